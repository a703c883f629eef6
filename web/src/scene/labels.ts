import type { Camera, Vector3 } from 'three';
import { h } from '../dom.js';
import { exact } from '../format.js';
import type { Pin } from '../state.js';

/** More labels than this would cover the mesh. */
const labelLimit = 40;
const labelHeight = 20;
/** Ray tests per label and frame that stay unnoticed. */
const testLimit = 3_000_000;

/** The values of pins, as text over a view; hidden where the surface hides the vertex or another label is in the way. */
export class Labels {
  private readonly layer = h('div', { class: 'pin-labels', 'aria-hidden': 'true' });
  private shown: { pin: Pin; element: HTMLElement; width: number }[] = [];

  constructor(view: HTMLElement) {
    view.append(this.layer);
  }

  set(pins: readonly Pin[]): void {
    this.layer.replaceChildren();
    this.shown = pins.slice(0, labelLimit).map((pin) => {
      const element = h('span', { class: 'pin-label' }, exact(Number(pin.value.toPrecision(3))));
      this.layer.append(element);
      return { pin, element, width: 0 };
    });
  }

  place(
    camera: Camera,
    points: Float32Array,
    triangles: Int32Array,
    toWorld: (vertex: number) => Vector3,
    toModel: (world: Vector3) => Vector3,
    width: number,
    height: number,
  ): void {
    if (this.shown.length === 0) return;
    const eye = toModel(camera.position.clone());
    const testable = (this.shown.length * triangles.length) / 3 <= testLimit;
    const taken: { x: number; y: number; width: number }[] = [];
    const wishes = this.shown
      .map((label) => {
        if (label.width === 0) {
          label.element.hidden = false;
          label.width = label.element.offsetWidth;
        }
        const at = toWorld(label.pin.vertex).project(camera);
        const [px, py] = [((at.x + 1) / 2) * width, ((1 - at.y) / 2) * height];
        const spots = [py - 22, py + 2].flatMap((y) => [px + 9, px - 9 - label.width].map((x) => ({ x, y })));
        const fits = ({ x, y }: { x: number; y: number }) =>
          at.z < 1 && x >= 0 && y >= 0 && x + label.width <= width && y + labelHeight <= height;
        return { label, depth: at.z, spots: spots.filter(fits) };
      })
      // Who has the least choice goes first, then who is nearest.
      .sort((p, q) => p.spots.length - q.spots.length || p.depth - q.depth);
    for (const { label, spots } of wishes) {
      const { pin, element } = label;
      const free = ({ x, y }: { x: number; y: number }) =>
        taken.every(
          (other) =>
            x + label.width + 2 < other.x || other.x + other.width + 2 < x || Math.abs(y - other.y) > labelHeight,
        );
      const spot = spots.find(free);
      const seen = spot && !(testable && hidden(eye, pin.vertex, points, triangles));
      element.hidden = !seen;
      if (!seen) continue;
      taken.push({ ...spot, width: label.width });
      element.style.transform = `translate(${Math.round(spot.x)}px, ${Math.round(spot.y)}px)`;
    }
  }
}

/** Whether a triangle lies between the eye and a vertex (Möller–Trumbore, triangles at the vertex left out). */
export function hidden(eye: Vector3, vertex: number, points: Float32Array, triangles: Int32Array): boolean {
  const [ex, ey, ez] = [eye.x, eye.y, eye.z];
  const at = (i: number) => points[i] as number;
  const dx = at(3 * vertex) - ex;
  const dy = at(3 * vertex + 1) - ey;
  const dz = at(3 * vertex + 2) - ez;
  for (let t = 0; t < triangles.length; t += 3) {
    const i = triangles[t] as number;
    const j = triangles[t + 1] as number;
    const k = triangles[t + 2] as number;
    if (i === vertex || j === vertex || k === vertex) continue;
    const [ax, ay, az] = [at(3 * i), at(3 * i + 1), at(3 * i + 2)];
    const [ux, uy, uz] = [at(3 * j) - ax, at(3 * j + 1) - ay, at(3 * j + 2) - az];
    const [vx, vy, vz] = [at(3 * k) - ax, at(3 * k + 1) - ay, at(3 * k + 2) - az];
    const [px, py, pz] = [dy * vz - dz * vy, dz * vx - dx * vz, dx * vy - dy * vx];
    const determinant = ux * px + uy * py + uz * pz;
    if (determinant === 0) continue;
    const [sx, sy, sz] = [ex - ax, ey - ay, ez - az];
    const b1 = (sx * px + sy * py + sz * pz) / determinant;
    if (b1 < 0 || b1 > 1) continue;
    const [qx, qy, qz] = [sy * uz - sz * uy, sz * ux - sx * uz, sx * uy - sy * ux];
    const b2 = (dx * qx + dy * qy + dz * qz) / determinant;
    if (b2 < 0 || b1 + b2 > 1) continue;
    const along = (vx * qx + vy * qy + vz * qz) / determinant;
    if (along > 0 && along < 0.999) return true;
  }
  return false;
}
