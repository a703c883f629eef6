/** The worker that hosts the core: see client.ts. */
import { load } from './load.js';
import { type Port, serve } from './serve.js';

serve(self as unknown as Port, load);
