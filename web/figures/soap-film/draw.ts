import type { Point, Say, Settings } from '../figure.js';
import { circle, group, labels, line, plane, polyline, svg, text } from '../svg.js';
import { byDistance, eyeAt, type Face, type Frame, type Line, markup, type Vec } from '../svg3d.js';
import { radiusAt } from './catenoid.js';
import { type FilmData, profile, shown } from './figure.js';

const frame: Frame = { centre: [0, 0, 0], radius: 1.32, width: 360, height: 360 };

/** The film in space, and cut through its axis beside the catenoid. */
export const drawFilm = (data: FilmData, settings: Settings, say: Say): string =>
  space(data, settings) + section(data, settings, say);

function space(data: FilmData, settings: Settings): string {
  const { offsets, corners, h, waist } = data;
  const { coordinates } = shown(data, settings).film;
  const eye = eyeAt(settings.view as Point, frame);
  const at = (v: number): Vec => [
    coordinates[3 * v] as number,
    coordinates[3 * v + 1] as number,
    coordinates[3 * v + 2] as number,
  ];
  const faces = Array.from({ length: offsets.length - 1 }, (_, f): Face => {
    const points = Array.from(corners.subarray(offsets[f], offsets[f + 1]), at);
    const isOnRing = (p: Vec) => Math.abs(Math.abs(p[2]) - h) < 1e-6;
    const edges = points.flatMap((p, k): Line[] => {
      const q = points[(k + 1) % points.length] as Vec;
      return isOnRing(p) && isOnRing(q) ? [{ kind: 'line', points: [p, q], look: 'thick' }] : [];
    });
    return { kind: 'face', points, edges };
  });
  // The outline's own plane: through the axis, across the view.
  const outlines = [-1, 1].map((sign) =>
    polyline(
      meridian(waist, h).map(([r, z]) => eye.place([sign * r * eye.right[0], sign * r * eye.right[1], z])),
      'catenoid',
    ),
  );
  return svg(frame.width, frame.height, group('solid edged', markup(byDistance(faces, eye), eye), ...outlines));
}

/** Of the catenoid from ring to ring; none where there is none. */
function meridian(c: number, h: number): Point[] {
  if (Number.isNaN(c)) return [];
  const parts = 40;
  return Array.from({ length: parts + 1 }, (_, k): Point => {
    const z = h * ((2 * k) / parts - 1);
    return [radiusAt(c, z), z];
  });
}

function section(data: FilmData, settings: Settings, say: Say): string {
  const { h, waist, around } = data;
  const { film, step, pinched } = shown(data, settings);
  const { at } = plane({ x: [-1.15, 1.15], y: [-1, 1], width: 360, height: 360, margin: 16 });
  const rings = profile(film, around);
  const mirrored = (points: readonly Point[], sign: number) => points.map(([r, z]) => at([sign * r, z]));
  const both = (draw: (sign: number) => string) => [-1, 1].map(draw).join('');
  const note = Number.isNaN(waist) ? say('labels.none') : '';
  return svg(
    360,
    360,
    line(at([0, -0.87]), at([0, 0.87]), 'axis'),
    both((sign) => polyline(mirrored(meridian(waist, h), sign), 'catenoid')),
    both((sign) => polyline(mirrored(rings, sign), 'edge')),
    both((sign) =>
      mirrored(rings, sign)
        .map((p) => circle(p, 2.5, 'point'))
        .join(''),
    ),
    both((sign) => [-h, h].map((z) => circle(at([sign, z]), 5, 'point-open')).join('')),
    text(at([0, 0.93]), note, 'quiet', 'middle'),
    pinched ? text(at([0, -0.93]), say('labels.pinched', { step }), 'quiet', 'middle') : '',
    labels(
      Number.isNaN(waist)
        ? []
        : [{ at: at([waist, 0]), words: say('labels.catenoid'), className: 'accent', towards: [-1, 0] }],
      mirrored(rings, 1).map(([x, y]): [number, number, number] => [x, y, 4]),
    ),
  );
}
