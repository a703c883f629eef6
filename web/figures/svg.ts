/** Drawings as text: the same when the site is built and in the page. All that is drawn is in units of the picture, a CSS pixel where it has its full size. */
import { minus } from '../src/format.js';
import type { Handle, Point } from './figure.js';

type Value = string | number | boolean | null | undefined;
export type Attributes = Readonly<Record<string, Value>>;

export const escapeText = (text: string): string =>
  text.replaceAll('&', '&amp;').replaceAll('<', '&lt;').replaceAll('>', '&gt;').replaceAll('"', '&quot;');

/** Two decimals are less than what one sees. */
const short = (value: number): string => String(Number(value.toFixed(2)) || 0);

/** An element. Children are markup: what comes from elsewhere has to be escaped. */
export function tag(name: string, attributes: Attributes, ...children: string[]): string {
  const given = Object.entries(attributes)
    .filter(([, value]) => value !== undefined && value !== null && value !== false)
    .map(([key, value]) => {
      const text = typeof value === 'number' ? short(value) : value === true ? '' : escapeText(String(value));
      return ` ${key}="${text}"`;
    });
  const start = `<${name}${given.join('')}`;
  return children.length === 0 ? `${start}/>` : `${start}>${children.join('')}</${name}>`;
}

/** A picture of so many pixels; on narrow screens it shrinks. Those of a figure stand side by side where there is room. */
export const svg = (width: number, height: number, ...children: string[]): string =>
  tag('svg', { xmlns: 'http://www.w3.org/2000/svg', viewBox: `0 0 ${short(width)} ${short(height)}` }, ...children);

export const group = (className: string, ...children: string[]): string =>
  tag('g', { class: className || undefined }, ...children);

/** A rectangle of the model, y up, in a picture. */
export interface Plane {
  readonly width: number;
  readonly height: number;
  /** Pixels per unit of the model. */
  readonly scale: number;
  at(point: Point): Point;
  /** Belongs into each picture with handles: pointers find the model's coordinates by its matrix. */
  readonly element: string;
}

interface Window {
  /** What the plane shows. */
  x: Point;
  y: Point;
  width: number;
  /** Otherwise as high as needed. */
  height?: number;
  /** Pixels around: one number, or top, right, bottom, left. */
  margin?: number | readonly [number, number, number, number];
}

/** As large as fits, in the middle. */
export function plane({ x, y, width, height: given, margin = 24 }: Window): Plane {
  const [top, right, bottom, left] = typeof margin === 'number' ? [margin, margin, margin, margin] : margin;
  const [wide, high] = [x[1] - x[0], y[1] - y[0]];
  const across = (width - left - right) / wide;
  const scale = given === undefined ? across : Math.min(across, (given - top - bottom) / high);
  const height = given ?? scale * high + top + bottom;
  const originX = left + (width - left - right) / 2 - (scale * (x[0] + x[1])) / 2;
  const originY = top + (height - top - bottom) / 2 + (scale * (y[0] + y[1])) / 2;
  const matrix = [scale, 0, 0, -scale, originX, originY].map((entry) => Number(entry.toFixed(4)));
  return {
    width,
    height,
    scale,
    at: ([px, py]) => [originX + scale * px, originY - scale * py],
    element: `<g data-plane="" transform="matrix(${matrix.join(' ')})"></g>`,
  };
}

const pair = ([x, y]: Point): string => `${short(x)},${short(y)}`;

export const polygon = (points: readonly Point[], className: string): string =>
  tag('polygon', { class: className, points: points.map(pair).join(' ') });

export const polyline = (points: readonly Point[], className: string): string =>
  tag('polyline', { class: className, points: points.map(pair).join(' ') });

export const line = ([x1, y1]: Point, [x2, y2]: Point, className: string, width?: number): string =>
  tag('line', { class: className, x1, y1, x2, y2, 'stroke-width': width });

export const circle = ([cx, cy]: Point, r: number, className: string): string =>
  tag('circle', { class: className, cx, cy, r });

export const rectangle = ([x, y]: Point, width: number, height: number, className: string): string =>
  tag('rect', { class: className, x, y, width, height });

/** A line with a head at its end, or `double`: at both. */
export function arrow(from: Point, to: Point, className: string, { size = 9, double = false } = {}): string {
  const length = Math.hypot(to[0] - from[0], to[1] - from[1]);
  if (length === 0) return '';
  const [dx, dy] = [(to[0] - from[0]) / length, (to[1] - from[1]) / length];
  // Short ones are all head.
  const head = Math.min(size, length / (double ? 2 : 1));
  const back = ([x, y]: Point, by: number): Point => [x - by * dx, y - by * dy];
  const headAt = (tip: Point, by: number): string => {
    const [bx, by2] = back(tip, by);
    const w = 0.4 * by;
    return polygon([tip, [bx - w * dy, by2 + w * dx], [bx + w * dy, by2 - w * dx]], 'head');
  };
  const shaft = line(double ? back(from, -0.8 * head) : from, back(to, 0.8 * head), 'shaft');
  return group(`arrow ${className}`, shaft, headAt(to, head), double ? headAt(from, -head) : '');
}

export type Anchor = 'start' | 'middle' | 'end';

/** Plain text; `markup` instead where it has indices. The middle of its letters is at the point. */
export function text(at: Point, words: string, className = '', anchor: Anchor = 'middle'): string {
  return markup(at, escapeText(words), className, anchor);
}

export const markup = ([x, y]: Point, inner: string, className = '', anchor: Anchor = 'middle'): string =>
  tag('text', { class: className || undefined, x, y, 'text-anchor': anchor, dy: '.35em' }, inner);

/** A variable with an index: w₁₂. What comes after it, too, as plain text. */
export const indexed = (name: string, index: string, rest = ''): string =>
  `<tspan class="variable">${escapeText(name)}</tspan><tspan class="index" dy=".3em">${escapeText(index)}</tspan><tspan dy="-.21em">${escapeText(rest) || '\u200b'}</tspan>`;

/** With a fixed number of decimals, so that nothing jumps, and a true minus sign. */
export function fixed(value: number, decimals = 3): string {
  const written = value.toFixed(decimals);
  return minus(Number(written) === 0 ? written.replace('-', '') : written);
}

/** A handle as one sees, drags and hears it. @param label what it is called; `said` its place in words */
export function handle(control: Handle, value: Point, plane: Plane, label: string, said?: string): string {
  const [x, y] = plane.at(value);
  const place = said ?? `${fixed(value[0], 2)}, ${fixed(value[1], 2)}`;
  return tag(
    'g',
    {
      class: 'handle',
      'data-handle': control.id,
      tabindex: '0',
      role: 'slider',
      'aria-label': label,
      'aria-valuemin': control.min[0],
      'aria-valuemax': control.max[0],
      'aria-valuenow': value[0],
      'aria-valuetext': place,
      transform: `translate(${short(x)} ${short(y)})`,
    },
    circle([0, 0], 24, 'target'),
    circle([0, 0], 12, 'ring'),
    circle([0, 0], 7, 'grip'),
  );
}

/** How wide text is, roughly: fonts differ, and when the site is built there is none. */
const letter = 0.6;

export interface Label {
  at: Point;
  /** Its text is as long as it will be drawn. */
  words: string;
  className?: string;
  /** As markup, where it is not plain; `words` then only tells how long it is. */
  inner?: string;
  /** The direction that it would best be moved in. */
  towards?: Point;
  /** Font size; 13 unless told. */
  size?: number;
  /** How far from its point, in pixels. */
  distance?: number;
}

interface Box {
  left: number;
  right: number;
  top: number;
  bottom: number;
}

const overlap = (p: Box, q: Box): number =>
  Math.max(0, Math.min(p.right, q.right) - Math.max(p.left, q.left)) *
  Math.max(0, Math.min(p.bottom, q.bottom) - Math.max(p.top, q.top));

/**
 * Labels beside their points, where they cover neither each other nor what must be seen: the first ones choose first.
 * @param keepClear points with the radius around them that is taken
 */
export function labels(
  given: readonly Label[],
  keepClear: readonly (readonly [number, number, number])[] = [],
  frame?: { width: number; height: number },
): string {
  const taken: Box[] = keepClear.map(([x, y, r]) => ({ left: x - r, right: x + r, top: y - r, bottom: y + r }));
  const outside = (box: Box): number =>
    frame
      ? Math.max(0, -box.left) +
        Math.max(0, box.right - frame.width) +
        Math.max(0, -box.top) +
        Math.max(0, box.bottom - frame.height)
      : 0;
  const drawn = given.map(({ at: [x, y], words, className, inner, towards = [0, -1], size = 13, distance = 14 }) => {
    const [w, h] = [letter * size * words.length, 1.2 * size];
    const best = Math.atan2(towards[1], towards[0]);
    let chosen: { box: Box; cost: number } | undefined;
    for (let k = 0; k < 24; k++) {
      // From the best direction to both sides, near and then farther away.
      const turn = (((k % 12) + 1) >> 1) * (k % 2 ? 1 : -1);
      const angle = best + (turn * Math.PI) / 6;
      const away = distance * (k < 12 ? 1 : 1.8);
      const [dx, dy] = [Math.cos(angle), Math.sin(angle)];
      const [cx, cy] = [x + dx * (away + w / 2), y + dy * (away + h / 2)];
      const box = { left: cx - w / 2, right: cx + w / 2, top: cy - h / 2, bottom: cy + h / 2 };
      const covered = taken.reduce((sum, other) => sum + overlap(box, other), 0);
      const cost = covered + 100 * outside(box) + 0.5 * k;
      if (!chosen || cost < chosen.cost) chosen = { box, cost };
    }
    const { box } = chosen as { box: Box };
    taken.push(box);
    const middle: Point = [(box.left + box.right) / 2, (box.top + box.bottom) / 2];
    return markup(middle, inner ?? escapeText(words), className);
  });
  return drawn.join('');
}

/** The class of a value on the ramp from −1 (red) over 0 (pale) to 1 (blue). */
export function ramp(value: number): string {
  const step = Math.round(5 * Math.max(-1, Math.min(1, value)));
  return `ramp-${step < 0 ? 'm' : 'p'}${Math.abs(step)}`;
}
