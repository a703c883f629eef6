import {
  BufferGeometry,
  DoubleSide,
  GLSL3,
  type Material,
  Mesh,
  ShaderMaterial,
  type Texture,
  Vector2,
  Vector3,
} from 'three';
import type { Geometry } from '../polylap.js';
import { faceNormals, fetchTexel, noValue, ValueTexture, VectorTexture } from './data-texture.js';

/** Larger than any value, and differences with it are still numbers. */
const everything = noValue / 10;

/** Looks up a triangle's corner by gl_VertexID: a mesh needs no vertex buffers, and a step uploads V + F vectors only. */
const corner = /* glsl */ `
precision highp isampler2D;
uniform highp sampler2D positions;
uniform highp isampler2D triangles;
${fetchTexel}
ivec4 triangleAt(int t) { return texelFetch(triangles, texel(t), 0); }
ivec4 triangle() { return triangleAt(gl_VertexID / 3); }
int cornerOf(ivec4 t) { int k = gl_VertexID % 3; return k == 0 ? t.x : k == 1 ? t.y : t.z; }
vec4 cornerAt(int vertex) { return modelViewMatrix * vec4(texelFetch(positions, texel(vertex), 0).xyz, 1.0); }`;

/** In half of a quad, the side that is no edge is the diagonal; opposite of it are an ear here and the fourth corner there. */
const vertexShader = /* glsl */ `
${corner}
uniform highp sampler2D normals;
uniform highp sampler2D values;
uniform bool mapped;
flat out vec3 vNormal;
flat out int vEdges;
flat out vec4 vValues;
flat out vec3 vEar;
out vec3 vCorner;
out vec3 vEye;
float valueAt(int vertex) { return texelFetch(values, texel(vertex), 0).x; }
void main() {
  ivec4 t = triangle();
  int vertex = cornerOf(t);
  vec4 eye = cornerAt(vertex);
  int k = gl_VertexID % 3;
  vCorner = vec3(k == 0, k == 1, k == 2);
  vEdges = t.w & 63;
  vNormal = normalMatrix * texelFetch(normals, texel(t.w >> 8), 0).xyz;
  vValues = vec4(${noValue.toExponential(1)});
  vEar = vec3(0.0);
  if (mapped) {
    vValues = vec4(valueAt(t.x), valueAt(t.y), valueAt(t.z), 0.0);
    int partner = t.w >> 6 & 3;
    if (partner != 0) {
      int drawn = t.w & 7;
      ivec3 ear = ivec3(drawn == 5, drawn == 3, drawn == 6);
      ivec3 rest = triangleAt(gl_VertexID / 3 + 2 * partner - 3).xyz - t.xyz + ear * t.xyz;
      vValues.w = valueAt(rest.x + rest.y + rest.z);
      vEar = vec3(ear);
    }
  }
  vEye = eye.xyz;
  gl_Position = projectionMatrix * eye;
}`;

/** Where light comes from, as the eye sees it. */
export const lightFrom = [-0.55, 0.75, 0.5] as const;

/** Of the lines that hatch, horizontally and in CSS pixels. */
const hatchPeriod = 8;

/**
 * `weights` of the three corners and, in quads, the fourth: bilinear there, so that neither diagonal is preferred. All are ≥ 0 and
 * no value exceeds those of the corners, not even by rounding. `hatch` slants up to the right above what is allowed, down below it.
 * Edges at the boundary are twice as wide, for nothing draws their other half.
 */
const fragmentShader = /* glsl */ `
uniform sampler2D map;
uniform vec2 range;
uniform vec2 allowed;
uniform float isolines;
uniform vec3 lit;
uniform vec3 shade;
uniform vec3 edge;
uniform vec3 card;
uniform float faded;
uniform float edges;
uniform float pixelRatio;
flat in vec3 vNormal;
flat in int vEdges;
flat in vec4 vValues;
flat in vec3 vEar;
in vec3 vCorner;
in vec3 vEye;
out vec4 colour;
vec4 weights() {
  vec3 b = max(vCorner, 0.0);
  b /= b.x + b.y + b.z;
  float t = dot(vEar, b.yzx * b.zxy);
  return vec4(b + t * (2.0 * vEar - 1.0), t);
}
float hatch(vec4 w) {
  float above = dot(w, vValues - allowed.y);
  float below = dot(w, allowed.x - vValues);
  float beyond = max(above, below);
  float across = (gl_FragCoord.x + (above > below ? -1.0 : 1.0) * gl_FragCoord.y) / pixelRatio / ${hatchPeriod.toFixed(1)};
  float off = abs(fract(across) - 0.5) * ${hatchPeriod.toFixed(1)};
  return beyond > 0.0 ? 1.0 - smoothstep(0.6, 1.3, off) : 0.0;
}
void main() {
  vec3 n = normalize(vNormal);
  if (dot(n, vEye) > 0.0) n = -n;
  float light = 0.5 + 0.5 * dot(n, normalize(vec3(${lightFrom})));
  vec3 surface = mix(mix(shade, lit, light * light), card, faded);
  vec3 drawnEdge = edge;
  if (max(vValues.x, max(vValues.y, vValues.z)) < ${everything.toExponential(1)}) {
    vec4 w = weights();
    float value = dot(w, vValues);
    float t = clamp((value - range.x) / (range.y - range.x), 0.0, 1.0);
    surface = texture(map, vec2((t * 255.0 + 0.5) / 256.0, 0.5)).rgb * mix(0.78, 1.0, light);
    // Against dark colours edges are lighter, against light ones darker.
    float bright = dot(surface, vec3(0.3, 0.6, 0.1));
    drawnEdge = bright < 0.3 ? mix(surface, vec3(1.0), 0.3) : 0.45 * surface;
    // Lines of equal value, as wide everywhere; where they would run into each other there are none.
    float level = (value - range.x) / (range.y - range.x) * isolines;
    float wide = fwidth(level);
    float off = abs(fract(level + 0.5) - 0.5) / max(wide, 1e-9);
    float isoline = isolines > 0.0 ? (1.0 - smoothstep(0.7, 1.4, off / pixelRatio)) * (1.0 - smoothstep(0.2, 0.5, wide)) : 0.0;
    surface = mix(surface, vec3(bright < 0.45), max(0.85 * isoline, 0.7 * hatch(w)));
    if (isolines > 0.0) drawnEdge = mix(surface, drawnEdge, 0.35);
  }
  // Distance to each side in pixels; side k lies opposite corner k + 2.
  vec3 width = fwidth(vCorner);
  vec3 away = vCorner / max(width, vec3(1e-6));
  vec3 drawn = vec3(vEdges & 1, vEdges >> 1 & 1, vEdges >> 2 & 1);
  vec3 wide = 1.0 + vec3(vEdges >> 3 & 1, vEdges >> 4 & 1, vEdges >> 5 & 1);
  vec3 near = drawn * (1.0 - smoothstep(vec3(0.0), wide, away.zxy / pixelRatio));
  // Where triangles shrink to a few pixels edges fade, instead of painting everything dark.
  float room = 1.0 - smoothstep(0.12, 0.45, max(width.x, max(width.y, width.z)));
  float line = max(near.x, max(near.y, near.z)) * mix(0.2, 1.0, room) * edges;
  colour = vec4(mix(surface, drawnEdge, line), 1.0);
}`;

export interface Interval {
  min: number;
  max: number;
}

export type Colours = Record<'lit' | 'shade' | 'edge' | 'spoke' | 'negative' | 'ink' | 'card' | 'accent', Vector3>;

/** One side's surface. */
export class Surface {
  readonly mesh: Mesh;
  readonly positions: VectorTexture;
  readonly values: ValueTexture;
  readonly material: ShaderMaterial;
  /** 3V, as drawn. */
  points: Float32Array;
  private shown: Float64Array | null = null;
  private readonly normals: VectorTexture;
  /** 3F, unit length. */
  readonly faceNormals: Float32Array;

  constructor(
    private readonly geometry: Geometry,
    vertexCount: number,
    triangles: Texture,
    map: Texture,
  ) {
    const faces = geometry.offsets.length - 1;
    this.positions = new VectorTexture(vertexCount);
    this.values = new ValueTexture(vertexCount);
    this.normals = new VectorTexture(faces);
    this.faceNormals = new Float32Array(3 * faces);
    this.points = geometry.positions;
    const corners = { positions: { value: this.positions.texture }, triangles: { value: triangles } };
    this.material = new ShaderMaterial({
      glslVersion: GLSL3,
      vertexShader,
      fragmentShader,
      side: DoubleSide,
      // Leaves room for the lines that lie on the surface.
      polygonOffset: true,
      polygonOffsetFactor: 1.5,
      polygonOffsetUnits: 2,
      uniforms: {
        ...corners,
        normals: { value: this.normals.texture },
        values: { value: this.values.texture },
        map: { value: map },
        mapped: { value: false },
        range: { value: new Vector2(0, 1) },
        allowed: { value: new Vector2(-everything, everything) },
        isolines: { value: 0 },
        lit: { value: new Vector3(1, 1, 1) },
        shade: { value: new Vector3() },
        edge: { value: new Vector3() },
        card: { value: new Vector3() },
        faded: { value: 0 },
        edges: { value: 1 },
        pixelRatio: { value: 1 },
      },
    });
    const buffer = new BufferGeometry();
    buffer.setDrawRange(0, geometry.triangles.length);
    this.mesh = new Mesh(buffer, this.material as Material);
    this.mesh.frustumCulled = false;
    this.move(geometry.positions);
  }

  move(points: Float32Array): void {
    this.points = points;
    this.positions.update(points);
    faceNormals(points, this.geometry.offsets, this.geometry.corners, this.faceNormals);
    this.normals.update(this.faceNormals);
  }

  /** @param allowed beyond this values are hatched; null: none is */
  show(values: Float64Array | null, range: Interval | null, colours: Texture, allowed: Interval | null): void {
    // The other side's may be all that has changed.
    if (values !== this.shown) this.values.update(values);
    this.shown = values;
    const { mapped, map, range: shown, allowed: limits } = this.material.uniforms;
    if (limits) limits.value.set(allowed?.min ?? -everything, allowed?.max ?? everything);
    if (map) map.value = colours;
    if (mapped) mapped.value = values !== null && range !== null;
    if (range && shown) shown.value.set(range.min, range.max);
  }

  /** @param count how many spaces they divide the range into; 0: there are none */
  drawIsolines(count: number): void {
    if (this.material.uniforms.isolines) this.material.uniforms.isolines.value = count;
  }

  /** @param faded how far the surface steps back behind what is drawn on it, 0 … 1   @param edges how strong its edges are, 0 … 1 */
  fade(faded: number, edges: number): void {
    const { uniforms } = this.material;
    if (uniforms.faded) uniforms.faded.value = faded;
    if (uniforms.edges) uniforms.edges.value = edges;
  }

  dispose(): void {
    for (const { texture } of [this.positions, this.values, this.normals]) texture.dispose();
    this.material.dispose();
    this.mesh.geometry.dispose();
  }
}
