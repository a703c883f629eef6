import { choice, stateWith } from '../common.js';
import { arc, bisector, rightAngle } from '../drawing.js';
import { drawn, type Handle, type Point, type Say, type Settings } from '../figure.js';
import { objOf } from '../flat.js';
import { between, length, minus, plus } from '../plane.js';
import { circle, group, handle, indexed, line, markup, plane, polygon, polyline, svg, text } from '../svg.js';
import { compute, type Data, isNegative, meshOf, read } from './compute.js';

// So far from the edge that the circumcentres stay in the picture or near it.
const left: Handle = {
  kind: 'handle',
  id: 'left',
  initial: [-1.5, 0.3],
  step: 0.05,
  min: [-1.8, -1.3],
  max: [-0.3, 1.3],
};
const right: Handle = {
  kind: 'handle',
  id: 'right',
  initial: [1.2, -0.2],
  step: 0.05,
  min: [0.3, -1.3],
  max: [1.8, 1.3],
};

const view = plane({ x: [-2.1, 2.1], y: [-1.6, 1.6], width: 380, margin: 4 });

/** So that a label stays in the picture. */
const within = (place: number, size: number) => Math.min(size - 12, Math.max(12, place));

function draw(data: Data, settings: Settings, say: Say): string {
  const [bottom, top, ...apexes] = data.mesh.points.map(view.at) as [Point, Point, Point, Point];
  const centres = data.centres.map(view.at) as [Point, Point];
  const negative = isNegative(data);
  const middle = between(bottom, top, 0.5);
  const star = between(...centres, 0.5);
  const bad = negative ? ' bad' : '';
  const gammas = apexes.map((apex, k) => {
    const [x, y] = plus(apex, bisector(apex, bottom, top), -26);
    const place: Point = [within(x, view.width), within(y, view.height)];
    return text(place, k === 0 ? 'γ' : 'γ′', 'variable halo');
  });
  return svg(
    view.width,
    view.height,
    group('clip', ...centres.map((centre) => circle(centre, length(minus(centre, top)), 'thin'))),
    group(
      'mesh',
      ...apexes.map((apex) => polygon([bottom, top, apex], 'face') + polyline([bottom, apex, top], 'edge')),
    ),
    group('radii', ...centres.map((centre) => line(centre, top, 'dotted'))),
    group('angles', ...apexes.map((apex) => arc(apex, bottom, top, 28, 'edge'))),
    line(bottom, top, 'thick'),
    line(...centres, negative ? 'edge-negative' : 'dual'),
    group('marks', rightAngle(middle, [0, -1], [1, 0], 9)),
    group('centres', ...centres.map((centre) => circle(centre, 4, 'point-accent'))),
    group('ends', circle(bottom, 4, 'point'), circle(top, 4, 'point')),
    group('gammas', ...gammas),
    markup(plus(bottom, [0, 16]), indexed('x', 'i'), 'halo'),
    markup(plus(top, [0, -16]), indexed('x', 'j'), 'halo'),
    text(plus(between(bottom, top, 0.16), [12, 0]), 'e', 'variable halo'),
    text(plus(star, [0, 18]), '⋆e', `variable halo${bad}`),
    view.element,
    group(
      'handles',
      ...[left, right].map((one) => handle(one, settings[one.id] as Point, view, say(`handles.${one.id}`))),
    ),
  );
}

export const figure = drawn<Data>({
  id: 'circumcentric-dual',
  number: 2,
  controls: [left, right],
  compute,
  draw,
  read,
  file: (settings) => objOf(meshOf(settings)),
  state: () =>
    stateWith(() => ({
      source: { kind: 'file', name: 'two-triangles.obj', file: -1 },
      sides: { a: choice('cotan'), b: choice('umbrella') },
      selected: 0,
    })),
});
