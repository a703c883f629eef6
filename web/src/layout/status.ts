import type { App } from '../app.js';
import { colouring, Outside, outsideOf } from '../colouring.js';
import { h, put } from '../dom.js';
import { cleared, count, exact } from '../format.js';
import type { Side } from '../polylap.js';
import { known } from '../results.js';
import { sides } from '../state.js';
import { t } from '../words.js';
import { button } from './controls.js';
import { ramp } from './ramp.js';

/** The line at the bottom: what happened, what is under way, and the legend that both sides share. */
export function statusLine(app: App): HTMLElement {
  const notice = h('p', { class: 'notice', role: 'status', 'aria-live': 'polite' });
  const bar = h('progress', { max: 1, 'aria-label': t('Progress') });
  const label = h('span', { class: 'job' });
  const cancel = button(t('Cancel'), () => app.cancel(), { 'data-action': 'cancel' });
  const busy = h('div', { class: 'busy', hidden: true }, label, bar, cancel);
  app.results.watch(
    (results) => [results.notice],
    (text) => put(notice, text),
  );
  app.results.watch(
    (results) => [results.busy, results.playing],
    (job, playing) => {
      // While playing, steps that take a little longer are no news.
      busy.hidden = job === null || (playing && job.fraction === null);
      if (!job) return;
      put(label, job.label);
      if (job.fraction === null) bar.removeAttribute('value');
      else bar.value = job.fraction;
    },
  );
  return h('footer', { class: 'status' }, notice, busy, progressed(app), legend(app));
}

/** That the surfaces are smoothed ones, in the tasks that do not say so themselves, and the way back. */
function progressed(app: App): HTMLElement {
  const steps = h('span', { 'data-readout': 'steps' });
  const reset = button(t('Reset'), () => void app.smoothing.reset(), {
    class: 'quiet',
    'data-action': 'reset-quietly',
  });
  const element = h('div', { class: 'progressed' }, steps, ' · ', reset);
  const show = () => {
    const { a, b } = app.results.get();
    const step = Math.max(a.step, b.step);
    element.hidden = step === 0 || app.state.get().task === 'smooth';
    put(steps, t('step {step}', { step: count(step) }), step);
  };
  app.results.watch((results) => [results.a.step, results.b.step], show);
  app.state.watch((state) => [state.task], show);
  return element;
}

function legend(app: App): HTMLElement {
  const dashes = h('span', { class: 'legend-dashes', 'aria-hidden': 'true' });
  const negative = h('input', {
    type: 'checkbox',
    'data-field': 'negative-shown',
    onchange: () => {
      const { task, negativeShown } = app.state.get();
      app.state.set({ negativeShown: { ...negativeShown, [task]: negative.checked } });
    },
  });
  app.state.watch(
    (state) => [state.negativeShown[state.task]],
    (shown) => {
      negative.checked = shown;
    },
  );
  const low = h('output', { 'data-readout': 'range-min' });
  const high = h('output', { 'data-readout': 'range-max' });
  const strip = ramp();
  const hatch = (side: string, text: string) =>
    h('span', {}, h('span', { class: `hatch ${side}`, 'aria-hidden': 'true' }), text);
  const hatches = {
    [Outside.below]: hatch('below', t('below the pins')),
    [Outside.above]: hatch('above', t('above the pins')),
  };
  const outside = h(
    'span',
    { class: 'legend-outside', title: t('Where values leave the range of the pins') },
    hatches[Outside.below],
    hatches[Outside.above],
  );
  const values = h(
    'span',
    { class: 'legend-values', role: 'group', 'aria-label': t('Colours of A and B') },
    low,
    strip.element,
    high,
    outside,
  );
  const element = h(
    'div',
    { class: 'legend', 'aria-label': t('Legend'), role: 'group' },
    values,
    h('label', { class: 'legend-negative' }, negative, dashes, t('negative weight')),
  );
  const outsideAt = (side: Side) => {
    const own = known(app.results.get()[side].harmonic);
    return own ? outsideOf(own) : [];
  };
  const show = () => {
    const { task } = app.state.get();
    const coloured = colouring(app.state.get(), app.results.get());
    values.hidden = coloured === null;
    if (!coloured) return;
    const { range, map } = coloured;
    const size = Math.max(Math.abs(range.min), Math.abs(range.max));
    const single = range.single !== null;
    values.classList.toggle('single', single);
    strip.paint(map, single);
    high.hidden = single;
    const beyond = task === 'harmonic' ? sides.flatMap(outsideAt) : [];
    for (const where of [Outside.below, Outside.above])
      hatches[where].hidden = !beyond.some(([, there]) => there === where);
    outside.hidden = beyond.length === 0;
    if (range.single !== null) {
      put(low, t('{value} everywhere', { value: exact(range.single) }), range.single);
      return;
    }
    put(low, exact(cleared(range.min, size)), range.min);
    put(high, exact(cleared(range.max, size)), range.max);
  };
  app.results.watch(({ a, b }) => [a.harmonic, b.harmonic, a.check, b.check], show);
  app.state.watch((state) => [state.task, state.mode, state.colours], show);
  return element;
}
