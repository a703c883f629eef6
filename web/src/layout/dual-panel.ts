import type { App } from '../app.js';
import { h } from '../dom.js';
import { count, real, typed } from '../format.js';
import type { Dual, Geometry } from '../polylap.js';
import { known } from '../results.js';
import { operatorOf, type State, sides } from '../state.js';
import { t } from '../words.js';
import { button, numberField, slider } from './controls.js';
import { edgeSection } from './edge-section.js';
import { vertexField } from './number-walk.js';
import { sideTable } from './table.js';
import { vertexWeights } from './vertex-weights.js';

/** The slider's left end is 0, exactly orthogonal; then powers of ten. */
const [weakest, strongest] = [-2, 4];
const exactly = weakest - 0.1;

/** The orthogonal dual: how it fits, what is drawn of it, and the compromise where it does not fit. */
export function dualPanel(app: App): HTMLElement {
  const figures = sideTable(t('Orthogonal dual'), [
    { id: 'residual', name: t('residual') },
    { id: 'constraints', name: t('constraints') },
    { id: 'rank', name: t('rank') },
    { id: 'null-space', name: t('null space') },
    { id: 'shift', name: t('largest shift') },
    { id: 'shift-face', name: t('at face') },
  ]);
  const verdict = h('p', { class: 'verdict-text', 'data-readout': 'dual-verdict' });
  const again = button(t('Compute'), () => app.answers.updateBoth(), { 'data-action': 'dual-again' });
  const setMu = (mu: number) => app.setDual({ mu });
  const track = slider({
    label: t('μ of the compromise'),
    min: exactly,
    max: strongest,
    step: 0.1,
    onInput: (at) => setMu(at <= exactly + 0.05 ? 0 : Number((10 ** at).toPrecision(2))),
  });
  const field = numberField({
    label: t('μ of the compromise'),
    besideSlider: true,
    min: 0,
    max: 1e12,
    onChange: setMu,
    onRefuse: (why) => app.refuse(why),
  });
  field.element.dataset.field = 'mu';
  const layer = (id: keyof Omit<State['dual'], 'mu'>, swatch: string, text: string) => {
    const box = h('input', {
      type: 'checkbox',
      'data-field': `layer-${id}`,
      onchange: () => app.setDual({ [id]: box.checked }),
    });
    app.state.watch(
      (state) => [state.dual[id]],
      (shown) => {
        box.checked = shown;
      },
    );
    return h('label', { class: 'check' }, box, h('span', { class: `swatch ${swatch}`, 'aria-hidden': 'true' }), text);
  };
  const weights = h(
    'section',
    {},
    h('h2', {}, t('Vertex weights')),
    vertexField(app),
    vertexWeights(app),
    h(
      'p',
      { class: 'note' },
      t(
        'These operators let ω move where an edge is crossed: (|e|² + ωᵢ − ωⱼ) / 2|e| from vertex i. The dual drawn here is found without ω.',
      ),
    ),
  );
  app.state.watch(
    (state) => [state.sides],
    (choices) => {
      weights.hidden = !sides.some((side) => operatorOf(choices[side]).takesVertexWeights);
    },
  );
  const element = h(
    'div',
    { class: 'panel-body' },
    h(
      'section',
      {},
      h('h2', {}, t('Orthogonal dual')),
      h(
        'p',
        { class: 'note' },
        t(
          'A point for each face, so that the line between two neighbours is orthogonal to their edge; of all such points those nearest to the barycentres.',
        ),
      ),
      h(
        'p',
        { class: 'note' },
        t('The dual depends on the surface only, not on the operator: A and B differ where their surfaces do.'),
      ),
      figures.element,
      verdict,
      again,
    ),
    h(
      'section',
      {},
      h('h2', {}, t('Compromise')),
      h(
        'div',
        { class: 'parameter' },
        h('span', { class: 'parameter-name', 'aria-hidden': 'true' }, h('i', {}, 'μ')),
        track.element,
        field.element,
      ),
      h(
        'p',
        { class: 'note' },
        t(
          'μ = 0 is exact. Above, points may leave the right angle to stay near their barycentres: the more, the smaller μ is.',
        ),
      ),
    ),
    h(
      'section',
      {},
      h('h2', {}, t('Drawn')),
      layer('primal', 'primal', t('primal edges')),
      layer('edges', 'dual', t('dual edges and vertices')),
      layer('points', 'point', t('edge points, where dual edges cross')),
    ),
    edgeSection(app),
    weights,
  );

  app.state.watch(
    (state) => [state.dual.mu],
    (mu) => {
      track.set(mu === 0 ? exactly : Math.log10(mu), mu === 0 ? t('0, exactly orthogonal') : typed(mu));
      field.set(mu);
    },
  );
  app.results.watch(
    (results) => [results.a.dual, results.b.dual],
    (...both) => {
      sides.forEach((side, k) => {
        const dual = known(both[k] ?? null);
        const text = (id: string, value: number | undefined, write: (value: number) => string) =>
          figures.set(id, side, value === undefined ? { text: '–' } : { text: write(value), value });
        text('residual', dual?.residual, (value) => real(value, 3));
        text('constraints', dual?.constraints, count);
        text('rank', dual?.rank, count);
        text('null-space', dual?.nullSpace, count);
        text('shift', dual?.largestShift, (value) => real(value, 3));
        const face = dual?.worstFace ?? -1;
        const { mesh } = app.results.get();
        figures.set(
          'shift-face',
          side,
          mesh && face >= 0
            ? {
                text: count(face),
                label: t('face {face}', { face: count(face) }),
                value: face,
                act: () => app.show({ side, vertices: cornersOf(mesh.geometry, face) }),
              }
            : { text: '–' },
        );
      });
      verdict.textContent = verdicts(both);
      again.hidden = !both.some((dual) => typeof dual === 'string');
    },
  );
  return element;
}

/** Plain sentences on whether the duals can be used. */
function verdicts(both: readonly (Dual | string | null)[]): string {
  const texts = both.map((dual) => {
    if (dual === null) return '';
    if (typeof dual === 'string') return dual;
    if (dual.usable) return t('Every point is near its face: the dual is usable.');
    return t('The dual is not usable: a point lies {shift} face widths from its barycentre.', {
      shift: real(dual.largestShift, 2),
    });
  });
  const [a = '', b = ''] = texts;
  return a === b ? a : texts.map((text, k) => text && `${'AB'[k]}: ${text}`).join(' ');
}

const cornersOf = ({ offsets, corners }: Geometry, face: number) => [
  ...corners.subarray(offsets[face], offsets[face + 1]),
];
