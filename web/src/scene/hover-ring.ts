import { h } from '../dom.js';
import { type View, views } from '../state.js';
import { scaleOf } from './box-within.js';

/** A ring around the vertex under the pointer, over the canvas and not in it: nothing has to be drawn again while the pointer moves. */
export class HoverRing {
  private readonly rings: Record<View, HTMLElement>;
  private vertex: number | null = null;

  /** @param project where a vertex is on the page, and whether nothing hides it */
  constructor(
    private readonly places: Record<View, HTMLElement>,
    private readonly project: (view: View, vertex: number) => { x: number; y: number; visible: boolean } | null,
  ) {
    const ring = (view: View) => {
      const element = h('div', { class: 'hover-ring', hidden: true });
      places[view].append(element);
      return element;
    };
    this.rings = { a: ring('a'), b: ring('b'), delta: ring('delta') };
  }

  set(vertex: number | null): void {
    this.vertex = vertex;
    this.place();
  }

  /** Where the vertex is now. */
  place(): void {
    for (const view of views) {
      const ring = this.rings[view];
      const at = this.vertex === null ? null : this.project(view, this.vertex);
      ring.hidden = !at?.visible;
      if (!at?.visible) continue;
      const place = this.places[view];
      const { x, y } = place.getBoundingClientRect();
      const scale = scaleOf(place);
      ring.style.transform = `translate(${(at.x - x) / scale}px, ${(at.y - y) / scale}px)`;
    }
  }
}
