/** The figures in space against closed forms, with the real core, in Node. */
import { afterAll, beforeAll, describe, expect, it } from 'vitest';
import type { Client, OperatorSpec } from '../../wasm/src/index.js';
import { createClient } from '../../wasm/src/node.js';
import { initialSettings, type Reading, type Settings } from '../../web/figures/figure.js';
import { areaOf, largestHeight, radiusAt, waist } from '../../web/figures/soap-film/catenoid.js';
import { deviation, profile, figure as soapFilm } from '../../web/figures/soap-film/figure.js';
import { cylinderOf, relax, relaxBoth } from '../../web/figures/soap-film/film.js';
import {
  byDistance,
  byPlanes,
  cross,
  dot,
  eyeAt,
  type Face,
  type Line,
  length,
  mean,
  minus,
  type Piece,
  sum,
  times,
  unit,
  type Vec,
} from '../../web/figures/svg3d.js';
import { figure as vectorArea } from '../../web/figures/vector-area/figure.js';
import { type Kind, kinds, oneFace, polygon } from '../../web/figures/vector-area/polygons.js';

let client: Client;
beforeAll(async () => {
  client = await createClient();
});
afterAll(() => client.close());

const number = (readings: readonly Reading[], id: string): number => {
  const found = readings.find((reading) => reading.id === id);
  if (!found) throw new Error(`there is no reading ${id}`);
  return found.value;
};

describe('what is drawn of space', () => {
  const frame = { centre: [0, 0, 0], radius: 1, width: 300, height: 200 } as const;
  const face = (...points: Vec[]): Face => ({ kind: 'face', points });
  const line = (from: Vec, to: Vec): Line => ({ kind: 'line', points: [from, to], look: '' });

  it('shows the whole ball from everywhere', () => {
    for (let azimuth = -180; azimuth <= 180; azimuth += 30) {
      for (let elevation = -90; elevation <= 90; elevation += 30) {
        const eye = eyeAt([azimuth, elevation], frame);
        expect(length(cross(eye.right, eye.up))).toBeCloseTo(1, 12);
        expect(dot(cross(eye.right, eye.up), eye.toEye)).toBeCloseTo(1, 12);
        const [x, y] = eye.place(sum(eye.right, times(0.5, eye.toEye)));
        expect([x, y]).toEqual([expect.closeTo(250, 9), expect.closeTo(100, 9)]);
      }
    }
  });

  it('draws far pieces first', () => {
    const eye = eyeAt([0, 0], frame);
    const [far, near] = [face([0, 1, 0], [1, 1, 0], [0, 1, 1]), face([0, -1, 0], [1, -1, 0], [0, -1, 1])];
    expect(byDistance([near, far], eye)).toEqual([far, near]);
    expect(byDistance([near, far], eyeAt([180, 0], frame))).toEqual([near, far]);
  });

  it('cuts a line where it passes through a face, and hides what is behind', () => {
    const wall = face([-1, 0, -1], [1, 0, -1], [1, 0, 1], [-1, 0, 1]);
    const through = line([0, -0.5, 0], [0, 0.5, 0]);
    const drawn = byPlanes([through, wall], eyeAt([0, 0], frame));
    expect(drawn.map(({ kind, points }) => [kind, ...points])).toEqual([
      ['line', [0, 0, 0], [0, 0.5, 0]],
      ['face', ...wall.points],
      ['line', [0, -0.5, 0], [0, 0, 0]],
    ]);
  });

  it('cuts faces that pass through each other into parts of the same area, in an order that hides', () => {
    const wall = face([-1, 0, -1], [1, 0, -1], [1, 0, 1], [-1, 0, 1]);
    const floor = face([-1, -1, 0.2], [1, -1, 0.2], [1, 1, 0.2], [-1, 1, 0.2]);
    const area = ({ points }: Piece) =>
      length(points.map((p, k) => cross(p, points[(k + 1) % points.length] as Vec)).reduce(sum)) / 2;
    for (const view of [
      [20, 30],
      [200, -40],
      [90, 5],
    ] as const) {
      const eye = eyeAt(view, frame);
      const drawn = byPlanes([wall, floor], eye);
      expect(drawn.length).toBe(3);
      expect(drawn.reduce((all, piece) => all + area(piece), 0)).toBeCloseTo(8, 12);
      // Neither is cut by the other any more, so their middles are in order along the eye within a plane's two sides.
      const [first, , last] = drawn.map(({ points }) => mean(points)) as [Vec, Vec, Vec];
      expect(dot(minus(last, first), eye.toEye)).toBeGreaterThan(0);
    }
  });
});

const bare: OperatorSpec = { id: 'alexa-wardetzky', lambda: 0 };

describe('the vector area', () => {
  const ask = async (kind: Kind, height: number) => {
    const settings: Settings = { ...initialSettings(vectorArea), polygon: kind, height };
    const data = await vectorArea.compute(client, settings);
    return { data, readings: vectorArea.read(data, settings) };
  };
  const heights = [0, 0.05, 0.3, 0.6, 1];

  it('of the saddle is (0, 0, 1) whatever its height, and its surfaces grow', async () => {
    for (const h of heights) {
      const { data, readings } = await ask('saddle', h);
      expect(length(minus(data.vectorArea, [0, 0, 1]))).toBeLessThan(1e-12);
      expect(readings.find(({ id }) => id === 'vectorArea')?.text).toBe('(0.000, 0.000, 1.000)');
      expect(number(readings, 'size')).toBeCloseTo(1, 12);
      expect(number(readings, 'cut')).toBeCloseTo(Math.sqrt(1 + 2 * h * h), 12);
      expect(number(readings, 'fan')).toBeCloseTo(Math.sqrt(1 + h * h), 12);
      expect(number(readings, 'nonPlanarity')).toBeCloseTo(h / 2, 12);
      expect(number(readings, 'bare')).toBeCloseTo(0, 12);
      expect(number(readings, 'stabilised')).toBeCloseTo(2 * h, 12);
      expect(number(readings, 'planar')).toBeCloseTo(h, 12);
    }
  });

  it('leans away from a lifted corner', async () => {
    for (const h of heights) {
      const { data, readings } = await ask('corner', h);
      expect(length(minus(data.vectorArea, [-h / 2, -h / 2, 1]))).toBeLessThan(1e-12);
      expect(number(readings, 'size')).toBeCloseTo(Math.sqrt(1 + (h * h) / 2), 12);
    }
  });

  it('of the hexagon is (0, 0, 1), too', async () => {
    for (const h of heights) {
      const { data } = await ask('hexagon', h);
      expect(length(minus(data.vectorArea, [0, 0, 1]))).toBeLessThan(1e-12);
    }
  });

  it('has the gradient that the operator without stabiliser makes of the coordinates', async () => {
    for (const kind of kinds) {
      for (const h of heights) {
        const { data, readings } = await ask(kind, h);
        const { points, gradients } = data;
        expect(number(readings, 'sum')).toBeLessThan(1e-12);
        const size = async (moved: readonly Vec[]) => {
          const mesh = await client.fromArrays(oneFace(moved), 'moved');
          const { vectorArea: area } = await mesh.face(bare, 0);
          await mesh.close();
          return length(area);
        };
        const corner = 1;
        const by = 1e-5;
        for (const axis of [0, 1, 2]) {
          const moved = (sign: number) =>
            points.map(
              (p, k): Vec => (k === corner ? (p.map((c, a) => (a === axis ? c + sign * by : c)) as never) : p),
            );
          const slope = ((await size(moved(1))) - (await size(moved(-1)))) / (2 * by);
          expect(gradients[corner]?.[axis]).toBeCloseTo(slope, 8);
        }
        // ½ (xᵢ₊₁ − xᵢ₋₁) × a/|a|, as the figure's words have it.
        const u = unit(data.vectorArea);
        for (const [k, gradient] of gradients.entries()) {
          const across = minus(points[(k + 1) % points.length] as Vec, points.at(k - 1) as Vec);
          expect(length(minus(gradient, times(0.5, cross(across, u))))).toBeLessThan(1e-12);
        }
      }
    }
  });

  it('lets all three operators agree in the plane of the shadow', async () => {
    for (const kind of kinds) {
      const points = polygon(kind, 0.7);
      const mesh = await client.fromArrays(oneFace(points), 'polygon');
      const inPlane = async (spec: OperatorSpec) => {
        const { stiffness, normal } = await mesh.face(spec, 0);
        return points.map((_, i) => {
          const pull = points.map((p, j) => times(stiffness?.[i * points.length + j] ?? Number.NaN, p)).reduce(sum);
          return minus(pull, times(dot(pull, normal), normal));
        });
      };
      const [first, ...others] = await Promise.all(
        [bare, { id: 'alexa-wardetzky' } as const, { id: 'planar' } as const].map(inPlane),
      );
      for (const other of others)
        for (const [k, pull] of other.entries()) expect(length(minus(pull, first?.[k] as Vec))).toBeLessThan(1e-12);
      await mesh.close();
    }
  });

  it('stays in its picture from wherever it is seen', async () => {
    let [left, right, top, bottom] = [Infinity, -Infinity, Infinity, -Infinity];
    for (const kind of kinds) {
      for (const height of [0, 1]) {
        const { data } = await ask(kind, height);
        for (let azimuth = -180; azimuth < 180; azimuth += 30) {
          for (let elevation = -90; elevation <= 90; elevation += 15) {
            const drawing = vectorArea.draw(data, { view: [azimuth, elevation] }, (path) => path);
            for (const [, x, y] of drawing.matchAll(/[ML]([-\d.]+) ([-\d.]+)/g)) {
              [left, right] = [Math.min(left, Number(x)), Math.max(right, Number(x))];
              [top, bottom] = [Math.min(top, Number(y)), Math.max(bottom, Number(y))];
            }
            for (const [, points = ''] of drawing.matchAll(/points="([^"]*)"/g))
              for (const pair of points.split(' ')) {
                const [x, y] = pair.split(',').map(Number) as [number, number];
                [left, right] = [Math.min(left, x), Math.max(right, x)];
                [top, bottom] = [Math.min(top, y), Math.max(bottom, y)];
              }
          }
        }
      }
    }
    expect([left, top].every((least) => least >= 0)).toBe(true);
    expect([right <= 500, bottom <= 410]).toEqual([true, true]);
    // And uses most of it.
    expect(bottom - top).toBeGreaterThan(0.9 * 410);
  });

  it('hands the same polygon to the full page', () => {
    const settings = { ...initialSettings(vectorArea), polygon: 'hexagon', height: 0.4 };
    expect(vectorArea.state(settings).source).toEqual({ kind: 'file', name: 'polygon.obj', file: 0 });
    const rows = vectorArea.file?.(settings).trim().split('\n') ?? [];
    const points = rows.slice(0, -1).map((row) => row.split(' ').slice(1).map(Number));
    expect(points).toEqual(polygon('hexagon', 0.4));
    expect(rows.at(-1)).toBe('f 1 2 3 4 5 6');
  });
});

const operators = { a: { id: 'alexa-wardetzky' }, b: { id: 'planar' } } as const;

describe('the catenoid', () => {
  it('goes through both rings, and is the wide one', () => {
    for (const h of [0.01, 0.2, 0.5, 0.6, 0.66, 0.6627]) {
      const c = waist(h);
      expect(radiusAt(c, h)).toBeCloseTo(1, 12);
      // Where the two catenoids meet, h/c is 1.19968.
      expect(h / c).toBeLessThan(1.19968);
    }
    expect(waist(0.6628)).toBeNaN();
    const x = 1.1996786402577337;
    expect(x * Math.tanh(x)).toBeCloseTo(1, 12);
    expect(1 / Math.sinh(x)).toBeCloseTo(largestHeight, 9);
  });

  it('has as much area as two discs at h = 0.5277', () => {
    expect(areaOf(waist(0.5276), 0.5276)).toBeLessThan(2 * Math.PI);
    expect(areaOf(waist(0.5278), 0.5278)).toBeGreaterThan(2 * Math.PI);
    // And its area is that of a fine polygon turned about the axis.
    const [h, c, n] = [0.6, waist(0.6), 20000];
    let area = 0;
    for (let k = 0; k < n; k++) {
      const [z, next] = [h * ((2 * k) / n - 1), h * ((2 * (k + 1)) / n - 1)];
      const [r, s] = [radiusAt(c, z), radiusAt(c, next)];
      area += Math.PI * (r + s) * Math.hypot(next - z, s - r);
    }
    expect(areaOf(c, h)).toBeCloseTo(area, 7);
  });
});

describe('the soap film', () => {
  const ask = async (distance: number, steps: number) => {
    const settings: Settings = { ...initialSettings(soapFilm), distance, steps };
    const data = await soapFilm.compute(client, settings);
    return { data, readings: soapFilm.read(data, settings), settings };
  };

  it('takes steps that are harmonic interpolations of the coordinates', async () => {
    const h = 0.6;
    const mesh = await client.make(cylinderOf(h, { around: 24, along: 8 }));
    for (const spec of [operators.a, operators.b]) {
      await mesh.reset();
      const films = await relax(mesh, spec, 4, h, 'a');
      for (let step = 1; step < 4; step++) {
        const [from, to] = [films[step]?.coordinates, films[step + 1]?.coordinates] as [Float64Array, Float64Array];
        await mesh.restore({ coordinates: from, step }, { side: 'b' });
        for (const axis of [0, 1, 2]) {
          const fixed = { vertices: mesh.boundary, values: mesh.boundary.map(() => 0) as ArrayLike<number> };
          const values = Array.from(mesh.boundary, (v) => from[3 * v + axis] as number);
          const harmonic = await mesh.harmonic(spec, { ...fixed, values }, { side: 'b' });
          for (const [v, value] of harmonic.values.entries())
            expect(Math.abs(value - (to[3 * v + axis] as number))).toBeLessThan(1e-9);
        }
      }
    }
    await mesh.close();
  });

  it('comes to rest near the catenoid, and its area never grows', async () => {
    for (const h of [0.2, 0.4, 0.5, 0.6, 0.65]) {
      const { data, readings } = await ask(h, 60);
      expect(data.films.length).toBe(61);
      for (const [step, film] of data.films.entries())
        if (step > 0) expect(film.area).toBeLessThan((data.films[step - 1]?.area ?? 0) * (1 + 1e-12));
      expect(number(readings, 'deviation')).toBeLessThan(0.0021);
      expect(number(readings, 'area')).toBeLessThan(number(readings, 'catenoid'));
      expect(number(readings, 'area')).toBeGreaterThan(0.999 * number(readings, 'catenoid'));
      expect(number(readings, 'neck')).toBeCloseTo(number(readings, 'waist'), 2);
      expect(readings.some(({ bad }) => bad)).toBe(false);
    }
  });

  it('has as much area on itself as half its Dirichlet energy, with either operator', async () => {
    const h = 0.6;
    const mesh = await client.make(cylinderOf(h, { around: 24, along: 8 }));
    await relax(mesh, operators.b, 3, h, 'a');
    const { area } = await mesh.shape({ side: 'a' });
    for (const spec of [operators.a, operators.b])
      expect((await mesh.energy(spec, { side: 'a' })) / 2 / area).toBeCloseTo(1, 9);
    await mesh.close();
  });

  it('lies on the catenoid after 20 steps, as the words have it', async () => {
    const { readings } = await ask(0.6, 20);
    expect(number(readings, 'deviation').toFixed(4)).toBe('0.0012');
    const [before, after] = [await ask(0.52, 60), await ask(0.53, 60)];
    expect(number(before.readings, 'catenoid')).toBeLessThan(2 * Math.PI);
    expect(number(after.readings, 'catenoid')).toBeGreaterThan(2 * Math.PI);
    expect(number(after.readings, 'deviation')).toBeLessThan(0.001);
  });

  it('is four times nearer to it on twice the quads each way', async () => {
    const h = 0.6;
    const errors: number[] = [];
    for (const [around, along] of [
      [24, 6],
      [48, 12],
      [96, 24],
    ] as const) {
      const { films } = await relaxBoth(client, operators, { h, steps: 80, around, along });
      for (const side of ['a', 'b'] as const)
        if (side === 'b') errors.push(deviation(films[side].at(-1) as never, around, waist(h)));
    }
    const [coarse, middle, fine] = errors as [number, number, number];
    expect(coarse / middle).toBeGreaterThan(3.7);
    expect(coarse / middle).toBeLessThan(4.4);
    expect(middle / fine).toBeGreaterThan(3.7);
    expect(middle / fine).toBeLessThan(4.4);
  });

  it('is the same for both operators in the end, but for rings that slide along it', async () => {
    const [h, around] = [0.6, 24];
    const { films } = await relaxBoth(client, operators, { h, steps: 1500, around, along: 6 });
    const apart = (step: number) =>
      Math.max(
        ...Array.from(films.a[step]?.coordinates ?? [], (c, k) => Math.abs(c - (films.b[step]?.coordinates[k] ?? 0))),
      );
    expect(apart(1)).toBeGreaterThan(1e-3);
    expect(apart(60)).toBeGreaterThan(1e-5);
    expect(apart(1500)).toBeLessThan(1e-9);
    // Its quads stay flat trapezoids: rings are round and level.
    for (const { coordinates } of [films.a.at(60), films.b.at(60)].filter((film) => film !== undefined)) {
      const rings = profile({ coordinates, area: 0 }, around);
      for (let k = 0; k < coordinates.length; k += 3) {
        const [r, z] = rings[Math.floor(k / 3 / around)] as [number, number];
        expect(Math.hypot(coordinates[k] as number, coordinates[k + 1] as number)).toBeCloseTo(r, 9);
        expect(coordinates[k + 2]).toBeCloseTo(z, 9);
      }
    }
  });

  it('pinches off where there is no catenoid, and only there', async () => {
    const held = await ask(0.66, 60);
    expect(held.data.films.length).toBe(61);
    expect(number(held.readings, 'neck')).toBeGreaterThan(0.58);
    for (const [h, steps] of [
      [0.67, 52],
      [0.8, 12],
    ] as const) {
      const { data, readings } = await ask(h, 60);
      expect(data.films.length - 1).toBe(steps);
      expect(number(readings, 'neck')).toBeLessThan(1e-6);
      expect(readings.find(({ id }) => id === 'neck')?.bad).toBe(true);
      // Two discs with 48 corners and a thread.
      const discs = 48 * Math.sin((2 * Math.PI) / 48);
      expect(Math.abs(number(readings, 'area') - discs)).toBeLessThan(0.01);
      expect(number(readings, 'catenoid')).toBeNaN();
      expect(readings.find(({ id }) => id === 'catenoid')?.text).toBe('–');
    }
  });

  it('draws every quad and stays in its pictures', async () => {
    for (const distance of [0.2, 0.6, 0.8]) {
      const { data, settings } = await ask(distance, 8);
      for (const view of [
        [0, 0],
        [70, 90],
        [-160, -30],
      ] as const) {
        const [space = '', section = ''] = soapFilm.draw(data, { ...settings, view }, (path) => path).split('</svg>');
        expect(space.match(/tone-\d/g)?.length).toBe(48 * 12);
        const places = [...space.matchAll(/[ML]([-\d.]+) ([-\d.]+)/g)].flatMap(([, x, y]) => [Number(x), Number(y)]);
        expect(Math.min(...places)).toBeGreaterThanOrEqual(0);
        expect(Math.max(...places)).toBeLessThanOrEqual(360);
        expect(section.includes('labels.none')).toBe(distance > largestHeight);
      }
    }
  });
});
