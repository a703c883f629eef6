import type { App } from '../app.js';
import { h } from '../dom.js';
import { real, weight } from '../format.js';
import { csv } from '../numbers-text.js';
import type { FaceReport, Side } from '../polylap.js';
import { known, type Results } from '../results.js';
import { save } from '../saving.js';
import { operatorOf, sides } from '../state.js';
import { t, told } from '../words.js';
import { button } from './controls.js';
import { faceDrawing } from './face-drawing.js';
import { faceField } from './number-walk.js';

type Faces = Readonly<Record<Side, FaceReport>>;

/** The selected face: what it is, how the operators cut it, and what it adds to their matrices. */
export function faceSection(app: App): HTMLElement {
  const body = h('div', { class: 'face' });
  const element = h('section', { class: 'face-section' }, faceField(app), body);
  const note = (text: string) => body.replaceChildren(h('p', { class: 'note' }, text));
  const show = () => {
    const { selectedFace } = app.state.get();
    const results = app.results.get();
    const faces = facesOf(results, selectedFace);
    const why = sides.flatMap((side) => {
      const { face } = results[side];
      return typeof face === 'string' ? [`${side.toUpperCase()}: ${face}`] : [];
    });
    body.classList.toggle('awaited', selectedFace !== null && !faces && why.length === 0);
    if (selectedFace === null) note(t('Click inside a face, or walk with { and }, to look into it.'));
    else if (faces) body.replaceChildren(...report(app, selectedFace, faces));
    else if (why.length > 0) note(why.join(' '));
  };
  app.state.watch((state) => [state.selectedFace], show);
  app.results.watch(({ a, b }) => [a.face, b.face], show);
  return element;
}

function facesOf({ a, b }: Results, face: number | null): Faces | null {
  const [one, other] = [known(a.face), known(b.face)];
  return face !== null && one?.face === face && other?.face === face ? { a: one, b: other } : null;
}

function report(app: App, face: number, faces: Faces): HTMLElement[] {
  return [
    h(
      'p',
      { 'data-face': face },
      t('Corners {list}', {
        list:
          [...faces.a.corners].slice(0, mostCorners).join(', ') + (faces.a.corners.length > mostCorners ? ', …' : ''),
      }),
    ),
    vectors(face, faces),
    h(
      'div',
      { class: 'stencils' },
      ...sides.map((side) =>
        h(
          'figure',
          {},
          faces[side].projected.length > 0 ? faceDrawing(faces[side]) : null,
          h('figcaption', {}, `${side.toUpperCase()}, ${cutting(faces[side])}`),
        ),
      ),
    ),
    ...sides.map((side) => matrix(side, faces[side], t(operatorOf(app.state.get().sides[side]).label))),
    h(
      'div',
      { class: 'buttons' },
      button('CSV', () => save({ name: `face-${face}.csv`, contents: new Blob([matrixCsv(faces)]) }), {
        class: 'quiet',
        'data-action': 'csv-face',
        'aria-label': t('Matrices of the face, CSV'),
      }),
    ),
  ];
}

const mostCorners = 24;
/** Of a vector's length, a component of that size is 0. */
const rounding = 1e-12;

/** How the operator sees the face, besides its outline. */
function cutting({ projected, triangles }: FaceReport): string {
  if (projected.length === 0) return t('without area');
  if (projected.length === 6) return t('a triangle');
  return triangles.length > 0 ? t('cut dashed') : t('not cut');
}

/** Vector area and normal, and what they come to. */
function vectors(face: number, faces: Faces): HTMLElement {
  const row = (id: string, head: HTMLElement, of: (report: FaceReport) => number, length = of) =>
    h(
      'tr',
      {},
      head,
      ...sides.map((side) => {
        const value = of(faces[side]);
        const seen = Math.abs(value) <= rounding * length(faces[side]) ? 0 : value;
        return h('td', { 'data-readout': id, 'data-of': side, 'data-value': value }, real(seen));
      }),
    );
  const named = (...name: (Node | string)[]) => h('th', { scope: 'row' }, ...name);
  const components = (letter: 'a' | 'n', of: (report: FaceReport) => readonly number[]) =>
    ['x', 'y', 'z'].map((axis, c) =>
      row(
        `${letter}-${axis}`,
        named(h('i', {}, letter), h('sub', {}, axis)),
        (report) => of(report)[c] ?? 0,
        (report) => Math.hypot(...of(report)),
      ),
    );
  return h(
    'table',
    { class: 'readouts' },
    h('caption', { class: 'unseen' }, t('Vector area and normal of face {face}', { face })),
    h('thead', {}, h('tr', {}, h('td', {}), ...sides.map((side) => h('th', { scope: 'col' }, side.toUpperCase())))),
    h(
      'tbody',
      {},
      ...components('a', ({ vectorArea }) => vectorArea),
      row('face-area', named(`${t('area')} |`, h('i', {}, 'a'), '|'), ({ vectorArea }) => Math.hypot(...vectorArea)),
      ...components('n', ({ normal }) => normal),
      row('face-non-planarity', named(t('non-planarity')), ({ nonPlanarity }) => nonPlanarity),
    ),
  );
}

/** What the face adds to S. Off the diagonal, what is above 0 is a negative weight. */
function matrix(side: Side, { corners, stiffness, noStiffness }: FaceReport, operator: string): HTMLElement {
  const title = h('h3', {}, h('i', {}, 'S'), h('sub', {}, 'f'), t(' of {side}', { side: side.toUpperCase() }));
  if (!stiffness)
    return h(
      'div',
      {},
      title,
      h('p', { class: 'note' }, t('{operator} has none here: {why}.', { operator, why: told(noStiffness) })),
    );
  const n = corners.length;
  const cell = (i: number, j: number) => {
    const value = stiffness[i * n + j] ?? 0;
    const size = Math.abs(stiffness[i * n + i] ?? 0);
    const seen = Math.abs(value) > 1e-10 * size ? value : 0;
    return h('td', { class: i !== j && seen > 0 ? 'negative' : '', 'data-value': value }, weight(seen));
  };
  const shown = [...corners].slice(0, mostCorners);
  const heads = (scope: string) => shown.map((vertex) => h('th', { scope }, String(vertex)));
  return h(
    'div',
    {},
    title,
    h(
      'div',
      {
        class: 'matrix',
        tabindex: 0,
        role: 'group',
        'aria-label': t('Matrix of the face on {side}', { side: side.toUpperCase() }),
      },
      h(
        'table',
        { class: 'readouts', 'data-matrix': side },
        h('thead', {}, h('tr', {}, h('td', {}), ...heads('col'))),
        h('tbody', {}, ...heads('row').map((head, i) => h('tr', {}, head, ...shown.map((_, j) => cell(i, j))))),
      ),
    ),
    n > mostCorners
      ? h(
          'p',
          { class: 'note' },
          t('The first {some} of {all} corners; all are in the CSV.', { some: mostCorners, all: n }),
        )
      : null,
  );
}

function matrixCsv({ a, b }: Faces): string {
  const n = a.corners.length;
  const rows = [...a.corners].flatMap((i, p) =>
    [...a.corners].map((j, q) => [i, j, a.stiffness?.[p * n + q], b.stiffness?.[p * n + q]]),
  );
  return csv(['i', 'j', 'S_f_A', 'S_f_B'], rows);
}
