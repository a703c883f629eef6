import type { App } from '../app.js';
import { boundaryPins, boundaryPresets, examplePins } from '../boundary-pins.js';
import { h, put } from '../dom.js';
import { count, exact, plural } from '../format.js';
import { sides } from '../state.js';
import { button, menu, numberField } from './controls.js';
import { sideTable } from './table.js';
import { vertexField } from './vertex-field.js';

/** Longer lists of pins are counted, not listed. */
const listed = 60;

/** Harmonic interpolation of pinned values. */
export function harmonicPanel(app: App): HTMLElement {
  const setValue = (value: number) => app.state.set({ harmonic: { ...app.state.get().harmonic, value } });
  const value = numberField({ label: 'Value of the next pin', onChange: setValue });
  value.element.dataset.field = 'value';
  const quick = [0, 1].map((number) =>
    button(String(number), () => setValue(number), { class: 'key', 'aria-label': `Pin to ${number}` }),
  );
  const preset = menu(
    'Values of the boundary',
    boundaryPresets.map(({ id, label }) => [id, label] as const),
    () => {},
  );
  const pinBoundary = button(
    'Pin all',
    () => {
      const { mesh } = app.results.get();
      if (mesh) app.setPins(boundaryPins(mesh, preset.value, app.state.get().harmonic.value));
    },
    { 'data-action': 'pin-boundary', 'aria-label': 'Pin the whole boundary' },
  );
  const clear = button('Clear', () => app.setPins([]), { 'data-action': 'clear-pins' });
  const example = button(
    'Two pins, 0 and 1',
    () => {
      const { mesh } = app.results.get();
      if (mesh) app.setPins(examplePins(mesh));
    },
    { 'data-action': 'example-pins' },
  );
  const readouts = sideTable(
    'Values',
    [
      { id: 'value', name: 'at the vertex' },
      { id: 'min', name: 'smallest' },
      { id: 'max', name: 'largest' },
      { id: 'outside', name: 'outside ×' },
    ],
    'figures6',
  );
  const verdict = h('p', { class: 'note', 'data-readout': 'verdict' });
  const pinSelected = button('Pin', () => togglePin(), { 'data-action': 'pin-vertex' });
  const noBoundary = h('p', { class: 'note' });
  const list = h('ol', { class: 'pins' });
  const listTitle = h('h2', {});
  const element = h(
    'div',
    { class: 'panel-body' },
    h(
      'section',
      {},
      h('h2', {}, 'Pin values'),
      h('div', { class: 'line' }, h('span', { class: 'line-name' }, 'Click to pin'), value.element, ...quick),
      h('div', { class: 'line' }, h('span', { class: 'line-name' }, 'Boundary'), preset, pinBoundary),
      noBoundary,
      h('div', { class: 'line' }, example, clear),
    ),
    h('section', {}, h('div', { class: 'line' }, vertexField(app), pinSelected), readouts.element, verdict),
    h('section', {}, listTitle, list),
  );

  function togglePin(): void {
    const { selected, harmonic } = app.state.get();
    if (selected === null) return;
    const pinned = harmonic.pins.some((pin) => pin.vertex === selected);
    app.pin(selected, pinned ? null : harmonic.value);
  }

  app.state.watch(
    (state) => [state.harmonic.value],
    (next) => value.set(next),
  );
  app.results.watch(
    (results) => [results.mesh],
    (mesh) => {
      const bounded = (mesh?.boundary.length ?? 0) > 0;
      pinBoundary.disabled = !bounded;
      preset.disabled = !bounded;
      noBoundary.textContent = bounded ? '' : 'This surface is closed: it has no boundary.';
    },
  );
  app.state.watch(
    (state) => [state.harmonic.pins, state.selected],
    (pins, selected) => {
      pinSelected.disabled = selected === null;
      pinSelected.textContent = pins.some((pin) => pin.vertex === selected) ? 'Remove pin' : 'Pin';
    },
  );
  app.state.watch(
    (state) => [state.harmonic.pins],
    (pins) => {
      clear.disabled = pins.length === 0;
      listTitle.textContent = pins.length === 0 ? 'No pins yet' : plural(pins.length, 'pin');
      // A row that is being typed into must not be built anew.
      const rows = new Map(
        Array.from(list.children, (row) => [
          (row as HTMLElement).dataset.vertex,
          row as HTMLElement & { set: (value: number) => void },
        ]),
      );
      list.replaceChildren(
        ...pins.slice(0, listed).map((pin) => {
          const row = rows.get(String(pin.vertex)) ?? pinRow(app, pin.vertex);
          row.set(pin.value);
          return row;
        }),
        ...(pins.length > listed ? [h('li', { class: 'note' }, `and ${count(pins.length - listed)} more`)] : []),
      );
    },
  );

  const showReadouts = () => {
    const results = app.results.get();
    const {
      selected,
      harmonic: { pins },
    } = app.state.get();
    const vertex = results.hovered ?? selected;
    readouts.rename('value', vertex === null ? 'at the vertex' : `vertex ${vertex}`);
    for (const side of sides) {
      const { harmonic } = results[side];
      const known = harmonic !== null && typeof harmonic !== 'string' ? harmonic : null;
      const at = vertex === null ? undefined : known?.values[vertex];
      readouts.set('value', side, at === undefined ? { text: '–' } : { text: exact(at), value: at });
      readouts.set('min', side, known ? { text: exact(known.min), value: known.min } : { text: '–' });
      readouts.set('max', side, known ? { text: exact(known.max), value: known.max } : { text: '–' });
      readouts.set(
        'outside',
        side,
        known
          ? {
              text: count(known.outside.length),
              value: known.outside.length,
              class: known.outside.length > 0 ? 'strong' : '',
            }
          : { text: '–' },
      );
    }
    const { a, b } = results;
    const problem = [a.harmonic, b.harmonic].find((harmonic) => typeof harmonic === 'string');
    if (typeof problem === 'string') put(verdict, problem);
    else if (a.harmonic && b.harmonic && typeof a.harmonic !== 'string') {
      const outside = `${count(a.harmonic.outside.length)} | ${count((b.harmonic as typeof a.harmonic).outside.length)}`;
      put(
        verdict,
        `${outside} vertices outside the pinned range [${exact(a.harmonic.fixedMin)}, ${exact(a.harmonic.fixedMax)}]; the maximum principle allows none.`,
      );
    } else put(verdict, pins.length === 0 ? 'Pin a vertex to see the harmonic function of both operators.' : ' ');
  };
  app.results.watch((results) => [results.a.harmonic, results.b.harmonic, results.hovered], showReadouts);
  app.state.watch((state) => [state.selected, state.harmonic.pins], showReadouts);
  return element;
}

function pinRow(app: App, vertex: number): HTMLElement & { set: (value: number) => void } {
  const field = numberField({
    label: `Value of the pin at vertex ${vertex}`,
    onChange: (value) => app.pin(vertex, value),
  });
  const row = h(
    'li',
    { 'data-vertex': vertex },
    button(`vertex ${count(vertex)}`, () => app.select(vertex), { class: 'quiet' }),
    field.element,
    button('×', () => app.pin(vertex, null), { class: 'key', 'aria-label': `Remove the pin at vertex ${vertex}` }),
  );
  return Object.assign(row, { set: field.set });
}
