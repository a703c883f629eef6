/** What the client and one of its workers say to each other. The client has one request under way at a time and keeps the queue. */
import type { ConversionSpec, OperatorSpec, ShapeSpec } from './generated.js';
import type { RawError } from './raw.js';
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
  Row,
  Shape,
  Side,
  Smoothed,
  SmoothOptions,
  Stability,
  StabilityOptions,
  Weights,
} from './types.js';

/** From what a mesh is made. */
export type Source =
  | { bytes: Uint8Array; name: string; options: OpenOptions }
  | { spec: ShapeSpec }
  | { arrays: MeshArrays };

export interface Opened {
  info: MeshInfo;
  geometry: Geometry;
  /** 3V, as they are: with the geometry's faces, all that another worker needs to have the same mesh. */
  coordinates: Float64Array;
}

/** The part of a surface that smoothing changes. */
export type Saved = Pick<Smoothed, 'coordinates' | 'step'>;

/** Each call with its arguments and its value. Meshes are numbered by the client. */
export interface Calls {
  open: { takes: { mesh: number; source: Source }; gives: Opened };
  /** Takes over a mesh that another worker opened. */
  adopt: { takes: { mesh: number; arrays: MeshArrays }; gives: undefined };
  close: { takes: { mesh: number }; gives: undefined };
  weights: { takes: OnSide & { spec: OperatorSpec }; gives: Weights };
  row: { takes: OnSide & { spec: OperatorSpec; vertex: number }; gives: Row };
  face: { takes: OnSide & { spec: OperatorSpec; face: number }; gives: FaceReport };
  shape: { takes: OnSide; gives: Shape };
  smooth: { takes: OnSide & { spec: OperatorSpec; options: SmoothOptions; showSteps: boolean }; gives: Smoothed };
  stability: { takes: OnSide & { spec: OperatorSpec; options: StabilityOptions }; gives: Stability };
  harmonic: { takes: OnSide & { spec: OperatorSpec; fixed: FixedValues }; gives: Harmonic };
  matrices: { takes: OnSide & { spec: OperatorSpec }; gives: Matrices };
  check: { takes: OnSide & { spec: OperatorSpec }; gives: Check };
  spectrum: { takes: OnSide & { spec: OperatorSpec; count: number }; gives: Float64Array };
  energy: { takes: OnSide & { spec: OperatorSpec }; gives: number };
  dual: { takes: OnSide & { options: DualOptions }; gives: Dual };
  file: { takes: OnSide & { format: MeshFormat }; gives: Uint8Array };
  /** The new mesh gets the number `made`. */
  convert: { takes: OnSide & { conversion: ConversionSpec; made: number }; gives: Opened };
  reset: { takes: OnSide; gives: undefined };
  restore: { takes: OnSide & { saved: Saved }; gives: undefined };
  convergence: { takes: { spec: OperatorSpec }; gives: ConvergenceStudy[] };
}

export interface OnSide {
  mesh: number;
  side: Side;
}

export type CallName = keyof Calls;
export type Takes<K extends CallName> = Calls[K]['takes'];
export type Gives<K extends CallName> = Calls[K]['gives'];

/** Call and arguments, as one of the pairs that belong together. */
export type RequestOf<K extends CallName> = { [C in K]: { call: C; takes: Takes<C> } }[K];
export type Request = RequestOf<CallName>;

export type ToWorker =
  /** First of all; without a module the worker gets it by itself. Whole: with what `check` and `convergence` need. */
  | { kind: 'start'; module: WebAssembly.Module | undefined; whole: boolean; warmUp: boolean }
  | { kind: 'request'; id: number; request: Request }
  | { kind: 'cancel'; id: number };

export type FromWorker =
  | { kind: 'ready' }
  /** The worker cannot go on: end it. */
  | { kind: 'failed'; message: string }
  | { kind: 'progress'; id: number; fraction: number }
  | { kind: 'step'; id: number; smoothed: Smoothed }
  | { kind: 'done'; id: number; value: Gives<CallName> }
  | { kind: 'error'; id: number; error: RawError };
