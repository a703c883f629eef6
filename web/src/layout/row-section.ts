import type { App } from '../app.js';
import { h } from '../dom.js';
import { count, weight } from '../format.js';
import type { Mesh, Side } from '../polylap.js';
import { drawnWeights, type Entries, largestWeight, rowSum, rowsOf } from '../rows.js';
import { sides } from '../state.js';
import { t } from '../words.js';
import { stencil } from './stencil.js';

const rowsShown = 24;

/** The row of the selected vertex on both sides: drawn, and as numbers. */
export function rowSection(app: App): HTMLElement {
  const element = h('div', { class: 'row' });
  const note = (text: string) => element.replaceChildren(h('p', { class: 'note' }, text));
  const show = () => {
    const { selected } = app.state.get();
    const results = app.results.get();
    const { mesh, a, b } = results;
    const rows = rowsOf(results, selected);
    const why = [a.row, b.row].flatMap((own, k) => (typeof own === 'string' ? [`${'AB'[k]}: ${own}`] : []));
    // What is there stays until there is something newer to see, and says by its looks that it is going.
    element.classList.toggle('awaited', selected !== null && !rows && why.length === 0);
    if (selected === null) note(t('Click a vertex, or walk with [ and ], to read its row of weights.'));
    else if (mesh && rows) element.replaceChildren(stencils(app, mesh, selected, rows), rowTable(selected, rows));
    else if (why.length > 0) note(why.join(' '));
  };
  app.state.watch((state) => [state.selected], show);
  app.results.watch(({ a, b }) => [a.row, b.row], show);
  return element;
}

/** The two rows, drawn at one scale. */
function stencils(app: App, mesh: Mesh, vertex: number, rows: Record<Side, Entries>): HTMLElement {
  const largest = largestWeight(rows, vertex);
  return h(
    'div',
    { class: 'stencils' },
    ...sides.map((side) => {
      const figure = h('figure', {}, h('figcaption', {}, side.toUpperCase()));
      const weights = drawnWeights(rows[side], vertex);
      figure.prepend(stencil(mesh.geometry, app.results.get()[side].positions, vertex, weights, largest));
      return figure;
    }),
  );
}

function rowTable(vertex: number, rows: Record<Side, Entries>): HTMLElement {
  const neighbours = [...new Set([...rows.a.keys(), ...rows.b.keys()])]
    .filter((j) => j !== vertex)
    .sort((p, q) => p - q);
  const cell = (side: Side, value: number) =>
    h('td', { class: value < 0 ? 'negative' : '', 'data-of': side, 'data-value': value }, weight(value));
  const line = (name: string | HTMLElement, value: (side: Side) => number) =>
    h('tr', {}, h('th', { scope: 'row' }, name), ...sides.map((side) => cell(side, value(side))));
  const index = (letter: string, below: string) => h('span', {}, h('i', {}, letter), h('sub', {}, below));
  const hiddenRows = neighbours.length - rowsShown;
  return h(
    'table',
    { class: 'readouts', 'data-row': vertex },
    h('caption', { class: 'unseen' }, t('Weights of vertex {vertex}', { vertex })),
    h(
      'thead',
      {},
      h(
        'tr',
        {},
        h('th', { scope: 'col' }, h('i', {}, 'j')),
        ...sides.map((side) => h('th', { scope: 'col' }, index('w', 'ij'), ` ${side.toUpperCase()}`)),
      ),
    ),
    h(
      'tbody',
      {},
      // w_ij = −S_ij; +0 so that a zero has no sign.
      ...neighbours.slice(0, rowsShown).map((j) => line(String(j), (side) => 0 - (rows[side].get(j) ?? 0))),
      hiddenRows > 0 ? h('tr', {}, h('td', { colspan: 3 }, t('and {some} more', { some: count(hiddenRows) }))) : null,
    ),
    h(
      'tfoot',
      {},
      line(index('S', 'ii'), (side) => rows[side].get(vertex) ?? 0),
      line(h('span', {}, 'Σ ', index('S', 'ij')), (side) => rowSum(rows[side], vertex)),
    ),
  );
}
