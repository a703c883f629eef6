import type { App } from '../app.js';
import { h } from '../dom.js';
import { real, written } from '../format.js';
import type { ConvergenceStudy, Side } from '../polylap.js';
import { known } from '../results.js';
import { operatorOf, sides, studied } from '../state.js';
import { t, told } from '../words.js';
import { askedSection } from './asked-section.js';

/** Whether the two operators approach the smooth one on finer and finer meshes. */
export function convergenceSection(app: App): HTMLElement {
  const tables = h('div', { class: 'studies' });
  const show = () => {
    const { a, b } = app.results.get();
    const studies = { a: known(a.study) ?? [], b: known(b.study) ?? [] };
    const families = [...new Set(sides.flatMap((side) => studies[side].map(({ family }) => family)))];
    tables.replaceChildren(
      ...families.map((family) =>
        familyTable(app, family, (side) => studies[side].find((study) => study.family === family)),
      ),
    );
  };
  return askedSection(app, {
    title: t('Convergence'),
    note: [t('The error against the smooth operator on finer and finer meshes of the study’s own.')],
    label: t('Study convergence'),
    action: 'study',
    ask: () => app.answers.study(),
    found: ({ study }) => study,
    body: tables,
    show,
  });
}

function familyTable(app: App, family: string, studyOf: (side: Side) => ConvergenceStudy | undefined): HTMLElement {
  const studies = { a: studyOf('a'), b: studyOf('b') };
  const longest = (studies.a?.levels.length ?? 0) >= (studies.b?.levels.length ?? 0) ? studies.a : studies.b;
  const cells = (study: ConvergenceStudy | undefined, k: number) => {
    const level = study?.levels[k];
    if (!level) return [h('td', {}, '–'), h('td', {}, '')];
    return [
      h('td', { 'data-value': level.error }, real(level.error, 2)),
      h('td', { 'data-value': level.order }, Number.isNaN(level.order) ? '' : written(level.order.toFixed(2))),
    ];
  };
  const verdict = (side: Side) => {
    const study = studies[side];
    if (!study) return `${side.toUpperCase()}: –`;
    const { where } = operatorOf(app.state.get().sides[side]).claims[studied];
    const found = study.converges ? t('✓ converges') : t('✗ does not converge');
    const claimed = t('{side} claims {where}', { side: side.toUpperCase(), where: t(where) });
    return `${claimed}: ${found}${study.failure ? `; ${told(study.failure)}` : ''}`;
  };
  return h(
    'div',
    { class: 'study', 'data-family': family },
    h('h3', {}, t(family)),
    h('p', { class: 'note' }, t(longest?.problem ?? '')),
    h(
      'table',
      { class: 'readouts study-table' },
      h('caption', { class: 'unseen' }, t('Convergence, {family}', { family: t(family) })),
      h(
        'thead',
        {},
        h(
          'tr',
          {},
          h('th', { scope: 'col' }, h('i', {}, 'h')),
          ...['A', 'B'].flatMap((letter) => [
            h('th', { scope: 'col' }, t('{side} error', { side: letter })),
            h('th', { scope: 'col', 'aria-label': t('{side} order', { side: letter }) }, t('order')),
          ]),
        ),
      ),
      h(
        'tbody',
        {},
        ...(longest?.levels ?? []).map(({ h: size, vertices }, k) =>
          h(
            'tr',
            { title: t('{n} vertex|{n} vertices', { n: vertices }) },
            h('th', { scope: 'row' }, real(size, 2)),
            ...cells(studies.a, k),
            ...cells(studies.b, k),
          ),
        ),
      ),
    ),
    ...sides.map((side) => h('p', { class: 'study-verdict', 'data-of': side }, verdict(side))),
  );
}
