import type { Client } from '../../src/polylap.js';
import type { Point, Reading, Settings } from '../figure.js';
import { arraysOf, type Flat, times } from '../flat.js';
import { dot, minus, plus, signedArea, type Triangle } from '../plane.js';
import { fixed } from '../svg.js';

export interface Data {
  readonly source: Triangle;
  readonly image: Triangle;
  /** E_d of the map, length² */
  readonly energy: number;
  /** Of the image; negative where the map turns the triangle over. */
  readonly area: number;
  /** Largest and smallest factor by which the map changes lengths. */
  readonly stretches: readonly [number, number];
}

export const sourceOf = ({ a, b, c }: Settings): Triangle => [a as Point, b as Point, c as Point];
export const imageOf = ({ p, q, r }: Settings): Triangle => [p as Point, q as Point, r as Point];
export const meshOf = (settings: Settings): Flat => ({ points: sourceOf(settings), faces: [[0, 1, 2]] });

export async function compute(client: Client, settings: Settings): Promise<Data> {
  const [source, image] = [sourceOf(settings), imageOf(settings)];
  const opened = await client.fromArrays(arraysOf(meshOf(settings)), 'triangle');
  try {
    const { stiffness } = await opened.matrices({ id: 'cotan' });
    // Of the source triangle: what it takes of the image is how far its corners are apart.
    const moved = times(stiffness, image);
    const energy = image.reduce((sum, corner, k) => sum + dot(corner, moved[k] as Point), 0) / 2;
    return { source, image, energy, area: signedArea(...image), stretches: stretchesOf(jacobian(source, image)) };
  } finally {
    await opened.close();
  }
}

/** The images of (1, 0) and (0, 1) under the linear part of the map. */
export function jacobian(source: Triangle, image: Triangle): readonly [Point, Point] {
  const [u, v] = [minus(source[1], source[0]), minus(source[2], source[0])];
  const [p, q] = [minus(image[1], image[0]), minus(image[2], image[0])];
  const twice = 2 * signedArea(...source);
  const of = (x: number, y: number): Point => plus([(x * p[0]) / twice, (x * p[1]) / twice], q, y / twice);
  return [of(v[1], -u[1]), of(-v[0], u[0])];
}

/** The singular values of a matrix of two columns. */
function stretchesOf([[a, c], [b, d]]: readonly [Point, Point]): readonly [number, number] {
  // Of its conformal and its anticonformal part.
  const [same, other] = [Math.hypot(a + d, c - b) / 2, Math.hypot(a - d, c + b) / 2];
  return [same + other, Math.abs(same - other)];
}

export const excess = ({ energy, area }: Data) => energy - Math.abs(area);

export function read(data: Data): Reading[] {
  const { energy, area, stretches } = data;
  return [
    { id: 'energy', value: energy, text: fixed(energy, 4) },
    { id: 'area', value: Math.abs(area), text: fixed(Math.abs(area), 4) },
    { id: 'excess', value: excess(data), text: fixed(excess(data), 4) },
    { id: 'stretch', value: stretches[0] / stretches[1], text: stretchText(stretches) },
  ];
}

const stretchText = (stretches: readonly [number, number]) => stretches.map((each) => fixed(each)).join(', ');
