/** The labels of pins on the meshes: dragged from vertex to vertex, edited in place, moved by keys. */
import type { App } from './app.js';
import { h } from './dom.js';
import { exact } from './format.js';
import { numberField } from './layout/controls.js';
import { neighbours } from './neighbours.js';
import { onDrag } from './scene/drag.js';
import { type Label, labelLimit } from './scene/labels.js';
import type { Viewer } from './scene/viewer.js';
import { focusedBy } from './scope.js';
import { type Pin, type View, views } from './state.js';
import { t } from './words.js';

/** Two clicks within this time, in ms, open the value. */
const doubleSpan = 400;
/** On the screen, to the right and down. */
const directions: Readonly<Record<string, readonly [number, number]>> = {
  ArrowLeft: [-1, 0],
  ArrowRight: [1, 0],
  ArrowUp: [0, -1],
  ArrowDown: [0, 1],
};

export function bindPins(app: App, viewer: Viewer, places: Record<View, HTMLElement>): void {
  for (const view of views) {
    const labels: PinLabel[] = [];
    const show = () => {
      const { task, harmonic } = app.state.get();
      const pins = task === 'harmonic' ? harmonic.pins.slice(0, labelLimit) : [];
      labels.length = Math.min(labels.length, pins.length);
      pins.forEach((pin, k) => {
        labels[k] ??= new PinLabel(app, viewer, view, places, () => (labels[k] ?? labels[k - 1])?.focus());
        labels[k]?.set(pin);
      });
      viewer.setLabels(view, 'pins', labels.slice());
    };
    app.state.watch((state) => [state.task, state.harmonic.pins], show);
  }
}

/** A pin in a view. */
class PinLabel implements Label {
  readonly element = h('span', { class: 'vertex-label pin-label' });
  private readonly button = h('button', {
    type: 'button',
    title: t('Drag to another vertex. Double click for the value.'),
    'aria-keyshortcuts': 'Enter Delete ArrowLeft ArrowRight ArrowUp ArrowDown',
  });
  private pin: Pin = { vertex: 0, value: 0 };
  private clicked = Number.NEGATIVE_INFINITY;

  /** @param removed once it is gone */
  constructor(
    private readonly app: App,
    private readonly viewer: Viewer,
    private readonly view: View,
    private readonly places: Record<View, HTMLElement>,
    private readonly removed: () => void,
  ) {
    const { button } = this;
    this.element.append(button);
    button.addEventListener('click', ({ timeStamp }) => {
      app.select(this.vertex);
      if (timeStamp - this.clicked < doubleSpan) this.edit();
      this.clicked = timeStamp;
    });
    button.addEventListener('keydown', (event) => this.key(event));
    this.takeDrags();
  }

  get vertex(): number {
    return this.pin.vertex;
  }

  set(pin: Pin): void {
    if (pin === this.pin) return;
    this.pin = pin;
    this.button.textContent = exact(Number(pin.value.toPrecision(3)));
    this.button.setAttribute(
      'aria-label',
      t('Pin at vertex {vertex}, value {value}', { vertex: pin.vertex, value: exact(pin.value) }),
    );
  }

  focus(): void {
    this.button.focus();
  }

  private takeDrags(): void {
    const { app, element } = this;
    let before = app.state.get().harmonic.pins;
    const over = () => {
      element.classList.remove('dragged');
      app.hover(null);
      app.history.release();
    };
    onDrag(this.button, {
      begin: () => {
        before = app.state.get().harmonic.pins;
        app.history.hold();
        element.classList.add('dragged');
      },
      move: (x, y, touch) => {
        const vertex = this.vertexAt(x, y, touch);
        if (vertex === null || vertex === this.vertex || !app.movePin(this.vertex, vertex)) return;
        app.hover(vertex);
      },
      end: () => {
        over();
        app.select(this.vertex);
        app.sayOfPins(t('Pinned at vertex {vertex}.', { vertex: this.vertex }));
      },
      cancel: () => {
        app.setPins(before);
        over();
        app.sayOfPins(t('The pin is where it was.'));
      },
    });
  }

  /** In whichever view the pointer is. */
  private vertexAt(x: number, y: number, touch: boolean): number | null {
    const over = views.find((view) => {
      const { left, right, top, bottom } = this.places[view].getBoundingClientRect();
      return left <= x && x < right && top <= y && y < bottom;
    });
    return over ? this.viewer.pick(over, x, y, touch) : null;
  }

  private key(event: KeyboardEvent): void {
    if (event.ctrlKey || event.metaKey || event.altKey) return;
    const direction = directions[event.key];
    if (direction) this.step(direction);
    else if (event.key === 'Enter') this.edit();
    else if (event.key === 'Delete' || event.key === 'Backspace') this.remove();
    else return;
    event.preventDefault();
    event.stopPropagation();
  }

  private remove(): void {
    const { vertex } = this;
    this.places[this.view].focus();
    this.app.pin(vertex, null);
    this.app.sayOfPins(t('The pin at vertex {vertex} is removed.', { vertex }));
    this.removed();
  }

  /** Along the edge that goes most in a direction of the screen. */
  private step([dx, dy]: readonly [number, number]): void {
    const { app, viewer, view } = this;
    const { mesh } = app.results.get();
    const here = viewer.project(view, this.vertex);
    if (!mesh || !here) return;
    let best: { vertex: number; along: number } | null = null;
    for (const vertex of neighbours(mesh.geometry, this.vertex)) {
      const there = viewer.project(view, vertex);
      if (!there) continue;
      const [x, y] = [there.x - here.x, there.y - here.y];
      const along = (x * dx + y * dy) / (Math.hypot(x, y) || 1);
      // Not across, let alone back.
      if (along > 0.3 && along > (best?.along ?? 0)) best = { vertex, along };
    }
    if (!best) return;
    const { vertex } = best;
    if (!app.movePin(this.vertex, vertex)) {
      app.sayOfPins(t('Vertex {vertex} is pinned already.', { vertex }));
      return;
    }
    app.sayOfPins(t('Pinned at vertex {vertex}.', { vertex }));
    if (!viewer.project(view, vertex)?.visible) viewer.flyTo(view, vertex);
  }

  private edit(): void {
    const { app, button, element } = this;
    const { vertex, value } = this.pin;
    const field = numberField({
      label: t('Value at vertex {vertex}', { vertex }),
      step: 1,
      onChange: (next) => app.pin(vertex, next),
      onRefuse: (why) => app.refuse(why),
    });
    const input = field.element;
    let open = true;
    const close = (keep: boolean) => {
      if (!open) return;
      open = false;
      if (!keep) app.pin(vertex, value);
      app.history.release();
      const focused = focusedBy(input) === input;
      button.hidden = false;
      input.remove();
      if (focused) button.focus();
    };
    field.set(value);
    input.addEventListener('keydown', (event) => {
      event.stopPropagation();
      if (event.key === 'Enter' || event.key === 'Escape') event.preventDefault();
      // What cannot be taken is told of on the way out.
      if (event.key === 'Enter') input.dispatchEvent(new Event('change'));
      if (event.key === 'Enter') close(true);
      if (event.key === 'Escape') close(false);
    });
    input.addEventListener('pointerdown', (event) => event.stopPropagation());
    input.addEventListener('blur', () => close(true));
    app.history.hold();
    element.append(input);
    input.focus();
    button.hidden = true;
    input.select();
    this.viewer.request();
  }
}
