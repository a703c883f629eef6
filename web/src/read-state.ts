/** A state that came from outside: nothing of it is believed that is not checked. */
import { colourMaps } from './colour-maps.js';
import type { Move } from './moves.js';
import { conversions, type Flow, type MakerInfo, operators, type Side, shapes } from './polylap.js';
import {
  type Camera,
  type Change,
  type Choice,
  gains,
  initialParameters,
  initialState,
  type Made,
  type Parameters,
  presets,
  type Smooth,
  type Source,
  type State,
  sides,
  type VertexWeights,
  views,
} from './state.js';

type Fields = Readonly<Record<string, unknown>>;

/** At most so many steps are taken again. */
const mostSteps = 10_000;

/** @throws Error, a sentence that names what is wrong */
export function readState(value: unknown): State {
  const initial = initialState();
  const all = fields(value, 'the state');
  if (all.version !== initial.version)
    throw new Error(`this page reads states of version ${initial.version}, not ${show(all.version)}`);
  const perSide = <T>(name: string, read: (value: unknown, name: string) => T): Record<Side, T> => {
    const given = fields(all[name], name);
    return { a: read(given.a, `${name} of A`), b: read(given.b, `${name} of B`) };
  };
  const smooth = fields(all.smooth, 'smooth');
  const harmonic = fields(all.harmonic, 'harmonic');
  const dual = fields(all.dual, 'dual');
  const shown = fields(all.negativeShown, 'negativeShown');
  const moves = readMoves(all.moves, 'moves');
  const steps = moves.reduce((sum, move) => sum + move.steps, 0);
  const tasks = Object.keys(initial.negativeShown) as State['task'][];
  const negativeShown = Object.fromEntries(tasks.map((task) => [task, truth(shown[task], `negativeShown of ${task}`)]));
  return {
    version: initial.version,
    task: among(all.task, tasks, 'the task'),
    source: readSource(all.source),
    sides: perSide('sides', readChoice),
    vertexWeights: perSide('vertexWeights', readWeights),
    smooth: readSmooth(smooth),
    moves,
    step: whole(all.step, 0, steps, 'the step shown'),
    harmonic: {
      value: real(harmonic.value, 'the value of pins'),
      pins: list(harmonic.pins, 'the pins').map((pin, k) => {
        const { vertex, value: pinned } = fields(pin, `pin ${k}`);
        return { vertex: whole(vertex, 0, maxIndex, `the vertex of pin ${k}`), value: real(pinned, `pin ${k}`) };
      }),
    },
    dual: {
      mu: real(dual.mu, 'μ'),
      primal: truth(dual.primal, 'primal'),
      edges: truth(dual.edges, 'edges'),
      points: truth(dual.points, 'points'),
    },
    colours: readColours(all.colours),
    mode: perSide('mode', (mode, name) => (mode === null ? null : whole(mode, 0, maxIndex, name))),
    negativeShown: negativeShown as State['negativeShown'],
    selected: all.selected === null ? null : whole(all.selected, 0, maxIndex, 'the selected vertex'),
    selectedFace: all.selectedFace == null ? null : whole(all.selectedFace, 0, maxIndex, 'the selected face'),
    shown: among(all.shown, views, 'the view shown'),
    delta: readDelta(all.delta),
    camera: readCamera(all.camera),
    theme: among(all.theme, ['auto', 'light', 'dark'], 'the theme'),
  };
}

const flows: readonly Flow[] = ['implicit', 'conformalised', 'explicit'];
const maxIndex = 2 ** 31 - 1;

function readSource(value: unknown): Source {
  const { kind, changes, ...rest } = fields(value, 'the source');
  const origin = ((): Source => {
    switch (among(kind, ['preset', 'shape', 'file'], 'the kind of source')) {
      case 'preset':
        return {
          kind: 'preset',
          id: among(
            rest.id,
            presets.map(({ id }) => id),
            'the mesh',
          ),
        };
      case 'shape':
        return { kind: 'shape', shape: readMade(rest.shape, shapes, 'the shape') };
      case 'file': {
        if (typeof rest.name !== 'string' || rest.name === '') throw new Error('the file has no name');
        const repaired = rest.repaired === true && { repaired: true };
        return { kind: 'file', name: rest.name.slice(0, 200), file: -1, ...repaired };
      }
    }
  })();
  if (changes === undefined) return origin;
  const made = list(changes, 'the changes').map((change, k): Change => {
    const name = `change ${k + 1}`;
    const { side, moves } = fields(change, name);
    return {
      ...readMade(change, conversions, name),
      side: among(side, sides, `the side of ${name}`),
      moves: readMoves(moves, `the moves before ${name}`),
    };
  });
  return { ...origin, changes: made };
}

function readMoves(value: unknown, name: string): Move[] {
  return list(value, name).map((move) => {
    const given = fields(move, `one of ${name}`);
    const [choices, weights] = [fields(given.sides, 'sides'), fields(given.vertexWeights, 'vertex weights')];
    return {
      sides: { a: readChoice(choices.a, 'the operator of A'), b: readChoice(choices.b, 'the operator of B') },
      vertexWeights: { a: readWeights(weights.a, 'weights of A'), b: readWeights(weights.b, 'weights of B') },
      ...readSmooth(given),
      steps: whole(given.steps, 1, mostSteps, 'steps'),
    };
  });
}

/** Links from before there were flows say nothing of them. */
function readSmooth(given: Fields): Smooth {
  const { flow = initialState().smooth.flow, keepVolume = false, fixBoundary = false } = given;
  const { a, b } = fields(flow, 'the flows');
  return {
    timeH2: time(given.timeH2),
    rebuild: truth(given.rebuild, 'rebuild'),
    flow: { a: among(a, flows, 'the flow of A'), b: among(b, flows, 'the flow of B') },
    keepVolume: truth(keepVolume, 'keepVolume'),
    fixBoundary: truth(fixBoundary, 'fixBoundary'),
  };
}

function readChoice(value: unknown, name: string): Choice {
  const { operator, parameters } = fields(value, name);
  const entry = entryOf(operators, operator, name);
  return { operator: entry.id, parameters: readParameters(parameters, entry, name) };
}

function readMade(value: unknown, table: readonly MakerInfo[], name: string): Made {
  const { id, parameters } = fields(value, name);
  const entry = entryOf(table, id, name);
  return { id: entry.id, parameters: readParameters(parameters, entry, name) };
}

function readParameters(value: unknown, entry: Pick<MakerInfo, 'parameters'>, name: string): Parameters {
  const given = fields(value, `the parameters of ${name}`);
  const known = new Map(entry.parameters.map((parameter) => [parameter.id, parameter]));
  const read = Object.entries(given).map(([id, setting]): [string, number | string] => {
    const parameter = known.get(id);
    if (!parameter) throw new Error(`${name} has no parameter ${show(id)}`);
    if (parameter.kind === 'choice') return [id, among(setting, parameter.choices, `${id} of ${name}`)];
    const number = real(setting, `${id} of ${name}`);
    if (number < parameter.min || number > parameter.max || (parameter.kind === 'integer' && !Number.isInteger(number)))
      throw new Error(`${id} of ${name} cannot be ${number}`);
    return [id, number];
  });
  return { ...initialParameters(entry), ...Object.fromEntries(read) };
}

function readWeights(value: unknown, name: string): VertexWeights {
  const entries = Object.entries(fields(value, name));
  return Object.fromEntries(
    entries.map(([vertex, weight]) => [whole(Number(vertex), 0, maxIndex, `a vertex of ${name}`), real(weight, name)]),
  );
}

function readColours(value: unknown): State['colours'] {
  const { map, isolines, symmetric, locked } = fields(value, 'the colours');
  const ids = colourMaps.map(([id]) => id);
  const range = locked === null ? null : fields(locked, 'the range');
  const [min, max] = range ? [real(range.min, 'the range'), real(range.max, 'the range')] : [0, 1];
  if (min >= max) throw new Error(`the range cannot be ${min} to ${max}`);
  return {
    map: among(map, ids, 'the colours'),
    isolines: truth(isolines, 'isolines'),
    symmetric: truth(symmetric, 'symmetric'),
    locked: range && { min, max },
  };
}

function readDelta(value: unknown): State['delta'] {
  const { open, gain, swipe } = fields(value, 'the difference');
  const allowed = gains.find((each) => each === gain);
  if (allowed === undefined) throw new Error(`the difference cannot be amplified ${show(gain)} times`);
  const share = swipe === null ? null : real(swipe, 'the swipe');
  if (share !== null && (share < 0 || share > 1)) throw new Error(`the swipe cannot be ${share}`);
  return { open: truth(open, 'open'), gain: allowed, swipe: share };
}

function readCamera(value: unknown): Camera | null {
  if (value === null || value === undefined) return null;
  const { position, target } = fields(value, 'the camera');
  const point = (given: unknown): [number, number, number] => {
    const [x, y, z] = list(given, 'a point of the camera').map((coordinate) => real(coordinate, 'the camera'));
    return [x ?? 0, y ?? 0, z ?? 0];
  };
  return { position: point(position), target: point(target) };
}

// --- values -----------------------------------------------------------------------------------------------------------------

const show = (value: unknown) => (JSON.stringify(value) ?? String(value)).slice(0, 40);

function fields(value: unknown, name: string): Fields {
  if (typeof value !== 'object' || value === null || Array.isArray(value)) throw new Error(`${name} is missing`);
  return value as Fields;
}

function list(value: unknown, name: string): readonly unknown[] {
  if (!Array.isArray(value)) throw new Error(`${name} are missing`);
  return value;
}

function entryOf<T extends { readonly id: string }>(table: readonly T[], id: unknown, name: string): T {
  const entry = table.find((line) => line.id === id);
  if (!entry) throw new Error(`${name}: there is no ${show(id)}`);
  return entry;
}

function among<T extends string>(value: unknown, allowed: readonly T[], name: string): T {
  const found = allowed.find((each) => each === value);
  if (found === undefined) throw new Error(`${name} cannot be ${show(value)}`);
  return found;
}

function real(value: unknown, name: string): number {
  if (typeof value !== 'number' || !Number.isFinite(value)) throw new Error(`${name} must be a number`);
  return value;
}

function time(value: unknown): number {
  const t = real(value, 'the time step');
  if (t <= 0) throw new Error('the time step must be above 0');
  return t;
}

function whole(value: unknown, min: number, max: number, name: string): number {
  const number = real(value, name);
  if (!Number.isInteger(number) || number < min || number > max) throw new Error(`${name} cannot be ${number}`);
  return number;
}

function truth(value: unknown, name: string): boolean {
  if (typeof value !== 'boolean') throw new Error(`${name} must be true or false`);
  return value;
}
