import {
  BufferAttribute,
  BufferGeometry,
  GLSL3,
  InstancedBufferAttribute,
  InstancedBufferGeometry,
  LineSegments,
  Mesh,
  ShaderMaterial,
  Vector2,
  Vector3,
} from 'three';

/** Up to here lines are as wide as they should be; beyond, hairlines; beyond the second limit only some of them. */
export const wideLimit = 30_000;
export const drawnLimit = 400_000;

const shared = /* glsl */ `
uniform vec2 viewport;
uniform float halfWidth;
out float vAlong;
// A little nearer than the surface they lie on, so that they win where depths are equal.
vec4 lifted(vec4 p) { p.z -= 2e-5 * p.w; return p; }`;

const wideVertexShader = /* glsl */ `
${shared}
in vec3 from;
in vec3 to;
in float start;
void main() {
  vec4 eyeA = modelViewMatrix * vec4(from, 1.0);
  vec4 eyeB = modelViewMatrix * vec4(to, 1.0);
  vec4 a = projectionMatrix * eyeA;
  vec4 b = projectionMatrix * eyeB;
  vec2 along = (b.xy / b.w - a.xy / a.w) * viewport;
  float length2 = dot(along, along);
  vec2 across = length2 > 0.0 ? vec2(-along.y, along.x) * inversesqrt(length2) : vec2(0.0);
  vec4 p = mix(a, b, position.x);
  p.xy += across * position.y * 2.0 * halfWidth / viewport * p.w;
  vAlong = start + position.x * distance(from, to);
  gl_Position = lifted(p);
}`;

const thinVertexShader = /* glsl */ `
${shared}
in float start;
void main() {
  vAlong = start;
  gl_Position = lifted(projectionMatrix * modelViewMatrix * vec4(position, 1.0));
}`;

const fragmentShader = /* glsl */ `
uniform vec3 ink;
uniform float period;
in float vAlong;
out vec4 colour;
void main() {
  float phase = fract(vAlong / period);
  if (phase > 0.62) discard;
  colour = vec4(ink, 1.0);
}`;

export interface Segments {
  segments: Float32Array;
  segmentStarts: Float32Array;
  segmentPairs: Int32Array;
}

/** Dashed lines on a surface: dashed, so that they are never told by colour alone. */
export class DashedLines {
  readonly object: Mesh | LineSegments;
  /** 1: all of them are drawn; n: every n-th pair. */
  readonly thinning: number;
  readonly hairlines: boolean;
  readonly material: ShaderMaterial;

  constructor(lines: Segments) {
    const total = lines.segmentStarts.length;
    this.hairlines = total > wideLimit;
    this.thinning = Math.ceil(total / drawnLimit) || 1;
    this.material = new ShaderMaterial({
      glslVersion: GLSL3,
      vertexShader: this.hairlines ? thinVertexShader : wideVertexShader,
      fragmentShader,
      side: 2,
      uniforms: {
        viewport: { value: new Vector2(1, 1) },
        halfWidth: { value: 1 },
        period: { value: 1 },
        ink: { value: new Vector3() },
      },
    });
    this.object = this.hairlines
      ? new LineSegments(thinGeometry(lines, this.thinning), this.material)
      : new Mesh(wideGeometry(lines), this.material);
    this.object.frustumCulled = false;
    this.object.renderOrder = 1;
  }

  /** @param lengthPerPixel length on the model that a pixel covers in the middle of the view */
  fit(width: number, height: number, pixelRatio: number, lengthPerPixel: number): void {
    const { viewport, halfWidth, period } = this.material.uniforms;
    viewport?.value.set(width * pixelRatio, height * pixelRatio);
    if (halfWidth) halfWidth.value = 0.75 * pixelRatio;
    // In powers of two: dashes keep their size on screen without crawling as the camera moves.
    if (period) period.value = 2 ** Math.round(Math.log2(6 * lengthPerPixel));
  }

  dispose(): void {
    this.object.geometry.dispose();
    this.material.dispose();
  }
}

function wideGeometry({ segments, segmentStarts }: Segments): BufferGeometry {
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
  geometry.instanceCount = count;
  return geometry;
}

function thinGeometry({ segments, segmentStarts, segmentPairs }: Segments, thinning: number): BufferGeometry {
  const kept: number[] = [];
  for (let s = 0; s < segmentStarts.length; s++) if ((segmentPairs[s] as number) % thinning === 0) kept.push(s);
  const position = new Float32Array(6 * kept.length);
  const start = new Float32Array(2 * kept.length);
  kept.forEach((s, k) => {
    const ends = segments.subarray(6 * s, 6 * s + 6);
    position.set(ends, 6 * k);
    const [ax = 0, ay = 0, az = 0, bx = 0, by = 0, bz = 0] = ends;
    start[2 * k] = segmentStarts[s] as number;
    start[2 * k + 1] = (segmentStarts[s] as number) + Math.hypot(bx - ax, by - ay, bz - az);
  });
  const geometry = new BufferGeometry();
  geometry.setAttribute('position', new BufferAttribute(position, 3));
  geometry.setAttribute('start', new BufferAttribute(start, 1));
  return geometry;
}
