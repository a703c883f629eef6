import type { Difference } from './difference.js';
import type {
  Check,
  ConvergenceStudy,
  Dual,
  FaceReport,
  Harmonic,
  Matrices,
  Mesh,
  Row,
  Shape,
  Side,
  SmoothingSolve,
  Stability,
  Weights,
} from './polylap.js';
import { t } from './words.js';

/** What the core said about one side's surface. A string stands where it said why not. */
export interface SideResults {
  /** Smoothing steps since the loaded mesh. */
  step: number;
  /** 3V, relative to the geometry's origin. */
  positions: Float32Array;
  shape: Shape | null;
  /** The step that led here. */
  solve: SmoothingSolve | null;
  /** Of an explicit step from here. */
  stability: Stability | string | null;
  weights: Weights | string | null;
  harmonic: Harmonic | string | null;
  matrices: Matrices | string | null;
  /** Of the selected vertex, or of the one selected before until its own is there. */
  row: (Row & { vertex: number }) | string | null;
  /** Of the selected face; the same. */
  face: (FaceReport & { face: number }) | string | null;
  check: Check | string | null;
  /** The lowest eigenvalues, once somebody has asked for them. */
  spectrum: Float64Array | string | null;
  dual: Dual | string | null;
  /** Dirichlet energy of the surface after a step. */
  energy: { readonly step: number; readonly value: number } | string | null;
  /** Of the operator, on meshes of the study's own. */
  study: readonly ConvergenceStudy[] | string | null;
}

export interface Message {
  title: string;
  text: string;
  /** One line each. */
  list?: readonly string[];
  /** What can be done about it. */
  offer?: { label: string; act: () => unknown };
}

export interface Busy {
  label: string;
  /** In [0, 1]; null as long as nothing was reported. */
  fraction: number | null;
}

/** Where a measurement went wrong. */
export interface Place {
  side: Side;
  vertices: readonly number[];
}

export interface Results {
  mesh: Mesh | null;
  a: SideResults;
  b: SideResults;
  error: Message | null;
  /** What was done to a file on its way in. */
  report: Message | null;
  /** Of the sides, while somebody looks at it. */
  difference: Difference | null;
  /** The status line. */
  notice: string;
  busy: Busy | null;
  playing: boolean;
  /** Vertex under the pointer. */
  hovered: number | null;
  /** In Weights, the face that a click would select, where it would select no vertex. */
  hoveredFace: number | null;
  /** Of the dual, the one that is read. */
  edge: number | null;
  /** What the camera was turned to. */
  place: Place | null;
  /** What the next undo would take back, and the next redo bring again; in English. */
  undoes: string | null;
  redoes: string | null;
}

export function freshSide(positions: Float32Array = new Float32Array(0)): SideResults {
  return {
    step: 0,
    positions,
    shape: null,
    solve: null,
    stability: null,
    weights: null,
    harmonic: null,
    matrices: null,
    row: null,
    face: null,
    check: null,
    spectrum: null,
    dual: null,
    energy: null,
    study: null,
  };
}

export function noResults(): Results {
  return {
    mesh: null,
    a: freshSide(),
    b: freshSide(),
    error: null,
    report: null,
    difference: null,
    notice: t('Starting …'),
    busy: null,
    playing: false,
    hovered: null,
    hoveredFace: null,
    edge: null,
    place: null,
    undoes: null,
    redoes: null,
  };
}

/** What is there, of something that may be unknown or refused. */
export function known<T extends object>(answer: T | string | null): T | null {
  return typeof answer === 'string' ? null : answer;
}
