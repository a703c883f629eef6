import { DataTexture, FloatType, IntType, NearestFilter, RedFormat, RGBAFormat, RGBAIntegerFormat } from 'three';
import type { Geometry } from '../polylap.js';
import { loneSides } from './lone-sides.js';

/** Arrays too long for a uniform live in textures of this width; texel i is at (i % width, i / width). */
export const textureWidth = 2048;

export const fetchTexel = /* glsl */ `
ivec2 texel(int i) { return ivec2(i % ${textureWidth}, i / ${textureWidth}); }`;

const rowsFor = (count: number) => Math.max(1, Math.ceil(count / textureWidth));

/** Four floats a texel; `update` takes three and leaves the fourth 0. */
export class VectorTexture {
  readonly texture: DataTexture;
  private readonly data: Float32Array;

  constructor(count: number) {
    this.data = new Float32Array(rowsFor(count) * textureWidth * 4);
    this.texture = new DataTexture(this.data, textureWidth, rowsFor(count), RGBAFormat, FloatType);
  }

  update(vectors: Float32Array): void {
    for (let from = 0, to = 0; from < vectors.length; from += 3, to += 4) {
      this.data[to] = vectors[from] as number;
      this.data[to + 1] = vectors[from + 1] as number;
      this.data[to + 2] = vectors[from + 2] as number;
    }
    this.texture.needsUpdate = true;
  }
}

/** Stands for "no value": NaN does not survive every driver. */
export const noValue = 3e38;

/** A float a texel. */
export class ValueTexture {
  readonly texture: DataTexture;
  private readonly data: Float32Array;

  constructor(count: number) {
    this.data = new Float32Array(rowsFor(count) * textureWidth);
    this.texture = new DataTexture(this.data, textureWidth, rowsFor(count), RedFormat, FloatType);
    this.update(null);
  }

  update(values: Float64Array | null): void {
    const { data } = this;
    for (let i = 0; i < data.length; i++) {
      const value = values?.[i];
      data[i] = value !== undefined && Number.isFinite(value) ? value : noValue;
    }
    this.texture.needsUpdate = true;
  }
}

/**
 * Per triangle: its three vertices, and bits: its polygon edges (3), those at the boundary (3), where the other half of a
 * quad is (2; 1: the triangle before, 2: the one after), and the face.
 */
export function triangleTexture(geometry: Geometry): DataTexture {
  const { offsets, triangles, triangleEdges: edges, triangleFaces: faces } = geometry;
  const lone = loneSides(triangles, edges, geometry.positions.length / 3);
  const rows = rowsFor(faces.length);
  const data = new Int32Array(rows * textureWidth * 4);
  for (let t = 0; t < faces.length; t++) {
    for (let k = 0; k < 3; k++) data[4 * t + k] = triangles[3 * t + k] as number;
    const face = faces[t] as number;
    const quad = (offsets[face + 1] as number) - (offsets[face] as number) === 4;
    const half = !quad ? 0 : faces[t - 1] === face ? 1 : faces[t + 1] === face ? 2 : 0;
    data[4 * t + 3] = (face << 8) | (half << 6) | ((lone[t] as number) << 3) | (edges[t] as number);
  }
  const texture = new DataTexture(data, textureWidth, rows, RGBAIntegerFormat, IntType);
  texture.internalFormat = 'RGBA32I';
  texture.minFilter = texture.magFilter = NearestFilter;
  texture.needsUpdate = true;
  return texture;
}

/** Unit vector areas of the polygons: one normal for all triangles of a face. */
export function faceNormals(
  positions: Float32Array,
  offsets: Int32Array,
  corners: Int32Array,
  normals: Float32Array,
): void {
  for (let f = 0; f + 1 < offsets.length; f++) {
    const first = offsets[f] as number;
    const last = offsets[f + 1] as number;
    const o = 3 * (corners[first] as number);
    let [x, y, z] = [0, 0, 0];
    // Relative to the first corner, so that small faces far out keep their digits.
    for (let c = first + 1; c + 1 < last; c++) {
      const p = 3 * (corners[c] as number);
      const q = 3 * (corners[c + 1] as number);
      const px = (positions[p] as number) - (positions[o] as number);
      const py = (positions[p + 1] as number) - (positions[o + 1] as number);
      const pz = (positions[p + 2] as number) - (positions[o + 2] as number);
      const qx = (positions[q] as number) - (positions[o] as number);
      const qy = (positions[q + 1] as number) - (positions[o + 1] as number);
      const qz = (positions[q + 2] as number) - (positions[o + 2] as number);
      x += py * qz - pz * qy;
      y += pz * qx - px * qz;
      z += px * qy - py * qx;
    }
    const length = Math.hypot(x, y, z) || 1;
    normals[3 * f] = x / length;
    normals[3 * f + 1] = y / length;
    normals[3 * f + 2] = z / length;
  }
}
