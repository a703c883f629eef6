import {
  BufferAttribute,
  BufferGeometry,
  DoubleSide,
  GLSL3,
  InstancedBufferAttribute,
  InstancedBufferGeometry,
  LineSegments,
  Mesh,
  ShaderMaterial,
  Vector2,
  Vector3,
} from 'three';

/** Up to here lines are as wide as they should be; beyond, hairlines. */
export const wideLimit = 30_000;

const shared = /* glsl */ `
uniform vec2 viewport;
uniform float halfWidth;
uniform float lift;
out float vAlong;
// Nearer by a length for what lies close to the surface rather than on it.
vec4 raised(vec3 p) {
  vec4 eye = modelViewMatrix * vec4(p, 1.0);
  eye.xyz *= 1.0 - lift / length(eye.xyz);
  return projectionMatrix * eye;
}
// A little nearer than the surface they lie on, so that they win where depths are equal.
vec4 lifted(vec4 p) { p.z -= 2e-5 * p.w; return p; }`;

const wideVertexShader = /* glsl */ `
${shared}
in vec3 from;
in vec3 to;
in float start;
in float share;
void main() {
  vec4 a = raised(from);
  vec4 b = raised(to);
  vec2 along = (b.xy / b.w - a.xy / a.w) * viewport;
  float length2 = dot(along, along);
  vec2 across = length2 > 0.0 ? vec2(-along.y, along.x) * inversesqrt(length2) : vec2(0.0);
  vec4 p = mix(a, b, position.x);
  p.xy += across * position.y * 2.0 * share * halfWidth / viewport * p.w;
  vAlong = start + position.x * distance(from, to);
  gl_Position = lifted(p);
}`;

const thinVertexShader = /* glsl */ `
${shared}
in float start;
void main() {
  vAlong = start;
  gl_Position = lifted(raised(position));
}`;

const fragmentShader = /* glsl */ `
uniform vec3 ink;
uniform float period;
uniform float drawn;
uniform float opacity;
uniform vec3 card;
uniform bool filled;
in float vAlong;
out vec4 colour;
void main() {
  bool gap = fract(vAlong / period) > drawn;
  if (gap && !filled) discard;
  colour = vec4(gap ? card : ink, opacity);
}`;

/** Mean length in pixels from which on lines are fully drawn. */
const clearLength = 8;

export interface Segments {
  /** 6 a segment: both ends. */
  segments: Float32Array;
  /** Length along its line; all 0 for lines that are not dashed. */
  segmentStarts: Float32Array;
  /** How wide each is, a share of the stroke's width; without, all are as wide as that. */
  shares?: Float32Array;
}

export interface Stroke {
  ink: 'negative' | 'accent' | 'spoke';
  dashed: boolean;
  /** In CSS pixels. */
  width: number;
  /** How much nearer to the eye they are drawn, a length. */
  lift: number;
  /** Also where the segments are short; others become a tint there. */
  opaque?: boolean;
  /** Gaps between dashes are filled with the colour of the card: what lies below does not show through. */
  filled?: boolean;
  /** A dash and its gap, in CSS pixels, about. */
  period?: number;
  /** At most that share of their mean length on screen wide. */
  slender?: number;
}

/** Lines on a surface, or close to it. */
export class Lines {
  readonly object: Mesh | LineSegments;
  readonly material: ShaderMaterial;
  readonly ink: Stroke['ink'];
  private readonly meanLength: number;

  constructor(
    lines: Segments,
    private readonly stroke: Stroke,
  ) {
    const { ink, dashed, lift, opaque = false, filled = false } = stroke;
    this.ink = ink;
    const total = lines.segmentStarts.length;
    const hairlines = total > wideLimit;
    this.material = new ShaderMaterial({
      glslVersion: GLSL3,
      vertexShader: hairlines ? thinVertexShader : wideVertexShader,
      fragmentShader,
      side: DoubleSide,
      transparent: true,
      depthWrite: false,
      uniforms: {
        viewport: { value: new Vector2(1, 1) },
        halfWidth: { value: 1 },
        period: { value: 1 },
        drawn: { value: dashed ? 0.62 : 2 },
        lift: { value: lift },
        opacity: { value: 1 },
        ink: { value: new Vector3() },
        card: { value: new Vector3() },
        filled: { value: filled },
      },
    });
    Object.assign(this.material.defaultAttributeValues, { share: [1] });
    this.meanLength = opaque ? Infinity : meanLength(lines.segments);
    this.object = hairlines
      ? new LineSegments(thinGeometry(lines), this.material)
      : new Mesh(wideGeometry(lines), this.material);
    this.object.frustumCulled = false;
    this.object.renderOrder = 1;
  }

  /** @param lengthPerPixel length on the model that a pixel covers in the middle of the view */
  fit(width: number, height: number, pixelRatio: number, lengthPerPixel: number): void {
    const { viewport, halfWidth, period, opacity } = this.material.uniforms;
    viewport?.value.set(width * pixelRatio, height * pixelRatio);
    // Lines a few pixels apart would hide the surface: they become a tint.
    if (opacity) opacity.value = Math.min(1, Math.max(0.12, this.meanLength / lengthPerPixel / clearLength));
    const { width: full, slender = Infinity } = this.stroke;
    if (halfWidth) halfWidth.value = (Math.min(full, (slender * this.meanLength) / lengthPerPixel) / 2) * pixelRatio;
    // In powers of two: dashes keep their size on screen without crawling as the camera moves.
    if (period) period.value = 2 ** Math.round(Math.log2((this.stroke.period ?? 6) * lengthPerPixel));
  }

  dispose(): void {
    this.object.geometry.dispose();
    this.material.dispose();
  }
}

function wideGeometry({ segments, segmentStarts, shares }: Segments): BufferGeometry {
  const geometry = new InstancedBufferGeometry();
  geometry.setAttribute('position', new BufferAttribute(new Float32Array([0, -1, 0, 1, -1, 0, 0, 1, 0, 1, 1, 0]), 3));
  geometry.setIndex([0, 1, 2, 2, 1, 3]);
  const count = segmentStarts.length;
  const from = new Float32Array(3 * count);
  const to = new Float32Array(3 * count);
  for (let s = 0; s < count; s++) {
    from.set(segments.subarray(6 * s, 6 * s + 3), 3 * s);
    to.set(segments.subarray(6 * s + 3, 6 * s + 6), 3 * s);
  }
  geometry.setAttribute('from', new InstancedBufferAttribute(from, 3));
  geometry.setAttribute('to', new InstancedBufferAttribute(to, 3));
  geometry.setAttribute('start', new InstancedBufferAttribute(segmentStarts, 1));
  if (shares) geometry.setAttribute('share', new InstancedBufferAttribute(shares, 1));
  geometry.instanceCount = count;
  return geometry;
}

function thinGeometry({ segments, segmentStarts }: Segments): BufferGeometry {
  const start = new Float32Array(2 * segmentStarts.length);
  segmentStarts.forEach((from, s) => {
    start[2 * s] = from;
    start[2 * s + 1] = from + segmentLength(segments, s);
  });
  const geometry = new BufferGeometry();
  geometry.setAttribute('position', new BufferAttribute(segments, 3));
  geometry.setAttribute('start', new BufferAttribute(start, 1));
  return geometry;
}

function segmentLength(segments: Float32Array, s: number): number {
  const d = (k: number) => (segments[6 * s + 3 + k] as number) - (segments[6 * s + k] as number);
  return Math.hypot(d(0), d(1), d(2));
}

function meanLength(segments: Float32Array): number {
  const total = segments.length / 6;
  let sum = 0;
  for (let s = 0; s < total; s++) sum += segmentLength(segments, s);
  return sum / total;
}
