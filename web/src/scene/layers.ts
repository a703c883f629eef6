/** What is drawn over a surface besides its marks. */
import { facesAround } from '../faces-around.js';
import type { Dual, Geometry, Weights } from '../polylap.js';
import type { VertexWeights } from '../state.js';
import { Dots } from './dots.js';
import { Lines, type Segments } from './lines.js';

export type Layer = Lines | Dots;
export type LayerName =
  | 'negative'
  | 'dualEdges'
  | 'dualVertices'
  | 'edgePoints'
  | 'edgeRead'
  | 'weights'
  | 'place'
  | 'spokes'
  | 'minusSpokes'
  | 'minuses'
  | 'face';

/** Dashed, so that they are never told by colour alone. */
export const negativeLines = (weights: Weights): Lines =>
  new Lines(weights, { ink: 'negative', dashed: true, width: 1.5, lift: 0 });

/** @param edge mean edge length: dual points lie that close to the surface where faces are not planar */
export function dualLayers(dual: Dual, edge: number): Partial<Record<LayerName, Layer>> {
  const lift = 0.3 * edge;
  const spacing = edge;
  return {
    dualEdges: new Lines(dualSegments(dual), { ink: 'accent', dashed: false, width: 1.75, lift }),
    dualVertices: new Dots(dual.positions, { ink: 'accent', shape: 'full', size: 7, lift, spacing }),
    edgePoints: new Dots(insidePoints(dual), { ink: 'accent', shape: 'hollow', size: 6, lift, spacing }),
  };
}

/** From each dual vertex to the edge point, and on to the other one; at the boundary there is no other one. */
function dualSegments({ positions, edgeFaces, edgePoints }: Dual): Segments {
  const ends: number[] = [];
  for (let e = 0; e < edgePoints.length / 3; e++) {
    for (const face of edgeFaces.subarray(2 * e, 2 * e + 2)) {
      if (face < 0) continue;
      ends.push(...positions.subarray(3 * face, 3 * face + 3), ...edgePoints.subarray(3 * e, 3 * e + 3));
    }
  }
  return { segments: Float32Array.from(ends), segmentStarts: new Float32Array(ends.length / 6) };
}

/** Of edges between two faces or at the boundary, not of those that no face has. */
function insidePoints({ edgeFaces, edgePoints }: Dual): Float32Array {
  const kept: number[] = [];
  for (let e = 0; e < edgePoints.length / 3; e++) {
    const point = edgePoints.subarray(3 * e, 3 * e + 3);
    if (point.every(Number.isFinite) && ((edgeFaces[2 * e] ?? -1) >= 0 || (edgeFaces[2 * e + 1] ?? -1) >= 0))
      kept.push(...point);
  }
  return Float32Array.from(kept);
}

/** The point that is read; none where the dual edge does not cross. */
export function edgePoint({ edgePoints }: Dual, edge: number, length: number): Dots | null {
  const point = edgePoints.slice(3 * edge, 3 * edge + 3);
  if (point.length < 3 || !point.every(Number.isFinite)) return null;
  return new Dots(point, { ink: 'accent', shape: 'hollow', size: 15, lift: 0.4 * length, spacing: Infinity });
}

const circleSides = 48;

/** A circle of radius √|ω| around each weighted vertex, in its tangent plane; dashed where ω < 0. */
export function weightCircles(
  points: Float32Array,
  weights: VertexWeights,
  normalOf: (vertex: number) => readonly [number, number, number],
  lift: number,
): Lines | null {
  const ends: number[] = [];
  const starts: number[] = [];
  for (const [key, weight] of Object.entries(weights)) {
    const vertex = Number(key);
    const radius = Math.sqrt(Math.abs(weight));
    const [u, v] = frame(normalOf(vertex));
    const at = (k: number) => {
      const angle = (2 * Math.PI * k) / circleSides;
      return [0, 1, 2].map(
        (c) => (points[3 * vertex + c] ?? 0) + radius * (Math.cos(angle) * (u[c] ?? 0) + Math.sin(angle) * (v[c] ?? 0)),
      );
    };
    for (let k = 0; k < circleSides; k++) {
      // Every other pair of sides: as many dashes whatever the radius.
      if (weight < 0 && k % 4 >= 2) continue;
      ends.push(...at(k), ...at(k + 1));
      starts.push(0);
    }
  }
  if (starts.length === 0) return null;
  const lines = { segments: Float32Array.from(ends), segmentStarts: Float32Array.from(starts) };
  return new Lines(lines, { ink: 'accent', dashed: false, width: 2, lift, opaque: true });
}

/** A line from vertex to vertex. */
export function chain(points: Float32Array, vertices: readonly number[], lift: number): Lines | null {
  const ends = vertices.slice(1).flatMap((vertex, k) => {
    const before = vertices[k] ?? vertex;
    return [...points.subarray(3 * before, 3 * before + 3), ...points.subarray(3 * vertex, 3 * vertex + 3)];
  });
  if (ends.length === 0) return null;
  return new Lines(
    { segments: Float32Array.from(ends), segmentStarts: new Float32Array(ends.length / 6) },
    { ink: 'accent', dashed: false, width: 2.5, lift },
  );
}

type Vector = [number, number, number];

/** Two unit vectors that span the plane of a normal. */
function frame([x, y, z]: readonly [number, number, number]): [Vector, Vector] {
  const off: Vector = Math.abs(x) < 0.6 ? [1, 0, 0] : [0, 1, 0];
  const u = unit([y * off[2] - z * off[1], z * off[0] - x * off[2], x * off[1] - y * off[0]]);
  return [u, [y * u[2] - z * u[1], z * u[0] - x * u[2], x * u[1] - y * u[0]]];
}

const unit = ([x, y, z]: Vector): Vector => {
  const length = Math.hypot(x, y, z) || 1;
  return [x / length, y / length, z / length];
};

/** The mean of the unit normals of the faces around a vertex. */
export function vertexNormal(geometry: Geometry, normals: Float32Array, vertex: number): Vector {
  const sum: Vector = [0, 0, 0];
  for (const f of facesAround(geometry, vertex)) for (const c of [0, 1, 2] as const) sum[c] += normals[3 * f + c] ?? 0;
  return unit(sum);
}
