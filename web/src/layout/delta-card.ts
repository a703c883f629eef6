import type { App } from '../app.js';
import { type Difference, isDifferent } from '../difference.js';
import { h, put } from '../dom.js';
import { exact, real } from '../format.js';
import { onDrag } from '../scene/drag.js';
import { gains, type State } from '../state.js';
import { t } from '../words.js';
import { button, slider } from './controls.js';
import { ramp } from './ramp.js';

/** The third view: how far B is from A, amplified; or A and B in one view, with a line between them to drag. */
export function deltaCard(app: App): { element: HTMLElement; view: HTMLElement } {
  const set = (patch: Partial<State['delta']>) => app.state.set({ delta: { ...app.state.get().delta, ...patch } });
  const loud = h('output', { class: 'loud', 'aria-label': t('Largest difference'), 'data-readout': 'delta-max' }, '–');
  const caption = h('span', { title: t('h: the mean edge length of the loaded mesh') });
  const rms = h('span', { 'data-readout': 'delta-rms' });
  const where = button('', () => void app.select(app.results.get().difference?.vertex ?? null), {
    class: 'quiet',
    'data-action': 'delta-vertex',
  });
  const view = h('div', {
    class: 'view',
    tabindex: 0,
    role: 'application',
    'aria-roledescription': t('3D view'),
    'data-view': 'delta',
  });
  const divider = h('div', { class: 'divider', 'aria-hidden': 'true' });
  view.append(divider);
  let before: number | null = null;
  onDrag(divider, {
    begin: () => {
      before = app.state.get().delta.swipe;
    },
    move: (x) => {
      const { left, width } = view.getBoundingClientRect();
      set({ swipe: Math.min(1, Math.max(0, (x - left) / width)) });
    },
    end: () => {},
    cancel: () => set({ swipe: before }),
  });
  const gainButtons = gains.map((gain) =>
    button(`× ${gain}`, () => set({ gain, swipe: null }), { 'aria-label': t('Difference times {gain}', { gain }) }),
  );
  const swipeButton = button(t('Swipe'), () => set({ swipe: app.state.get().delta.swipe ?? 0.5 }), {
    'data-action': 'swipe',
  });
  const track = slider({
    label: t('Share of the view that shows A'),
    min: 0,
    max: 1,
    step: 0.005,
    onInput: (swipe) => set({ swipe }),
  });
  const swipeRow = h(
    'div',
    { class: 'parameter swipe' },
    h('span', { 'aria-hidden': 'true' }, 'A'),
    track.element,
    h('span', { 'aria-hidden': 'true' }, 'B'),
  );
  const strip = ramp();
  const low = h('output', { 'data-readout': 'delta-low' });
  const high = h('output', { 'data-readout': 'delta-high' });
  const scale = h('div', { class: 'parameter scale' }, low, strip.element, high);
  const same = h('p', { class: 'view-caption' });
  const title = h('span', { class: 'card-title' });
  const figures = h(
    'div',
    { class: 'count' },
    loud,
    h(
      'p',
      { class: 'count-text' },
      h('span', { class: 'count-name' }, caption, where),
      h('span', { class: 'count-share' }, rms),
    ),
  );
  const element = h(
    'div',
    { class: 'card', role: 'group', 'data-side': 'delta', 'aria-label': t('Difference of A and B') },
    h(
      'header',
      { class: 'card-head' },
      h('span', { class: 'badge', 'aria-hidden': 'true' }, 'Δ'),
      title,
      h('div', { class: 'segments', role: 'group', 'aria-label': t('Third view') }, ...gainButtons, swipeButton),
    ),
    figures,
    view,
    same,
    h('footer', { class: 'card-foot' }, scale, swipeRow),
  );

  app.state.watch(
    (state) => [state.delta],
    ({ gain, swipe, open }) => {
      gains.forEach((each, k) => {
        gainButtons[k]?.setAttribute('aria-pressed', String(swipe === null && each === gain));
      });
      swipeButton.setAttribute('aria-pressed', String(swipe !== null));
      swipeRow.hidden = swipe === null;
      scale.hidden = swipe !== null;
      // Of the difference, which is not what is seen; its place stays.
      figures.style.visibility = swipe === null ? '' : 'hidden';
      title.textContent = swipe === null ? 'B − A' : 'A | B';
      divider.hidden = swipe === null;
      divider.style.left = `${100 * (swipe ?? 0)}%`;
      if (swipe !== null) track.set(swipe, `${Math.round(100 * swipe)} %`);
      view.setAttribute(
        'aria-label',
        swipe === null
          ? t('Difference of A and B, {gain} times', { gain })
          : t('A on the left, B on the right of the same view'),
      );
      element.dataset.open = String(open);
    },
  );
  app.results.watch(
    (results) => [results.difference],
    (difference) => show(difference),
  );

  function show(difference: Difference | null): void {
    const values = difference?.of === 'values';
    const unit = values ? '' : ' h';
    const there = difference !== null && isDifferent(difference, 1);
    put(
      loud,
      difference ? (there ? real(difference.max, 3) : '0') : '–',
      difference ? (there ? difference.max : 0) : null,
    );
    caption.textContent = values ? t('at most, at') : t('h at most, at');
    put(
      rms,
      difference && there ? `${t('root mean square')} ${real(difference.rms, 3)}${unit}` : '',
      difference?.rms ?? null,
    );
    where.hidden = !there;
    caption.hidden = !there;
    where.textContent = difference ? t('vertex {vertex}', { vertex: difference.vertex }) : '';
    same.textContent =
      difference && !there ? (values ? t('Both functions are the same.') : t('Both surfaces are the same.')) : '';
    if (!difference) return;
    strip.paint(difference.map);
    put(low, `${exact(difference.range.min)}${unit}`, difference.range.min);
    put(high, `${exact(difference.range.max)}${unit}`, difference.range.max);
  }
  return { element, view };
}
