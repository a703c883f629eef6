/** The one door to the library: the page uses what any other program would. */

export type { ConversionSpec, OperatorSpec, PropertyId, ShapeSpec } from '../../wasm/src/index.js';
export { conversions, createClient, operators, PolylapError, properties, shapes } from '../../wasm/src/index.js';
export type * from '../../wasm/src/types.js';
