/** A piece of a triangle mesh: a vertex, the six around it, and the twelve around those. */
import type { Point } from '../figure.js';
import type { Flat } from '../flat.js';

/** The vertices that triangles go all the way around: the first ones. */
export const inner = 7;

/** Not quite the regular one: each edge has a weight of its own. */
const near: readonly Point[] = [
  [1.02, 0.06],
  [0.46, 0.9],
  [-0.52, 0.84],
  [-1.0, -0.08],
  [-0.44, -0.9],
  [0.56, -0.84],
];
const far: readonly Point[] = [
  [1.94, 0.1],
  [1.58, 0.84],
  [1.0, 1.62],
  [-0.06, 1.74],
  [-0.96, 1.78],
  [-1.56, 0.8],
  [-1.96, -0.04],
  [-1.44, -0.96],
  [-1.06, -1.66],
  [0.08, -1.8],
  [1.06, -1.7],
  [1.48, -0.86],
];

/** @param middle where the first vertex is */
export function patch(middle: Point): Flat {
  const faces = Array.from({ length: 6 }, (_, k) => {
    const [a, b] = [1 + k, 1 + ((k + 1) % 6)];
    const [c, d, e] = [7 + 2 * k, 8 + 2 * k, 7 + ((2 * k + 2) % 12)];
    return [
      [0, a, b],
      [a, c, d],
      [a, d, b],
      [b, d, e],
    ];
  }).flat();
  return { points: [middle, ...near, ...far], faces };
}
