import type { App } from '../app.js';
import { h, put } from '../dom.js';
import { count } from '../format.js';
import type { Side } from '../polylap.js';
import { known } from '../results.js';
import { sides, type Task } from '../state.js';
import { card } from './card.js';
import { checkPanel } from './check-panel.js';
import { helpDialog, pasteDialog } from './dialogs.js';
import { dualPanel } from './dual-panel.js';
import { harmonicPanel } from './harmonic-panel.js';
import { header } from './header.js';
import { intake } from './intake.js';
import { makeDialog } from './make-dialog.js';
import { messageLine } from './message-line.js';
import { shareDialog } from './share-dialog.js';
import { smoothPanel, transport } from './smooth-panel.js';
import { statusLine } from './status.js';
import { tabs } from './tabs.js';
import { weightsPanel } from './weights-panel.js';

export interface Page {
  canvas: HTMLCanvasElement;
  views: Record<Side, HTMLElement>;
  help: () => void;
}

/** The whole document, in reading order. */
export function page(app: App, root: HTMLElement): Page {
  const help = helpDialog();
  const paste = pasteDialog(app);
  const make = makeDialog(app);
  const share = shareDialog(app);
  const files = intake(app, root);
  const cards = { a: card(app, 'a'), b: card(app, 'b') };
  const canvas = h('canvas', { class: 'scene', 'aria-hidden': 'true' });
  const panels: Record<Task, HTMLElement> = {
    weights: weightsPanel(app),
    smooth: smoothPanel(app),
    harmonic: harmonicPanel(app),
    dual: dualPanel(app),
    check: checkPanel(app),
  };
  const tasks = tabs<Task>(
    'Task',
    [
      { id: 'weights', label: 'Weights', panel: panels.weights },
      { id: 'smooth', label: 'Smooth', panel: panels.smooth },
      { id: 'harmonic', label: 'Harmonic', panel: panels.harmonic },
      { id: 'dual', label: 'Dual', panel: panels.dual },
      { id: 'check', label: 'Check', panel: panels.check },
    ],
    (task) => app.setTask(task),
  );
  const narrowTransport = h('div', { class: 'narrow-transport' }, transport(app));
  const stage = h('div', { class: 'stage' }, cards.a.element, cards.b.element, canvas);
  const masthead = header(app, {
    open: files.pick,
    paste: () => paste.showModal(),
    make: () => make.showModal(),
    share: share.open,
    help: () => help.showModal(),
  });
  const leave = () => tasks.element.querySelector<HTMLElement>('[aria-selected=true]')?.focus();
  masthead.append(files.element);
  root.append(
    masthead,
    h(
      'section',
      { class: 'task-line', 'aria-label': 'Task and messages' },
      tasks.element,
      h('div', { class: 'messages' }, messageLine(app, 'error', leave), messageLine(app, 'report', leave)),
    ),
    h(
      'main',
      {},
      narrowTransport,
      sideSwitch(app),
      stage,
      h('aside', { class: 'panel', 'aria-label': 'Controls and readouts' }, ...Object.values(panels)),
    ),
    statusLine(app),
    help,
    paste,
    make,
    share.element,
  );
  app.state.watch(
    (state) => [state.task],
    (task) => {
      tasks.show(task);
      narrowTransport.hidden = task !== 'smooth';
    },
  );
  app.state.watch(
    (state) => [state.shown],
    (shown) => {
      stage.dataset.shown = shown;
    },
  );
  return { canvas, views: { a: cards.a.view, b: cards.b.view }, help: () => help.showModal() };
}

/** Where there is room for one side only: which one, with the numbers of both. */
function sideSwitch(app: App): HTMLElement {
  const buttons = sides.map((side) => {
    const number = h('span', { 'data-readout': 'negative-short' });
    const element = h(
      'button',
      { type: 'button', onclick: () => app.state.set({ shown: side }) },
      h('b', {}, side.toUpperCase()),
      ' ',
      number,
    );
    app.results.watch(
      (results) => [results[side].weights],
      (weights) => {
        const negative = known(weights)?.negativeOrdered ?? null;
        put(number, negative === null ? '–' : count(negative), negative);
        element.setAttribute(
          'aria-label',
          `Side ${side.toUpperCase()}, ${negative ?? 'unknown number of'} negative weights`,
        );
      },
    );
    app.state.watch(
      (state) => [state.shown],
      (shown) => element.setAttribute('aria-pressed', String(shown === side)),
    );
    return element;
  });
  return h('div', { class: 'side-switch', role: 'group', 'aria-label': 'Side shown' }, ...buttons);
}
