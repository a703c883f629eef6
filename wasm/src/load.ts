/** Starts the module, in a browser, a worker or Node. */
import createModule from '../../build/wasm/polylap.js';
import { notStarted } from './compile.js';
import type { RawModule } from './raw.js';
import { Polylap } from './session.js';

export interface LoadOptions {
  /** polylap.wasm, compiled already: instances share its machine code, and what the engine has optimised of it. */
  module?: WebAssembly.Module | undefined;
  /** The contents of polylap.wasm. Node needs them; elsewhere the file is fetched from beside the module. */
  wasmBinary?: ArrayBuffer | Uint8Array;
  /** Where polylap.wasm is, if not there. */
  wasmUrl?: string;
}

/** @throws PolylapError with code `internal` when WebAssembly or its file cannot be had */
export async function load({ module, wasmBinary, wasmUrl }: LoadOptions = {}): Promise<Polylap> {
  try {
    return new Polylap(
      module
        ? await instantiate(module)
        : await createModule({
            ...(wasmBinary && { wasmBinary }),
            ...(wasmUrl !== undefined && { locateFile: () => wasmUrl }),
          }),
    );
  } catch (error) {
    throw notStarted(error);
  }
}

/** Emscripten's loader would wait for ever for an instance that cannot be made. */
function instantiate(module: WebAssembly.Module): Promise<RawModule> {
  return new Promise((resolve, reject) => {
    const instantiateWasm = (
      imports: WebAssembly.Imports,
      done: (instance: WebAssembly.Instance, module: WebAssembly.Module) => void,
    ) => {
      WebAssembly.instantiate(module, imports).then((instance) => done(instance, module), reject);
      return {};
    };
    createModule({ instantiateWasm }).then(resolve, reject);
  });
}
