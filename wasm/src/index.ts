/** polylap for browsers: the core runs in a worker, calls return promises. For Node, and for workers of one's own, see node.ts and load.ts. */
export type { ClientOptions, WorkerLike } from './client.js';
export { createClient } from './create.js';
export { PolylapError } from './error.js';
export * from './generated.js';
export * from './types.js';
