import type { Client } from '../../src/polylap.js';
import type { Point, Reading, Settings } from '../figure.js';
import { arraysOf, entry, type Flat } from '../flat.js';
import { angle, length, minus, powerCentre, signedDualLength } from '../plane.js';
import { fixed } from '../svg.js';

export interface Data {
  /** The edge runs up from vertex 0 to vertex 1; 2 is on its left, 3 on its right. */
  readonly mesh: Flat;
  /** The circumcentres of the triangles on its left and on its right. */
  readonly centres: readonly [Point, Point];
  /** At the apexes, opposite to the edge, in radians. */
  readonly gammas: readonly [number, number];
  /** What the triangles add to the cotan weight of the edge: ½ cot γ. */
  readonly halves: readonly [number, number];
  /** Their sum, as the core assembles it: -S_01. */
  readonly weight: number;
  /** |⋆e| and |e|. */
  readonly dualLength: number;
  readonly edgeLength: number;
}

const ends: readonly [Point, Point] = [
  [0, -1],
  [0, 1],
];

export const meshOf = (settings: Settings): Flat => ({
  points: [...ends, settings.left as Point, settings.right as Point],
  faces: [
    [0, 1, 2],
    [1, 0, 3],
  ],
});

export async function compute(client: Client, settings: Settings): Promise<Data> {
  const mesh = meshOf(settings);
  const opened = await client.fromArrays(arraysOf(mesh), 'two triangles');
  try {
    const { stiffness } = await opened.matrices({ id: 'cotan' });
    const half = async (face: number) => -((await opened.face({ id: 'cotan' }, face)).stiffness?.[1] ?? Number.NaN);
    const [[a, b], apexes] = [ends, [settings.left as Point, settings.right as Point] as const];
    const centres = [powerCentre([a, b, apexes[0]]), powerCentre([a, b, apexes[1]])] as const;
    return {
      mesh,
      centres,
      gammas: [angle(apexes[0], a, b), angle(apexes[1], a, b)],
      halves: [await half(0), await half(1)],
      weight: -entry(stiffness, 0, 1),
      dualLength: signedDualLength(a, b, ...centres),
      edgeLength: length(minus(b, a)),
    };
  } finally {
    await opened.close();
  }
}

/** A weight below this is negative, and not a zero that was rounded. */
const noSign = 1e-10;
export const isNegative = ({ weight }: Pick<Data, 'weight'>) => weight < -noSign;

const degrees = (radians: number) => (radians * 180) / Math.PI;

export function read(data: Data): Reading[] {
  const { gammas, weight, dualLength, edgeLength } = data;
  const [bad, ratio] = [isNegative(data), dualLength / edgeLength];
  return [
    { id: 'left', value: degrees(gammas[0]), text: `${fixed(degrees(gammas[0]), 1)}°` },
    { id: 'right', value: degrees(gammas[1]), text: `${fixed(degrees(gammas[1]), 1)}°` },
    { id: 'cotan', value: weight, text: fixed(weight, 4), bad },
    { id: 'ratio', value: ratio, text: fixed(ratio, 4), bad },
  ];
}
