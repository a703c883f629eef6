/** The figures of duals and of the Dirichlet energy: what the core says against closed forms, over all that their controls allow. */
import { afterAll, beforeAll, describe, expect, it } from 'vitest';
import type { Client } from '../../wasm/src/index.js';
import { createClient } from '../../wasm/src/node.js';
import * as circumcentric from '../../web/figures/circumcentric-dual/compute.js';
import { figure as circumcentricDual } from '../../web/figures/circumcentric-dual/figure.js';
import * as dirichlet from '../../web/figures/dirichlet-energy/compute.js';
import { figure as mappedTriangle } from '../../web/figures/dirichlet-energy/figure.js';
import type { Figure, Handle, Point, Settings } from '../../web/figures/figure.js';
import * as orthogonal from '../../web/figures/orthogonal-dual/compute.js';
import { meshes, sideOf } from '../../web/figures/orthogonal-dual/quads.js';
import { dot, length, minus, plus, signedArea, type Triangle } from '../../web/figures/plane.js';
import * as power from '../../web/figures/power-weights/compute.js';
import { figure as powerWeights } from '../../web/figures/power-weights/figure.js';

let client: Client;
beforeAll(async () => {
  client = await createClient();
});
afterAll(() => client.close());

const readings = (list: readonly { id: string; value: number; bad?: boolean }[]) =>
  Object.fromEntries(list.map((reading) => [reading.id, reading]));
/** Evenly from a to b, both included. */
const steps = (a: number, b: number, count: number) =>
  Array.from({ length: count }, (_, k) => a + ((b - a) * k) / (count - 1));

describe('circumcentric dual', () => {
  it('has half the cotangents, and the dual edge over the edge, as its weight', async () => {
    for (const x of steps(0.2, 2, 7)) {
      for (const [y, right] of [
        [0, [0.4, 0.3]],
        [-1.2, [1.5, -0.6]],
        [0.9, [x, 1.3]],
      ] as const) {
        const data = await circumcentric.compute(client, { left: [-x, y], right });
        const cotans = data.gammas.map((gamma) => 1 / Math.tan(gamma));
        for (const [k, half] of data.halves.entries()) expect(half).toBeCloseTo((cotans[k] as number) / 2, 12);
        expect(data.weight).toBeCloseTo(((cotans[0] as number) + (cotans[1] as number)) / 2, 12);
        expect(data.dualLength / data.edgeLength).toBeCloseTo(data.weight, 12);
        // Delaunay or not: the angles at the apexes tell.
        const { cotan, ratio, left, right: gamma } = readings(circumcentric.read(data));
        expect(cotan?.bad).toBe((left?.value ?? 0) + (gamma?.value ?? 0) > 180);
        expect(ratio?.bad).toBe(cotan?.bad);
        for (const [k, centre] of data.centres.entries()) {
          const corners = (data.mesh.faces[k] as number[]).map((v) => data.mesh.points[v] as Point);
          const [radius, ...others] = corners.map((corner) => length(minus(corner, centre)));
          for (const other of others) expect(other).toBeCloseTo(radius as number, 12);
        }
      }
    }
  });

  it('is 0 where all four corners lie on a circle, and belongs to the square', async () => {
    const data = await circumcentric.compute(client, { left: [-1, 0], right: [1, 0] });
    expect(Math.abs(data.weight)).toBeLessThan(1e-14);
    expect(circumcentric.isNegative(data)).toBe(false);
    const equilateral = await circumcentric.compute(client, {
      left: [-Math.sqrt(3), 0],
      right: [Math.sqrt(3), 0],
    });
    expect(equilateral.weight).toBeCloseTo(1 / Math.sqrt(3), 12);
  });
});

describe('power weights', () => {
  const settings = (omega: number, middle: Point = [0, 0]) => ({ omega, middle });

  it('are dual over primal lengths of the drawn power diagram, and linearly precise, for every ω', async () => {
    for (const omega of steps(-1.6, 1.6, 9)) {
      for (const middle of [
        [0, 0],
        [0.3, -0.2],
        [-0.35, 0.35],
      ] as const) {
        const data = await power.compute(client, settings(omega, middle));
        expect(data.edges).toHaveLength(30);
        for (const { weight, ratio } of data.edges) expect(ratio).toBeCloseTo(weight, 12);
        expect(data.residual).toBeLessThan(1e-13);
        // Each centre has the same power to all three corners of its triangle.
        data.mesh.faces.forEach((face, f) => {
          const powers = face.map((v) => {
            const from = minus(data.centres[f] as Point, data.mesh.points[v] as Point);
            return dot(from, from) - (v === 0 ? omega : 0);
          });
          expect(Math.max(...powers) - Math.min(...powers)).toBeLessThan(1e-12);
        });
      }
    }
  });

  it('are the cotan weights where ω is 0, and change only where the middle vertex has a triangle', async () => {
    const [plain, moved] = [await power.compute(client, settings(0)), await power.compute(client, settings(0.5))];
    for (const { weight, cotan } of plain.edges) expect(weight).toBe(cotan);
    expect(plain.edges.every(({ weight }) => weight > 0)).toBe(true);
    const changed = moved.edges.filter(({ weight, cotan }) => Math.abs(weight - cotan) > 1e-12);
    expect(changed).toHaveLength(12);
    expect(changed.every(({ ends }) => ends.every((v) => v < 7))).toBe(true);
    // More on the spokes, less on the ring: the sum of S over the whole patch knows nothing of it.
    for (const { ends, weight, cotan } of changed) expect(Math.sign(weight - cotan)).toBe(ends[0] === 0 ? 1 : -1);
  });

  it('turn spokes negative far below 0, and the ring far above', async () => {
    const negative = async (omega: number) =>
      (await power.compute(client, settings(omega))).edges.filter(power.isNegative);
    // From there on, as the words beside it say.
    const [below, above] = [await negative(-1.1), await negative(1.1)];
    expect(below.map(({ ends }) => ends[0])).toEqual([0, 0, 0, 0, 0, 0]);
    expect(above).toHaveLength(6);
    expect(above.every(({ ends }) => ends[0] > 0 && ends[1] < 7)).toBe(true);
  });
});

describe('orthogonal dual', () => {
  it('is orthogonal on every mesh, and its weights are signed lengths over lengths', async () => {
    for (const mesh of meshes) {
      for (const amount of steps(0, 0.4, 5)) {
        const data = await orthogonal.compute(client, { mesh, amount });
        for (const { ends, dual, foot, weight } of data.crossings) {
          const edge = minus(ends[1], ends[0]);
          for (const v of dual) expect(dot(minus(v, foot), edge)).toBeCloseTo(0, 11);
          if (dual.length < 2) continue;
          const [k, l] = dual as [Point, Point];
          expect(dot(minus(k, l), edge)).toBeCloseTo(0, 11);
          expect(Math.abs(weight)).toBeCloseTo(length(minus(k, l)) / length(edge), 11);
        }
        expect(data.measured.residual).toBeLessThan(1e-12);
        const shifts = data.dual.map((v, f) => {
          const face = (data.mesh.faces[f] as number[]).map((corner) => data.mesh.points[corner] as Point);
          const [a, b, c, d] = face as [Point, Point, Point, Point];
          const area = signedArea(a, b, c) + signedArea(a, c, d);
          expect(area).toBeGreaterThan(0);
          return length(minus(v, data.barycentres[f] as Point)) / Math.sqrt(area);
        });
        expect(Math.max(...shifts)).toBeCloseTo(data.measured.largestShift, 10);
        expect(data.measured.usable).toBe(data.measured.largestShift <= 1);
      }
    }
  });

  it('of parallelograms is the lattice that is sheared the other way: the corners of a larger mesh are farther off', async () => {
    for (const mesh of ['sheared', 'sheared-more'] as const) {
      const middle = (sideOf[mesh] - 1) / 2;
      for (const s of steps(0, 0.4, 5)) {
        const data = await orthogonal.compute(client, { mesh, amount: s });
        const farthest = middle * s * Math.hypot(1 + s / (1 + s * s), 1 / (1 + s * s));
        expect(data.measured.largestShift).toBeCloseTo(farthest, 10);
        for (const { ends, dual, weight } of data.crossings) {
          if (dual.length < 2) continue;
          expect(weight).toBeCloseTo(ends[0][1] === ends[1][1] ? 1 : 1 / (1 + s * s), 10);
        }
      }
    }
  });

  it('has negative edges on a mesh that is shaken hard, and no right to be used', async () => {
    const at = async (amount: number) =>
      readings(orthogonal.read(await orthogonal.compute(client, { mesh: 'shaken', amount })));
    // As the words beside it say.
    expect(await at(0.25)).toMatchObject({ negative: { value: 3 }, shift: { bad: true } });
    const [little, much] = [await at(0.1), await at(0.4)];
    expect(little).toMatchObject({ negative: { value: 0, bad: false }, shift: { bad: false } });
    expect(much.negative?.value).toBeGreaterThan(0);
    expect(much).toMatchObject({ negative: { bad: true }, shift: { bad: true } });
  });
});

describe('Dirichlet energy', () => {
  const source = { a: [0, 0], b: [1.2, 0.1], c: [0.3, 1.1] } as const;
  const images: readonly Triangle[] = [
    [
      [0, 0],
      [1, 0],
      [0, 1],
    ],
    [
      [0.2, -0.5],
      [1.9, 0.4],
      [-0.6, 0.8],
    ],
    [
      [0, 0],
      [1, 1],
      [2, 2],
    ],
    [
      [0, 0],
      [0.1, 1.4],
      [1.3, 0.2],
    ],
  ];

  it('is half the squared stretches times the area, at least the area of the image', async () => {
    const area = signedArea(source.a, source.b, source.c);
    for (const [p, q, r] of images) {
      const data = await dirichlet.compute(client, { ...source, p, q, r });
      const [most, least] = data.stretches;
      expect(data.energy).toBeCloseTo(((most ** 2 + least ** 2) / 2) * area, 12);
      expect(Math.abs(data.area)).toBeCloseTo(most * least * area, 12);
      expect(dirichlet.excess(data)).toBeCloseTo(((most - least) ** 2 / 2) * area, 12);
      expect(dirichlet.excess(data)).toBeGreaterThan(-1e-15);
    }
  });

  it('is the area where the image is similar, turned over or not, and moving it changes nothing', async () => {
    const similar = ([x, y]: Point, turn: number, scale: number, mirror: 1 | -1): Point => [
      scale * (Math.cos(turn) * x - Math.sin(turn) * mirror * y),
      scale * (Math.sin(turn) * x + Math.cos(turn) * mirror * y),
    ];
    for (const turn of steps(0, 6, 5)) {
      for (const scale of [0.3, 1, 2]) {
        for (const mirror of [1, -1] as const) {
          const [p, q, r] = [source.a, source.b, source.c].map((x) =>
            plus(similar(x, turn, scale, mirror), [1, 2]),
          ) as [Point, Point, Point];
          const data = await dirichlet.compute(client, { ...source, p, q, r });
          expect(Math.sign(data.area)).toBe(mirror);
          expect(data.energy).toBeCloseTo(scale ** 2 * signedArea(source.a, source.b, source.c), 12);
          expect(dirichlet.excess(data)).toBeCloseTo(0, 12);
          expect(data.stretches[0] / data.stretches[1]).toBeCloseTo(1, 7);
        }
      }
    }
  });
});

describe('what handles allow', () => {
  /** The corners of the region of each handle, in all combinations. */
  const extremes = (handles: readonly Handle[]): Settings[] =>
    handles.reduce<Settings[]>(
      (all, { id, min, max }) =>
        all.flatMap((one) =>
          [min, [max[0], min[1]] as const, max, [min[0], max[1]] as const].map((place) => ({ ...one, [id]: place })),
        ),
      [{}],
    );
  const handlesOf = ({ controls }: Figure, ids: readonly string[]) =>
    controls.filter((control): control is Handle => control.kind === 'handle' && ids.includes(control.id));

  // An area is linear in each coordinate: its extremes are at those of the corners.
  it.each([
    ['dirichlet-energy', mappedTriangle, ['a', 'b', 'c'], dirichlet.meshOf],
    ['power-weights', powerWeights, ['middle'], power.meshOf],
    ['circumcentric-dual', circumcentricDual, ['left', 'right'], circumcentric.meshOf],
  ] as const)('leaves all triangles of %s counter-clockwise', (_, figure, ids, meshOf) => {
    const all = extremes(handlesOf(figure, ids));
    expect(all).toHaveLength(4 ** ids.length);
    for (const settings of all) {
      const { points, faces } = meshOf(settings);
      for (const face of faces) {
        const [a, b, c] = face.map((v) => points[v]) as unknown as Triangle;
        expect(signedArea(a, b, c)).toBeGreaterThan(0.04);
      }
    }
  });
});
