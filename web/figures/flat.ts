/** Meshes of the plane that a figure makes itself, and what is read of the core's matrices on them. */
import type { MeshArrays, SparseMatrix } from '../src/polylap.js';
import type { Point } from './figure.js';

export interface Flat {
  readonly points: readonly Point[];
  /** Counter-clockwise. */
  readonly faces: readonly (readonly number[])[];
}

export function arraysOf({ points, faces }: Flat): MeshArrays {
  const offsets = new Int32Array(faces.length + 1);
  faces.forEach((face, f) => {
    offsets[f + 1] = (offsets[f] as number) + face.length;
  });
  return {
    coordinates: Float64Array.from(points.flatMap(([x, y]) => [x, y, 0])),
    offsets,
    corners: Int32Array.from(faces.flat()),
  };
}

/** For the link into the full page. */
export const objOf = ({ points, faces }: Flat): string =>
  [
    ...points.map(([x, y]) => `v ${x} ${y} 0`),
    ...faces.map((face) => `f ${face.map((vertex) => vertex + 1).join(' ')}`),
    '',
  ].join('\n');

/** @returns 0 where none is stored */
export function entry({ colStarts, rowIndices, values }: SparseMatrix, row: number, column: number): number {
  for (let k = colStarts[column] as number; k < (colStarts[column + 1] as number); ++k)
    if (rowIndices[k] === row) return values[k] as number;
  return 0;
}

/** A matrix times a function with two components, row by row: S u. */
export function times(matrix: SparseMatrix, u: readonly Point[]): Point[] {
  const sum = Array.from({ length: matrix.rows }, (): [number, number] => [0, 0]);
  u.forEach(([x, y], column) => {
    for (let k = matrix.colStarts[column] as number; k < (matrix.colStarts[column + 1] as number); ++k) {
      const [to, value] = [sum[matrix.rowIndices[k] as number] as [number, number], matrix.values[k] as number];
      to[0] += value * x;
      to[1] += value * y;
    }
  });
  return sum;
}
