import type { App } from '../app.js';
import { type ColourMap, colourMaps } from '../colour-maps.js';
import { colouring } from '../colouring.js';
import { h } from '../dom.js';
import type { State } from '../state.js';
import { t } from '../words.js';
import { menu } from './controls.js';

/** How values become colours, on both sides alike. */
export function coloursSection(app: App): HTMLElement {
  const set = (patch: Partial<State['colours']>) =>
    app.state.set({ colours: { ...app.state.get().colours, ...patch } });
  const map = menu(
    t('Colours of values'),
    colourMaps.map(([id, name]) => [id, t(name)] as const),
    (id) => set({ map: id as ColourMap }),
  );
  const check = (label: string, field: string, onPick: (on: boolean) => void) => {
    const input = h('input', { type: 'checkbox', 'data-field': field, onchange: () => onPick(input.checked) });
    return { input, element: h('label', { class: 'check' }, input, label) };
  };
  const isolines = check(t('Isolines'), 'isolines', (on) => set({ isolines: on }));
  const symmetric = check(t('Zero in the middle'), 'symmetric', (on) => set({ symmetric: on }));
  const lock = check(t('Keep the range'), 'locked', (on) => {
    const range = colouring(app.state.get(), app.results.get())?.range;
    set({ locked: on && range ? { min: range.min, max: range.max } : null });
  });
  app.state.watch(
    (state) => [state.colours],
    (colours) => {
      map.value = colours.map;
      isolines.input.checked = colours.isolines;
      symmetric.input.checked = colours.symmetric;
      lock.input.checked = colours.locked !== null;
      symmetric.input.disabled = colours.locked !== null;
    },
  );
  return h(
    'section',
    {},
    h('h2', {}, t('Colours')),
    h('div', { class: 'buttons' }, map, isolines.element, lock.element, symmetric.element),
  );
}
