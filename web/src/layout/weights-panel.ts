import { rowLimit } from '../answers.js';
import type { App } from '../app.js';
import { h } from '../dom.js';
import { count, plural, weight } from '../format.js';
import type { Mesh, Side, Weights } from '../polylap.js';
import { wideLimit } from '../scene/lines.js';
import { sparseRow } from '../sparse-row.js';
import { sides } from '../state.js';
import { stencil } from './stencil.js';
import { sideTable } from './table.js';
import { vertexField } from './vertex-field.js';
import { vertexWeights } from './vertex-weights.js';
import { weightsPlots } from './weights-plots.js';

const rowsShown = 24;
/** As for the counts: what is smaller beside the diagonal has no sign. */
const rounding = 1e-10;

/** What the weights are: extremes, the row of the selected vertex, and weights of vertices where an operator takes them. */
export function weightsPanel(app: App): HTMLElement {
  const extremes = sideTable('Weights', [
    { id: 'smallest', name: 'smallest' },
    { id: 'largest', name: 'largest' },
  ]);
  const lines = h('p', { class: 'note' });
  const row = h('div', { class: 'row' });
  const element = h(
    'div',
    { class: 'panel-body' },
    h('section', {}, h('h2', {}, 'Weights ', h('i', {}, 'w'), h('sub', {}, 'ij')), extremes.element, lines),
    h('section', {}, vertexField(app), vertexWeights(app), row),
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
        lines.textContent = known.length > 0 ? 'No weight is negative.' : '';
        return;
      }
      const pairs = known.map((weights) => drawnPairs(weights)).join(' | ');
      const hairlines = known.some((weights) => weights.segmentStarts.length > wideLimit);
      lines.textContent = `Dashed on the mesh${hairlines ? ' as hairlines' : ''}, drawn: ${pairs} pairs, each counted both ways.`;
    },
  );

  const showRow = () => {
    const { selected } = app.state.get();
    const { mesh } = app.results.get();
    if (selected === null) {
      row.replaceChildren(
        h('p', { class: 'note' }, 'Click a vertex, or walk with [ and ], to read its row of weights.'),
      );
      return;
    }
    if (mesh && mesh.vertices > rowLimit) {
      row.replaceChildren(
        h('p', { class: 'note' }, `Rows are read on meshes of up to ${plural(rowLimit, 'vertex', 'vertices')}.`),
      );
      return;
    }
    const rows = rowsOf(app, selected);
    if (!mesh || !rows) {
      const { a, b } = app.results.get();
      const why = [a.matrices, b.matrices].flatMap((own, k) => (typeof own === 'string' ? [`${'AB'[k]}: ${own}`] : []));
      row.replaceChildren(h('p', { class: 'note' }, why.join(' ')));
      return;
    }
    row.replaceChildren(stencils(app, mesh, selected, rows), rowTable(selected, rows));
  };
  app.state.watch((state) => [state.selected], showRow);
  app.results.watch((results) => [results.a.matrices, results.b.matrices], showRow);
  return element;
}

/** How many negative pairs are drawn, and of how many if not all are. */
export function drawnPairs({ pairs, segmentPairs }: Pick<Weights, 'pairs' | 'segmentPairs'>): string {
  const all = pairs.length / 2;
  const drawn = new Set(segmentPairs).size;
  return drawn < all ? `${count(drawn)} of ${count(all)}` : count(all);
}

/** Column → entry of S in the row of a vertex, without the entries that are only rounding. */
function rowsOf(app: App, vertex: number): Record<Side, Map<number, number>> | null {
  const rows = sides.map((side) => {
    const { matrices } = app.results.get()[side];
    if (matrices === null || typeof matrices === 'string') return null;
    const row = sparseRow(matrices.stiffness, vertex);
    const least = rounding * Math.abs(row.get(vertex) ?? 0);
    return new Map([...row].map(([j, entry]) => [j, Math.abs(entry) > least ? entry : 0]));
  });
  const [a, b] = rows;
  return a && b ? { a, b } : null;
}

/** The two rows, drawn at one scale. */
function stencils(app: App, mesh: Mesh, vertex: number, rows: Record<Side, Map<number, number>>): HTMLElement {
  const weights = (side: Side) =>
    new Map([...rows[side]].filter(([j]) => j !== vertex).map(([j, entry]) => [j, -entry]));
  const both = { a: weights('a'), b: weights('b') };
  const largest = Math.max(...sides.flatMap((side) => [...both[side].values()].map(Math.abs)), Number.MIN_VALUE);
  return h(
    'div',
    { class: 'stencils' },
    ...sides.map((side) => {
      const figure = h('figure', {}, h('figcaption', {}, side.toUpperCase()));
      figure.prepend(stencil(mesh.geometry, app.results.get()[side].positions, vertex, both[side], largest));
      return figure;
    }),
  );
}

/** What is smaller beside the diagonal is rounding. */
function rowSum(row: ReadonlyMap<number, number>, vertex: number): number {
  const sum = [...row.values()].reduce((all, entry) => all + entry, 0);
  return Math.abs(sum) > rounding * Math.abs(row.get(vertex) ?? 0) ? sum : 0;
}

function rowTable(vertex: number, rows: Record<Side, Map<number, number>>): HTMLElement {
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
    h('caption', { class: 'unseen' }, `Weights of vertex ${vertex}`),
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
      hiddenRows > 0 ? h('tr', {}, h('td', { colspan: 3 }, `and ${count(hiddenRows)} more`)) : null,
    ),
    h(
      'tfoot',
      {},
      line(index('S', 'ii'), (side) => rows[side].get(vertex) ?? 0),
      line(h('span', {}, 'Σ ', index('S', 'ij')), (side) => rowSum(rows[side], vertex)),
    ),
  );
}
