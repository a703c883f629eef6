/** Which values colour the two surfaces, and how: the views and the legend show the same. */
import type { ColourMap } from './colour-maps.js';
import type { Harmonic, Side } from './polylap.js';
import { known, type Results } from './results.js';
import type { Interval } from './scene/surface.js';
import type { State } from './state.js';

/** How a value stands to the range it should be in. */
export enum Outside {
  below = -1,
  above = 1,
}

export interface Range extends Interval {
  /** The one value everywhere, in the middle of the range. */
  single: number | null;
}

export interface Colouring {
  map: ColourMap;
  range: Range;
  values: Record<Side, Float64Array | null>;
  /** The range of the pins, where vertices leave it. */
  left: Record<Side, Interval | null>;
}

/** Beyond the range of the pins by less, beside its width, is rounding; as in the core. */
const outsideTolerance = 1e-9;

/** How large the values of a harmonic function are: what is tiny beside it is rounding. */
export const sizeOf = ({ fixedMin, fixedMax, min, max }: Harmonic): number =>
  Math.max(...[fixedMin, fixedMax, min, max].map(Math.abs));

/** Where the maximum principle fails: which vertices lie below what was pinned, which above. */
export function outsideOf({ outside, values, fixedMax }: Harmonic): (readonly [number, Outside])[] {
  return Array.from(outside, (vertex) => [
    vertex,
    (values[vertex] as number) > fixedMax ? Outside.above : Outside.below,
  ]);
}

/** null where all vertices stay in it. */
function leftRange({ outside, fixedMin, fixedMax }: Harmonic): Interval | null {
  const slack = outsideTolerance * (fixedMax - fixedMin);
  return outside.length > 0 ? { min: fixedMin - slack, max: fixedMax + slack } : null;
}

/** null when there is nothing to colour. */
export function colouring(state: Pick<State, 'task' | 'mode' | 'colours'>, results: Results): Colouring | null {
  if (state.task === 'harmonic') {
    const shared = sharedRange(results);
    const range = shared && chosenRange(shared, state.colours);
    const values = (side: Side) => known(results[side].harmonic)?.values ?? null;
    const left = (side: Side) => {
      const own = known(results[side].harmonic);
      return own && leftRange(own);
    };
    return (
      range && {
        map: state.colours.map,
        range,
        values: { a: values('a'), b: values('b') },
        left: { a: left('a'), b: left('b') },
      }
    );
  }
  if (state.task !== 'check') return null;
  const mode = (side: Side) => known(results[side].check)?.kernelModes[state.mode[side] ?? -1] ?? null;
  const values = { a: mode('a'), b: mode('b') };
  // Zero in the middle; one range for both sides.
  let reach = 0;
  for (const value of [...(values.a ?? []), ...(values.b ?? [])]) reach = Math.max(reach, Math.abs(value));
  return reach > 0
    ? { map: 'red-blue', range: { min: -reach, max: reach, single: null }, values, left: { a: null, b: null } }
    : null;
}

/** The range that is kept, if one is, or the values' own. */
export function chosenRange(
  shared: Range,
  { locked, symmetric }: Pick<State['colours'], 'locked' | 'symmetric'>,
): Range {
  if (locked) return { ...locked, single: null };
  if (!symmetric || shared.single !== null) return shared;
  const reach = Math.max(Math.abs(shared.min), Math.abs(shared.max));
  return { min: -reach, max: reach, single: null };
}

/** Values that differ by less, beside the largest of them, differ by rounding. */
const rounding = 1e-9;

/** One range for both sides, so that equal colours are equal values; null when there is nothing to show. */
export function sharedRange(results: Record<Side, Pick<Results[Side], 'harmonic'>>): Range | null {
  const shown = [known(results.a.harmonic), known(results.b.harmonic)].filter((harmonic) => harmonic !== null);
  if (shown.length === 0) return null;
  const min = Math.min(...shown.map((harmonic) => harmonic.min));
  const max = Math.max(...shown.map((harmonic) => harmonic.max));
  const size = Math.max(...shown.flatMap(({ fixedMin, fixedMax }) => [Math.abs(fixedMin), Math.abs(fixedMax)]));
  if (max - min > rounding * size) return { min, max, single: null };
  // What was pinned, rather than what rounding made of it.
  const single = shown[0]?.fixedMin ?? min;
  const reach = size || 1;
  return { min: single - reach, max: single + reach, single };
}
