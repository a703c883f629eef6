/** worker.ts for Node's worker threads: the same server, on the thread's own port. */
import { parentPort, workerData } from 'node:worker_threads';
import { load } from '../../wasm/src/load.js';
import { type Port, serve } from '../../wasm/src/serve.js';

if (!parentPort) throw new Error('not a worker');
const thread = parentPort;
const port: Port = { onmessage: null, postMessage: (message, transfer) => thread.postMessage(message, transfer as []) };
thread.on('message', (data) => port.onmessage?.({ data } as MessageEvent));
serve(port, (options) => load({ ...workerData, ...options }));
