import type { App } from '../app.js';
import { h } from '../dom.js';
import type { Mesh } from '../polylap.js';
import type { State } from '../state.js';
import { t } from '../words.js';
import { button, numberField } from './controls.js';

interface Walk {
  name: string;
  /** By which tests and styles know the field. */
  field: 'vertex' | 'face';
  /** What the buttons do. */
  before: string;
  next: string;
  count: (mesh: Mesh) => number;
  selected: (state: State) => number | null;
  select: (number: number | null) => void;
  walk: (by: number) => void;
  /** Back and on. */
  keys: readonly [string, string];
}

/** What is selected: by number, or to the neighbours in number. */
function numberWalk(
  app: App,
  { name, field: id, before, next, count, selected, select, walk, keys: [back, on] }: Walk,
): HTMLElement {
  const field = numberField({
    label: name,
    min: 0,
    max: () => {
      const { mesh } = app.results.get();
      return (mesh ? count(mesh) : 1) - 1;
    },
    integer: true,
    step: 1,
    onChange: select,
    onEmpty: () => select(null),
    onRefuse: (why) => app.refuse(why),
  });
  app.state.watch(
    (state) => [selected(state)],
    (number) => field.set(number),
  );
  field.element.placeholder = t('none');
  field.element.dataset.field = id;
  const key = (sign: string, by: number, label: string) =>
    button(sign, () => walk(by), { 'aria-label': label, title: `${label} (${sign})`, class: 'key' });
  return h(
    'div',
    { class: 'vertex-field' },
    h('h2', { title: t('Vertices and faces count from 0.') }, name),
    field.element,
    key(back, -1, before),
    key(on, 1, next),
  );
}

export const vertexField = (app: App): HTMLElement =>
  numberWalk(app, {
    name: t('Vertex'),
    field: 'vertex',
    before: t('Vertex before'),
    next: t('Next vertex'),
    count: ({ vertices }) => vertices,
    selected: ({ selected }) => selected,
    select: (vertex) => app.select(vertex),
    walk: (by) => app.walk(by),
    keys: ['[', ']'],
  });

export const faceField = (app: App): HTMLElement =>
  numberWalk(app, {
    name: t('Face'),
    field: 'face',
    before: t('Face before'),
    next: t('Next face'),
    count: ({ faces }) => faces,
    selected: ({ selectedFace }) => selectedFace,
    select: (face) => app.selectFace(face),
    walk: (by) => app.walkFaces(by),
    keys: ['{', '}'],
  });
