/** The row of a vertex on its mesh: a spoke to each vertex it is coupled to, along the surface. */
import type { Row } from '../polylap.js';
import { Dots } from './dots.js';
import type { Layer } from './layers.js';
import { Lines } from './lines.js';

/** Of the largest weight, and of the least that is drawn at all, in CSS pixels; dashes need a little more. */
const [widest, thinnest, thinnestDashed] = [7, 1.5, 2.5];
/** Where on its spoke the minus stands: away from the vertex, where the spokes meet. */
const minusAt = 0.62;

/** @param weights j → w_ij   @param largest |w| of both sides   @param edge mean edge length */
export function spokes(
  row: Row,
  weights: ReadonlyMap<number, number>,
  largest: number,
  edge: number,
): Record<'spokes' | 'minusSpokes' | 'minuses', Layer | null> {
  const weightOf = (segment: number) => weights.get(row.columns[row.segmentPairs[segment] as number] as number) ?? 0;
  const all = [...row.segmentPairs.keys()];
  const lines = (chosen: number[], ink: 'spoke' | 'negative', least: number) =>
    chosen.length === 0
      ? null
      : new Lines(
          {
            segments: Float32Array.from(chosen.flatMap((s) => [...row.segments.subarray(6 * s, 6 * s + 6)])),
            segmentStarts: Float32Array.from(chosen, (s) => row.segmentStarts[s] as number),
            shares: Float32Array.from(chosen, (s) => Math.max(least / widest, Math.abs(weightOf(s)) / largest)),
          },
          {
            ink,
            dashed: ink === 'negative',
            filled: true,
            period: 11,
            width: widest,
            lift: 0.12 * edge,
            slender: 0.22,
          },
        );
  const negative = all.filter((s) => weightOf(s) < 0);
  return {
    spokes: lines(
      all.filter((s) => weightOf(s) > 0),
      'spoke',
      thinnest,
    ),
    minusSpokes: lines(negative, 'negative', thinnestDashed),
    minuses: negative.length === 0 ? null : minuses(row, negative, edge),
  };
}

function minuses({ segments, segmentStarts, segmentPairs }: Row, chosen: readonly number[], edge: number): Dots {
  const end = (s: number) => {
    const from = segments.subarray(6 * s, 6 * s + 6);
    const [x = 0, y = 0, z = 0, X = 0, Y = 0, Z = 0] = from;
    return (segmentStarts[s] as number) + Math.hypot(X - x, Y - y, Z - z);
  };
  const lengths = new Map<number, number>();
  for (const s of chosen) {
    const pair = segmentPairs[s] as number;
    lengths.set(pair, Math.max(lengths.get(pair) ?? 0, end(s)));
  }
  const places = chosen.flatMap((s) => {
    const wanted = minusAt * (lengths.get(segmentPairs[s] as number) ?? 0);
    const start = segmentStarts[s] as number;
    const share = (wanted - start) / (end(s) - start);
    if (!(share > 0 && share <= 1)) return [];
    return [0, 1, 2].map((c) => {
      const from = segments[6 * s + c] as number;
      return from + share * ((segments[6 * s + 3 + c] as number) - from);
    });
  });
  const size = 13;
  return new Dots(Float32Array.from(places), {
    ink: 'negative',
    shape: 'minus',
    size,
    lift: 0.3 * edge,
    spacing: 1.2 * edge,
  });
}
