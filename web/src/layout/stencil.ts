import { facesAround } from '../faces-around.js';
import type { Geometry } from '../polylap.js';

const size = 132;
const margin = 12;
const widest = 6;

type Vector = [number, number, number];

/** The row of a vertex as spokes in its tangent plane: as thick as |w|, dashed where w < 0, over the faces around it. */
export function stencil(
  geometry: Geometry,
  points: Float32Array,
  vertex: number,
  weights: ReadonlyMap<number, number>,
  largest: number,
): SVGSVGElement {
  const at = (i: number): Vector => [points[3 * i] ?? 0, points[3 * i + 1] ?? 0, points[3 * i + 2] ?? 0];
  const middle = at(vertex);
  const { offsets, corners } = geometry;
  const faces = [...facesAround(geometry, vertex)].map((f) => [...corners.subarray(offsets[f], offsets[f + 1])]);
  const normal = faces
    .map((face) => vectorArea(face.map((i) => minus(at(i), middle))))
    .reduce((sum, area) => [sum[0] + area[0], sum[1] + area[1], sum[2] + area[2]], [0, 0, 0] as Vector);
  // What points up on the mesh points up here, unless one looks straight down.
  const n = unit(normal);
  const upright: Vector = Math.abs(n[2]) < 0.95 ? [0, 0, 1] : [0, 1, 0];
  const right = unit(cross(upright, n));
  const up = cross(n, right);
  const flat = (i: number) => {
    const d = minus(at(i), middle);
    return [dot(d, right), -dot(d, up)] as const;
  };
  const shown = new Set([...faces.flat(), ...weights.keys()]);
  const reach = (axis: 0 | 1) => Math.max(0, ...[...shown].map((i) => Math.abs(flat(i)[axis])));
  const extent = Math.max(reach(0), reach(1));
  const scale = extent > 0 ? (size / 2 - margin) / extent : 0;
  const height = 2 * (margin + scale * reach(1));
  const place = (i: number) =>
    flat(i)
      .map((c, axis) => ((axis === 0 ? size : height) / 2 + scale * c).toFixed(1))
      .join(',');

  const svg = make('svg', {
    viewBox: `0 0 ${size} ${height}`,
    class: 'stencil',
    'aria-hidden': 'true',
  }) as SVGSVGElement;
  for (const face of faces) svg.append(make('polygon', { points: face.map(place).join(' ') }));
  // Thick ones first, so that they hide no thin ones.
  const spokes = [...weights].filter(([, w]) => w !== 0).sort((p, q) => Math.abs(q[1]) - Math.abs(p[1]));
  for (const [i, w] of spokes) {
    const width = Math.max(0.75, (widest * Math.abs(w)) / largest).toFixed(2);
    const points2 = `${place(vertex)} ${place(i)}`;
    svg.append(make('polyline', { points: points2, 'stroke-width': width, class: w < 0 ? 'spoke minus' : 'spoke' }));
  }
  for (const i of shown) {
    const [cx, cy] = place(i).split(',');
    svg.append(make('circle', { cx, cy, r: i === vertex ? 4 : 2, class: i === vertex ? 'hub' : '' }));
  }
  return svg;
}

function make(tag: string, attributes: Record<string, string | number | undefined>): SVGElement {
  const element = document.createElementNS('http://www.w3.org/2000/svg', tag);
  for (const [name, value] of Object.entries(attributes)) element.setAttribute(name, String(value));
  return element;
}

function vectorArea(polygon: Vector[]): Vector {
  return polygon.reduce(
    (sum, p, k) => {
      const q = polygon[(k + 1) % polygon.length] ?? p;
      const c = cross(p, q);
      return [sum[0] + c[0] / 2, sum[1] + c[1] / 2, sum[2] + c[2] / 2];
    },
    [0, 0, 0] as Vector,
  );
}

const minus = (p: Vector, q: Vector): Vector => [p[0] - q[0], p[1] - q[1], p[2] - q[2]];
const dot = (p: Vector, q: Vector) => p[0] * q[0] + p[1] * q[1] + p[2] * q[2];
const cross = (p: Vector, q: Vector): Vector => [
  p[1] * q[2] - p[2] * q[1],
  p[2] * q[0] - p[0] * q[2],
  p[0] * q[1] - p[1] * q[0],
];
const unit = (p: Vector): Vector => {
  const length = Math.hypot(...p) || 1;
  return [p[0] / length, p[1] / length, p[2] / length];
};
