// Made from the operator table by wasm/generate.mjs; do not edit.
import type { OperatorInfo } from './types.js';

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
    claims: {
      symmetric: 'yes',
      positiveSemidefinite: 'yes',
      constantsInKernel: 'yes',
      linearPrecision: 'yes',
      positiveWeights: 'no',
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
    claims: {
      symmetric: 'yes',
      positiveSemidefinite: 'yes',
      constantsInKernel: 'yes',
      linearPrecision: 'yes',
      positiveWeights: 'no',
    },
    formulaMathml: '<math display="block" class="tml-display"><mrow><msub><mi>w</mi><mrow><mi>i</mi><mi>j</mi></mrow></msub><mo>=</mo><mstyle displaystyle="false" scriptlevel="0"><mfrac><mn>1</mn><mn>2</mn></mfrac></mstyle><mrow><mo fence="true" form="prefix" stretchy="true">(</mo><mrow><mi>cot</mi><mo>⁡</mo><mspace width="0.1667em"></mspace></mrow><msub><mi>γ</mi><mrow><mi>i</mi><mi>j</mi></mrow></msub><mo>+</mo><mrow><mi>cot</mi><mo>⁡</mo><mspace width="0.1667em"></mspace></mrow><msub><mi>γ</mi><mrow><mi>j</mi><mi>i</mi></mrow></msub><mo fence="true" form="postfix" stretchy="true">)</mo></mrow></mrow></math>',
  },
];
