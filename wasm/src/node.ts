/** polylap for Node: synchronous, in the calling thread. */
import { readFile } from 'node:fs/promises';
import { load as loadModule } from './load.js';
import type { Polylap } from './session.js';

export { PolylapError } from './error.js';
export * from './generated.js';
export { Polylap, Session, type SyncOptions } from './session.js';
export * from './types.js';

export async function load(): Promise<Polylap> {
  return loadModule({ wasmBinary: await readFile(new URL('../../build/wasm/polylap.wasm', import.meta.url)) });
}
