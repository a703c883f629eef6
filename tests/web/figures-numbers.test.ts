/** Numbers of flat figures against closed forms, over their settings; with the real core, in Node. */
import { afterAll, beforeAll, describe, expect, it } from 'vitest';
import type { Client } from '../../wasm/src/index.js';
import { createClient } from '../../wasm/src/node.js';
import { figure as checkerboard } from '../../web/figures/checkerboard/figure.js';
import { type Drawn, initialSettings, type Point, type Reading, type Settings } from '../../web/figures/figure.js';
import { figure as maximumPrinciple } from '../../web/figures/maximum-principle/figure.js';
import { figure as oneInteriorVertex } from '../../web/figures/one-interior-vertex/figure.js';
import { figure as twoCuts } from '../../web/figures/two-cuts/figure.js';
import { readState } from '../../web/src/read-state.js';

let client: Client;
beforeAll(async () => {
  client = await createClient();
});
afterAll(() => client.close());

// biome-ignore lint/suspicious/noExplicitAny: what one figure computes only it can read.
type Flat = Drawn<any>;

/** Reads a figure as it stands with other settings. */
async function at(figure: Flat, change: Settings = {}): Promise<Record<string, Reading>> {
  const settings = { ...initialSettings(figure), ...change };
  const readings = figure.read(await figure.compute(client, settings), settings);
  return Object.fromEntries(readings.map((reading) => [reading.id, reading]));
}
const value = (readings: Record<string, Reading>, id: string): number => (readings[id] as Reading).value;

describe('one interior vertex', () => {
  it.each([0.05, 0.25, 0.5, 0.75, 1, 1.5, 2, 3])('with λ = %s', async (lambda) => {
    for (const aspect of [1, 1.5, 2, 2 + Math.sqrt(3), 4]) {
      const read = await at(oneInteriorVertex, { lambda, aspect });
      const r = aspect + 1 / aspect;
      expect(value(read, 'a')).toBeCloseTo((8 * lambda) / (4 * lambda + r), 10);
      expect(value(read, 'b')).toBeCloseTo(1, 10);
      expect(value(read, 'diagonal')).toBeCloseTo(r / 4 - lambda, 10);
      expect(value(read, 'diagonal-b')).toBeCloseTo(0, 10);
      // Of two rectangles.
      expect(value(read, 'edge')).toBeCloseTo(2 * (lambda + (aspect - 1 / aspect) / 4), 10);
      expect(value(read, 'edge-b')).toBeCloseTo(aspect, 10);
      expect(read.a?.bad).toBe(lambda > r / 4 + 1e-9);
      expect(read.diagonal?.bad).toBe(lambda > r / 4 + 1e-9);
      if (aspect === 1) expect(value(read, 'a')).toBeCloseTo((4 * lambda) / (1 + 2 * lambda), 10);
    }
  });
});

describe('the maximum principle', () => {
  it('fails where λ > ½, and only there', async () => {
    for (const lambda of [0.1, 0.3, 0.49, 0.5, 0.51, 0.8, 1, 1.5, 2]) {
      const read = await at(maximumPrinciple, { lambda });
      const fails = lambda > 0.5;
      expect(value(read, 'smallest') < 0).toBe(fails);
      expect(value(read, 'outside') > 0).toBe(fails);
      expect([read.smallest?.bad, read.outside?.bad]).toEqual([fails, fails]);
      for (const id of ['smallest-b', 'largest-b', 'outside-b']) expect(value(read, id)).toBe(0);
      expect(value(read, 'largest') > 0).toBe(lambda < 0.5);
    }
  });

  it.each([
    [1, -0.1147],
    [0.51, -0.003],
    [0.5, 0],
  ])('with λ = %s the smallest value is %s', async (lambda, smallest) => {
    expect(value(await at(maximumPrinciple, { lambda }), 'smallest')).toBeCloseTo(smallest, 4);
  });

  it('says of how many vertices it says', async () => {
    expect(value(await at(maximumPrinciple), 'outside')).toBe(49);
  });
});

describe('two cuts', () => {
  const minus = ([a, b]: Point, [c, d]: Point): Point => [a - c, b - d];
  /** Of the angle at p, between q and r. */
  const cotangent = (p: Point, q: Point, r: Point): number => {
    const [u, v] = [minus(q, p), minus(r, p)];
    return (u[0] * v[0] + u[1] * v[1]) / Math.abs(u[0] * v[1] - u[1] * v[0]);
  };
  const cornersOf = (points: readonly Point[]): Settings =>
    Object.fromEntries(points.map((point, k) => [`corner-${k}`, point]));

  it('begins with the weights of the thesis’ quad', async () => {
    const read = await at(twoCuts);
    expect(value(read, 'w02')).toBeCloseTo(-0.2006, 4);
    expect(value(read, 'w13')).toBeCloseTo(0.1965, 4);
    expect([value(read, 'taken'), read.taken?.text]).toEqual([1, '1 – 3']);
    expect([read.w02?.bad, read.w13?.bad]).toEqual([true, false]);
  });

  it.each([
    [0, [0.8, 0.55]],
    [1, [1, 0.55]],
  ] as const)('leaves one cut where corner %s is drawn in past its neighbours', async (corner, point) => {
    const handle = twoCuts.controls[corner] as { min: Point; max: Point };
    for (const axis of [0, 1] as const) {
      expect(point[axis]).toBeGreaterThanOrEqual(handle.min[axis]);
      expect(point[axis]).toBeLessThanOrEqual(handle.max[axis]);
    }
    const read = await at(twoCuts, { [`corner-${corner}`]: point });
    const [inside, outside] = corner === 0 ? ['w02', 'w13'] : ['w13', 'w02'];
    expect(value(read, outside as string)).toBeNaN();
    expect(value(read, inside as string)).toBeGreaterThan(0);
  });

  it('gives the cotangent weights of convex quads, and Delaunay takes the one that is not negative', async () => {
    const quads: Point[][] = [
      [
        [0, 0],
        [2, 0],
        [2, 1],
        [0, 1],
      ],
      [
        [0.5, -0.3],
        [1.4, 0.1],
        [2.2, 1.1],
        [0.1, 1.3],
      ],
      [
        [-0.4, 0.1],
        [1.2, -0.4],
        [1.1, 0.7],
        [0.6, 1.4],
      ],
      [
        [0.1, -0.2],
        [2.3, -0.2],
        [1.5, 1.2],
        [-0.5, 0.9],
      ],
    ] as unknown as Point[][];
    for (const quad of quads) {
      const [a, b, c, d] = quad as [Point, Point, Point, Point];
      const read = await at(twoCuts, cornersOf(quad));
      expect(value(read, 'w02')).toBeCloseTo((cotangent(b, a, c) + cotangent(d, a, c)) / 2, 10);
      expect(value(read, 'w13')).toBeCloseTo((cotangent(a, b, d) + cotangent(c, b, d)) / 2, 10);
      expect(value(read, 'sum02') + value(read, 'sum13')).toBeCloseTo(360, 9);
      for (const [k, cut] of ['02', '13'].entries()) {
        const [weight, sum] = [value(read, `w${cut}`), value(read, `sum${cut}`)];
        expect(Math.sign(Math.round(weight * 1e9))).toBe(Math.sign(Math.round((180 - sum) * 1e9)));
        if (weight < -1e-9) expect(value(read, 'taken')).toBe(1 - k);
      }
    }
  });

  it('takes the only cut inside of a quad with a dent', async () => {
    const read = await at(
      twoCuts,
      cornersOf([
        [0, 0],
        [1.02, 0.41],
        [2.2, 0.6],
        [-0.1, 0.9],
      ] as unknown as Point[]),
    );
    expect([read.w02?.text, value(read, 'taken')]).toEqual(['–', 1]);
    expect(value(read, 'w13')).toBeGreaterThan(0);
    expect(value(read, 'sum02') + value(read, 'sum13')).toBeCloseTo(360, 9);
  });

  it('computes wherever its corners can be', async () => {
    const handles = twoCuts.controls.filter((control) => control.kind === 'handle');
    for (let which = 0; which < 4 ** 2; which++) {
      const places = handles.map(
        ({ min, max }, k): Point => [
          (which >> k) & 1 ? min[0] : max[0],
          (which >> ((k + 1) % 4)) & 1 ? min[1] : max[1],
        ],
      );
      const read = await at(twoCuts, cornersOf(places));
      const taken = value(read, 'taken') === 0 ? '02' : '13';
      expect(value(read, `w${taken}`)).toBeGreaterThan(-1e-9);
    }
  });
});

describe('the checkerboard', () => {
  it.each([
    ['grid', 2],
    ['even', 2],
    ['odd', 1],
  ])('%s: without the stabiliser the kernel has dimension %s, with it 1', async (mesh, dimension) => {
    const bare = await at(checkerboard, { mesh, lambda: 0 });
    expect([value(bare, 'kernel'), bare.kernel?.bad]).toEqual([dimension, dimension > 1]);
    expect(value(bare, 'energy') === 0).toBe(dimension > 1);
    for (const lambda of [0.01, 0.3, 1]) {
      const read = await at(checkerboard, { mesh, lambda });
      expect([value(read, 'kernel'), read.kernel?.bad]).toEqual([1, false]);
      expect(value(read, 'energy')).toBeGreaterThan(value(read, 'bare'));
      expect(value(read, 'bare')).toBe(value(bare, 'energy'));
    }
  });

  it('has the energy 16 λ in each unit square, and a straight line elsewhere', async () => {
    for (const lambda of [0.25, 0.5, 1])
      expect(value(await at(checkerboard, { lambda }), 'energy')).toBeCloseTo(16 * lambda, 9);
    for (const mesh of ['even', 'odd']) {
      const [zero, half, one] = await Promise.all(
        [0, 0.5, 1].map(async (lambda) => value(await at(checkerboard, { mesh, lambda }), 'energy')),
      );
      expect(half).toBeCloseTo(((zero ?? 0) + (one ?? 0)) / 2, 9);
      expect(one).toBeLessThan(16);
    }
  });

  it('draws the second function of the kernel as the core finds it: 1 and −1 in turns', async () => {
    const settings = { ...initialSettings(checkerboard), mesh: 'even' };
    const { values } = (await checkerboard.compute(client, settings)) as { values: number[] };
    values.forEach((entry, vertex) => {
      const sign = (Math.floor(vertex / 8) + (vertex % 8)) % 2 === 0 ? 1 : -1;
      expect(entry).toBeCloseTo(sign, 9);
    });
  });
});

describe('the states of the full page', () => {
  it.each([oneInteriorVertex, maximumPrinciple, twoCuts, checkerboard] as Flat[])(
    '$id: can be read back from a link as they are',
    (figure) => {
      const settings = { ...initialSettings(figure), lambda: 0.75 };
      const state = JSON.parse(JSON.stringify(figure.state(settings)));
      expect(readState(state)).toEqual(expect.objectContaining(state));
    },
  );
});
