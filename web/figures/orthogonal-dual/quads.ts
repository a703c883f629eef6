/** Quads in the plane that are no squares. */
import type { Point } from '../figure.js';
import type { Flat } from '../flat.js';

export const meshes = ['shaken', 'sheared', 'sheared-more'] as const;
export type MeshName = (typeof meshes)[number];

/** Quads a side. */
export const sideOf: Readonly<Record<MeshName, number>> = { shaken: 6, sheared: 4, 'sheared-more': 8 };

/** n × n unit squares about the origin, sheared or shaken by `amount`. */
export function quads(name: MeshName, amount: number): Flat {
  const n = sideOf[name];
  const shaken = noise();
  const points: Point[] = [];
  const faces: number[][] = [];
  for (let j = 0; j <= n; ++j) {
    for (let i = 0; i <= n; ++i) {
      const [x, y] = [i - n / 2, j - n / 2];
      points.push(name === 'shaken' ? [x + amount * shaken(), y + amount * shaken()] : [x + amount * y, y]);
      const v = j * (n + 1) + i;
      if (i < n && j < n) faces.push([v, v + 1, v + n + 2, v + n + 1]);
    }
  }
  return { points, faces };
}

/** The same numbers in [-1, 1) everywhere. */
function noise(): () => number {
  let state = 1;
  const next = () => {
    state = (Math.imul(state, 1664525) + 1013904223) >>> 0;
    return state / 2 ** 31 - 1;
  };
  // The first ones of small seeds are alike.
  for (let k = 0; k < 5; ++k) next();
  return next;
}
