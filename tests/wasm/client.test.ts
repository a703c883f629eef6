/** The asynchronous client, with the real core in a real worker thread. */
import { afterAll, afterEach, beforeAll, describe, expect, it } from 'vitest';
import { startClient, type WorkerLike } from '../../wasm/src/client.js';
import {
  type Client,
  type Mesh,
  type OperatorSpec,
  operators,
  PolylapError,
  type Smoothed,
} from '../../wasm/src/index.js';
import { load } from '../../wasm/src/node.js';
import { readMesh } from './native.js';
import { bundleWorker, ThreadWorker } from './thread.js';

let bundle: Awaited<ReturnType<typeof bundleWorker>>;
beforeAll(async () => {
  bundle = await bundleWorker();
});
afterAll(() => bundle.remove());

const aw: OperatorSpec = { id: 'alexa-wardetzky' };
const planar: OperatorSpec = { id: 'planar' };
const torus = { shape: 'torus', nu: 32, nv: 16, noise: 0.3, seed: 7 } as const;
/** Steps so small that the surface stands, and goes on standing: with large ones it soon has no area left. */
const endless = { time: 1e-9, steps: 1_000_000 };
/** One smoothing step on it takes longer than a cancellation is given. */
const big = { shape: 'grid', nx: 400, ny: 400, noise: 0.2 } as const;

let workers: ThreadWorker[] = [];
let client: Client | undefined;

async function start(): Promise<Client> {
  const worker = () => {
    workers.push(new ThreadWorker(bundle.file));
    return last();
  };
  client = await startClient({ worker });
  return client;
}

afterEach(() => {
  client?.close();
  workers = [];
});

const last = () => workers.at(-1) as ThreadWorker;

async function failure(promise: Promise<unknown>): Promise<PolylapError> {
  const error = await promise.then(
    () => undefined,
    (reason) => reason,
  );
  expect(error).toBeInstanceOf(PolylapError);
  return error;
}

async function until(condition: () => boolean, timeout = 10_000) {
  const end = performance.now() + timeout;
  while (!condition()) {
    if (performance.now() > end) throw new Error('waited too long');
    await new Promise((resolve) => setTimeout(resolve, 5));
  }
}

const textOf = (bytes: Uint8Array) => new TextDecoder().decode(bytes);
const coordinates = async (mesh: Mesh, side: 'a' | 'b' = 'a') => textOf(await mesh.file('obj', { side }));

describe('calls', () => {
  it('gives what the synchronous API gives', async () => {
    const { make, open } = await start().then((c) => ({ make: c.make.bind(c), open: c.open.bind(c) }));
    const polylap = await load();
    const bytes = readMesh('saddle-12x12.obj');
    const session = polylap.open(bytes, 'saddle.obj');
    const mesh = await open(bytes, 'saddle.obj');
    expect(mesh).toMatchObject({ name: 'saddle.obj', ...session.info() });
    expect(mesh.geometry).toEqual(session.geometry());
    expect(await mesh.weights(aw)).toEqual(session.weights(aw));
    expect(await mesh.shape()).toEqual(session.shape());
    expect(await mesh.matrices(planar)).toEqual(session.matrices(planar));
    const fixed = { vertices: [0, 5, 100], values: [0, 1, 2.5] };
    expect(await mesh.harmonic(aw, fixed)).toEqual(session.harmonic(aw, fixed));
    expect(await mesh.check(aw)).toEqual(session.check(aw));
    expect(await mesh.dual({ mu: 0.5 })).toEqual(session.dual({ mu: 0.5 }));
    expect(await mesh.file('ply')).toEqual(session.file('ply'));
    const options = { time: 0.01, steps: 3 };
    expect(await mesh.smooth(aw, options)).toEqual(session.smooth(aw, options));
    expect(await mesh.file('obj')).toEqual(session.file('obj'));
    expect(await mesh.file('obj', { side: 'b' })).toEqual(session.file('obj', { side: 'b' }));
    await mesh.reset();
    session.reset();
    expect(await mesh.file('obj')).toEqual(session.file('obj'));
    expect((await make(torus)).geometry).toEqual(polylap.make(torus).geometry());
  });

  it('opens bytes, buffers, blobs and text', async () => {
    const { open } = await start().then((c) => ({ open: c.open.bind(c) }));
    const text = readMesh('grid-2x2.obj').toString();
    const bytes = new TextEncoder().encode(text);
    for (const input of [bytes, bytes.buffer as ArrayBuffer, new Blob([text]), text]) {
      expect((await open(input, 'a.obj')).vertices).toBe(9);
    }
    expect(bytes.length).toBe(text.length);
  });

  it('opens with repair', async () => {
    const { open } = await start().then((c) => ({ open: c.open.bind(c) }));
    const twice = `${readMesh('grid-2x2.obj')}\nf 1 2 5 4\nf 1 1 2\n`;
    expect((await failure(open(twice, 'twice.obj'))).code).toBe('bad-mesh');
    const { faces, repairs } = await open(twice, 'twice.obj', { repair: true });
    expect(faces).toBe(4);
    expect(repairs.changes.map(({ kind }) => kind)).toContain('degenerate-faces');
    expect(repairs.originalFaces).toEqual(Int32Array.of(0, 1, 2, 3));
  });

  it('converts a side to a mesh of its own', async () => {
    const c = await start();
    const polylap = await load();
    const [mesh, session] = [await c.make(torus), polylap.make(torus)];
    await mesh.smooth(aw, { time: 0.01 }, { side: 'b' });
    session.smooth(aw, { time: 0.01 }, { side: 'b' });
    const made = await mesh.convert({ conversion: 'quads' }, { side: 'b' });
    const theirs = session.convert({ conversion: 'quads' }, { side: 'b' });
    expect(made).toMatchObject({ name: 'quads of torus', ...theirs.info(), geometry: theirs.geometry() });
    await mesh.close();
    expect(await made.file('obj')).toEqual(theirs.file('obj'));
    expect((await failure(made.convert({ conversion: 'gold' } as never))).code).toBe('bad-argument');
  });

  it('takes weights of vertices and leaves them to the caller', async () => {
    const mesh = await (await start()).make({ shape: 'ico-sphere' });
    const session = (await load()).make({ shape: 'ico-sphere' });
    for (const { id } of operators.filter(({ takesVertexWeights }) => takesVertexWeights)) {
      const vertexWeights = Float64Array.from({ length: mesh.vertices }, (_, v) => 0.01 * Math.cos(v));
      const spec = { id, vertexWeights } as OperatorSpec;
      const expected = session.matrices(spec);
      const waiting = mesh.matrices(spec);
      expect(vertexWeights.length).toBe(mesh.vertices);
      vertexWeights.fill(7);
      expect(await waiting).toEqual(expected);
      vertexWeights[3] = Number.NaN;
      expect(await failure(mesh.matrices(spec))).toMatchObject({ code: 'bad-argument', element: 3 });
    }
  });

  it('studies convergence', async () => {
    const c = await start();
    const fractions: number[] = [];
    const studies = await c.convergence(planar, { onProgress: (fraction) => fractions.push(fraction) });
    expect(studies).toEqual((await load()).convergence(planar));
    expect(fractions).toEqual([...fractions].sort((a, b) => a - b));
    expect(fractions.length).toBeGreaterThan(0);
    expect(await failure(c.convergence(planar, { signal: AbortSignal.abort() }))).toMatchObject({ code: 'cancelled' });
  });

  it('hands over code, message, element and line, and keeps the meshes', async () => {
    const c = await start();
    const mesh = await c.make(torus);
    const error = await failure(c.open('v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 4\n', 'broken.obj'));
    expect(error).toMatchObject({ code: 'parse-error', element: 0, line: 4 });
    expect(error.message).toContain('4');
    expect((await mesh.weights(aw)).negativeOrdered).toBe(2048);
    expect(workers.length).toBe(1);
  });

  it('refuses arguments that cannot be sent, and goes on', async () => {
    const mesh = await (await start()).make(torus);
    const error = await failure(mesh.weights({ id: 'planar', rule: (() => 1) as never }));
    expect(error.code).toBe('bad-argument');
    expect((await mesh.weights(planar)).negativeOrdered).toBe(0);
  });

  it('keeps two meshes and two sides apart', async () => {
    const c = await start();
    const [one, two] = await Promise.all([c.make(torus), c.make({ shape: 'saddle', n: 6 })]);
    const before = await Promise.all([coordinates(one, 'b'), coordinates(two)]);
    const smoothed = await one.smooth(aw, { time: 0.01 });
    expect(smoothed.step).toBe(1);
    expect(await Promise.all([coordinates(one, 'b'), coordinates(two)])).toEqual(before);
    expect((await one.smooth(planar, { time: 0.01 }, { side: 'b' })).step).toBe(1);
    await one.reset('a');
    expect((await one.smooth(aw, { time: 0.01 })).coordinates).toEqual(smoothed.coordinates);
    expect((await one.smooth(planar, { time: 0.01 }, { side: 'b' })).step).toBe(2);
  });

  it('answers nothing for a closed mesh, nor after closing the client', async () => {
    const c = await start();
    const mesh = await c.make(torus);
    await mesh.close();
    expect((await failure(mesh.shape())).code).toBe('bad-argument');
    const other = await c.make(torus);
    const waiting = [failure(other.shape()), failure(other.file('obj'))];
    c.close();
    for (const error of await Promise.all(waiting)) expect(error.code).toBe('cancelled');
    expect((await failure(c.make(torus))).code).toBe('cancelled');
    expect(last().terminated).toBe(true);
  });
});

describe('order, progress and steps', () => {
  it('runs one request after the other, in the order of the calls', async () => {
    const mesh = await (await start()).make(torus);
    const order: string[] = [];
    const note = (name: string) => (value: unknown) => {
      order.push(name);
      return value;
    };
    const results = await Promise.all([
      mesh.smooth(aw, { time: 0.01, steps: 5 }).then(note('smooth')),
      mesh.shape().then(note('shape')),
      mesh.reset().then(note('reset')),
      mesh.shape().then(note('shape again')),
    ]);
    expect(order).toEqual(['smooth', 'shape', 'reset', 'shape again']);
    expect((results[1] as { area: number }).area).not.toBe((results[3] as { area: number }).area);
  });

  it('shows each step', async () => {
    const mesh = await (await start()).make(torus);
    const steps: Smoothed[] = [];
    const final = await mesh.smooth(aw, { time: 0.01, steps: 4 }, { onStep: (smoothed) => steps.push(smoothed) });
    expect(steps.map(({ step }) => step)).toEqual([1, 2, 3, 4]);
    expect(steps[3]).toBe(final);
    const areas = steps.map(({ stats }) => stats.area);
    expect(areas).toEqual([...areas].sort((a, b) => b - a));
  });

  it('reports progress of long calls, rising in [0, 1]', async () => {
    const mesh = await (await start()).make({ ...big, nx: 200, ny: 200 });
    const smoothing: number[] = [];
    await mesh.smooth(aw, { time: 1e-5, steps: 4 }, { onProgress: (fraction) => smoothing.push(fraction) });
    expect(smoothing.length).toBeGreaterThan(3);
    const weighing: number[] = [];
    await mesh.weights({ id: 'alexa-wardetzky', lambda: 2 }, { onProgress: (fraction) => weighing.push(fraction) });
    expect(weighing.length).toBeGreaterThan(0);
    for (const fractions of [smoothing, weighing]) {
      expect(fractions).toEqual([...fractions].sort((a, b) => a - b));
      expect(Math.min(...fractions)).toBeGreaterThanOrEqual(0);
      expect(Math.max(...fractions)).toBeLessThanOrEqual(1);
    }
  });
});

describe('cancelling', () => {
  it('never starts what was aborted before', async () => {
    const mesh = await (await start()).make(torus);
    const before = last().sent.length;
    const error = await failure(mesh.smooth(aw, { time: 0.01 }, { signal: AbortSignal.abort() }));
    expect(error.code).toBe('cancelled');
    const late = new AbortController();
    const running = mesh.smooth(aw, { time: 0.01 });
    const waiting = failure(mesh.smooth(aw, { time: 0.01 }, { signal: late.signal }));
    late.abort();
    expect((await waiting).code).toBe('cancelled');
    expect((await running).step).toBe(1);
    expect((await mesh.smooth(aw, { time: 0.01 })).step).toBe(2);
    expect(last().sent.length - before).toBe(2);
  });

  it('stops smoothing between steps and leaves the surface as it was', async () => {
    const mesh = await (await start()).make(torus);
    await mesh.smooth(aw, { time: 0.01, steps: 2 });
    const before = await coordinates(mesh);
    const abort = new AbortController();
    const steps: number[] = [];
    const onStep = ({ step }: Smoothed) => {
      steps.push(step);
      if (step === 4) abort.abort();
    };
    const error = await failure(mesh.smooth(aw, endless, { signal: abort.signal, onStep }));
    expect(error.code).toBe('cancelled');
    expect(steps).toEqual([3, 4]);
    expect(await coordinates(mesh)).toBe(before);
    expect((await mesh.smooth(aw, { time: 0.01 })).step).toBe(3);
    expect(workers.length).toBe(1);
  });

  it('takes back what was finished when the cancellation came', async () => {
    const c = await start();
    const mesh = await c.make(torus);
    const before = await coordinates(mesh);
    const abort = new AbortController();
    const cancelled = failure(mesh.smooth(aw, { time: 0.01 }, { signal: abort.signal }));
    abort.abort();
    expect((await cancelled).code).toBe('cancelled');
    expect(await coordinates(mesh)).toBe(before);
    expect((await mesh.smooth(aw, { time: 0.01 })).step).toBe(1);
    const again = new AbortController();
    const opening = failure(c.open(readMesh('grid-2x2.obj'), 'a.obj', { signal: again.signal }));
    await until(() => last().sent.length > 5);
    again.abort();
    expect((await opening).code).toBe('cancelled');
    await mesh.shape();
    expect(last().sent.at(-2)).toMatchObject({ request: { call: 'close' } });
    expect(workers.length).toBe(1);
  });

  it('makes nothing that is no longer wanted', async () => {
    const c = await start();
    const mesh = await c.make(torus);
    const [making, converting] = [new AbortController(), new AbortController()];
    const refused = [
      failure(c.make(torus, { signal: making.signal })),
      failure(mesh.convert({ conversion: 'dual' }, { signal: converting.signal })),
    ];
    making.abort();
    await until(() => last().sent.some((sent) => sent.kind === 'request' && sent.request.call === 'convert'));
    converting.abort();
    for (const { code } of await Promise.all(refused)) expect(code).toBe('cancelled');
    await mesh.shape();
    // Each was closed again in the worker, by the number it had there.
    const closed = last().sent.flatMap((sent) =>
      sent.kind === 'request' && sent.request.call === 'close' ? [sent.request.takes.mesh] : [],
    );
    expect(closed).toEqual([1, 2]);
    expect(workers.length).toBe(1);
  });

  it('ends a worker that does not stop, and goes on with everything as it was', async () => {
    const c = await start();
    const reasons: string[] = [];
    c.onRestart = (reason) => reasons.push(reason);
    const saddle = await c.open(readMesh('saddle-12x12.obj'), 'saddle.obj');
    const mesh = await c.make(big);
    await saddle.smooth(aw, { time: 0.01, steps: 3 });
    await saddle.smooth(planar, { time: 0.02, steps: 2 }, { side: 'b' });
    const dual = await saddle.convert({ conversion: 'dual' }, { side: 'b' });
    const before = [await coordinates(saddle, 'a'), await coordinates(saddle, 'b'), await coordinates(dual)];

    const abort = new AbortController();
    const cancelled = failure(mesh.smooth(aw, { time: 1, steps: 1 }, { signal: abort.signal }));
    const queued = [coordinates(saddle, 'a'), coordinates(saddle, 'b'), coordinates(dual)];
    await until(() => last().sent.at(-1)?.kind === 'request');
    await new Promise((resolve) => setTimeout(resolve, 20));
    const aborted = performance.now();
    abort.abort();
    expect((await cancelled).code).toBe('cancelled');
    const waited = performance.now() - aborted;
    expect(waited).toBeGreaterThan(250);
    expect(waited).toBeLessThan(1500);

    expect(await Promise.all(queued)).toEqual(before);
    expect(workers.length).toBe(2);
    expect(workers[0]?.terminated).toBe(true);
    expect(reasons).toEqual(['cancelled']);
    expect((await saddle.smooth(aw, { time: 0.01 })).step).toBe(4);
    expect((await saddle.smooth(planar, { time: 0.01 }, { side: 'b' })).step).toBe(3);
    expect((await mesh.smooth(aw, { time: 1e-6 })).step).toBe(1);
  });
});

describe('a worker that dies', () => {
  it('is started again; only the request under way is lost', async () => {
    const c = await start();
    const reasons: string[] = [];
    c.onRestart = (reason) => reasons.push(reason);
    const mesh = await c.make(torus);
    const { coordinates: before } = await mesh.smooth(aw, { time: 0.01, steps: 2 });
    const kept = before.slice();
    before.fill(0); // The caller's array is the caller's: the client has its own.
    const running = failure(mesh.smooth(aw, endless));
    const queued = mesh.smooth(planar, { time: 1e-30 });
    await until(() => last().received.some(({ kind }) => kind === 'progress'));
    last().crash();
    expect(await running).toMatchObject({ code: 'worker-failed' });
    const { step, coordinates: after } = await queued;
    expect(step).toBe(3);
    for (const [k, value] of after.entries()) expect(value).toBeCloseTo(kept[k] as number, 12);
    expect(workers.length).toBe(2);
    expect(reasons).toEqual(['the worker failed: the thread ended']);
  });

  it('is started again after a failure of its own, and after a message that cannot be read', async () => {
    const c = await start();
    const mesh = await c.make(torus);
    last().say({ kind: 'failed', message: 'unreachable' });
    expect((await mesh.weights(aw)).negativeOrdered).toBe(2048);
    last().onmessageerror?.();
    expect((await mesh.weights(aw)).negativeOrdered).toBe(2048);
    expect(workers.length).toBe(3);
  });

  it('is given up after failing three times at once, with the reason', async () => {
    const made: string[] = [];
    const worker = () => {
      made.push('worker');
      const fake = new FakeWorker();
      setTimeout(() => fake.onerror?.({ message: 'no such file' }));
      return fake;
    };
    const error = await failure(startClient({ worker }));
    expect(error).toMatchObject({ code: 'worker-failed', message: 'the worker failed: no such file' });
    expect(made.length).toBe(3);
    const thrown = startClient({
      worker: () => {
        throw new Error('workers are forbidden here');
      },
    });
    expect((await failure(thrown)).message).toContain('workers are forbidden here');
  });

  it('fails all requests once it is given up', async () => {
    const c = await start();
    const mesh = await c.make(torus);
    for (let k = 0; k < 3; ++k) {
      last().say({ kind: 'failed', message: 'out of luck' });
      await until(() => k === 2 || last().received.some(({ kind }) => kind === 'ready'));
    }
    expect(await failure(mesh.shape())).toMatchObject({
      code: 'worker-failed',
      message: 'the worker failed: out of luck',
    });
    expect(last().terminated).toBe(true);
    expect(workers.length).toBe(3);
  });
});

class FakeWorker implements WorkerLike {
  onmessage = null;
  onerror: ((event: { message: string }) => void) | null = null;
  onmessageerror = null;
  postMessage() {}
  terminate() {}
}
