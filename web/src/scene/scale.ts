/** How much larger an element is seen than it was laid out: decks scale their slides to the screen. */
export function scaleOf(element: HTMLElement): number {
  const { width } = element.getBoundingClientRect();
  const { offsetWidth } = element;
  // The size of the layout is told in whole pixels.
  return offsetWidth === 0 || Math.abs(width - offsetWidth) < 1 ? 1 : width / offsetWidth;
}
