import { type Matrix4, Vector3 } from 'three';
import type { Geometry } from '../polylap.js';
import { firstHit } from './ray.js';

/** How far from a vertex beside the mesh, in pixels, a click still means it; of a finger, what it covers. */
const reach = { fine: 12, touch: 22 };
/** So near to a corner, in pixels, it is meant and not the face: small faces have nothing but corners. */
const atCorner = { fine: 8, touch: 14 };

/** A point of a view. */
export interface Aim {
  /** In CSS pixels, from the upper left corner. */
  x: number;
  y: number;
  width: number;
  height: number;
  /** Of a finger. */
  touch: boolean;
  /** From the model to clip space. */
  clip: Matrix4;
}

export interface Meant {
  /** The nearest corner of the face seen there; beside the surface, the nearest vertex within reach. */
  vertex: number | null;
  /** The face, where the point is nearer to its middle than to any corner. */
  face: number | null;
}

/** What a point of a view means. */
export function meant(aim: Aim, geometry: Geometry, points: Float32Array): Meant {
  const { x, y, width, height, clip } = aim;
  const kind = aim.touch ? 'touch' : 'fine';
  const inverse = clip.clone().invert();
  const at = (depth: number) => new Vector3((2 * x) / width - 1, 1 - (2 * y) / height, depth).applyMatrix4(inverse);
  const eye = at(-1);
  const hit = firstHit(eye, at(1).sub(eye), points, geometry.triangles);
  const distance = distanceIn(aim);
  const vertexAway = (v: number) =>
    distance(points[3 * v] as number, points[3 * v + 1] as number, points[3 * v + 2] as number);
  if (!hit) return { vertex: nearest(points.length / 3, (v) => v, vertexAway, reach[kind]), face: null };

  const face = geometry.triangleFaces[hit.triangle] as number;
  const corners = geometry.corners.subarray(geometry.offsets[face], geometry.offsets[face + 1]);
  const vertex = nearest(corners.length, (k) => corners[k] as number, vertexAway, Infinity);
  const away = vertex === null ? 0 : vertexAway(vertex);
  const middle = [0, 1, 2].map((c) => corners.reduce((sum, v) => sum + (points[3 * v + c] as number), 0));
  const [mx = 0, my = 0, mz = 0] = middle.map((sum) => sum / corners.length);
  return { vertex, face: away > atCorner[kind] && distance(mx, my, mz) < away ? face : null };
}

/**
 * Of some points by a surface, the nearest within reach that the surface does not hide.
 * @param slack how deep under the surface a point may lie, a length
 */
export function meantPoint(
  aim: Aim,
  loose: Float32Array,
  points: Float32Array,
  triangles: Int32Array,
  slack: number,
): number | null {
  const distance = distanceIn(aim);
  const coordinate = (k: number, c: number) => loose[3 * k + c] as number;
  const away = (k: number) => distance(coordinate(k, 0), coordinate(k, 1), coordinate(k, 2));
  const within: { k: number; away: number }[] = [];
  for (let k = 0; k < loose.length / 3; k++) {
    const pixels = away(k);
    if (pixels < reach[aim.touch ? 'touch' : 'fine']) within.push({ k, away: pixels });
  }
  within.sort((one, other) => one.away - other.away);
  const inverse = aim.clip.clone().invert();
  // In a crowd the first few decide: each costs a ray.
  for (const { k } of within.slice(0, 6)) {
    const point = new Vector3(coordinate(k, 0), coordinate(k, 1), coordinate(k, 2));
    const eye = point.clone().applyMatrix4(aim.clip).setZ(-1).applyMatrix4(inverse);
    const direction = point.sub(eye);
    const hit = firstHit(eye, direction, points, triangles);
    if (!hit || hit.along > 1 - slack / direction.length()) return k;
  }
  return null;
}

/** From a point of the model to the one aimed at, in pixels; no vectors on the way, for there may be a million. */
function distanceIn({ x, y, width, height, clip }: Aim): (px: number, py: number, pz: number) => number {
  const e = clip.elements;
  const row = (r: number) => [e[r], e[r + 4], e[r + 8], e[r + 12]] as [number, number, number, number];
  const [x0, x1, x2, x3] = row(0);
  const [y0, y1, y2, y3] = row(1);
  const [w0, w1, w2, w3] = row(3);
  return (px, py, pz) => {
    const w = w0 * px + w1 * py + w2 * pz + w3;
    const dx = (0.5 + (0.5 * (x0 * px + x1 * py + x2 * pz + x3)) / w) * width - x;
    const dy = (0.5 - (0.5 * (y0 * px + y1 * py + y2 * pz + y3)) / w) * height - y;
    return Math.sqrt(dx * dx + dy * dy);
  };
}

function nearest(
  count: number,
  vertexAt: (k: number) => number,
  away: (vertex: number) => number,
  within: number,
): number | null {
  let best: number | null = null;
  let least = within;
  for (let k = 0; k < count; k++) {
    const vertex = vertexAt(k);
    const distance = away(vertex);
    if (distance >= least) continue;
    least = distance;
    best = vertex;
  }
  return best;
}
