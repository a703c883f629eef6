/** A quad and its two triangulations (Herholz 2012, Fig. 4.6). */
import type { Client } from '../../src/polylap.js';
import { choice, stateWith } from '../common.js';
import { drawn, type Handle, type Point, type Say, type Settings } from '../figure.js';
import { arraysOf, objOf } from '../flat.js';
import { angle, between, minus, powerCentre, signedArea, type Triangle } from '../plane.js';
import { circle, fixed, group, handle, indexed, type Label, labels, line, plane, polygon, svg } from '../svg.js';

/** Each corner stays in its own quarter around the middle, so that sides never cross. */
const quarters = {
  left: [-0.5, 0.9],
  right: [1, 2.3],
  low: [-0.4, 0.55],
  high: [0.58, 1.4],
} as const;

const corner = (k: number, initial: Point, x: Point, y: Point): Handle => ({
  id: `corner-${k}`,
  kind: 'handle',
  initial,
  step: 0.05,
  min: [x[0], y[0]],
  max: [x[1], y[1]],
});

const corners = [
  corner(0, [0, 0], quarters.left, quarters.low),
  corner(1, [1.6, 0.15], quarters.right, quarters.low),
  corner(2, [1.9, 1], quarters.right, quarters.high),
  corner(3, [-0.1, 0.9], quarters.left, quarters.high),
] as const;

const pointsOf = (settings: Settings): Point[] => corners.map(({ id }) => settings[id] as Point);

/** A cut and the two corners that face it. */
const cuts = [
  { from: 0, to: 2, facing: [1, 3] },
  { from: 1, to: 3, facing: [2, 0] },
] as const;
type Cut = (typeof cuts)[number];
const nameOf = ({ from, to }: Cut): string => `${from}${to}`;

interface Data {
  points: Point[];
  /** Of the cuts; NaN for one that does not lie inside. */
  weights: readonly [number, number];
  /** Which of the cuts Delaunay takes. */
  taken: 0 | 1;
}

/** The two triangles that a cut makes, both as the quad turns. */
const trianglesOf = ({ from, to, facing }: Cut): [number[], number[]] => [
  [from, facing[0], to],
  [from, to, facing[1]],
];

const isInside = (points: readonly Point[], cut: Cut): boolean =>
  trianglesOf(cut).every((triangle) => signedArea(...(triangle.map((k) => points[k]) as unknown as Triangle)) > 0);

/** The cotangent weight of a cut, from the matrix of its two triangles. */
async function weightOf(client: Client, points: readonly Point[], cut: Cut): Promise<number> {
  if (!isInside(points, cut)) return Number.NaN;
  const mesh = await client.fromArrays(arraysOf({ points, faces: trianglesOf(cut) }), 'two triangles');
  try {
    const { columns, values } = await mesh.row({ id: 'cotan' }, cut.from);
    // None off the diagonal is 0: what is missing is.
    const k = columns.indexOf(cut.to);
    return k < 0 ? 0 : -(values[k] as number);
  } finally {
    await mesh.close();
  }
}

async function delaunay(client: Client, points: readonly Point[]): Promise<0 | 1> {
  const mesh = await client.fromArrays(arraysOf({ points, faces: [[0, 1, 2, 3]] }), 'quad');
  try {
    const { triangles } = await mesh.face({ id: 'planar' }, 0);
    // The ends of the cut are corners of both triangles.
    return [...triangles].filter((k) => k === 0).length === 2 ? 0 : 1;
  } finally {
    await mesh.close();
  }
}

export const figure = drawn<Data>({
  id: 'two-cuts',
  number: 9,
  controls: corners,
  async compute(client, settings) {
    const points = pointsOf(settings);
    const [first, second, taken] = await Promise.all([
      weightOf(client, points, cuts[0]),
      weightOf(client, points, cuts[1]),
      delaunay(client, points),
    ]);
    return { points, weights: [first, second], taken };
  },
  draw: (data, settings, say) => picture(data, settings, say),
  read: ({ points, weights, taken }) => [
    ...cuts.map((cut, k) => ({
      id: `w${nameOf(cut)}`,
      value: weights[k] as number,
      text: Number.isNaN(weights[k]) ? '–' : fixed(weights[k] as number, 4),
      bad: (weights[k] as number) < 0,
    })),
    ...cuts.map((cut) => {
      const value = facingAngles(points, cut);
      return { id: `sum${nameOf(cut)}`, value, text: `${fixed(value, 1)}°` };
    }),
    { id: 'taken', value: taken, text: `${(cuts[taken] as Cut).from} – ${(cuts[taken] as Cut).to}` },
  ],
  state: () =>
    stateWith(() => ({
      task: 'weights',
      source: { kind: 'file', name: 'quad.obj', file: -1 },
      sides: { a: choice('planar', { rule: 'fan' }), b: choice('planar') },
      selected: 1,
      selectedFace: 0,
    })),
  file: (settings) => objOf({ points: pointsOf(settings), faces: [[0, 1, 2, 3]] }),
});

/** The sum of the angles that face a cut, in degrees; a reflex one counts as such. */
function facingAngles(points: readonly Point[], { from, to, facing }: Cut): number {
  const at = (k: number) => points[k] as Point;
  const sum = facing.reduce<number>((total, k, which) => {
    const [before, after] = which === 0 ? [from, to] : [to, from];
    const inner = angle(at(k), at(before), at(after));
    return total + (signedArea(at(before), at(k), at(after)) > 0 ? inner : 2 * Math.PI - inner);
  }, 0);
  return (sum * 180) / Math.PI;
}

const [width, height] = [440, 310];

function picture({ points, weights, taken }: Data, settings: Settings, say: Say): string {
  const frame = plane({
    x: [quarters.left[0], quarters.right[1]],
    y: [quarters.low[0], quarters.high[1]],
    width,
    height,
    margin: 20,
  });
  const at = points.map(frame.at);
  const middle = frame.at([0.9, 0.5]);
  const chosen = cuts[taken] as Cut;
  const circles = trianglesOf(chosen).map((triangle) => {
    const three = triangle.map((k) => points[k]) as unknown as Triangle;
    const centre = powerCentre(three);
    return circle(frame.at(centre), frame.scale * Math.hypot(...minus(three[0], centre)), 'dotted');
  });
  const lines = cuts.map((cut, k) => {
    const [from, to] = [at[cut.from] as Point, at[cut.to] as Point];
    const weight = weights[k] as number;
    return line(from, to, weight < 0 ? 'edge-negative' : k === taken ? 'accent-line' : 'dotted');
  });
  // Away from where the cuts cross.
  const cutLabels = cuts.map((cut, k): Label => {
    const place = between(at[cut.from] as Point, at[cut.to] as Point, k === 0 ? 0.3 : 0.7);
    const weight = weights[k] as number;
    const value = Number.isNaN(weight) ? ` ${say('draw.outside')}` : ` = ${fixed(weight, 4)}`;
    return {
      at: place,
      words: `w${nameOf(cut)}${value}`,
      inner: indexed('w', nameOf(cut), value),
      className: weight < 0 ? 'halo bad' : 'halo',
      towards: [0, k === 0 ? 1 : -1],
      distance: 8,
    };
  });
  const numbers = at.map((p, k): Label => ({ at: p, words: String(k), towards: minus(p, middle), distance: 16 }));
  const taking = at.map(([x, y]) => [x, y, 12] as const);
  return svg(
    width,
    height,
    frame.element,
    group('clip', ...circles),
    polygon(at, 'face'),
    group('', ...lines),
    polygon(at, 'edge'),
    labels([...numbers, ...cutLabels], taking, { width, height }),
    ...corners.map((control, k) => handle(control, settings[control.id] as Point, frame, say('draw.corner', { k }))),
  );
}
