/** polylap for browsers: the core runs in a worker, calls return promises. For Node, and for workers of one's own, see node.ts and load.ts. */
import { type ClientOptions, startClient } from './client.js';
import { compile } from './compile.js';
import type { Client } from './types.js';

export type { ClientOptions, WorkerLike } from './client.js';
export { PolylapError } from './error.js';
export * from './generated.js';
export * from './types.js';

/** @throws PolylapError `worker-failed` when the worker cannot be started */
export function createClient(options: Partial<ClientOptions> = {}): Promise<Client> {
  return startClient({
    // Here and not in a worker: once for both, and while they start.
    module: (whole) =>
      compile(
        whole
          ? new URL('../../build/wasm/polylap.wasm', import.meta.url)
          : new URL('../../build/wasm/polylap-core.wasm', import.meta.url),
      ),
    worker: () => new Worker(new URL('./worker.js', import.meta.url), { type: 'module' }),
    ...options,
  });
}
