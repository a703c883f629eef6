/** Arguments as callers in plain JavaScript may give them: what is not right leaves as `bad-argument`, before it reaches the core or the worker. */
import { PolylapError } from './error.js';
import type { ConversionSpec, OperatorSpec, ShapeSpec } from './generated.js';
import type { Settings } from './raw.js';
import type { Flow, MeshArrays, OpenOptions, SmoothOptions, SmoothRunOptions } from './types.js';

export function badArgument(message: string, element?: number): PolylapError {
  return new PolylapError('bad-argument', message, element);
}

export const messageOf = (error: unknown) => (error instanceof Error ? error.message : String(error));

/** A value in a message; `String` would throw on some objects and print whole functions. */
function show(value: unknown): string {
  if (Array.isArray(value)) return 'an array';
  if (typeof value === 'function') return 'a function';
  return typeof value === 'object' && value !== null ? 'an object' : String(value);
}

/** Runs what may run the caller's code, such as getters. */
function reading<T>(what: string, work: () => T): T {
  try {
    return work();
  } catch (error) {
    if (error instanceof PolylapError) throw error;
    throw badArgument(`${what} cannot be read: ${messageOf(error)}`);
  }
}

/** A shallow copy of an object: read once, and the caller may change the original. */
export function fields<T extends object>(value: T, what: string): T {
  if (typeof value !== 'object' || value === null) throw badArgument(`${what} must be an object, not ${show(value)}`);
  return reading(what, () => ({ ...value }));
}

/** A copy that shares nothing with the caller. */
export function ownCopy<T>(value: T): T {
  return reading('the arguments', () => structuredClone(value));
}

/** Numbers that C++ would quietly cut to whole ones are refused here. */
export function wholeNumber(value: unknown, name: string, min = -(2 ** 31), max = 2 ** 31 - 1): number {
  if (typeof value !== 'number' || !Number.isInteger(value) || value < min || value > max) {
    throw badArgument(`${name} must be a whole number of at least ${min} and at most ${max}, not ${show(value)}`);
  }
  return value;
}

export function realNumber(value: unknown, name: string): number {
  if (typeof value !== 'number') throw badArgument(`${name} must be a number, not ${show(value)}`);
  return value;
}

export function yesOrNo(value: unknown, name: string): boolean {
  if (typeof value !== 'boolean') throw badArgument(`${name} must be true or false, not ${show(value)}`);
  return value;
}

export function text(value: unknown, name: string): string {
  if (typeof value !== 'string') throw badArgument(`${name} must be text, not ${show(value)}`);
  return value;
}

export function oneOf<T extends string>(value: T, choices: readonly T[], name: string): T {
  if (!choices.includes(value)) throw badArgument(`${name} must be '${choices.join("' or '")}', not ${show(value)}`);
  return value;
}

export function optionalFunction(value: unknown, name: string): void {
  if (typeof (value ?? show) !== 'function') throw badArgument(`${name} must be a function, not ${show(value)}`);
}

/** @param each checks a number and names it in its error. An array of the type itself needs no check, and no copy: C++ makes its own. */
export function numbers<T extends object>(
  type: {
    from(values: ArrayLike<number>, each: (value: unknown, k: number) => number): T;
    new (length: number): T;
  },
  values: ArrayLike<number>,
  name: string,
  each: (value: unknown, name: string) => number,
): T {
  if (typeof values !== 'object' || values === null) throw badArgument(`${name} must be an array, not ${show(values)}`);
  if (values instanceof type) return values;
  return reading(name, () => {
    wholeNumber(values.length, `the number of ${name}`, 0);
    return type.from(values, (value, k) => each(value, `${name}[${k}]`));
  });
}

/** `{…, parameter: number or text, …}`, copied. */
function settings(spec: object, what: string): Settings {
  const copy = fields(spec, what);
  for (const [key, value] of Object.entries(copy)) {
    if (value !== undefined && typeof value !== 'number' && typeof value !== 'string') {
      throw badArgument(`${key} in ${what} must be a number or text, not ${show(value)}`);
    }
  }
  return copy as Settings;
}

/** An operator taken apart, and nothing in it the caller's own. */
export interface OperatorParts {
  id: string;
  settings: Settings;
  vertexWeights: Float64Array | undefined;
}

/** V numbers, copied. Whether they are V finite ones the core knows. */
function weightsOfVertices(values: unknown): Float64Array {
  if (typeof values !== 'object' || values === null)
    throw badArgument(`vertexWeights must be an array, not ${show(values)}`);
  return reading('vertexWeights', () => {
    wholeNumber((values as ArrayLike<number>).length, 'the number of vertexWeights', 0);
    return Float64Array.from(values as ArrayLike<number>, (value, vertex) => {
      if (typeof value === 'number') return value;
      throw badArgument(`the weight of vertex ${vertex} must be a number, not ${show(value)}`, vertex);
    });
  });
}

export function operatorParts(spec: OperatorSpec): OperatorParts {
  const what = 'an operator, {id: …},';
  const { vertexWeights, ...rest } = fields<object & { vertexWeights?: unknown }>(spec, what);
  const { id, ...parameters } = settings(rest, what);
  return {
    id: String(id ?? ''),
    settings: parameters,
    vertexWeights: vertexWeights === undefined ? undefined : weightsOfVertices(vertexWeights),
  };
}

/** The same in one piece, as it crosses to the worker. */
export function ownOperator(spec: OperatorSpec): OperatorSpec {
  const { id, settings: parameters, vertexWeights } = operatorParts(spec);
  return { id, ...parameters, ...(vertexWeights && { vertexWeights }) } as OperatorSpec;
}

/** A shape: `{shape: id, …}`, copied; its own parameters apart from the noise that any shape takes. The seed is for both. */
export function shapeParts(shape: ShapeSpec): { id: string; settings: Settings; noise: number; seed: number } {
  const { shape: id, noise, ...rest } = settings(shape, 'a shape');
  const { seed } = rest;
  return {
    id: text(id, 'the name of a shape'),
    settings: rest,
    noise: realNumber(noise ?? 0, 'noise'),
    seed: wholeNumber(seed ?? 1, 'seed', 0, 2 ** 32 - 1),
  };
}

/** A conversion: `{conversion: id, …}`, copied. */
export function conversionParts(conversion: ConversionSpec): { id: string; settings: Settings } {
  const { conversion: id, ...rest } = settings(conversion, 'a conversion');
  return { id: text(id, 'the name of a conversion'), settings: rest };
}

/** How to open a mesh, complete. */
export function openOptions({ repair, mergeDistance }: OpenOptions): Required<OpenOptions> {
  return {
    repair: yesOrNo(repair ?? false, 'repair'),
    mergeDistance: realNumber(mergeDistance ?? 0, 'mergeDistance'),
  };
}

const flows: readonly Flow[] = ['implicit', 'conformalised', 'explicit'];

/** How to smooth, complete. */
export function flowOf(options: SmoothOptions): Required<SmoothOptions> {
  const given = fields(options, 'smoothing options');
  return {
    time: realNumber(given.time, 'time'),
    steps: wholeNumber(given.steps ?? 1, 'steps', 1),
    flow: oneOf(given.flow ?? 'implicit', flows, 'flow'),
    rebuild: yesOrNo(given.rebuild ?? true, 'rebuild'),
    keepVolume: yesOrNo(given.keepVolume ?? false, 'keepVolume'),
    fixBoundary: yesOrNo(given.fixBoundary ?? false, 'fixBoundary'),
  };
}

/** The contents of a mesh file; a view where there is one. */
export function bytesOf(contents: Uint8Array | ArrayBuffer | string): Uint8Array {
  if (typeof contents === 'string') return new TextEncoder().encode(contents);
  if (contents instanceof Uint8Array) return contents;
  if (contents instanceof ArrayBuffer) return reading('the contents of a mesh', () => new Uint8Array(contents));
  throw badArgument(`a mesh must be text, a Uint8Array or an ArrayBuffer, not ${show(contents)}`);
}

/** The caller's wishes for one call, read once. */
export function runOf<T extends SmoothRunOptions>(given: T): T {
  const run = fields(given, 'the options of a call');
  optionalFunction(run.onProgress, 'onProgress');
  optionalFunction(run.onStep, 'onStep');
  if (!((run.signal ?? undefined) === undefined || run.signal instanceof AbortSignal))
    throw badArgument('signal must be an AbortSignal');
  if (run.side !== undefined) oneOf(run.side, ['a', 'b'], 'the side');
  return run;
}

/** Bytes that the caller can no longer change: what a restarted worker reads must be what was opened. */
export async function ownBytes(contents: Uint8Array | ArrayBuffer | Blob | string): Promise<Uint8Array> {
  // Not with slice, which copies nothing in Node's Buffer.
  if (!(contents instanceof Blob)) return new Uint8Array(bytesOf(contents));
  try {
    return new Uint8Array(await contents.arrayBuffer());
  } catch (error) {
    throw badArgument(`the file cannot be read: ${messageOf(error)}`);
  }
}

/** A mesh as the core takes it. */
export function ownArrays(arrays: MeshArrays): MeshArrays {
  const { coordinates, offsets, corners } = fields(arrays, 'the arrays of a mesh');
  return {
    coordinates: numbers(Float64Array, coordinates, 'coordinates', realNumber),
    offsets: numbers(Int32Array, offsets, 'offsets', wholeNumber),
    corners: numbers(Int32Array, corners, 'corners', wholeNumber),
  };
}
