/** One corner is 1, the rest of the rim is 0, and inside there is less than 0. */
import type { Harmonic } from '../../src/polylap.js';
import { choice, fixedValues, gridSource, rim, stateWith } from '../common.js';
import { drawn, type Point, type Say } from '../figure.js';
import { circle, fixed, group, line, plane, rectangle, svg, text } from '../svg.js';

const n = 8;
const pins = rim(n, (i, j) => i === n && j === n);
const pinned = new Set(pins.map(({ vertex }) => vertex));

interface Side {
  /** By vertex, in rows. */
  values: number[];
  outside: number;
  smallest: number;
  largest: number;
}

interface Data {
  a: Side;
  b: Side;
}

const sideOf = ({ values, outside }: Harmonic): Side => {
  const inside = [...values].filter((_, vertex) => !pinned.has(vertex));
  return {
    values: [...values],
    outside: outside.length,
    smallest: Math.min(...inside),
    largest: Math.max(...inside),
  };
};

/** Beside the 1 of the corner. */
const rounding = 1e-12;
const cleared = (value: number): number => (Math.abs(value) < rounding ? 0 : value);

export const figure = drawn<Data>({
  id: 'maximum-principle',
  number: 7,
  controls: [{ id: 'lambda', kind: 'slider', min: 0.1, max: 2, step: 0.01, initial: 1 }],
  async compute(client, { lambda }) {
    const mesh = await client.make({ shape: 'grid', nx: n, ny: n, width: n, height: n });
    try {
      const fixedTo = fixedValues(pins);
      const [a, b] = await Promise.all([
        mesh.harmonic({ id: 'alexa-wardetzky', lambda: Number(lambda) }, fixedTo),
        mesh.harmonic({ id: 'planar' }, fixedTo, { side: 'b' }),
      ]);
      return { a: sideOf(a), b: sideOf(b) };
    } finally {
      await mesh.close();
    }
  },
  draw: ({ a, b }, _settings, say) => picture(a, say('draw.a'), say) + picture(b, say('draw.b'), say),
  read: ({ a, b }) =>
    (['smallest', 'largest', 'outside'] as const).flatMap((id) =>
      [a, b].map((side, k) => ({
        id: k === 0 ? id : `${id}-b`,
        value: cleared(side[id]),
        text: id === 'outside' ? String(side.outside) : fixed(side[id], 4),
        bad:
          id === 'largest'
            ? side.largest > 1 + rounding
            : id === 'outside'
              ? side.outside > 0
              : side.smallest < -rounding,
      })),
    ),
  state: ({ lambda }) =>
    stateWith(({ sides, harmonic }) => ({
      task: 'harmonic',
      source: gridSource(n, n),
      sides: { ...sides, a: choice('alexa-wardetzky', { lambda: Number(lambda) }) },
      harmonic: { ...harmonic, pins },
      selected: 70,
    })),
});

const [width, height] = [360, 424];
/** Radius of the ball of 1, in pixels; and of what is only just not 0. */
const [largest, smallest] = [15, 3];

/** The grid with a ball at each vertex: its volume is the value. */
function picture(side: Side, title: string, say: Say): string {
  const frame = plane({ x: [0, n], y: [0, n], width, height, margin: [66, 18, 44, 18] });
  const lines = Array.from({ length: n + 1 }, (_, k) => [
    line(frame.at([0, k]), frame.at([n, k]), 'thin'),
    line(frame.at([k, 0]), frame.at([k, n]), 'thin'),
  ]).flat();
  const [x, y] = frame.at([0, n]);
  const discs = side.values.map((value, vertex) => disc(frame.at(placeOf(vertex)), value));
  const fails = side.smallest < -rounding;
  return svg(
    width,
    height,
    text([0, 14], title, 'title', 'start'),
    text([width - 4, 14], fixed(side.smallest, 3), fails ? 'loud bad' : 'loud', 'end'),
    text([width - 4, 37], say('draw.smallest'), 'small quiet', 'end'),
    rectangle([x, y], n * frame.scale, n * frame.scale, 'face'),
    group('', ...lines),
    group('', ...discs),
    legend(say),
  );
}

const placeOf = (vertex: number): Point => [vertex % (n + 1), Math.floor(vertex / (n + 1))];

function disc(at: Point, value: number): string {
  const radius = radiusOf(value);
  if (radius === 0) return circle(at, 1.5, 'value-zero');
  return circle(at, radius, value > 0 ? 'value-positive' : radius < 5 ? 'value-negative small' : 'value-negative');
}

const radiusOf = (value: number): number =>
  Math.abs(value) < rounding ? 0 : Math.max(smallest, largest * Math.cbrt(Math.abs(value)));

function legend(say: Say): string {
  const y = height - 16;
  const entries: [number, string][] = [
    [1, '1'],
    [0.1, fixed(0.1, 1)],
    [0, '0'],
    [-0.1, fixed(-0.1, 1)],
  ];
  const shown = entries.map(([value, label], k) => {
    const x = 136 + 57 * k;
    return disc([x, y], value) + text([x + radiusOf(value) + 6, y], label, 'small quiet', 'start');
  });
  return group('', text([4, y], say('draw.volume'), 'small quiet', 'start'), ...shown);
}
