/** What crosses between the page, the worker and the core. Vertices and faces count from 0. */
import type { OperatorId, OperatorSpec } from './generated.js';

/** Where a property holds: everywhere, on meshes of planar faces, on triangle meshes, or nowhere in general. */
export type Claim = 'yes' | 'planar' | 'triangles' | 'no';

interface ParameterBase {
  readonly id: string;
  /** What a control shows, e.g. λ. */
  readonly label: string;
  /** One short sentence, or empty. */
  readonly hint: string;
}

export interface RealParameter extends ParameterBase {
  readonly kind: 'real';
  /** What is allowed. */
  readonly min: number;
  readonly max: number;
  /** Where a slider ends; it starts at `min`. */
  readonly sliderMax: number;
  readonly step: number;
  readonly initial: number;
}

export interface ChoiceParameter extends ParameterBase {
  readonly kind: 'choice';
  readonly choices: readonly string[];
  readonly initial: string;
}

export type Parameter = RealParameter | ChoiceParameter;

/** One line of the operator table. */
export interface OperatorInfo {
  readonly id: OperatorId;
  readonly label: string;
  readonly summary: string;
  readonly formulaLatex: string;
  /** A `<math>` element. */
  readonly formulaMathml: string;
  readonly citation: string;
  readonly parameters: readonly Parameter[];
  /** Wardetzky et al. 2007, "Discrete Laplace operators: no free lunch". */
  readonly claims: {
    readonly symmetric: Claim;
    readonly positiveSemidefinite: Claim;
    readonly constantsInKernel: Claim;
    readonly linearPrecision: Claim;
    readonly positiveWeights: Claim;
  };
}

/** A mesh has two surfaces that smoothing moves apart; weights and harmonic functions look at one of them. */
export type Side = 'a' | 'b';

export interface MeshIssue {
  kind: 'unreferenced-vertices' | 'non-manifold-edges' | 'opposite-orientation';
  count: number;
  message: string;
}

export interface MeshInfo {
  vertices: number;
  faces: number;
  edges: number;
  components: number;
  /** Corners of the smallest and of the largest face. */
  minCorners: number;
  maxCorners: number;
  /** h², the mean squared edge length of the loaded mesh, length². */
  meanSquaredEdge: number;
  /** Vertices on an edge with one face, ascending. */
  boundary: Int32Array;
  issues: MeshIssue[];
}

/** What a viewer needs once per mesh. */
export interface Geometry {
  /** Centre of the bounding box: float positions are relative to it. */
  origin: [number, number, number];
  /** 3V, relative to `origin`. */
  positions: Float32Array;
  /** F+1 and one vertex per corner. */
  offsets: Int32Array;
  corners: Int32Array;
  /** 3T vertices; the planar operator's own triangulation. */
  triangles: Int32Array;
  /** T; bit k: side k → k+1 is an edge of the polygon. */
  triangleEdges: Uint8Array;
  /** T; the face of each triangle. */
  triangleFaces: Int32Array;
}

export interface Weights {
  /** Negative weights over ordered pairs (i, j), beyond 1e-10 of the largest diagonal entry. */
  negativeOrdered: number;
  /** All nonzero off-diagonal weights, ordered pairs. */
  nonzeroOrdered: number;
  smallest: number;
  largest: number;
  /** 2P vertices of the negative unordered pairs, and their P weights. */
  pairs: Int32Array;
  values: Float64Array;
  /** K line segments laid on the surface: 6K coordinates relative to the origin, start along the line (K), pair (K). */
  segments: Float32Array;
  segmentStarts: Float32Array;
  segmentPairs: Int32Array;
}

export interface Shape {
  /** Σ |a_f|, length². */
  area: number;
  /** Length³; null when the surface is not closed, with the reason. */
  volume: number | null;
  noVolume: string;
  /** Mean over faces of (RMS distance of the corners from their plane) / √|a|. */
  meanNonPlanarity: number;
  meanSquaredEdge: number;
}

export interface SmoothOptions {
  /** t in (M + tS)x' = Mx, length². */
  time: number;
  /** Default 1. */
  steps?: number;
  /** Build S and M anew before each step (default), or keep those of the loaded mesh. */
  rebuild?: boolean;
}

export interface Smoothed {
  /** Steps since the loaded mesh. */
  step: number;
  /** 3V, relative to the origin: for the GPU. */
  positions: Float32Array;
  /** 3V, as they are. */
  coordinates: Float64Array;
  stats: Shape;
}

export interface FixedValues {
  vertices: ArrayLike<number>;
  values: ArrayLike<number>;
}

export interface Harmonic {
  /** V; NaN at unreferenced vertices. */
  values: Float64Array;
  min: number;
  max: number;
  fixedMin: number;
  fixedMax: number;
  /** Vertices whose value leaves the fixed range: the maximum principle fails there. */
  outside: Int32Array;
}

/** A sparse matrix in compressed columns. */
export interface SparseMatrix {
  rows: number;
  cols: number;
  colStarts: Int32Array;
  rowIndices: Int32Array;
  values: Float64Array;
}

export interface Matrices {
  stiffness: SparseMatrix;
  mass: SparseMatrix;
}

/** Meshes made in code. `noise` moves vertices along their normals, in mean edge lengths (default 0); `seed` (default 1) chooses which noise. */
export type ShapeSpec =
  | { shape: 'torus'; nu: number; nv: number; major?: number; minor?: number; noise?: number; seed?: number }
  | { shape: 'grid'; nx: number; ny: number; width?: number; height?: number; noise?: number; seed?: number }
  | { shape: 'saddle'; n: number; height?: number; noise?: number; seed?: number };

export interface RunOptions {
  side?: Side;
  signal?: AbortSignal;
  /** fraction in [0, 1] */
  onProgress?: (fraction: number) => void;
}

export interface SmoothRunOptions extends RunOptions {
  /** Called after each step with the surface as it stands. */
  onStep?: (smoothed: Smoothed) => void;
}

/** A mesh that lives in the worker. Methods run one after the other, in the order of the calls. */
export interface Mesh extends MeshInfo {
  readonly name: string;
  readonly geometry: Geometry;
  weights(spec: OperatorSpec, run?: RunOptions): Promise<Weights>;
  shape(run?: RunOptions): Promise<Shape>;
  smooth(spec: OperatorSpec, options: SmoothOptions, run?: SmoothRunOptions): Promise<Smoothed>;
  harmonic(spec: OperatorSpec, fixed: FixedValues, run?: RunOptions): Promise<Harmonic>;
  matrices(spec: OperatorSpec, run?: RunOptions): Promise<Matrices>;
  /** The side's surface as OBJ text, 17 digits. */
  obj(run?: RunOptions): Promise<string>;
  /** Back to the loaded mesh; both sides if none is named. */
  reset(side?: Side): Promise<void>;
  close(): Promise<void>;
}

export interface Client {
  /** @throws PolylapError; the meshes opened before stay as they are */
  open(bytes: Uint8Array | ArrayBuffer | Blob | string, name: string, run?: RunOptions): Promise<Mesh>;
  make(shape: ShapeSpec): Promise<Mesh>;
  /** Called when the worker died or was ended to cancel, and has been started again with all meshes as they were. */
  onRestart?: (reason: string) => void;
  close(): void;
}
