import type { App } from '../app.js';
import { h, put } from '../dom.js';
import { count } from '../format.js';
import { known } from '../results.js';
import type { Scope } from '../scope.js';
import { type Task, type View, views } from '../state.js';
import { type Language, t } from '../words.js';
import { card } from './card.js';
import { checkPanel } from './check-panel.js';
import { button } from './controls.js';
import { deltaCard } from './delta-card.js';
import { dualPanel } from './dual-panel.js';
import type { Photographer } from './export-dialog.js';
import { harmonicPanel } from './harmonic-panel.js';
import { header } from './header.js';
import { intake } from './intake.js';
import { later } from './later.js';
import { messageLine } from './message-line.js';
import { smoothPanel, transport } from './smooth-panel.js';
import { statusLine } from './status.js';
import { tabs } from './tabs.js';
import { weightsPanel } from './weights-panel.js';

export interface Page {
  canvas: HTMLCanvasElement;
  views: Record<View, HTMLElement>;
  help: () => void;
}

/** Everything that is mounted, in reading order. */
export function page(
  app: App,
  root: HTMLElement,
  scope: Scope,
  photograph: Photographer,
  speak?: (language: Language) => void,
): Page {
  const help = later(app, root, t('Help'), async () => (await import('./dialogs.js')).helpDialog(app));
  const files = intake(app, root, scope);
  const cards = { a: card(app, 'a'), b: card(app, 'b'), delta: deltaCard(app) };
  const canvas = h('canvas', { class: 'scene', 'aria-hidden': 'true' });
  const panels: Record<Task, HTMLElement> = {
    weights: weightsPanel(app),
    smooth: smoothPanel(app),
    harmonic: harmonicPanel(app),
    dual: dualPanel(app),
    check: checkPanel(app),
  };
  const tasks = tabs<Task>(
    t('Task'),
    [
      { id: 'weights', label: t('Weights'), panel: panels.weights },
      { id: 'smooth', label: t('Smooth'), panel: panels.smooth },
      { id: 'harmonic', label: t('Harmonic'), panel: panels.harmonic },
      { id: 'dual', label: t('Dual'), panel: panels.dual },
      { id: 'check', label: t('Check'), panel: panels.check },
    ],
    (task) => app.setTask(task),
  );
  const narrowTransport = h('div', { class: 'narrow-transport' }, transport(app));
  // Part of another page, it adds no landmarks to those.
  const panel = h(
    scope.whole ? 'aside' : 'div',
    { class: 'panel', role: scope.whole ? undefined : 'group', 'aria-label': t('Controls and readouts') },
    ...Object.values(panels),
  );
  const stage = h('div', { class: 'stage' }, cards.a.element, cards.b.element, cards.delta.element, canvas);
  const masthead = header(app, {
    gallery: later(app, root, t('The gallery'), async () => (await import('./gallery-dialog.js')).galleryDialog(app)),
    open: files.pick,
    paste: later(app, root, t('The field to paste into'), async () => (await import('./dialogs.js')).pasteDialog(app)),
    make: later(app, root, t('What can be made'), async () => (await import('./make-dialog.js')).makeDialog(app)),
    share: later(app, root, t('The link'), async () => (await import('./share-dialog.js')).shareDialog(app)),
    save: later(app, root, t('What can be saved'), async () =>
      (await import('./export-dialog.js')).exportDialog(app, photograph),
    ),
    help,
    speak,
  });
  const leave = () => tasks.element.querySelector<HTMLElement>('[aria-selected=true]')?.focus();
  masthead.append(files.element);
  root.append(
    masthead,
    h(
      scope.whole ? 'section' : 'div',
      { class: 'task-line', role: scope.whole ? undefined : 'group', 'aria-label': t('Task and messages') },
      tasks.element,
      h('div', { class: 'messages' }, messageLine(app, 'error', leave), messageLine(app, 'report', leave)),
      deltaToggle(app),
    ),
    h(scope.whole ? 'main' : 'div', { class: 'main' }, narrowTransport, sideSwitch(app), stage, panel),
    statusLine(app),
  );
  app.state.watch(
    (state) => [state.task],
    (task) => {
      tasks.show(task);
      narrowTransport.hidden = task !== 'smooth';
      panel.scrollTop = 0;
    },
  );
  app.results.watch(
    (results) => [results.mesh],
    () => {
      panel.scrollTop = 0;
    },
  );
  app.state.watch(
    (state) => [state.shown],
    (shown) => {
      stage.dataset.shown = shown;
    },
  );
  app.state.watch(
    (state) => [state.delta.open],
    (open) => {
      stage.dataset.delta = String(open);
    },
  );
  return { canvas, views: { a: cards.a.view, b: cards.b.view, delta: cards.delta.view }, help };
}

/** Where there is room for three views. */
function deltaToggle(app: App): HTMLElement {
  const element = button(
    t('Δ Difference'),
    () => {
      const { delta } = app.state.get();
      app.state.set({ delta: { ...delta, open: !delta.open } });
    },
    { class: 'delta-toggle', 'data-action': 'delta', title: t('What tells B from A, in a third view') },
  );
  app.state.watch(
    (state) => [state.delta.open],
    (open) => element.setAttribute('aria-pressed', String(open)),
  );
  return element;
}

/** Where there is room for one view only: which one, with the numbers of all. */
function sideSwitch(app: App): HTMLElement {
  const buttons = views.map((view) => {
    const number = h('span', { 'data-readout': view === 'delta' ? undefined : 'negative-short' });
    const element = h(
      'button',
      { type: 'button', onclick: () => app.state.set({ shown: view }) },
      h('b', {}, view === 'delta' ? 'Δ' : view.toUpperCase()),
      ' ',
      number,
    );
    if (view === 'delta') element.setAttribute('aria-label', t('Difference of A and B'));
    else
      app.results.watch(
        (results) => [results[view].weights],
        (weights) => {
          const negative = known(weights)?.negativeOrdered ?? null;
          put(number, negative === null ? '–' : count(negative), negative);
          element.setAttribute(
            'aria-label',
            negative === null
              ? t('Side {side}, unknown number of negative weights', { side: view.toUpperCase() })
              : t('Side {side}, {count} negative weights', { side: view.toUpperCase(), count: negative }),
          );
        },
      );
    app.state.watch(
      (state) => [state.shown],
      (shown) => element.setAttribute('aria-pressed', String(shown === view)),
    );
    return element;
  });
  return h('div', { class: 'side-switch', role: 'group', 'aria-label': t('View shown') }, ...buttons);
}
