import type { App } from '../app.js';
import { h } from '../dom.js';
import { formatOfText } from '../mesh-text.js';
import { language, t } from '../words.js';
import { button } from './controls.js';

const shortcuts = (): readonly (readonly [string, string])[] => [
  [t('Drag, or arrow keys'), t('turn both meshes (when a view has the focus)')],
  [t('Wheel, or + and −'), t('zoom; where the page scrolls, Ctrl + wheel')],
  [t('Right drag, two fingers'), t('move; two fingers zoom, too')],
  [t('0, or double tap'), t('show the whole mesh')],
  [t('[ and ]'), t('vertex before, next vertex')],
  [t('{ and }'), t('face before, next face (in Weights)')],
  [t('Click'), t('select a vertex; inside a face, in Weights, the face; in Harmonic, pin')],
  [t('Enter'), t('pin or unpin the selected vertex (in Harmonic, when a view has the focus)')],
  [
    t('Drag a pin’s label, or arrow keys on it'),
    t('take the pin to another vertex; Enter opens its value, Delete removes it'),
  ],
  [
    t('Drag ω up or down'),
    t('change the weight of a vertex, where the operator takes weights; arrow keys and Delete, too'),
  ],
  [t('Page Up, Page Down'), t('from label to label')],
  [t('Drag the line'), t('show more of A or of B (in Δ Difference, Swipe)')],
  [t('Space'), t('play or pause (in Smooth, when a view has the focus)')],
  [t('Ctrl Z, Ctrl Shift Z'), t('undo, redo: everything that changes a result')],
  [t('Ctrl V'), t('open the text of an OBJ, OFF, PLY or STL file from the clipboard')],
  ['?', t('this help')],
];

/** What else the site has; nothing of it lies beside the page that is one file. */
function besides(address: string | null): HTMLElement | null {
  if (address === null || !/\/(index\.html)?$/.test(new URL(address).pathname)) return null;
  const file = language() === 'en' ? 'index.html' : `${language()}.html`;
  const places = [
    [language() === 'en' ? 'figures/' : `figures/${language()}/`, 'index.html', t('Twelve figures')],
    ['thesis/', file, t('An interactive article')],
    ['class/', file, t('Use it in class')],
  ] as const;
  const link = ([folder, name, label]: (typeof places)[number]) =>
    h('li', {}, h('a', { href: new URL(folder + name, address).href }, label));
  return h('ul', { class: 'besides' }, ...places.map(link));
}

export function helpDialog(app: App): HTMLDialogElement {
  const dialog = h(
    'dialog',
    { class: 'dialog', 'aria-labelledby': 'help-title' },
    h('h2', { id: 'help-title' }, t('Two Laplacians, one mesh')),
    h(
      'p',
      {},
      t(
        'Each side builds a discrete Laplace operator from the same polygons and counts its negative weights, pair by ordered pair. A negative weight breaks the maximum principle: see it happen in Harmonic, what each operator makes of the surface in Smooth, and what else it promises and keeps in Check. Everything is computed on your machine; nothing is uploaded. Vertices and faces count from 0, lines of a file from 1.',
      ),
    ),
    besides(app.address()),
    h('dl', { class: 'shortcuts' }, ...shortcuts().flatMap(([keys, what]) => [h('dt', {}, keys), h('dd', {}, what)])),
    h(
      'div',
      { class: 'buttons end' },
      button(t('Close'), () => dialog.close(), { class: 'primary' }),
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
    t('Open'),
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
    h('h2', { id: 'paste-title' }, t('Paste a mesh')),
    h(
      'label',
      { for: 'paste-text' },
      t(
        'OBJ text: lines v x y z, and f with the vertices of a face, any number of them; or the text of an OFF, PLY or STL file',
      ),
    ),
    text,
    error,
    h(
      'div',
      { class: 'buttons end' },
      offer,
      button(t('Close'), () => dialog.close()),
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
