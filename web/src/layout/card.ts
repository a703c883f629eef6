import type { App } from '../app.js';
import { Outside, outsideOf, sizeOf } from '../colouring.js';
import { h, put } from '../dom.js';
import { cleared, count, exact, plural, real } from '../format.js';
import { type Mesh, operators, type Side } from '../polylap.js';
import { known } from '../results.js';
import { initialChoice, operatorOf } from '../state.js';
import { button, menu } from './controls.js';
import { formulaParts } from './formula.js';
import { parameterControls } from './parameters.js';

/** One side: operator, formula, the number of negative weights, the view of its surface, parameters, figures. */
export function card(app: App, side: Side): { element: HTMLElement; view: HTMLElement } {
  const letter = side.toUpperCase();
  const choose = menu(
    `Operator of ${letter}`,
    operators.map(({ id, label }) => [id, label] as const),
    (id) => app.setChoice(side, initialChoice(id)),
    { class: 'operator' },
  );
  const formula = h('div', { class: 'formula' });
  const loud = h(
    'output',
    { class: 'loud', 'aria-label': `Negative weights of ${letter}`, 'data-readout': 'negative' },
    '–',
  );
  const caption = h('span', { class: 'count-name' });
  const share = h('span', { class: 'count-share' });
  const again = button('Compute', () => app.answers.update(side), { class: 'quiet' });
  const view = h('div', {
    class: 'view',
    tabindex: 0,
    role: 'application',
    'aria-roledescription': '3D view',
    'data-view': side,
  });
  const at = h('span', { 'data-readout': 'vertex' });
  const crossing = h('span', { 'data-readout': 'card-edge' });
  const outside = h('span', { 'data-readout': 'card-outside' });
  const figures = h('p', { class: 'figures' });
  const element = h(
    'section',
    { class: 'card', 'data-side': side, 'aria-label': `Side ${letter}` },
    h('header', { class: 'card-head' }, h('span', { class: 'badge', 'aria-hidden': 'true' }, letter), choose, formula),
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
      choose.title = `${operator.summary}\n${operator.citation}`;
      formula.replaceChildren(...formulaParts(operator.formulaMathml));
      view.setAttribute(
        'aria-label',
        `Mesh ${letter}, ${operator.label}. Arrow keys turn it, plus and minus zoom, 0 shows all of it.`,
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
      caption.textContent =
        there && weights.negativeOrdered === 1 ? 'negative weight' : failed ? 'no weights' : 'negative weights';
      share.textContent = there ? `of ${count(weights.nonzeroOrdered)} off-diagonal pairs` : failed ? weights : ' ';
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
          plural(mesh.vertices, 'vertex', 'vertices'),
        ),
        ' · ',
        h('span', { 'data-readout': 'faces', 'data-value': mesh.faces }, plural(mesh.faces, ...faceNames(mesh))),
        ' · mean non-planarity ',
        planarity,
      );
    },
  );
  const showVertex = () => {
    const results = app.results.get();
    const { selected, task } = app.state.get();
    if (results.hoveredFace !== null) {
      put(at, `face ${results.hoveredFace}`);
      return;
    }
    const vertex = results.hovered ?? selected;
    const { harmonic } = results[side];
    const shown = task === 'harmonic' ? known(harmonic) : null;
    const value = shown?.values[vertex ?? -1];
    const text = shown && value !== undefined ? `: ${exact(cleared(value, sizeOf(shown)))}` : '';
    put(at, vertex === null ? '' : `vertex ${vertex}${text}`, value);
  };
  const showOutside = () => {
    const shown = app.state.get().task === 'harmonic' ? known(app.results.get()[side].harmonic) : null;
    const leaving = shown ? outsideOf(shown) : [];
    const above = leaving.filter(([, where]) => where === Outside.above).length;
    const below = leaving.length - above;
    const texts = shown
      ? [[below, 'below', shown.fixedMin] as const, [above, 'above', shown.fixedMax] as const].flatMap(
          ([number, where, end]) =>
            number > 0 ? [`${plural(number, 'vertex', 'vertices')} ${where} ${exact(end)}`] : [],
        )
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
      shown === undefined ? '' : `edge ${edge}: ${real(one, 3)} and ${real(other, 3)}, weight ${real(shown, 3)}`,
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

export function faceNames({ minCorners, maxCorners }: Pick<Mesh, 'minCorners' | 'maxCorners'>): [string, string] {
  if (minCorners === maxCorners && minCorners === 3) return ['triangle', 'triangles'];
  if (minCorners === maxCorners && minCorners === 4) return ['quad', 'quads'];
  return ['face', 'faces'];
}
