// Made from the tables of the core by wasm/generate.mjs; do not edit.
import type { MakerInfo, OperatorInfo, PropertyInfo } from './types.js';

export type ErrorCode =
  | 'bad-argument'
  | 'parse-error'
  | 'bad-mesh'
  | 'non-manifold-edge'
  | 'open-mesh'
  | 'degenerate-face'
  | 'unknown-operator'
  | 'parameter-out-of-range'
  | 'mass-not-positive'
  | 'not-positive-definite'
  | 'unconstrained-component'
  | 'not-converged'
  | 'cancelled'
  | 'out-of-memory';

export type PropertyId =
  | 'symmetric'
  | 'local'
  | 'positiveWeights'
  | 'positiveSemidefinite'
  | 'constantsInKernel'
  | 'linearPrecision'
  | 'maximumPrinciple'
  | 'convergent';

export type OperatorId =
  | 'alexa-wardetzky'
  | 'planar';

/** Alexa–Wardetzky. Edge vectors against the vector area of each face, stabilised by λ where they see nothing. */
export interface AlexaWardetzkySpec {
  id: 'alexa-wardetzky';
  /** λ; λ = ½ is the five-point star on squares; in [0, 1000000]; default 1. */
  lambda?: number;
}

/** Planar. Each face is projected along its vector area and triangulated there; the cotangents of its triangles are summed. */
export interface PlanarSpec {
  id: 'planar';
  /** rule; how the projected face is triangulated; default delaunay. */
  rule?: 'delaunay' | 'min-max-angle' | 'shortest-diagonal' | 'fan';
}

/** Which operator, with which parameters; what is left out takes its default. */
export type OperatorSpec = AlexaWardetzkySpec | PlanarSpec;

/** Grid. Equal rectangles on a rectangle of the plane. */
export interface GridShape {
  shape: 'grid';
  /** cells along x; whole, in [1, 2000]; default 8. */
  nx?: number;
  /** cells along y; whole, in [1, 2000]; default 8. */
  ny?: number;
  /** width; in [0.01, 1000000]; default 1. */
  width?: number;
  /** height; in [0.01, 1000000]; default 1. */
  height?: number;
  /** Noise along the normals, in mean edge lengths; default 0. */
  noise?: number;
  /** Of the noise; a whole number below 2³²; default 1. */
  seed?: number;
}

/** Saddle. A square grid lifted to x² − y²: none of its quads is planar. */
export interface SaddleShape {
  shape: 'saddle';
  /** cells a side; whole, in [1, 2000]; default 12. */
  n?: number;
  /** height; from the lowest to the highest corner; in [0, 1000000]; default 1. */
  height?: number;
  /** Noise along the normals, in mean edge lengths; default 0. */
  noise?: number;
  /** Of the noise; a whole number below 2³²; default 1. */
  seed?: number;
}

/** Torus. Planar quads around a ring; closed. */
export interface TorusShape {
  shape: 'torus';
  /** quads around the hole; whole, in [3, 2000]; default 32. */
  nu?: number;
  /** quads around the tube; whole, in [3, 2000]; default 16. */
  nv?: number;
  /** radius of the ring; in [0.01, 1000000]; default 1. */
  major?: number;
  /** radius of the tube; in [0.01, 1000000]; default 0.4. */
  minor?: number;
  /** Noise along the normals, in mean edge lengths; default 0. */
  noise?: number;
  /** Of the noise; a whole number below 2³²; default 1. */
  seed?: number;
}

/** Which shape to make; what is left out takes its default. */
export type ShapeSpec = GridShape | SaddleShape | TorusShape;

/** Dual mesh. A vertex for each face, a face for each inner vertex. */
export interface DualConversion {
  conversion: 'dual';
}

/** What to make of a mesh; what is left out takes its default. */
export type ConversionSpec = DualConversion;

/** The operator table, in the order of menus. */
export const operators: readonly OperatorInfo[] = [
  {
    id: 'alexa-wardetzky',
    label: 'Alexa–Wardetzky',
    summary: 'Edge vectors against the vector area of each face, stabilised by λ where they see nothing.',
    formulaLatex: 'S_f = \\delta^{\\mathrm T}\\Bigl(\\tfrac{1}{|a|}\\,B B^{\\mathrm T} + \\lambda\\, C C^{\\mathrm T}\\Bigr)\\delta',
    citation: 'M. Alexa, M. Wardetzky: Discrete Laplacians on general polygonal meshes. ACM Trans. Graph. 30(4), 2011; Herholz 2012, eq. 4.29',
    parameters: [
      {
        id: 'lambda',
        label: 'λ',
        hint: 'λ = ½ is the five-point star on squares',
        kind: 'real',
        min: 0,
        max: 1000000,
        sliderMax: 2,
        step: 0.01,
        initial: 1,
      },
    ],
    takesVertexWeights: false,
    claims: {
      symmetric: {
        where: 'yes',
        why: 'a sum of symmetric matrices of faces',
      },
      local: {
        where: 'yes',
        why: 'a sum over faces',
      },
      positiveWeights: {
        where: 'no',
        why: 'λ > ½ makes every diagonal of a square negative',
      },
      positiveSemidefinite: {
        where: 'yes',
        why: 'a sum of squares; λ = 0 has more in its kernel than constants',
      },
      constantsInKernel: {
        where: 'yes',
        why: 'only differences along edges enter',
      },
      linearPrecision: {
        where: 'yes',
        why: 'on planar faces S x is the gradient of the area',
      },
      maximumPrinciple: {
        where: 'no',
        why: 'negative weights let values overshoot',
      },
      convergent: {
        where: 'yes',
        why: 'consistent on linear functions, stabilised by λ > 0',
      },
    },
    formulaMathml: '<math display="block" class="tml-display"><mrow><msub><mi>S</mi><mi>f</mi></msub><mo>=</mo><msup><mi>δ</mi><mrow><mi mathvariant="normal">T</mi><mspace></mspace></mrow></msup><mo fence="true" symmetric="true" minsize="1.8em" maxsize="1.8em">(</mo><mstyle displaystyle="false" scriptlevel="0"><mfrac><mn>1</mn><mrow><mi>|</mi><mi>a</mi><mi>|</mi></mrow></mfrac></mstyle><mspace width="0.1667em"></mspace><mi>B</mi><msup><mi>B</mi><mrow class="tml-med-pad"><mi mathvariant="normal">T</mi><mspace></mspace></mrow></msup><mo>+</mo><mi>λ</mi><mspace width="0.1667em"></mspace><mi>C</mi><msup><mi>C</mi><mrow class="tml-med-pad"><mi mathvariant="normal">T</mi><mspace></mspace></mrow></msup><mo fence="true" symmetric="true" minsize="1.8em" maxsize="1.8em">)</mo><mi>δ</mi></mrow></math>',
  },
  {
    id: 'planar',
    label: 'Planar',
    summary: 'Each face is projected along its vector area and triangulated there; the cotangents of its triangles are summed.',
    formulaLatex: 'w_{ij} = \\tfrac12\\left(\\cot\\gamma_{ij} + \\cot\\gamma_{ji}\\right)',
    citation: 'P. Herholz: General discrete Laplace operators on polygonal meshes. Diploma thesis, Humboldt-Universität zu Berlin, 2012, section 4.2.4',
    parameters: [
      {
        id: 'rule',
        label: 'rule',
        hint: 'how the projected face is triangulated',
        kind: 'choice',
        choices: [
          'delaunay',
          'min-max-angle',
          'shortest-diagonal',
          'fan',
        ],
        initial: 'delaunay',
      },
    ],
    takesVertexWeights: false,
    claims: {
      symmetric: {
        where: 'yes',
        why: 'cotangents weigh both directions of an edge alike',
      },
      local: {
        where: 'yes',
        why: 'a sum over faces',
      },
      positiveWeights: {
        where: 'no',
        why: 'two angles opposite an edge can exceed 180° in sum',
      },
      positiveSemidefinite: {
        where: 'yes',
        why: 'each triangle adds a Dirichlet energy',
      },
      constantsInKernel: {
        where: 'yes',
        why: 'only differences along edges enter',
      },
      linearPrecision: {
        where: 'yes',
        why: 'planar faces are projected onto themselves',
      },
      maximumPrinciple: {
        where: 'no',
        why: 'a negative weight lets values overshoot',
      },
      convergent: {
        where: 'yes',
        why: 'linear finite elements on the projected triangles',
      },
    },
    formulaMathml: '<math display="block" class="tml-display"><mrow><msub><mi>w</mi><mrow><mi>i</mi><mi>j</mi></mrow></msub><mo>=</mo><mstyle displaystyle="false" scriptlevel="0"><mfrac><mn>1</mn><mn>2</mn></mfrac></mstyle><mrow><mo fence="true" form="prefix" stretchy="true">(</mo><mrow><mi>cot</mi><mo>⁡</mo><mspace width="0.1667em"></mspace></mrow><msub><mi>γ</mi><mrow><mi>i</mi><mi>j</mi></mrow></msub><mo>+</mo><mrow><mi>cot</mi><mo>⁡</mo><mspace width="0.1667em"></mspace></mrow><msub><mi>γ</mi><mrow><mi>j</mi><mi>i</mi></mrow></msub><mo fence="true" form="postfix" stretchy="true">)</mo></mrow></mrow></math>',
  },
];

/** The property table. */
export const properties: readonly PropertyInfo[] = [
  {
    id: 'symmetric',
    label: 'Symmetric',
    meaning: 'S = Sᵀ: as much weight from i to j as back.',
  },
  {
    id: 'local',
    label: 'Local',
    meaning: 'Weights only between vertices that share a face.',
  },
  {
    id: 'positiveWeights',
    label: 'Weights ≥ 0',
    meaning: 'No weight off the diagonal is negative.',
  },
  {
    id: 'positiveSemidefinite',
    label: 'PSD',
    meaning: 'No function has negative Dirichlet energy.',
  },
  {
    id: 'constantsInKernel',
    label: 'S 1 = 0',
    meaning: 'Constant functions have no Laplacian.',
  },
  {
    id: 'linearPrecision',
    label: 'Linear precision',
    meaning: 'Linear functions have no Laplacian at inner vertices whose surroundings lie in one plane.',
  },
  {
    id: 'maximumPrinciple',
    label: 'Maximum principle',
    meaning: 'Harmonic functions stay within the range of their boundary values.',
  },
  {
    id: 'convergent',
    label: 'Convergent',
    meaning: 'Solutions approach the smooth ones under refinement.',
  },
];

/** The shape table, in the order of menus. All shapes take noise and its seed besides their own parameters. */
export const shapes: readonly MakerInfo[] = [
  {
    id: 'grid',
    label: 'Grid',
    summary: 'Equal rectangles on a rectangle of the plane.',
    parameters: [
      {
        id: 'nx',
        label: 'cells along x',
        hint: '',
        kind: 'integer',
        min: 1,
        max: 2000,
        sliderMax: 64,
        step: 1,
        initial: 8,
      },
      {
        id: 'ny',
        label: 'cells along y',
        hint: '',
        kind: 'integer',
        min: 1,
        max: 2000,
        sliderMax: 64,
        step: 1,
        initial: 8,
      },
      {
        id: 'width',
        label: 'width',
        hint: '',
        kind: 'real',
        min: 0.01,
        max: 1000000,
        sliderMax: 10,
        step: 0.01,
        initial: 1,
      },
      {
        id: 'height',
        label: 'height',
        hint: '',
        kind: 'real',
        min: 0.01,
        max: 1000000,
        sliderMax: 10,
        step: 0.01,
        initial: 1,
      },
    ],
  },
  {
    id: 'saddle',
    label: 'Saddle',
    summary: 'A square grid lifted to x² − y²: none of its quads is planar.',
    parameters: [
      {
        id: 'n',
        label: 'cells a side',
        hint: '',
        kind: 'integer',
        min: 1,
        max: 2000,
        sliderMax: 64,
        step: 1,
        initial: 12,
      },
      {
        id: 'height',
        label: 'height',
        hint: 'from the lowest to the highest corner',
        kind: 'real',
        min: 0,
        max: 1000000,
        sliderMax: 4,
        step: 0.01,
        initial: 1,
      },
    ],
  },
  {
    id: 'torus',
    label: 'Torus',
    summary: 'Planar quads around a ring; closed.',
    parameters: [
      {
        id: 'nu',
        label: 'quads around the hole',
        hint: '',
        kind: 'integer',
        min: 3,
        max: 2000,
        sliderMax: 128,
        step: 1,
        initial: 32,
      },
      {
        id: 'nv',
        label: 'quads around the tube',
        hint: '',
        kind: 'integer',
        min: 3,
        max: 2000,
        sliderMax: 64,
        step: 1,
        initial: 16,
      },
      {
        id: 'major',
        label: 'radius of the ring',
        hint: '',
        kind: 'real',
        min: 0.01,
        max: 1000000,
        sliderMax: 10,
        step: 0.01,
        initial: 1,
      },
      {
        id: 'minor',
        label: 'radius of the tube',
        hint: '',
        kind: 'real',
        min: 0.01,
        max: 1000000,
        sliderMax: 10,
        step: 0.01,
        initial: 0.4,
      },
    ],
  },
];

/** The conversion table, in the order of menus. */
export const conversions: readonly MakerInfo[] = [
  {
    id: 'dual',
    label: 'Dual mesh',
    summary: 'A vertex for each face, a face for each inner vertex.',
    parameters: [],
  },
];
