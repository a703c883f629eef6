import type { App } from '../app.js';
import { Outside, outsideOf, sizeOf } from '../colouring.js';
import { h, put } from '../dom.js';
import { cleared, count, exact, real } from '../format.js';
import { type Mesh, operators, type Side } from '../polylap.js';
import { known } from '../results.js';
import { initialChoice, operatorOf } from '../state.js';
import { t, word } from '../words.js';
import { button, menu } from './controls.js';
import { formulaParts } from './formula.js';
import { parameterControls } from './parameters.js';

/** One side: operator, formula, the number of negative weights, the view of its surface, parameters, figures. */
export function card(app: App, side: Side): { element: HTMLElement; view: HTMLElement } {
  const letter = side.toUpperCase();
  const choose = menu(
    t('Operator of {side}', { side: letter }),
    operators.map(({ id, label }) => [id, t(label)] as const),
    (id) => app.setChoice(side, initialChoice(id)),
    { class: 'operator' },
  );
  // Where there are no controls.
  const operatorName = h('b', { class: 'operator-name', hidden: true });
  const formula = h('div', { class: 'formula' });
  const loud = h(
    'output',
    { class: 'loud', 'aria-label': t('Negative weights of {side}', { side: letter }), 'data-readout': 'negative' },
    '–',
  );
  const caption = h('span', { class: 'count-name' });
  const share = h('span', { class: 'count-share' });
  const again = button(t('Compute'), () => app.answers.update(side), { class: 'quiet' });
  const view = h('div', {
    class: 'view',
    tabindex: 0,
    role: 'application',
    'aria-roledescription': t('3D view'),
    'data-view': side,
  });
  const at = h('span', { 'data-readout': 'vertex' });
  const crossing = h('span', { 'data-readout': 'card-edge' });
  const outside = h('span', { 'data-readout': 'card-outside' });
  const figures = h('p', { class: 'figures' });
  const element = h(
    'div',
    { class: 'card', role: 'group', 'data-side': side, 'aria-label': t('Side {side}', { side: letter }) },
    h(
      'header',
      { class: 'card-head' },
      h('span', { class: 'badge', 'aria-hidden': 'true' }, letter),
      choose,
      operatorName,
      formula,
    ),
    h('div', { class: 'count' }, loud, h('p', { class: 'count-text' }, caption, share), again),
    view,
    h('p', { class: 'view-caption' }, at, outside, crossing),
    h('footer', { class: 'card-foot' }, parameterControls(app, side), figures),
  );

  app.state.watch(
    (state) => [state.sides[side].operator],
    () => {
      const operator = operatorOf(app.state.get().sides[side]);
      choose.value = operator.id;
      operatorName.textContent = t(operator.label);
      choose.title = `${t(operator.summary)}\n${operator.citation}`;
      formula.replaceChildren(...formulaParts(operator.formulaMathml));
      view.setAttribute(
        'aria-label',
        t('Mesh {side}, {operator}. Arrow keys turn it, plus and minus zoom, 0 shows all of it.', {
          side: letter,
          operator: t(operator.label),
        }),
      );
    },
  );
  app.results.watch(
    (results) => [results[side].weights],
    (weights) => {
      const failed = typeof weights === 'string';
      const there = weights !== null && !failed;
      put(loud, there ? count(weights.negativeOrdered) : '–', there ? weights.negativeOrdered : null);
      loud.classList.toggle('negative', there && weights.negativeOrdered > 0);
      caption.textContent = t(
        there && weights.negativeOrdered === 1
          ? word('negative weight')
          : failed
            ? word('no weights')
            : word('negative weights'),
      );
      share.textContent = there
        ? t('of {all} off-diagonal pairs', { all: count(weights.nonzeroOrdered) })
        : failed
          ? weights
          : ' ';
      share.title = share.textContent;
      again.hidden = !failed;
    },
  );
  app.results.watch(
    (results) => [results.mesh, results[side].shape],
    (mesh, shape) => {
      figures.replaceChildren();
      if (!mesh) return;
      const planarity = h('span', { 'data-readout': 'non-planarity' });
      if (shape) put(planarity, real(shape.meanNonPlanarity, 3), shape.meanNonPlanarity);
      figures.append(
        h(
          'span',
          { 'data-readout': 'vertices', 'data-value': mesh.vertices },
          t('{n} vertex|{n} vertices', { n: mesh.vertices }),
        ),
        ' · ',
        h('span', { 'data-readout': 'faces', 'data-value': mesh.faces }, faceCount(mesh)),
        ` · ${t('mean non-planarity')} `,
        planarity,
      );
    },
  );
  const showVertex = () => {
    const results = app.results.get();
    const { selected, task } = app.state.get();
    if (results.hoveredFace !== null) {
      put(at, t('face {face}', { face: results.hoveredFace }));
      return;
    }
    const vertex = results.hovered ?? selected;
    const { harmonic } = results[side];
    const shown = task === 'harmonic' ? known(harmonic) : null;
    const value = shown?.values[vertex ?? -1];
    const text = shown && value !== undefined ? `: ${exact(cleared(value, sizeOf(shown)))}` : '';
    put(at, vertex === null ? '' : `${t('vertex {vertex}', { vertex })}${text}`, value);
  };
  const showOutside = () => {
    const shown = app.state.get().task === 'harmonic' ? known(app.results.get()[side].harmonic) : null;
    const leaving = shown ? outsideOf(shown) : [];
    const above = leaving.filter(([, where]) => where === Outside.above).length;
    const below = leaving.length - above;
    const texts = shown
      ? [
          [below, word('{n} vertex below {end}|{n} vertices below {end}'), shown.fixedMin] as const,
          [above, word('{n} vertex above {end}|{n} vertices above {end}'), shown.fixedMax] as const,
        ].flatMap(([n, text, end]) => (n > 0 ? [t(text, { n, end: exact(end) })] : []))
      : [];
    put(outside, texts.join(' · '), shown ? leaving.length : null);
  };
  const showEdge = () => {
    const { edge, [side]: own } = app.results.get();
    const dual = app.state.get().task === 'dual' ? known(own.dual) : null;
    const [one = 0, other = 0] = dual && edge !== null ? dual.lengths.subarray(2 * edge, 2 * edge + 2) : [];
    const shown = dual?.weights[edge ?? -1];
    put(
      crossing,
      shown === undefined
        ? ''
        : t('edge {edge}: {one} and {other}, weight {weight}', {
            edge: edge ?? '',
            one: real(one, 3),
            other: real(other, 3),
            weight: real(shown, 3),
          }),
      shown,
    );
  };
  app.results.watch((results) => [results.edge, results[side].dual], showEdge);
  app.state.watch((state) => [state.task], showEdge);
  app.results.watch((results) => [results[side].harmonic], showOutside);
  app.state.watch((state) => [state.task], showOutside);
  app.results.watch((results) => [results.hovered, results.hoveredFace, results[side].harmonic], showVertex);
  app.state.watch((state) => [state.selected, state.task], showVertex);
  return { element, view };
}

/** By what they are, where they are alike. */
export function faceCount({
  faces: n,
  minCorners,
  maxCorners,
}: Pick<Mesh, 'faces' | 'minCorners' | 'maxCorners'>): string {
  const alike = minCorners === maxCorners ? minCorners : 0;
  if (alike === 3) return t('{n} triangle|{n} triangles', { n });
  return alike === 4 ? t('{n} quad|{n} quads', { n }) : t('{n} face|{n} faces', { n });
}
