import type { App } from './app.js';
import { differenceOf } from './difference.js';

/** Keeps the difference of the sides up to date while somebody looks at it. */
export function compare(app: App): void {
  const update = () => {
    const state = app.state.get();
    const results = app.results.get();
    const wanted = state.delta.open || state.shown === 'delta';
    const difference = wanted ? differenceOf(state, results) : null;
    if (difference !== results.difference) app.results.set({ difference });
  };
  app.state.watch((state) => [state.task, state.delta.open, state.delta.gain, state.shown], update);
  app.results.watch(({ mesh, a, b }) => [mesh, a.positions, b.positions, a.harmonic, b.harmonic], update);
}
