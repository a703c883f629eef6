import type { Camera } from 'three';
import { h } from '../dom.js';
import type { Content } from './content.js';
import { hidden } from './ray.js';

/** More labels than this would cover the mesh. */
export const labelLimit = 40;
const labelHeight = 24;
/** Ray tests per label and frame that stay unnoticed. */
const testLimit = 3_000_000;

export interface Label {
  vertex: number;
  /** Holds one control, which is what takes the focus. */
  element: HTMLElement;
}

/**
 * Small controls beside vertices; out of sight where the surface hides the vertex or another label is in the way, except for the one in use.
 * One stop of the Tab key; Page Up and Page Down go from one to the next.
 */
export class Labels {
  private readonly layer = h('div', { class: 'labels' });
  private readonly groups = new Map<string, readonly Label[]>();
  private stop: HTMLElement | null = null;

  constructor(view: HTMLElement) {
    view.append(this.layer);
    this.layer.addEventListener('focusin', ({ target }) => this.stopAt(target as HTMLElement));
    this.layer.addEventListener('keydown', (event) => {
      const by = { PageDown: 1, PageUp: -1 }[event.key];
      if (by === undefined) return;
      event.preventDefault();
      const seen = this.controls().filter(({ element }) => !element.classList.contains('unplaced'));
      const at = seen.findIndex(({ element }) => element.contains(event.target as Node));
      seen[(at + by + seen.length) % seen.length]?.control.focus();
    });
  }

  set(group: string, labels: readonly Label[]): void {
    const before = this.groups.get(group) ?? [];
    this.groups.set(group, labels);
    const wanted = new Set(labels.map(({ element }) => element));
    for (const { element } of before) if (!wanted.has(element)) element.remove();
    for (const { element } of labels) if (!element.isConnected) this.layer.append(element);
  }

  private all(): readonly Label[] {
    return [...this.groups.values()].flat();
  }

  private controls(): { element: HTMLElement; control: HTMLElement }[] {
    return this.all().flatMap(({ element }) => {
      const control = element.querySelector<HTMLElement>('button, [tabindex]');
      return control ? [{ element, control }] : [];
    });
  }

  private stopAt(control: HTMLElement | null): void {
    this.stop = control;
    for (const each of this.controls()) each.control.tabIndex = each.control === control ? 0 : -1;
  }

  place(camera: Camera, content: Content, width: number, height: number): void {
    const labels = this.all();
    if (labels.length === 0) return;
    const { points } = content.surface;
    const { triangles } = content.geometry;
    const eye = content.toModel(camera.position);
    const testable = (labels.length * triangles.length) / 3 <= testLimit;
    const taken: { x: number; y: number; width: number }[] = [];
    const wishes = labels
      .map((label) => {
        const own = label.element.offsetWidth;
        const at = content.placeOf(label.vertex).project(camera);
        const [px, py] = [((at.x + 1) / 2) * width, ((1 - at.y) / 2) * height];
        const spots = [py - labelHeight - 2, py + 2].flatMap((y) => [px + 9, px - 9 - own].map((x) => ({ x, y })));
        const fits = ({ x, y }: { x: number; y: number }) =>
          at.z < 1 && x >= 0 && y >= 0 && x + own <= width && y + labelHeight <= height;
        const used = label.element.matches('.dragged, :focus-within');
        const room = spots.filter(fits);
        // Whatever is in use stays in view.
        const edge = { x: clamp(px + 9, width - own), y: clamp(py - labelHeight - 2, height - labelHeight) };
        return { label, own, used, depth: at.z, spots: used && room.length === 0 ? [edge] : room };
      })
      // What is in use goes first, then who has the least choice, then who is nearest.
      .sort((p, q) => Number(q.used) - Number(p.used) || p.spots.length - q.spots.length || p.depth - q.depth);
    for (const { label, own, used, spots } of wishes) {
      const { vertex, element } = label;
      const free = ({ x, y }: { x: number; y: number }) =>
        taken.every(
          (other) => x + own + 2 < other.x || other.x + other.width + 2 < x || Math.abs(y - other.y) > labelHeight,
        );
      const spot = spots.find(free);
      const seen = spot && (used || !(testable && hidden(eye, vertex, points, triangles)));
      element.classList.toggle('unplaced', !seen);
      if (!seen) continue;
      taken.push({ ...spot, width: own });
      element.style.transform = `translate(${Math.round(spot.x)}px, ${Math.round(spot.y)}px)`;
    }
    const placed = this.controls().filter(({ element }) => !element.classList.contains('unplaced'));
    if (!placed.some(({ control }) => control === this.stop)) this.stopAt(placed[0]?.control ?? null);
  }
}

const clamp = (value: number, most: number) => Math.max(0, Math.min(value, most));
