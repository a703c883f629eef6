import { specOf } from './answers.js';
import type { App } from './app.js';
import { count } from './format.js';
import { explain } from './messages.js';
import type { Side, Smoothed } from './polylap.js';
import type { Results } from './results.js';
import { type State, sides } from './state.js';
import { isFaceRefused, littleLeft, nothingLeft, type Stop, stopped } from './stops.js';
import { isCancelled } from './work.js';

/** Milliseconds between steps when playing: slow enough to watch. */
const stepPace = 90;
const playingNotice = 'Smoothing …';

/** Implicit smoothing on both sides in step. */
export class Smoothing {
  private plays = 0;
  /** Area of the loaded mesh, before any step; 0 until it is known. */
  loadedArea = 0;
  private stepping: Promise<void> | null = null;

  constructor(private readonly app: App) {}

  set(patch: Partial<State['smooth']>): void {
    this.app.state.set({ smooth: { ...this.app.state.get().smooth, ...patch } });
  }

  /** One step on both sides, shown at once. A side that lags because its last step failed catches up first. */
  step(): Promise<void> {
    this.stepping ??= this.stepBoth().finally(() => {
      this.stepping = null;
    });
    return this.stepping;
  }

  private async stepBoth(): Promise<void> {
    const { app } = this;
    const { mesh, a, b } = app.results.get();
    if (!mesh) return;
    const { smooth, sides: choices, vertexWeights } = app.state.get();
    const results = { a, b };
    const behind = Math.min(a.step, b.step);
    const moving = sides.filter((side) => results[side].step === behind);
    const options = { time: smooth.timeH2 * mesh.meanSquaredEdge, steps: 1, rebuild: smooth.rebuild };
    const settled = await Promise.allSettled(
      moving.map((side) => {
        const spec = specOf(choices[side], vertexWeights[side], mesh.vertices);
        const label = `${side.toUpperCase()}: step ${behind + 1}`;
        return app.work.run(label, (run) => mesh.smooth(spec, options, { side, ...run }), side);
      }),
    );
    if (app.results.get().mesh !== mesh) return;
    const patch: Partial<Results> = { error: null };
    const stops: Stop[] = [];
    settled.forEach((outcome, k) => {
      const side = moving[k] as Side;
      if (outcome.status === 'fulfilled') {
        const { stats, step } = outcome.value;
        patch[side] = { ...app.results.get()[side], ...surfaceOf(outcome.value) };
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
    app.results.set(patch);
    app.answers.updateBoth();
  }

  async play(): Promise<void> {
    const { results } = this.app;
    if (results.get().playing || !results.get().mesh) return;
    const turn = ++this.plays;
    const goesOn = () => results.get().playing && turn === this.plays;
    results.set({ playing: true, error: null, notice: playingNotice });
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
    if (!this.stepping) this.sayPaused();
  }

  toggle(): void {
    if (this.app.results.get().playing) this.pause();
    else void this.play();
  }

  /** Unless there is other news already. */
  private sayPaused(): void {
    const { notice, a, b } = this.app.results.get();
    if (notice === playingNotice) this.app.say(`Paused at step ${count(Math.min(a.step, b.step))}.`);
  }

  async reset(): Promise<void> {
    const { app } = this;
    this.pause();
    await this.stepping;
    const { mesh } = app.results.get();
    if (!mesh) return;
    try {
      await app.work.run('Back to the loaded mesh', () => mesh.reset());
    } catch (reason) {
      app.fail(mesh, 'The mesh could not be reset', reason);
      return;
    }
    const { positions } = mesh.geometry;
    for (const side of sides) {
      app.patch(mesh, side, { step: 0, positions, solve: null });
      void app.answers.measure(mesh, side);
    }
    app.answers.updateBoth();
    app.results.set({ error: null, notice: 'Back to the loaded mesh.' });
  }
}

function surfaceOf({ step, positions, stats, solve }: Smoothed) {
  return { step, positions, shape: stats, solve };
}
