/**
 * Polygons and arrows in space as SVG: seen from afar (orthographic), far ones first, in flat tones. Colours are the classes of figure.css, so that
 * a drawing is right on light and on dark paper, and on paper.
 */
import type { Point } from './figure.js';
import { arrow, tag } from './svg.js';

export type Vec = readonly [number, number, number];

export const sum = ([a, b, c]: Vec, [x, y, z]: Vec): Vec => [a + x, b + y, c + z];
export const times = (s: number, [x, y, z]: Vec): Vec => [s * x, s * y, s * z];
export const minus = (p: Vec, q: Vec): Vec => sum(p, times(-1, q));
export const dot = ([a, b, c]: Vec, [x, y, z]: Vec) => a * x + b * y + c * z;
export const cross = ([a, b, c]: Vec, [x, y, z]: Vec): Vec => [b * z - c * y, c * x - a * z, a * y - b * x];
export const length = (v: Vec) => Math.hypot(...v);
export const unit = (v: Vec): Vec => times(1 / (length(v) || 1), v);
export const mean = (points: readonly Vec[]): Vec => times(1 / points.length, points.reduce(sum, [0, 0, 0]));

/** ½ Σ xᵢ × xᵢ₊₁: for the light, whatever the polygon. */
const normalOf = (points: readonly Vec[]): Vec => {
  const [first = [0, 0, 0]] = points;
  const arms = points.map((p) => minus(p, first));
  return unit(arms.map((arm, k) => cross(arm, arms[(k + 1) % arms.length] as Vec)).reduce(sum, [0, 0, 0]));
};

/** A ball of space, and the rectangle that shows all of it from wherever it is seen: nothing jumps while the view turns. */
export interface Frame {
  readonly centre: Vec;
  readonly radius: number;
  readonly width: number;
  readonly height: number;
}

export interface Eye {
  readonly right: Vec;
  readonly up: Vec;
  readonly toEye: Vec;
  /** To coordinates of the drawing. */
  readonly place: (p: Vec) => Point;
}

/** @param view azimuth and elevation in degrees: (0, 0) looks along y, with x to the right and z up */
export function eyeAt(view: Point, { centre, radius, width, height }: Frame): Eye {
  const [azimuth, elevation] = view.map((angle) => (angle * Math.PI) / 180) as [number, number];
  const [s, c] = [Math.sin(azimuth), Math.cos(azimuth)];
  const right: Vec = [c, s, 0];
  const toEye: Vec = [s * Math.cos(elevation), -c * Math.cos(elevation), Math.sin(elevation)];
  const up = cross(toEye, right);
  const scale = Math.min(width, height) / (2 * radius);
  const place = (p: Vec): Point => {
    const from = minus(p, centre);
    return [width / 2 + scale * dot(from, right), height / 2 - scale * dot(from, up)];
  };
  return { right, up, toEye, place };
}

/** Part of a plane. */
export interface Face {
  readonly kind: 'face';
  readonly points: readonly Vec[];
  /** Instead of a tone by the light. */
  readonly look?: string;
  /** Drawn right after it, and hidden with it. */
  readonly edges?: readonly Line[];
}

export interface Line {
  readonly kind: 'line';
  readonly points: readonly [Vec, Vec];
  readonly look: string;
  /** It ends in an arrow's head. */
  readonly arrow?: boolean;
}

export type Piece = Face | Line;

/** Classes `tone-0`, the darkest, to `tone-7`. */
const tones = 8;
/** How far an arrow's head reaches back, in the drawing. */
const headSize = 12;

const depth = (eye: Eye, points: readonly Vec[]) => dot(mean(points), eye.toEye);

/** Small pieces of one size, by their distance. */
export const byDistance = (pieces: readonly Piece[], eye: Eye): Piece[] =>
  pieces
    .map((piece) => ({ piece, at: depth(eye, piece.points) }))
    .sort((one, other) => one.at - other.at)
    .map(({ piece }) => piece);

/** What lies nearer to a face's plane is on it. Scenes have the size of 1. */
const onPlane = 1e-9;

/**
 * A few pieces of any size, which may pass through each other: each face's plane cuts the others (Fuchs, Kedem & Naylor 1980), so that what is hidden
 * is hidden exactly.
 */
export function byPlanes(pieces: readonly Piece[], eye: Eye): Piece[] {
  const root = pieces.find((piece): piece is Face => piece.kind === 'face');
  if (!root) return byDistance(pieces, eye);
  const [normal, origin] = [normalOf(root.points), root.points[0] as Vec];
  const height = (p: Vec) => dot(minus(p, origin), normal);
  const [above, on, below]: [Piece[], Piece[], Piece[]] = [[], [root], []];
  for (const piece of pieces) {
    if (piece === root) continue;
    const heights = piece.points.map(height);
    if (heights.every((h) => Math.abs(h) <= onPlane)) on.push(piece);
    else if (heights.every((h) => h >= -onPlane)) above.push(piece);
    else if (heights.every((h) => h <= onPlane)) below.push(piece);
    else {
      const [high, low] = piece.kind === 'face' ? cutFace(piece, heights) : cutLine(piece, heights);
      above.push(high);
      below.push(low);
    }
  }
  const isSeenFromAbove = dot(normal, eye.toEye) > 0;
  const [far, near] = isSeenFromAbove ? [below, above] : [above, below];
  return [...byPlanes(far, eye), ...on, ...byPlanes(near, eye)];
}

const between = (p: Vec, q: Vec, share: number) => sum(times(1 - share, p), times(share, q));

function cutFace(face: Face, heights: readonly number[]): [Face, Face] {
  const [high, low]: [Vec[], Vec[]] = [[], []];
  for (const [k, p] of face.points.entries()) {
    const next = (k + 1) % heights.length;
    const [h, hNext] = [heights[k] as number, heights[next] as number];
    if (h >= -onPlane) high.push(p);
    if (h <= onPlane) low.push(p);
    if (Math.min(h, hNext) < -onPlane && Math.max(h, hNext) > onPlane) {
      const meeting = between(p, face.points[next] as Vec, h / (h - hNext));
      high.push(meeting);
      low.push(meeting);
    }
  }
  return [
    { ...face, points: high },
    { ...face, points: low },
  ];
}

function cutLine(line: Line, heights: readonly number[]): [Line, Line] {
  const [[from, to], [start, end]] = [line.points, heights as [number, number]];
  const meeting = between(from, to, start / (start - end));
  const first: Line = { ...line, points: [from, meeting], arrow: false };
  const last: Line = { ...line, points: [meeting, to] };
  return start > end ? [first, last] : [last, first];
}

/** The markup of pieces in their order. */
export const markup = (pieces: readonly Piece[], eye: Eye): string =>
  pieces.map((piece) => (piece.kind === 'face' ? faceMarkup(piece, eye) : lineMarkup(piece, eye))).join('');

/** One decimal: there are many. */
const short = (value: number) => String(Math.round(10 * value) / 10 + 0);
const outline = (points: readonly Point[]) => points.map((p) => p.map(short).join(' ')).join('L');

function faceMarkup({ points, look, edges = [] }: Face, eye: Eye): string {
  const path = `M${outline(points.map(eye.place))}z`;
  return (
    tag('path', { class: look ?? toneOf(points, eye), d: path }) + edges.map((edge) => lineMarkup(edge, eye)).join('')
  );
}

/** By a lamp above the left shoulder; both sides of a surface are lit. */
function toneOf(points: readonly Vec[], { right, up, toEye }: Eye): string {
  const normal = normalOf(points);
  const towards = dot(normal, toEye) < 0 ? times(-1, normal) : normal;
  const lamp = unit(sum(toEye, sum(times(0.7, up), times(-0.6, right))));
  const lit = Math.max(0, dot(towards, lamp));
  return `tone tone-${Math.min(tones - 1, Math.floor(tones * lit))}`;
}

function lineMarkup({ points: [from, to], look, arrow: hasHead }: Line, eye: Eye): string {
  const [start, tip] = [eye.place(from), eye.place(to)];
  if (!hasHead) return tag('path', { class: look, d: `M${outline([start, tip])}` });
  // One that comes towards the eye has a short head.
  const size = Math.min(headSize, 0.6 * Math.hypot(tip[0] - start[0], tip[1] - start[1]));
  return arrow(start, tip, look, { size });
}
