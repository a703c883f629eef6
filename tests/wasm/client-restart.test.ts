/** Workers that die. */
import { describe, expect, it } from 'vitest';
import { startClient, type WorkerLike } from '../../wasm/src/client.js';
import { aw, endless, failure, planar, sending, torus, until, useClients } from './client-help.js';

const { start, worker, workers } = useClients();

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
    await until(() => worker().received.some(({ kind }) => kind === 'progress'));
    worker().crash();
    expect(await running).toMatchObject({ code: 'worker-failed' });
    const { step, coordinates: after } = await queued;
    expect(step).toBe(3);
    for (const [k, value] of after.entries()) expect(value).toBeCloseTo(kept[k] as number, 12);
    expect(workers().length).toBe(2);
    expect(reasons).toEqual(['the worker failed: the thread ended']);
  });

  it('is started again after a failure of its own, and after a message that cannot be read', async () => {
    const c = await start();
    const mesh = await c.make(torus);
    worker().say({ kind: 'failed', message: 'unreachable' });
    expect((await mesh.weights(aw)).negativeOrdered).toBe(2048);
    worker().onmessageerror?.();
    expect((await mesh.weights(aw)).negativeOrdered).toBe(2048);
    expect(workers().length).toBe(3);
  });

  it.each(['close', 'reset'] as const)('has done what it was to undo: %s', async (call) => {
    const c = await start();
    const mesh = await c.make(torus);
    await mesh.smooth(aw, { time: 0.01 });
    const sent = sending(worker(), call);
    const done = mesh[call]();
    await sent;
    worker().say({ kind: 'failed', message: 'unreachable' });
    await done;
    expect(workers().length).toBe(2);
    if (call === 'reset') expect((await mesh.smooth(aw, { time: 0.01 })).step).toBe(1);
    else expect((await failure(mesh.shape())).message).toContain('has been closed');
  });

  it('is replaced when it ran out of memory, which it could not give back', async () => {
    const c = await start();
    const mesh = await c.make(torus);
    await mesh.smooth(aw, { time: 0.01 });
    // A star, whose matrix would have 20 000² entries.
    const count = 20_000;
    const angles = Array.from({ length: count }, (_, k) => (2 * Math.PI * ((k * 7001) % count)) / count);
    const vertices = angles.map((angle) => `v ${Math.cos(angle)} ${Math.sin(angle)} 0\n`).join('');
    const star = await c.open(`${vertices}f ${angles.map((_, k) => k + 1).join(' ')}\n`, 'star.obj');
    expect((await failure(star.matrices(aw))).code).toBe('out-of-memory');
    expect((await mesh.smooth(aw, { time: 0.01 })).step).toBe(2);
    expect([workers('a').length, workers('b').length]).toEqual([2, 1]);
  });

  it('is given up after failing three times at once, with the reason', async () => {
    const made: string[] = [];
    const worker = (side: string) => {
      made.push(side);
      const fake = new FakeWorker();
      setTimeout(() => fake.onerror?.({ message: 'no such file' }));
      return fake;
    };
    const error = await failure(startClient({ worker }));
    expect(error).toMatchObject({ code: 'worker-failed', message: 'the worker failed: no such file' });
    expect(made.filter((side) => side === 'a').length).toBe(3);
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
      worker().say({ kind: 'failed', message: 'out of luck' });
      await until(() => k === 2 || worker().received.some(({ kind }) => kind === 'ready'));
    }
    expect(await failure(mesh.shape())).toMatchObject({
      code: 'worker-failed',
      message: 'the worker failed: out of luck',
    });
    expect(worker().terminated).toBe(true);
    expect(workers().length).toBe(3);
  });
});

class FakeWorker implements WorkerLike {
  onmessage = null;
  onerror: ((event: { message: string }) => void) | null = null;
  onmessageerror = null;
  postMessage() {}
  terminate() {}
}
