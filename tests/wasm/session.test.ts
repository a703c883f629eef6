/** The synchronous API: numbers known by hand, refusals, and who owns what. */
import { describe, expect, it } from 'vitest';
import { load, type OperatorSpec, type Polylap, type Session } from '../../wasm/src/node.js';
import { failure } from './help.js';
import { readMesh } from './native.js';

const polylap = await load();
const aw = (lambda?: number): OperatorSpec => ({ id: 'alexa-wardetzky', ...(lambda !== undefined && { lambda }) });
const planar: OperatorSpec = { id: 'planar' };

describe('numbers', () => {
  it('finds 2048 negative ordered pairs with Alexa–Wardetzky on the noisy torus, none with the planar operator', () => {
    const session = polylap.make({ shape: 'torus', nu: 32, nv: 16, noise: 0.3, seed: 1 });
    expect(session.info()).toMatchObject({
      vertices: 512,
      faces: 512,
      edges: 1024,
      components: 1,
      minCorners: 4,
      maxCorners: 4,
    });
    const weights = session.weights(aw());
    expect(weights.negativeOrdered).toBe(2048);
    expect(weights.pairs.length).toBe(2048);
    expect(weights.values.length).toBe(1024);
    expect(Math.max(...weights.values)).toBeLessThan(0);
    expect(Math.min(...weights.values)).toBe(weights.smallest);
    expect(weights.segments.length).toBe(6 * weights.segmentPairs.length);
    expect(weights.segmentStarts.length).toBe(weights.segmentPairs.length);
    expect(new Set(weights.segmentPairs).size).toBe(1024);
    expect(session.weights(planar, { side: 'b' }).negativeOrdered).toBe(0);
  });

  it.each([
    [aw(), 4 / 3],
    [aw(0.5), 1],
    [aw(2), 1.6],
    [planar, 1],
  ])('interpolates the centre of 2×2 unit quads with %o', (spec, centre) => {
    const session = polylap.make({ shape: 'grid', nx: 2, ny: 2, width: 2, height: 2 });
    const vertices = [0, 1, 2, 3, 5, 6, 7, 8];
    const { values, min, max, fixedMin, fixedMax, outside } = session.harmonic(spec, {
      vertices,
      values: [0, 1, 0, 1, 1, 0, 1, 0],
    });
    expect(values[4]).toBeCloseTo(centre, 12);
    expect([fixedMin, fixedMax, min]).toEqual([0, 1, 0]);
    expect(max).toBeCloseTo(Math.max(centre, 1), 12);
    expect([...outside]).toEqual(centre > 1.001 ? [4] : []);
  });

  it('moves a surface in three steps as in three times one, and back', () => {
    const make = () => polylap.make({ shape: 'torus', nu: 8, nv: 6, noise: 0.2, seed: 3 });
    const [one, three] = [make(), make()];
    for (let k = 0; k < 3; ++k) one.smooth(aw(), { time: 0.02 });
    const at = three.smooth(aw(), { time: 0.02, steps: 3 });
    expect(one.surface()).toEqual(at);
    expect(at.step).toBe(3);
    expect(at.stats.area).toBeLessThan(make().shape().area);
    three.reset();
    expect(three.surface()).toEqual(make().surface());
    three.restore(at);
    expect(three.surface()).toEqual({ ...at, solve: null });
    expect(three.smooth(aw(), { time: 0.02 }).coordinates).toEqual(one.smooth(aw(), { time: 0.02 }).coordinates);
  });

  it('keeps far meshes sharp in float by their origin', () => {
    const text = 'v 1e7 0 0\nv 10000001 0 0\nv 10000001 1 0\nv 1e7 1 0\nf 1 2 3 4\n';
    const { origin, positions } = polylap.open(text, 'far.obj').geometry();
    expect(origin).toEqual([10000000.5, 0.5, 0]);
    expect([...positions]).toEqual([-0.5, -0.5, 0, 0.5, -0.5, 0, 0.5, 0.5, 0, -0.5, 0.5, 0]);
  });

  it('describes connectivity, boundary, triangles and polygon edges', () => {
    const session = polylap.make({ shape: 'grid', nx: 2, ny: 2 });
    const { offsets, corners, triangles, triangleEdges, triangleFaces } = session.geometry();
    expect([...offsets]).toEqual([0, 4, 8, 12, 16]);
    expect([...corners.slice(0, 4)]).toEqual([0, 1, 4, 3]);
    expect([...session.info().boundary]).toEqual([0, 1, 2, 3, 5, 6, 7, 8]);
    expect(triangles.length).toBe(24);
    expect([...triangleFaces]).toEqual([0, 0, 1, 1, 2, 2, 3, 3]);
    const bits = (mask: number) => (mask & 1) + ((mask >> 1) & 1) + ((mask >> 2) & 1);
    expect([...triangleEdges].map(bits)).toEqual([2, 2, 2, 2, 2, 2, 2, 2]);
    expect(session.shape()).toMatchObject({ area: 1, volume: null, meanNonPlanarity: 0, meanSquaredEdge: 0.25 });
    expect(session.shape().noVolume).not.toBe('');
  });

  it('reports what is odd about a mesh', () => {
    const session = polylap.open('v 0 0 0\nv 1 0 0\nv 0 1 0\nv 5 5 5\nf 1 2 3\n', 'odd.obj');
    expect(session.info().issues).toMatchObject([{ kind: 'unreferenced-vertices', count: 1 }]);
    const { values } = session.harmonic(planar, { vertices: [0], values: [2] });
    expect([...values]).toEqual([2, 2, 2, Number.NaN].map((x, k) => (k === 3 ? Number.NaN : expect.closeTo(x, 12))));
  });

  it('writes what it reads, digit for digit', () => {
    const bytes = readMesh('quad-torus-32x16-noisy.obj');
    const first = polylap.open(bytes, 'a.obj');
    const second = polylap.open(first.file('obj'), 'b.obj');
    expect(second.surface().coordinates).toEqual(first.surface().coordinates);
    expect(second.geometry().corners).toEqual(first.geometry().corners);
  });
});

describe('refusals', () => {
  it.each([
    ['v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 4\n', 'parse-error', 0, 4],
    ['v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2\n', 'bad-mesh', 0, 4],
    ['v 0 0 0\nv 1 nan 0\nv 0 1 0\nf 1 2 3\n', 'parse-error', 1, 2],
    ['# nothing\n', 'parse-error', -1, -1],
  ])('of %j name code, element and line', (text, code, element, line) => {
    const error = failure(() => polylap.open(text, 'broken.obj'));
    expect(error).toMatchObject({ name: 'PolylapError', code, element, line });
    expect(error.message).not.toBe('');
  });

  const session = polylap.make({ shape: 'grid', nx: 3, ny: 3 });
  const anything = (value: unknown) => value as never;
  it.each<[string, string, () => unknown]>([
    ['an unknown ending', 'bad-argument', () => polylap.open('', 'mesh.xyz')],
    ['an unknown operator', 'unknown-operator', () => session.weights(anything({ id: 'best' }))],
    ['no operator', 'bad-argument', () => session.weights(anything(undefined))],
    ['no operator id', 'unknown-operator', () => session.weights(anything({}))],
    ['an unknown parameter', 'bad-argument', () => session.weights(anything({ id: 'planar', lambda: 1 }))],
    ['a parameter out of range', 'parameter-out-of-range', () => session.weights(aw(-1))],
    ['no number', 'bad-argument', () => session.weights(anything({ id: 'alexa-wardetzky', lambda: 'much' }))],
    ['an unknown choice', 'bad-argument', () => session.weights(anything({ id: 'planar', rule: 'best' }))],
    ['a side c', 'bad-argument', () => session.shape({ side: anything('c') })],
    ['no time', 'bad-argument', () => session.smooth(aw(), anything({}))],
    ['time 0', 'bad-argument', () => session.smooth(aw(), { time: 0 })],
    ['time NaN', 'bad-argument', () => session.smooth(aw(), { time: Number.NaN })],
    ['no steps', 'bad-argument', () => session.smooth(aw(), { time: 1, steps: 0 })],
    ['half a step', 'bad-argument', () => session.smooth(aw(), { time: 1, steps: 1.5 })],
    ['nothing fixed', 'unconstrained-component', () => session.harmonic(aw(), { vertices: [], values: [] })],
    ['more vertices than values', 'bad-argument', () => session.harmonic(aw(), { vertices: [0, 1], values: [1] })],
    ['a vertex 1.5', 'bad-argument', () => session.harmonic(aw(), { vertices: [1.5], values: [1] })],
    ['a vertex 2³²', 'bad-argument', () => session.harmonic(aw(), { vertices: [2 ** 32], values: [1] })],
    ['a vertex that is not there', 'bad-argument', () => session.harmonic(aw(), { vertices: [16], values: [1] })],
    ['a vertex twice', 'bad-argument', () => session.harmonic(aw(), { vertices: [1, 1], values: [1, 1] })],
    ['an infinite value', 'bad-argument', () => session.harmonic(aw(), { vertices: [1], values: [Infinity] })],
    ['too few coordinates', 'bad-argument', () => session.restore({ coordinates: new Float64Array(3), step: 1 })],
    ['two thirds of a point', 'bad-argument', () => session.restore({ coordinates: new Float64Array(47), step: 1 })],
    ['a coordinate NaN', 'bad-mesh', () => session.restore({ coordinates: new Float64Array(48).fill(NaN), step: 1 })],
    ['an unknown shape', 'bad-argument', () => polylap.make(anything({ shape: 'teapot' }))],
    ['a torus of nothing', 'parameter-out-of-range', () => polylap.make({ shape: 'torus', nu: 0, nv: 0 })],
    ['a seed below 0', 'bad-argument', () => polylap.make({ shape: 'grid', nx: 1, ny: 1, seed: -1 })],
  ])('%s', (_, code, work) => {
    const error = failure(work);
    expect(error.code).toBe(code);
    expect(error.message).not.toBe('');
    expect(session.surface()).toEqual(polylap.make({ shape: 'grid', nx: 3, ny: 3 }).surface());
  });

  it('name the face without area', () => {
    const flat = polylap.open('v 0 0 0\nv 1 0 0\nv 0 1 0\nv 2 0 0\nf 1 2 3\nf 1 2 4\n', 'flat.obj');
    expect(failure(() => flat.weights(aw()))).toMatchObject({ code: 'degenerate-face', element: 1 });
  });

  it('of a mesh too large end in out-of-memory, and the module stays usable', () => {
    // A star, so that it has no triangulation to look for; its matrix has 20 000² entries.
    const count = 20_000;
    const corners = Array.from({ length: count }, (_, k) => (k * 7001) % count);
    const points = corners.map((k) => [Math.cos((2 * Math.PI * k) / count), Math.sin((2 * Math.PI * k) / count)]);
    const vertices = points.map(([x, y]) => `v ${x} ${y} 0\n`).join('');
    const star = polylap.open(`${vertices}f ${corners.map((_, k) => k + 1).join(' ')}\n`, 'star.obj');
    expect(failure(() => star.matrices(aw())).code).toBe('out-of-memory');
    star.close();
    expect(polylap.make({ shape: 'grid', nx: 1, ny: 1 }).info().faces).toBe(1);
  });
});

describe('a face of 1000 corners', () => {
  const count = 1000;
  const corners = Array.from({ length: count }, (_, k) => {
    const angle = (2 * Math.PI * k) / count;
    return `v ${Math.cos(angle)} ${Math.sin(angle)} ${0.05 * Math.cos(3 * angle)}\n`;
  });
  const face = Array.from({ length: count }, (_, k) => k + 1).join(' ');
  const session = polylap.open(`${corners.join('')}f ${face}\n`, 'large.obj');
  const area = Math.PI;

  it('has its weights counted in full and drawn within bounds', () => {
    const weights = session.weights(aw());
    expect(weights.nonzeroOrdered).toBeGreaterThan(0.9 * count * (count - 1));
    expect(weights.negativeOrdered).toBe(2 * weights.values.length);
    expect(weights.values.length).toBeGreaterThan(count);
    expect(weights.segmentPairs.length).toBeGreaterThanOrEqual(400_000);
    expect(weights.segmentPairs.length).toBeLessThanOrEqual(401_000);
    expect(Math.max(...new Set(weights.segmentPairs))).toBeLessThan(weights.values.length);
    expect(weights.segments.every(Number.isFinite)).toBe(true);
  });

  it.each([aw(), planar])('is smoothed with %o', (spec) => {
    session.reset();
    const { step, stats, solve } = session.smooth(spec, { time: 0.01 });
    expect(solve).toEqual({ solver: 'cholesky', iterations: 0 });
    expect(step).toBe(1);
    expect(stats.area).toBeGreaterThan(0.5 * area);
    expect(stats.area).toBeLessThan(area);
  });

  it.each([aw(), planar])('carries a harmonic function of %o', (spec) => {
    session.reset();
    const { values } = session.harmonic(spec, { vertices: [0, 500], values: [0, 1] });
    expect([values[0], values[500]]).toEqual([0, 1]);
    // The polygon is its own mirror image, and so is what is fixed on it.
    for (let k = 1; k < 500; k += 7) expect(values[k]).toBeCloseTo(values[count - k] as number, 6);
    expect(values[250]).toBeGreaterThan(0);
    expect(values[250]).toBeLessThan(1);
  });
});

describe('progress', () => {
  const make = () => polylap.make({ shape: 'torus', nu: 8, nv: 6 });

  it('stops when told, and changes nothing', () => {
    const session = make();
    const error = failure(() => session.smooth(aw(), { time: 0.1, steps: 5 }, { onProgress: (f) => f < 0.5 }));
    expect(error.code).toBe('cancelled');
    expect(session.surface()).toEqual(make().surface());
  });

  it('lets errors of the callback through as they are', () => {
    const session = make();
    const mine = new TypeError('mine');
    const onProgress = () => {
      throw mine;
    };
    expect(() => session.smooth(aw(), { time: 0.1, steps: 5 }, { onProgress })).toThrow(mine);
    expect(session.surface()).toEqual(make().surface());
  });
});

it('gives arrays that outlive the session and the growth of memory', () => {
  const session = polylap.make({ shape: 'grid', nx: 20, ny: 20 });
  const arrays = (of: Session) => [
    of.geometry().positions,
    of.surface().coordinates,
    of.matrices(aw()).stiffness.values,
  ];
  const kept = arrays(session);
  const copies = kept.map((array) => array.slice());
  session.close();
  const large = polylap.make({ shape: 'grid', nx: 700, ny: 700 });
  expect(kept).toEqual(copies);
  large.close();
});

it('says so when it is used after closing', () => {
  const session = polylap.make({ shape: 'grid', nx: 1, ny: 1 });
  session.close();
  session.close();
  expect(failure(() => session.shape()).code).toBe('bad-argument');
});

it('frees its memory', () => {
  const before = heapAfterRounds(polylap, 20);
  expect(heapAfterRounds(polylap, 60)).toBe(before);
});

/** How far the heap reaches after opening and closing meshes again and again. */
function heapAfterRounds(module: Polylap, rounds: number): number {
  for (let k = 0; k < rounds; ++k) {
    const session = module.make({ shape: 'grid', nx: 150, ny: 150 });
    session.weights(aw());
    session.close();
  }
  return module.memory();
}
