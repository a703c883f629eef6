import type { Geometry } from './polylap.js';

/** Vertices that share an edge with one, in the order of their faces. */
export function neighbours({ offsets, corners }: Geometry, vertex: number): number[] {
  const found = new Set<number>();
  for (let f = 0; f + 1 < offsets.length; f++) {
    const face = corners.subarray(offsets[f], offsets[f + 1]);
    const at = face.indexOf(vertex);
    if (at < 0) continue;
    found.add(face[(at + face.length - 1) % face.length] as number);
    found.add(face[(at + 1) % face.length] as number);
  }
  return [...found];
}
