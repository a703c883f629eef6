const made = new Map<string, CSSStyleSheet>();

/** Gives a style sheet to the document or the shadow root that a node is in, once, and as no policy of a host refuses it. */
export function adopt(node: Node, text: string): void {
  const root = node.getRootNode() as Document | ShadowRoot;
  let sheet = made.get(text);
  if (!sheet) {
    sheet = new CSSStyleSheet();
    sheet.replaceSync(text);
    made.set(text, sheet);
  }
  if (!root.adoptedStyleSheets.includes(sheet)) root.adoptedStyleSheets.push(sheet);
}
