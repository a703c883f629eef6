/** Makes Node's worker threads look like a browser's workers, and lets tests watch and kill them. */
import { mkdirSync, mkdtempSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { dirname, join } from 'node:path';
import { fileURLToPath } from 'node:url';
import { Worker as Thread } from 'node:worker_threads';
import { build } from 'vite';
import type { WorkerLike } from '../../wasm/src/client.js';
import type { FromWorker, ToWorker } from '../../wasm/src/protocol.js';

const wasmBinary = readFileSync(new URL('../../build/wasm/polylap.wasm', import.meta.url));

/** Node 20 runs no TypeScript: the worker is bundled. */
export async function bundleWorker(): Promise<{ file: string; remove: () => void }> {
  const entry = fileURLToPath(new URL('./node-worker.ts', import.meta.url));
  const result = await build({
    configFile: false,
    logLevel: 'error',
    build: { ssr: entry, write: false, minify: false, rollupOptions: { output: { format: 'es' } } },
  });
  const output = 'output' in result ? result.output : [];
  const folder = mkdtempSync(join(tmpdir(), 'polylap-'));
  let file = '';
  for (const chunk of output) {
    if (chunk.type !== 'chunk') continue;
    const path = join(folder, chunk.fileName);
    mkdirSync(dirname(path), { recursive: true });
    writeFileSync(path, chunk.code);
    if (chunk.isEntry) file = path;
  }
  if (!file) throw new Error('the worker was not bundled');
  // What Node is to read as modules.
  writeFileSync(join(folder, 'package.json'), '{ "type": "module" }');
  return { file, remove: () => rmSync(folder, { recursive: true }) };
}

export class ThreadWorker implements WorkerLike {
  onmessage: ((event: { data: FromWorker }) => void) | null = null;
  onerror: ((event: { message: string }) => void) | null = null;
  onmessageerror: (() => void) | null = null;
  /** All that went either way. */
  readonly sent: ToWorker[] = [];
  readonly received: FromWorker[] = [];
  /** Called with each message before it goes. */
  onSent: ((message: ToWorker) => void) | null = null;
  terminated = false;
  readonly #thread: Thread;

  constructor(file: string) {
    this.#thread = new Thread(file, { workerData: { wasmBinary } });
    this.#thread.on('message', (data: FromWorker) => {
      this.received.push(data);
      this.onmessage?.({ data });
    });
    this.#thread.on('error', ({ message }) => this.onerror?.({ message }));
    this.#thread.on('exit', () => {
      if (!this.terminated) this.onerror?.({ message: 'the thread ended' });
    });
  }

  postMessage(message: ToWorker, transfer: Transferable[]): void {
    this.sent.push(message);
    this.onSent?.(message);
    this.#thread.postMessage(message, transfer as []);
  }

  terminate(): void {
    this.terminated = true;
    void this.#thread.terminate();
  }

  /** Ends the thread as a crash would, without the client's knowledge. */
  crash(): void {
    void this.#thread.terminate();
  }

  /** Pretends that a message came from the worker. */
  say(data: FromWorker): void {
    this.onmessage?.({ data });
  }
}
