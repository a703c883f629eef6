/** polylap for Node: synchronous, in the calling thread; or as browsers have it, with promises, in that thread too. */
import { readFile } from 'node:fs/promises';
import { startClient, type WorkerLike } from './client.js';
import { load as loadModule } from './load.js';
import { type Port, serve } from './serve.js';
import type { Polylap } from './session.js';
import type { Client } from './types.js';

export { PolylapError } from './error.js';
export * from './generated.js';
export { Polylap, Session, type SyncOptions } from './session.js';
export * from './types.js';

const file = () => readFile(new URL('../../build/wasm/polylap.wasm', import.meta.url));

export async function load(): Promise<Polylap> {
  return loadModule({ wasmBinary: await file() });
}

/** The asynchronous API without workers: programs for the browser run here unchanged. Close it, or the process does not end. */
export async function createClient(): Promise<Client> {
  const wasmBinary = await file();
  return startClient({ worker: () => inThisThread(wasmBinary) });
}

function inThisThread(wasmBinary: Uint8Array): WorkerLike {
  const { port1, port2 } = new MessageChannel();
  serve(port2 as unknown as Port, ({ whole }) => loadModule({ wasmBinary, whole }));
  return Object.assign(port1, {
    terminate: () => port1.close(),
    onerror: null,
  }) as unknown as WorkerLike;
}
