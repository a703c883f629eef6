/** Requests that are no longer wanted. */
import { describe, expect, it } from 'vitest';
import type { Smoothed } from '../../wasm/src/index.js';
import {
  aw,
  big,
  coordinates,
  endless,
  failure,
  planar,
  requests,
  sending,
  torus,
  until,
  useClients,
} from './client-help.js';
import { readMesh } from './native.js';

const { start, worker, workers } = useClients();

describe('cancelling', () => {
  it('never starts what was aborted before', async () => {
    const mesh = await (await start()).make(torus);
    const before = worker().sent.length;
    const error = await failure(mesh.smooth(aw, { time: 0.01 }, { signal: AbortSignal.abort() }));
    expect(error.code).toBe('cancelled');
    const late = new AbortController();
    const running = mesh.smooth(aw, { time: 0.01 });
    const waiting = failure(mesh.smooth(aw, { time: 0.01 }, { signal: late.signal }));
    late.abort();
    expect((await waiting).code).toBe('cancelled');
    expect((await running).step).toBe(1);
    expect((await mesh.smooth(aw, { time: 0.01 })).step).toBe(2);
    expect(worker().sent.length - before).toBe(2);
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
    expect(workers().length).toBe(1);
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
    const sent = sending(worker(), 'open');
    const opening = failure(c.open(readMesh('grid-2x2.obj'), 'a.obj', { signal: again.signal }));
    await sent;
    again.abort();
    expect((await opening).code).toBe('cancelled');
    await mesh.shape();
    expect(requests(worker()).slice(-2)).toEqual(['close', 'shape']);
    expect(workers().length).toBe(1);
  });

  it('makes nothing that is no longer wanted', async () => {
    const c = await start();
    const mesh = await c.make(torus);
    const [making, converting] = [new AbortController(), new AbortController()];
    const sent = sending(worker(), 'convert');
    const refused = [
      failure(c.make(torus, { signal: making.signal })),
      failure(mesh.convert({ conversion: 'dual' }, { signal: converting.signal })),
    ];
    making.abort();
    await sent;
    converting.abort();
    for (const { code } of await Promise.all(refused)) expect(code).toBe('cancelled');
    await mesh.shape();
    // Each was closed again in the worker, by the number it had there.
    const closed = worker().sent.flatMap((sent) =>
      sent.kind === 'request' && sent.request.call === 'close' ? [sent.request.takes.mesh] : [],
    );
    expect(closed).toEqual([1, 2]);
    expect(workers().length).toBe(1);
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
    await until(() => worker().sent.at(-1)?.kind === 'request');
    await new Promise((resolve) => setTimeout(resolve, 20));
    const aborted = performance.now();
    abort.abort();
    expect((await cancelled).code).toBe('cancelled');
    const waited = performance.now() - aborted;
    expect(waited).toBeGreaterThan(250);
    expect(waited).toBeLessThan(1500);

    expect(await Promise.all(queued)).toEqual(before);
    expect(workers().length).toBe(2);
    expect(workers()[0]?.terminated).toBe(true);
    expect(reasons).toEqual(['cancelled']);
    expect((await saddle.smooth(aw, { time: 0.01 })).step).toBe(4);
    expect((await saddle.smooth(planar, { time: 0.01 }, { side: 'b' })).step).toBe(3);
    expect((await mesh.smooth(aw, { time: 1e-6 })).step).toBe(1);
  });
});
