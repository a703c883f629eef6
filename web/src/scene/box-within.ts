export interface Box {
  left: number;
  top: number;
  width: number;
  height: number;
}

/** Where an element is within one around it, in CSS pixels of its own: a host may show them smaller or larger, as slide decks do. */
export function boxWithin(element: HTMLElement, around: HTMLElement): Box {
  const [inner, outer] = [element.getBoundingClientRect(), around.getBoundingClientRect()];
  const scale = scaleOf(around);
  return {
    left: (inner.left - outer.left) / scale,
    top: (inner.top - outer.top) / scale,
    width: inner.width / scale,
    height: inner.height / scale,
  };
}

/** How much larger an element is seen than it was laid out. */
export function scaleOf(element: HTMLElement): number {
  const { width } = element.getBoundingClientRect();
  const { offsetWidth } = element;
  // The size of the layout is told in whole pixels.
  return offsetWidth === 0 || Math.abs(width - offsetWidth) < 1 ? 1 : width / offsetWidth;
}
