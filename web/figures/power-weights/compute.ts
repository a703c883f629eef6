import type { Client, OperatorSpec } from '../../src/polylap.js';
import { rounding } from '../drawing.js';
import type { Point, Reading, Settings } from '../figure.js';
import { arraysOf, entry, type Flat, times } from '../flat.js';
import { length, minus, powerCentre, signedDualLength, type Triangle } from '../plane.js';
import { fixed } from '../svg.js';
import { inner, patch } from './patch.js';

/** An edge between two triangles. */
export interface Edge {
  readonly ends: readonly [number, number];
  /** The triangles on its left and on its right. */
  readonly faces: readonly [number, number];
  /** -S_ij, of the weighted cotan operator. */
  readonly weight: number;
  /** The same of the cotan operator. */
  readonly cotan: number;
  /** |⋆e| / |e|, from the power centres that are drawn. */
  readonly ratio: number;
}

export interface Data {
  readonly mesh: Flat;
  readonly omega: number;
  /** Of the triangles. */
  readonly centres: readonly Point[];
  readonly edges: readonly Edge[];
  /** Largest |(S x)_i| over the inner vertices, both coordinates x. */
  readonly residual: number;
}

export const meshOf = (settings: Settings): Flat => patch(settings.middle as Point);

/** Of the middle vertex; the others have none. */
const weightsOf = ({ points }: Flat, omega: number) => points.map((_, v) => (v === 0 ? omega : 0));

export async function compute(client: Client, settings: Settings): Promise<Data> {
  const [mesh, omega] = [meshOf(settings), settings.omega as number];
  const vertexWeights = weightsOf(mesh, omega);
  const opened = await client.fromArrays(arraysOf(mesh), 'triangles');
  const stiffness = async (spec: OperatorSpec) => (await opened.matrices(spec)).stiffness;
  try {
    const [weighted, cotan] = [
      await stiffness({ id: 'weighted-cotan', vertexWeights }),
      await stiffness({ id: 'cotan' }),
    ];
    const centres = mesh.faces.map((face) => {
      const [a, b, c] = face as [number, number, number];
      const corners = face.map((v) => mesh.points[v]) as unknown as Triangle;
      const at = (v: number) => vertexWeights[v] as number;
      return powerCentre(corners, [at(a), at(b), at(c)]);
    });
    const edges = innerEdges(mesh).map(({ ends: [i, j], faces }): Edge => {
      const [a, b] = [mesh.points[i] as Point, mesh.points[j] as Point];
      const [onLeft, onRight] = faces.map((face) => centres[face]) as [Point, Point];
      return {
        ends: [i, j],
        faces,
        weight: -entry(weighted, i, j),
        cotan: -entry(cotan, i, j),
        ratio: signedDualLength(a, b, onLeft, onRight) / length(minus(b, a)),
      };
    });
    const moved = times(weighted, mesh.points).slice(0, inner);
    return { mesh, omega, centres, edges, residual: Math.max(...moved.flat().map(Math.abs)) };
  } finally {
    await opened.close();
  }
}

function innerEdges({ faces }: Flat): Pick<Edge, 'ends' | 'faces'>[] {
  const onLeft = new Map<string, number>();
  const sides = (face: readonly number[]) => face.map((v, k) => [v, face[(k + 1) % face.length] as number] as const);
  faces.forEach((face, f) => {
    for (const [i, j] of sides(face)) onLeft.set(`${i} ${j}`, f);
  });
  return faces.flatMap((face, f) =>
    sides(face).flatMap(([i, j]) => {
      const other = onLeft.get(`${j} ${i}`);
      return i < j && other !== undefined ? [{ ends: [i, j] as const, faces: [f, other] as const }] : [];
    }),
  );
}

/** Below this a weight is negative, and not a zero that was rounded. */
export const noSign = 1e-10;
export const isNegative = ({ weight }: Pick<Edge, 'weight'>) => weight < -noSign;

export function read({ edges, residual }: Data): Reading[] {
  const smallest = Math.min(...edges.map(({ weight }) => weight));
  const negative = edges.filter(isNegative).length;
  const largest = (of: (edge: Edge) => number) => Math.max(...edges.map((edge) => Math.abs(of(edge))));
  const change = largest(({ weight, cotan }) => weight - cotan);
  const difference = largest(({ weight, ratio }) => weight - ratio);
  return [
    { id: 'smallest', value: smallest, text: fixed(smallest), bad: isNegative({ weight: smallest }) },
    { id: 'negative', value: negative, bad: negative > 0 },
    { id: 'change', value: change, text: fixed(change) },
    { id: 'ratio', value: difference, text: rounding(difference) },
    { id: 'residual', value: residual, text: rounding(residual) },
  ];
}
