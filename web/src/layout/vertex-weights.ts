import type { App } from '../app.js';
import { h } from '../dom.js';
import { typed } from '../format.js';
import type { Side } from '../polylap.js';
import { operatorOf, sides } from '../state.js';
import { t } from '../words.js';
import { button, numberField, slider } from './controls.js';

/** The weight ω of the selected vertex, for the sides whose operator takes such weights. */
export function vertexWeights(app: App): HTMLElement {
  return h('div', { class: 'vertex-weights' }, ...sides.map((side) => weightRow(app, side)));
}

function weightRow(app: App, side: Side): HTMLElement {
  const letter = side.toUpperCase();
  const label = t('Weight ω of the vertex on {side}', { side: letter });
  const set = (weight: number) => {
    const { selected } = app.state.get();
    if (selected !== null) app.setWeight(side, selected, weight);
  };
  /** The slider is in units of the mean squared edge length. */
  const unit = () => app.results.get().mesh?.meanSquaredEdge ?? 1;
  const track = slider({
    label,
    min: -1,
    max: 1,
    step: 0.01,
    onInput: (at) => set(Number((at * unit()).toPrecision(4))),
  });
  const field = numberField({
    label,
    besideSlider: true,
    onChange: set,
    onRefuse: (why) => app.refuse(why),
  });
  field.element.dataset.field = `omega-${side}`;
  const given = h('span', { class: 'note', 'data-readout': 'weighted' });
  const clear = button(
    t('Clear all'),
    () => {
      app.setWeights(side, {});
      track.element.focus();
    },
    { 'data-action': `clear-weights-${side}`, 'aria-label': t('Clear all weights of {side}', { side: letter }) },
  );
  const element = h(
    'div',
    { class: 'vertex-weight', role: 'group', 'aria-label': t('Vertex weights of {side}', { side: letter }) },
    h(
      'div',
      { class: 'parameter' },
      h('span', { class: 'parameter-name', 'aria-hidden': 'true' }, h('i', {}, 'ω'), ` ${letter}`),
      track.element,
      field.element,
    ),
    h('div', { class: 'line' }, given, clear),
  );
  const show = () => {
    const { sides: choices, vertexWeights: weights, selected } = app.state.get();
    element.hidden = !operatorOf(choices[side]).takesVertexWeights;
    const weight = selected === null ? null : (weights[side][selected] ?? 0);
    track.set((weight ?? 0) / unit(), typed(weight ?? 0));
    field.set(weight);
    track.element.disabled = field.element.disabled = selected === null;
    const total = Object.keys(weights[side]).length;
    given.textContent =
      total === 0 ? t('ω = 0 everywhere') : t('{n} weighted vertex|{n} weighted vertices', { n: total });
    clear.hidden = total === 0;
  };
  app.state.watch((state) => [state.sides[side].operator, state.vertexWeights[side], state.selected], show);
  app.results.watch((results) => [results.mesh], show);
  return element;
}
