import { choice, stateWith } from '../common.js';
import { rightAngle } from '../drawing.js';
import { type Choice, drawn, type Point, type Say, type Settings, type Slider } from '../figure.js';
import { objOf } from '../flat.js';
import { minus } from '../plane.js';
import { circle, group, line, plane, polygon, svg, text } from '../svg.js';
import { type Crossing, compute, type Data, isNegative, meshOf, read } from './compute.js';
import { type MeshName, meshes, sideOf } from './quads.js';

const mesh: Choice = { kind: 'choice', id: 'mesh', choices: meshes, initial: 'shaken' };
/** Of the side of a square. */
const amount: Slider = { kind: 'slider', id: 'amount', min: 0, max: 0.4, step: 0.01, initial: 0.15 };

/** All that a mesh can become fits in. */
function viewOf(name: MeshName) {
  const half = sideOf[name] / 2;
  const room = name === 'shaken' ? 0.7 : 0.3 * half + 0.4;
  const [x, y] = [half + room, half + 0.7];
  return plane({ x: [-x, x], y: [-y, y], width: 400, height: 424, margin: [4, 4, 28, 4] });
}

function draw(data: Data, settings: Settings, say: Say): string {
  const view = viewOf(settings.mesh as MeshName);
  const negative = isNegative(data);
  const { mesh: flat, barycentres, dual, crossings, measured } = data;
  const on = ({ along }: Crossing) => along >= 0 && along <= 1;
  const shifts = barycentres.map((from, f) =>
    line(view.at(from), view.at(dual[f] as Point), f === measured.worstFace ? 'edge' : 'thin'),
  );
  return svg(
    view.width,
    view.height,
    group(
      'mesh',
      ...flat.faces.map((face) =>
        polygon(
          face.map((v) => view.at(flat.points[v] as Point)),
          'face',
        ),
      ),
    ),
    group('edges', ...crossings.map(({ ends }) => line(view.at(ends[0]), view.at(ends[1]), 'edge'))),
    group(
      'extensions',
      ...crossings.map((crossing) => {
        const { ends, foot, along } = crossing;
        return on(crossing) ? '' : line(view.at(ends[along < 0 ? 0 : 1]), view.at(foot), 'dotted');
      }),
    ),
    group('shifts', ...shifts),
    group('barycentres', ...barycentres.map((point) => circle(view.at(point), 2.5, 'value-zero'))),
    group(
      'duals',
      ...crossings.map((crossing) => {
        const [from, to = crossing.foot] = crossing.dual;
        return line(view.at(from as Point), view.at(to), negative(crossing) ? 'edge-negative' : 'dual');
      }),
    ),
    group('marks', ...crossings.filter(on).map((crossing) => mark(crossing, view))),
    group('centres', ...dual.map((point) => circle(view.at(point), 3, 'point-accent'))),
    group('verdict', text([200, 410], measured.usable ? '' : say('labels.unusable'), 'halo bad')),
  );
}

function mark({ ends, dual: [v], foot, along }: Crossing, { at, scale }: ReturnType<typeof viewOf>): string {
  const [corner, end, across] = [at(foot), at(ends[along < 0.5 ? 1 : 0]), at(v as Point)];
  const direction = minus(across, corner);
  // On the edge itself the dual vertex has no direction from it.
  return Math.hypot(...direction) < 1 ? '' : rightAngle(corner, minus(end, corner), direction, 0.1 * scale);
}

export const figure = drawn<Data>({
  id: 'orthogonal-dual',
  number: 10,
  controls: [mesh, amount],
  compute,
  draw,
  read,
  file: (settings) => objOf(meshOf(settings)),
  state: () =>
    stateWith(() => ({
      task: 'dual',
      source: { kind: 'file', name: 'quads.obj', file: -1 },
      sides: { a: choice('orthogonal-dual'), b: choice('planar') },
    })),
});
