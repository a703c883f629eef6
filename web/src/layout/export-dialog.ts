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
import { button, menu, newId } from './controls.js';

/** Draws a view without its surroundings. */
export type Photographer = (view: View, transparent: boolean) => Promise<Blob>;

const formats: readonly (readonly [MeshFormat, string])[] = [
  ['obj', 'OBJ'],
  ['ply', 'PLY'],
  ['off', 'OFF'],
  ['stl', 'STL, triangles'],
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
      done.textContent = mayBeSandboxed()
        ? `Saved as ${file.name}. If nothing arrives, the frame that the page is in needs allow-downloads in its sandbox.`
        : `Saved as ${file.name}.`;
    } catch (reason) {
      said.textContent = explain(reason);
    }
  };
  const side = menu(
    'Side',
    sides.map((each) => [each, `Side ${each.toUpperCase()}`] as const),
    () => {},
  );
  const chosen = () => side.value as Side;
  const format = menu('Format', formats, () => {});
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
  const noRow = 'There is no row to save: select a vertex first.';
  const difference = saver('Picture of the difference', 'png-delta', () => shoot('delta'));
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
    h('h2', { id: 'export-title' }, 'Save'),
    h('label', { class: 'line' }, 'What belongs to one side is taken from ', side),
    section(
      'Surface',
      format,
      saver('Save surface', 'surface', () => surfaceFile(app, chosen(), format.value as MeshFormat)),
    ),
    section(
      'Pictures, twice as fine as on screen',
      h('label', { class: 'check' }, transparent, 'transparent'),
      saver('Picture', 'png', () => shoot(chosen())),
      difference,
      saver('Stencil of the vertex, SVG', 'svg', () => stencilFile(app, chosen(), dialog), noRow),
    ),
    section(
      'Numbers',
      saver('S, MatrixMarket', 'stiffness', () => matrixFile(app, chosen(), 'stiffness')),
      saver('M, MatrixMarket', 'mass', () => matrixFile(app, chosen(), 'mass')),
      saver('Row of the vertex, CSV', 'row', () => rowFile(app), noRow),
      saver('Positions and values, CSV', 'values', () => valuesFile(app)),
    ),
    section(
      'Cite the operators of A and B',
      entries,
      button(
        'Copy',
        () =>
          // Without a right to it there may be no clipboard at all.
          void (async () => navigator.clipboard.writeText(entries.value))().then(
            () => {
              done.textContent = 'Copied.';
            },
            () => {
              entries.select();
              said.textContent = 'The browser does not let the page copy: the entries are selected, copy them by hand.';
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
      button('Close', () => dialog.close()),
    ),
  );
  dialog.addEventListener('close', () => {
    said.textContent = '';
    done.textContent = '';
  });
  return dialog;
}
