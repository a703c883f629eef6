/** What the operator without its stabiliser takes for constant. */
import type { Matrices, Mesh, OperatorSpec, ShapeSpec } from '../../src/polylap.js';
import { choice, stateWith } from '../common.js';
import { drawn, type Point, type Say, type Settings } from '../figure.js';
import { arrow, circle, fixed, group, line, plane, polygon, polyline, svg, text } from '../svg.js';

interface Example {
  /** Faces across and up. */
  size: readonly [number, number];
  /** A torus is cut open for the drawing: its first row and column are drawn again as the last. */
  closed: boolean;
  shape: ShapeSpec & { shape: 'grid' | 'torus' };
  /** The vertex at a place of the drawing. */
  vertex: (i: number, j: number) => number;
}

const torus = (nu: number, nv: number): Example => ({
  size: [nu, nv],
  closed: true,
  shape: { shape: 'torus', nu, nv },
  vertex: (i, j) => (i % nu) * nv + (j % nv),
});

const examples: Readonly<Record<string, Example>> = {
  grid: {
    size: [8, 8],
    closed: false,
    shape: { shape: 'grid', nx: 8, ny: 8, width: 8, height: 8 },
    vertex: (i, j) => 9 * j + i,
  },
  even: torus(16, 8),
  odd: torus(15, 9),
};

const exampleOf = ({ mesh }: Settings): Example => examples[String(mesh)] as Example;

interface Data {
  kernel: number;
  /** By vertex: the second kernel function, or where there is none the checkerboard as far as it goes. */
  values: number[];
  /** uᵀ S u of the checkerboard for λ = 0, as set, and for the largest λ. */
  energy: { bare: number; now: number; full: number };
  faces: number;
}

const lambdaMax = 1;

/** 1 and −1 in turns. */
function checkerboard({ size: [nu, nv], closed, vertex }: Example, vertices: number): number[] {
  const values = new Array<number>(vertices).fill(0);
  const [wide, high] = closed ? [nu, nv] : [nu + 1, nv + 1];
  for (let i = 0; i < wide; i++) for (let j = 0; j < high; j++) values[vertex(i, j)] = (i + j) % 2 === 0 ? 1 : -1;
  return values;
}

/** uᵀ S u. */
function energyOf({ stiffness }: Matrices, u: readonly number[]): number {
  const { colStarts, rowIndices, values } = stiffness;
  let sum = 0;
  for (let column = 0; column < stiffness.cols; column++)
    for (let k = colStarts[column] as number; k < (colStarts[column + 1] as number); k++)
      sum += (u[column] as number) * (values[k] as number) * (u[rowIndices[k] as number] as number);
  return sum;
}

/** Beside the diagonals of S, which sum to some hundreds. */
const rounding = 1e-9;
const cleared = (value: number): number => (Math.abs(value) < rounding ? 0 : value);

const specOf = (lambda: number): OperatorSpec => ({ id: 'alexa-wardetzky', lambda });

async function measure(mesh: Mesh, example: Example, lambda: number): Promise<Data> {
  const board = checkerboard(example, mesh.vertices);
  const energy = async (at: number) => cleared(energyOf(await mesh.matrices(specOf(at)), board));
  const [{ kernelDimension, kernelModes }, bare, now, full] = await Promise.all([
    mesh.check(specOf(lambda)),
    ...[0, lambda, lambdaMax].map(energy),
  ]);
  const mode = kernelModes[1];
  const largest = mode ? Math.max(...mode.map(Math.abs)) : 1;
  // Of the mode and its negative, the one that begins like the checkerboard.
  const scale = mode ? largest * Math.sign(mode[0] || 1) : 1;
  const values = mode ? [...mode].map((value) => value / scale) : board;
  return {
    kernel: kernelDimension,
    values,
    energy: { bare: bare as number, now: now as number, full: full as number },
    faces: mesh.faces,
  };
}

export const figure = drawn<Data>({
  id: 'checkerboard',
  number: 5,
  controls: [
    { id: 'mesh', kind: 'choice', choices: Object.keys(examples), initial: 'grid' },
    { id: 'lambda', kind: 'slider', min: 0, max: lambdaMax, step: 0.01, initial: 0 },
  ],
  async compute(client, settings) {
    const example = exampleOf(settings);
    const mesh = await client.make(example.shape);
    try {
      return await measure(mesh, example, Number(settings.lambda));
    } finally {
      await mesh.close();
    }
  },
  draw: (data, settings, say) => board(data, settings, say) + chart(data, settings, say),
  read: ({ kernel, energy, faces }) => [
    { id: 'kernel', value: kernel, text: String(kernel), bad: kernel > 1 },
    { id: 'energy', value: energy.now / faces, text: fixed(energy.now / faces, 3), bad: energy.now === 0 },
    { id: 'bare', value: energy.bare / faces, text: fixed(energy.bare / faces, 3), bad: energy.bare === 0 },
  ],
  state: (settings) => {
    const { shape, ...parameters } = exampleOf(settings).shape;
    const lambda = Number(settings.lambda);
    return stateWith(({ sides }) => ({
      task: 'check',
      source: { kind: 'shape', shape: { id: shape, parameters: parameters as Record<string, number> } },
      sides: { ...sides, a: choice('alexa-wardetzky', { lambda }) },
      mode: { a: lambda === 0 && settings.mesh !== 'odd' ? 1 : null, b: null },
    }));
  },
});

const [width, height] = [400, 340];

/** The mesh, a torus cut open, with a disc at each vertex: full above 0, hollow below. */
function board({ values, kernel }: Data, settings: Settings, say: Say): string {
  const example = exampleOf(settings);
  const [nu, nv] = example.size;
  const frame = plane({ x: [0, nu], y: [0, nv], width, height, margin: [52, 24, 34, 24] });
  const at = (i: number, j: number): Point => frame.at([i, j]);
  const value = (i: number, j: number): number => values[example.vertex(i, j)] as number;
  const lines = [
    ...Array.from({ length: nu + 1 }, (_, i) => line(at(i, 0), at(i, nv), 'thin')),
    ...Array.from({ length: nv + 1 }, (_, j) => line(at(0, j), at(nu, j), 'thin')),
  ];
  const clashes: string[] = [];
  const discs: string[] = [];
  for (let i = 0; i <= nu; i++)
    for (let j = 0; j <= nv; j++) {
      const radius = Math.max(2, 0.27 * frame.scale * Math.sqrt(Math.abs(value(i, j))));
      discs.push(circle(at(i, j), radius, value(i, j) > 0 ? 'value-positive' : 'value-negative'));
      // Two alike side by side: the pattern does not close.
      if (i < nu && value(i, j) * value(i + 1, j) > 0) clashes.push(line(at(i, j), at(i + 1, j), 'accent-line'));
      if (j < nv && value(i, j) * value(i, j + 1) > 0) clashes.push(line(at(i, j), at(i, j + 1), 'accent-line'));
    }
  const title = kernel > 1 ? say('draw.second') : say('draw.board');
  return svg(
    width,
    height,
    text([0, 14], title, 'title', 'start'),
    text([width - 4, 16], String(kernel), kernel > 1 ? 'loud bad' : 'loud', 'end'),
    text([width - 30, 16], say('draw.kernel'), 'small quiet', 'end'),
    polygon([at(0, 0), at(nu, 0), at(nu, nv), at(0, nv)], 'face'),
    group('', ...lines),
    example.closed ? seams(at, nu, nv) : '',
    group('', ...clashes),
    group('', ...discs),
    text([width / 2, height - 10], example.closed ? say('draw.glued') : say('draw.flat'), 'small quiet'),
  );
}

/** Sides with the same arrows are one and the same line of the torus. */
function seams(at: (i: number, j: number) => Point, nu: number, nv: number): string {
  const across = ([x, y]: Point, dx: number, dy: number): Point => [x + dx, y + dy];
  const single = [0, nv].map((j) => {
    const dy = j === 0 ? 13 : -13;
    return arrow(across(at(0.42 * nu, j), 0, dy), across(at(0.58 * nu, j), 0, dy), 'quiet', { size: 7 });
  });
  const double = [0, nu].map((i) => {
    const dx = i === 0 ? -13 : 13;
    const [low, high] = [across(at(i, 0.4 * nv), dx, 0), across(at(i, 0.6 * nv), dx, 0)];
    const second: Point = [high[0], high[1] + 7];
    return arrow(low, high, 'quiet', { size: 7 }) + arrow(low, second, 'quiet', { size: 7 });
  });
  return group('', ...single, ...double);
}

/** The energy of the checkerboard per face, over λ: a straight line. */
function chart({ energy, faces }: Data, { lambda }: Settings, say: Say): string {
  const [left, right, top, bottom] = [46, width - 18, 60, height - 46];
  const largest = 18;
  const x = (at: number): number => left + ((right - left) * at) / lambdaMax;
  const y = (value: number): number => bottom - ((bottom - top) * value) / largest;
  const per = (value: number): number => value / faces;
  const now: Point = [x(Number(lambda)), y(per(energy.now))];
  const ticks = [0, 4, 8, 12, 16].map(
    (value) =>
      line([left, y(value)], [right, y(value)], 'hair') +
      text([left - 9, y(value)], String(value), 'small quiet', 'end'),
  );
  const steps = [0, 0.5, 1].map((value) => text([x(value), bottom + 16], String(value), 'small quiet'));
  return svg(
    width,
    height,
    text([0, 14], say('draw.energy'), 'title', 'start'),
    text([width - 4, 16], fixed(per(energy.now), 2), energy.now === 0 ? 'loud bad' : 'loud', 'end'),
    ...ticks,
    ...steps,
    text([right, bottom + 34], 'λ', 'variable', 'end'),
    line([left, bottom], [right, bottom], 'thin'),
    polyline(
      [
        [x(0), y(per(energy.bare))],
        [x(lambdaMax), y(per(energy.full))],
      ],
      'accent-line',
    ),
    line([now[0], bottom], now, 'dotted'),
    circle(now, 6, energy.now === 0 ? 'value-negative' : 'point-accent'),
  );
}
