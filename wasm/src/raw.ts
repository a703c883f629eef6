/** The module that Emscripten makes of wasm/bindings, as it is. Everything else goes through session.ts. */
import type {
  Check,
  ConvergenceStudy,
  Dual,
  FaceReport,
  Geometry,
  Harmonic,
  MakerInfo,
  Matrices,
  MeshInfo,
  OperatorInfo,
  PropertyInfo,
  Row,
  Shape,
  Smoothed,
  SmoothOptions,
  Stability,
  Weights,
} from './types.js';

export interface RawError {
  code: string;
  message: string;
  element: number;
  line: number;
}

export type Reply<T> = { ok: T; error?: never } | { ok?: never; error: RawError };

/** fraction in [0, 1] → go on? */
export type Tick = (fraction: number) => boolean;

/** A value of an embind enum. */
export interface RawSide {
  readonly value: number;
}

/** Parameters by name; undefined ones take their default. */
export type Settings = Record<string, number | string | undefined>;

export interface RawSession {
  info(): Reply<MeshInfo>;
  geometry(): Reply<Geometry>;
  coordinates(): Reply<Float64Array>;
  surface(side: RawSide): Reply<Smoothed>;
  shape(side: RawSide): Reply<Shape>;
  setOperator(side: RawSide, id: string, settings: Settings, vertexWeights: Float64Array | undefined): Reply<void>;
  weights(side: RawSide, tick: Tick | undefined): Reply<Weights>;
  row(side: RawSide, vertex: number, tick: Tick | undefined): Reply<Row>;
  face(side: RawSide, face: number): Reply<FaceReport>;
  energy(side: RawSide, tick: Tick | undefined): Reply<number>;
  smooth(side: RawSide, options: Required<SmoothOptions>, tick: Tick | undefined): Reply<void>;
  stability(side: RawSide, options: Required<SmoothOptions>, tick: Tick | undefined): Reply<Stability>;
  harmonic(side: RawSide, vertices: Int32Array, values: Float64Array, tick: Tick | undefined): Reply<Harmonic>;
  matrices(side: RawSide, tick: Tick | undefined): Reply<Matrices>;
  reset(side: RawSide): Reply<void>;
  restore(side: RawSide, coordinates: Float64Array, steps: number): Reply<void>;
  /** Frees the C++ object; the only way to do so. */
  delete(): void;
}

export interface RawModule {
  Side: { a: RawSide; b: RawSide };
  /** Another array after the memory has grown. */
  HEAPU8: Uint8Array;
  fromArrays(
    coordinates: Float64Array,
    offsets: Int32Array,
    corners: Int32Array,
    tick: Tick | undefined,
  ): Reply<RawSession>;
  make(id: string, settings: Settings, noise: number, seed: number): Reply<RawSession>;
  operatorIds(): Reply<string[]>;

  // What follows the smaller module has not.
  open?(
    bytes: Uint8Array,
    name: string,
    repair: boolean,
    mergeDistance: number,
    tick: Tick | undefined,
  ): Reply<RawSession>;
  file?(session: RawSession, side: RawSide, format: string): Reply<Uint8Array>;
  convert?(session: RawSession, side: RawSide, id: string, settings: Settings): Reply<RawSession>;
  dual?(session: RawSession, side: RawSide, mu: number, tick: Tick | undefined): Reply<Dual>;
  check?(session: RawSession, side: RawSide, tick: Tick | undefined): Reply<Check>;
  spectrum?(session: RawSession, side: RawSide, count: number, tick: Tick | undefined): Reply<Float64Array>;
  convergence?(
    id: string,
    settings: Settings,
    vertexWeights: Float64Array | undefined,
    tick: Tick | undefined,
  ): Reply<ConvergenceStudy[]>;
  operators?(): Reply<Omit<OperatorInfo, 'formulaMathml'>[]>;
  properties?(): Reply<PropertyInfo[]>;
  shapes?(): Reply<MakerInfo[]>;
  conversions?(): Reply<MakerInfo[]>;
  errorCodes?(): Reply<string[]>;
}

export type CreateModule = (options?: {
  wasmBinary?: ArrayBuffer | Uint8Array;
  instantiateWasm?: (
    imports: WebAssembly.Imports,
    done: (instance: WebAssembly.Instance, module: WebAssembly.Module) => void,
  ) => object;
  locateFile?: (path: string, directory: string) => string;
}) => Promise<RawModule>;
