import type { App } from '../app.js';
import { h } from '../dom.js';
import { count, exact } from '../format.js';
import { faceSizes, spyBlocks, weightBins, weightsOf } from '../plots/data.js';
import { bars, spy } from '../plots/draw.js';
import { figure } from '../plots/figure.js';
import { known } from '../results.js';
import { sides } from '../state.js';

/** All weights at a glance: their signs and sizes, where the matrices have them, and of which faces they come. */
export function weightsPlots(app: App): HTMLElement {
  const weights = sides.map((side) => figure(`Weights of ${side.toUpperCase()}`, `weights-${side}`));
  const patterns = sides.map((side) => figure(`S of ${side.toUpperCase()}`, `spy-${side}`));
  const sizes = figure('Corners of the faces', 'face-sizes');
  const element = h(
    'section',
    { class: 'plots' },
    h('h2', {}, 'Plots'),
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
          `Histogram of ${count(all.length)} weights of ${side.toUpperCase()}, ${count(negative)} of them negative`,
          ['from', 'to', 'weights'],
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
          `Entries of S of ${side.toUpperCase()} in ${across} × ${across} blocks: ${count(blocks.size)} have some`,
          ['block row', 'block column', 'negative weight'],
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
        `Faces by corners: from ${exact(first)} to ${exact(last)}`,
        ['corners', 'faces'],
        found,
      );
    },
  );
  return element;
}
