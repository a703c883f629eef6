import { withWeight } from '../../src/state.js';
import { choice, stateWith } from '../common.js';
import { type Choice, drawn, type Handle, type Point, type Say, type Settings, type Slider } from '../figure.js';
import { objOf } from '../flat.js';
import { length, minus, plus, unit } from '../plane.js';
import { circle, fixed, group, handle, line, plane, polygon, svg, text } from '../svg.js';
import { compute, type Data, isNegative, meshOf, read } from './compute.js';

/** In squared lengths; the edges are about 1 long. */
const omega: Slider = { kind: 'slider', id: 'omega', min: -1.6, max: 1.6, step: 0.02, initial: 0.4 };
const circles: Choice = {
  kind: 'choice',
  id: 'circles',
  choices: ['vertex', 'triangles'],
  initial: 'vertex',
  view: true,
};
/** Where all its triangles stay counter-clockwise. */
const middle: Handle = {
  kind: 'handle',
  id: 'middle',
  initial: [0, 0],
  step: 0.05,
  min: [-0.35, -0.35],
  max: [0.35, 0.35],
};

const view = plane({ x: [-2.1, 2.1], y: [-1.95, 1.95], width: 400, margin: 4 });

function draw({ mesh, omega: weight, centres, edges }: Data, settings: Settings, say: Say): string {
  const points = mesh.points.map(view.at);
  const at = (v: number) => points[v] as Point;
  const centre = centres.map(view.at);
  // The triangles around the middle, in order.
  const around = mesh.faces.flatMap((face, f) => (face[0] === 0 ? [f] : []));
  const cell = around.map((f) => centre[f] as Point);
  const spokes = edges.filter(({ ends }) => ends[0] === 0);
  const radius = Math.sqrt(Math.abs(weight)) * view.scale;
  const own = radius > 0 ? circle(at(0), radius, weight < 0 ? 'edge-negative' : 'edge') : '';
  const orthogonal = around.map((f) => {
    const c = centre[f] as Point;
    return circle(c, length(minus(c, at(mesh.faces[f]?.[1] as number))), 'dotted');
  });
  return svg(
    view.width,
    view.height,
    group('clip', polygon(cell, spokes.every(isNegative) ? 'face-bad' : 'face-accent')),
    group('mesh', ...mesh.faces.map((face) => polygon(face.map(at), 'thin'))),
    group('circles', ...(settings.circles === 'triangles' ? orthogonal : [])),
    group('powers', own),
    group(
      'duals',
      ...edges.map((edge) => {
        const [a, b] = edge.faces.map((f) => centre[f]) as [Point, Point];
        return line(a, b, isNegative(edge) ? 'edge-negative' : 'dual');
      }),
    ),
    group('vertices', ...points.slice(1).map((point) => circle(point, 3, 'point'))),
    group('centres', ...centre.map((point) => circle(point, 2.5, 'point-accent'))),
    group(
      'weights',
      ...spokes.map((edge) => {
        const end = at(edge.ends[1]);
        const place = plus(end, unit(minus(end, view.at([0, 0]))), 22);
        return text(place, fixed(edge.weight, 2), isNegative(edge) ? 'halo bad' : 'halo');
      }),
    ),
    view.element,
    group('handles', handle(middle, settings.middle as Point, view, say('handles.middle'))),
  );
}

export const figure = drawn<Data>({
  id: 'power-weights',
  number: 3,
  controls: [omega, circles, middle],
  compute,
  draw,
  read,
  file: (settings) => objOf(meshOf(settings)),
  state: (settings) =>
    stateWith(() => ({
      source: { kind: 'file', name: 'triangles.obj', file: -1 },
      sides: { a: choice('weighted-cotan'), b: choice('cotan') },
      vertexWeights: { a: withWeight({}, 0, settings.omega as number), b: {} },
      selected: 0,
    })),
});
