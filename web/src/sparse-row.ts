import type { SparseMatrix } from './polylap.js';

/** Row i of a matrix in compressed columns: column → value. */
export function sparseRow({ cols, colStarts, rowIndices, values }: SparseMatrix, i: number): Map<number, number> {
  const row = new Map<number, number>();
  for (let j = 0; j < cols; j++) {
    for (let at = colStarts[j] as number; at < (colStarts[j + 1] as number); at++) {
      if (rowIndices[at] === i) row.set(j, values[at] as number);
    }
  }
  return row;
}
