/** The value in the middle of four rectangles (Herholz 2012, Fig. 4.9). */
import type { Harmonic, Mesh, OperatorSpec, Row } from '../../src/polylap.js';
import { choice, fixedValues, flat, gridSource, rim, stateWith } from '../common.js';
import { drawn, type Point, type Say, type Settings } from '../figure.js';
import { circle, fixed, group, line, plane, polygon, rectangle, svg, text } from '../svg.js';

const middle = 4;
const pins = rim(2, (i, j) => i === 1 || j === 1);

interface Side {
  value: number;
  /** Of the row of the middle, by vertex. */
  weights: ReadonlyMap<number, number>;
}

interface Data {
  /** In the plane, by vertex. */
  points: Point[];
  faces: number[][];
  a: Side;
  b: Side;
}

const sizeOf = ({ aspect }: Settings) => ({ width: 2, height: 2 / Number(aspect) });

const sideOf = ({ values }: Harmonic, { columns, values: entries }: Row): Side => ({
  value: values[middle] ?? Number.NaN,
  weights: new Map(
    [...columns].map((vertex, k): [number, number] => [vertex, -(entries[k] ?? 0)]).filter(([v]) => v !== middle),
  ),
});

async function ask(mesh: Mesh, spec: OperatorSpec): Promise<Side> {
  const [harmonic, row] = await Promise.all([mesh.harmonic(spec, fixedValues(pins)), mesh.row(spec, middle)]);
  return sideOf(harmonic, row);
}

export const figure = drawn<Data>({
  id: 'one-interior-vertex',
  number: 6,
  controls: [
    { id: 'lambda', kind: 'slider', min: 0.05, max: 3, step: 0.05, initial: 1 },
    { id: 'aspect', kind: 'slider', min: 1, max: 4, step: 0.05, initial: 1 },
  ],
  async compute(client, settings) {
    const mesh = await client.make({ shape: 'grid', nx: 2, ny: 2, ...sizeOf(settings) });
    try {
      const [a, b] = await Promise.all([
        ask(mesh, { id: 'alexa-wardetzky', lambda: Number(settings.lambda) }),
        ask(mesh, { id: 'planar' }),
      ]);
      const { positions, offsets, corners } = mesh.geometry;
      const points = Array.from({ length: mesh.vertices }, (_, v) => flat(positions, v));
      const faces = Array.from({ length: mesh.faces }, (_, f) => [...corners.subarray(offsets[f], offsets[f + 1])]);
      return { points, faces, a, b };
    } finally {
      await mesh.close();
    }
  },
  draw: (data, _settings, say) => picture(data, data.a, say('draw.a'), say) + picture(data, data.b, say('draw.b'), say),
  read: ({ a, b }) => [
    { id: 'a', value: a.value, text: fixed(a.value, 4), bad: isOutside(a.value) },
    { id: 'b', value: b.value, text: fixed(b.value, 4), bad: isOutside(b.value) },
    { id: 'edge', ...weightOf(a, 1) },
    { id: 'edge-b', ...weightOf(b, 1) },
    { id: 'diagonal', ...weightOf(a, 0) },
    { id: 'diagonal-b', ...weightOf(b, 0) },
  ],
  state: (settings) => {
    const { width, height } = sizeOf(settings);
    return stateWith(({ sides, harmonic }) => ({
      task: 'harmonic',
      source: gridSource(2, 2, width, height),
      sides: { ...sides, a: choice('alexa-wardetzky', { lambda: Number(settings.lambda) }) },
      harmonic: { ...harmonic, pins },
      selected: middle,
    }));
  },
});

const rounding = 1e-9;
const isOutside = (value: number): boolean => value > 1 + rounding || value < -rounding;

function weightOf({ weights }: Side, vertex: number) {
  const value = weights.get(vertex) ?? 0;
  return { value, text: fixed(value), bad: value < -rounding };
}

const [width, height] = [360, 376];

/** The four faces, what is pinned, the row of the middle, and its value on a scale. */
function picture({ points, faces }: Data, side: Side, title: string, say: Say): string {
  const ys = points.map(([, y]) => y);
  const frame = plane({
    x: [-1, 1],
    y: [Math.min(...ys), Math.max(...ys)],
    width,
    height,
    margin: [76, 92, 68, 34],
  });
  const at = points.map(frame.at);
  const place = (vertex: number): Point => at[vertex] ?? [0, 0];
  const hub = place(middle);
  const largest = Math.max(...[...side.weights.values()].map(Math.abs));
  const spokes = [...side.weights]
    .filter(([, w]) => Math.abs(w) > rounding)
    .map(([vertex, w]) =>
      line(hub, place(vertex), w < 0 ? 'spoke minus' : 'spoke', Math.max(1.5, (7 * Math.abs(w)) / largest)),
    );
  const rims = pins.map(({ vertex, value }) => circle(place(vertex), 5, value === 1 ? 'point' : 'point-open'));
  const numbers = pins.map(({ vertex, value }) => {
    const [x, y] = place(vertex);
    const away: Point = [Math.sign(x - hub[0]), Math.sign(y - hub[1])];
    const reach = away[0] && away[1] ? 14 : 17;
    return text([x + reach * away[0], y + reach * away[1]], String(value));
  });
  return svg(
    width,
    height,
    text([0, 12], title, 'title', 'start'),
    group('', ...faces.map((face) => polygon(face.map(place), 'face'))),
    group('', ...faces.map((face) => polygon(face.map(place), 'edge'))),
    ...spokes,
    ...rims,
    ...numbers,
    circle(hub, 9, 'hub'),
    weightLegend(side),
    scale(side.value, say),
  );
}

/** Of an edge each way and of a diagonal, below the drawing, where there is always room: the others have the same. */
function weightLegend({ weights }: Side): string {
  const y = height - 14;
  const samples: [number, Point][] = [
    [7, [0, -9]],
    [5, [9, 0]],
    [8, [8, -8]],
  ];
  return samples
    .map(([vertex, [dx, dy]], k) => {
      const w = weights.get(vertex) ?? 0;
      const x = 44 + 92 * k;
      const isNegative = w < -rounding;
      const sample = line([x - dx, y - dy], [x + dx, y + dy], isNegative ? 'spoke minus' : 'spoke', 3);
      return sample + text([x + 17, y], fixed(w, 3), isNegative ? 'bad' : '', 'start');
    })
    .join('');
}

/** From 0 to 2, with the range of what is pinned. */
function scale(value: number, say: Say): string {
  const [x, top, bottom] = [width - 34, 76, height - 68];
  const y = (v: number): number => bottom + ((top - bottom) * v) / 2;
  const shown = Math.max(0, Math.min(2, value));
  return group(
    '',
    rectangle([x - 5, y(1)], 10, y(0) - y(1), 'bar-range'),
    line([x, y(0)], [x, y(2)], 'thin'),
    ...[0, 1, 2].map(
      (v) => line([x - 5, y(v)], [x + 5, y(v)], 'thin') + text([x + 17, y(v)], String(v), 'small quiet', 'start'),
    ),
    line([x - 11, y(shown)], [x + 11, y(shown)], isOutside(value) ? 'edge-negative' : 'thick'),
    text([width - 10, 14], fixed(value, 3), isOutside(value) ? 'loud bad' : 'loud', 'end'),
    text([width - 10, 36], say('draw.middle'), 'small quiet', 'end'),
  );
}
