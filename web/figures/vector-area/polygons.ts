/** The polygons of the figure: of area 1 seen from above, about the origin, in no plane unless the height is 0. */
import type { MeshArrays } from '../../src/polylap.js';
import type { Vec } from '../svg3d.js';

export const kinds = ['saddle', 'corner', 'hexagon'] as const;
export type Kind = (typeof kinds)[number];

const regular = (corners: number, lift: (k: number) => number): Vec[] => {
  const radius = Math.sqrt(2 / (corners * Math.sin((2 * Math.PI) / corners)));
  return Array.from({ length: corners }, (_, k) => {
    const angle = (2 * Math.PI * (k - 0.5)) / corners;
    return [radius * Math.cos(angle), radius * Math.sin(angle), lift(k)];
  });
};

/** @param height from the lowest to the highest corner */
export function polygon(kind: Kind, height: number): Vec[] {
  const zigzag = (k: number) => (k % 2 === 0 ? -height / 2 : height / 2);
  if (kind === 'saddle') return regular(4, zigzag);
  if (kind === 'hexagon') return regular(6, zigzag);
  return regular(4, (k) => (k === 1 ? 0.75 * height : -0.25 * height));
}

export const oneFace = (points: readonly Vec[]): MeshArrays => ({
  coordinates: Float64Array.from(points.flat()),
  offsets: Int32Array.of(0, points.length),
  corners: Int32Array.from(points.keys()),
});

/** As a file, for the link into the full page. */
export const objOf = (points: readonly Vec[]): string =>
  [...points.map((p) => `v ${p.join(' ')}`), `f ${points.map((_, k) => k + 1).join(' ')}`, ''].join('\n');
