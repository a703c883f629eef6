import { h, put } from '../dom.js';
import { button } from './controls.js';

export interface Cell {
  text: string;
  value?: number | null;
  class?: string;
  /** Makes the text a button. */
  act?: () => void;
  /** Of the button: its text and what it is the number of. */
  label?: string;
}

/** A table A | B whose rows stay where they are while their numbers change. */
export function sideTable(caption: string, rows: readonly { id: string; name: string }[], kind = '') {
  const cells = new Map<string, [HTMLElement, HTMLElement]>();
  const names = new Map<string, HTMLElement>();
  const body = h(
    'tbody',
    {},
    ...rows.map(({ id, name }) => {
      const a = h('td', { 'data-readout': id, 'data-of': 'a' });
      const b = h('td', { 'data-readout': id, 'data-of': 'b' });
      cells.set(id, [a, b]);
      const head = h('th', { scope: 'row' }, name);
      names.set(id, head);
      return h('tr', {}, head, a, b);
    }),
  );
  const element = h(
    'table',
    { class: `readouts ${kind}` },
    h('caption', { class: 'unseen' }, caption),
    h('thead', {}, h('tr', {}, h('td', {}), h('th', { scope: 'col' }, 'A'), h('th', { scope: 'col' }, 'B'))),
    body,
  );
  const set = (id: string, side: 'a' | 'b', cell: Cell) => {
    const target = cells.get(id)?.[side === 'a' ? 0 : 1];
    if (!target) return;
    put(target, cell.text, cell.value);
    if (cell.act) target.replaceChildren(button(cell.text, cell.act, { class: 'place', 'aria-label': cell.label }));
    target.className = cell.class ?? '';
  };
  const rename = (id: string, name: string) => {
    const head = names.get(id);
    if (head) put(head, name);
  };
  return { element, set, rename };
}
