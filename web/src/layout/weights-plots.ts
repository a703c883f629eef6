import type { App } from '../app.js';
import { h } from '../dom.js';
import { count, exact } from '../format.js';
import { faceSizes, spyBlocks, weightBins, weightsOf } from '../plots/data.js';
import { bars, spy } from '../plots/draw.js';
import { figure } from '../plots/figure.js';
import { known } from '../results.js';
import { sides } from '../state.js';
import { t, word } from '../words.js';

/** All weights at a glance: their signs and sizes, where the matrices have them, and of which faces they come. */
export function weightsPlots(app: App): HTMLElement {
  const weights = sides.map((side) => figure(t('Weights of {side}', { side: side.toUpperCase() }), `weights-${side}`));
  const patterns = sides.map((side) => figure(t('S of {side}', { side: side.toUpperCase() }), `spy-${side}`));
  const sizes = figure(t('Corners of the faces'), 'face-sizes');
  const element = h(
    'section',
    { class: 'plots' },
    h('h2', {}, t('Plots')),
    ...weights.map((plot) => plot.element),
    h('div', { class: 'plot-pair' }, ...patterns.map((plot) => plot.element)),
    sizes.element,
  );
  app.results.watch(
    ({ a, b }) => [a.matrices, b.matrices],
    (...answers) => {
      const matrices = answers.map((answer) => known(answer)?.stiffness ?? null);
      const [a = [], b = []] = matrices.map((matrix) => (matrix ? weightsOf(matrix) : []));
      const bins = weightBins(a, b);
      sides.forEach((side, k) => {
        const matrix = matrices[k];
        const own = bins[k] ?? [];
        const all = k === 0 ? a : b;
        const negative = all.filter((weight) => weight < 0).length;
        weights[k]?.show(
          matrix ? bars(own) : null,
          t('Histogram of {all} weights of {side}, {negative} of them negative', {
            all: count(all.length),
            side: side.toUpperCase(),
            negative: count(negative),
          }),
          [word('from'), word('to'), word('weights')],
          own.map(({ from, to, count: number }) => [from, to, number]),
        );
        if (!matrix) {
          patterns[k]?.show(null, '', [], []);
          return;
        }
        const { blocks, across } = spyBlocks(matrix);
        const rows = [...blocks].map(([key, minus]) => [Math.floor(key / across), key % across, minus ? 1 : 0]);
        patterns[k]?.show(
          spy(blocks, across),
          t('Entries of S of {side} in {across} × {across} blocks: {some} have some', {
            side: side.toUpperCase(),
            across,
            some: count(blocks.size),
          }),
          [word('block row'), word('block column'), word('negative weight')],
          rows.sort(([p = 0, r = 0], [q = 0, s = 0]) => p - q || r - s),
        );
      });
    },
  );
  app.results.watch(
    (results) => [results.mesh],
    (mesh) => {
      const found = mesh ? faceSizes(mesh.geometry) : [];
      const [first, last] = [found[0]?.[0] ?? 3, found.at(-1)?.[0] ?? 3];
      const bins = found.map(([corners, number]) => ({ from: corners - 0.5, to: corners + 0.5, count: number }));
      // All faces alike need no plot.
      sizes.show(
        found.length > 1 ? bars(bins) : null,
        t('Faces by corners: from {first} to {last}', { first: exact(first), last: exact(last) }),
        [word('corners'), word('faces')],
        found,
      );
    },
  );
  return element;
}
