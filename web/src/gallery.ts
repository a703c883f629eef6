/** What the gallery offers, its words in English. The figures are states of the page that show what Herholz 2012 shows there. */
import { moveOf } from './moves.js';
import { shapes } from './polylap.js';
import {
  type Choice,
  forAnotherMesh,
  initialChoice,
  initialParameters,
  initialState,
  presets,
  type Source,
  type State,
} from './state.js';
import { word } from './words.js';

export interface Entry {
  id: string;
  label: string;
  /** What there is to see. */
  look: string;
  /** Where in Herholz 2012. */
  place?: string;
  source: Source;
  /** What belongs to it but the mesh, where that is more than a mesh. */
  figure?: (state: State) => Partial<State>;
}

/** What was measured of an entry when the page was built. */
export interface Facts {
  vertices: number;
  faces: number;
  minCorners: number;
  maxCorners: number;
  /** Negative weights of A and of B, ordered pairs; null where an operator refuses the mesh. */
  negative: readonly (number | null)[];
  /** Beside the page. */
  picture: string;
}

export interface Group {
  label: string;
  entries: readonly Entry[];
}

/** The state that an entry leads to. */
export function stateOf({ source, figure }: Entry, now: State): State {
  if (!figure) return { ...now, ...forAnotherMesh(now), source };
  const start: State = { ...initialState(), theme: now.theme, source };
  return { ...start, ...figure(start) };
}

const preset = (id: string): Source => ({ kind: 'preset', id });

export const choice = (operator: string, parameters: Choice['parameters'] = {}): Choice => {
  const initial = initialChoice(operator);
  return { ...initial, parameters: { ...initial.parameters, ...parameters } };
};

/** The vertices of a grid of n × n squares in rows; on its rim, 1 where `isOne` says so and otherwise 0. */
export function rim(n: number, isOne: (i: number, j: number) => boolean): State['harmonic']['pins'] {
  const at = Array.from(
    { length: (n + 1) ** 2 },
    (_, vertex) => [vertex % (n + 1), Math.floor(vertex / (n + 1))] as const,
  );
  return at.flatMap(([i, j], vertex) => (i % n === 0 || j % n === 0 ? [{ vertex, value: isOne(i, j) ? 1 : 0 }] : []));
}

const figures: readonly Entry[] = [
  {
    id: 'one-interior-vertex',
    label: word('One interior vertex'),
    look: word('A gives the middle 4λ/(1 + 2λ): more than any pin once λ > ½. B gives 1.'),
    place: word('Fig. 4.9'),
    source: preset('grid-2'),
    figure: ({ harmonic }) => ({
      task: 'harmonic',
      harmonic: { ...harmonic, pins: rim(2, (i, j) => i === 1 || j === 1) },
      selected: 4,
    }),
  },
  {
    id: 'maximum-principle',
    label: word('The maximum principle fails'),
    look: word('One corner is 1, the rest of the rim 0. A dips below 0 inside; at λ = ½ the dip is gone. B has none.'),
    source: preset('grid-8'),
    figure: ({ harmonic }) => ({
      task: 'harmonic',
      harmonic: { ...harmonic, pins: rim(8, (i, j) => i === 8 && j === 8) },
      selected: 70,
    }),
  },
  {
    id: 'quad-bunny',
    label: word('Negative weights'),
    look: word('Nearly every diagonal of a quad is negative for A; B keeps to what Delaunay leaves.'),
    place: word('p. 31'),
    source: preset('bunny'),
    figure: () => ({}),
  },
  {
    id: 'quad-bunny-noisy',
    label: word('Negative weights under noise'),
    look: word('The same bunny, shaken along its normals: no face is flat any more, and B still has few.'),
    place: word('p. 31'),
    source: preset('noisy-bunny'),
    figure: () => ({}),
  },
  {
    id: 'smoothing',
    label: word('Noise smoothed away'),
    look: word('After ten steps A and B look alike; what tells them apart is shown tenfold.'),
    place: word('Figs. 4.7, 4.8'),
    source: preset('noisy-torus'),
    figure: (state) => ({
      task: 'smooth',
      moves: [{ ...moveOf(state), steps: 10 }],
      step: 10,
      delta: { ...state.delta, open: true, gain: 10 },
    }),
  },
  {
    id: 'two-cuts',
    label: word('Two triangulations of a quad'),
    look: word('Cut along one diagonal the quad has a negative weight; Delaunay takes the other one.'),
    place: word('Fig. 4.6'),
    source: preset('quad'),
    figure: () => ({
      sides: { a: choice('planar', { rule: 'fan' }), b: choice('planar') },
      // On the cut of B.
      selected: 1,
      selectedFace: 0,
    }),
  },
  {
    id: 'orthogonal-dual',
    label: word('Orthogonal dual'),
    look: word('Each dual edge is at right angles to its edge. How far had the dual vertices to move for it?'),
    place: word('Figs. 4.2, 4.3'),
    source: preset('noisy-torus'),
    figure: () => ({ task: 'dual', sides: { a: choice('orthogonal-dual'), b: choice('planar') } }),
  },
  {
    id: 'power-weights',
    label: word('Vertex weights change the row'),
    look: word(
      'A weight ω at a vertex changes the weights of its edges (drag it); linear functions stay harmonic, and large ω turns weights negative.',
    ),
    place: word('Fig. 3.5'),
    source: {
      kind: 'shape',
      shape: { id: 'voronoi', parameters: { nx: 5, ny: 5, jitter: 0.5, seed: 1 } },
      changes: [{ id: 'dual', parameters: {}, side: 'a', moves: [] }],
    },
    figure: (state) => ({
      sides: { a: choice('weighted-cotan'), b: choice('cotan') },
      vertexWeights: { ...state.vertexWeights, a: { 12: 0.01 } },
      selected: 12,
    }),
  },
  {
    id: 'vector-area',
    label: word('Vector area'),
    look: word(
      'A hexagon in no plane: its vector area is that of its largest projection, and only this is what B triangulates.',
    ),
    place: word('Fig. 4.4'),
    source: { kind: 'shape', shape: { id: 'wavy-polygon', parameters: { n: 6, height: 0.5 } } },
    figure: () => ({ selected: 0, selectedFace: 0 }),
  },
  {
    id: 'checkerboard',
    label: word('A checkerboard that A takes for constant'),
    look: word('Without its stabiliser (λ = 0) the kernel of A has two dimensions; the other function is drawn.'),
    source: preset('grid-8'),
    figure: (state) => ({
      task: 'check',
      sides: { a: choice('alexa-wardetzky', { lambda: 0 }), b: state.sides.b },
      mode: { a: 1, b: null },
    }),
  },
];

const example = (id: string, look: string): Entry => ({
  id,
  label: presets.find((entry) => entry.id === id)?.label ?? id,
  look,
  source: preset(id),
});

export const groups: readonly Group[] = [
  { label: word('Figures of the thesis'), entries: figures },
  {
    label: word('Examples'),
    entries: [
      example('noisy-torus', word('A has a negative weight on every diagonal, B none at all.')),
      example('noisy-saddle', word('An open surface: smoothing pulls its rim in.')),
      example('bunny', word('A closed surface, nearly everywhere smooth.')),
      example('noisy-bunny', word('The same with noise on it, to smooth away.')),
      example('soup', word('Pieces with dents that touch nowhere: every operator takes any simple polygon.')),
      example('patchwork', word('A closed surface of concave faces with many corners each, in no plane.')),
    ],
  },
  {
    label: word('Shapes'),
    entries: shapes.map((shape) => ({
      id: `shape-${shape.id}`,
      label: shape.label,
      look: shape.summary,
      source: { kind: 'shape', shape: { id: shape.id, parameters: initialParameters(shape) } },
    })),
  },
];
