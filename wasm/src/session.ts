/** The typed, synchronous API over the raw module: for Node and for the worker. Arrays it returns belong to the caller. */
import { PolylapError } from './error.js';
import type { ErrorCode, OperatorSpec } from './generated.js';
import type { RawModule, RawSession, RawSide, Reply, Tick } from './raw.js';
import type {
  FixedValues,
  Geometry,
  Harmonic,
  Matrices,
  MeshInfo,
  OperatorInfo,
  Shape,
  ShapeSpec,
  Side,
  Smoothed,
  SmoothOptions,
  Weights,
} from './types.js';

export interface SyncOptions {
  /** Default `a`. */
  side?: Side;
  /** fraction in [0, 1]; returning false stops the call with code `cancelled`. */
  onProgress?: (fraction: number) => boolean | undefined;
}

function badArgument(message: string): PolylapError {
  return new PolylapError('bad-argument', message);
}

/** Numbers that C++ would quietly cut to whole ones are refused here. */
export function wholeNumber(value: unknown, name: string, min = -(2 ** 31), max = 2 ** 31 - 1): number {
  if (typeof value !== 'number' || !Number.isInteger(value) || value < min || value > max) {
    throw badArgument(`${name} must be a whole number of at least ${min} and at most ${max}, not ${String(value)}`);
  }
  return value;
}

function realNumber(value: unknown, name: string): number {
  if (typeof value !== 'number') throw badArgument(`${name} must be a number, not ${String(value)}`);
  return value;
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
  const message = error instanceof Error ? error.message : String(error);
  if (error instanceof RangeError && /allocation|array length/i.test(message)) {
    return new PolylapError('out-of-memory', 'not enough memory for the result');
  }
  return new PolylapError('internal', `the core stopped: ${message}`);
}

/** The module, loaded: see load.ts. */
export class Polylap {
  readonly #module: RawModule;

  constructor(module: RawModule) {
    this.#module = module;
  }

  /** Reads a mesh file; the format follows from the ending of `name`. */
  open(bytes: Uint8Array | string, name: string, { onProgress }: Pick<SyncOptions, 'onProgress'> = {}): Session {
    const data = typeof bytes === 'string' ? new TextEncoder().encode(bytes) : bytes;
    return this.#own((tick) => this.#module.open(data, name, tick), onProgress);
  }

  make(spec: ShapeSpec): Session {
    const noise = realNumber(spec.noise ?? 0, 'noise');
    const seed = wholeNumber(spec.seed ?? 1, 'seed', 0, 2 ** 32 - 1);
    const module = this.#module;
    switch (spec.shape) {
      case 'torus': {
        const [nu, nv] = [wholeNumber(spec.nu, 'nu'), wholeNumber(spec.nv, 'nv')];
        const [major, minor] = [realNumber(spec.major ?? 1, 'major'), realNumber(spec.minor ?? 0.4, 'minor')];
        return this.#own(() => module.makeTorus(nu, nv, major, minor, noise, seed));
      }
      case 'grid': {
        const [nx, ny] = [wholeNumber(spec.nx, 'nx'), wholeNumber(spec.ny, 'ny')];
        const [width, height] = [realNumber(spec.width ?? 1, 'width'), realNumber(spec.height ?? 1, 'height')];
        return this.#own(() => module.makeGrid(nx, ny, width, height, noise, seed));
      }
      case 'saddle': {
        const n = wholeNumber(spec.n, 'n');
        const height = realNumber(spec.height ?? 1, 'height');
        return this.#own(() => module.makeSaddle(n, height, noise, seed));
      }
      default:
        throw badArgument(`no such shape: ${String((spec as { shape?: unknown }).shape)}`);
    }
  }

  /** The operator table as the core has it; `operators` in generated.ts is the same with MathML. */
  operators(): Omit<OperatorInfo, 'formulaMathml'>[] {
    return call(() => this.#module.operators());
  }

  errorCodes(): string[] {
    return call(() => this.#module.errorCodes());
  }

  /** Bytes of WebAssembly memory. It grows when needed and never shrinks. */
  memory(): number {
    return this.#module.HEAPU8.length;
  }

  #own(work: (tick: Tick | undefined) => Reply<RawSession>, onProgress?: SyncOptions['onProgress']): Session {
    return new Session(call(work, onProgress), this.#module.Side);
  }
}

/** One mesh with two sides. Call `close` when done: C++ memory is not garbage collected. */
export class Session {
  #handle: RawSession | undefined;
  readonly #sides: RawModule['Side'];

  constructor(raw: RawSession, sides: RawModule['Side']) {
    this.#handle = raw;
    this.#sides = sides;
  }

  get #raw(): RawSession {
    if (!this.#handle) throw badArgument('this mesh has been closed');
    return this.#handle;
  }

  info(): MeshInfo {
    return call(() => this.#raw.info());
  }

  geometry(): Geometry {
    return call(() => this.#raw.geometry());
  }

  /** The side's surface as it stands. */
  surface({ side }: SyncOptions = {}): Smoothed {
    const raw = this.#side(side);
    return call(() => this.#raw.surface(raw));
  }

  shape({ side }: SyncOptions = {}): Shape {
    const raw = this.#side(side);
    return call(() => this.#raw.shape(raw));
  }

  obj({ side }: SyncOptions = {}): string {
    const raw = this.#side(side);
    return call(() => this.#raw.obj(raw));
  }

  weights(spec: OperatorSpec, { side, onProgress }: SyncOptions = {}): Weights {
    const raw = this.#operator(side, spec);
    return call((tick) => this.#raw.weights(raw, tick), onProgress);
  }

  /** All steps or none: a step that fails or is stopped leaves the surface as it was. */
  smooth(spec: OperatorSpec, options: SmoothOptions, { side, onProgress }: SyncOptions = {}): Smoothed {
    const time = realNumber(options.time, 'time');
    const steps = wholeNumber(options.steps ?? 1, 'steps', 1);
    const raw = this.#operator(side, spec);
    call((tick) => this.#raw.smooth(raw, time, steps, options.rebuild ?? true, tick), onProgress);
    return call(() => this.#raw.surface(raw));
  }

  harmonic(spec: OperatorSpec, fixed: FixedValues, { side, onProgress }: SyncOptions = {}): Harmonic {
    const vertices = Int32Array.from(fixed.vertices, (vertex, k) => wholeNumber(vertex, `fixed vertex number ${k}`));
    const values = Float64Array.from(fixed.values, (value, k) => realNumber(value, `fixed value number ${k}`));
    const raw = this.#operator(side, spec);
    return call((tick) => this.#raw.harmonic(raw, vertices, values, tick), onProgress);
  }

  matrices(spec: OperatorSpec, { side, onProgress }: SyncOptions = {}): Matrices {
    const raw = this.#operator(side, spec);
    return call((tick) => this.#raw.matrices(raw, tick), onProgress);
  }

  /** Back to the loaded mesh; both sides if none is named. */
  reset(side?: Side): void {
    const sides: Side[] = side === undefined ? ['a', 'b'] : [side];
    for (const raw of sides.map((each) => this.#side(each))) call(() => this.#raw.reset(raw));
  }

  /** Puts a side onto given coordinates (3V), as after `step` smoothing steps. */
  restore({ coordinates, step }: Pick<Smoothed, 'coordinates' | 'step'>, { side }: SyncOptions = {}): void {
    const raw = this.#side(side);
    const steps = wholeNumber(step, 'step', 0);
    call(() => this.#raw.restore(raw, coordinates, steps));
  }

  close(): void {
    this.#handle?.delete();
    this.#handle = undefined;
  }

  #side(side: Side = 'a'): RawSide {
    if (side !== 'a' && side !== 'b') throw badArgument(`the side must be 'a' or 'b', not ${String(side)}`);
    return this.#sides[side];
  }

  #operator(side: Side | undefined, spec: OperatorSpec): RawSide {
    if (typeof spec !== 'object' || spec === null)
      throw badArgument(`an operator is given as {id: …}, not ${String(spec)}`);
    const raw = this.#side(side);
    call(() => this.#raw.setOperator(raw, spec));
    return raw;
  }
}
