/** Pinkall and Polthier's iteration: with its rims fixed, a film moves to where its coordinates are harmonic on itself, again and again. */
import { type Client, type Mesh, type OperatorSpec, PolylapError, type Side } from '../../src/polylap.js';

export interface Film {
  /** 3V; z is 0 midway between the rings. */
  readonly coordinates: Float64Array;
  readonly area: number;
}

/** Quads around and along. */
export interface Resolution {
  readonly around: number;
  readonly along: number;
}

/**
 * Of a step (M + tS) x′ = M x in mean squared edge lengths. So large that M adds nothing that a double could hold beside tS: x′ is harmonic on x. One
 * call takes all steps, where harmonic interpolation would be asked for three times a step.
 */
const time = 1e12;

export const cylinderOf = (h: number, { around, along }: Resolution) =>
  ({ shape: 'cylinder', nu: around, nv: along, radius: 1, height: 2 * h }) as const;

/** As the full page has it. */
export const smoothOptions = { timeH2: time, rebuild: true, fixBoundary: true } as const;

/** The films from the cylinder on; fewer than asked for if one has pinched off, so that there is no operator on it. */
export async function relax(mesh: Mesh, spec: OperatorSpec, steps: number, h: number, side: Side): Promise<Film[]> {
  const centred = (coordinates: Float64Array) => coordinates.map((c, k) => (k % 3 === 2 ? c - h : c));
  const films: Film[] = [];
  const { positions, origin } = mesh.geometry;
  const start = Float64Array.from(positions, (c, k) => c + (origin[k % 3] as number));
  films.push({ coordinates: centred(start), area: (await mesh.shape({ side })).area });
  const options = { time: time * mesh.meanSquaredEdge, steps, rebuild: true, fixBoundary: true };
  try {
    await mesh.smooth(spec, options, {
      side,
      onStep: ({ coordinates, stats }) => films.push({ coordinates: centred(coordinates), area: stats.area }),
    });
  } catch (reason) {
    if (!(reason instanceof PolylapError) || !collapsed.includes(reason.code)) throw reason;
  }
  return films;
}

/** What the core says of a surface without area. */
const collapsed: readonly string[] = ['degenerate-face', 'not-positive-definite', 'mass-not-positive'];

/** Both films start from the same cylinder. */
export async function relaxBoth(
  client: Client,
  specs: Readonly<Record<Side, OperatorSpec>>,
  { h, steps, ...resolution }: Resolution & { h: number; steps: number },
): Promise<{ films: Readonly<Record<Side, readonly Film[]>>; mesh: Pick<Mesh, 'geometry' | 'boundary'> }> {
  const mesh = await client.make(cylinderOf(h, resolution));
  try {
    const [a, b] = await Promise.all([relax(mesh, specs.a, steps, h, 'a'), relax(mesh, specs.b, steps, h, 'b')]);
    return { films: { a, b }, mesh };
  } finally {
    await mesh.close();
  }
}
