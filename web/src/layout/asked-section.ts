import type { App } from '../app.js';
import { h } from '../dom.js';
import type { SideResults } from '../results.js';
import { sides } from '../state.js';
import { button } from './controls.js';

interface Asked {
  title: string;
  note: readonly (string | Node)[];
  label: string;
  action: string;
  ask: () => unknown;
  /** What a side was found to have, or why not. */
  found: (side: SideResults) => unknown;
  body: HTMLElement;
  show: () => void;
}

/** What is worked out for the asking, since it can take a while; and why a side has none. */
export function askedSection(app: App, { title, note, label, action, ask, found, body, show }: Asked): HTMLElement {
  const asking = button(label, () => void ask(), { 'data-action': action });
  const trouble = h('p', { class: 'note', 'data-readout': `${action}-trouble` });
  app.results.watch(
    ({ a, b }) => [found(a), found(b)],
    (...both) => {
      trouble.textContent = sides
        .flatMap((side, s) => (typeof both[s] === 'string' ? [`${side.toUpperCase()}: ${both[s]}`] : []))
        .join(' ');
      show();
    },
  );
  app.results.watch(
    (results) => [results.busy],
    (busy) => {
      asking.disabled = busy !== null;
    },
  );
  return h(
    'section',
    {},
    h('h2', {}, title),
    h('p', { class: 'note' }, ...note),
    h('div', { class: 'buttons' }, asking),
    trouble,
    body,
  );
}
