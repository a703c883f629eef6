/** What figures of duals draw alike: in pixels of a picture, of points that are there already. */
import { minus as minusSign } from '../src/format.js';
import type { Point } from './figure.js';
import { dot, length, minus, plus, unit } from './plane.js';
import { polyline, tag } from './svg.js';

/** What rounding leaves of 0, in few digits. */
export const rounding = (value: number): string => (value === 0 ? '0' : minusSign(value.toExponential(1)));

/** The mark of a right angle at a corner, between two directions. */
export function rightAngle(corner: Point, along: Point, across: Point, size: number): string {
  const [u, v] = [unit(along), unit(across)];
  const [a, b] = [plus(corner, u, size), plus(corner, v, size)];
  return polyline([a, plus(a, v, size), b], 'thin');
}

/** The arc of an angle at a corner, from one point to another. */
export function arc(corner: Point, from: Point, to: Point, radius: number, className: string): string {
  const [u, v] = [unit(minus(from, corner)), unit(minus(to, corner))];
  const [[x0, y0], [x1, y1]] = [plus(corner, u, radius), plus(corner, v, radius)];
  const turn = u[0] * v[1] - u[1] * v[0] > 0 ? 1 : 0;
  const place = (value: number) => value.toFixed(2);
  const d = `M${place(x0)} ${place(y0)}A${radius} ${radius} 0 0 ${turn} ${place(x1)} ${place(y1)}`;
  return tag('path', { class: className, d });
}

/** The direction that halves the angle at a corner. */
export function bisector(corner: Point, from: Point, to: Point): Point {
  const sum = plus(unit(minus(from, corner)), unit(minus(to, corner)));
  return length(sum) < 1e-9 || dot(sum, sum) === 0 ? [0, -1] : unit(sum);
}
