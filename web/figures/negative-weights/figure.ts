/** How many weights are negative on a quad bunny (Herholz 2012, table on p. 31). */
import { count } from '../../src/format.js';
import type { Client, Geometry, OperatorSpec, Weights } from '../../src/polylap.js';
import { openBunny } from '../bunny.js';
import { choice, stateWith } from '../common.js';
import { type Compared, compared, type Reading, type Settings } from '../figure.js';

const meshes = { smooth: 'bunny', noisy: 'noisy-bunny' } as const;
type Surface = keyof typeof meshes;

/** What the thesis counts, on a quad bunny and a noise of its own. */
const thesis: Readonly<Record<Surface, { a: number; b: number }>> = {
  smooth: { a: 20_714, b: 30 },
  noisy: { a: 23_950, b: 680 },
};

const surfaceOf = ({ surface }: Settings) => surface as Surface;

async function compute(client: Client, settings: Settings): Promise<Reading[]> {
  const surface = surfaceOf(settings);
  const specs: OperatorSpec[] = [{ id: 'alexa-wardetzky', lambda: Number(settings.lambda) }, { id: 'planar' }];
  const mesh = await openBunny(client, meshes[surface]);
  try {
    const [a, b] = await Promise.all(specs.map((spec) => mesh.weights(spec)));
    if (!a || !b) throw new Error('Weights were not counted');
    const along = onEdges(a, mesh.geometry);
    return [
      { id: 'a', value: a.negativeOrdered, bad: a.negativeOrdered > 0 },
      { id: 'edges-a', value: along },
      { id: 'diagonals-a', value: a.negativeOrdered - along },
      { id: 'b', value: b.negativeOrdered, bad: b.negativeOrdered > 0 },
      { id: 'thesis-a', value: thesis[surface].a },
      { id: 'thesis-b', value: thesis[surface].b },
    ].map((reading) => ({ ...reading, text: count(reading.value) }));
  } finally {
    await mesh.close();
  }
}

/** Of the negative weights, ordered pairs, those between the ends of an edge. */
function onEdges({ pairs }: Weights, { offsets, corners }: Geometry): number {
  const name = (i: number, j: number) => `${Math.min(i, j)} ${Math.max(i, j)}`;
  const edges = new Set<string>();
  for (let f = 0; f + 1 < offsets.length; f++) {
    const face = [...corners.subarray(offsets[f], offsets[f + 1])];
    for (const [k, corner] of face.entries()) edges.add(name(corner, face[(k + 1) % face.length] as number));
  }
  let found = 0;
  for (let k = 0; k < pairs.length; k += 2) if (edges.has(name(pairs[k] as number, pairs[k + 1] as number))) found += 2;
  return found;
}

export const figure: Compared = compared({
  id: 'negative-weights',
  number: 8,
  controls: [
    { kind: 'choice', id: 'surface', choices: ['smooth', 'noisy'], initial: 'smooth' },
    { kind: 'slider', id: 'lambda', min: 0, max: 2, step: 0.05, initial: 1 },
  ],
  compute,
  state: (settings) =>
    stateWith(({ sides }) => ({
      source: { kind: 'preset', id: meshes[surfaceOf(settings)] },
      sides: { a: choice('alexa-wardetzky', { lambda: Number(settings.lambda) }), b: sides.b },
    })),
});
