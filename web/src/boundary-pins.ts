import { type Loop, sideFrom } from './boundary-loops.js';
import type { Mesh } from './polylap.js';
import type { Pin } from './state.js';
import { word } from './words.js';

type Point = readonly [number, number, number];

/** Ways to pin the boundary. Coordinates count from the middle of the bounding box, in half its largest extent: within [-1, 1]. */
export const boundaryPresets: readonly {
  id: string;
  label: string;
  /** @param chosen of the vertices that are singled out, if any are */
  value: (at: Point, pinned: number, chosen: boolean) => number;
  /** The vertices that are 1 where others are 0. */
  choose?: (loop: Loop, corner: number, positions: Float32Array) => readonly number[];
}[] = [
  { id: 'value', label: word('constant'), value: (_, pinned) => pinned },
  { id: 'x', label: 'x', value: ([x]) => x },
  { id: 'y', label: 'y', value: ([, y]) => y },
  { id: 'x2-y2', label: 'x² − y²', value: ([x, y]) => x * x - y * y },
  {
    id: 'corner',
    label: word('one corner 1'),
    value: (_at, _pinned, chosen) => Number(chosen),
    choose: (_, corner) => [corner],
  },
  { id: 'side', label: word('one side 1'), value: (_at, _pinned, chosen) => Number(chosen), choose: sideFrom },
];

/** Pins for all vertices of some loops of a mesh. */
export function boundaryPins(
  { geometry: { positions } }: Pick<Mesh, 'geometry'>,
  loops: readonly Loop[],
  preset: string,
  pinned: number,
): Pin[] {
  const rule = boundaryPresets.find(({ id }) => id === preset);
  if (!rule) return [];
  let extent = 0;
  for (const coordinate of positions) extent = Math.max(extent, Math.abs(coordinate));
  const at = (vertex: number): Point =>
    [positions[3 * vertex] as number, positions[3 * vertex + 1] as number, positions[3 * vertex + 2] as number].map(
      (c) => c / (extent || 1),
    ) as unknown as Point;
  // The corner, or without corners the vertex, farthest out along (1, 1).
  let first: { loop: Loop; vertex: number; along: number } | null = null;
  for (const loop of loops) {
    const corners = loop.corners.map((k) => loop.vertices[k] as number);
    for (const vertex of corners.length > 0 ? corners : loop.vertices) {
      const [x, y] = at(vertex);
      if (!first || x + y > first.along) first = { loop, vertex, along: x + y };
    }
  }
  const chosen = new Set(first ? rule.choose?.(first.loop, first.vertex, positions) : []);
  const vertices = new Set(loops.flatMap((loop) => loop.vertices));
  return Array.from(vertices, (vertex) => ({
    vertex,
    value: rounded(rule.value(at(vertex), pinned, chosen.has(vertex))),
  }));
}

/** Two pins as far apart as one axis allows: something to look at on any mesh. */
export function examplePins({ geometry: { positions } }: Mesh): Pin[] {
  const ends = [0, 1, 2].map((axis) => {
    let [low, high] = [0, 0];
    for (let i = 0; i < positions.length / 3; i++) {
      if ((positions[3 * i + axis] as number) < (positions[3 * low + axis] as number)) low = i;
      if ((positions[3 * i + axis] as number) > (positions[3 * high + axis] as number)) high = i;
    }
    return { low, high, span: (positions[3 * high + axis] as number) - (positions[3 * low + axis] as number) };
  });
  const { low, high } = ends.reduce((widest, end) => (end.span > widest.span ? end : widest));
  return low === high
    ? [{ vertex: low, value: 0 }]
    : [
        { vertex: low, value: 0 },
        { vertex: high, value: 1 },
      ];
}

/** Float coordinates are not exact at the seventh digit: 0.99999994 is 1. */
function rounded(value: number): number {
  return Number(value.toFixed(6)) + 0;
}
