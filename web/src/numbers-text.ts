/** Numbers into text for other programs: all digits, a point, nothing grouped. */
import type { SparseMatrix } from './polylap.js';

/** A matrix in MatrixMarket's `coordinate real` form, whose indices count from 1; only its lower half where it is symmetric to the bit. */
export function matrixMarket({ rows, cols, colStarts, rowIndices, values }: SparseMatrix, comment: string): string {
  const entries = new Map<number, number>();
  for (let j = 0; j < cols; j++)
    for (let at = colStarts[j] as number; at < (colStarts[j + 1] as number); at++) {
      const value = values[at] as number;
      const i = rowIndices[at] as number;
      // Vertices that only share a face.
      if (value !== 0 || i === j) entries.set(j * rows + i, value);
    }
  const symmetric =
    rows === cols &&
    [...entries].every(([key, value]) => entries.get((key % rows) * rows + Math.floor(key / rows)) === value);
  const lines: string[] = [];
  for (const [key, value] of entries) {
    const [i, j] = [key % rows, Math.floor(key / rows)];
    if (!symmetric || i >= j) lines.push(`${i + 1} ${j + 1} ${value}`);
  }
  const head = `%%MatrixMarket matrix coordinate real ${symmetric ? 'symmetric' : 'general'}\n% ${comment}\n`;
  return `${head}${rows} ${cols} ${lines.length}\n${lines.join('\n')}\n`;
}

type Cell = string | number | null | undefined;

/** Comma-separated values (RFC 4180, but with line feeds); what has no value is empty. */
export function csv(head: readonly string[], rows: Iterable<readonly Cell[]>): string {
  const cell = (value: Cell) => {
    if (value === null || value === undefined || Number.isNaN(value)) return '';
    const text = String(value);
    return /[",\n]/.test(text) ? `"${text.replaceAll('"', '""')}"` : text;
  };
  const line = (cells: readonly Cell[]) => `${cells.map(cell).join(',')}\n`;
  let text = line(head);
  for (const row of rows) text += line(row);
  return text;
}
