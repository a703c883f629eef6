/** The one door to the library: the page uses what any other program would. */
export { createClient, operators, PolylapError } from '../../wasm/src/index.js';
export type * from '../../wasm/src/types.js';
