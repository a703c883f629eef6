import type { Mesh } from './polylap.js';
import type { Pin } from './state.js';

type Point = readonly [number, number, number];

/** Ways to pin the whole boundary. Coordinates count from the middle of the bounding box, in half its largest extent: within [-1, 1]. */
export const boundaryPresets: readonly {
  id: string;
  label: string;
  value: (at: Point, pinned: number, isCorner: boolean) => number;
}[] = [
  { id: 'value', label: 'constant', value: (_, pinned) => pinned },
  { id: 'x', label: 'x', value: ([x]) => x },
  { id: 'y', label: 'y', value: ([, y]) => y },
  { id: 'x2-y2', label: 'x² − y²', value: ([x, y]) => x * x - y * y },
  { id: 'corner', label: 'one corner 1', value: (_at, _pinned, isCorner) => (isCorner ? 1 : 0) },
];

export function boundaryPins({ boundary, geometry: { positions } }: Mesh, preset: string, pinned: number): Pin[] {
  const rule = boundaryPresets.find(({ id }) => id === preset);
  if (!rule) return [];
  let extent = 0;
  for (const coordinate of positions) extent = Math.max(extent, Math.abs(coordinate));
  const at = (vertex: number): Point =>
    [positions[3 * vertex] as number, positions[3 * vertex + 1] as number, positions[3 * vertex + 2] as number].map(
      (c) => c / (extent || 1),
    ) as unknown as Point;
  // The vertex farthest out along (1, 1): a corner of a grid.
  let corner = -1;
  let farthest = -Infinity;
  for (const vertex of boundary) {
    const [x, y] = at(vertex);
    if (x + y > farthest) [corner, farthest] = [vertex, x + y];
  }
  return Array.from(boundary, (vertex) => ({
    vertex,
    value: rounded(rule.value(at(vertex), pinned, vertex === corner)),
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
