import type { App } from '../app.js';
import { h } from '../dom.js';
import { cleared, count, real } from '../format.js';
import { known } from '../results.js';
import { sides } from '../state.js';
import { t, word } from '../words.js';
import { button, menu } from './controls.js';
import { convergenceSection } from './convergence-section.js';
import { propertyTable } from './property-table.js';
import { spectrumSection } from './spectrum-section.js';
import { sideTable } from './table.js';

/** The properties of both operators on the mesh at hand: what they claim, what is measured. */
export function checkPanel(app: App): HTMLElement {
  const trouble = h('p', { class: 'note', 'data-readout': 'check-trouble' });
  const again = button(t('Measure'), () => app.answers.updateBoth(), { 'data-action': 'check-again' });
  app.results.watch(
    (results) => [results.a.check, results.b.check],
    (...both) => {
      const texts = both.map((check, k) => (typeof check === 'string' ? `${'AB'[k]}: ${check}` : ''));
      trouble.textContent = texts.filter(Boolean).join(' ');
      again.hidden = trouble.textContent === '';
    },
  );
  return h(
    'div',
    { class: 'panel-body' },
    propertyTable(app),
    h('section', {}, h('h2', {}, t('Numbers')), numbers(app), trouble, again),
    kernelModes(app),
    spectrumSection(app),
    convergenceSection(app),
  );
}

function numbers(app: App): HTMLElement {
  const table = sideTable(t('Numbers'), [
    { id: 'negative-ordered', name: t('negative weights, ordered') },
    { id: 'negative-pairs', name: t('negative weights, pairs') },
    { id: 'smallest-eigenvalue', name: t('smallest eigenvalue') },
    { id: 'largest-eigenvalue', name: t('largest eigenvalue') },
    { id: 'kernel', name: t('kernel dimension') },
    { id: 'components', name: t('parts of the mesh') },
    { id: 'condition', name: t('condition number') },
    { id: 'smallest-mass', name: t('smallest mass') },
    { id: 'smallest-mass-vertex', name: t('at vertex') },
  ]);
  for (const side of sides) {
    app.results.watch(
      (results) => [results[side].check],
      (answer) => {
        const check = known(answer);
        const put = (id: string, value: number | undefined, write: (value: number) => string) =>
          table.set(id, side, value === undefined ? { text: '–' } : { text: write(value), value });
        put('negative-ordered', check?.negativeOrdered, count);
        put('negative-pairs', check?.negativePairs, count);
        put('smallest-eigenvalue', check?.smallestEigenvalue, (value) =>
          real(cleared(value, check?.largestEigenvalue ?? 0), 3),
        );
        put('largest-eigenvalue', check?.largestEigenvalue, (value) => real(value, 4));
        put('kernel', check?.kernelDimension, (value) =>
          check?.kernelComplete ? count(value) : t('at least {value}', { value: count(value) }),
        );
        put('components', check?.components, count);
        put('condition', check?.condition, (value) => real(value, 3));
        put('smallest-mass', check?.smallestMass, (value) => real(value, 3));
        const vertex = check?.smallestMassVertex ?? -1;
        table.set(
          'smallest-mass-vertex',
          side,
          vertex < 0
            ? { text: '–' }
            : {
                text: count(vertex),
                value: vertex,
                label: t('vertex {vertex}', { vertex: count(vertex) }),
                act: () => app.show({ side, vertices: [vertex] }),
              },
        );
      },
    );
  }
  return table.element;
}

/** Functions that the operators take for constant: one a side may colour its surface. */
function kernelModes(app: App): HTMLElement {
  const rows = sides.map((side) => {
    const letter = side.toUpperCase();
    const choose = menu(t('Kernel mode of {side}', { side: letter }), [], (value) =>
      app.setMode(side, value === '' ? null : Number(value)),
    );
    app.results.watch(
      (results) => [results[side].check],
      (answer) => {
        const modes = known(answer)?.kernelModes ?? [];
        choose.replaceChildren(
          h('option', { value: '' }, modes.length === 0 ? t('none') : t('none shown')),
          ...modes.map((mode, k) =>
            h(
              'option',
              { value: k },
              t(isConstant(mode) ? word('{some} of {all}, constant') : word('{some} of {all}'), {
                some: k + 1,
                all: modes.length,
              }),
            ),
          ),
        );
        choose.disabled = modes.length === 0;
        if ((app.state.get().mode[side] ?? -1) >= modes.length) app.setMode(side, null);
        choose.value = String(app.state.get().mode[side] ?? '');
      },
    );
    app.state.watch(
      (state) => [state.mode[side]],
      (mode) => {
        choose.value = String(mode ?? '');
      },
    );
    return h(
      'div',
      { class: 'line' },
      h('span', { class: 'line-name' }, t('mode of {side}', { side: letter })),
      choose,
    );
  });
  return h(
    'section',
    {},
    h('h2', {}, t('Kernel')),
    h('p', { class: 'note' }, t('Constants and nothing else should be in it. Choose a mode to see it on the mesh.')),
    ...rows,
  );
}

/** But for rounding. */
function isConstant(mode: Float64Array): boolean {
  let [low, high] = [Infinity, -Infinity];
  for (const value of mode) {
    low = Math.min(low, value);
    high = Math.max(high, value);
  }
  return high - low < 1e-6 * Math.max(Math.abs(low), Math.abs(high));
}
