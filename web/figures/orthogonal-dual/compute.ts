import type { Client, Dual } from '../../src/polylap.js';
import { rounding } from '../drawing.js';
import type { Point, Reading, Settings } from '../figure.js';
import { arraysOf, type Flat } from '../flat.js';
import { between, dot, minus } from '../plane.js';
import { fixed } from '../svg.js';
import { type MeshName, quads } from './quads.js';

/** An edge of the mesh and its dual. */
export interface Crossing {
  readonly ends: readonly [Point, Point];
  /** The dual vertices on its sides; on the rim there is one. */
  readonly dual: readonly Point[];
  /** Where the line of the dual edge meets that of the edge, and how far along the edge that is: outside [0, 1] it is off it. */
  readonly foot: Point;
  readonly along: number;
  /** |⋆e| / |e| */
  readonly weight: number;
}

export interface Data {
  readonly mesh: Flat;
  readonly barycentres: readonly Point[];
  readonly dual: readonly Point[];
  readonly crossings: readonly Crossing[];
  readonly measured: Pick<Dual, 'residual' | 'largestShift' | 'usable' | 'worstFace'>;
}

/** In the plane a rounding error of this times the largest weight has no sign, as for the operators. */
const noSign = 1e-10;

export const meshOf = (settings: Settings): Flat => quads(settings.mesh as MeshName, settings.amount as number);

export async function compute(client: Client, settings: Settings): Promise<Data> {
  const mesh = meshOf(settings);
  const opened = await client.fromArrays(arraysOf(mesh), 'quads');
  try {
    return dataOf(mesh, await opened.dual());
  } finally {
    await opened.close();
  }
}

function dataOf(mesh: Flat, { coordinates, edgeVertices, edgeFaces, weights, ...measured }: Dual): Data {
  const at = (v: number) => mesh.points[v] as Point;
  const dual = mesh.faces.map((_, f): Point => [coordinates[3 * f] as number, coordinates[3 * f + 1] as number]);
  const barycentres = mesh.faces.map((face): Point => {
    const sum = face.map(at).reduce(([x, y], [a, b]) => [x + a, y + b]);
    return [sum[0] / face.length, sum[1] / face.length];
  });
  const crossings = Array.from(weights, (weight, e): Crossing => {
    const ends = [at(edgeVertices[2 * e] as number), at(edgeVertices[2 * e + 1] as number)] as const;
    const sides = [...edgeFaces.subarray(2 * e, 2 * e + 2)].filter((face) => face >= 0);
    const own = sides.map((face) => dual[face] as Point);
    const edge = minus(ends[1], ends[0]);
    const along = own.reduce((sum, v) => sum + dot(minus(v, ends[0]), edge) / dot(edge, edge), 0) / own.length;
    return { ends, dual: own, along, foot: between(ends[0], ends[1], along), weight };
  });
  return { mesh, barycentres, dual, crossings, measured };
}

export function isNegative({ crossings }: Data): (crossing: Crossing) => boolean {
  const least = noSign * Math.max(...crossings.map(({ weight }) => Math.abs(weight)));
  return ({ weight }) => weight < -least;
}

export function read(data: Data): Reading[] {
  const { residual, largestShift, usable } = data.measured;
  const negative = data.crossings.filter(isNegative(data)).length;
  return [
    { id: 'residual', value: residual, text: rounding(residual) },
    { id: 'shift', value: largestShift, text: fixed(largestShift), bad: !usable },
    { id: 'negative', value: negative, bad: negative > 0 },
  ];
}
