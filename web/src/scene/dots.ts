import { BufferAttribute, BufferGeometry, GLSL3, Points, ShaderMaterial, Vector3 } from 'three';

const vertexShader = /* glsl */ `
uniform float pixelRatio;
uniform float size;
uniform float lift;
void main() {
  vec4 eye = modelViewMatrix * vec4(position, 1.0);
  eye.xyz *= 1.0 - lift / length(eye.xyz);
  gl_Position = projectionMatrix * eye;
  gl_PointSize = pixelRatio * size;
}`;

const fragmentShader = /* glsl */ `
uniform vec3 ink;
uniform vec3 card;
uniform int shape;
out vec4 colour;
void main() {
  float r = length(2.0 * gl_PointCoord - 1.0);
  float soft = fwidth(r);
  float body = 1.0 - smoothstep(1.0 - soft, 1.0, r);
  if (body < 0.04) discard;
  vec2 p = abs(2.0 * gl_PointCoord - 1.0);
  float inside = shape == 1 ? 1.0 - smoothstep(0.5 - soft, 0.5, r) : 0.0;
  if (shape == 2) inside = p.x < 0.58 && p.y < 0.16 ? 0.0 : 1.0;
  colour = vec4(mix(ink, card, inside), body);
}`;

const shapes = ['full', 'hollow', 'minus'] as const;

export interface Dot {
  ink: 'accent' | 'negative';
  /** What tells them apart beside colour. */
  shape: (typeof shapes)[number];
  /** In CSS pixels, where they have room. */
  size: number;
  /** How much nearer to the eye they are drawn, a length. */
  lift: number;
  /** Between neighbours, a length. */
  spacing: number;
}

/** Points of their own, unlike markers, which sit on vertices. */
export class Dots {
  readonly object: Points;
  readonly material: ShaderMaterial;
  readonly ink: Dot['ink'];

  constructor(
    positions: Float32Array,
    private readonly dot: Dot,
  ) {
    this.ink = dot.ink;
    this.material = new ShaderMaterial({
      glslVersion: GLSL3,
      vertexShader,
      fragmentShader,
      transparent: true,
      depthWrite: false,
      uniforms: {
        pixelRatio: { value: 1 },
        size: { value: dot.size },
        lift: { value: dot.lift },
        shape: { value: shapes.indexOf(dot.shape) },
        ink: { value: new Vector3() },
        card: { value: new Vector3() },
      },
    });
    const geometry = new BufferGeometry();
    geometry.setAttribute('position', new BufferAttribute(positions, 3));
    this.object = new Points(geometry, this.material);
    this.object.frustumCulled = false;
    this.object.renderOrder = 1.5;
  }

  /** Smaller where they would touch each other. */
  fit(_width: number, _height: number, pixelRatio: number, lengthPerPixel: number): void {
    const { pixelRatio: ratio, size } = this.material.uniforms;
    if (ratio) ratio.value = pixelRatio;
    if (size) size.value = Math.max(1, Math.min(this.dot.size, (0.4 * this.dot.spacing) / lengthPerPixel));
  }

  dispose(): void {
    this.object.geometry.dispose();
    this.material.dispose();
  }
}
