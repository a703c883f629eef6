import type { App } from '../app.js';
import { h } from '../dom.js';
import { button } from './controls.js';

const shortcuts: readonly (readonly [string, string])[] = [
  ['Drag, or arrow keys', 'turn both meshes (when a view has the focus)'],
  ['Wheel, or + and −', 'zoom'],
  ['Right drag', 'move'],
  ['0', 'show the whole mesh'],
  ['[ and ]', 'vertex before, next vertex'],
  ['Click', 'select a vertex; pin it in Harmonic'],
  ['Enter', 'pin or unpin the selected vertex (in Harmonic, when a view has the focus)'],
  ['Space', 'play or pause (in Smooth, when a view has the focus)'],
  ['Ctrl V', 'open OBJ text from the clipboard'],
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
      'see it happen in Harmonic, and see what each operator makes of the surface in Smooth. Everything is computed on your machine; nothing is uploaded. Vertices and faces count from 0, lines of a file from 1.',
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

/** Takes OBJ text; stays open with the text and what is wrong with it until it opens. */
export function pasteDialog(app: App): HTMLDialogElement {
  const text = h('textarea', {
    id: 'paste-text',
    rows: 14,
    spellcheck: 'false',
    placeholder: 'v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 1 2 3 4',
  });
  const error = h('p', { class: 'dialog-error', role: 'alert' });
  const open = button(
    'Open',
    async () => {
      error.textContent = '';
      const wrong = await app.open(new Blob([text.value]), 'pasted.obj');
      if (wrong) {
        error.textContent = wrong.text;
        app.results.set({ error: null });
        return;
      }
      text.value = '';
      dialog.close();
    },
    { class: 'primary', 'data-action': 'open-pasted' },
  );
  const dialog = h(
    'dialog',
    { class: 'dialog', 'aria-labelledby': 'paste-title' },
    h('h2', { id: 'paste-title' }, 'Paste a mesh'),
    h('label', { for: 'paste-text' }, 'OBJ text: lines v x y z, and f with the vertices of a face, any number of them'),
    text,
    error,
    h(
      'div',
      { class: 'buttons end' },
      button('Close', () => dialog.close()),
      open,
    ),
  );
  return dialog;
}
