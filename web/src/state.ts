import type { ColourMap } from './colour-maps.js';
import type { Move } from './moves.js';
import type { ConversionSpec, Flow, MakerInfo, OperatorInfo, PropertyId, ShapeSpec, Side } from './polylap.js';
import { conversions, operators, shapes } from './polylap.js';
import { t, word } from './words.js';

export type Task = 'weights' | 'smooth' | 'harmonic' | 'dual' | 'check';
export type Theme = 'auto' | 'light' | 'dark';
export const sides: readonly Side[] = ['a', 'b'];
/** Both sides, and what tells them apart. */
export type View = Side | 'delta';
export const views: readonly View[] = [...sides, 'delta'];
export const gains = [1, 10, 100] as const;

type Triple = readonly [number, number, number];

/** The eye and what it looks at, in the mesh's coordinates relative to its centre, but turned upright. */
export interface Camera {
  position: Triple;
  target: Triple;
}

export type Parameters = Readonly<Record<string, number | string>>;

export interface Pin {
  vertex: number;
  value: number;
}

/** An operator and the parameters that differ from the table's initial ones or were touched. */
export interface Choice {
  operator: string;
  parameters: Parameters;
}

/** A line of the table of shapes or of conversions, with its parameters. */
export interface Made {
  id: string;
  parameters: Parameters;
}

/** Vertex → ω, length²; of the others it is 0. */
export type VertexWeights = Readonly<Record<number, number>>;

/** A mesh made of a side's surface, which moves had led to. */
export interface Change extends Made {
  side: Side;
  moves: readonly Move[];
}

/** Where the mesh on screen came from, and what was made of it since: enough to make it again. */
export type Source = (
  | { kind: 'preset'; id: string }
  | { kind: 'shape'; shape: Made }
  /** @param file its number among those opened since the page was loaded */
  | { kind: 'file'; name: string; file: number; repaired?: boolean }
) & { changes?: readonly Change[] };

/** How steps are taken. What a mesh does not have is not kept, see moves.ts. */
export interface Smooth {
  timeH2: number;
  rebuild: boolean;
  flow: Readonly<Record<Side, Flow>>;
  keepVolume: boolean;
  fixBoundary: boolean;
}

/** Everything a person has chosen; plain data, so that it can be stored and sent. What was computed from it is in results.ts. */
export interface State {
  version: 3;
  task: Task;
  source: Source;
  sides: Readonly<Record<Side, Choice>>;
  /** For the operators that take them. */
  vertexWeights: Readonly<Record<Side, VertexWeights>>;
  smooth: Smooth;
  /** The steps since the loaded mesh, and after how many of them the surfaces are shown. */
  moves: readonly Move[];
  step: number;
  harmonic: { pins: readonly Pin[]; value: number };
  /** μ, and which layers are drawn. */
  dual: { mu: number; primal: boolean; edges: boolean; points: boolean };
  /** How the values of Harmonic become colours; `locked` is a range that stays whatever the values. */
  colours: {
    map: ColourMap;
    isolines: boolean;
    symmetric: boolean;
    locked: { readonly min: number; readonly max: number } | null;
  };
  /** Which kernel mode colours a side. */
  mode: Readonly<Record<Side, number | null>>;
  /** In which tasks negative weights are drawn on the meshes. */
  negativeShown: Readonly<Record<Task, boolean>>;
  /** The vertex whose numbers are read. */
  selected: number | null;
  /** The face that is looked into. */
  selectedFace: number | null;
  /** Which view is seen where there is room for one. */
  shown: View;
  /** The third view: whether there is one, the difference so many times, or (swipe) that share of it A and the rest B. */
  delta: { open: boolean; gain: (typeof gains)[number]; swipe: number | null };
  /** Where it was put; null: the whole mesh is in view. */
  camera: Camera | null;
  theme: Theme;
}

export type Preset = {
  id: string;
  label: string;
} & ({ shape: ShapeSpec } | { file: string; change?: ConversionSpec });

/** Beside the page; made when it is built, loaded when it is asked for. */
const bunny = 'meshes/quad-bunny.obj';

export const presets: readonly Preset[] = [
  { id: 'noisy-torus', label: word('Noisy torus'), shape: { shape: 'torus', nu: 32, nv: 16, noise: 0.3, seed: 1 } },
  { id: 'torus', label: word('Torus'), shape: { shape: 'torus', nu: 32, nv: 16 } },
  {
    id: 'noisy-saddle',
    label: word('Noisy saddle'),
    shape: { shape: 'saddle', n: 16, height: 0.6, noise: 0.25, seed: 1 },
  },
  { id: 'saddle', label: word('Saddle'), shape: { shape: 'saddle', n: 16, height: 0.6 } },
  { id: 'grid-8', label: word('Grid, 8 × 8'), shape: { shape: 'grid', nx: 8, ny: 8, width: 8, height: 8 } },
  { id: 'grid-2', label: word('Grid, 2 × 2'), shape: { shape: 'grid', nx: 2, ny: 2, width: 2, height: 2 } },
  { id: 'bunny', label: word('Quad bunny'), file: bunny },
  {
    id: 'noisy-bunny',
    label: word('Noisy quad bunny'),
    file: bunny,
    change: { conversion: 'noise', amplitude: 0.3, seed: 1 },
  },
  { id: 'quad', label: word('One quad'), file: 'meshes/quad.obj' },
  { id: 'soup', label: word('Polygon soup'), file: 'meshes/polygon-soup.obj' },
  { id: 'patchwork', label: word('Patchwork sphere'), file: 'meshes/patchwork.obj' },
];

/** What the page opens with: the only place that names operators. */
const openingPair: Readonly<Record<Side, string>> = { a: 'alexa-wardetzky', b: 'planar' };

/** The one property that no single mesh can show: there is a study for it. */
export const studied: PropertyId = 'convergent';

/** What belongs to one mesh, and goes with it. */
export const forAnotherMesh = (state: State) => ({
  selected: null,
  selectedFace: null,
  camera: null,
  vertexWeights: { a: {}, b: {} },
  moves: [],
  step: 0,
  mode: { a: null, b: null },
  harmonic: { ...state.harmonic, pins: [] },
});

/** The same of a state whose mesh is made again; what it was smoothed to comes after. */
export const belongings = ({ selected, selectedFace, vertexWeights, harmonic }: State) => ({
  selected,
  selectedFace,
  vertexWeights,
  harmonic,
});

export function initialState(): State {
  return {
    version: 3,
    task: 'weights',
    source: { kind: 'preset', id: 'noisy-torus' },
    sides: { a: initialChoice(openingPair.a), b: initialChoice(openingPair.b) },
    vertexWeights: { a: {}, b: {} },
    smooth: {
      timeH2: 0.02,
      rebuild: true,
      flow: { a: 'implicit', b: 'implicit' },
      keepVolume: false,
      fixBoundary: false,
    },
    moves: [],
    step: 0,
    harmonic: { pins: [], value: 1 },
    colours: { map: 'viridis', isolines: false, symmetric: false, locked: null },
    dual: { mu: 0, primal: true, edges: true, points: true },
    mode: { a: null, b: null },
    negativeShown: { weights: true, smooth: true, harmonic: false, dual: false, check: false },
    selected: null,
    selectedFace: null,
    shown: 'a',
    delta: { open: false, gain: 1, swipe: null },
    camera: null,
    theme: 'auto',
  };
}

export function operatorOf({ operator }: { operator: string }): OperatorInfo {
  const entry = operators.find(({ id }) => id === operator) ?? operators[0];
  if (!entry) throw new Error('The operator table is empty.');
  return entry;
}

export function initialChoice(operator: string): Choice {
  const entry = operatorOf({ operator });
  return { operator: entry.id, parameters: initialParameters(entry) };
}

export function initialParameters({ parameters }: Pick<MakerInfo, 'parameters'>): Parameters {
  return Object.fromEntries(parameters.map(({ id, initial }) => [id, initial]));
}

/** Sets, changes or (with null) removes the pin at a vertex. */
export function withPin(pins: readonly Pin[], vertex: number, value: number | null): Pin[] {
  const rest = pins.filter((pin) => pin.vertex !== vertex);
  if (value === null) return rest;
  const at = pins.findIndex((pin) => pin.vertex === vertex);
  if (at < 0) return [...rest, { vertex, value }];
  return pins.map((pin) => (pin.vertex === vertex ? { vertex, value } : pin));
}

/** Sets the weight of a vertex; 0 takes it away. */
export function withWeight(weights: VertexWeights, vertex: number, weight: number): VertexWeights {
  const { [vertex]: _, ...rest } = weights;
  return weight === 0 ? rest : { ...rest, [vertex]: weight };
}

/** What the mesh is called: its origin, then what was made of it. @param say in another language than that of the page */
export function nameOf(source: Source, say: (english: string) => string = t): string {
  const label = (table: readonly MakerInfo[], id: string) => table.find((entry) => entry.id === id)?.label ?? id;
  const changes = (source.changes ?? []).map(({ id }) => say(label(conversions, id).toLowerCase()));
  return [originOf(source), ...changes].join(' · ');

  function originOf(origin: Source): string {
    if (origin.kind === 'file') return origin.repaired ? `${origin.name} · ${say(word('repaired'))}` : origin.name;
    if (origin.kind === 'shape') return say(label(shapes, origin.shape.id));
    return say(presets.find(({ id }) => id === origin.id)?.label ?? origin.id);
  }
}
