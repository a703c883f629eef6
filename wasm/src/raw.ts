/** The module that Emscripten makes of bindings.cpp, as it is. Everything else goes through session.ts. */
import type { Geometry, Harmonic, Matrices, MeshInfo, OperatorInfo, PropertyInfo, Shape, Smoothed, Weights } from './types.js';

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

export interface RawSession {
  info(): Reply<MeshInfo>;
  geometry(): Reply<Geometry>;
  surface(side: RawSide): Reply<Smoothed>;
  shape(side: RawSide): Reply<Shape>;
  obj(side: RawSide): Reply<string>;
  setOperator(side: RawSide, spec: object): Reply<void>;
  weights(side: RawSide, tick: Tick | undefined): Reply<Weights>;
  smooth(side: RawSide, time: number, steps: number, rebuild: boolean, tick: Tick | undefined): Reply<void>;
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
  open(bytes: Uint8Array, name: string, tick: Tick | undefined): Reply<RawSession>;
  makeTorus(nu: number, nv: number, major: number, minor: number, noise: number, seed: number): Reply<RawSession>;
  makeGrid(nx: number, ny: number, width: number, height: number, noise: number, seed: number): Reply<RawSession>;
  makeSaddle(n: number, height: number, noise: number, seed: number): Reply<RawSession>;
  operators(): Reply<Omit<OperatorInfo, 'formulaMathml'>[]>;
  properties(): Reply<PropertyInfo[]>;
  errorCodes(): Reply<string[]>;
}

export type CreateModule = (options?: {
  wasmBinary?: ArrayBuffer | Uint8Array;
  locateFile?: (path: string, directory: string) => string;
}) => Promise<RawModule>;
