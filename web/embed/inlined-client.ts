/** Takes the place of wasm/src/create.ts where a file carries the core and the worker in itself. Nothing is fetched. */
import core from 'inlined:core';
import worker from 'inlined:worker';
import { startClient } from '../../wasm/src/client.js';
import type { Client } from '../src/polylap.js';
import { unpack } from './unpack.js';

/** @throws PolylapError `worker-failed` when the worker cannot be started */
export async function createClient(): Promise<Client> {
  const script = await (await unpack(worker)).text();
  const address = URL.createObjectURL(new Blob([script], { type: 'text/javascript' }));
  return startClient({
    module: async () => WebAssembly.compile(await (await unpack(core)).arrayBuffer()),
    // A classic one: from file:// a module from a blob does not start.
    worker: () => new Worker(address),
    whole: true,
  });
}
