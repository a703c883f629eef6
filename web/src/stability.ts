import { exact, real } from './format.js';
import type { Stability } from './polylap.js';
import { t } from './words.js';

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
      compared: t('no step is stable'),
      roughest,
      effect: t('S has the eigenvalue {bend}/h², and a mode grows {factor}-fold a step{sign}.', {
        bend,
        ...grown(factor),
      }),
    };
  }
  if (timeH2 * h2 > limit)
    return {
      unstable: true,
      compared: `t = ${step} h² > ${limitText} h²`,
      roughest,
      effect: t('the roughest mode grows {factor}-fold a step{sign}.', grown(factor)),
    };
  return {
    unstable: false,
    compared: t('stable for t < {limit} h²', { limit: limitText }),
    roughest,
    effect: t('a step multiplies the roughest mode by {factor}.', { factor: real(factor, 2) }),
  };
}

const grown = (factor: number) => ({
  factor: real(Math.abs(factor), Math.abs(factor) < 1.1 ? 4 : 2),
  sign: factor < 0 ? t(', with alternating sign') : '',
});
