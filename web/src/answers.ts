import type { App } from './app.js';
import { latest } from './latest.js';
import { explain } from './messages.js';
import type { ConvergenceStudy, Dual, Mesh, OperatorSpec, Side } from './polylap.js';
import { known, type SideResults } from './results.js';
import { type Choice, operatorOf, sides, type VertexWeights } from './state.js';
import { t, word } from './words.js';
import { isCancelled, type Run, Unwanted } from './work.js';

const names = {
  weights: word('weights'),
  harmonic: word('harmonic function'),
  matrices: word('matrix'),
  row: word('row of the vertex'),
  face: word('face'),
  stability: word('largest eigenvalue'),
  check: word('properties'),
  spectrum: word('spectrum'),
  energy: word('energy'),
  dual: word('orthogonal dual'),
  shape: word('area and volume'),
  study: word('convergence'),
};
type Kind = Exclude<keyof typeof names, 'shape' | 'study'>;
const kinds = (Object.keys(names) as (keyof typeof names)[]).filter(
  (name): name is Kind => name !== 'shape' && name !== 'study',
);

const labelOf = (side: Side, what: keyof typeof names) => `${side.toUpperCase()}: ${t(names[what])}`;

/** Plots of matrices need all of them; on more vertices that is too much to copy for each touch of a slider. */
export const plotLimit = 20_000;

/** So many of the lowest eigenvalues are looked for. */
const spectrumSize = 30;

/** What an answer depends on. */
interface Question {
  /** Each surface has its own. */
  surface: Float32Array;
  about: string;
}

const same = (one: Question | undefined, other: Question) =>
  one?.surface === other.surface && one.about === other.about;

/** Asks the core about both surfaces: what is on screen, the newest question first, and none twice. */
export class Answers {
  private readonly refreshers: Record<Side, Record<Kind, (mesh: Mesh) => void>>;
  /** What was asked last, and to what the answers on screen are answers. */
  private readonly asked: Record<Side, Partial<Record<Kind, Question>>> = { a: {}, b: {} };
  private readonly answered: Record<Side, Partial<Record<Kind, Question>>> = { a: {}, b: {} };
  /** Of which mesh a side is being measured. */
  private readonly measured: Record<Side, Mesh | null> = { a: null, b: null };
  private dual: { mesh: Mesh; about: string; answer: Promise<Dual> } | null = null;

  constructor(private readonly app: App) {
    const refresher = (side: Side, kind: Kind) =>
      latest(
        (mesh: Mesh) => this.refresh(mesh, side, kind),
        () => same(this.asked[side][kind], this.question(side, kind)) || app.work.supersede(labelOf(side, kind)),
      );
    const ofSide = (side: Side) =>
      Object.fromEntries(kinds.map((kind) => [kind, refresher(side, kind)])) as Record<Kind, (mesh: Mesh) => void>;
    this.refreshers = { a: ofSide('a'), b: ofSide('b') };
  }

  /** Asks for everything about a side that is on screen. */
  update(side: Side): void {
    const { app } = this;
    const { mesh } = app.results.get();
    if (!mesh) return;
    const { task } = app.state.get();
    const ask = this.refreshers[side];
    // A worker that died has taken it along.
    if (!app.results.get()[side].shape && this.measured[side] !== mesh) void this.measure(mesh, side);
    ask.weights(mesh);
    this.harmonic(side);
    if (task === 'check') ask.check(mesh);
    if (task === 'dual') ask.dual(mesh);
    this.stability(side);
    if (task === 'smooth') ask.energy(mesh);
    // It is of another operator or surface now, and takes long: asked for again when somebody wants it.
    if (this.app.results.get()[side].spectrum && !this.isAnswered(side, 'spectrum'))
      this.app.patch(mesh, side, { spectrum: null });
    if (task !== 'weights') return;
    if (mesh.vertices <= plotLimit) ask.matrices(mesh);
    this.row(side);
    this.face(side);
  }

  updateBoth(): void {
    for (const side of sides) this.update(side);
  }

  /** The harmonic function: all that depends on the pins. */
  harmonic(side: Side): void {
    const { mesh } = this.app.results.get();
    const { task, harmonic } = this.app.state.get();
    if (!mesh) return;
    if (harmonic.pins.length === 0) this.app.patch(mesh, side, { harmonic: null });
    else if (task === 'harmonic') this.refreshers[side].harmonic(mesh);
  }

  /** The row of the selected vertex. */
  row(side: Side): void {
    const { mesh } = this.app.results.get();
    const { task, selected } = this.app.state.get();
    if (mesh && task === 'weights' && selected !== null) this.refreshers[side].row(mesh);
  }

  /** What bounds an explicit step from where the side stands. On large meshes, not after each step of a play. */
  stability(side: Side): void {
    const { mesh, playing } = this.app.results.get();
    const { task, smooth } = this.app.state.get();
    if (!mesh || task !== 'smooth' || smooth.flow[side] !== 'explicit') return;
    if (!playing || mesh.vertices <= plotLimit) this.refreshers[side].stability(mesh);
  }

  /** The lowest eigenvalues of both operators. */
  spectra(): void {
    const { mesh } = this.app.results.get();
    if (mesh) for (const side of sides) this.refreshers[side].spectrum(mesh);
  }

  /** What the selected face is to the side's operator. */
  face(side: Side): void {
    const { mesh } = this.app.results.get();
    const { task, selectedFace } = this.app.state.get();
    if (mesh && task === 'weights' && selectedFace !== null) this.refreshers[side].face(mesh);
  }

  /** Area and volume of a side that stands on the loaded mesh. */
  async measure(mesh: Mesh, side: Side): Promise<void> {
    const { app } = this;
    this.measured[side] = mesh;
    try {
      const shape = await app.work.run(labelOf(side, 'shape'), (run) => mesh.shape({ side, ...run }), side);
      if (app.results.get().mesh === mesh) app.smoothing.loadedArea = shape.area;
      app.patch(mesh, side, { shape });
    } catch (reason) {
      app.fail(mesh, t('The surface could not be measured'), reason);
    } finally {
      if (this.measured[side] === mesh) this.measured[side] = null;
    }
  }

  /** What was left unasked for the sake of a mesh that did not come. */
  again(): void {
    const { mesh } = this.app.results.get();
    if (!mesh || this.app.meshes.awaited > 0) return;
    for (const side of sides) {
      if (!this.app.results.get()[side].shape) void this.measure(mesh, side);
      this.update(side);
    }
  }

  /** Whether the operators converge, on meshes of the study's own. */
  async study(): Promise<void> {
    const { app } = this;
    const client = await app.client;
    const studyOf = async (side: Side) => {
      const choice = app.state.get().sides[side];
      let study: readonly ConvergenceStudy[] | string;
      try {
        study = await app.work.run(labelOf(side, 'study'), (run) => client.convergence(specOf(choice), run));
      } catch (reason) {
        study = isCancelled(reason) ? t('Cancelled.') : explain(reason);
      }
      if (app.state.get().sides[side] === choice) app.results.set({ [side]: { ...app.results.get()[side], study } });
    };
    await Promise.all(sides.map(studyOf));
  }

  private async refresh(mesh: Mesh, side: Side, kind: Kind): Promise<void> {
    const { app } = this;
    if (app.results.get().mesh !== mesh || app.meshes.awaited > 0 || this.isAnswered(side, kind)) return;
    const question = this.question(side, kind);
    this.asked[side][kind] = question;
    try {
      const patch = await app.work.run(labelOf(side, kind), (run) => this.ask(kind, mesh, side, run), side);
      if (!patch) return;
      this.answered[side][kind] = question;
      app.patch(mesh, side, patch);
    } catch (reason) {
      if (reason instanceof Unwanted) return;
      if (app.results.get().mesh !== mesh || (isCancelled(reason) && app.meshes.awaited > 0)) return;
      app.patch(mesh, side, { [kind]: isCancelled(reason) ? t('Cancelled.') : explain(reason) });
      if (isCancelled(reason)) app.say(t('Cancelled; the mesh is as it was.'));
    }
  }

  private question(side: Side, kind: Kind): Question {
    const { state, results } = this.app;
    const { sides: choices, vertexWeights, harmonic, dual, selected, selectedFace, smooth } = state.get();
    const more: Partial<Record<Kind, unknown>> = {
      harmonic: harmonic.pins,
      row: selected,
      face: selectedFace,
      stability: [smooth.rebuild, smooth.fixBoundary],
    };
    const about = kind === 'dual' ? dual.mu : [choices[side], vertexWeights[side], more[kind]];
    return { surface: results.get()[side].positions, about: JSON.stringify(about) };
  }

  private isAnswered(side: Side, kind: Kind): boolean {
    const there = known(this.app.results.get()[side][kind]) !== null;
    return there && same(this.answered[side][kind], this.question(side, kind));
  }

  /** @returns null when there is nothing new to say */
  private async ask(kind: Kind, mesh: Mesh, side: Side, work: Run): Promise<Partial<SideResults> | null> {
    const { state } = this.app;
    const run = { side, ...work };
    const { sides: choices, vertexWeights, harmonic, selected, selectedFace, smooth } = state.get();
    const spec = specOf(choices[side], vertexWeights[side], mesh.vertices);
    switch (kind) {
      case 'weights':
        return { weights: await mesh.weights(spec, run) };
      case 'matrices':
        return { matrices: await mesh.matrices(spec, run) };
      case 'stability': {
        const { rebuild, fixBoundary } = smooth;
        return { stability: await mesh.stability(spec, { rebuild, fixBoundary }, run) };
      }
      case 'row': {
        if (selected === null) return null;
        const vertex = selected;
        return { row: { ...(await mesh.row(spec, vertex, run)), vertex } };
      }
      case 'face': {
        if (selectedFace === null) return null;
        const face = selectedFace;
        return { face: { ...(await mesh.face(spec, face, run)), face } };
      }
      case 'harmonic': {
        const { pins } = harmonic;
        if (pins.length === 0) return null;
        const fixed = { vertices: pins.map((pin) => pin.vertex), values: pins.map((pin) => pin.value) };
        const answer = await mesh.harmonic(spec, fixed, run);
        return state.get().harmonic.pins.length > 0 ? { harmonic: answer } : null;
      }
      case 'check':
        return { check: await mesh.check(spec, run) };
      case 'spectrum': {
        const asked = this.question(side, kind);
        const spectrum = await mesh.spectrum(spec, spectrumSize, run);
        // Nobody asks again when something else is on screen by then.
        return same(asked, this.question(side, kind)) ? { spectrum } : null;
      }
      case 'energy': {
        const { step, positions } = this.app.results.get()[side];
        const energy = await mesh.energy(spec, run);
        if (this.app.results.get()[side].positions !== positions) return null;
        this.app.smoothing.trail.noteEnergy(step, side, energy);
        return { energy: { step, value: energy } };
      }
      case 'dual':
        return { dual: await this.dualOf(mesh, side, run) };
    }
  }

  /** It does not depend on the operator: as long as the surfaces are the same, both sides have the same one. */
  private dualOf(mesh: Mesh, side: Side, run: Run): Promise<Dual> {
    const { mu } = this.app.state.get().dual;
    const { step } = this.app.results.get()[side];
    const about = JSON.stringify(step === 0 ? [mu] : [mu, side, step]);
    if (this.dual?.mesh !== mesh || this.dual.about !== about) {
      const answer = mesh.dual({ mu }, run);
      this.dual = { mesh, about, answer };
      answer.catch(() => {
        if (this.dual?.answer === answer) this.dual = null;
      });
    }
    return this.dual.answer;
  }
}

/** @param vertices of the mesh; without them vertex weights are left out */
export function specOf(choice: Choice, weights: VertexWeights = {}, vertices = 0): OperatorSpec {
  const entry = operatorOf(choice);
  const given = Object.entries(weights);
  if (!entry.takesVertexWeights || given.length === 0 || vertices === 0)
    return { id: choice.operator, ...choice.parameters } as OperatorSpec;
  const vertexWeights = new Float64Array(vertices);
  for (const [vertex, weight] of given) vertexWeights[Number(vertex)] = weight;
  return { id: choice.operator, ...choice.parameters, vertexWeights } as OperatorSpec;
}
