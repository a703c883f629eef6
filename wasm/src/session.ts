/** The typed, synchronous API over the raw module: for Node and for the worker. Arrays it returns belong to the caller. */
import {
  badArgument,
  bytesOf,
  conversionParts,
  fields,
  flowOf,
  messageOf,
  numbers,
  oneOf,
  openOptions,
  operatorParts,
  optionalFunction,
  ownArrays,
  realNumber,
  shapeParts,
  text,
  wholeNumber,
} from './check.js';
import { CoreStopped, PolylapError } from './error.js';
import type { ConversionSpec, ErrorCode, OperatorSpec, ShapeSpec } from './generated.js';
import type { RawModule, RawSession, RawSide, Reply, Tick } from './raw.js';
import type {
  Check,
  ConvergenceStudy,
  Dual,
  DualOptions,
  FaceReport,
  FixedValues,
  Geometry,
  Harmonic,
  Matrices,
  MeshArrays,
  MeshFormat,
  MeshInfo,
  OpenOptions,
  OperatorInfo,
  Row,
  Shape,
  Side,
  Smoothed,
  SmoothOptions,
  Stability,
  StabilityOptions,
  Weights,
} from './types.js';

export interface SyncOptions {
  /** Default `a`. */
  side?: Side;
  /** fraction in [0, 1]; returning false stops the call with code `cancelled`. */
  onProgress?: (fraction: number) => boolean | undefined;
}

const formats: readonly MeshFormat[] = ['obj', 'off', 'ply', 'stl'];

/** What a call may be given besides its arguments, read once. */
function optionsOf<T extends SyncOptions>(options: T): T {
  const copy = fields(options, 'the options');
  optionalFunction(copy.onProgress, 'onProgress');
  return copy;
}

/** Makes one call. Whatever goes wrong in it leaves as a PolylapError; what the caller's own callback throws leaves as it is. */
function call<T>(work: (tick: Tick | undefined) => Reply<T>, onProgress?: SyncOptions['onProgress']): T {
  let thrown: { error: unknown } | undefined;
  const tick: Tick | undefined =
    onProgress &&
    ((fraction) => {
      try {
        return onProgress(fraction) !== false;
      } catch (error) {
        thrown = { error };
        return false;
      }
    });
  let reply: Reply<T>;
  try {
    reply = work(tick);
  } catch (error) {
    throw error instanceof PolylapError ? error : opaque(error);
  }
  if (thrown) throw thrown.error;
  if (reply.error) {
    const { code, message, element, line } = reply.error;
    throw new PolylapError(code as ErrorCode, message, element, line);
  }
  return reply.ok as T;
}

/** What came past the guard in C++: a trap, an exhausted stack, an array that JavaScript had no room for. */
function opaque(error: unknown): PolylapError {
  const message = messageOf(error);
  if (error instanceof RangeError && /allocation|array length/i.test(message)) {
    return new PolylapError('out-of-memory', 'not enough memory for the result');
  }
  return new CoreStopped(message);
}

/** What only the whole module has. */
function whole<F>(has: F | undefined): F {
  if (!has) throw new PolylapError('not-included', 'this is the smaller module, which does without what it takes');
  return has;
}

/** The module, loaded: see load.ts. */
export class Polylap {
  readonly #module: RawModule;

  constructor(module: RawModule) {
    this.#module = module;
  }

  /** Reads a mesh file; the format follows from the ending of `name`. */
  open(
    contents: Uint8Array | ArrayBuffer | string,
    name: string,
    options: Pick<SyncOptions, 'onProgress'> & OpenOptions = {},
  ): Session {
    const [bytes, file, given] = [bytesOf(contents), text(name, 'the name of a mesh'), optionsOf(options)];
    const { repair, mergeDistance } = openOptions(given);
    const read = whole(this.#module.open);
    return this.#own((tick) => read(bytes, file, repair, mergeDistance, tick), given.onProgress);
  }

  /** A mesh from arrays; they are copied. */
  fromArrays(arrays: MeshArrays, options: Pick<SyncOptions, 'onProgress'> = {}): Session {
    const { coordinates, offsets, corners } = ownArrays(arrays);
    const { onProgress } = optionsOf(options);
    return this.#own((tick) => this.#module.fromArrays(coordinates, offsets, corners, tick), onProgress);
  }

  make(shape: ShapeSpec): Session {
    const { id, settings, noise, seed } = shapeParts(shape);
    return this.#own(() => this.#module.make(id, settings, noise, seed));
  }

  /** A study on meshes of its own: does the operator converge under refinement? */
  convergence(spec: OperatorSpec, options: Pick<SyncOptions, 'onProgress'> = {}): ConvergenceStudy[] {
    const { id, settings, vertexWeights } = operatorParts(spec);
    const { onProgress } = optionsOf(options);
    const study = whole(this.#module.convergence);
    return call((tick) => study(id, settings, vertexWeights, tick), onProgress);
  }

  operatorIds(): string[] {
    return call(() => this.#module.operatorIds());
  }

  /** The operator table as the core has it; `operators` in generated.ts is the same with MathML. */
  operators(): Omit<OperatorInfo, 'formulaMathml'>[] {
    return call(() => whole(this.#module.operators)());
  }

  errorCodes(): string[] {
    return call(() => whole(this.#module.errorCodes)());
  }

  /** Bytes of WebAssembly memory. It grows when needed and never shrinks. */
  memory(): number {
    return this.#module.HEAPU8.length;
  }

  #own(work: (tick: Tick | undefined) => Reply<RawSession>, onProgress?: SyncOptions['onProgress']): Session {
    return new Session(call(work, onProgress), this.#module);
  }
}

/**
 * One mesh with two sides. Call `close` when done: C++ memory is not garbage collected.
 * A callback of one of its calls must leave it alone: any use throws `bad-argument`.
 */
export class Session {
  #handle: RawSession | undefined;
  #busy = false;
  readonly #module: RawModule;

  constructor(raw: RawSession, module: RawModule) {
    this.#handle = raw;
    this.#module = module;
  }

  info(): MeshInfo {
    return this.#call((raw) => raw.info());
  }

  geometry(): Geometry {
    return this.#call((raw) => raw.geometry());
  }

  /** 3V, of the loaded mesh, as they are. With the geometry's faces, `fromArrays` makes the same mesh of them. */
  coordinates(): Float64Array {
    return this.#call((raw) => raw.coordinates());
  }

  /** The side's surface as it stands. */
  surface(options: SyncOptions = {}): Smoothed {
    const side = this.#side(optionsOf(options).side);
    return this.#call((raw) => raw.surface(side));
  }

  shape(options: SyncOptions = {}): Shape {
    const side = this.#side(optionsOf(options).side);
    return this.#call((raw) => raw.shape(side));
  }

  /** The side's surface as a file; text but for STL. */
  file(format: MeshFormat, options: SyncOptions = {}): Uint8Array {
    const [ending, side] = [oneOf(format, formats, 'the format'), this.#side(optionsOf(options).side)];
    const write = whole(this.#module.file);
    return this.#call((raw) => write(raw, side, ending));
  }

  /** A new session with a mesh made of the side's surface. */
  convert(conversion: ConversionSpec, options: SyncOptions = {}): Session {
    const { id, settings } = conversionParts(conversion);
    const side = this.#side(optionsOf(options).side);
    const make = whole(this.#module.convert);
    return new Session(
      this.#call((raw) => make(raw, side, id, settings)),
      this.#module,
    );
  }

  weights(spec: OperatorSpec, options: SyncOptions = {}): Weights {
    return this.#apply(spec, options, (raw, side, tick) => raw.weights(side, tick));
  }

  /** The row of a vertex: at once where the matrices were built for something else. */
  row(spec: OperatorSpec, vertex: number, options: SyncOptions = {}): Row {
    const of = wholeNumber(vertex, 'the vertex');
    return this.#apply(spec, options, (raw, side, tick) => raw.row(side, of, tick));
  }

  face(spec: OperatorSpec, face: number, options: SyncOptions = {}): FaceReport {
    const of = wholeNumber(face, 'the face');
    return this.#apply(spec, options, (raw, side) => raw.face(side, of));
  }

  /** All steps or none: a step that fails or is stopped leaves the surface as it was. */
  smooth(spec: OperatorSpec, how: SmoothOptions, options: SyncOptions = {}): Smoothed {
    const flow = flowOf(how);
    const mine = optionsOf(options);
    this.#apply(spec, mine, (raw, side, tick) => raw.smooth(side, flow, tick));
    return this.surface(mine);
  }

  /** What bounds the explicit step that the options describe. */
  stability(spec: OperatorSpec, how: StabilityOptions = {}, options: SyncOptions = {}): Stability {
    const flow = flowOf({ ...fields(how, 'the options of stability'), time: 1 });
    return this.#apply(spec, options, (raw, side, tick) => raw.stability(side, flow, tick));
  }

  harmonic(spec: OperatorSpec, fixed: FixedValues, options: SyncOptions = {}): Harmonic {
    const given = fields(fixed, 'fixed values');
    const vertices = numbers(Int32Array, given.vertices, 'fixed vertices', wholeNumber);
    const values = numbers(Float64Array, given.values, 'fixed values', realNumber);
    return this.#apply(spec, options, (raw, side, tick) => raw.harmonic(side, vertices, values, tick));
  }

  matrices(spec: OperatorSpec, options: SyncOptions = {}): Matrices {
    return this.#apply(spec, options, (raw, side, tick) => raw.matrices(side, tick));
  }

  /** The properties of an operator on the side's surface. */
  check(spec: OperatorSpec, options: SyncOptions = {}): Check {
    const check = whole(this.#module.check);
    return this.#apply(spec, options, (raw, side, tick) => check(raw, side, tick));
  }

  /** The lowest eigenvalues of S x = μ M x, ascending. */
  spectrum(spec: OperatorSpec, count: number, options: SyncOptions = {}): Float64Array {
    const most = wholeNumber(count, 'the number of eigenvalues', 1);
    const spectrum = whole(this.#module.spectrum);
    return this.#apply(spec, options, (raw, side, tick) => spectrum(raw, side, most, tick));
  }

  /** Dirichlet energy of the side's surface, length². */
  energy(spec: OperatorSpec, options: SyncOptions = {}): number {
    return this.#apply(spec, options, (raw, side, tick) => raw.energy(side, tick));
  }

  /** The orthogonal dual of the side's surface. */
  dual(how: DualOptions = {}, options: SyncOptions = {}): Dual {
    const mu = realNumber(fields(how, 'the options of the dual').mu ?? 0, 'mu');
    const { side, onProgress } = optionsOf(options);
    const on = this.#side(side);
    const dual = whole(this.#module.dual);
    return this.#call((raw, tick) => dual(raw, on, mu, tick), onProgress);
  }

  /** Back to the loaded mesh; both sides if none is named. */
  reset(side?: Side): void {
    const sides: Side[] = side === undefined ? ['a', 'b'] : [side];
    for (const each of sides.map((name) => this.#side(name))) this.#call((raw) => raw.reset(each));
  }

  /** Puts a side onto given coordinates (3V), as after `step` smoothing steps. */
  restore(saved: Pick<Smoothed, 'coordinates' | 'step'>, options: SyncOptions = {}): void {
    const { coordinates, step } = fields(saved, 'a saved surface');
    const side = this.#side(optionsOf(options).side);
    const steps = wholeNumber(step, 'step', 0);
    const data = numbers(Float64Array, coordinates, 'coordinates', realNumber);
    this.#call((raw) => raw.restore(side, data, steps));
  }

  close(): void {
    this.#refuseIfBusy();
    this.#handle?.delete();
    this.#handle = undefined;
  }

  /** Every way into the core. Nothing may come in while C++ is at work on the session: it would be pulled from under it. */
  #call<T>(work: (raw: RawSession, tick: Tick | undefined) => Reply<T>, onProgress?: SyncOptions['onProgress']): T {
    this.#refuseIfBusy();
    const raw = this.#handle;
    if (!raw) throw badArgument('this mesh has been closed');
    this.#busy = true;
    try {
      return call((tick) => work(raw, tick), onProgress);
    } finally {
      this.#busy = false;
    }
  }

  /** A call with an operator. */
  #apply<T>(
    spec: OperatorSpec,
    options: SyncOptions,
    work: (raw: RawSession, side: RawSide, tick: Tick | undefined) => Reply<T>,
  ): T {
    const { id, settings, vertexWeights } = operatorParts(spec);
    const { side, onProgress } = optionsOf(options);
    const on = this.#side(side);
    this.#call((raw) => raw.setOperator(on, id, settings, vertexWeights));
    return this.#call((raw, tick) => work(raw, on, tick), onProgress);
  }

  #refuseIfBusy(): void {
    if (this.#busy) throw badArgument('this mesh is busy: one of its calls is still running');
  }

  #side(side: Side = 'a'): RawSide {
    return this.#module.Side[oneOf(side, ['a', 'b'], 'the side')];
  }
}
