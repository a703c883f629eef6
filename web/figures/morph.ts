/** Makes one tree the like of another and keeps its elements: the focus stays, and so does the pointer. */
export function morph(from: Element, to: Element): void {
  for (const { name } of [...from.attributes]) if (!to.hasAttribute(name)) from.removeAttribute(name);
  for (const { name, value } of to.attributes) if (from.getAttribute(name) !== value) from.setAttribute(name, value);
  morphChildren(from, to);
}

export function morphChildren(from: Element, to: Element): void {
  const wanted = [...to.childNodes];
  while (from.childNodes.length > wanted.length) from.lastChild?.remove();
  for (const [k, node] of wanted.entries()) {
    const old = from.childNodes[k];
    if (!old) from.append(node);
    else if (old instanceof Element && node instanceof Element && old.nodeName === node.nodeName) morph(old, node);
    else if (old.nodeType === node.nodeType && old.nodeType === Node.TEXT_NODE) {
      if (old.nodeValue !== node.nodeValue) old.nodeValue = node.nodeValue;
    } else old.replaceWith(node);
  }
}
