import type { App } from '../app.js';
import { h } from '../dom.js';
import { real } from '../format.js';
import type { Dual } from '../polylap.js';
import { known } from '../results.js';
import { sides } from '../state.js';
import { t, word } from '../words.js';
import { numberField } from './controls.js';
import { sideTable } from './table.js';

/** What the duals say about one edge: the signed lengths of both halves of its dual edge, and its weight. */
export function edgeSection(app: App): HTMLElement {
  const field = numberField({
    label: t('Edge'),
    min: 0,
    max: () => Math.max(0, edgesOf(known(app.results.get().a.dual)) - 1),
    integer: true,
    step: 1,
    onChange: (edge) => app.readEdge(edge),
    onEmpty: () => app.readEdge(null),
    onRefuse: (why) => app.refuse(why),
  });
  field.element.placeholder = t('none');
  field.element.dataset.field = 'edge';
  const between = h('span', { class: 'note', 'data-readout': 'edge-vertices' });
  const table = sideTable(t('Edge point'), [
    { id: 'edge-left', name: t('one side') },
    { id: 'edge-right', name: t('other side') },
    { id: 'edge-weight', name: t('weight') },
  ]);
  const element = h(
    'section',
    {},
    h('div', { class: 'vertex-field' }, h('h2', {}, t('Edge')), field.element, between),
    table.element,
    h(
      'p',
      { class: 'note' },
      t(
        'Point at an edge point, or tap it. Lengths go from there to the dual points of both faces; they are negative where the dual point lies beyond the edge. The weight is their sum over the length of the edge.',
      ),
    ),
  );
  const show = () => {
    const { edge, a } = app.results.get();
    const of = known(a.dual);
    field.set(edge);
    const there = edge !== null && of !== null && edge < edgesOf(of);
    const [i, j] = there ? of.edgeVertices.subarray(2 * edge, 2 * edge + 2) : [];
    between.textContent = there ? t('between {i} and {j}', { i: i ?? '', j: j ?? '' }) : '';
    const ends = [
      ['edge-left', 0],
      ['edge-right', 1],
    ] as const;
    for (const [id, k] of ends) {
      const face = there ? (of.edgeFaces[2 * edge + k] ?? -1) : -1;
      table.rename(
        id,
        !there
          ? t(k === 0 ? word('one side') : word('other side'))
          : face < 0
            ? t('boundary')
            : t('to face {face}', { face }),
      );
    }
    for (const side of sides) {
      const dual = known(app.results.get()[side].dual);
      const put = (id: string, value: number | undefined) =>
        table.set(
          id,
          side,
          value === undefined || !Number.isFinite(value)
            ? { text: '–' }
            : { text: real(value, 3), value, class: value < 0 ? 'negative' : '' },
        );
      for (const [id, k] of ends) {
        const inside = there && (of.edgeFaces[2 * edge + k] ?? -1) >= 0;
        put(id, inside ? dual?.lengths[2 * edge + k] : undefined);
      }
      put('edge-weight', there ? dual?.weights[edge] : undefined);
    }
  };
  app.results.watch((results) => [results.edge, results.a.dual, results.b.dual], show);
  return element;
}

const edgesOf = (dual: Dual | null) => dual?.weights.length ?? 0;
