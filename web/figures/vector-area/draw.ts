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

const frame: Frame = { centre: [0, 0, 0], radius: 1.12, width: 440, height: 380 };
/** How far below the middle of the polygon its projection lies, and how long arrows are drawn: |a| = 1, and a gradient of 1. */
const [drop, areaLength, gradientLength] = [0.85, 0.9, 0.5];

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
  const rightmost = (among: readonly Vec[]) => among.reduce((p, q) => (dot(q, eye.right) > dot(p, eye.right) ? q : p));
  const names = labels(
    [
      { at: eye.place(tip), words: 'a', className: 'variable symbol accent', towards: [1, 0], size: 17 },
      {
        at: eye.place(rightmost(tips)),
        words: say('labels.gradient'),
        className: 'variable symbol',
        towards: [0.4, 1],
        size: 17,
      },
      { at: eye.place(rightmost(shadows)), words: '|a|', className: 'variable symbol', towards: [0.2, 1], size: 17 },
    ],
    [],
    frame,
  );
  return svg(frame.width, frame.height, group('solid', markup(byPlanes(pieces, eye), eye)), names);
}
