/** What is wider than the screen is scrolled with keys, too. */
export function reachWide(all: Iterable<Element>): void {
  const widths = new ResizeObserver((entries) => {
    for (const { target } of entries) {
      if (target.scrollWidth > target.clientWidth) target.setAttribute('tabindex', '0');
      else target.removeAttribute('tabindex');
    }
  });
  for (const one of all) widths.observe(one);
}
