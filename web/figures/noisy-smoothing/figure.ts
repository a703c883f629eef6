/** Noise smoothed away by two operators, and what tells their surfaces apart (Herholz 2012, Figs. 4.7 and 4.8). */
import { meanEdge } from '../../src/mean-edge.js';
import { moveOf, optionsOf } from '../../src/moves.js';
import type { Client, OperatorSpec, Side } from '../../src/polylap.js';
import { openBunny } from '../bunny.js';
import { stateWith } from '../common.js';
import { type Compared, compared, type Reading, type Settings } from '../figure.js';
import { fixed } from '../svg.js';

const specs: Readonly<Record<Side, OperatorSpec>> = { a: { id: 'alexa-wardetzky' }, b: { id: 'planar' } };
/** A few more, and on this bunny a quad crosses itself in the projection that the planar operator cuts. */
const mostSteps = 12;
const gains = { surfaces: null, x1: 1, x10: 10, x100: 100 } as const;

/** So many steps of the page's own kind. */
const state = ({ steps, shown }: Settings) =>
  stateWith((initial) => {
    const gain = gains[shown as keyof typeof gains];
    const move = { ...moveOf(initial), steps: mostSteps };
    return {
      task: 'smooth',
      source: { kind: 'preset', id: 'noisy-bunny' },
      moves: [move],
      step: Number(steps),
      negativeShown: { ...initial.negativeShown, smooth: false },
      ...(gain && { shown: 'delta', delta: { ...initial.delta, open: true, gain } }),
    };
  });

async function compute(client: Client, settings: Settings): Promise<Reading[]> {
  const steps = Number(settings.steps);
  const [clean, noisy] = await Promise.all([openBunny(client, 'bunny'), openBunny(client, 'noisy-bunny')]);
  try {
    const [move] = state(settings).moves;
    const after = async (side: Side) => {
      if (!move || steps === 0) return { positions: noisy.geometry.positions, stats: await noisy.shape({ side }) };
      const options = { ...optionsOf(move, side, noisy), steps };
      return noisy.smooth(specs[side], options, { side });
    };
    const [a, b] = await Promise.all([after('a'), after('b')]);
    const unit = meanEdge(noisy.geometry);
    // Positions are relative to the middle of each mesh's own box.
    const shift = noisy.geometry.origin.map((c, axis) => c - (clean.geometry.origin[axis] as number));
    const original = clean.geometry.positions.map((c, k) => c - (shift[k % 3] as number));
    const apart = distances(a.positions, b.positions, unit);
    const length = (id: string, value: number): Reading => ({ id, value, text: fixed(value, 4) });
    return [
      length('largest', apart.largest),
      length('rms', apart.rms),
      length('noise-a', distances(a.positions, original, unit).rms),
      length('noise-b', distances(b.positions, original, unit).rms),
      length('non-planarity-a', a.stats.meanNonPlanarity),
      length('non-planarity-b', b.stats.meanNonPlanarity),
    ];
  } finally {
    await Promise.all([clean.close(), noisy.close()]);
  }
}

/** Between vertices of the same number. */
function distances(one: Float32Array, other: Float32Array, unit: number): { largest: number; rms: number } {
  let [largest, sum] = [0, 0];
  for (let k = 0; k < one.length; k += 3) {
    const along = (c: number) => (one[k + c] as number) - (other[k + c] as number);
    const distance = Math.hypot(along(0), along(1), along(2)) / unit;
    largest = Math.max(largest, distance);
    sum += distance ** 2;
  }
  return { largest, rms: Math.sqrt((3 * sum) / one.length) };
}

export const figure: Compared = compared({
  id: 'noisy-smoothing',
  number: 11,
  controls: [
    { kind: 'slider', id: 'steps', min: 0, max: mostSteps, step: 1, initial: 6 },
    { kind: 'choice', id: 'shown', view: true, choices: Object.keys(gains), initial: 'surfaces' },
  ],
  compute,
  state,
});
