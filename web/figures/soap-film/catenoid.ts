/** The catenoid between two rings of radius 1 at the heights ±h: r = c cosh(z/c). */

/** Largest h for which there is one: 1/sinh x, where x tanh x = 1. */
export const largestHeight = 0.6627434193;

/** Of the two catenoids the outer one, the stable one. @returns NaN where there is none */
export function waist(h: number): number {
  // Where the slope of c cosh(h/c) − 1 is 0, its lowest point: beyond it the two solutions have run into each other.
  if (h > largestHeight) return Number.NaN;
  let c = 1;
  // The function is convex, and c begins above its larger zero: Newton's steps come down to it and never past it.
  for (;;) {
    const x = h / c;
    const step = (c * Math.cosh(x) - 1) / (Math.cosh(x) - x * Math.sinh(x));
    if (!(step > 1e-15)) return c;
    c -= step;
  }
}

export const radiusAt = (c: number, z: number): number => c * Math.cosh(z / c);

/** 2π ∫ r √(1 + r′²) dz. */
export const areaOf = (c: number, h: number): number => Math.PI * c * (2 * h + c * Math.sinh((2 * h) / c));
