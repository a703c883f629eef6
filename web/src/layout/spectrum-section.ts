import type { App } from '../app.js';
import { h } from '../dom.js';
import { dots } from '../plots/draw.js';
import { figure } from '../plots/figure.js';
import { known } from '../results.js';
import { sides } from '../state.js';
import { button } from './controls.js';

/** The lowest eigenvalues of both operators on the mesh: for the asking, since they can take a while. */
export function spectrumSection(app: App): HTMLElement {
  const ask = button('Find eigenvalues', () => app.answers.spectra(), { 'data-action': 'spectrum' });
  const trouble = h('p', { class: 'note', 'data-readout': 'spectrum-trouble' });
  const plot = figure('Lowest eigenvalues μ over their number, A full, B hollow', 'spectrum');
  const show = () => {
    const results = app.results.get();
    const spectra = sides.map((side) => known(results[side].spectrum));
    trouble.textContent = sides
      .flatMap((side) => {
        const { spectrum } = results[side];
        return typeof spectrum === 'string' ? [`${side.toUpperCase()}: ${spectrum}`] : [];
      })
      .join(' ');
    const longest = Math.max(...spectra.map((spectrum) => spectrum?.length ?? 0));
    const rows = Array.from({ length: longest }, (_, k) => [k, ...spectra.map((spectrum) => spectrum?.[k] ?? null)]);
    const series = sides.map((side, s) => ({
      name: side,
      dashed: side === 'b',
      points: [...(spectra[s] ?? [])].map((value, k): [number, number] => [k, value]),
    }));
    plot.show(
      longest > 0 ? dots(series) : null,
      `The ${longest} lowest eigenvalues of S x = μ M x, of A and B`,
      ['mode', 'A', 'B'],
      rows,
    );
  };
  app.results.watch(({ a, b }) => [a.spectrum, b.spectrum], show);
  app.results.watch(
    (results) => [results.busy],
    (busy) => {
      ask.disabled = busy !== null;
    },
  );
  return h(
    'section',
    { class: 'plots' },
    h('h2', {}, 'Spectrum'),
    h('p', { class: 'note' }, 'The lowest eigenvalues of ', h('i', {}, 'S x = μ M x'), ', in 1 / length².'),
    h('div', { class: 'buttons' }, ask),
    trouble,
    plot.element,
  );
}
