/** The weights ω of vertices on the meshes: a circle of radius √|ω| around each, and a handle that is dragged up or down. */
import type { App } from './app.js';
import { h } from './dom.js';
import { real } from './format.js';
import type { Side } from './polylap.js';
import { onDrag } from './scene/drag.js';
import { type Label, labelLimit } from './scene/labels.js';
import { weightCircles } from './scene/layers.js';
import type { Viewer } from './scene/viewer.js';
import { operatorOf, type State, sides } from './state.js';
import { t } from './words.js';

/** Where there is something to read of weights. */
const tasks: readonly State['task'][] = ['weights', 'dual'];
/** In pixels: a smaller circle cannot be told from none. */
const least = 3;
/** What an arrow key adds, in mean squared edge lengths. */
const keyStep = 0.01;

export function bindWeights(app: App, viewer: Viewer): void {
  for (const side of sides) {
    bindCircles(app, viewer, side);
    bindHandles(app, viewer, side);
  }
}

const weightsOf = (app: App, side: Side) => {
  const { sides: choices, vertexWeights } = app.state.get();
  return operatorOf(choices[side]).takesVertexWeights ? vertexWeights[side] : null;
};

function bindCircles(app: App, viewer: Viewer, side: Side): void {
  const show = () => {
    const { positions } = app.results.get()[side];
    const normalOf = (vertex: number) => viewer.normalOf(side, vertex);
    const weights = weightsOf(app, side) ?? {};
    viewer.setLayer(side, 'weights', weightCircles(positions, weights, normalOf, 0.3 * viewer.meanEdge));
  };
  app.state.watch((state) => [state.sides[side].operator, state.vertexWeights[side]], show);
  app.results.watch((results) => [results[side].positions, results.mesh], show);
}

/** One for the selected vertex and for each that has a weight. */
function bindHandles(app: App, viewer: Viewer, side: Side): void {
  const handles = new Map<number, WeightHandle>();
  const show = () => {
    const { task, selected } = app.state.get();
    const weights = tasks.includes(task) && app.results.get().mesh ? weightsOf(app, side) : null;
    const wanted = weights
      ? new Set([...(selected === null ? [] : [selected]), ...Object.keys(weights).map(Number)])
      : [];
    const shown = [...wanted].slice(0, labelLimit).map((vertex) => {
      const handle = handles.get(vertex) ?? new WeightHandle(app, viewer, side, vertex);
      handle.set(weights?.[vertex] ?? 0);
      return handle;
    });
    handles.clear();
    for (const handle of shown) handles.set(handle.vertex, handle);
    viewer.setLabels(side, 'weights', shown);
  };
  app.state.watch((state) => [state.task, state.selected, state.sides[side].operator, state.vertexWeights[side]], show);
  app.results.watch((results) => [results.mesh], show);
}

class WeightHandle implements Label {
  readonly element: HTMLElement;
  private readonly handle: HTMLElement;
  private weight = Number.NaN;

  constructor(
    private readonly app: App,
    private readonly viewer: Viewer,
    private readonly side: Side,
    readonly vertex: number,
  ) {
    this.handle = h('span', {
      class: 'handle',
      role: 'spinbutton',
      tabindex: 0,
      title: t('Drag up or down: the radius of the circle is √|ω|, dashed below 0.'),
      'aria-label': t('Weight ω at vertex {vertex} of {side}', { vertex, side: side.toUpperCase() }),
      onclick: () => app.select(vertex),
      onkeydown: (event: KeyboardEvent) => this.key(event),
    });
    this.element = h('span', { class: 'vertex-label weight-label' }, this.handle);
    this.takeDrags();
  }

  set(weight: number): void {
    if (weight === this.weight) return;
    this.weight = weight;
    this.handle.replaceChildren(h('i', {}, 'ω'), ` ${real(weight, 3)}`);
    this.handle.setAttribute('aria-valuenow', String(weight));
    this.handle.setAttribute('aria-valuetext', real(weight, 3));
  }

  private give(weight: number): void {
    this.app.setWeight(this.side, this.vertex, Number(weight.toPrecision(4)));
  }

  private takeDrags(): void {
    const { app, element, side, vertex } = this;
    let before = app.state.get().vertexWeights[side];
    /** With the sign of ω. */
    let radius = 0;
    let from = 0;
    const over = () => {
      element.classList.remove('dragged');
      app.history.release();
    };
    onDrag(this.handle, {
      begin: (_, y) => {
        before = app.state.get().vertexWeights[side];
        radius = Math.sign(this.weight) * Math.sqrt(Math.abs(this.weight));
        from = y;
        app.select(vertex);
        app.hover(null);
        app.history.hold();
        element.classList.add('dragged');
      },
      move: (_, y) => {
        const pixel = this.viewer.lengthPerPixel(side, vertex);
        const now = radius + (from - y) * pixel;
        this.give(Math.abs(now) < least * pixel ? 0 : now * Math.abs(now));
      },
      end: () => {
        over();
        app.say(t('ω of vertex {vertex} is {value}.', { vertex, value: real(this.weight, 3) }), (state) => [
          state.vertexWeights,
        ]);
      },
      cancel: () => {
        app.setWeights(side, before);
        over();
        app.say(t('The weight is as it was.'), (state) => [state.vertexWeights]);
      },
    });
  }

  private key(event: KeyboardEvent): void {
    if (event.ctrlKey || event.metaKey || event.altKey) return;
    const { meanSquaredEdge = 1 } = this.app.results.get().mesh ?? {};
    const by = { ArrowUp: keyStep, ArrowDown: -keyStep }[event.key];
    if (by !== undefined) {
      // In whole steps: down as often as up is 0 again.
      const steps = Math.round(this.weight / (keyStep * meanSquaredEdge) + by / keyStep);
      this.give(steps * keyStep * meanSquaredEdge);
    } else if (event.key === 'Delete' || event.key === 'Backspace') this.give(0);
    else return;
    event.preventDefault();
    event.stopPropagation();
  }
}
