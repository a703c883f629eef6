import type { Geometry, Mesh } from './polylap.js';

/** Turns by less than this, in radians, are bends rather than corners. */
const cornerAngle = (40 * Math.PI) / 180;

export interface Loop {
  /** In order along the edges. */
  vertices: readonly number[];
  /** Which of them are corners: indices into `vertices`. */
  corners: readonly number[];
}

/** The closed curves that the edges of one face only make up, the longest first. */
export function boundaryLoops({ boundary, geometry }: Pick<Mesh, 'boundary' | 'geometry'>): Loop[] {
  const next = openEdges(boundary, geometry);
  const loops: Loop[] = [];
  for (const start of boundary) {
    for (;;) {
      const vertices: number[] = [];
      let at: number | undefined = start;
      while (at !== undefined) {
        const to: number | undefined = next.get(at)?.pop();
        if (to === undefined) break;
        vertices.push(at);
        // Taken from both ends, as faces may disagree on the direction.
        const back = next.get(to);
        if (back) back.splice(back.indexOf(at), 1);
        at = to === start ? undefined : to;
      }
      if (vertices.length === 0) break;
      loops.push({ vertices, corners: cornersOf(vertices, geometry.positions) });
    }
  }
  const lengths = new Map(loops.map((loop) => [loop, lengthOf(loop.vertices, geometry.positions)]));
  return loops.sort((one, other) => (lengths.get(other) ?? 0) - (lengths.get(one) ?? 0));
}

/** Edges of one face only: from each vertex, in both directions; last the one that its face goes along. */
function openEdges(boundary: Int32Array, { offsets, corners, positions }: Geometry): Map<number, number[]> {
  const open = new Uint8Array(positions.length / 3);
  for (const vertex of boundary) open[vertex] = 1;
  const faces = new Map<string, { from: number; to: number; count: number }>();
  for (let f = 0; f + 1 < offsets.length; f++) {
    const [first = 0, last = 0] = offsets.subarray(f, f + 2);
    for (let c = first; c < last; c++) {
      const from = corners[c] as number;
      const to = corners[c + 1 < last ? c + 1 : first] as number;
      if (!open[from] || !open[to]) continue;
      const key = from < to ? `${from} ${to}` : `${to} ${from}`;
      const edge = faces.get(key);
      if (edge) edge.count++;
      else faces.set(key, { from, to, count: 1 });
    }
  }
  const next = new Map<number, number[]>();
  const listOf = (vertex: number) => {
    const list = next.get(vertex) ?? [];
    next.set(vertex, list);
    return list;
  };
  for (const { from, to, count } of faces.values()) {
    if (count !== 1) continue;
    listOf(from).push(to);
    listOf(to).unshift(from);
  }
  return next;
}

function cornersOf(vertices: readonly number[], positions: Float32Array): number[] {
  const at = (k: number) => vertices[(k + vertices.length) % vertices.length] as number;
  return vertices.flatMap((vertex, k) => {
    const before = direction(positions, at(k - 1), vertex);
    const after = direction(positions, vertex, at(k + 1));
    const cosine = before.reduce((sum, c, i) => sum + c * (after[i] ?? 0), 0);
    return cosine < Math.cos(cornerAngle) ? [k] : [];
  });
}

function direction(positions: Float32Array, from: number, to: number): number[] {
  const along = [0, 1, 2].map((c) => (positions[3 * to + c] ?? 0) - (positions[3 * from + c] ?? 0));
  const length = Math.hypot(...along) || 1;
  return along.map((c) => c / length);
}

function lengthOf(vertices: readonly number[], positions: Float32Array): number {
  return stations(vertices, positions).at(-1) ?? 0;
}

/** How far along a closed curve each of its vertices is; one more for its whole length. */
function stations(vertices: readonly number[], positions: Float32Array): number[] {
  const reached = [0];
  vertices.forEach((from, k) => {
    const to = vertices[(k + 1) % vertices.length] as number;
    const step = [0, 1, 2].map((c) => (positions[3 * to + c] ?? 0) - (positions[3 * from + c] ?? 0));
    reached.push((reached[k] ?? 0) + Math.hypot(...step));
  });
  return reached;
}

/** Along a loop from one of its vertices to the next corner, both included; without corners a quarter of its length. */
export function sideFrom({ vertices, corners }: Loop, first: number, positions: Float32Array): number[] {
  const begin = vertices.indexOf(first);
  const turned = [...vertices.slice(begin), ...vertices.slice(0, begin)];
  const isCorner = new Set(corners.map((k) => vertices[k]));
  const reached = stations(turned, positions);
  const quarter = (reached.at(-1) ?? 0) / 4;
  const last =
    isCorner.size >= 2
      ? turned.findIndex((vertex, k) => k > 0 && isCorner.has(vertex))
      : // A quarter but for rounding.
        reached.findLastIndex((way) => way <= quarter * (1 + 1e-6));
  return turned.slice(0, (last < 0 ? turned.length : last) + 1);
}
