import { exact, real } from './format.js';
import type { Stability } from './polylap.js';

/** What an explicit step does, for people. */
export interface Verdict {
  unstable: boolean;
  /** The limit beside the step, where there is something to compare. */
  compared: string;
  /** μ_max times h². */
  roughest: string;
  /** What becomes of the roughest mode. */
  effect: string;
}

/**
 * By what a step multiplies the mode that shows most: the roughest, or that of a negative eigenvalue where it grows more.
 * @param time length²
 */
export function growth({ largest, smallest }: Stability, time: number): number {
  const [top, bottom] = [1 - time * largest, 1 - time * smallest];
  return smallest < 0 && Math.abs(bottom) > Math.abs(top) ? bottom : top;
}

/** @param h2 length² */
export function verdict(stability: Stability, timeH2: number, h2: number): Verdict {
  const { largest, smallest, limit } = stability;
  const factor = growth(stability, timeH2 * h2);
  const roughest = real(largest * h2, 3);
  const limitText = real(limit / h2, 3);
  const step = exact(timeH2);
  if (smallest < 0) {
    const bend = real(smallest * h2, 3);
    return {
      unstable: true,
      compared: 'no step is stable',
      roughest,
      effect: `S has the eigenvalue ${bend}/h², and a mode grows ${fold(factor)} a step${sign(factor)}.`,
    };
  }
  if (timeH2 * h2 > limit)
    return {
      unstable: true,
      compared: `t = ${step} h² > ${limitText} h²`,
      roughest,
      effect: `the roughest mode grows ${fold(factor)} a step${sign(factor)}.`,
    };
  return {
    unstable: false,
    compared: `stable for t < ${limitText} h²`,
    roughest,
    effect: `a step multiplies the roughest mode by ${real(factor, 2)}.`,
  };
}

const fold = (factor: number) => `${real(Math.abs(factor), Math.abs(factor) < 1.1 ? 4 : 2)}-fold`;
const sign = (factor: number) => (factor < 0 ? ', with alternating sign' : '');
