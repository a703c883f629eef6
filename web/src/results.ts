import type { Harmonic, Matrices, Mesh, Shape, Side, Weights } from './polylap.js';

/** What the core said about one side's surface. A string stands where it said why not. */
export interface SideResults {
  /** Smoothing steps since the loaded mesh. */
  step: number;
  /** 3V, relative to the geometry's origin. */
  positions: Float32Array;
  shape: Shape | null;
  weights: Weights | string | null;
  harmonic: Harmonic | string | null;
  matrices: Matrices | string | null;
}

export interface Message {
  title: string;
  text: string;
}

export interface Busy {
  label: string;
  /** In [0, 1]; null as long as nothing was reported. */
  fraction: number | null;
}

export interface Results {
  mesh: Mesh | null;
  a: SideResults;
  b: SideResults;
  error: Message | null;
  /** The status line. */
  notice: string;
  busy: Busy | null;
  playing: boolean;
  /** Vertex under the pointer. */
  hovered: number | null;
}

export function freshSide(positions: Float32Array = new Float32Array(0)): SideResults {
  return { step: 0, positions, shape: null, weights: null, harmonic: null, matrices: null };
}

export function noResults(): Results {
  return {
    mesh: null,
    a: freshSide(),
    b: freshSide(),
    error: null,
    notice: 'Starting …',
    busy: null,
    playing: false,
    hovered: null,
  };
}

export interface Range {
  min: number;
  max: number;
  /** The one value everywhere, in the middle of the range. */
  single: number | null;
}

/** Values that differ by less, beside the largest of them, differ by rounding. */
const rounding = 1e-9;

/** One range for both sides, so that equal colours are equal values; null when there is nothing to show. */
export function sharedRange(results: Pick<Results, Side>): Range | null {
  const shown = [results.a.harmonic, results.b.harmonic].filter(
    (harmonic) => harmonic !== null && typeof harmonic !== 'string',
  );
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
