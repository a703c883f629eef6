import { type Camera, Vector3 } from 'three';
import { h } from '../dom.js';
import type { Content } from './content.js';
import { hidden } from './ray.js';

/** More labels than this would cover the mesh. */
export const labelLimit = 40;
const labelHeight = 24;
/** From a vertex to its label, in pixels. */
const gap = 9;
/** A label this near to another's vertex would be taken for that one's. */
const clearance = 13;
/** Ray tests per label and frame that stay unnoticed. */
const testLimit = 3_000_000;

export interface Label {
  vertex: number;
  /** Holds one control, which is what takes the focus. */
  element: HTMLElement;
}

interface Point {
  x: number;
  y: number;
}

/** As high as all labels. */
interface Box extends Point {
  width: number;
}

/**
 * Small controls right beside vertices; out of sight where the surface hides the vertex or there is no room, except for the one in use.
 * One stop of the Tab key; Page Up and Page Down go from one to the next.
 */
export class Labels {
  private readonly layer = h('div', { class: 'labels' });
  private readonly groups = new Map<string, readonly Label[]>();
  private stop: HTMLElement | null = null;
  /** The vertex under the pointer: its label comes before others. */
  hovered: number | null = null;

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
    const on = (at: Vector3) => ({ x: ((at.x + 1) / 2) * width, y: ((1 - at.y) / 2) * height });
    // Of the loaded mesh, whose positions are relative to it.
    const middle = on(new Vector3().project(camera));
    const inView = labels.map(({ vertex, element }) => {
      const at = content.placeOf(vertex).project(camera);
      const used = element.matches('.dragged, :focus-within');
      // Pointing at one that is placed already moves none.
      const revealed =
        (vertex === this.hovered || element.matches(':hover')) && element.matches('.unplaced, .revealed');
      element.classList.toggle('revealed', revealed);
      const there = at.z < 1 && !(testable && hidden(eye, vertex, points, triangles));
      return { vertex, element, used, wanted: used || revealed, there, depth: at.z, dot: on(at) };
    });
    const dots = inView.filter(({ there }) => there).map(({ dot }) => dot);
    const wishes = inView
      .map((label) => {
        const { element, used, wanted, there, dot } = label;
        const own = element.offsetWidth;
        const inside = spotsAround(dot, own, middle).filter(
          ({ x, y }) => x >= 0 && y >= 0 && x + own <= width && y + labelHeight <= height,
        );
        const room = inside.filter((spot) => dots.every((other) => other === dot || distance(spot, other) > clearance));
        if (wanted) room.push(...inside);
        // Whatever is in use stays in view.
        if (used) room.push(within(dot, own, width, height));
        return { ...label, spots: used || there ? room : [] };
      })
      // What is wanted goes first, then who has the least choice, then who is nearest.
      .sort((p, q) => Number(q.wanted) - Number(p.wanted) || p.spots.length - q.spots.length || p.depth - q.depth);
    const taken: Box[] = [];
    for (const { element, spots } of wishes) {
      const spot = spots.find((box) => taken.every((other) => apart(box, other)));
      element.classList.toggle('unplaced', !spot);
      if (!spot) continue;
      taken.push(spot);
      element.style.transform = `translate(${Math.round(spot.x)}px, ${Math.round(spot.y)}px)`;
    }
    const placed = this.controls().filter(({ element }) => !element.classList.contains('unplaced'));
    if (!placed.some(({ control }) => control === this.stop)) this.stopAt(placed[0]?.control ?? null);
  }
}

/** Beside a vertex, at each side and at each corner; the farther out from the middle of the mesh, the better. */
function spotsAround({ x, y }: Point, width: number, middle: Point): Box[] {
  const spots = [-1, 0, 1].flatMap((down) =>
    [1, 0, -1].flatMap((right) => {
      if (right === 0 && down === 0) return [];
      const offX = right * (gap + width / 2);
      const offY = down * ((right === 0 ? gap : 2) + labelHeight / 2);
      const out = (offX * (x - middle.x) + offY * (y - middle.y)) / Math.hypot(offX, offY);
      return { out, box: { x: x + offX - width / 2, y: y + offY - labelHeight / 2, width } };
    }),
  );
  return spots.sort((p, q) => q.out - p.out).map(({ box }) => box);
}

function within({ x, y }: Point, own: number, width: number, height: number): Box {
  const clamp = (value: number, most: number) => Math.max(0, Math.min(value, most));
  return { x: clamp(x + gap, width - own), y: clamp(y - labelHeight - 2, height - labelHeight), width: own };
}

const apart = (one: Box, other: Box) =>
  one.x + one.width + 2 < other.x || other.x + other.width + 2 < one.x || Math.abs(one.y - other.y) > labelHeight;

function distance({ x, y, width }: Box, point: Point): number {
  return Math.hypot(Math.max(x - point.x, 0, point.x - x - width), Math.max(y - point.y, 0, point.y - y - labelHeight));
}
