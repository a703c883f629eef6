import type { App } from '../app.js';
import { h } from '../dom.js';
import { button, numberField } from './controls.js';

/** The selected vertex: by number, or to the neighbours in number. */
export function vertexField(app: App): HTMLElement {
  const field = numberField({
    label: 'Vertex',
    min: 0,
    max: () => (app.results.get().mesh?.vertices ?? 1) - 1,
    integer: true,
    step: 1,
    onChange: (vertex) => app.select(vertex),
    onEmpty: () => app.select(null),
    onRefuse: (why) => app.say(why),
  });
  app.state.watch(
    (state) => [state.selected],
    (selected) => field.set(selected),
  );
  field.element.placeholder = 'none';
  field.element.dataset.field = 'vertex';
  return h(
    'div',
    { class: 'vertex-field' },
    h('h2', { title: 'Vertices and faces count from 0.' }, 'Vertex'),
    field.element,
    button('[', () => app.walk(-1), { 'aria-label': 'Vertex before', title: 'Vertex before ([)', class: 'key' }),
    button(']', () => app.walk(1), { 'aria-label': 'Next vertex', title: 'Next vertex (])', class: 'key' }),
  );
}
