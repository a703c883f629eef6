import type { App } from '../app.js';
import { h } from '../dom.js';
import { conversions, type MakerInfo, type Side, shapes } from '../polylap.js';
import type { Message } from '../results.js';
import { initialParameters, type Made, type Parameters, sides } from '../state.js';
import { t } from '../words.js';
import { button, menu, newId } from './controls.js';
import { parameterRows } from './parameters.js';

/** A line of a table to choose, with its parameters below. */
function maker(name: string, table: readonly MakerInfo[], refuse: (why: string) => void) {
  let chosen = table[0] as MakerInfo;
  let values: Parameters = {};
  const summary = h('p', { class: 'note' });
  const controls = h('div', { class: 'parameters' });
  const choose = menu(
    name,
    table.map(({ id, label }) => [id, t(label)] as const),
    (id) => show(table.find((entry) => entry.id === id) ?? chosen),
  );
  const show = (entry: MakerInfo) => {
    chosen = entry;
    choose.value = entry.id;
    summary.textContent = t(entry.summary);
    values = initialParameters(entry);
    const rows = parameterRows(
      entry.parameters,
      (label) => label,
      (id, value) => {
        values = { ...values, [id]: value };
        rows.show(values);
      },
      refuse,
    );
    controls.replaceChildren(...rows.elements);
    rows.show(values);
  };
  show(chosen);
  return { elements: [choose, summary, controls], made: (): Made => ({ id: chosen.id, parameters: values }) };
}

/** Makes a shape with parameters of one's own, or another mesh of the one on screen. */
export function makeDialog(app: App): HTMLDialogElement {
  const error = h('p', { class: 'dialog-error', role: 'alert' });
  const refuse = (why: string) => {
    error.textContent = why;
  };
  const attempt = async (work: () => Promise<Message | null>) => {
    error.textContent = '';
    const wrong = await work();
    if (!wrong) {
      dialog.close();
      return;
    }
    app.results.set({ error: null });
    refuse(`${wrong.title}. ${wrong.text}`);
  };
  const shape = maker(t('Shape'), shapes, refuse);
  const change = maker(t('Change'), conversions, refuse);
  const surface = menu(
    t('Surface to change'),
    sides.map((side) => [side, t('surface {side}', { side: side.toUpperCase() })] as const),
    () => {},
  );
  const repair = button(
    t('Repair the opened file'),
    () => {
      const { repair: again } = app.meshes;
      if (again) void attempt(again);
    },
    { 'data-action': 'repair' },
  );
  const section = (title: string, ...children: HTMLElement[]) => {
    const heading = h('h3', { id: newId('make') }, title);
    return h('section', { 'aria-labelledby': heading.id }, heading, ...children);
  };
  const dialog = h(
    'dialog',
    { class: 'dialog make-dialog', 'aria-labelledby': 'make-title' },
    h('h2', { id: 'make-title' }, t('Make a mesh')),
    h(
      'div',
      { class: 'makers' },
      section(
        t('A shape'),
        ...shape.elements,
        button(t('Make'), () => void attempt(() => app.meshes.make(shape.made())), {
          class: 'primary',
          'data-action': 'make-shape',
        }),
      ),
      section(
        t('Of the mesh on screen'),
        ...change.elements,
        surface,
        button(t('Apply'), () => void attempt(() => app.meshes.convert(change.made(), surface.value as Side)), {
          class: 'primary',
          'data-action': 'convert',
        }),
        repair,
      ),
    ),
    error,
    h(
      'div',
      { class: 'buttons end' },
      button(t('Close'), () => dialog.close()),
    ),
  );
  dialog.addEventListener('close', () => {
    error.textContent = '';
  });
  // Two surfaces to choose from only where smoothing has moved them apart.
  app.results.watch(
    ({ a, b }) => [a.step, b.step],
    (a, b) => {
      surface.hidden = a === 0 && b === 0;
      if (surface.hidden) surface.value = 'a';
    },
  );
  app.state.watch(
    (state) => [state.source],
    () => {
      repair.hidden = app.meshes.repair === null;
    },
  );
  return dialog;
}
