import type { App } from '../app.js';
import { h, put } from '../dom.js';
import { count, real } from '../format.js';
import { stepsOf } from '../moves.js';
import type { SmoothingSolve } from '../polylap.js';
import { sides } from '../state.js';
import { button, numberField, slider } from './controls.js';
import { flowTable, keepChecks, stabilityNotes } from './flow-controls.js';
import { smoothPlots } from './smooth-plots.js';
import { sideTable } from './table.js';

const [shortest, longest] = [1e-3, 1e2];

/** Play, Step, Reset: in the panel, and above the meshes where the panel is out of sight. */
export function transport(app: App): HTMLElement {
  const play = button('Play', () => app.smoothing.toggle(), {
    class: 'primary',
    'data-action': 'play',
  });
  const step = button('Step', () => void app.smoothing.step(), { 'data-action': 'step' });
  const reset = button('Reset', () => void app.smoothing.reset(), { 'data-action': 'reset' });
  app.results.watch(
    (results) => [results.playing],
    (playing) => {
      play.textContent = playing ? 'Pause' : 'Play';
      step.disabled = playing;
    },
  );
  return h('div', { class: 'buttons transport' }, play, step, reset);
}

/** Back and forth over the steps taken. */
function scrubber(app: App): HTMLElement {
  const track = slider({
    label: 'Step shown',
    min: 0,
    max: 1,
    step: 1,
    onInput: (step) => app.smoothing.scrub(step),
  });
  track.element.dataset.field = 'step';
  const place = h('output', { class: 'unit', 'data-readout': 'step-of' });
  app.state.watch(
    (state) => [state.step, state.moves],
    (step, moves) => {
      const steps = stepsOf(moves);
      track.element.max = String(Math.max(1, steps));
      track.element.disabled = steps === 0;
      track.set(step, `${step} of ${steps}`);
      put(place, `${count(step)} / ${count(steps)}`, step);
    },
  );
  return h(
    'div',
    { class: 'parameter' },
    h('span', { class: 'parameter-name', 'aria-hidden': 'true' }, 'step'),
    track.element,
    place,
  );
}

function solverText({ solver, iterations }: SmoothingSolve): string {
  if (solver === 'conjugate-gradients') return `${count(iterations)} conjugate gradient steps`;
  if (solver === 'diagonal') return 'dividing by the mass';
  return solver === 'cholesky' ? 'a Cholesky factor' : 'an LU factor';
}

/** Smoothing on both sides in step. */
export function smoothPanel(app: App): HTMLElement {
  const setTime = (timeH2: number) => app.smoothing.set({ timeH2 });
  const track = slider({
    label: 'Time step, in mean squared edge lengths',
    min: Math.log10(shortest),
    max: Math.log10(longest),
    step: 0.05,
    onInput: (exponent) => setTime(Number((10 ** exponent).toPrecision(3))),
  });
  const field = numberField({
    label: 'Time step in mean squared edge lengths, value',
    min: 1e-9,
    max: 1e9,
    onChange: setTime,
    onRefuse: (why) => app.refuse(why),
  });
  field.element.dataset.field = 'time';
  const rebuild = h('input', {
    type: 'checkbox',
    'data-field': 'rebuild',
    onchange: () => app.smoothing.set({ rebuild: rebuild.checked }),
  });
  const ownRule = h('span', { class: 'reason' });
  const readouts = sideTable('Surfaces', [
    { id: 'step', name: 'step' },
    { id: 'mean-non-planarity', name: 'mean non-planarity' },
    { id: 'area', name: 'area' },
    { id: 'volume', name: 'volume' },
  ]);
  const whyNoVolume = h('p', { class: 'note' });
  const solvers = h('p', { class: 'note', 'data-value': 'solvers' });
  const element = h(
    'div',
    { class: 'panel-body' },
    h(
      'section',
      {},
      h('h2', {}, 'Smoothing'),
      flowTable(app),
      transport(app),
      scrubber(app),
      h(
        'div',
        { class: 'parameter' },
        h('span', { class: 'parameter-name', 'aria-hidden': 'true' }, h('i', {}, 't')),
        track.element,
        field.element,
        h('span', { class: 'unit' }, h('i', {}, 'h'), '²'),
      ),
      h('p', { class: 'note' }, h('i', {}, 'h'), '²: mean squared edge length of the loaded mesh'),
      stabilityNotes(app),
      h(
        'div',
        {},
        h('label', { class: 'check' }, rebuild, 'Rebuild the operator each step', ownRule),
        ...keepChecks(app),
      ),
      solvers,
    ),
    h('section', {}, h('h2', {}, 'Surfaces'), readouts.element, whyNoVolume),
    smoothPlots(app),
  );

  app.state.watch(
    (state) => [state.smooth],
    ({ timeH2, rebuild: each, flow }) => {
      track.set(Math.log10(timeH2), `${timeH2} h²`);
      field.set(timeH2);
      rebuild.checked = each;
      rebuild.disabled = sides.every((side) => flow[side] === 'conformalised');
      ownRule.textContent = rebuild.disabled ? 'the flow decides' : '';
    },
  );
  app.results.watch(
    ({ a, b }) => [a.solve, b.solve],
    (a, b) => {
      const solved = sides.flatMap((side) => {
        const solve = { a, b }[side];
        return solve ? [`${side.toUpperCase()} by ${solverText(solve)}`] : [];
      });
      solvers.textContent = solved.length > 0 ? `Solved ${solved.join(', ')}.` : '';
    },
  );
  for (const side of sides) {
    app.results.watch(
      (results) => [results[side].step, results[side].shape],
      (steps, shape) => {
        readouts.set('step', side, { text: count(steps), value: steps });
        if (!shape) return;
        readouts.set('mean-non-planarity', side, { text: real(shape.meanNonPlanarity), value: shape.meanNonPlanarity });
        readouts.set('area', side, { text: real(shape.area, 5), value: shape.area });
        readouts.set('volume', side, {
          text: shape.volume === null ? 'none' : real(shape.volume, 5),
          value: shape.volume,
        });
        whyNoVolume.textContent = shape.volume === null ? `No volume: ${shape.noVolume}` : '';
      },
    );
  }
  return element;
}
