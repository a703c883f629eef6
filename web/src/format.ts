/** Numbers for people. Machines read the `data-value` beside them. */

const thinSpace = '\u202f';

/** 2048 → "2 048" */
export function count(value: number): string {
  return minus(
    Math.round(value)
      .toString()
      .replace(/\B(?=(\d{3})+$)/g, thinSpace),
  );
}

/** A length, an area, a weight: `digits` significant digits, scientific only where plain digits would not fit a readout. */
export function real(value: number, digits = 4): string {
  if (Number.isNaN(value)) return 'undefined';
  if (value === 0) return '0';
  if (!Number.isFinite(value)) return value > 0 ? '∞' : '−∞';
  const size = Math.abs(value);
  if (size !== 0 && (size < 1e-4 || size >= 1e6)) return minus(value.toExponential(digits - 1));
  const whole = Math.max(1, Math.floor(Math.log10(size)) + 1);
  if (whole >= digits) return count(value);
  return minus(value.toPrecision(digits));
}

/** Six significant digits without trailing zeros: 4/3 → "1.33333", 1 → "1". */
export function exact(value: number): string {
  if (Number.isNaN(value)) return 'undefined';
  return minus(Number(value.toPrecision(6)).toString());
}

/** A signed weight with fixed decimals, so that columns line up. */
export function weight(value: number): string {
  const text = value.toFixed(3);
  return minus(text === '-0.000' ? '0.000' : text);
}

export function plural(value: number, one: string, many = `${one}s`): string {
  return `${count(value)}\u00a0${value === 1 ? one : many}`;
}

/** 'min-max-angle' → "Min max angle" */
export function words(id: string): string {
  const text = id.replaceAll('-', ' ');
  return text.charAt(0).toUpperCase() + text.slice(1);
}

function minus(text: string): string {
  return text.replaceAll('-', '−');
}
