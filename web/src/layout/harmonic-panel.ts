import type { App } from '../app.js';
import { boundaryLoops, type Loop } from '../boundary-loops.js';
import { boundaryPins, boundaryPresets, examplePins } from '../boundary-pins.js';
import { sizeOf } from '../colouring.js';
import { h, put } from '../dom.js';
import { cleared, count, exact } from '../format.js';
import type { Harmonic, Mesh } from '../polylap.js';
import { type Pin, sides } from '../state.js';
import { t } from '../words.js';
import { coloursSection } from './colours-section.js';
import { button, menu, numberField } from './controls.js';
import { vertexField } from './number-walk.js';
import { sideTable } from './table.js';

/** Longer lists of pins are counted, not listed. */
const listed = 60;

/** Harmonic interpolation of pinned values. */
export function harmonicPanel(app: App): HTMLElement {
  const setValue = (value: number) => app.state.set({ harmonic: { ...app.state.get().harmonic, value } });
  const value = numberField({
    label: t('Value of the next pin'),
    step: 1,
    onChange: setValue,
    onRefuse: (why) => app.refuse(why),
  });
  value.element.dataset.field = 'value';
  const quick = [0, 1].map((number) =>
    button(String(number), () => setValue(number), {
      class: 'key',
      'aria-label': t('Pin to {value}', { value: number }),
    }),
  );
  const preset = menu(
    t('Values of the boundary'),
    [['', ''] as const, ...boundaryPresets.map(({ id, label }) => [id, t(label)] as const)],
    () => pinLoops(),
  );
  const [unchosen, constant] = preset.options;
  if (unchosen) unchosen.disabled = true;
  /** What the menu last pinned: as long as it is there, the menu names it. */
  let chosen: readonly Pin[] | null = null;
  let loops: readonly Loop[] = [];
  /** Of which they are. */
  let loopsOf: Mesh | null = null;
  const loopMenu = menu(t('Loop of the boundary'), [], () => forget());
  const loopLine = h('div', { class: 'line' }, h('span', { class: 'line-name' }, t('Loop')), loopMenu);
  const clear = button(t('Clear'), () => clearPins(), { 'data-action': 'clear-pins' });
  const example = button(
    t('Two pins, 0 and 1'),
    () => {
      const { mesh } = app.results.get();
      if (mesh) app.setPins(examplePins(mesh));
    },
    { 'data-action': 'example-pins' },
  );
  const readouts = sideTable(
    t('Values'),
    [
      { id: 'value', name: t('at the vertex') },
      { id: 'min', name: t('smallest') },
      { id: 'max', name: t('largest') },
      { id: 'outside', name: t('out of range') },
    ],
    'figures6',
  );
  const verdict = h('p', { class: 'note', 'data-readout': 'verdict' });
  const pinSelected = button(t('Pin'), () => togglePin(), { 'data-action': 'pin-vertex' });
  const list = h('ol', { class: 'pins' });
  // Takes the focus when the button that had it goes.
  const listTitle = h('h2', { tabindex: -1 });
  const element = h(
    'div',
    { class: 'panel-body' },
    h(
      'section',
      {},
      h('h2', {}, t('Pin values')),
      h('div', { class: 'line' }, h('span', { class: 'line-name' }, t('Click to pin')), value.element, ...quick),
      loopLine,
      h('div', { class: 'line' }, h('span', { class: 'line-name' }, t('Boundary')), preset),
      h('div', { class: 'line' }, example, clear),
    ),
    h('section', {}, h('div', { class: 'line' }, vertexField(app), pinSelected), readouts.element, verdict),
    coloursSection(app),
    h('section', {}, listTitle, list),
  );

  function forget(): void {
    chosen = null;
    preset.value = '';
  }

  /** All of the boundary and nothing else, or one loop beside what is pinned elsewhere. */
  function pinLoops(): void {
    const { mesh } = app.results.get();
    if (!mesh) return;
    const { pins, value } = app.state.get().harmonic;
    const loop = loops[Number(loopMenu.value)];
    const own = new Set(loop?.vertices);
    chosen =
      loopMenu.value === '' || !loop
        ? boundaryPins(mesh, loops, preset.value, value)
        : [...pins.filter(({ vertex }) => !own.has(vertex)), ...boundaryPins(mesh, [loop], preset.value, value)];
    app.setPins(chosen);
  }

  function clearPins(): void {
    app.setPins([]);
    listTitle.focus();
  }

  function removePin(vertex: number): void {
    const at = app.state.get().harmonic.pins.findIndex((pin) => pin.vertex === vertex);
    app.pin(vertex, null);
    const rest = list.querySelectorAll<HTMLElement>('[data-action=remove-pin]');
    (rest[Math.min(at, rest.length - 1)] ?? listTitle).focus();
  }

  function togglePin(): void {
    const { selected, harmonic } = app.state.get();
    if (selected === null) return;
    const pinned = harmonic.pins.some((pin) => pin.vertex === selected);
    app.pin(selected, pinned ? null : harmonic.value);
  }

  app.state.watch(
    (state) => [state.harmonic.value],
    (next) => {
      value.set(next);
      forget();
      if (constant) constant.textContent = `${t('constant')} ${exact(next)}`;
    },
  );
  const showLoops = () => {
    const { mesh } = app.results.get();
    if (app.state.get().task !== 'harmonic' || loopsOf === mesh) return;
    loopsOf = mesh;
    loops = mesh ? boundaryLoops(mesh) : [];
    const several = loops.length > 1;
    loopLine.hidden = !several;
    loopMenu.replaceChildren(
      h('option', { value: '' }, t('all {some} loops', { some: count(loops.length) })),
      ...(several ? loops.slice(0, listed) : []).map(({ vertices }, k) =>
        h(
          'option',
          { value: k },
          `${t('loop {loop}', { loop: k + 1 })}, ${t('{n} vertex|{n} vertices', { n: vertices.length })}`,
        ),
      ),
    );
    forget();
  };
  app.state.watch((state) => [state.task], showLoops);
  app.results.watch((results) => [results.mesh], showLoops);
  app.results.watch(
    (results) => [results.mesh],
    (mesh) => {
      const bounded = (mesh?.boundary.length ?? 0) > 0;
      preset.disabled = !bounded;
      if (unchosen) unchosen.textContent = bounded ? t('choose…') : t('no boundary');
    },
  );
  app.state.watch(
    (state) => [state.harmonic.pins, state.selected],
    (pins, selected) => {
      pinSelected.disabled = selected === null;
      pinSelected.textContent = pins.some((pin) => pin.vertex === selected) ? t('Unpin') : t('Pin');
    },
  );
  app.state.watch(
    (state) => [state.harmonic.pins],
    (pins) => {
      if (pins !== chosen) forget();
      clear.disabled = pins.length === 0;
      listTitle.textContent = pins.length === 0 ? t('No pins yet') : t('{n} pin|{n} pins', { n: pins.length });
      // A row that is being typed into must not be built anew, nor move.
      const rows = new Map(
        Array.from(list.children, (row) => [
          (row as HTMLElement).dataset.vertex,
          row as HTMLElement & { set: (value: number) => void },
        ]),
      );
      const wanted: HTMLElement[] = pins.slice(0, listed).map((pin) => {
        const row = rows.get(String(pin.vertex)) ?? pinRow(app, pin.vertex, removePin);
        row.set(pin.value);
        return row;
      });
      if (pins.length > listed)
        wanted.push(h('li', { class: 'note' }, t('and {some} more', { some: count(pins.length - listed) })));
      const same = wanted.length === list.children.length && wanted.every((row, k) => row === list.children[k]);
      if (!same) list.replaceChildren(...wanted);
    },
  );

  const showReadouts = () => {
    const results = app.results.get();
    const {
      selected,
      harmonic: { pins },
    } = app.state.get();
    const vertex = results.hovered ?? selected;
    readouts.rename('value', vertex === null ? t('at the vertex') : t('vertex {vertex}', { vertex }));
    for (const side of sides) {
      const { harmonic } = results[side];
      const known = harmonic !== null && typeof harmonic !== 'string' ? harmonic : null;
      const at = vertex === null ? undefined : known?.values[vertex];
      const read = (value: number | undefined) =>
        known && value !== undefined ? { text: exact(cleared(value, sizeOf(known))), value } : { text: '–' };
      readouts.set('value', side, read(at));
      readouts.set('min', side, read(known?.min));
      readouts.set('max', side, read(known?.max));
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
    const none = pins.length === 0 ? t('Pin a vertex to see the harmonic function of both operators.') : ' ';
    put(verdict, verdictOn(results.a.harmonic, results.b.harmonic) || none);
  };
  app.results.watch((results) => [results.a.harmonic, results.b.harmonic, results.hovered], showReadouts);
  app.state.watch((state) => [state.selected, state.harmonic.pins], showReadouts);
  return element;
}

/** Each side's own: a message where there is one, the number of vertices outside where not. */
export function verdictOn(a: Harmonic | string | null, b: Harmonic | string | null): string {
  if (a === null || b === null) return '';
  if (typeof a === 'string' && typeof b === 'string')
    return a === b ? t('A and B: {why}', { why: a }) : `A: ${a} B: ${b}`;
  const range = ({ fixedMin, fixedMax }: Harmonic) =>
    t('[{low}, {high}]', { low: exact(fixedMin), high: exact(fixedMax) });
  if (typeof a !== 'string' && typeof b !== 'string')
    return t('{a} | {b} vertices outside the pinned range {range}; the maximum principle allows none.', {
      a: count(a.outside.length),
      b: count(b.outside.length),
      range: range(a),
    });
  return [a, b]
    .map((own, k) => {
      const letter = 'AB'[k];
      return typeof own === 'string'
        ? `${letter}: ${own}`
        : `${letter}: ${t(
            '{n} vertex outside the pinned range {range}; the maximum principle allows none.|{n} vertices outside the pinned range {range}; the maximum principle allows none.',
            { n: own.outside.length, range: range(own) },
          )}`;
    })
    .join(' ');
}

function pinRow(
  app: App,
  vertex: number,
  remove: (vertex: number) => void,
): HTMLElement & { set: (value: number) => void } {
  const field = numberField({
    label: t('Value of the pin at vertex {vertex}', { vertex }),
    step: 1,
    onChange: (value) => app.pin(vertex, value),
    onRefuse: (why) => app.refuse(why),
  });
  const row = h(
    'li',
    { 'data-vertex': vertex },
    button(t('vertex {vertex}', { vertex: count(vertex) }), () => app.select(vertex), { class: 'quiet' }),
    field.element,
    button('×', () => remove(vertex), {
      class: 'key',
      'data-action': 'remove-pin',
      'aria-label': t('Remove the pin at vertex {vertex}', { vertex }),
    }),
  );
  return Object.assign(row, { set: field.set });
}
