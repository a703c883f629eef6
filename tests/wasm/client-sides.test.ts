/** Two workers: what is done on one side does not wait for the other, nor suffer with it. */
import { readFileSync } from 'node:fs';
import { expect, it } from 'vitest';
import { type OperatorSpec, operators } from '../../wasm/src/index.js';
import { load } from '../../wasm/src/node.js';
import type { FromWorker } from '../../wasm/src/protocol.js';
import { aw, big, coordinates, endless, failure, planar, requests, torus, until, useClients } from './client-help.js';

const { start, worker, workers } = useClients();

it('works on both sides at the same time', async () => {
  const mesh = await (await start()).make(torus);
  const [abortA, abortB] = [new AbortController(), new AbortController()];
  const order: string[] = [];
  // Each goes on until the other has been seen at work: one after the other, neither would ever end.
  const run = (name: string, mine: AbortController, others: AbortController) => ({
    signal: mine.signal,
    onStep: () => {
      order.push(name);
      if (order.includes('a') && order.includes('b')) for (const each of [mine, others]) each.abort();
    },
  });
  const settled = await Promise.all([
    failure(mesh.smooth(aw, endless, { side: 'a', ...run('a', abortA, abortB) })),
    failure(mesh.smooth(planar, endless, { side: 'b', ...run('b', abortB, abortA) })),
  ]);
  expect(settled.map(({ code }) => code)).toEqual(['cancelled', 'cancelled']);
  expect(new Set(order)).toEqual(new Set(['a', 'b']));
  expect([workers('a').length, workers('b').length]).toEqual([1, 1]);
});

it('brings a mesh to the other side when something is asked about it there, once', async () => {
  const c = await start();
  const mesh = await c.make(torus);
  await mesh.shape();
  expect(requests(worker('b'))).toEqual([]);
  const there = await coordinates(mesh, 'b');
  expect(there).toBe(await coordinates(mesh, 'a'));
  await mesh.weights(planar, { side: 'b' });
  expect(requests(worker('b'))).toEqual(['adopt', 'file', 'weights']);
  expect(requests(worker('a'))).toEqual(['open', 'shape', 'file']);
});

it('gives the same on both sides, of meshes with any faces', async () => {
  const c = await start();
  const mesh = await c.make({ shape: 'hexagon-sphere', noise: 0.05, seed: 3 });
  const dual = await mesh.convert({ conversion: 'quads' }, { side: 'b' });
  for (const each of [mesh, dual]) {
    const [a, b] = await Promise.all([
      each.smooth(aw, { time: 1e-3, steps: 2 }, { side: 'a' }),
      each.smooth(aw, { time: 1e-3, steps: 2 }, { side: 'b' }),
    ]);
    expect(b).toEqual(a);
    expect(await each.matrices(planar, { side: 'b' })).toEqual(await each.matrices(planar, { side: 'a' }));
  }
  // Made by the worker of side b, it came to that of side a.
  expect(requests(worker('a'))).toEqual(expect.arrayContaining(['adopt']));
});

it('leaves side b alone when side a is cancelled by force', async () => {
  const c = await start();
  const told: [string, string][] = [];
  c.onRestart = (reason, side) => told.push([reason, side]);
  const mesh = await c.make(big);
  const small = await c.make(torus);
  await small.smooth(aw, { time: 0.01, steps: 2 });
  await small.smooth(planar, { time: 0.01, steps: 3 }, { side: 'b' });
  const before = await Promise.all([coordinates(small, 'a'), coordinates(small, 'b')]);
  const abort = new AbortController();
  const cancelled = failure(mesh.smooth(aw, { time: 1 }, { signal: abort.signal }));
  const steps: number[] = [];
  const endB = new AbortController();
  const running = failure(
    small.smooth(planar, endless, { side: 'b', signal: endB.signal, onStep: ({ step }) => steps.push(step) }),
  );
  await until(() => requests(worker('a')).at(-1) === 'smooth' && steps.length > 0);
  abort.abort();
  expect((await cancelled).code).toBe('cancelled');
  const seen = steps.length;
  await until(() => told.length > 0 && steps.length > seen);
  expect(told).toEqual([['cancelled', 'a']]);
  endB.abort();
  await running;
  expect(await Promise.all([coordinates(small, 'a'), coordinates(small, 'b')])).toEqual(before);
  expect([workers('a').length, workers('b').length]).toEqual([2, 1]);
});

it('leaves side a alone when the worker of side b dies', async () => {
  const c = await start();
  const told: [string, string][] = [];
  c.onRestart = (reason, side) => told.push([reason, side]);
  const mesh = await c.make(torus);
  const { coordinates: stood } = await mesh.smooth(planar, { time: 0.01 }, { side: 'b' });
  const kept = stood.slice();
  const lost = failure(mesh.smooth(planar, endless, { side: 'b' }));
  const other = mesh.smooth(aw, { time: 0.01, steps: 3 });
  await until(() => worker('b').received.some(({ kind }) => kind === 'progress'));
  worker('b').crash();
  expect(await lost).toMatchObject({ code: 'worker-failed' });
  expect((await other).step).toBe(3);
  const { coordinates: after, step } = await mesh.smooth(planar, { time: 1e-30 }, { side: 'b' });
  expect(step).toBe(2);
  for (const [k, value] of after.entries()) expect(value).toBeCloseTo(kept[k] as number, 12);
  expect([workers('a').length, workers('b').length]).toEqual([1, 2]);
  expect(told).toEqual([['the worker failed: the thread ended', 'b']]);
});

it('opens a mesh on the other side when one is at work', async () => {
  const c = await start();
  const mesh = await c.make(torus);
  await until(() => worker('b').received.some(({ kind }) => kind === 'ready'));
  const abort = new AbortController();
  const running = failure(mesh.smooth(aw, endless, { signal: abort.signal }));
  const second = await c.make({ shape: 'saddle', n: 6 });
  expect(requests(worker('b'))).toEqual(['open']);
  abort.abort();
  await running;
  expect(await coordinates(second, 'a')).toBe(await coordinates(second, 'b'));
  expect(requests(worker('a'))).toEqual(['open', 'smooth', 'adopt', 'file']);
});

it('resets and closes a mesh wherever it is, and nowhere else', async () => {
  const c = await start();
  const mesh = await c.make(torus);
  const before = await coordinates(mesh);
  await mesh.smooth(aw, { time: 0.01 });
  await mesh.reset();
  expect(requests(worker('b'))).toEqual([]);
  await mesh.smooth(aw, { time: 0.01 });
  await mesh.smooth(aw, { time: 0.01 }, { side: 'b' });
  const waiting = mesh.smooth(aw, { time: 0.01 }, { side: 'b' });
  await mesh.reset();
  await waiting;
  expect([await coordinates(mesh, 'a'), await coordinates(mesh, 'b')]).toEqual([before, before]);
  const late = mesh.shape({ side: 'b' });
  await mesh.close();
  await mesh.close();
  expect((await late).area).toBeGreaterThan(0);
  expect((await failure(mesh.shape({ side: 'b' }))).code).toBe('bad-argument');
  for (const side of ['a', 'b'] as const)
    expect(requests(worker(side)).filter((call) => call === 'close').length).toBe(1);
});

it('brings a mesh anew where what was cancelled too late could not be undone', async () => {
  const mesh = await (await start()).make(torus);
  const before = await coordinates(mesh);
  worker().say({ kind: 'error', id: 1e9, error: { code: 'out-of-memory', message: 'no', element: -1, line: -1 } });
  expect(await coordinates(mesh)).toBe(before);
  expect(requests(worker())).toEqual(['open', 'file', 'adopt', 'file']);
});

const fileOf = (whole: boolean) =>
  readFileSync(new URL(`../../build/wasm/polylap${whole ? '' : '-core'}.wasm`, import.meta.url));

it('compiles once for both workers, and tries again after it could not be had', async () => {
  let compiled = 0;
  const module = async (whole: boolean) => {
    if (++compiled === 1) throw new Error('offline');
    return WebAssembly.compile(fileOf(whole));
  };
  const mesh = await (await start({ module })).make(torus);
  expect((await mesh.weights(planar, { side: 'b' })).negativeOrdered).toBe(0);
  expect(compiled).toBe(2);
  for (const side of ['a', 'b'] as const)
    expect(worker(side).sent[0]).toMatchObject({ kind: 'start', module: expect.any(WebAssembly.Module), whole: false });
});

it('gets the whole core for who asks for what only that can do, and keeps the surfaces', async () => {
  const asked: boolean[] = [];
  let online = false;
  const module = async (whole: boolean) => {
    asked.push(whole);
    if (whole && !online) throw new Error('offline');
    return WebAssembly.compile(fileOf(whole));
  };
  const c = await start({ module });
  const restarts: string[] = [];
  c.onRestart = (reason) => restarts.push(reason);
  const mesh = await c.make(torus);
  await mesh.smooth(aw, { time: 0.01 });
  expect(await failure(mesh.check(aw))).toMatchObject({ code: 'worker-failed', message: /offline/ });
  expect((await mesh.smooth(aw, { time: 0.01 })).step).toBe(2);
  expect(workers('a').length).toBe(1);
  online = true;
  const abort = new AbortController();
  const unwanted = failure(mesh.check(aw, { signal: abort.signal }));
  abort.abort();
  expect((await unwanted).code).toBe('cancelled');
  const before = await coordinates(mesh);
  const [check] = await Promise.all([mesh.check(aw), mesh.check(aw)]);
  const session = (await load()).open(before, 'torus.obj');
  expect(check.measurements).toEqual(session.check(aw).measurements);
  expect(await coordinates(mesh)).toBe(before);
  expect((await mesh.smooth(aw, { time: 0.01 })).step).toBe(3);
  expect(asked.filter(Boolean).length).toBe(2);
  expect([workers('a').length, workers('b').length]).toEqual([2, 1]);
  expect(restarts).toEqual([]);
});

it('asks the whole core again for what the smaller finds that it cannot do', async () => {
  const loading: boolean[] = [];
  const c = await start({ module: async (whole: boolean) => WebAssembly.compile(fileOf(whole)) });
  c.onLoading = (more) => loading.push(more);
  const mesh = await c.make(torus);
  await mesh.smooth(aw, { time: 0.01, steps: 2 }, { side: 'b' });
  expect(loading).toEqual([]);
  const general = { id: operators.find(({ claims }) => claims.symmetric.where === 'no')?.id } as OperatorSpec;
  const fixed = { vertices: [0, 5], values: [0, 1] };
  const asked = await mesh.harmonic(general, fixed, { side: 'b' });
  expect(loading).toEqual([true, false]);
  expect([workers('a').length, workers('b').length]).toEqual([1, 2]);
  const session = (await load()).make(torus);
  session.smooth(aw, { time: 0.01, steps: 2 });
  expect(asked.values).toEqual(session.harmonic(general, fixed).values);
  // Of what both modules do, both do the same, and the surface has stayed.
  const moved = await mesh.smooth(aw, { time: 0.01 }, { side: 'b' });
  expect(moved.step).toBe(3);
  expect(moved.coordinates).toEqual(session.smooth(aw, { time: 0.01 }).coordinates);
});

it('gives up the memory of a file, and hands over that of every answer', async () => {
  const c = await start();
  const text = new TextEncoder().encode('v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n');
  await c.open(text, 'a.obj');
  // The caller's bytes are the caller's; the client's own copy went to the worker.
  expect(text.length).toBeGreaterThan(0);
  const sent = worker().sent.find((message) => message.kind === 'request');
  const source = sent?.kind === 'request' && sent.request.call === 'open' ? sent.request.takes.source : undefined;
  expect(source && 'bytes' in source && source.bytes.length).toBe(0);
  const done = worker().received.find((message: FromWorker) => message.kind === 'done');
  expect(done).toBeDefined();
});
