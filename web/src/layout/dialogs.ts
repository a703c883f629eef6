import type { App } from '../app.js';
import { h } from '../dom.js';
import { formatOfText } from '../mesh-text.js';
import { button } from './controls.js';

const shortcuts: readonly (readonly [string, string])[] = [
  ['Drag, or arrow keys', 'turn both meshes (when a view has the focus)'],
  ['Wheel, or + and −', 'zoom; where the page scrolls, Ctrl + wheel'],
  ['Right drag, two fingers', 'move; two fingers zoom, too'],
  ['0, or double tap', 'show the whole mesh'],
  ['[ and ]', 'vertex before, next vertex'],
  ['{ and }', 'face before, next face (in Weights)'],
  ['Click', 'select a vertex; inside a face, in Weights, the face; in Harmonic, pin'],
  ['Enter', 'pin or unpin the selected vertex (in Harmonic, when a view has the focus)'],
  [
    'Drag a pin’s label, or arrow keys on it',
    'take the pin to another vertex; Enter opens its value, Delete removes it',
  ],
  ['Drag ω up or down', 'change the weight of a vertex, where the operator takes weights; arrow keys and Delete, too'],
  ['Page Up, Page Down', 'from label to label'],
  ['Drag the line', 'show more of A or of B (in Δ Difference, Swipe)'],
  ['Space', 'play or pause (in Smooth, when a view has the focus)'],
  ['Ctrl Z, Ctrl Shift Z', 'undo, redo: everything that changes a result'],
  ['Ctrl V', 'open the text of an OBJ, OFF, PLY or STL file from the clipboard'],
  ['?', 'this help'],
];

export function helpDialog(): HTMLDialogElement {
  const dialog = h(
    'dialog',
    { class: 'dialog', 'aria-labelledby': 'help-title' },
    h('h2', { id: 'help-title' }, 'Two Laplacians, one mesh'),
    h(
      'p',
      {},
      'Each side builds a discrete Laplace operator from the same polygons and counts its negative weights, pair by ordered pair. A negative weight breaks the maximum principle: ',
      'see it happen in Harmonic, what each operator makes of the surface in Smooth, and what else it promises and keeps in Check. Everything is computed on your machine; nothing is uploaded. Vertices and faces count from 0, lines of a file from 1.',
    ),
    h('dl', { class: 'shortcuts' }, ...shortcuts.flatMap(([keys, what]) => [h('dt', {}, keys), h('dd', {}, what)])),
    h(
      'div',
      { class: 'buttons end' },
      button('Close', () => dialog.close(), { class: 'primary' }),
    ),
  );
  return dialog;
}

/** Takes the text of a mesh file; stays open with the text and what is wrong with it until it opens. */
export function pasteDialog(app: App): HTMLDialogElement {
  const text = h('textarea', {
    id: 'paste-text',
    rows: 14,
    spellcheck: 'false',
    placeholder: 'v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 1 2 3 4',
  });
  const error = h('p', { class: 'dialog-error', role: 'alert' });
  const close = () => {
    text.value = '';
    dialog.close();
  };
  const offer = button('', async () => {
    await app.results.get().error?.offer?.act();
    if (!app.results.get().error) close();
  });
  const open = button(
    'Open',
    async () => {
      error.textContent = '';
      const format = formatOfText(text.value) ?? 'obj';
      if (!(await app.meshes.open(new Blob([text.value]), `pasted.${format}`))) close();
    },
    { class: 'primary', 'data-action': 'open-pasted' },
  );
  const dialog = h(
    'dialog',
    { class: 'dialog', 'aria-labelledby': 'paste-title' },
    h('h2', { id: 'paste-title' }, 'Paste a mesh'),
    h(
      'label',
      { for: 'paste-text' },
      'OBJ text: lines v x y z, and f with the vertices of a face, any number of them; or the text of an OFF, PLY or STL file',
    ),
    text,
    error,
    h(
      'div',
      { class: 'buttons end' },
      offer,
      button('Close', () => dialog.close()),
      open,
    ),
  );
  // Behind the dialog the message of the page cannot be reached.
  app.results.watch(
    (results) => [results.error],
    (message) => {
      error.textContent = dialog.open && message ? message.text : '';
      offer.hidden = !message?.offer;
      offer.textContent = message?.offer?.label ?? '';
    },
  );
  dialog.addEventListener('close', () => {
    if (error.textContent) app.results.set({ error: null });
  });
  return dialog;
}
