import type { App } from '../app.js';
import { h } from '../dom.js';
import {
  bibliography,
  bibliographyFile,
  matrixFile,
  pictureName,
  rowFile,
  stencilFile,
  surfaceFile,
  valuesFile,
} from '../exports.js';
import { explain } from '../messages.js';
import { mayBeSandboxed } from '../place.js';
import type { MeshFormat, Side } from '../polylap.js';
import { type SavedFile, save } from '../saving.js';
import { sides, type View } from '../state.js';
import { t, word } from '../words.js';
import { button, menu, newId } from './controls.js';

/** Draws a view without its surroundings. */
export type Photographer = (view: View, transparent: boolean) => Promise<Blob>;

const formats: readonly (readonly [MeshFormat, string])[] = [
  ['obj', 'OBJ'],
  ['ply', 'PLY'],
  ['off', 'OFF'],
  ['stl', word('STL, triangles')],
];

/** Everything that can be saved. */
export function exportDialog(app: App, photograph: Photographer): HTMLDialogElement {
  const said = h('p', { class: 'dialog-error', role: 'alert' });
  const done = h('p', { class: 'note', role: 'status' });
  const attempt = async (make: () => Promise<SavedFile | null> | SavedFile | null, missing = '') => {
    said.textContent = '';
    done.textContent = '';
    try {
      const file = await make();
      if (!file) {
        said.textContent = missing;
        return;
      }
      save(file);
      const { name } = file;
      done.textContent = mayBeSandboxed()
        ? t(
            'Saved as {name}. If nothing arrives, the frame that the page is in needs allow-downloads in its sandbox.',
            { name },
          )
        : t('Saved as {name}.', { name });
    } catch (reason) {
      said.textContent = explain(reason);
    }
  };
  const side = menu(
    t('Side'),
    sides.map((each) => [each, t('Side {side}', { side: each.toUpperCase() })] as const),
    () => {},
  );
  const chosen = () => side.value as Side;
  const format = menu(
    t('Format'),
    formats.map(([id, label]) => [id, t(label)] as const),
    () => {},
  );
  const transparent = h('input', { type: 'checkbox', checked: true, 'data-field': 'transparent' });
  const shoot = async (view: View): Promise<SavedFile> => ({
    name: pictureName(app, view),
    contents: await photograph(view, transparent.checked),
  });
  const saver = (label: string, id: string, make: () => Promise<SavedFile | null> | SavedFile | null, missing = '') =>
    button(label, () => void attempt(make, missing), { 'data-action': `save-${id}` });
  const section = (title: string, ...children: HTMLElement[]) => {
    const heading = h('h3', { id: newId('export') }, title);
    return h('section', { 'aria-labelledby': heading.id }, heading, h('div', { class: 'buttons' }, ...children));
  };
  const noRow = t('There is no row to save: select a vertex first.');
  const difference = saver(t('Picture of the difference'), 'png-delta', () => shoot('delta'));
  app.state.watch(
    (state) => [state.delta.open, state.shown],
    (open, shown) => {
      difference.hidden = !open && shown !== 'delta';
    },
  );
  const entries = h('textarea', {
    class: 'bibtex',
    readonly: true,
    rows: 5,
    'aria-label': 'BibTeX',
    spellcheck: 'false',
  });
  app.state.watch(
    (state) => [state.sides.a.operator, state.sides.b.operator],
    () => {
      entries.value = bibliography(app.state.get());
    },
  );
  const dialog: HTMLDialogElement = h(
    'dialog',
    { class: 'dialog', 'aria-labelledby': 'export-title' },
    h('h2', { id: 'export-title' }, t('Save')),
    h('label', { class: 'line' }, t('What belongs to one side is taken from '), side),
    section(
      t('Surface'),
      format,
      saver(t('Save surface'), 'surface', () => surfaceFile(app, chosen(), format.value as MeshFormat)),
    ),
    section(
      t('Pictures, twice as fine as on screen'),
      h('label', { class: 'check' }, transparent, t('transparent')),
      saver(t('Picture'), 'png', () => shoot(chosen())),
      difference,
      saver(t('Stencil of the vertex, SVG'), 'svg', () => stencilFile(app, chosen(), dialog), noRow),
    ),
    section(
      t('Numbers'),
      saver(t('S, MatrixMarket'), 'stiffness', () => matrixFile(app, chosen(), 'stiffness')),
      saver(t('M, MatrixMarket'), 'mass', () => matrixFile(app, chosen(), 'mass')),
      saver(t('Row of the vertex, CSV'), 'row', () => rowFile(app), noRow),
      saver(t('Positions and values, CSV'), 'values', () => valuesFile(app)),
    ),
    section(
      t('Cite the operators of A and B'),
      entries,
      button(
        t('Copy'),
        () =>
          // Without a right to it there may be no clipboard at all.
          void (async () => navigator.clipboard.writeText(entries.value))().then(
            () => {
              done.textContent = t('Copied.');
            },
            () => {
              entries.select();
              said.textContent = t(
                'The browser does not let the page copy: the entries are selected, copy them by hand.',
              );
            },
          ),
        { 'data-action': 'copy-bibtex' },
      ),
      saver('BibTeX', 'bibtex', () => bibliographyFile(app)),
    ),
    said,
    done,
    h(
      'div',
      { class: 'buttons end' },
      button(t('Close'), () => dialog.close()),
    ),
  );
  dialog.addEventListener('close', () => {
    said.textContent = '';
    done.textContent = '';
  });
  return dialog;
}
