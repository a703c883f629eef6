import type { Point, Say, Settings } from '../figure.js';
import { group, labels, svg } from '../svg.js';
import {
  byPlanes,
  dot,
  eyeAt,
  type Face,
  type Frame,
  type Line,
  markup,
  mean,
  minus,
  sum,
  times,
  unit,
  type Vec,
} from '../svg3d.js';
import type { AreaData } from './figure.js';

const frame: Frame = { centre: [0, 0, 0], radius: 1.32, width: 500, height: 410 };
/** How far below the middle of the polygon its projection lies, and how long arrows are drawn: |a| = 1, and a gradient of 1. */
const [drop, areaLength, gradientLength] = [0.8, 0.9, 0.4];

export function drawArea(data: AreaData, settings: Settings, say: Say): string {
  const eye = eyeAt(settings.view as Point, frame);
  const { points, vectorArea, gradients } = data;
  const middle = mean(points);
  const normal = unit(vectorArea);
  const shadows = points.map((p): Vec => sum(p, times(-drop - dot(minus(p, middle), normal), normal)));
  const tip = sum(middle, times(areaLength, vectorArea));
  const tips = points.map((p, k) => sum(p, times(gradientLength, gradients[k] as Vec)));
  const next = (k: number) => points[(k + 1) % points.length] as Vec;
  const line = (from: Vec, to: Vec, look: string, arrow = false): Line => ({
    kind: 'line',
    points: [from, to],
    look,
    arrow,
  });
  const pieces = [
    { kind: 'face', points: shadows, look: 'shadow' } satisfies Face,
    ...points.map((p, k): Face => ({ kind: 'face', points: [middle, p, next(k)] })),
    ...points.map((p, k) => line(p, next(k), 'edge')),
    ...points.map((p, k) => line(p, shadows[k] as Vec, 'dotted')),
    ...points.map((p, k) => line(p, tips[k] as Vec, '', true)),
    line(middle, tip, 'accent', true),
  ];
  // Beyond the outermost point in a direction nothing of its kind is in the way.
  const beyond = (points: readonly Vec[], towards: Point) => {
    const reach = ([x, y]: Point) => x * towards[0] + y * towards[1];
    const at = points.map(eye.place).reduce((p, q) => (reach(q) > reach(p) ? q : p));
    return { at, towards, className: 'variable symbol', size: 17 };
  };
  const names = labels(
    [
      { ...beyond([tip], [1, 0]), words: 'a', className: 'variable symbol accent' },
      { ...beyond(tips, [0.95, -0.3]), words: say('labels.gradient') },
      { ...beyond(shadows, [0.6, 0.8]), words: '|a|' },
    ],
    [],
    frame,
  );
  return svg(frame.width, frame.height, group('solid', markup(byPlanes(pieces, eye), eye)), names);
}
