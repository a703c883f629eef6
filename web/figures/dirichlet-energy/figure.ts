import { choice, stateWith } from '../common.js';
import { drawn, type Handle, type Point, type Say, type Settings } from '../figure.js';
import { objOf } from '../flat.js';
import { length, minus, plus, type Triangle } from '../plane.js';
import { group, handle, indexed, line, markup, plane, polygon, rectangle, svg, text } from '../svg.js';
import { compute, type Data, jacobian, meshOf, read } from './compute.js';

/** Each corner of the source has a place of its own: the triangle cannot turn over, or lose its area. */
const source: readonly Handle[] = [
  corner('a', [0, 0], [-0.1, -0.1], [0.3, 0.25]),
  corner('b', [1.2, 0], [0.8, -0.1], [1.4, 0.4]),
  corner('c', [0.4, 1], [-0.1, 0.7], [0.9, 1.3]),
];
/** Those of its image go anywhere. */
const image: readonly Handle[] = [
  corner('p', [0.1, 0.2], [-0.35, -0.35], [1.55, 1.45]),
  corner('q', [1.4, 0], [-0.35, -0.35], [1.55, 1.45]),
  corner('r', [1.2, 1.1], [-0.35, -0.35], [1.55, 1.45]),
];

function corner(id: string, initial: Point, min: Point, max: Point): Handle {
  return { kind: 'handle', id, initial, step: 0.05, min, max };
}

/** The same scale on both sides: areas can be compared. */
const view = plane({ x: [-0.5, 1.7], y: [-0.5, 1.6], width: 340, height: 372, margin: [4, 4, 44, 4] });
const bar = { left: 24, width: 292, top: 344, height: 12 };

function draw(data: Data, settings: Settings, say: Say): string {
  const inscribed = incircle(data.source);
  const [first, second] = jacobian(data.source, data.image);
  const [origin, target] = [data.source[0], data.image[0]];
  const mapped = inscribed.points.map((point) => {
    const [x, y] = minus(point, origin);
    return plus(plus(target, first, x), second, y);
  });
  const middle = (handles: readonly Handle[]) =>
    handles.map(({ id }) => settings[id] as Point).reduce((sum, point) => plus(sum, point, 1 / 3), [0, 0] as Point);
  const side = (
    name: 'x' | 'u',
    handles: readonly Handle[],
    triangle: Triangle,
    round: readonly Point[],
    foot: string,
  ) =>
    svg(
      view.width,
      view.height,
      polygon(triangle.map(view.at), 'face'),
      polygon(triangle.map(view.at), 'edge'),
      polygon(round.map(view.at), 'face-accent'),
      polygon(round.map(view.at), 'dual'),
      group('below', foot),
      view.element,
      group('handles', ...handles.map((one) => handle(one, settings[one.id] as Point, view, say(`handles.${one.id}`)))),
      group(
        'names',
        ...handles.map((one, k) => {
          const at = settings[one.id] as Point;
          const away = minus(at, middle(handles));
          const outward: Point = length(away) > 1e-6 ? [away[0] / length(away), -away[1] / length(away)] : [0, -1];
          return markup(plus(view.at(at), outward, 24), indexed(name, String(k + 1)), 'halo');
        }),
      ),
    );
  return (
    side('x', source, data.source, inscribed.points, text([170, 350], say('labels.source'), 'quiet')) +
    side('u', image, data.image, mapped, shares(data, say))
  );
}

/** E_d as a bar: what of it is area, and what is beyond. */
function shares(data: Data, say: Say): string {
  const { left, width, top, height } = bar;
  const area = data.energy > 0 ? (Math.abs(data.area) / data.energy) * width : width;
  return group(
    'shares',
    rectangle([left, top], width, height, 'bar-range'),
    rectangle([left, top], area, height, 'bar'),
    line([left + area, top - 4], [left + area, top + height + 4], 'thick'),
    text([left, top - 12], say('labels.area'), 'quiet', 'start'),
    text([left + width, top - 12], say('labels.excess'), 'quiet', 'end'),
  );
}

/** The largest circle in a triangle. */
function incircle([a, b, c]: Triangle) {
  const sides = [length(minus(c, b)), length(minus(a, c)), length(minus(b, a))] as const;
  const around = sides[0] + sides[1] + sides[2];
  const centre = [a, b, c].reduce((sum, point, k) => plus(sum, point, (sides[k] as number) / around), [0, 0] as Point);
  const [u, v] = [minus(b, a), minus(c, a)];
  const radius = Math.abs(u[0] * v[1] - u[1] * v[0]) / around;
  const points = Array.from({ length: 72 }, (_, k) => {
    const angle = (k * Math.PI) / 36;
    return plus(centre, [Math.cos(angle), Math.sin(angle)], radius);
  });
  return { centre, radius, points };
}

export const figure = drawn<Data>({
  id: 'dirichlet-energy',
  number: 1,
  controls: [...source, ...image],
  compute,
  draw,
  read,
  file: (settings) => objOf(meshOf(settings)),
  state: () =>
    stateWith(() => ({
      source: { kind: 'file', name: 'triangle.obj', file: -1 },
      sides: { a: choice('cotan'), b: choice('umbrella') },
      selected: 0,
    })),
});
