import type { Row, Side } from './polylap.js';
import { known, type Results } from './results.js';
import { sides } from './state.js';

/** As for the counts: what is smaller beside the diagonal has no sign. */
const rounding = 1e-10;

/** Column → entry of S. */
export type Entries = ReadonlyMap<number, number>;

/** The rows of a vertex on both sides; null until both are there. */
export function rowsOf({ a, b }: Results, vertex: number | null): Record<Side, Entries> | null {
  const [one, other] = [known(a.row), known(b.row)];
  if (vertex === null || one?.vertex !== vertex || other?.vertex !== vertex) return null;
  return { a: entriesOf(one, vertex), b: entriesOf(other, vertex) };
}

/** What is only rounding beside the diagonal is 0. */
export function entriesOf({ columns, values }: Row, vertex: number): Entries {
  const row = new Map([...columns].map((j, k) => [j, values[k] as number]));
  const least = rounding * Math.abs(row.get(vertex) ?? 0);
  for (const [j, entry] of row) if (Math.abs(entry) <= least) row.set(j, 0);
  return row;
}

/** The row sum, 0 where it is only rounding. */
export function rowSum(row: Entries, vertex: number): number {
  const sum = [...row.values()].reduce((all, entry) => all + entry, 0);
  return Math.abs(sum) > rounding * Math.abs(row.get(vertex) ?? 0) ? sum : 0;
}

/** j → w_ij = −S_ij, of the others that have a weight. */
export const weightsOf = (row: Entries, vertex: number): Entries =>
  new Map([...row].filter(([j, entry]) => j !== vertex && entry !== 0).map(([j, entry]) => [j, -entry]));

/** The same, and 0 for the others that the row has. */
export const drawnWeights = (row: Entries, vertex: number): Entries =>
  new Map([...[...row.keys()].filter((j) => j !== vertex).map((j) => [j, 0] as const), ...weightsOf(row, vertex)]);

/** What both sides' spokes are drawn in proportion to. */
export const largestWeight = (rows: Record<Side, Entries>, vertex: number): number =>
  Math.max(...sides.flatMap((side) => [...weightsOf(rows[side], vertex).values()].map(Math.abs)), Number.MIN_VALUE);
