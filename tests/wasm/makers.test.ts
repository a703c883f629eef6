/** Shapes, conversions and the orthogonal dual: every line of the tables, and numbers known by hand. */
import { describe, expect, it } from 'vitest';
import {
  type ConversionSpec,
  conversions,
  load,
  type OperatorSpec,
  operators,
  type Parameter,
  type Session,
  type ShapeSpec,
  shapes,
} from '../../wasm/src/node.js';
import { failure, sum } from './help.js';

const polylap = await load();
const spec = (tag: string, id: string, settings: object = {}) => ({ [tag]: id, ...settings });
const shape = (id: string, settings?: object) => spec('shape', id, settings) as unknown as ShapeSpec;
const conversion = (id: string, settings?: object) => spec('conversion', id, settings) as unknown as ConversionSpec;
const defaults = (parameters: readonly Parameter[]) => Object.fromEntries(parameters.map((p) => [p.id, p.initial]));

function meshOf(session: Session) {
  const { offsets, corners } = session.geometry();
  const told = { offsets, corners, coordinates: session.surface().coordinates };
  session.close();
  return told;
}

describe('shapes', () => {
  it.each(shapes)('$id is what its defaults say', ({ id, parameters }) => {
    const mesh = meshOf(polylap.make(shape(id)));
    expect(mesh.offsets.length).toBeGreaterThan(1);
    expect(mesh.coordinates.every(Number.isFinite)).toBe(true);
    expect(meshOf(polylap.make(shape(id, defaults(parameters))))).toEqual(mesh);
  });

  it.each(shapes)('$id takes every operator', ({ id }) => {
    const mesh = polylap.make(shape(id));
    const { vertices, meanSquaredEdge } = mesh.info();
    for (const info of operators) {
      const operator = { id: info.id } as OperatorSpec;
      const { negativeOrdered, nonzeroOrdered } = mesh.weights(operator);
      if (info.claims.positiveWeights.where === 'yes') expect(negativeOrdered).toBe(0);
      expect(nonzeroOrdered).toBeGreaterThan(0);
      expect(mesh.check(operator).negativeOrdered).toBe(negativeOrdered);
      const { coordinates } = mesh.smooth(operator, { time: 0.01 * meanSquaredEdge });
      expect(coordinates).toHaveLength(3 * vertices);
      expect(coordinates.every(Number.isFinite)).toBe(true);
      mesh.reset();
    }
    mesh.close();
  });

  it.each(shapes)('$id refuses what its parameters do not allow, by name', ({ id, parameters }) => {
    expect(failure(() => polylap.make(shape(id, { bogus: 1 })))).toMatchObject({ code: 'bad-argument' });
    for (const parameter of parameters) {
      const wrong = parameter.kind === 'choice' ? 'bogus' : parameter.max + 1;
      const error = failure(() => polylap.make(shape(id, { [parameter.id]: wrong })));
      expect(error.code).toBe(parameter.kind === 'choice' ? 'bad-argument' : 'parameter-out-of-range');
      expect(error.message).toContain(parameter.id);
      if (parameter.kind !== 'integer') continue;
      const half = failure(() => polylap.make(shape(id, { [parameter.id]: parameter.min + 0.5 })));
      expect(half.message).toContain('whole');
    }
  });

  it.each(shapes.filter(({ parameters }) => parameters.some(({ id }) => id === 'seed')))(
    '$id is another with another seed',
    ({ id }) => {
      const made = (seed: number) => meshOf(polylap.make(shape(id, { seed })));
      expect(made(2)).toEqual(made(2));
      expect(made(2)).not.toEqual(made(3));
    },
  );

  it('take noise and its seed', () => {
    const made = (settings: object) => meshOf(polylap.make(shape('saddle', { n: 4, ...settings }))).coordinates;
    expect(made({ noise: 0, seed: 5 })).toEqual(made({}));
    expect(made({ noise: 0.2 })).toEqual(made({ noise: 0.2, seed: 1 }));
    expect(made({ noise: 0.2, seed: 5 })).not.toEqual(made({ noise: 0.2 }));
    const noisy = polylap.make(shape('saddle', { n: 4 })).convert(conversion('noise', { amplitude: 0.2, seed: 5 }));
    expect(meshOf(noisy).coordinates).toEqual(made({ noise: 0.2, seed: 5 }));
  });
});

describe('conversions', () => {
  it.each(conversions)('$id makes a mesh of a torus, as its defaults say, and refuses others by name', (info) => {
    const torus = polylap.make({ shape: 'torus', nu: 8, nv: 6 });
    const before = torus.surface();
    const mesh = meshOf(torus.convert(conversion(info.id)));
    expect(mesh.offsets.length).toBeGreaterThan(40);
    expect(meshOf(torus.convert(conversion(info.id, defaults(info.parameters))))).toEqual(mesh);
    expect(failure(() => torus.convert(conversion(info.id, { bogus: 1 }))).code).toBe('bad-argument');
    expect(torus.surface()).toEqual(before);
    torus.close();
  });

  it('count as they must', () => {
    const torus = polylap.make({ shape: 'torus', nu: 8, nv: 6 });
    const counts = (id: string) => {
      const made = torus.convert(conversion(id));
      const { vertices, faces, minCorners, maxCorners } = made.info();
      made.close();
      return [vertices, faces, minCorners, maxCorners];
    };
    expect(counts('dual')).toEqual([48, 48, 4, 4]);
    expect(counts('quads')).toEqual([48 + 96 + 48, 4 * 48, 4, 4]);
    expect(counts('triangles')).toEqual([48, 96, 3, 3]);
    expect(torus.convert(conversion('triangles')).convert(conversion('pair-triangles')).info()).toMatchObject({
      vertices: 48,
      faces: 48,
    });
  });

  it('start from the surface of the side that is named', () => {
    const torus = polylap.make({ shape: 'torus', nu: 8, nv: 6 });
    const { stats } = torus.smooth({ id: 'planar' }, { time: 0.05 }, { side: 'b' });
    const area = (side: 'a' | 'b') => torus.convert(conversion('noise', { amplitude: 0 }), { side }).shape().area;
    expect(area('b')).toBe(stats.area);
    expect(area('a')).toBe(torus.shape().area);
    expect(stats.area).toBeLessThan(torus.shape().area);
  });

  it('outlive what they were made of', () => {
    const torus = polylap.make({ shape: 'torus', nu: 8, nv: 6 });
    const dual = torus.convert(conversion('dual'));
    torus.close();
    expect(dual.weights({ id: 'planar' }).nonzeroOrdered).toBeGreaterThan(0);
  });
});

describe('the orthogonal dual', () => {
  it('of four squares is known by hand', () => {
    const grid = polylap.make({ shape: 'grid', nx: 2, ny: 2, width: 2, height: 2 });
    const dual = grid.dual();
    const centres = [0.5, 0.5, 0, 1.5, 0.5, 0, 0.5, 1.5, 0, 1.5, 1.5, 0];
    expect([...dual.coordinates]).toEqual(centres.map((x) => expect.closeTo(x, 12)));
    // Relative to the origin, the centre (1, 1, 0).
    expect([...dual.positions]).toEqual(centres.map((x, k) => expect.closeTo(k % 3 === 2 ? x : x - 1, 6)));
    expect(dual.weights.length).toBe(12);
    expect([dual.edgeVertices.length, dual.edgeFaces.length, dual.edgePoints.length, dual.lengths.length]).toEqual([
      24, 24, 36, 24,
    ]);
    for (const [e, weight] of dual.weights.entries()) {
      const faces = [...dual.edgeFaces.slice(2 * e, 2 * e + 2)];
      expect(weight).toBeCloseTo(0.5 * faces.filter((face) => face >= 0).length, 12);
      for (const [k, face] of faces.entries()) expect(dual.lengths[2 * e + k]).toBeCloseTo(face >= 0 ? 0.5 : 0, 12);
    }
    expect(dual).toMatchObject({ constraints: 4, rank: 4, nullSpace: 8, usable: true });
    expect(dual.residual).toBeLessThan(1e-12);
    expect(dual.largestShift).toBeLessThan(1e-12);
  });

  it('is orthogonal on a torus, and with μ a compromise nearer to the barycentres', () => {
    const torus = polylap.make({ shape: 'torus', nu: 16, nv: 8, noise: 0.1 });
    const [exact, compromise] = [torus.dual(), torus.dual({ mu: 0.1 })];
    expect(exact.residual).toBeLessThan(1e-8);
    expect(compromise.residual).toBeGreaterThan(100 * exact.residual);
    expect(compromise.largestShift).toBeLessThan(exact.largestShift);
    expect(exact.coordinates.length).toBe(3 * 128);
    expect(exact.rank + exact.nullSpace).toBe(3 * 128);
  });

  it('is that of the side’s surface', () => {
    const torus = polylap.make({ shape: 'torus', nu: 16, nv: 8 });
    const before = torus.dual({}, { side: 'b' });
    torus.smooth({ id: 'planar' }, { time: 0.01 }, { side: 'b' });
    expect(torus.dual()).toEqual(before);
    expect(torus.dual({}, { side: 'b' })).not.toEqual(before);
    expect(sum(before.lengths)).toBeGreaterThan(0);
  });

  it('refuses a μ below 0', () => {
    const grid = polylap.make({ shape: 'grid', nx: 2, ny: 2 });
    expect(failure(() => grid.dual({ mu: -1 })).code).toBe('parameter-out-of-range');
  });
});
