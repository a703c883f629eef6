/** What tells B from A: of values in Harmonic, of positions otherwise. */
import type { ColourMap } from './colour-maps.js';
import type { Range } from './colouring.js';
import { meanEdge } from './mean-edge.js';
import { known, type Results } from './results.js';
import type { State } from './state.js';

export interface Difference {
  of: 'values' | 'positions';
  /** 3V: the surface A, with B's way from it amplified. */
  positions: Float32Array;
  /** V: B − A for values; the distance for positions, in mean edge lengths. NaN where one side has no value. */
  values: Float64Array;
  /** Of |values|; the root mean square is over vertices. */
  max: number;
  rms: number;
  /** Where the largest is. */
  vertex: number;
  range: Range;
  map: ColourMap;
}

/** Below this share of what is compared, a difference is rounding: float positions have 24 bits. */
const rounding = 2 ** -20;

/** null as long as there is nothing to compare. */
export function differenceOf(
  state: Pick<State, 'task'> & { delta: Pick<State['delta'], 'gain'> },
  results: Pick<Results, 'a' | 'b' | 'mesh'>,
): Difference | null {
  const { a, b, mesh } = results;
  if (!mesh || a.positions.length !== b.positions.length || a.positions.length === 0) return null;
  const { gain } = state.delta;
  if (state.task === 'harmonic') {
    const [one, other] = [known(a.harmonic), known(b.harmonic)];
    if (!one || !other) return null;
    const values = Float64Array.from(one.values, (value, v) => (other.values[v] ?? Number.NaN) - value);
    const figures = sizeOf(values);
    const reach = (figures.max || 1) / gain;
    return {
      of: 'values',
      positions: a.positions,
      values,
      ...figures,
      range: { min: -reach, max: reach, single: null },
      map: 'red-blue',
    };
  }
  const unit = meanEdge(mesh.geometry);
  const positions = a.positions.map((coordinate, k) => coordinate + gain * ((b.positions[k] as number) - coordinate));
  const values = new Float64Array(a.positions.length / 3);
  for (let v = 0; v < values.length; v++) {
    const along = (c: number) => (b.positions[3 * v + c] as number) - (a.positions[3 * v + c] as number);
    values[v] = Math.hypot(along(0), along(1), along(2)) / unit;
  }
  const figures = sizeOf(values);
  return {
    of: 'positions',
    positions,
    values,
    ...figures,
    range: { min: 0, max: figures.max || 1, single: null },
    map: 'viridis',
  };
}

/** Whether there is more than rounding to see, beside what is compared. */
export const isDifferent = ({ max }: Pick<Difference, 'max'>, beside = 1): boolean => max > rounding * beside;

function sizeOf(values: Float64Array): Pick<Difference, 'max' | 'rms' | 'vertex'> {
  let [max, vertex, squares, counted] = [0, 0, 0, 0];
  values.forEach((value, v) => {
    if (!Number.isFinite(value)) return;
    squares += value * value;
    counted++;
    if (Math.abs(value) > max) [max, vertex] = [Math.abs(value), v];
  });
  return { max, rms: Math.sqrt(squares / (counted || 1)), vertex };
}
