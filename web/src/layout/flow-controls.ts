import type { App } from '../app.js';
import { h } from '../dom.js';
import type { Flow, Side } from '../polylap.js';
import { verdict } from '../stability.js';
import { type State, sides } from '../state.js';
import { t, told, word } from '../words.js';
import { menu } from './controls.js';

const flows: readonly Flow[] = ['implicit', 'conformalised', 'explicit'];
const names: Readonly<Record<Flow, string>> = {
  implicit: word('implicit'),
  conformalised: word('conformalised'),
  explicit: word('explicit'),
};

const i = (text: string) => h('i', {}, text);
const equations: Readonly<Record<Flow, () => (Node | string)[]>> = {
  implicit: () => ['(', i('M'), ' + ', i('t S'), ') ', i('x'), '′ = ', i('M x')],
  conformalised: () => ['(', i('M'), ' + ', i('t S'), h('sub', {}, '0'), ') ', i('x'), '′ = ', i('M x')],
  explicit: () => [i('x'), '′ = ', i('x'), ' − ', i('t M'), h('sup', {}, '−1'), i(' S x')],
};
const hints: Readonly<Record<Flow, string>> = {
  implicit: word('Stable for every t.'),
  conformalised: word('S of the loaded mesh, M of the moved one; scaled to the loaded area. No neck pinches off.'),
  explicit: word('Unstable beyond a limit, which is shown.'),
};

/** Which flow each side takes, and what it solves. */
export function flowTable(app: App): HTMLElement {
  const column = (side: Side) => {
    const choice = menu(
      t('Flow of {side}', { side: side.toUpperCase() }),
      flows.map((flow) => [flow, t(names[flow])] as const),
      (flow) => app.smoothing.set({ flow: { ...app.state.get().smooth.flow, [side]: flow as Flow } }),
      { 'data-field': `flow-${side}` },
    );
    const equation = h('span', { class: 'equation' });
    app.state.watch(
      (state) => [state.smooth.flow[side]],
      (flow) => {
        choice.value = flow;
        choice.title = t(hints[flow]);
        equation.replaceChildren(...equations[flow]());
      },
    );
    return { choice, equation };
  };
  const [a, b] = [column('a'), column('b')];
  const head = (text: string) => h('th', { scope: 'col' }, text);
  return h(
    'table',
    { class: 'flows' },
    h('caption', { class: 'unseen' }, t('Flows')),
    h('thead', {}, h('tr', {}, head('A'), head('B'))),
    h(
      'tbody',
      {},
      h('tr', {}, h('td', {}, a.choice), h('td', {}, b.choice)),
      h('tr', {}, h('td', {}, a.equation), h('td', {}, b.equation)),
    ),
  );
}

/** Of each explicit side: how far a step may go, and what this one does. */
export function stabilityNotes(app: App): HTMLElement {
  const notes = sides.map((side) => {
    const note = h('p', { class: 'stability', 'data-stability': side, hidden: true });
    const show = () => {
      const { smooth } = app.state.get();
      const { mesh, [side]: results } = app.results.get();
      note.hidden = smooth.flow[side] !== 'explicit';
      if (note.hidden || !mesh) return;
      const { stability } = results;
      const letter = h('b', {}, side.toUpperCase());
      const known = stability !== null && typeof stability !== 'string';
      const said = known ? verdict(stability, smooth.timeH2, mesh.meanSquaredEdge) : null;
      note.classList.toggle('negative', said?.unstable ?? false);
      if (!said) {
        note.replaceChildren(letter, ` ${stability ?? 'μmax …'}`);
        return;
      }
      const { unstable, compared, roughest, effect } = said;
      note.replaceChildren(
        letter,
        ...(unstable ? [' ', h('strong', {}, t('unstable'))] : []),
        `${unstable ? ': ' : ' '}${compared}. `,
        i('μ'),
        h('sub', {}, 'max'),
        ` = ${roughest}/h²: ${effect}`,
      );
    };
    app.state.watch((state) => [state.smooth], show);
    app.results.watch((results) => [results.mesh, results[side].stability], show);
    return note;
  });
  return h('div', { class: 'stabilities' }, ...notes);
}

interface Keep {
  field: 'keepVolume' | 'fixBoundary';
  text: string;
  /** Why it cannot be had, or empty. */
  without: (results: ReturnType<App['results']['get']>) => string;
}

const keeps: readonly Keep[] = [
  {
    field: 'keepVolume',
    text: word('Keep the volume'),
    without: ({ mesh, a }) =>
      mesh && mesh.boundary.length > 0
        ? t('the surface is open')
        : a.shape?.volume === null
          ? told(a.shape.noVolume)
          : '',
  },
  {
    field: 'fixBoundary',
    text: word('Fix the boundary'),
    without: ({ mesh }) => (mesh && mesh.boundary.length === 0 ? t('the surface is closed') : ''),
  },
];

/** What steps leave as it is. What the mesh does not have cannot be chosen, and why is said. */
export function keepChecks(app: App): HTMLElement[] {
  return keeps.map(({ field, text, without }) => {
    const box = h('input', {
      type: 'checkbox',
      'data-field': field,
      onchange: () => app.smoothing.set({ [field]: box.checked } as Partial<State['smooth']>),
    });
    const reason = h('span', { class: 'reason' });
    const show = () => {
      const why = without(app.results.get());
      box.disabled = why !== '';
      box.checked = why === '' && app.state.get().smooth[field];
      reason.textContent = why;
      reason.title = why;
    };
    app.state.watch((state) => [state.smooth[field]], show);
    app.results.watch((results) => [results.mesh, results.a.shape], show);
    return h('label', { class: 'check' }, box, t(text), reason);
  });
}
