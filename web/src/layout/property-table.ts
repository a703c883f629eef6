import type { App } from '../app.js';
import { h } from '../dom.js';
import { minus, real } from '../format.js';
import { type Measurement, properties } from '../polylap.js';
import { known, type SideResults } from '../results.js';
import { operatorOf, sides, studied } from '../state.js';
import { t, told, word } from '../words.js';
import { button, newId } from './controls.js';

type Verdict = Measurement['verdict'];
type Finding = Pick<Measurement, 'verdict' | 'text' | 'vertices'>;

const signs: Record<Verdict, readonly [sign: string, word: string]> = {
  holds: ['✓', word('holds')],
  fails: ['✗', word('fails')],
  'not-measured': ['–', word('not measured')],
};

/** Each property of the table: claimed by the operator and measured on the surface; the reasons in a row that opens. */
export function propertyTable(app: App): HTMLElement {
  const rows = properties.map((property) => {
    const cells = { a: h('td', { 'data-of': 'a' }), b: h('td', { 'data-of': 'b' }) };
    const claims = {
      a: h('td', { class: 'claim', 'data-of': 'a' }),
      b: h('td', { class: 'claim', 'data-of': 'b' }),
    };
    const details = { a: h('div', { 'data-of': 'a' }), b: h('div', { 'data-of': 'b' }) };
    const reasons = h(
      'tr',
      { class: 'reasons', id: newId('reasons'), hidden: true },
      h('td', { colspan: 5 }, h('p', {}, t(property.meaning)), details.a, details.b),
    );
    const opener = button(t(property.label), () => open(reasons.hidden === true), {
      class: 'opener',
      'aria-expanded': 'false',
      'aria-controls': reasons.id,
    });
    const open = (opened: boolean) => {
      reasons.hidden = !opened;
      opener.setAttribute('aria-expanded', String(opened));
    };
    const row = h(
      'tr',
      { 'data-property': property.id },
      h('th', { scope: 'row' }, opener),
      claims.a,
      cells.a,
      claims.b,
      cells.b,
    );
    return { property, claims, cells, details, row, reasons, open };
  });
  const all = button(
    t('All reasons'),
    () => {
      const open = rows.some(({ reasons }) => reasons.hidden === true);
      for (const row of rows) row.open(open);
      all.setAttribute('aria-expanded', String(open));
    },
    { class: 'quiet', 'aria-expanded': 'false', 'data-action': 'all-reasons' },
  );
  const element = h(
    'section',
    {},
    h('div', { class: 'section-head' }, h('h2', {}, t('Claimed and measured')), all),
    h(
      'table',
      { class: 'readouts properties' },
      h('caption', { class: 'unseen' }, t('Properties, claimed and measured')),
      h('colgroup', {}, h('col'), ...sides.flatMap(() => [h('col'), h('col', { class: 'found' })])),
      h(
        'thead',
        {},
        h('tr', {}, h('td', {}), ...['A', 'B'].map((side) => h('th', { scope: 'colgroup', colspan: 2 }, side))),
        h(
          'tr',
          {},
          h('td', {}),
          ...sides.flatMap(() => [t('claim'), t('here')].map((what) => h('th', { scope: 'col' }, what))),
        ),
      ),
      h('tbody', {}, ...rows.flatMap(({ row, reasons }) => [row, reasons])),
    ),
    h(
      'p',
      { class: 'note' },
      t(
        'Claim: yes, planar (where faces are planar), triangles (on triangle meshes), some (with the initial parameters, not with all) or no. Here, as measured: ✓ holds, ✗ fails, – not measured.',
      ),
    ),
  );
  for (const side of sides) {
    const show = () => {
      const operator = operatorOf(app.state.get().sides[side]);
      const results = app.results.get()[side];
      for (const { property, claims, cells, details } of rows) {
        const { where, why } = operator.claims[property.id];
        const finding = findingOf(results, property.id);
        const [sign, english] = signs[finding.verdict];
        const said = t(english);
        const place = placeName(finding.vertices);
        const broken = where === 'yes' && finding.verdict === 'fails';
        claims[side].textContent = t(where);
        cells[side].replaceChildren(
          finding.vertices.length > 0
            ? button(sign, () => app.show({ side, vertices: finding.vertices }), {
                class: `verdict ${finding.verdict}`,
                'data-verdict': finding.verdict,
                'aria-label': t('{property} {verdict} on {side}: show {place}', {
                  property: t(property.label),
                  verdict: said,
                  side: side.toUpperCase(),
                  place,
                }),
                title: t('Show {place}', { place }),
              })
            : h(
                'span',
                { class: `verdict ${finding.verdict}`, 'data-verdict': finding.verdict },
                h('span', { 'aria-hidden': 'true' }, sign),
                h('span', { class: 'unseen' }, said),
              ),
        );
        details[side].replaceChildren(
          h('p', {}, h('b', {}, side.toUpperCase()), t(' claims {where}: {why}.', { where: t(where), why: t(why) })),
          h(
            'p',
            { class: broken ? 'negative' : '' },
            `${said.charAt(0).toUpperCase()}${said.slice(1)}${broken ? t(', against the claim') : ''}${finding.text ? `: ${finding.text}` : ''}. `,
            finding.vertices.length > 0
              ? button(t('Show'), () => app.show({ side, vertices: finding.vertices }), {
                  class: 'place',
                  'aria-label': t('Show {place} on {side}', { place, side: side.toUpperCase() }),
                })
              : null,
          ),
        );
      }
    };
    app.state.watch((state) => [state.sides[side].operator], show);
    app.results.watch((results) => [results[side].check, results[side].study], show);
  }
  return element;
}

const unknown: Finding = { verdict: 'not-measured', text: '', vertices: [] };

/** What was measured of a property; of convergence, what the study found. */
function findingOf({ check, study }: SideResults, property: string): Finding {
  const measured = known(check)?.measurements.find((measurement) => measurement.property === property);
  if (property !== studied) return measured ? { ...measured, text: minus(told(measured.text)) } : unknown;
  const studies = known(study);
  if (!studies) return { ...unknown, text: t('see the study below') };
  const text = studies
    .map(({ family, order }) => t('order {order} on {family}', { order: real(order, 2), family: t(family) }))
    .join('; ');
  return { verdict: studies.every(({ converges }) => converges) ? 'holds' : 'fails', text, vertices: [] };
}

function placeName(vertices: readonly number[]): string {
  const [first, second] = vertices;
  if (second === undefined) return t('vertex {vertex}', { vertex: first ?? '' });
  return t(vertices.length === 2 ? word('vertices {first} and {second}') : word('vertices {first}, {second} …'), {
    first: first ?? '',
    second,
  });
}
