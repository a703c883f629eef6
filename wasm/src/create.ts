/** The client with its workers and the core as files beside this one. What carries them in itself has another module in this one's place. */
import { type ClientOptions, startClient } from './client.js';
import { compile } from './compile.js';
import type { Client } from './types.js';

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
