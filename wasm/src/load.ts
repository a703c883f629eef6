/** Starts the module, in a browser, a worker or Node. */
import createCore from '../../build/wasm/polylap-core.js';
import { notStarted } from './compile.js';
import type { CreateModule, RawModule } from './raw.js';
import { Polylap } from './session.js';

export interface LoadOptions {
  /** Everything (default), or only what most need: polylap-core.wasm, half the size; the rest answers `not-included`. */
  whole?: boolean;
  /** The file, compiled already: instances share its machine code, and what the engine has optimised of it. */
  module?: WebAssembly.Module | undefined;
  /** The contents of polylap.wasm. Node needs them; elsewhere the file is fetched from beside the module. */
  wasmBinary?: ArrayBuffer | Uint8Array;
  /** Where polylap.wasm is, if not there. */
  wasmUrl?: string;
}

/** @throws PolylapError with code `internal` when WebAssembly or its file cannot be had */
export async function load({ whole = true, module, wasmBinary, wasmUrl }: LoadOptions = {}): Promise<Polylap> {
  try {
    // What few ask for is not loaded by all.
    const createModule = whole ? (await import('../../build/wasm/polylap.js')).default : createCore;
    return new Polylap(
      module
        ? await instantiate(createModule, module)
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
function instantiate(createModule: CreateModule, module: WebAssembly.Module): Promise<RawModule> {
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
