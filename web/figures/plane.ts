/** Geometry of the plane: what a figure draws around a mesh. */
import type { Point } from './figure.js';

export const plus = ([a, b]: Point, [c, d]: Point, times = 1): Point => [a + times * c, b + times * d];
export const minus = ([a, b]: Point, [c, d]: Point): Point => [a - c, b - d];
export const dot = ([a, b]: Point, [c, d]: Point): number => a * c + b * d;
export const cross = ([a, b]: Point, [c, d]: Point): number => a * d - b * c;
export const length = (v: Point): number => Math.hypot(...v);
export const between = (a: Point, b: Point, share: number): Point => plus(a, minus(b, a), share);
/** Of length 1. */
export const unit = (v: Point): Point => [v[0] / length(v), v[1] / length(v)];
/** Turned by a quarter to the left. */
export const left = ([x, y]: Point): Point => [-y, x];

/** Positive where the corners run counter-clockwise. */
export const signedArea = (a: Point, b: Point, c: Point): number => cross(minus(b, a), minus(c, a)) / 2;

/** At a, from b to c, in radians. */
export function angle(a: Point, b: Point, c: Point): number {
  const [u, v] = [minus(b, a), minus(c, a)];
  return Math.atan2(Math.abs(cross(u, v)), dot(u, v));
}

export type Triangle = readonly [Point, Point, Point];

/**
 * The point with the same power |p - x_i|² - ω_i to all three corners; of equal weights the circumcentre.
 * @param weights ω, length²
 */
export function powerCentre([a, b, c]: Triangle, [wa, wb, wc]: readonly [number, number, number] = [0, 0, 0]): Point {
  const [u, v] = [minus(b, a), minus(c, a)];
  const [p, q] = [(dot(u, u) + wa - wb) / 2, (dot(v, v) + wa - wc) / 2];
  const twice = cross(u, v);
  return plus(a, [(p * v[1] - q * u[1]) / twice, (q * u[0] - p * v[0]) / twice]);
}

/**
 * The length of the dual edge across the edge from a to b, from the face on its right to that on its left: negative where it runs backwards.
 * @param onLeft, onRight dual vertices
 */
export const signedDualLength = (a: Point, b: Point, onLeft: Point, onRight: Point): number =>
  dot(minus(onLeft, onRight), unit(left(minus(b, a))));
