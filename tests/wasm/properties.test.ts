/** Properties measured, studies of convergence, and weights of vertices. */
import { describe, expect, it } from 'vitest';
import { load, type OperatorSpec, operators, properties } from '../../wasm/src/node.js';
import { failure, sum } from './help.js';

const polylap = await load();
const specOf = (id: string, more: object = {}) => ({ id, ...more }) as OperatorSpec;
const aw = (lambda = 1) => specOf('alexa-wardetzky', { lambda });

describe('check', () => {
  it('counts as weights do, and names the worst pair', () => {
    const torus = polylap.make({ shape: 'torus', nu: 32, nv: 16, noise: 0.3, seed: 1 });
    const [check, weights] = [torus.check(aw()), torus.weights(aw())];
    expect(check).toMatchObject({ negativeOrdered: 2048, negativePairs: 1024, components: 1, kernelDimension: 1 });
    const worst = check.measurements.find(({ property }) => property === 'positiveWeights');
    expect(worst).toMatchObject({ verdict: 'fails' });
    const at = weights.values.indexOf(weights.smallest);
    expect([...(worst?.vertices ?? [])].sort((p, q) => p - q)).toEqual([...weights.pairs.slice(2 * at, 2 * at + 2)]);
  });

  it('finds the constants in the kernel, and with λ = 0 more', () => {
    const grid = polylap.make({ shape: 'grid', nx: 4, ny: 4 });
    const check = grid.check(aw());
    expect(check.kernelModes.map(({ length }) => length)).toEqual([25]);
    const [mode] = check.kernelModes as [Float64Array];
    for (const value of mode) expect(Math.abs(value)).toBeCloseTo(1 / 5, 9);
    expect(Math.abs(check.smallestEigenvalue)).toBeLessThan(1e-9 * check.largestEigenvalue);
    expect(check.condition).toBeGreaterThan(1);
    // λ = 0 sees no mode that alternates along rows or columns: it leaves two more.
    const bare = grid.check(aw(0));
    expect(bare.kernelDimension).toBeGreaterThan(1);
    expect(bare.kernelModes.length).toBe(bare.kernelDimension);
    for (const [k, one] of bare.kernelModes.entries())
      for (const [l, two] of bare.kernelModes.entries())
        expect(sum(one.map((value, v) => value * (two[v] as number)))).toBeCloseTo(k === l ? 1 : 0, 8);
  });

  it.each(operators)('of $id measures all properties but convergence, in the order of the table', ({ id }) => {
    const sphere = polylap.make({ shape: 'ico-sphere' });
    const { measurements, smallestMass, smallestMassVertex } = sphere.check(specOf(id));
    const known = properties.map(({ id: property }) => property).filter((property) => property !== 'convergent');
    expect(measurements.map(({ property }) => property)).toEqual(known);
    for (const { verdict, value, text } of measurements) {
      expect(['holds', 'fails', 'not-measured']).toContain(verdict);
      expect(text).not.toBe('');
      if (verdict !== 'not-measured') expect(value).toBeGreaterThanOrEqual(0);
    }
    expect(Number.isFinite(smallestMass)).toBe(true);
    expect(smallestMassVertex).toBeLessThan(sphere.info().vertices);
  });

  // On a mesh of triangles in a plane every claim but `no` must hold, and each property can be measured.
  it.each(operators)('of $id finds on flat triangles what it claims', ({ id, claims }) => {
    const flat = polylap.make({ shape: 'skew-grid' }).convert({ conversion: 'triangles' });
    for (const { property, verdict, text } of flat.check(specOf(id)).measurements)
      if (claims[property].where !== 'no') expect([property, verdict, text]).toEqual([property, 'holds', text]);
  });

  it('stops when told', () => {
    const grid = polylap.make({ shape: 'grid', nx: 20, ny: 20 });
    const fractions: number[] = [];
    expect(grid.check(aw(), { onProgress: (fraction) => fractions.push(fraction) > 0 }).kernelDimension).toBe(1);
    expect(fractions.length).toBeGreaterThan(1);
    const stopped = polylap.make({ shape: 'grid', nx: 20, ny: 20 });
    expect(failure(() => stopped.check(aw(), { onProgress: () => false })).code).toBe('cancelled');
  });
});

describe('convergence', () => {
  it('is found where it is claimed, and stops when told', () => {
    const studies = polylap.convergence(specOf('planar'));
    expect(studies.length).toBeGreaterThan(3);
    for (const { levels, order, converges, failure: why } of studies) {
      expect(levels.length).toBeGreaterThan(1);
      expect(levels[0]?.order).toBeNaN();
      expect(levels.at(-1)?.order).toBe(order);
      expect([converges, why]).toEqual([true, '']);
    }
    let told = 0;
    const onProgress = () => ++told < 3;
    expect(failure(() => polylap.convergence(specOf('planar'), { onProgress })).code).toBe('cancelled');
    expect(failure(() => polylap.convergence(specOf('best'))).code).toBe('unknown-operator');
  });
});

describe('weights of vertices', () => {
  const taking = operators.filter(({ takesVertexWeights }) => takesVertexWeights);
  const others = operators.filter(({ takesVertexWeights }) => !takesVertexWeights);
  const sphere = polylap.make({ shape: 'ico-sphere', noise: 0.1 });
  const count = sphere.info().vertices;
  const some = Float64Array.from({ length: count }, (_, v) => 0.01 * Math.sin(v));
  const weighted = (id: string, vertexWeights: unknown) => specOf(id, { vertexWeights });

  it('are taken by some operators and not by others', () => {
    expect(taking.length).toBeGreaterThan(0);
    expect(others.length).toBeGreaterThan(0);
  });

  it.each(taking)('$id: none are zeros, any kind of array will do, and they matter', ({ id }) => {
    const plain = sphere.matrices(specOf(id));
    expect(sphere.matrices(weighted(id, new Float64Array(count)))).toEqual(plain);
    expect(sphere.matrices(weighted(id, undefined))).toEqual(plain);
    const moved = sphere.matrices(weighted(id, some));
    expect(moved.stiffness.values).not.toEqual(plain.stiffness.values);
    expect(sphere.matrices(weighted(id, [...some]))).toEqual(moved);
    expect(sphere.matrices(weighted(id, Object.assign({ length: count }, some)))).toEqual(moved);
    expect(sphere.matrices(specOf(id))).toEqual(plain);
  });

  it.each(taking)('$id: they are copied, and refused by the number of the vertex', ({ id }) => {
    const mine = some.slice();
    sphere.matrices(weighted(id, mine));
    expect(mine).toEqual(some);
    const error = (values: unknown) => failure(() => sphere.matrices(weighted(id, values)));
    expect(error(some.slice(1))).toMatchObject({ code: 'bad-argument' });
    expect(error(some.map((value, v) => (v === 7 ? Number.NaN : value)))).toMatchObject({
      code: 'bad-argument',
      element: 7,
    });
    const texts = [...some].map((value, v) => (v === 5 ? 'heavy' : value));
    expect(error(texts)).toMatchObject({ code: 'bad-argument', element: 5 });
    expect(error(texts).message).toContain('vertex 5');
    for (const nonsense of [null, 5, 'heavy', {}, { length: -1 }]) expect(error(nonsense).code).toBe('bad-argument');
  });

  it.each(others)('$id refuses them', ({ id }) => {
    expect(failure(() => sphere.matrices(weighted(id, some))).code).toBe('bad-argument');
  });
});
