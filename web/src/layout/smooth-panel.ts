import type { App } from '../app.js';
import { h, put } from '../dom.js';
import { count, real, typed } from '../format.js';
import { stepsOf } from '../moves.js';
import type { SmoothingSolve } from '../polylap.js';
import { sides } from '../state.js';
import { t, told } from '../words.js';
import { button, numberField, slider } from './controls.js';
import { flowTable, keepChecks, stabilityNotes } from './flow-controls.js';
import { smoothPlots } from './smooth-plots.js';
import { sideTable } from './table.js';

const [shortest, longest] = [1e-3, 1e2];

/** Play, Step, Reset: in the panel, and above the meshes where the panel is out of sight. */
export function transport(app: App): HTMLElement {
  const play = button(t('Play'), () => app.smoothing.toggle(), {
    class: 'primary',
    'data-action': 'play',
  });
  const step = button(t('Step'), () => void app.smoothing.step(), { 'data-action': 'step' });
  const reset = button(t('Reset'), () => void app.smoothing.reset(), { 'data-action': 'reset' });
  app.results.watch(
    (results) => [results.playing],
    (playing) => {
      play.textContent = playing ? t('Pause') : t('Play');
      step.disabled = playing;
    },
  );
  return h('div', { class: 'buttons transport' }, play, step, reset);
}

/** Back and forth over the steps taken. */
function scrubber(app: App): HTMLElement {
  const track = slider({
    label: t('Step shown'),
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
      track.set(step, t('{some} of {all}', { some: step, all: steps }));
      put(place, `${count(step)} / ${count(steps)}`, step);
    },
  );
  return h(
    'div',
    { class: 'parameter' },
    h('span', { class: 'parameter-name', 'aria-hidden': 'true' }, t('step')),
    track.element,
    place,
  );
}

function solverText({ solver, iterations }: SmoothingSolve): string {
  if (solver === 'conjugate-gradients') return t('{steps} conjugate gradient steps', { steps: count(iterations) });
  if (solver === 'diagonal') return t('dividing by the mass');
  return solver === 'cholesky' ? t('a Cholesky factor') : t('an LU factor');
}

/** Smoothing on both sides in step. */
export function smoothPanel(app: App): HTMLElement {
  const setTime = (timeH2: number) => app.smoothing.set({ timeH2 });
  const track = slider({
    label: t('Time step, in mean squared edge lengths'),
    min: Math.log10(shortest),
    max: Math.log10(longest),
    step: 0.05,
    onInput: (exponent) => setTime(Number((10 ** exponent).toPrecision(3))),
  });
  const field = numberField({
    label: t('Time step in mean squared edge lengths'),
    besideSlider: true,
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
  const readouts = sideTable(t('Surfaces'), [
    { id: 'step', name: t('step') },
    { id: 'mean-non-planarity', name: t('mean non-planarity') },
    { id: 'area', name: t('area') },
    { id: 'volume', name: t('volume') },
  ]);
  const whyNoVolume = h('p', { class: 'note' });
  const solvers = h('p', { class: 'note', 'data-value': 'solvers' });
  const element = h(
    'div',
    { class: 'panel-body' },
    h(
      'section',
      {},
      h('h2', {}, t('Smoothing')),
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
      h('p', { class: 'note' }, h('i', {}, 'h'), `²: ${t('mean squared edge length of the loaded mesh')}`),
      stabilityNotes(app),
      h(
        'div',
        {},
        h('label', { class: 'check' }, rebuild, t('Rebuild the operator each step'), ownRule),
        ...keepChecks(app),
      ),
      solvers,
    ),
    h('section', {}, h('h2', {}, t('Surfaces')), readouts.element, whyNoVolume),
    smoothPlots(app),
  );

  app.state.watch(
    (state) => [state.smooth],
    ({ timeH2, rebuild: each, flow }) => {
      track.set(Math.log10(timeH2), `${typed(timeH2)} h²`);
      field.set(timeH2);
      rebuild.checked = each;
      rebuild.disabled = sides.every((side) => flow[side] === 'conformalised');
      ownRule.textContent = rebuild.disabled ? t('the flow decides') : '';
    },
  );
  app.results.watch(
    ({ a, b }) => [a.solve, b.solve],
    (a, b) => {
      const solved = sides.flatMap((side) => {
        const solve = { a, b }[side];
        return solve ? [t('{side} by {solver}', { side: side.toUpperCase(), solver: solverText(solve) })] : [];
      });
      solvers.textContent = solved.length > 0 ? t('Solved {list}.', { list: solved.join(', ') }) : '';
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
          text: shape.volume === null ? t('none') : real(shape.volume, 5),
          value: shape.volume,
        });
        whyNoVolume.textContent = shape.volume === null ? t('No volume: {why}', { why: told(shape.noVolume) }) : '';
      },
    );
  }
  return element;
}
