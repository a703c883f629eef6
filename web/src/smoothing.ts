import { specOf } from './answers.js';
import type { App } from './app.js';
import { count } from './format.js';
import { latest } from './latest.js';
import { explain } from './messages.js';
import { after, common, type Move, moveOf, optionsOf, possible, stepsOf, upTo, withStep } from './moves.js';
import type { Mesh, Smoothed } from './polylap.js';
import type { Results } from './results.js';
import { type State, sides } from './state.js';
import { isFaceRefused, littleLeft, nothingLeft, type Stop, stopped } from './stops.js';
import { type Marks, type Surfaces, Trail } from './trail.js';
import { t } from './words.js';
import { isCancelled } from './work.js';

/** Milliseconds between steps when playing: slow enough to watch. */
const stepPace = 90;
/** What the surfaces on the way may take, in bytes. */
const trailSize = 256e6;

/** Smoothing: both surfaces move in step, and can go back. */
export class Smoothing {
  private plays = 0;
  private goals = 0;
  /** Area of the loaded mesh, before any step; 0 until it is known. */
  loadedArea = 0;
  private stepping: Promise<void> | null = null;
  /** The surfaces that were reached, by these moves. */
  readonly trail = new Trail(trailSize);
  private trodden: readonly Move[] = [];
  private loaded: Marks | undefined;
  private readonly scrubbing = latest((step: number) => this.goTo(this.app.state.get().moves, step));

  constructor(private readonly app: App) {}

  set(patch: Partial<State['smooth']>): void {
    this.app.state.set({ smooth: { ...this.app.state.get().smooth, ...patch } });
    if (!('timeH2' in patch)) for (const side of sides) this.app.answers.stability(side);
  }

  /** Another mesh begins at its own beginning. */
  begin(): void {
    this.loadedArea = 0;
    this.trail.clear();
    this.trodden = [];
    this.loaded = undefined;
  }

  /** What was measured of both surfaces after a step, as far as it is known. */
  marks(step: number): Marks | undefined {
    if (step > 0) return this.trail.marks(step);
    const { a, b } = this.app.results.get();
    if (a.step === 0 && b.step === 0 && a.shape && b.shape) this.loaded = { a: a.shape, b: b.shape };
    return this.loaded;
  }

  /** One step on both sides, shown at once. */
  step(): Promise<void> {
    return this.alone(async () => {
      const { mesh, a } = this.app.results.get();
      const state = this.app.state.get();
      if (mesh) await this.take(mesh, upTo(state.moves, state.step), possible(moveOf(state), mesh, a.shape));
    });
  }

  /** To the surfaces after the first steps of moves: back to kept ones, and from there by taking the steps again. */
  async goTo(moves: readonly Move[], step = stepsOf(moves)): Promise<void> {
    const turn = ++this.goals;
    this.pause();
    while (this.stepping) await this.stepping;
    if (turn !== this.goals) return;
    return this.alone(async () => {
      const { mesh } = this.app.results.get();
      if (!mesh) return;
      const wanted = upTo(moves, step);
      let done = this.trail.lastUpTo(common(this.trodden, wanted));
      await this.goBack(mesh, done);
      for (const move of after(wanted, done)) {
        for (let k = 0; k < move.steps; k++) {
          if (turn !== this.goals || this.app.results.get().mesh !== mesh) return;
          if (!(await this.take(mesh, upTo(wanted, done), { ...move, steps: 1 }))) return;
          done++;
        }
      }
      if (this.app.results.get().mesh === mesh) this.app.state.set({ moves, step });
    });
  }

  /** To a step that was taken already; the newest wish counts. */
  scrub(step: number): void {
    this.app.state.set({ step });
    this.scrubbing(step);
  }

  async play(): Promise<void> {
    const { results } = this.app;
    if (results.get().playing || !results.get().mesh) return;
    const turn = ++this.plays;
    const goesOn = () => results.get().playing && turn === this.plays;
    results.set({ playing: true, error: null, notice: t('Smoothing …') });
    while (goesOn()) {
      const pace = new Promise((done) => setTimeout(done, stepPace));
      await this.step();
      if (goesOn()) await pace;
    }
    if (turn === this.plays) this.sayPaused();
  }

  pause(): void {
    if (!this.app.results.get().playing) return;
    this.app.results.set({ playing: false });
    for (const side of sides) this.app.answers.stability(side);
    if (!this.stepping) this.sayPaused();
  }

  toggle(): void {
    if (this.app.results.get().playing) this.pause();
    else void this.play();
  }

  async reset(): Promise<void> {
    await this.goTo([]);
    this.app.results.set({ error: null });
    this.app.say(t('Back to the loaded mesh.'), ofSteps);
  }

  /** What is under way is joined, not doubled. */
  private alone(work: () => Promise<unknown>): Promise<void> {
    this.stepping ??= work()
      .then(() => {})
      .finally(() => {
        this.stepping = null;
      });
    return this.stepping;
  }

  /** Takes one more step, on both sides or on none. @returns whether it was taken */
  private async take(mesh: Mesh, before: readonly Move[], move: Move): Promise<boolean> {
    const { app } = this;
    const step = stepsOf(before);
    const settled = await Promise.allSettled(
      sides.map((side) => {
        const spec = specOf(move.sides[side], move.vertexWeights[side], mesh.vertices);
        const label = `${side.toUpperCase()}: ${t('step {step}', { step: step + 1 })}`;
        return app.work.run(label, (run) => mesh.smooth(spec, optionsOf(move, side, mesh), { side, ...run }), side);
      }),
    );
    if (app.results.get().mesh !== mesh) return false;
    const [a, b] = settled;
    if (a?.status === 'fulfilled' && b?.status === 'fulfilled') {
      const moves = withStep(before, move);
      this.trail.cut(step);
      this.trail.add(step + 1, { a: a.value, b: b.value });
      this.trodden = moves;
      this.show({ a: a.value, b: b.value }, { moves, step: step + 1 }, { error: null });
      return true;
    }
    await this.putBack(mesh, step, settled);
    return false;
  }

  /** A step that failed on a side has not been on the other. */
  private async putBack(mesh: Mesh, step: number, settled: readonly PromiseSettledResult<Smoothed>[]): Promise<void> {
    const { app } = this;
    const stops: Stop[] = [];
    const patch: Partial<Results> = { playing: false };
    for (const [k, side] of sides.entries()) {
      const outcome = settled[k];
      if (outcome?.status !== 'rejected') continue;
      if (isCancelled(outcome.reason)) patch.notice = t('Cancelled; the surfaces are those of the last finished step.');
      else {
        const area = app.results.get()[side].shape?.area ?? this.loadedArea;
        // What unstable steps blow up has not collapsed.
        const collapsed =
          step > 0 &&
          (area < littleLeft * this.loadedArea || (isFaceRefused(outcome.reason) && area < this.loadedArea));
        stops.push({ side, step, collapsed, reason: explain(outcome.reason) });
      }
    }
    if (stops.length > 0) Object.assign(patch, stopNews(stops));
    app.results.set(patch);
    await this.goBack(mesh, step);
  }

  /** Both surfaces to a step that is kept. */
  private async goBack(mesh: Mesh, step: number): Promise<void> {
    const { app } = this;
    const there = this.trail.at(step);
    try {
      const done = app.work.run(t('Back to an earlier surface'), async () => {
        if (there) await Promise.all(sides.map((side) => mesh.restore(there[side], { side })));
        else await mesh.reset();
      });
      // Questions queue up behind it.
      if (there) this.show(there, { step });
      else {
        const { positions } = mesh.geometry;
        for (const side of sides) app.patch(mesh, side, { step: 0, positions, solve: null });
        app.state.set({ step: 0 });
        for (const side of sides) void app.answers.measure(mesh, side);
        app.answers.updateBoth();
      }
      await done;
    } catch (reason) {
      app.fail(mesh, t('The surfaces could not be put back'), reason);
    }
  }

  private show(surfaces: Surfaces, state: Partial<State>, patch: Partial<Results> = {}): void {
    const { app } = this;
    const results = app.results.get();
    const stops: Stop[] = [];
    for (const side of sides) {
      const { step, positions, stats, solve } = surfaces[side];
      patch[side] = { ...results[side], step, positions, shape: stats, solve };
      if (stats.area < nothingLeft * this.loadedArea)
        stops.push({ side, step, collapsed: true, reason: t('Less than a millionth of its area is left.') });
    }
    if (stops.length > 0) Object.assign(patch, { playing: false }, stopNews(stops));
    app.state.set(state);
    app.results.set(patch);
    app.answers.updateBoth();
  }

  /** Unless there is other news already. */
  private sayPaused(): void {
    const { notice, a, b } = this.app.results.get();
    if (notice === t('Smoothing …'))
      this.app.say(t('Paused at step {step}.', { step: count(Math.min(a.step, b.step)) }), ofSteps);
  }
}

const ofSteps = ({ step, source }: State) => [step, source];

const stopNews = (stops: readonly Stop[]): Partial<Results> => ({
  error: stopped(stops),
  notice: t('Stopped at step {step}.', { step: count(Math.max(...stops.map((stop) => stop.step))) }),
});
