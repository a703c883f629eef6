import type { App } from '../app.js';
import { h } from '../dom.js';
import { stepsOf } from '../moves.js';
import { lines } from '../plots/draw.js';
import { figure } from '../plots/figure.js';
import type { Shape, Side } from '../polylap.js';
import { sides } from '../state.js';
import { t, word } from '../words.js';

const ofShape = (pick: (shape: Shape) => number | null) => (app: App, step: number, side: Side) => {
  const marks = app.smoothing.marks(step);
  return marks ? pick(marks[side]) : null;
};

/** What is known of a side after a step; null where nothing is. */
const measures: readonly {
  name: string;
  title: string;
  of: (app: App, step: number, side: Side) => number | null;
}[] = [
  { name: 'non-planarity', title: word('Mean non-planarity'), of: ofShape(({ meanNonPlanarity }) => meanNonPlanarity) },
  { name: 'area', title: word('Area'), of: ofShape(({ area }) => area) },
  { name: 'volume', title: word('Volume'), of: ofShape(({ volume }) => volume) },
  {
    name: 'energy',
    title: word('Dirichlet energy of the surface'),
    of: (app, step, side) => app.smoothing.trail.energy(step, side),
  },
];

/** How the surfaces change over the steps: A solid, B dashed. */
export function smoothPlots(app: App): HTMLElement {
  const plots = measures.map(({ title, name }) => figure(t(title), name));
  const element = h(
    'section',
    { class: 'plots', hidden: true },
    h('h2', {}, t('Over the steps')),
    h('p', { class: 'note' }, t('A solid, B dashed.')),
    ...plots.map((plot) => plot.element),
  );
  const show = () => {
    const { moves, step } = app.state.get();
    const steps = stepsOf(moves);
    element.hidden = steps === 0;
    if (steps === 0) return;
    measures.forEach(({ title, of }, m) => {
      const rows = Array.from({ length: steps + 1 }, (_, k): (number | null)[] => [
        k,
        of(app, k, 'a'),
        of(app, k, 'b'),
      ]);
      const series = sides.map((side, s) => ({
        name: side,
        dashed: side === 'b',
        points: rows.flatMap((row): [number, number][] => {
          const [k, value] = [row[0], row[s + 1]];
          return typeof k === 'number' && typeof value === 'number' ? [[k, value]] : [];
        }),
      }));
      const some = series.some(({ points }) => points.length > 0);
      plots[m]?.show(
        some ? lines(series, step) : null,
        t('{measure} of A and B over {steps} steps', { measure: t(title), steps }),
        [word('step'), 'A', 'B'],
        rows,
      );
    });
  };
  app.state.watch((state) => [state.moves, state.step, state.task], show);
  app.results.watch(({ a, b }) => [a.shape, b.shape, a.energy, b.energy], show);
  return element;
}
