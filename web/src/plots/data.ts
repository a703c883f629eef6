/** The numbers behind the plots. */
import type { Geometry, SparseMatrix } from '../polylap.js';
import { type Bin, histogram } from './scale.js';

/** What is smaller beside the diagonal is rounding, as for the counts. */
const rounding = 1e-10;

/** w_ij of all ordered pairs that have a weight. */
export function weightsOf({ cols, colStarts, rowIndices, values }: SparseMatrix): number[] {
  let diagonal = 0;
  for (let j = 0; j < cols; j++)
    for (let at = colStarts[j] as number; at < (colStarts[j + 1] as number); at++)
      if (rowIndices[at] === j) diagonal = Math.max(diagonal, Math.abs(values[at] as number));
  const found: number[] = [];
  for (let j = 0; j < cols; j++)
    for (let at = colStarts[j] as number; at < (colStarts[j + 1] as number); at++) {
      const value = values[at] as number;
      if (rowIndices[at] !== j && Math.abs(value) > rounding * diagonal) found.push(-value);
    }
  return found;
}

/** Weights of both sides in the same bins. */
export function weightBins(a: readonly number[], b: readonly number[]): [Bin[], Bin[]] {
  let [min, max] = [0, 0];
  for (const weights of [a, b])
    for (const weight of weights) {
      min = Math.min(min, weight);
      max = Math.max(max, weight);
    }
  return [histogram(a, min, max), histogram(b, min, max)];
}

/** Corners → faces with so many, ascending. */
export function faceSizes({ offsets }: Geometry): [number, number][] {
  const sizes = new Map<number, number>();
  for (let f = 0; f + 1 < offsets.length; f++) {
    const corners = (offsets[f + 1] as number) - (offsets[f] as number);
    sizes.set(corners, (sizes.get(corners) ?? 0) + 1);
  }
  return [...sizes].sort(([p], [q]) => p - q);
}

/** The blocks of a matrix that have entries: row · across + column → whether any weight in it is negative. */
export function spyBlocks(
  { cols, colStarts, rowIndices, values }: SparseMatrix,
  most = 66,
): { blocks: Map<number, boolean>; across: number } {
  const across = Math.min(cols, most);
  const blocks = new Map<number, boolean>();
  const block = (i: number) => Math.floor((i * across) / cols);
  for (let j = 0; j < cols; j++)
    for (let at = colStarts[j] as number; at < (colStarts[j + 1] as number); at++) {
      const value = values[at] as number;
      if (value === 0) continue;
      const i = rowIndices[at] as number;
      const key = block(i) * across + block(j);
      blocks.set(key, (blocks.get(key) ?? false) || (i !== j && value > 0));
    }
  return { blocks, across };
}
