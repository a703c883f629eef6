/** The vector area of a polygon in no plane, and its gradient (Herholz 2012, Fig. 4.4). */

import type { Client, FaceReport, OperatorSpec } from '../../src/polylap.js';
import { initialChoice, initialState } from '../../src/state.js';
import { drawn, type Reading, type Settings } from '../figure.js';
import { fixed } from '../svg.js';
import { cross, dot, length, mean, minus, sum, times, type Vec } from '../svg3d.js';
import { drawArea } from './draw.js';
import { type Kind, kinds, objOf, oneFace, polygon } from './polygons.js';

export interface AreaData {
  readonly points: readonly Vec[];
  readonly vectorArea: Vec;
  readonly nonPlanarity: number;
  /** Of corners: how the planar operator cuts the face. */
  readonly triangles: readonly (readonly [number, number, number])[];
  /** Of |a| at the corners: S x of Alexa and Wardetzky's operator without its stabiliser. */
  readonly gradients: readonly Vec[];
  /** The largest part of S x along a: without stabiliser, with it, and of the planar operator. */
  readonly pull: { readonly bare: number; readonly stabilised: number; readonly planar: number };
}

const bare: OperatorSpec = { id: 'alexa-wardetzky', lambda: 0 };
const stabilised: OperatorSpec = { id: 'alexa-wardetzky', lambda: 1 };
const planar: OperatorSpec = { id: 'planar' };

const chosen = ({ polygon: kind, height }: Settings) => polygon(kind as Kind, height as number);

async function compute(client: Client, settings: Settings): Promise<AreaData> {
  const points = chosen(settings);
  const mesh = await client.fromArrays(oneFace(points), 'polygon');
  try {
    const [one, other, cut] = await Promise.all([bare, stabilised, planar].map((spec) => mesh.face(spec, 0)));
    if (!one || !other || !cut) throw new Error('A face was not reported');
    const along = (report: FaceReport) =>
      Math.max(...applied(report, points).map((pull) => Math.abs(dot(pull, one.normal))));
    return {
      points,
      vectorArea: one.vectorArea,
      nonPlanarity: one.nonPlanarity,
      triangles: triples(cut.triangles),
      gradients: applied(one, points),
      pull: { bare: along(one), stabilised: along(other), planar: along(cut) },
    };
  } finally {
    await mesh.close();
  }
}

/** S x of one face. @throws Error where the core has no S, with its reason */
function applied({ stiffness, noStiffness }: FaceReport, points: readonly Vec[]): Vec[] {
  if (!stiffness) throw new Error(noStiffness);
  const n = points.length;
  return points.map((_, i) => points.map((p, j) => times(stiffness[i * n + j] as number, p)).reduce(sum));
}

const triples = (corners: ArrayLike<number>): [number, number, number][] =>
  Array.from({ length: corners.length / 3 }, (_, t) => {
    const corner = (k: number) => corners[3 * t + k] as number;
    return [corner(0), corner(1), corner(2)];
  });

/** Of triangles in space. */
const areaOf = (triangles: readonly (readonly [Vec, Vec, Vec])[]): number =>
  triangles.reduce((area, [p, q, r]) => area + length(cross(minus(q, p), minus(r, p))) / 2, 0);

/** The triangles between the middle and the sides, as they are drawn. */
const fanArea = ({ points }: AreaData): number =>
  areaOf(points.map((p, k) => [mean(points), p, points[(k + 1) % points.length] as Vec]));

const cutArea = ({ points, triangles }: AreaData): number =>
  areaOf(triangles.map((corners) => corners.map((corner) => points[corner] as Vec) as [Vec, Vec, Vec]));

function read(data: AreaData): Reading[] {
  const { vectorArea, nonPlanarity, gradients, pull } = data;
  const plain = (id: string, value: number): Reading => ({ id, value, text: fixed(value, 4) });
  return [
    { id: 'vectorArea', value: vectorArea[2], text: `(${vectorArea.map((part) => fixed(part)).join(', ')})` },
    plain('size', length(vectorArea)),
    plain('fan', fanArea(data)),
    plain('cut', cutArea(data)),
    plain('nonPlanarity', nonPlanarity),
    plain('sum', length(gradients.reduce(sum))),
    plain('bare', pull.bare),
    plain('stabilised', pull.stabilised),
    plain('planar', pull.planar),
  ];
}

export const figure = drawn<AreaData>({
  id: 'vector-area',
  number: 4,
  controls: [
    { kind: 'choice', id: 'polygon', choices: kinds, initial: 'saddle' },
    { kind: 'slider', id: 'height', min: 0, max: 1, step: 0.05, initial: 0.6 },
    { kind: 'turn', id: 'view', view: true, initial: [30, 24] },
  ],
  compute,
  draw: drawArea,
  read,
  state: () => ({
    ...initialState(),
    source: { kind: 'file', name: 'polygon.obj', file: 0 },
    sides: { a: { ...initialChoice(bare.id), parameters: { lambda: 0 } }, b: initialChoice(planar.id) },
    selected: 0,
    selectedFace: 0,
  }),
  file: (settings) => objOf(chosen(settings)),
});
