/** The parts of a formula between its outermost commas: MathML breaks no lines, but parts can stand below one another. */
export function formulaParts(mathml: string): Element[] {
  const source = document.createElement('template');
  // From the operator table, made when the page was built.
  source.innerHTML = mathml;
  const whole = source.content.firstElementChild;
  const row = whole?.firstElementChild;
  if (!whole || !row) return [];
  const parts: Element[] = [];
  let into: Element | null = null;
  for (const child of [...row.children]) {
    // Space after a comma is between the parts.
    if (!into && child.localName === 'mspace') continue;
    if (!into) {
      const part = whole.cloneNode(false) as Element;
      into = row.cloneNode(false) as Element;
      part.append(into);
      parts.push(part);
    }
    into.append(child);
    if (child.localName === 'mo' && child.getAttribute('separator') === 'true') into = null;
  }
  return parts;
}
