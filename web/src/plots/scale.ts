/** Round numbers within [min, max]: at least one less than wanted, and never a single one. */
export function ticks(min: number, max: number, wanted = 3): number[] {
  const span = max - min;
  if (!(span > 0) || !Number.isFinite(span)) return [min];
  const power = 10 ** Math.floor(Math.log10(span / wanted));
  for (const factor of [10, 5, 2, 1, 0.5]) {
    const step = factor * power;
    const first = Math.ceil(min / step - 1e-9);
    const last = Math.floor(max / step + 1e-9);
    // Multiples of the step, with no digits beyond its own.
    if (last - first + 1 >= Math.max(2, wanted - 1))
      return Array.from({ length: last - first + 1 }, (_, k) => Number(((first + k) * step).toPrecision(12)));
  }
  return [min, max];
}

export interface Bin {
  from: number;
  to: number;
  count: number;
}

/** Equal bins over [min, max]; where 0 lies within, it is an edge between two of them. */
export function histogram(values: Iterable<number>, min: number, max: number, wanted = 32): Bin[] {
  const across = min < 0 && max > 0;
  const width = (max - min || 1) / wanted;
  const below = across ? Math.ceil(-min / width) : 0;
  const count = across ? below + Math.ceil(max / width) : wanted;
  const start = across ? -below * width : min;
  const bins = Array.from({ length: count }, (_, k) => ({
    from: start + k * width,
    to: start + (k + 1) * width,
    count: 0,
  }));
  for (const value of values) {
    const bin = bins[Math.min(count - 1, Math.max(0, Math.floor((value - start) / width)))];
    if (bin) bin.count++;
  }
  return bins;
}
