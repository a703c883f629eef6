/** Callers in plain JavaScript make mistakes: each is refused in words, and costs neither the worker nor the module. */
import { afterAll, beforeAll, beforeEach, describe, expect, it } from 'vitest';
import { startClient } from '../../wasm/src/client.js';
import type { Client, Mesh, Smoothed } from '../../wasm/src/index.js';
import { load, type OperatorSpec, PolylapError } from '../../wasm/src/node.js';
import { readMesh } from './native.js';
import { bundleWorker, ThreadWorker } from './thread.js';

const polylap = await load();
const aw = { id: 'alexa-wardetzky' } as const;
const torus = { shape: 'torus', nu: 12, nv: 8, noise: 0.3, seed: 7 } as const;
const time = { time: 0.01 };
const text = readMesh('grid-2x2.obj').toString();
// biome-ignore lint/suspicious/noExplicitAny: what is tried here is what types forbid.
type Any = any;

const thrower = () => {
  throw new RangeError('mine');
};
const specOf = (lambda: unknown) => ({ id: 'alexa-wardetzky', lambda });
const withGetter = Object.defineProperty({ id: 'alexa-wardetzky' }, 'lambda', { get: thrower, enumerable: true });

/** Mistakes that both APIs must refuse; `it` is a Session or a Mesh. */
const onMesh: [string, (it: Any) => unknown][] = [
  ['smooth without options', (it) => it.smooth(aw)],
  ['smooth with null', (it) => it.smooth(aw, null)],
  ['smooth with 5', (it) => it.smooth(aw, 5)],
  ['smooth with a rebuild that is text', (it) => it.smooth(aw, { time: 1, rebuild: 'no' })],
  ['smooth with an unknown flow', (it) => it.smooth(aw, { time: 1, flow: 'upwards' })],
  ['smooth with a volume kept that is a number', (it) => it.smooth(aw, { time: 1, keepVolume: 1 })],
  ['smooth with a boundary fixed that is text', (it) => it.smooth(aw, { time: 1, fixBoundary: 'yes' })],
  ['stability with null', (it) => it.stability(aw, null)],
  ['stability with a rebuild that is text', (it) => it.stability(aw, { rebuild: 'no' })],
  ['smooth without an operator', (it) => it.smooth(undefined, time)],
  ['harmonic without fixed values', (it) => it.harmonic(aw)],
  ['harmonic with {}', (it) => it.harmonic(aw, {})],
  ['harmonic with vertices null', (it) => it.harmonic(aw, { vertices: null, values: [] })],
  ['harmonic with one vertex', (it) => it.harmonic(aw, { vertices: 5, values: [1] })],
  ['harmonic with bigints', (it) => it.harmonic(aw, { vertices: [0], values: [1n] })],
  ['harmonic with objects', (it) => it.harmonic(aw, { vertices: [0], values: [{}] })],
  ['harmonic with a length of -1', (it) => it.harmonic(aw, { vertices: { length: -1 }, values: [] })],
  ['options null', (it) => it.weights(aw, null)],
  ['options 5', (it) => it.weights(aw, 5)],
  ['shape on side null', (it) => it.shape({ side: null })],
  ['onProgress that is text', (it) => it.weights(aw, { onProgress: 'go on' })],
  ['an array as a parameter', (it) => it.weights(specOf([2]))],
  ['a bigint as a parameter', (it) => it.weights(specOf(2n))],
  ['an object as a parameter', (it) => it.weights(specOf({ valueOf: () => 2 }))],
  ['null as a parameter', (it) => it.weights(specOf(null))],
  ['a boolean as a parameter', (it) => it.weights(specOf(true))],
  ['a symbol as a parameter', (it) => it.weights(specOf(Symbol('two')))],
  ['a getter that throws', (it) => it.weights(withGetter)],
  ['weights of vertices that are text', (it) => it.weights({ ...aw, vertexWeights: 'heavy' })],
  ['a weight of a vertex that is text', (it) => it.weights({ ...aw, vertexWeights: ['heavy'] })],
  ['weights of vertices for an operator without', (it) => it.weights({ ...aw, vertexWeights: Array(96).fill(0) })],
  ['check without an operator', (it) => it.check()],
  ['row without a vertex', (it) => it.row(aw)],
  ['row of a vertex that is text', (it) => it.row(aw, '7')],
  ['face of half a number', (it) => it.face(aw, 0.5)],
  ['spectrum of no eigenvalues', (it) => it.spectrum(aw, 0)],
  ['spectrum of half an eigenvalue', (it) => it.spectrum(aw, 1.5)],
  ['energy without an operator', (it) => it.energy()],
  ['dual with options 5', (it) => it.dual(5)],
  ['dual with a mu that is text', (it) => it.dual({ mu: 'much' })],
  ['file without a format', (it) => it.file()],
  ['file of an unknown format', (it) => it.file('gltf')],
  ['convert to nothing', (it) => it.convert()],
  ['convert to what there is not', (it) => it.convert({ conversion: 'gold' })],
  ['convert with a rule that is an array', (it) => it.convert({ conversion: 'triangles', rule: [] })],
  ['convert with an unknown parameter', (it) => it.convert({ conversion: 'dual', size: 5 })],
  ['a side that is an object', (it) => it.reset(Object.create(null))],
];

/** `it` is a Polylap or a Client. */
const onLibrary: [string, (it: Any) => unknown][] = [
  ['open without a name', (it) => it.open(text)],
  ['open with the name 5', (it) => it.open(text, 5)],
  ['open nothing', (it) => it.open(undefined, 'a.obj')],
  ['open floats', (it) => it.open(new Float32Array(4), 'a.obj')],
  ['open a view', (it) => it.open(new DataView(new ArrayBuffer(4)), 'a.obj')],
  ['open with options null', (it) => it.open(text, 'a.obj', null)],
  ['open with a repair that is text', (it) => it.open(text, 'a.obj', { repair: 'yes' })],
  ['open with a distance that is text', (it) => it.open(text, 'a.obj', { repair: true, mergeDistance: 'far' })],
  ['convergence of nothing', (it) => it.convergence()],
  ['convergence with options null', (it) => it.convergence(aw, null)],
  ['make nothing', (it) => it.make(undefined)],
  ['make null', (it) => it.make(null)],
  ['make a shape that is a number', (it) => it.make({ shape: 5 })],
  ['make a torus of text', (it) => it.make({ shape: 'torus', nu: 'many' })],
  ['make a torus of arrays', (it) => it.make({ shape: 'torus', nu: [8] })],
];

function expectRefusal(error: unknown) {
  expect(error).toBeInstanceOf(PolylapError);
  expect(error).toMatchObject({ code: 'bad-argument' });
  // In words about the argument, not those of a failed look-up in our own code.
  expect((error as Error).message).not.toMatch(/undefined \(reading|not iterable|BindingError|not a function$/);
}

function thrownBy(work: () => unknown): unknown {
  try {
    work();
  } catch (error) {
    return error;
  }
  throw new Error('nothing was thrown');
}

describe('the synchronous API refuses', () => {
  const session = polylap.make(torus);
  const before = session.surface();

  it.each(onMesh)('%s', (_, work) => {
    expectRefusal(thrownBy(() => work(session)));
    expect(session.surface()).toEqual(before);
  });

  it.each(onLibrary)('%s', (_, work) => expectRefusal(thrownBy(() => work(polylap))));

  it.each([{ step: 0 }, { step: 0, coordinates: null }, { step: 0, coordinates: 'far away' }, null])(
    'to restore %o',
    (saved) => expectRefusal(thrownBy(() => session.restore(saved as Any))),
  );

  it('a buffer that has been given away, but opens one that has not', () => {
    const { buffer } = new TextEncoder().encode(text);
    expect(polylap.open(buffer as ArrayBuffer, 'a.obj').info().vertices).toBe(9);
    structuredClone(buffer, { transfer: [buffer as ArrayBuffer] });
    expectRefusal(thrownBy(() => polylap.open(buffer as ArrayBuffer, 'a.obj')));
  });
});

describe('a session whose call is running', () => {
  const uses: [string, (session: Any) => unknown][] = [
    ['close', (session) => session.close()],
    ['info', (session) => session.info()],
    ['smooth', (session) => session.smooth(aw, time)],
    ['stability', (session) => session.stability(aw)],
    ['weights', (session) => session.weights({ id: 'planar' })],
    ['reset', (session) => session.reset()],
    ['restore', (session) => session.restore(before)],
  ];
  const before = polylap.make(torus).surface();

  it.each(uses)('refuses %s, and is as it was', (_, use) => {
    const session = polylap.make(torus);
    const error = thrownBy(() => session.smooth(aw, { ...time, steps: 3 }, { onProgress: () => use(session) as Any }));
    expectRefusal(error);
    expect((error as Error).message).toContain('busy');
    expect(session.surface()).toEqual(before);
    session.close();
  });

  it('leaves other sessions free', () => {
    const [one, two] = [polylap.make(torus), polylap.make(torus)];
    const areas: number[] = [];
    one.smooth(aw, time, { onProgress: () => areas.push(two.smooth(aw, time).stats.area) > 0 });
    expect(areas.length).toBeGreaterThan(0);
    two.close();
    expect(one.surface().step).toBe(1);
  });
});

describe('the client', () => {
  let bundle: Awaited<ReturnType<typeof bundleWorker>>;
  let client: Client;
  let mesh: Mesh;
  const workers: ThreadWorker[] = [];
  const uncaught: unknown[] = [];

  beforeAll(async () => {
    bundle = await bundleWorker();
    const worker = () => {
      const made = new ThreadWorker(bundle.file);
      workers.push(made);
      return made;
    };
    client = await startClient({ worker });
    mesh = await client.make(torus);
    process.on('uncaughtException', note);
  });
  afterAll(() => {
    process.off('uncaughtException', note);
    client.close();
    bundle.remove();
  });
  beforeEach(() => mesh.reset());
  const note = (error: unknown) => uncaught.push(error);

  async function rejection(work: () => unknown): Promise<unknown> {
    // What is thrown instead of rejected is a failure of the test.
    const promise = work() as Promise<unknown>;
    return promise.then(
      () => {
        throw new Error('nothing was refused');
      },
      (error) => error,
    );
  }

  const mistakes: [string, () => unknown][] = [
    ...onMesh.map(([name, work]): [string, () => unknown] => [name, () => work(mesh)]),
    ...onLibrary.map(([name, work]): [string, () => unknown] => [name, () => work(client)]),
    ['a signal that is none', () => mesh.weights(aw, { signal: 5 as Any })],
    ['onStep that is text', () => mesh.smooth(aw, time, { onStep: 'show' as Any })],
  ];
  it.each(mistakes)('rejects %s, and its worker lives on', async (_, work) => {
    expectRefusal(await rejection(work));
    expect((await mesh.shape()).area).toBe(polylap.make(torus).shape().area);
    expect(workers.length).toBe(2);
  });

  it('takes arguments as they are when it is called', async () => {
    const session = polylap.make(torus);
    const spec: OperatorSpec = { id: 'alexa-wardetzky', lambda: 2 };
    const fixed = { vertices: [0, 5, 50], values: [0, 1, 2] };
    const options = { time: 0.01, steps: 2 };
    const run = { side: 'b' as 'a' | 'b' };
    const buffer = Buffer.from(text);
    const harmonic = session.harmonic(spec, fixed);
    const { coordinates } = session.smooth(spec, options);

    const waiting = mesh.smooth(aw, { time: 0.01, steps: 20 });
    const [function_, surface, opened] = [
      mesh.harmonic(spec, fixed, run),
      mesh.smooth(spec, options, run),
      client.open(buffer, 'a.obj'),
    ];
    spec.lambda = -5;
    fixed.values[1] = 99;
    fixed.vertices.push(7);
    options.steps = 0;
    run.side = 'a';
    buffer.fill(0);
    await waiting;
    expect(await function_).toEqual(harmonic);
    expect((await surface).coordinates).toEqual(coordinates);
    expect((await opened).vertices).toBe(9);
  });

  it.each<[string, (mine: Error) => Record<string, unknown>, number]>([
    ['onProgress', (mine) => ({ onProgress: throwing(mine) }), 1_000_000],
    ['onStep', (mine) => ({ onStep: throwing(mine) }), 1_000_000],
    ['the last onStep', (mine) => ({ onStep: ({ step }: Smoothed) => step === 3 && throwing(mine)() }), 3],
  ])('ends a request whose %s throws, with what was thrown', async (_, callbacks, steps) => {
    const before = await mesh.file('obj');
    const mine = new TypeError('mine');
    const smoothing = rejection(() => mesh.smooth(aw, { time: 1e-9, steps }, callbacks(mine)));
    const next = mesh.file('obj');
    expect(await smoothing).toBe(mine);
    expect(await next).toEqual(before);
    expect((await mesh.smooth(aw, time)).step).toBe(1);
    expect(workers.length).toBe(2);
    expect(uncaught).toEqual([]);
  });
  const throwing = (error: Error) => () => {
    throw error;
  };
});
