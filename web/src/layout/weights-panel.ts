import { type App, rowLimit } from '../app.js';
import { h } from '../dom.js';
import { count, plural, weight } from '../format.js';
import type { operators, Side } from '../polylap.js';
import { drawnLimit, wideLimit } from '../scene/line-limits.js';
import { sparseRow } from '../sparse-row.js';
import { operatorOf, sides } from '../state.js';
import { sideTable } from './table.js';
import { vertexField } from './vertex-field.js';

const rowsShown = 24;

const claimNames: Record<keyof (typeof operators)[number]['claims'], string> = {
  symmetric: 'symmetric',
  positiveSemidefinite: 'positive semi-definite',
  constantsInKernel: 'constants in kernel',
  linearPrecision: 'linear precision',
  positiveWeights: 'weights ≥ 0',
};

/** What the weights are: extremes, the row of the selected vertex, what the operators promise. */
export function weightsPanel(app: App): HTMLElement {
  const extremes = sideTable('Weights', [
    { id: 'smallest', name: 'smallest' },
    { id: 'largest', name: 'largest' },
  ]);
  const lines = h('p', { class: 'note' });
  const row = h('div', { class: 'row' });
  const claims = sideTable(
    'What the operators promise',
    Object.entries(claimNames).map(([id, name]) => ({ id, name })),
    'brief',
  );
  const element = h(
    'div',
    { class: 'panel-body' },
    h('section', {}, h('h2', {}, 'Weights ', h('i', {}, 'w'), h('sub', {}, 'ij')), extremes.element, lines),
    h('section', {}, vertexField(app), row),
    h(
      'section',
      {},
      h('h2', {}, 'Promised by the operator'),
      claims.element,
      h('p', { class: 'note' }, 'planar: where faces are planar; triangles: on triangle meshes.'),
    ),
  );

  for (const side of sides) {
    app.results.watch(
      (results) => [results[side].weights],
      (weights) => {
        const known = weights !== null && typeof weights !== 'string';
        for (const id of ['smallest', 'largest'] as const) {
          const value = known ? weights[id] : null;
          extremes.set(id, side, {
            text: value === null ? '–' : weight(value),
            value,
            class: value !== null && value < 0 ? 'negative' : '',
          });
        }
      },
    );
    app.state.watch(
      (state) => [state.sides[side].operator],
      () => {
        const promised = operatorOf(app.state.get().sides[side]).claims;
        for (const id of Object.keys(claimNames) as (keyof typeof claimNames)[])
          claims.set(id, side, { text: promised[id] });
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
      const drawn = known.map((weights) => count(weights.pairs.length / 2)).join(' | ');
      const most = Math.max(...known.map((weights) => weights.segmentStarts.length));
      const how =
        most > drawnLimit
          ? `, one in ${Math.ceil(most / drawnLimit)} of them`
          : most > wideLimit
            ? ', as hairlines'
            : '';
      lines.textContent = `Dashed on the mesh${how}: ${drawn} pairs, each counted both ways.`;
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
    row.replaceChildren(rowTable(app, selected));
  };
  app.state.watch((state) => [state.selected], showRow);
  app.results.watch((results) => [results.a.matrices, results.b.matrices], showRow);
  return element;
}

function rowTable(app: App, vertex: number): HTMLElement {
  const results = app.results.get();
  const rows = Object.fromEntries(
    sides.map((side) => {
      const { matrices } = results[side];
      return [
        side,
        matrices && typeof matrices !== 'string' ? sparseRow(matrices.stiffness, vertex) : new Map<number, number>(),
      ];
    }),
  ) as Record<Side, Map<number, number>>;
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
    ),
  );
}
