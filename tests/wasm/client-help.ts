/** Clients with the real core in real worker threads, for the tests of client.ts. */
import { afterAll, afterEach, beforeAll, expect } from 'vitest';
import { type ClientOptions, startClient } from '../../wasm/src/client.js';
import { type Client, type Mesh, type OperatorSpec, PolylapError, type Side } from '../../wasm/src/index.js';
import type { CallName } from '../../wasm/src/protocol.js';
import { bundleWorker, ThreadWorker } from './thread.js';

export const aw: OperatorSpec = { id: 'alexa-wardetzky' };
export const planar: OperatorSpec = { id: 'planar' };
export const torus = { shape: 'torus', nu: 32, nv: 16, noise: 0.3, seed: 7 } as const;
/** Steps so small that the surface stands, and goes on standing: with large ones it soon has no area left. */
export const endless = { time: 1e-9, steps: 1_000_000 };
/** One smoothing step on it takes longer than a cancellation is given. */
export const big = { shape: 'grid', nx: 400, ny: 400, noise: 0.2 } as const;

/** The clients of one test file: closed after each test. */
export function useClients() {
  let bundle: Awaited<ReturnType<typeof bundleWorker>>;
  /** All that were ever started for a side, in order. */
  let workers: Record<Side, ThreadWorker[]> = { a: [], b: [] };
  let clients: Client[] = [];
  beforeAll(async () => {
    bundle = await bundleWorker();
  });
  afterAll(() => bundle.remove());
  afterEach(() => {
    for (const client of clients) client.close();
    clients = [];
    workers = { a: [], b: [] };
  });
  return {
    async start(options: Partial<ClientOptions> = {}): Promise<Client> {
      const worker = (side: Side) => {
        const thread = new ThreadWorker(bundle.file);
        workers[side].push(thread);
        return thread;
      };
      const client = await startClient({ worker, ...options });
      clients.push(client);
      return client;
    },
    workers: (side: Side = 'a') => workers[side],
    /** The one at work. */
    worker: (side: Side = 'a') => workers[side].at(-1) as ThreadWorker,
  };
}

export async function failure(promise: Promise<unknown>): Promise<PolylapError> {
  const error = await promise.then(
    () => undefined,
    (reason) => reason,
  );
  expect(error).toBeInstanceOf(PolylapError);
  return error;
}

export async function until(condition: () => boolean, timeout = 10_000) {
  const end = performance.now() + timeout;
  while (!condition()) {
    if (performance.now() > end) throw new Error('waited too long');
    await new Promise((resolve) => setTimeout(resolve, 5));
  }
}

const textOf = (bytes: Uint8Array) => new TextDecoder().decode(bytes);
export const coordinates = async (mesh: Mesh, side: Side = 'a') => textOf(await mesh.file('obj', { side }));

/** Until a worker is sent the next request of that name: its answer has not come yet. */
export function sending(worker: ThreadWorker, call: CallName): Promise<void> {
  return new Promise((done) => {
    worker.onSent = (message) => {
      if (message.kind === 'request' && message.request.call === call) done();
    };
  });
}

/** The requests that a worker was sent, in order. */
export const requests = (worker: ThreadWorker) =>
  worker.sent.flatMap((sent) => (sent.kind === 'request' ? [sent.request.call] : []));
