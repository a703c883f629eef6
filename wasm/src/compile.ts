/** The core's machine code: made once, wherever it is needed. */
import { messageOf } from './check.js';
import { PolylapError } from './error.js';

/** Fetches and compiles a file of ours. @throws PolylapError with code `internal` */
export async function compile(url: URL | string): Promise<WebAssembly.Module> {
  try {
    const response = await fetch(url);
    if (!response.ok) throw new Error(`the server says ${response.status} for ${url}`);
    // Only with the right type do browsers compile while they load.
    return response.headers.get('content-type')?.startsWith('application/wasm')
      ? await WebAssembly.compileStreaming(response)
      : await WebAssembly.compile(await response.arrayBuffer());
  } catch (error) {
    throw notStarted(error);
  }
}

export const notStarted = (error: unknown) =>
  new PolylapError('internal', `WebAssembly did not start: ${messageOf(error)}`);
