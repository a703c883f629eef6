import { count, plural } from './format.js';
import { latest } from './latest.js';
import { describe, explain } from './messages.js';
import { countFaces } from './obj-text.js';
import type { Client, Mesh, Side, Smoothed } from './polylap.js';
import { freshSide, type Message, noResults, type Results, type SideResults } from './results.js';
import { type Choice, initialState, presets, type Source, type State, sides, withPin } from './state.js';
import { isFaceRefused, littleLeft, nothingLeft, type Stop, stopped } from './stops.js';
import { Store } from './store.js';
import { isCancelled, Work } from './work.js';

type Spec = Parameters<Mesh['weights']>[0];
type Kind = 'weights' | 'harmonic' | 'matrices';

const tooManyFaces = 1_000_000;
const tooManyBytes = 200e6;
/** Rows of S are read from the whole matrix; beyond this that is too much to copy for each touch of a slider. */
export const rowLimit = 20_000;
/** Milliseconds between steps when playing: slow enough to watch. */
const stepPace = 90;
const playingNotice = 'Smoothing …';

/** What the page can do. Holds what was chosen (`state`) and what came of it (`results`); knows nothing of the document. */
export class App {
  readonly state = new Store<State>(initialState());
  readonly results = new Store<Results>(noResults());
  private readonly work = new Work((busy) => this.results.set({ busy }));
  private readonly refreshers: Record<Side, Record<Kind, (mesh: Mesh) => void>>;
  private opening = 0;
  /** Meshes asked for and not there yet. */
  private awaited = 0;
  private plays = 0;
  /** Area of the loaded mesh, before any step. */
  private loadedArea = 0;
  private stepping: Promise<void> | null = null;

  /** @param client the page is there before the worker is */
  constructor(private readonly client: Promise<Client>) {
    void client.then(
      (ready) => {
        ready.onRestart = (reason) =>
          this.say(`The worker was started again: ${reason.replace(/\.$/, '')}. The mesh is as it was.`);
      },
      // Told by the first mesh that cannot be made.
      () => {},
    );
    const forSide = (side: Side) => ({
      weights: latest((mesh: Mesh) => this.refresh(mesh, side, 'weights')),
      harmonic: latest((mesh: Mesh) => this.refresh(mesh, side, 'harmonic')),
      matrices: latest((mesh: Mesh) => this.refresh(mesh, side, 'matrices')),
    });
    this.refreshers = { a: forSide('a'), b: forSide('b') };
  }

  // --- meshes -------------------------------------------------------------------------------------------------------------

  async makePreset(id: string): Promise<void> {
    const preset = presets.find((entry) => entry.id === id) ?? presets[0];
    if (!preset) return;
    await this.take({ kind: 'preset', id: preset.id }, preset.label, async () =>
      (await this.client).make(preset.shape),
    );
  }

  /** @returns what was wrong, or null; the mesh on screen stays if something was */
  async open(file: Blob, name: string): Promise<Message | null> {
    if (file.size > tooManyBytes) {
      return this.refuse(
        name,
        `It has ${count(file.size / 1e6)} MB; this page takes up to ${count(tooManyBytes / 1e6)} MB.`,
      );
    }
    const faces = await countFaces(file, name);
    if (faces > tooManyFaces) {
      return this.refuse(
        name,
        `It has ${plural(faces, 'face')}; this page takes up to ${count(tooManyFaces)}. The command line takes more.`,
      );
    }
    return this.take({ kind: 'file', name }, name, () =>
      this.work.run(`Opening ${name}`, async (run) => (await this.client).open(file, name, run)),
    );
  }

  private refuse(name: string, text: string): Message {
    const error = { title: `${name} is too large`, text };
    this.results.set({ error, notice: error.title });
    return error;
  }

  private async take(source: Source, label: string, make: () => Promise<Mesh>): Promise<Message | null> {
    const turn = ++this.opening;
    this.pause();
    this.awaited++;
    // The new mesh does not wait for answers about the old one.
    this.work.cancelWaiting();
    let mesh: Mesh;
    try {
      mesh = await make();
    } catch (reason) {
      this.awaited--;
      this.askAgain();
      if (turn !== this.opening) return null;
      if (isCancelled(reason)) {
        this.say(`Opening ${label} was cancelled; the mesh is as it was.`);
        return null;
      }
      const error = { title: `${label} could not be opened`, text: explain(reason) };
      this.results.set({ error, notice: error.title });
      return error;
    }
    this.awaited--;
    if (turn !== this.opening) {
      await mesh.close();
      return null;
    }
    this.loadedArea = 0;
    const before = this.results.get().mesh;
    this.state.set({ source, selected: null, harmonic: { ...this.state.get().harmonic, pins: [] } });
    const { positions } = mesh.geometry;
    this.results.set({
      mesh,
      a: freshSide(positions),
      b: freshSide(positions),
      error: null,
      hovered: null,
      notice: describe(mesh, label),
    });
    void before?.close();
    for (const side of sides) {
      void this.measure(mesh, side);
      this.update(side);
    }
    return null;
  }

  /** What was left unasked for the sake of a mesh that did not come. */
  private askAgain(): void {
    const { mesh } = this.results.get();
    if (!mesh || this.awaited > 0) return;
    for (const side of sides) {
      if (!this.results.get()[side].shape) void this.measure(mesh, side);
      this.update(side);
    }
  }

  private async measure(mesh: Mesh, side: Side): Promise<void> {
    try {
      const shape = await this.work.run(`${side.toUpperCase()}: area and volume`, (run) =>
        mesh.shape({ side, ...run }),
      );
      if (this.results.get().mesh === mesh) this.loadedArea = shape.area;
      this.patch(mesh, side, { shape });
    } catch (reason) {
      this.fail(mesh, 'The surface could not be measured', reason);
    }
  }

  // --- sides --------------------------------------------------------------------------------------------------------------

  setChoice(side: Side, choice: Choice): void {
    this.state.set({ sides: { ...this.state.get().sides, [side]: choice } });
    this.update(side);
  }

  setParameter(side: Side, id: string, value: number | string): void {
    const choice = this.state.get().sides[side];
    this.setChoice(side, { ...choice, parameters: { ...choice.parameters, [id]: value } });
  }

  /** Asks for everything about a side that is on screen. */
  update(side: Side): void {
    const mesh = this.results.get().mesh;
    if (!mesh) return;
    const { task, harmonic } = this.state.get();
    this.refreshers[side].weights(mesh);
    if (harmonic.pins.length === 0) this.patch(mesh, side, { harmonic: null });
    else if (task === 'harmonic') this.refreshers[side].harmonic(mesh);
    this.askRow(side);
  }

  private askRow(side: Side): void {
    const { mesh } = this.results.get();
    const { task, selected } = this.state.get();
    if (mesh && task === 'weights' && selected !== null && mesh.vertices <= rowLimit)
      this.refreshers[side].matrices(mesh);
  }

  private updateBoth(): void {
    for (const side of sides) this.update(side);
  }

  private async refresh(mesh: Mesh, side: Side, kind: Kind): Promise<void> {
    if (this.results.get().mesh !== mesh || this.awaited > 0) return;
    const state = this.state.get();
    const spec = specOf(state.sides[side]);
    const name = `${side.toUpperCase()}: ${{ weights: 'weights', harmonic: 'harmonic function', matrices: 'matrix' }[kind]}`;
    try {
      await this.work.run(name, async ({ signal, onProgress }) => {
        const run = { side, signal, onProgress };
        if (kind === 'weights') this.patch(mesh, side, { weights: await mesh.weights(spec, run) });
        else if (kind === 'matrices') this.patch(mesh, side, { matrices: await mesh.matrices(spec, run) });
        else {
          const { pins } = this.state.get().harmonic;
          if (pins.length === 0) return;
          const fixed = { vertices: pins.map((pin) => pin.vertex), values: pins.map((pin) => pin.value) };
          const harmonic = await mesh.harmonic(spec, fixed, run);
          if (this.state.get().harmonic.pins.length > 0) this.patch(mesh, side, { harmonic });
        }
      });
    } catch (reason) {
      if (this.results.get().mesh !== mesh || (isCancelled(reason) && this.awaited > 0)) return;
      this.patch(mesh, side, { [kind]: isCancelled(reason) ? 'cancelled' : explain(reason) });
      if (isCancelled(reason)) this.say('Cancelled; the mesh is as it was.');
    }
  }

  // --- smoothing ----------------------------------------------------------------------------------------------------------

  setSmooth(patch: Partial<State['smooth']>): void {
    this.state.set({ smooth: { ...this.state.get().smooth, ...patch } });
  }

  /** One step on both sides, shown at once. A side that lags because its last step failed catches up first. */
  step(): Promise<void> {
    this.stepping ??= this.stepBoth().finally(() => {
      this.stepping = null;
    });
    return this.stepping;
  }

  private async stepBoth(): Promise<void> {
    const { mesh, a, b } = this.results.get();
    if (!mesh) return;
    const { smooth, sides: choices } = this.state.get();
    const results = { a, b };
    const behind = Math.min(a.step, b.step);
    const moving = sides.filter((side) => results[side].step === behind);
    const options = { time: smooth.timeH2 * mesh.meanSquaredEdge, steps: 1, rebuild: smooth.rebuild };
    const settled = await Promise.allSettled(
      moving.map((side) =>
        this.work.run(`${side.toUpperCase()}: step ${behind + 1}`, (run) =>
          mesh.smooth(specOf(choices[side]), options, { side, ...run }),
        ),
      ),
    );
    if (this.results.get().mesh !== mesh) return;
    const patch: Partial<Results> = { error: null };
    const stops: Stop[] = [];
    settled.forEach((outcome, k) => {
      const side = moving[k] as Side;
      if (outcome.status === 'fulfilled') {
        const { stats, step } = outcome.value;
        patch[side] = { ...this.results.get()[side], ...surfaceOf(outcome.value) };
        if (stats.area < nothingLeft * this.loadedArea)
          stops.push({ side, step, collapsed: true, reason: 'Less than a millionth of its area is left.' });
      } else if (isCancelled(outcome.reason)) {
        patch.playing = false;
        patch.notice = 'Cancelled; the surfaces are those of the last finished step.';
      } else {
        const area = results[side].shape?.area ?? this.loadedArea;
        const collapsed = behind > 0 && (area < littleLeft * this.loadedArea || isFaceRefused(outcome.reason));
        stops.push({ side, step: behind, collapsed, reason: explain(outcome.reason) });
      }
    });
    if (stops.length > 0) {
      patch.playing = false;
      patch.error = stopped(stops);
      patch.notice = `Stopped at step ${count(Math.max(...stops.map((stop) => stop.step)))}.`;
    }
    this.results.set(patch);
    this.updateBoth();
  }

  async play(): Promise<void> {
    if (this.results.get().playing || !this.results.get().mesh) return;
    const turn = ++this.plays;
    const goesOn = () => this.results.get().playing && turn === this.plays;
    this.results.set({ playing: true, error: null, notice: playingNotice });
    while (goesOn()) {
      const pace = new Promise((done) => setTimeout(done, stepPace));
      await this.step();
      if (goesOn()) await pace;
    }
    if (turn === this.plays) this.sayPaused();
  }

  pause(): void {
    if (!this.results.get().playing) return;
    this.results.set({ playing: false });
    if (!this.stepping) this.sayPaused();
  }

  /** Unless there is other news already. */
  private sayPaused(): void {
    const { notice, a, b } = this.results.get();
    if (notice === playingNotice) this.say(`Paused at step ${count(Math.min(a.step, b.step))}.`);
  }

  async reset(): Promise<void> {
    this.pause();
    await this.stepping;
    const { mesh } = this.results.get();
    if (!mesh) return;
    try {
      await this.work.run('Back to the loaded mesh', () => mesh.reset());
    } catch (reason) {
      this.fail(mesh, 'The mesh could not be reset', reason);
      return;
    }
    const { positions } = mesh.geometry;
    for (const side of sides) {
      this.patch(mesh, side, { step: 0, positions });
      void this.measure(mesh, side);
    }
    this.updateBoth();
    this.results.set({ error: null, notice: 'Back to the loaded mesh.' });
  }

  // --- harmonic -----------------------------------------------------------------------------------------------------------

  pin(vertex: number, value: number | null): void {
    this.setPins(withPin(this.state.get().harmonic.pins, vertex, value));
  }

  /** Pins to the current value; touching a pin that has it already removes it. */
  touchPin(vertex: number): void {
    const { pins, value } = this.state.get().harmonic;
    const there = pins.find((pin) => pin.vertex === vertex);
    this.pin(vertex, there?.value === value ? null : value);
  }

  setPins(pins: State['harmonic']['pins']): void {
    this.state.set({ harmonic: { ...this.state.get().harmonic, pins } });
    this.updateBoth();
  }

  // --- the rest -----------------------------------------------------------------------------------------------------------

  setTask(task: State['task']): void {
    if (task !== 'smooth') this.pause();
    this.state.set({ task });
    this.updateBoth();
  }

  select(vertex: number | null): void {
    if (vertex === this.state.get().selected) return;
    const first = this.state.get().selected === null;
    this.state.set({ selected: vertex });
    // Rows are not asked for until somebody looks at one.
    if (first) for (const side of sides) this.askRow(side);
  }

  hover(vertex: number | null): void {
    if (vertex !== this.results.get().hovered) this.results.set({ hovered: vertex });
  }

  /** To the next vertex, or the one before. */
  walk(by: number): void {
    const { mesh } = this.results.get();
    if (!mesh) return;
    const { selected } = this.state.get();
    this.select(selected === null ? 0 : (selected + by + mesh.vertices) % mesh.vertices);
  }

  cancel(): void {
    this.results.set({ playing: false });
    this.work.cancel();
  }

  /** Whether nothing is under way. */
  get idle(): boolean {
    return this.work.idle && !this.results.get().playing;
  }

  say(notice: string): void {
    this.results.set({ notice });
  }

  private patch(mesh: Mesh, side: Side, patch: Partial<SideResults>): void {
    const results = this.results.get();
    if (results.mesh === mesh) this.results.set({ [side]: { ...results[side], ...patch } });
  }

  private fail(mesh: Mesh, title: string, reason: unknown): void {
    if (this.results.get().mesh !== mesh || isCancelled(reason)) return;
    this.results.set({ error: { title, text: explain(reason) } });
  }
}

function specOf(choice: Choice): Spec {
  return { id: choice.operator, ...choice.parameters } as Spec;
}

function surfaceOf({ step, positions, stats }: Smoothed) {
  return { step, positions, shape: stats };
}
