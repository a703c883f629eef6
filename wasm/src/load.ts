/** Starts the module, in a browser, a worker or Node. */
import createModule from '../../build/wasm/polylap.js';
import { PolylapError } from './error.js';
import { Polylap } from './session.js';

export interface LoadOptions {
  /** The contents of polylap.wasm. Node needs them; elsewhere the file is fetched from beside the module. */
  wasmBinary?: ArrayBuffer | Uint8Array;
  /** Where polylap.wasm is, if not there. */
  wasmUrl?: string;
}

/** @throws PolylapError with code `internal` when WebAssembly or its file cannot be had */
export async function load({ wasmBinary, wasmUrl }: LoadOptions = {}): Promise<Polylap> {
  try {
    const module = await createModule({
      ...(wasmBinary && { wasmBinary }),
      ...(wasmUrl !== undefined && { locateFile: () => wasmUrl }),
    });
    return new Polylap(module);
  } catch (error) {
    throw new PolylapError(
      'internal',
      `WebAssembly did not start: ${error instanceof Error ? error.message : String(error)}`,
    );
  }
}
