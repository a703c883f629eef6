import { BufferAttribute, BufferGeometry, GLSL3, Points, ShaderMaterial, type Texture, Vector3 } from 'three';
import { fetchTexel } from './data-texture.js';

/** Told apart by shape, not by colour. */
export enum Mark {
  selected = 0,
  pin = 1,
  /** Of a value beyond its range. */
  below = 2,
  above = 3,
}

const vertexShader = /* glsl */ `
uniform highp sampler2D positions;
uniform float pixelRatio;
uniform float lift;
uniform bool crowded;
in float vertex;
in float mark;
flat out int vMark;
${fetchTexel}
void main() {
  vMark = int(mark + 0.5);
  vec4 eye = modelViewMatrix * vec4(texelFetch(positions, texel(int(vertex + 0.5)), 0).xyz, 1.0);
  // Nearer by less than an edge: a mark must not sink into the faces around its vertex.
  eye.xyz *= 1.0 - lift / length(eye.xyz);
  gl_Position = projectionMatrix * eye;
  bool outside = vMark == ${Mark.below} || vMark == ${Mark.above};
  // Where there is room the surface itself is hatched.
  if (outside && !crowded) gl_Position = vec4(2.0, 2.0, 2.0, 1.0);
  gl_PointSize = pixelRatio * (outside ? 12.0 : vMark == ${Mark.pin} ? 13.0 : 18.0);
}`;

const fragmentShader = /* glsl */ `
uniform float pixelRatio;
uniform vec3 ink;
uniform vec3 card;
uniform vec3 accent;
flat in int vMark;
out vec4 colour;
void main() {
  vec2 p = 2.0 * gl_PointCoord - 1.0;
  float r = length(p);
  float soft = fwidth(r);
  vec4 under = vec4(card, 0.0);
  float body = 0.0;
  float halo = 0.0;
  vec3 tint = ink;
  if (vMark == ${Mark.below} || vMark == ${Mark.above}) {
    float slant = vMark == ${Mark.above} ? -1.0 : 1.0;
    float across = (gl_FragCoord.x + slant * gl_FragCoord.y) / pixelRatio / 5.0;
    body = 1.0 - smoothstep(0.14, 0.24, abs(fract(across) - 0.5));
    colour = vec4(mix(card, ink, body), mix(0.5, 1.0, body) * (1.0 - smoothstep(1.0 - soft, 1.0, r)));
    return;
  } else if (vMark == ${Mark.pin}) {
    body = 1.0 - smoothstep(0.62 - soft, 0.62, r);
    halo = 1.0 - smoothstep(1.0 - soft, 1.0, r);
  } else {
    float dot = 1.0 - smoothstep(0.24 - soft, 0.24, r);
    float ring = smoothstep(0.56 - soft, 0.56, r) * (1.0 - smoothstep(0.8 - soft, 0.8, r));
    body = max(dot, ring);
    halo = max(1.0 - smoothstep(0.36, 0.44, r), smoothstep(0.4 - soft, 0.4, r) * (1.0 - smoothstep(1.0 - soft, 1.0, r)));
    tint = accent;
  }
  if (max(body, halo) < 0.04) discard;
  colour = vec4(mix(card, tint, body), max(body, halo));
}`;

export class Markers {
  readonly object: Points;
  readonly material: ShaderMaterial;

  constructor(positions: Texture, lift: number) {
    this.material = new ShaderMaterial({
      glslVersion: GLSL3,
      vertexShader,
      fragmentShader,
      transparent: true,
      depthWrite: false,
      uniforms: {
        positions: { value: positions },
        pixelRatio: { value: 1 },
        lift: { value: lift },
        crowded: { value: false },
        ink: { value: new Vector3() },
        card: { value: new Vector3() },
        accent: { value: new Vector3() },
      },
    });
    this.object = new Points(new BufferGeometry(), this.material);
    this.object.frustumCulled = false;
    this.object.renderOrder = 2;
    this.show([]);
  }

  /** Later groups are drawn over earlier ones. */
  show(groups: readonly { mark: Mark; vertices: ArrayLike<number> }[]): void {
    const total = groups.reduce((sum, { vertices }) => sum + vertices.length, 0);
    const vertex = new Float32Array(total);
    const mark = new Float32Array(total);
    let at = 0;
    for (const group of groups) {
      vertex.set(group.vertices, at);
      mark.fill(group.mark, at, at + group.vertices.length);
      at += group.vertices.length;
    }
    this.object.geometry.dispose();
    const geometry = new BufferGeometry();
    geometry.setAttribute('vertex', new BufferAttribute(vertex, 1));
    geometry.setAttribute('mark', new BufferAttribute(mark, 1));
    geometry.setDrawRange(0, total);
    this.object.geometry = geometry;
    this.object.visible = total > 0;
  }

  /** @param crowded whether vertices are too close together for anything but a mark on each */
  crowd(crowded: boolean): void {
    if (this.material.uniforms.crowded) this.material.uniforms.crowded.value = crowded;
  }

  dispose(): void {
    this.object.geometry.dispose();
    this.material.dispose();
  }
}
