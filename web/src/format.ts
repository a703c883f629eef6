/** Numbers for people. Machines read the `data-value` beside them. */

import { count, decimals, minus } from './digits.js';
import { language, t } from './words.js';

export { count, minus };

/** A decimal number as the language writes it. */
export const written = (digits: string): string => decimals(minus(digits), language());

/** A number with all its digits, as somebody would type it. */
export const typed = (value: number): string => decimals(String(value), language());

/** Characters that a number may take in a column of a table. */
const room = 8;
const exactRoom = 10;

/** A length, an area, a weight: `digits` significant digits, fewer where the whole number would not fit its place. */
export function real(value: number, digits = 4): string {
  const special = specialText(value);
  if (special) return special;
  const size = Math.abs(value);
  if (size < 1e-4 || size >= 1e6) return fitting((d) => value.toExponential(d - 1), digits, room);
  const whole = Math.max(1, Math.floor(Math.log10(size)) + 1);
  if (whole >= digits) return count(value);
  return written(value.toPrecision(digits));
}

/** Six significant digits without trailing zeros: 4/3 → "1.33333", 1 → "1"; fewer where they would not fit. */
export function exact(value: number): string {
  const special = specialText(value);
  if (special) return special;
  const text = (digits: number) => {
    const rounded = Number(value.toPrecision(digits));
    const plain = rounded.toString();
    return plain.length <= exactRoom ? plain : rounded.toExponential();
  };
  return fitting(text, 6, exactRoom);
}

/** Beside numbers of a size, what is smaller by this is left over from rounding. */
const rounding = 1e-12;

/** 0 where only rounding keeps a value from it. */
export const cleared = (value: number, size: number): number => (Math.abs(value) <= rounding * size ? 0 : value);

/** A signed weight: decimals that line up, as long as they show it. */
export function weight(value: number): string {
  const size = Math.abs(value);
  if (value === 0 || Number.isNaN(value) || (size >= 0.01 && size < 999.9995)) return written((value + 0).toFixed(3));
  if (size >= 0.001 && size < 1) return written(value.toPrecision(2));
  return size < 1 ? written(value.toExponential(1)) : real(value);
}

function specialText(value: number): string | null {
  if (Number.isNaN(value)) return t('undefined');
  if (value === 0) return '0';
  return Number.isFinite(value) ? null : value > 0 ? '∞' : '−∞';
}

/** With as many digits as fit. */
function fitting(write: (digits: number) => string, most: number, width: number): string {
  for (let digits = most; ; digits--) {
    const text = write(digits).replace('e+', 'e');
    if (text.length <= width || digits === 1) return written(text);
  }
}

/** 'min-max-angle' → "Min max angle" */
export function words(id: string): string {
  const text = id.replaceAll('-', ' ');
  return text.charAt(0).toUpperCase() + text.slice(1);
}
