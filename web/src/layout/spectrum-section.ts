import type { App } from '../app.js';
import { h } from '../dom.js';
import { dots } from '../plots/draw.js';
import { figure } from '../plots/figure.js';
import { known } from '../results.js';
import { sides } from '../state.js';
import { t, word } from '../words.js';
import { askedSection } from './asked-section.js';

/** The lowest eigenvalues of both operators on the mesh. */
export function spectrumSection(app: App): HTMLElement {
  const plot = figure(t('Lowest eigenvalues μ over their number, A full, B hollow'), 'spectrum');
  const show = () => {
    const results = app.results.get();
    const spectra = sides.map((side) => known(results[side].spectrum));
    const longest = Math.max(...spectra.map((spectrum) => spectrum?.length ?? 0));
    const rows = Array.from({ length: longest }, (_, k) => [k, ...spectra.map((spectrum) => spectrum?.[k] ?? null)]);
    const series = sides.map((side, s) => ({
      name: side,
      dashed: side === 'b',
      points: [...(spectra[s] ?? [])].map((value, k): [number, number] => [k, value]),
    }));
    plot.show(
      longest > 0 ? dots(series) : null,
      t('The {count} lowest eigenvalues of S x = μ M x, of A and B', { count: longest }),
      [word('mode'), 'A', 'B'],
      rows,
    );
  };
  return askedSection(app, {
    title: t('Spectrum'),
    note: [t('The lowest eigenvalues of '), h('i', {}, 'S x = μ M x'), t(', in 1 / length².')],
    label: t('Find eigenvalues'),
    action: 'spectrum',
    ask: () => app.answers.spectra(),
    found: ({ spectrum }) => spectrum,
    body: h('div', { class: 'plots' }, plot.element),
    show,
  });
}
