/** What crosses between the page, the worker and the core. Vertices and faces count from 0. */
import type { ConversionSpec, OperatorId, OperatorSpec, PropertyId, ShapeSpec } from './generated.js';

/** Where a property holds: everywhere, on meshes of planar faces, on triangle meshes, or nowhere in general. */
export type Claim = 'yes' | 'planar' | 'triangles' | 'some' | 'no';

/** What an operator claims of a property, and why. */
export interface PropertyClaim {
  readonly where: Claim;
  readonly why: string;
}

/** One line of the property table. */
export interface PropertyInfo {
  readonly id: PropertyId;
  readonly label: string;
  readonly meaning: string;
}

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

/** As a real one, but whole numbers only. */
export interface IntegerParameter extends Omit<RealParameter, 'kind'> {
  readonly kind: 'integer';
}

export interface ChoiceParameter extends ParameterBase {
  readonly kind: 'choice';
  readonly choices: readonly string[];
  readonly initial: string;
}

export type Parameter = RealParameter | IntegerParameter | ChoiceParameter;

/** One line of the operator table. */
export interface OperatorInfo {
  readonly id: OperatorId;
  readonly label: string;
  readonly summary: string;
  readonly formulaLatex: string;
  /** A `<math>` element. */
  readonly formulaMathml: string;
  readonly citation: string;
  /** One entry; operators of the same work have the same. */
  readonly bibtex: string;
  readonly parameters: readonly Parameter[];
  /** Whether a spec may have `vertexWeights`. */
  readonly takesVertexWeights: boolean;
  /** Wardetzky et al. 2007, "Discrete Laplace operators: no free lunch". */
  readonly claims: Readonly<Record<PropertyId, PropertyClaim>>;
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
  /** What reading the file did to its data. */
  notes: string[];
  repairs: Repairs;
}

/** A mesh as plain arrays. */
export interface MeshArrays {
  /** 3V. */
  coordinates: Float64Array;
  /** F+1: face f has the corners from offsets[f] to offsets[f + 1]. */
  offsets: Int32Array;
  /** One vertex per corner. */
  corners: Int32Array;
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

/** The row of a vertex in S. */
export interface Row {
  /** Ascending, the vertex itself among them. */
  columns: Int32Array;
  /** S_ij; none off the diagonal is 0. */
  values: Float64Array;
  /** M_ii, length². */
  mass: number;
  /** Lines from the vertex to the others, laid on the surface as those of Weights; `segmentPairs` counts in `columns`. */
  segments: Float32Array;
  segmentStarts: Float32Array;
  segmentPairs: Int32Array;
}

/** One face, as an operator sees it. */
export interface FaceReport {
  /** n vertices. */
  corners: Int32Array;
  /** length² */
  vectorArea: [number, number, number];
  /** Of length 1; 0 where the vector area is. */
  normal: [number, number, number];
  /** RMS distance of the corners from their plane over √|a|. */
  nonPlanarity: number;
  /** 2n coordinates of the corners seen along the vector area, counter-clockwise; empty where it is 0. */
  projected: Float64Array;
  /** 3T corners of the triangles that the operator cuts the face into; empty where it cuts none. */
  triangles: Int32Array;
  /** n², row by row: what the face adds to S; null where there is no such matrix, with the reason. */
  stiffness: Float64Array | null;
  noStiffness: string;
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

/**
 * Which equation a step solves. `implicit`: (M + tS)x' = Mx, stable for all t. `conformalised`: the same with S of the loaded mesh and M of the moved
 * surface, scaled to the area of the loaded mesh after each step (Kazhdan, Solomon & Ben-Chen 2012). `explicit`: x' = x − t M⁻¹ S x, see `stability`.
 */
export type Flow = 'implicit' | 'conformalised' | 'explicit';

export interface SmoothOptions {
  /** t, length². */
  time: number;
  /** Default 1. */
  steps?: number;
  /** Default `implicit`. */
  flow?: Flow;
  /** Build S and M anew before each step (default), or keep those of the loaded mesh. The conformalised flow has its own rule. */
  rebuild?: boolean;
  /** Scale the surface to the volume of the loaded mesh after each step; refused where there is none. Default false. */
  keepVolume?: boolean;
  /** Vertices on the boundary stay. Default false. */
  fixBoundary?: boolean;
}

/** Which S and M, and which rows of them. */
export type StabilityOptions = Pick<SmoothOptions, 'rebuild' | 'fixBoundary'>;

/** What bounds explicit steps: the ends of the spectrum of S x = λ M x, 1/length². A step multiplies the mode of λ by 1 − tλ. */
export interface Stability {
  largest: number;
  /** 0 where S is positive semi-definite. */
  smallest: number;
  /** Steps t below this are stable: 2 / largest, length². 0 if none is, Infinity if all are. */
  limit: number;
}

/** How a step was solved: by a factor, or iteratively where that is expected to take less time. */
export interface SmoothingSolve {
  /** Diagonal: nothing to solve, as in explicit steps with a lumped mass. */
  solver: 'cholesky' | 'lu' | 'conjugate-gradients' | 'diagonal';
  /** Of conjugate gradients; 0 otherwise. */
  iterations: number;
}

export interface Smoothed {
  /** Steps since the loaded mesh. */
  step: number;
  /** 3V, relative to the origin: for the GPU. */
  positions: Float32Array;
  /** 3V, as they are. */
  coordinates: Float64Array;
  stats: Shape;
  /** The last step; null where none of this session led to the surface. */
  solve: SmoothingSolve | null;
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

/** One line of the shape table or of the conversion table. */
export interface MakerInfo {
  readonly id: string;
  readonly label: string;
  readonly summary: string;
  readonly parameters: readonly Parameter[];
}

/** A property measured on a mesh. */
export interface Measurement {
  property: PropertyId;
  verdict: 'holds' | 'fails' | 'not-measured';
  /** The violation; 0 where it holds exactly. */
  value: number;
  /** For people. */
  text: string;
  /** The offending vertex or pair; empty if there is none. */
  vertices: number[];
}

/** What `check` finds: the properties in the order of the table (but for convergence), eigenvalues, kernel, condition. */
export interface Check {
  measurements: Measurement[];
  negativeOrdered: number;
  negativePairs: number;
  /** Of (S + Sᵀ)/2. */
  smallestEigenvalue: number;
  largestEigenvalue: number;
  /** Connected parts of the mesh. */
  components: number;
  kernelDimension: number;
  /** Whether the kernel may be larger than what was looked for. */
  kernelComplete: boolean;
  /** kernelDimension arrays of V values. */
  kernelModes: Float64Array[];
  /** Largest over smallest nonzero |eigenvalue|; Infinity if none is known. */
  condition: number;
  smallestMass: number;
  smallestMassVertex: number;
}

export interface DualOptions {
  /** 0 (default): exactly orthogonal, nearest to the barycentres; above: the compromise with this weight. */
  mu?: number;
}

/** The orthogonal dual (Herholz 2012, section 4.1). */
export interface Dual {
  /** 3F, relative to the origin: for the GPU. */
  positions: Float32Array;
  /** 3F, as they are. */
  coordinates: Float64Array;
  /** 2E vertices, 2E faces (-1: none), per edge of the mesh. */
  edgeVertices: Int32Array;
  edgeFaces: Int32Array;
  /** 3E points where dual edges cross, relative to the origin. */
  edgePoints: Float32Array;
  /** 2E signed distances of both dual vertices from the edge, length. */
  lengths: Float64Array;
  /** E weights w_ij. */
  weights: Float64Array;
  constraints: number;
  rank: number;
  nullSpace: number;
  /** Largest |⟨v_k - v_l, e⟩| over the largest |e|². */
  residual: number;
  worstEdge: number;
  /** Largest |v_k - b_k| / √|a_k|. */
  largestShift: number;
  worstFace: number;
  usable: boolean;
}

export interface ConvergenceLevel {
  vertices: number;
  h: number;
  error: number;
  /** NaN at the first level. */
  order: number;
}

export interface ConvergenceStudy {
  family: string;
  problem: string;
  onlyTriangles: boolean;
  /** All faces of all its meshes lie in planes. */
  planarFaces: boolean;
  levels: ConvergenceLevel[];
  order: number;
  converges: boolean;
  /** Why there are no more levels, or empty. */
  failure: string;
}

/** One kind of change that repair made. Elements are numbers of the file. */
export interface RepairChange {
  kind:
    | 'merged-vertices'
    | 'repeated-corners'
    | 'degenerate-faces'
    | 'duplicate-faces'
    | 'turned-faces'
    | 'unorientable-faces'
    | 'dropped-vertices';
  elements: Int32Array;
  message: string;
}

export interface Repairs {
  changes: RepairChange[];
  /** The vertex (face) of the file that each vertex (face) was; empty without repair. */
  originalVertices: Int32Array;
  originalFaces: Int32Array;
}

export interface OpenOptions {
  /** Repair what can be. */
  repair?: boolean;
  /** Vertices closer than this multiple of the bounding box's diagonal become one; default 0: only equal ones. */
  mergeDistance?: number;
}

export type MeshFormat = 'obj' | 'off' | 'ply' | 'stl';

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

/** A mesh that lives in the workers, one for each side. Of a side, methods run one after the other, in the order of the calls. */
export interface Mesh extends MeshInfo {
  readonly name: string;
  readonly geometry: Geometry;
  weights(spec: OperatorSpec, run?: RunOptions): Promise<Weights>;
  /** The row of a vertex. Does not wait for what was asked before: of the surface as it stands. */
  row(spec: OperatorSpec, vertex: number, run?: RunOptions): Promise<Row>;
  /** As `row`, of a face. */
  face(spec: OperatorSpec, face: number, run?: RunOptions): Promise<FaceReport>;
  shape(run?: RunOptions): Promise<Shape>;
  smooth(spec: OperatorSpec, options: SmoothOptions, run?: SmoothRunOptions): Promise<Smoothed>;
  /** What bounds the explicit step that the options describe, whatever their flow, time and steps. */
  stability(spec: OperatorSpec, options?: StabilityOptions, run?: RunOptions): Promise<Stability>;
  harmonic(spec: OperatorSpec, fixed: FixedValues, run?: RunOptions): Promise<Harmonic>;
  matrices(spec: OperatorSpec, run?: RunOptions): Promise<Matrices>;
  /** The properties of an operator on the side's surface. */
  check(spec: OperatorSpec, run?: RunOptions): Promise<Check>;
  /** The lowest eigenvalues of S x = μ M x, ascending, 1/length²; S must be symmetric and M diagonal. */
  spectrum(spec: OperatorSpec, count: number, run?: RunOptions): Promise<Float64Array>;
  /** Dirichlet energy of the side's surface, Σ xᵀ S x over its coordinates, length². */
  energy(spec: OperatorSpec, run?: RunOptions): Promise<number>;
  /** The orthogonal dual of the side's surface. */
  dual(options?: DualOptions, run?: RunOptions): Promise<Dual>;
  /** The side's surface as a file; text but for STL. */
  file(format: MeshFormat, run?: RunOptions): Promise<Uint8Array>;
  /** A new mesh made of the side's surface. */
  convert(conversion: ConversionSpec, run?: RunOptions): Promise<Mesh>;
  /** Puts a side onto given coordinates, as after so many smoothing steps. */
  restore(saved: Pick<Smoothed, 'coordinates' | 'step'>, run?: RunOptions): Promise<void>;
  /** Back to the loaded mesh; both sides if none is named. */
  reset(side?: Side): Promise<void>;
  close(): Promise<void>;
}

export interface Client {
  /** @throws PolylapError; the meshes opened before stay as they are */
  open(
    bytes: Uint8Array | ArrayBuffer | Blob | string,
    name: string,
    run?: Omit<RunOptions, 'side'> & OpenOptions,
  ): Promise<Mesh>;
  make(shape: ShapeSpec, run?: Omit<RunOptions, 'side'>): Promise<Mesh>;
  /** A mesh from arrays; they are copied. */
  fromArrays(arrays: MeshArrays, name: string, run?: Omit<RunOptions, 'side'>): Promise<Mesh>;
  /** A study on meshes of its own: does the operator converge under refinement? */
  convergence(spec: OperatorSpec, run?: Omit<RunOptions, 'side'>): Promise<ConvergenceStudy[]>;
  /** Called when a side's worker died or was ended to cancel, and has been started again; all meshes are as they were. */
  onRestart?: (reason: string, side: Side) => unknown;
  /** Called when more of the core is fetched for what was asked, and when that has ended. */
  onLoading?: (loading: boolean) => unknown;
  close(): void;
}
