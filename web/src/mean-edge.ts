import type { Geometry } from './polylap.js';

const known = new WeakMap<Geometry, number>();

/** Of the loaded mesh; every edge counts as often as it has faces. */
export function meanEdge(geometry: Geometry): number {
  let length = known.get(geometry);
  if (length === undefined) {
    length = measure(geometry);
    known.set(geometry, length);
  }
  return length;
}

function measure({ positions, offsets, corners }: Geometry): number {
  let sum = 0;
  for (let f = 0; f + 1 < offsets.length; f++) {
    const last = (offsets[f + 1] as number) - 1;
    let before = 3 * (corners[last] as number);
    for (let c = offsets[f] as number; c <= last; c++) {
      const here = 3 * (corners[c] as number);
      sum += Math.hypot(
        (positions[here] as number) - (positions[before] as number),
        (positions[here + 1] as number) - (positions[before + 1] as number),
        (positions[here + 2] as number) - (positions[before + 2] as number),
      );
      before = here;
    }
  }
  return sum / corners.length;
}
