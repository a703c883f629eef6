import type { App } from '../app.js';
import { h } from '../dom.js';
import { count, weight } from '../format.js';
import type { Weights } from '../polylap.js';
import { wideLimit } from '../scene/lines.js';
import { sides } from '../state.js';
import { t, word } from '../words.js';
import { faceSection } from './face-section.js';
import { vertexField } from './number-walk.js';
import { rowSection } from './row-section.js';
import { sideTable } from './table.js';
import { vertexWeights } from './vertex-weights.js';
import { weightsPlots } from './weights-plots.js';

/** What the weights are: extremes, the row of the selected vertex, and weights of vertices where an operator takes them. */
export function weightsPanel(app: App): HTMLElement {
  const extremes = sideTable(t('Weights'), [
    { id: 'smallest', name: t('smallest') },
    { id: 'largest', name: t('largest') },
  ]);
  const lines = h('p', { class: 'note' });
  const element = h(
    'div',
    { class: 'panel-body' },
    h('section', {}, h('h2', {}, `${t('Weights')} `, h('i', {}, 'w'), h('sub', {}, 'ij')), extremes.element, lines),
    h('section', {}, vertexField(app), vertexWeights(app), rowSection(app)),
    faceSection(app),
    weightsPlots(app),
  );

  for (const side of sides) {
    app.results.watch(
      (results) => [results[side].weights],
      (weights) => {
        const known = weights !== null && typeof weights !== 'string';
        for (const id of ['smallest', 'largest'] as const) {
          const value = known ? weights[id] : null;
          // A zero that rounding made negative counts as none, and looks like none.
          const minus = known && weights[id] < 0 && weights.negativeOrdered > 0;
          extremes.set(id, side, {
            text: value === null ? '–' : weight(value < 0 && !minus ? 0 : value),
            value,
            class: minus ? 'negative' : '',
          });
        }
      },
    );
  }
  app.results.watch(
    (results) => [results.a.weights, results.b.weights],
    (...both) => {
      const known = both.filter((weights) => weights !== null && typeof weights !== 'string');
      if (known.every((weights) => weights.negativeOrdered === 0)) {
        lines.textContent = known.length > 0 ? t('No weight is negative.') : '';
        return;
      }
      const pairs = known.map((weights) => drawnPairs(weights)).join(' | ');
      const hairlines = known.some((weights) => weights.segmentStarts.length > wideLimit);
      lines.textContent = t(
        hairlines
          ? word('Dashed on the mesh as hairlines, drawn: {pairs} pairs, each counted both ways.')
          : word('Dashed on the mesh, drawn: {pairs} pairs, each counted both ways.'),
        { pairs },
      );
    },
  );

  return element;
}

/** How many negative pairs are drawn, and of how many if not all are. */
export function drawnPairs({ pairs, segmentPairs }: Pick<Weights, 'pairs' | 'segmentPairs'>): string {
  const all = pairs.length / 2;
  const drawn = new Set(segmentPairs).size;
  return drawn < all ? t('{some} of {all}', { some: count(drawn), all: count(all) }) : count(all);
}
