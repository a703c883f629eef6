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
  | 'out-of-memory'
  | 'not-included';

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
  | 'umbrella'
  | 'tutte'
  | 'normalized-graph'
  | 'cotan'
  | 'weighted-cotan'
  | 'alexa-wardetzky'
  | 'alexa-wardetzky-weighted'
  | 'planar'
  | 'orthogonal-dual';

/** Umbrella. The graph Laplacian of the edges: every neighbour counts alike, wherever it lies. */
export interface UmbrellaSpec {
  id: 'umbrella';
}

/** Tutte. The difference of each value from the mean of its neighbours along edges. */
export interface TutteSpec {
  id: 'tutte';
}

/** Normalised graph. The graph Laplacian, scaled symmetrically by the numbers of neighbours. */
export interface NormalizedGraphSpec {
  id: 'normalized-graph';
}

/** Cotan. Linear finite elements on the triangles that the faces are cut into, in space. */
export interface CotanSpec {
  id: 'cotan';
  /** rule; how faces are cut into triangles; default delaunay. */
  rule?: 'delaunay' | 'min-max-angle' | 'shortest-diagonal' | 'fan';
  /** mass; how much area each vertex gets; default lumped. */
  mass?: 'lumped' | 'barycentric' | 'ring' | 'circumcentric' | 'mixed-voronoi' | 'galerkin';
}

/** Cotan, weighted. Dual over primal lengths, as for the cotan operator, with dual edges that weights of the vertices move. */
export interface WeightedCotanSpec {
  id: 'weighted-cotan';
  /** rule; how faces are cut into triangles; default delaunay. */
  rule?: 'delaunay' | 'min-max-angle' | 'shortest-diagonal' | 'fan';
  /** mass; how much area each vertex gets; default lumped. */
  mass?: 'lumped' | 'barycentric' | 'ring' | 'circumcentric' | 'mixed-voronoi' | 'galerkin';
  /** ω, one per vertex, length²; default all 0. */
  vertexWeights?: ArrayLike<number>;
}

/** Alexa–Wardetzky. Edge vectors against the vector area of each face, stabilised by λ where they see nothing. */
export interface AlexaWardetzkySpec {
  id: 'alexa-wardetzky';
  /** λ; λ = ½ is the five-point star on squares; in [0, 1000000]; default 1. */
  lambda?: number;
}

/** Alexa–Wardetzky, weighted. Alexa and Wardetzky's operator with points on the edges that weights of the vertices move. */
export interface AlexaWardetzkyWeightedSpec {
  id: 'alexa-wardetzky-weighted';
  /** λ; the stabiliser of the unweighted operator; in [0, 1000000]; default 1. */
  lambda?: number;
  /** ω, one per vertex, length²; default all 0. */
  vertexWeights?: ArrayLike<number>;
}

/** Planar. Each face is projected along its vector area and triangulated there; the cotangents of its triangles are summed. */
export interface PlanarSpec {
  id: 'planar';
  /** rule; how the projected face is triangulated; default delaunay. */
  rule?: 'delaunay' | 'min-max-angle' | 'shortest-diagonal' | 'fan';
}

/** Orthogonal dual. Dual edges are made orthogonal to the edges, with dual vertices as near to the barycentres as that allows; a weight is the signed length of the dual edge over that of the edge. */
export interface OrthogonalDualSpec {
  id: 'orthogonal-dual';
}

/** Which operator, with which parameters; what is left out takes its default. */
export type OperatorSpec = UmbrellaSpec | TutteSpec | NormalizedGraphSpec | CotanSpec | WeightedCotanSpec | AlexaWardetzkySpec | AlexaWardetzkyWeightedSpec | PlanarSpec | OrthogonalDualSpec;

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
  /** Of the noise; whole, below 2³²; default 1. */
  seed?: number;
}

/** Skewed grid. Parallelograms of growing size in the plane. */
export interface SkewGridShape {
  shape: 'skew-grid';
  /** cells along x; whole, in [1, 2000]; default 8. */
  nx?: number;
  /** cells along y; whole, in [1, 2000]; default 8. */
  ny?: number;
  /** shear; how far the upper side is moved along x; in [0, 100]; default 0.5. */
  shear?: number;
  /** stretch; how much faster the spacing is at the end than at the start; in [1, 100]; default 3. */
  stretch?: number;
  /** Noise along the normals, in mean edge lengths; default 0. */
  noise?: number;
  /** Of the noise; whole, below 2³²; default 1. */
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
  /** Of the noise; whole, below 2³²; default 1. */
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
  /** Of the noise; whole, below 2³²; default 1. */
  seed?: number;
}

/** Sphere of meridians. Planar quads, and triangles around both poles. */
export interface UvSphereShape {
  shape: 'uv-sphere';
  /** meridians; whole, in [3, 2000]; default 32. */
  nu?: number;
  /** bands; from pole to pole; whole, in [2, 2000]; default 16. */
  nv?: number;
  /** Noise along the normals, in mean edge lengths; default 0. */
  noise?: number;
  /** Of the noise; whole, below 2³²; default 1. */
  seed?: number;
}

/** Sphere of triangles. An icosahedron whose triangles are cut into four again and again. */
export interface IcoSphereShape {
  shape: 'ico-sphere';
  /** level; how often each triangle is cut into four; whole, in [0, 8]; default 3. */
  level?: number;
  /** Noise along the normals, in mean edge lengths; default 0. */
  noise?: number;
  /** Of the noise; whole, below 2³²; default 1. */
  seed?: number;
}

/** Sphere of hexagons. The dual of the sphere of triangles: twelve pentagons among hexagons. */
export interface HexagonSphereShape {
  shape: 'hexagon-sphere';
  /** level; 0 is the dodecahedron; whole, in [0, 8]; default 3. */
  level?: number;
  /** vertices; on the sphere, or where all faces are flat and touch it; default on-sphere. */
  kind?: 'on-sphere' | 'flat';
  /** Noise along the normals, in mean edge lengths; default 0. */
  noise?: number;
  /** Of the noise; whole, below 2³²; default 1. */
  seed?: number;
}

/** Cube. Squares on the sides of a cube of edge 1. */
export interface CubeShape {
  shape: 'cube';
  /** quads an edge; whole, in [1, 500]; default 8. */
  n?: number;
  /** Noise along the normals, in mean edge lengths; default 0. */
  noise?: number;
  /** Of the noise; whole, below 2³²; default 1. */
  seed?: number;
}

/** Sphere of quads. A cube of n × n quads a side, blown up to a ball. */
export interface CubeSphereShape {
  shape: 'cube-sphere';
  /** quads an edge; whole, in [1, 500]; default 8. */
  n?: number;
  /** Noise along the normals, in mean edge lengths; default 0. */
  noise?: number;
  /** Of the noise; whole, below 2³²; default 1. */
  seed?: number;
}

/** Cylinder. Planar quads around a tube that is open at both ends. */
export interface CylinderShape {
  shape: 'cylinder';
  /** quads around; whole, in [3, 2000]; default 24. */
  nu?: number;
  /** quads along; whole, in [1, 2000]; default 8. */
  nv?: number;
  /** radius; in [0.01, 1000000]; default 0.5. */
  radius?: number;
  /** height; in [0.01, 1000000]; default 1. */
  height?: number;
  /** Noise along the normals, in mean edge lengths; default 0. */
  noise?: number;
  /** Of the noise; whole, below 2³²; default 1. */
  seed?: number;
}

/** Disc. A polygon and rings of planar quads around it. */
export interface DiscShape {
  shape: 'disc';
  /** corners a ring; whole, in [3, 2000]; default 12. */
  n?: number;
  /** rings; whole, in [0, 2000]; default 5. */
  rings?: number;
  /** Noise along the normals, in mean edge lengths; default 0. */
  noise?: number;
  /** Of the noise; whole, below 2³²; default 1. */
  seed?: number;
}

/** Concave hexagons. The plane tiled by hexagons with two concave corners each. */
export interface ConcaveHexagonsShape {
  shape: 'concave-hexagons';
  /** hexagons a row; whole, in [1, 1000]; default 6. */
  nx?: number;
  /** rows; whole, in [1, 2000]; default 12. */
  ny?: number;
  /** depth; how far the long sides are pushed in; 0: bricks; in [0, 0.95]; default 0.4. */
  depth?: number;
  /** Noise along the normals, in mean edge lengths; default 0. */
  noise?: number;
  /** Of the noise; whole, below 2³²; default 1. */
  seed?: number;
}

/** Voronoi cells. Convex polygons of three to about ten corners in a rectangle. */
export interface VoronoiShape {
  shape: 'voronoi';
  /** cells a row; whole, in [1, 1000]; default 12. */
  nx?: number;
  /** rows; whole, in [1, 1000]; default 12. */
  ny?: number;
  /** jitter; how far the sites are shaken; 0: regular hexagons; in [0, 1]; default 0.7. */
  jitter?: number;
  /** seed; another seed, another mesh; the same on every platform; whole, in [0, 2147483647]; default 1. */
  seed?: number;
  /** Noise along the normals, in mean edge lengths; default 0. */
  noise?: number;
}

/** L tiles. A rectangle cut into L-shaped polygons with ten corners each. */
export interface LTilesShape {
  shape: 'l-tiles';
  /** pairs along x; whole, in [1, 500]; default 3. */
  nx?: number;
  /** pairs along y; whole, in [1, 1000]; default 6. */
  ny?: number;
  /** Noise along the normals, in mean edge lengths; default 0. */
  noise?: number;
  /** Of the noise; whole, below 2³²; default 1. */
  seed?: number;
}

/** Tetris. A rectangle cut into T, L, J and S pieces with ten corners each. */
export interface TetrisShape {
  shape: 'tetris';
  /** blocks along x; whole, in [1, 500]; default 3. */
  nx?: number;
  /** blocks along y; whole, in [1, 500]; default 3. */
  ny?: number;
  /** Noise along the normals, in mean edge lengths; default 0. */
  noise?: number;
  /** Of the noise; whole, below 2³²; default 1. */
  seed?: number;
}

/** Polygon. One regular polygon. */
export interface PolygonShape {
  shape: 'polygon';
  /** corners; whole, in [3, 10000]; default 6. */
  n?: number;
  /** Noise along the normals, in mean edge lengths; default 0. */
  noise?: number;
  /** Of the noise; whole, below 2³²; default 1. */
  seed?: number;
}

/** Star. One concave polygon. */
export interface StarShape {
  shape: 'star';
  /** points; whole, in [3, 5000]; default 5. */
  points?: number;
  /** inner radius; radius of the corners between the points; in [0.05, 1]; default 0.4. */
  inner?: number;
  /** Noise along the normals, in mean edge lengths; default 0. */
  noise?: number;
  /** Of the noise; whole, below 2³²; default 1. */
  seed?: number;
}

/** Wavy polygon. One polygon that lies in no plane: regular seen from above, twice up and twice down. */
export interface WavyPolygonShape {
  shape: 'wavy-polygon';
  /** corners; whole, in [4, 10000]; default 6. */
  n?: number;
  /** height; from the lowest to the highest corner or nearly so; in [0, 100]; default 0.5. */
  height?: number;
  /** Noise along the normals, in mean edge lengths; default 0. */
  noise?: number;
  /** Of the noise; whole, below 2³²; default 1. */
  seed?: number;
}

/** Trapezium. The face of Herholz 2012, Table 4.1. */
export interface TrapeziumShape {
  shape: 'trapezium';
  /** Noise along the normals, in mean edge lengths; default 0. */
  noise?: number;
  /** Of the noise; whole, below 2³²; default 1. */
  seed?: number;
}

/** Two components. An open saddle beneath a closed sphere. */
export interface TwoComponentsShape {
  shape: 'two-components';
  /** quads an edge; whole, in [1, 500]; default 6. */
  n?: number;
  /** Noise along the normals, in mean edge lengths; default 0. */
  noise?: number;
  /** Of the noise; whole, below 2³²; default 1. */
  seed?: number;
}

/** Which shape to make; what is left out takes its default. */
export type ShapeSpec = GridShape | SkewGridShape | SaddleShape | TorusShape | UvSphereShape | IcoSphereShape | HexagonSphereShape | CubeShape | CubeSphereShape | CylinderShape | DiscShape | ConcaveHexagonsShape | VoronoiShape | LTilesShape | TetrisShape | PolygonShape | StarShape | WavyPolygonShape | TrapeziumShape | TwoComponentsShape;

/** Dual mesh. A face around each inner vertex, its corners in the middles of the faces. */
export interface DualConversion {
  conversion: 'dual';
}

/** Quads. Each face of n corners becomes n quads around its middle. */
export interface QuadsConversion {
  conversion: 'quads';
  /** rule; keep the surface, or smooth it; default linear. */
  rule?: 'linear' | 'catmull-clark';
}

/** Pairs of triangles. Neighbouring triangles become quads where these are convex. */
export interface PairTrianglesConversion {
  conversion: 'pair-triangles';
}

/** Triangles. Diagonals cut each face into triangles. */
export interface TrianglesConversion {
  conversion: 'triangles';
  /** rule; which diagonals cut a face; default delaunay. */
  rule?: 'delaunay' | 'min-max-angle' | 'shortest-diagonal' | 'fan';
}

/** Noise. Each vertex moves at random along its normal. */
export interface NoiseConversion {
  conversion: 'noise';
  /** amplitude; of the mean edge length; in [0, 100]; default 0.3. */
  amplitude?: number;
  /** seed; another seed, another noise; the same on every platform; whole, in [0, 4294967295]; default 1. */
  seed?: number;
}

/** What to make of a mesh; what is left out takes its default. */
export type ConversionSpec = DualConversion | QuadsConversion | PairTrianglesConversion | TrianglesConversion | NoiseConversion;

/** The operator table, in the order of menus. */
export const operators: readonly OperatorInfo[] = [
  {
    id: 'umbrella',
    label: 'Umbrella',
    summary: 'The graph Laplacian of the edges: every neighbour counts alike, wherever it lies.',
    formulaLatex: 'w_{ij} = 1',
    citation: 'G. Taubin: A signal processing approach to fair surface design. SIGGRAPH 1995; Herholz 2012, section 3.2',
    bibtex: '@inproceedings{taubin1995,\n  author = {Gabriel Taubin},\n  title = {A signal processing approach to fair surface design},\n  booktitle = {Proceedings of the 22nd Annual Conference on Computer Graphics and Interactive Techniques (SIGGRAPH \'95)},\n  pages = {351--358},\n  year = {1995},\n  doi = {10.1145/218380.218473}\n}',
    parameters: [],
    takesVertexWeights: false,
    claims: {
      symmetric: {
        where: 'yes',
        why: 'an edge has the same weight from both ends',
      },
      local: {
        where: 'yes',
        why: 'only edges have weights',
      },
      positiveWeights: {
        where: 'yes',
        why: 'every weight is 1',
      },
      positiveSemidefinite: {
        where: 'yes',
        why: 'a sum of squared differences along edges',
      },
      constantsInKernel: {
        where: 'yes',
        why: 'only differences along edges enter',
      },
      linearPrecision: {
        where: 'no',
        why: 'a vertex need not lie at the mean of its neighbours',
      },
      maximumPrinciple: {
        where: 'yes',
        why: 'a harmonic value is the mean of its neighbours',
      },
      convergent: {
        where: 'no',
        why: 'it knows nothing of lengths and angles',
      },
    },
    formulaMathml: '<math display="block" class="tml-display"><mrow><msub><mi>w</mi><mrow><mi>i</mi><mi>j</mi></mrow></msub><mo>=</mo><mn>1</mn></mrow></math>',
  },
  {
    id: 'tutte',
    label: 'Tutte',
    summary: 'The difference of each value from the mean of its neighbours along edges.',
    formulaLatex: 'w_{ij} = 1 / d_i',
    citation: 'W. T. Tutte: How to draw a graph. Proc. London Math. Soc. 13, 1963; Herholz 2012, section 3.2',
    bibtex: '@article{tutte1963,\n  author = {William T. Tutte},\n  title = {How to draw a graph},\n  journal = {Proceedings of the London Mathematical Society},\n  volume = {s3-13},\n  number = {1},\n  pages = {743--767},\n  year = {1963},\n  doi = {10.1112/plms/s3-13.1.743}\n}',
    parameters: [],
    takesVertexWeights: false,
    claims: {
      symmetric: {
        where: 'no',
        why: 'each end of an edge divides by its own number of neighbours',
      },
      local: {
        where: 'yes',
        why: 'only edges have weights',
      },
      positiveWeights: {
        where: 'yes',
        why: 'every weight is one over a number of neighbours',
      },
      positiveSemidefinite: {
        where: 'no',
        why: 'its spectrum lies in [0, 2], but uᵀSu can be negative where the numbers of neighbours differ',
      },
      constantsInKernel: {
        where: 'yes',
        why: 'a constant equals the mean of its neighbours',
      },
      linearPrecision: {
        where: 'no',
        why: 'a vertex need not lie at the mean of its neighbours',
      },
      maximumPrinciple: {
        where: 'yes',
        why: 'a harmonic value is the mean of its neighbours',
      },
      convergent: {
        where: 'no',
        why: 'it knows nothing of lengths and angles',
      },
    },
    formulaMathml: '<math display="block" class="tml-display"><mrow><msub><mi>w</mi><mrow><mi>i</mi><mi>j</mi></mrow></msub><mo>=</mo><mn>1</mn><mi>/</mi><msub><mi>d</mi><mi>i</mi></msub></mrow></math>',
  },
  {
    id: 'normalized-graph',
    label: 'Normalised graph',
    summary: 'The graph Laplacian, scaled symmetrically by the numbers of neighbours.',
    formulaLatex: 'w_{ij} = 1 / \\sqrt{d_i d_j}',
    citation: 'F. Chung: Spectral graph theory. AMS 1997; Herholz 2012, section 3.2',
    bibtex: '@book{chung1997,\n  author = {Fan R. K. Chung},\n  title = {Spectral graph theory},\n  series = {CBMS Regional Conference Series in Mathematics},\n  volume = {92},\n  publisher = {American Mathematical Society},\n  year = {1997},\n  doi = {10.1090/cbms/092}\n}',
    parameters: [],
    takesVertexWeights: false,
    claims: {
      symmetric: {
        where: 'yes',
        why: 'both ends of an edge enter alike',
      },
      local: {
        where: 'yes',
        why: 'only edges have weights',
      },
      positiveWeights: {
        where: 'yes',
        why: 'every weight is one over a root',
      },
      positiveSemidefinite: {
        where: 'yes',
        why: 'the graph Laplacian, scaled from both sides',
      },
      constantsInKernel: {
        where: 'no',
        why: 'its kernel are the roots of the numbers of neighbours',
      },
      linearPrecision: {
        where: 'no',
        why: 'a vertex need not lie at the mean of its neighbours',
      },
      maximumPrinciple: {
        where: 'no',
        why: 'vertices of many neighbours rise above the rest',
      },
      convergent: {
        where: 'no',
        why: 'it knows nothing of lengths and angles',
      },
    },
    formulaMathml: '<math display="block" class="tml-display"><mrow><msub><mi>w</mi><mrow><mi>i</mi><mi>j</mi></mrow></msub><mo>=</mo><mn>1</mn><mi>/</mi><msqrt><mrow><msub><mi>d</mi><mi>i</mi></msub><msub><mi>d</mi><mi>j</mi></msub></mrow></msqrt></mrow></math>',
  },
  {
    id: 'cotan',
    label: 'Cotan',
    summary: 'Linear finite elements on the triangles that the faces are cut into, in space.',
    formulaLatex: 'w_{ij} = \\tfrac12\\left(\\cot\\gamma_{ij} + \\cot\\gamma_{ji}\\right)',
    citation: 'U. Pinkall, K. Polthier: Computing discrete minimal surfaces and their conjugates. Experimental Mathematics 2(1), 1993; Herholz 2012, eq. 3.16',
    bibtex: '@article{pinkall1993,\n  author = {Ulrich Pinkall and Konrad Polthier},\n  title = {Computing discrete minimal surfaces and their conjugates},\n  journal = {Experimental Mathematics},\n  volume = {2},\n  number = {1},\n  pages = {15--36},\n  year = {1993},\n  doi = {10.1080/10586458.1993.10504266}\n}',
    parameters: [
      {
        id: 'rule',
        label: 'rule',
        hint: 'how faces are cut into triangles',
        kind: 'choice',
        choices: [
          'delaunay',
          'min-max-angle',
          'shortest-diagonal',
          'fan',
        ],
        initial: 'delaunay',
      },
      {
        id: 'mass',
        label: 'mass',
        hint: 'how much area each vertex gets',
        kind: 'choice',
        choices: [
          'lumped',
          'barycentric',
          'ring',
          'circumcentric',
          'mixed-voronoi',
          'galerkin',
        ],
        initial: 'lumped',
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
        why: 'a sum over triangles inside faces',
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
        why: 'S x is the gradient of the area of the triangles',
      },
      maximumPrinciple: {
        where: 'no',
        why: 'a negative weight lets values overshoot',
      },
      convergent: {
        where: 'some',
        why: 'linear finite elements; not with the mass ring, which is six times the area',
      },
    },
    formulaMathml: '<math display="block" class="tml-display"><mrow><msub><mi>w</mi><mrow><mi>i</mi><mi>j</mi></mrow></msub><mo>=</mo><mstyle displaystyle="false" scriptlevel="0"><mfrac><mn>1</mn><mn>2</mn></mfrac></mstyle><mrow><mo fence="true" form="prefix" stretchy="true">(</mo><mrow><mi>cot</mi><mo>⁡</mo><mspace width="0.1667em"></mspace></mrow><msub><mi>γ</mi><mrow><mi>i</mi><mi>j</mi></mrow></msub><mo>+</mo><mrow><mi>cot</mi><mo>⁡</mo><mspace width="0.1667em"></mspace></mrow><msub><mi>γ</mi><mrow><mi>j</mi><mi>i</mi></mrow></msub><mo fence="true" form="postfix" stretchy="true">)</mo></mrow></mrow></math>',
  },
  {
    id: 'weighted-cotan',
    label: 'Cotan, weighted',
    summary: 'Dual over primal lengths, as for the cotan operator, with dual edges that weights of the vertices move.',
    formulaLatex: 'w_{ij} = \\sum_k \\frac{d_{ik} - d_{ij}\\cos\\gamma_i}{|e_{ij}|\\,\\sin\\gamma_i},\\; d_{ij} = \\frac{|e_{ij}|^2 + \\omega_i - \\omega_j}{2\\,|e_{ij}|}',
    citation: 'D. Glickenstein: A monotonicity property for weighted Delaunay triangulations. Discrete & Computational Geometry 38(4), 2007; Herholz 2012, eq. 3.24 and 3.25',
    bibtex: '@article{glickenstein2007,\n  author = {David Glickenstein},\n  title = {A monotonicity property for weighted {D}elaunay triangulations},\n  journal = {Discrete \\& Computational Geometry},\n  volume = {38},\n  number = {4},\n  year = {2007}\n}',
    parameters: [
      {
        id: 'rule',
        label: 'rule',
        hint: 'how faces are cut into triangles',
        kind: 'choice',
        choices: [
          'delaunay',
          'min-max-angle',
          'shortest-diagonal',
          'fan',
        ],
        initial: 'delaunay',
      },
      {
        id: 'mass',
        label: 'mass',
        hint: 'how much area each vertex gets',
        kind: 'choice',
        choices: [
          'lumped',
          'barycentric',
          'ring',
          'circumcentric',
          'mixed-voronoi',
          'galerkin',
        ],
        initial: 'lumped',
      },
    ],
    takesVertexWeights: true,
    claims: {
      symmetric: {
        where: 'yes',
        why: 'an edge and its dual have one length each',
      },
      local: {
        where: 'yes',
        why: 'a sum over triangles inside faces',
      },
      positiveWeights: {
        where: 'no',
        why: 'dual edges may run backwards',
      },
      positiveSemidefinite: {
        where: 'no',
        why: 'large weights turn dual edges around',
      },
      constantsInKernel: {
        where: 'yes',
        why: 'only differences along edges enter',
      },
      linearPrecision: {
        where: 'yes',
        why: 'the dual edges around a vertex, orthogonal to its edges, close up',
      },
      maximumPrinciple: {
        where: 'no',
        why: 'a negative weight lets values overshoot',
      },
      convergent: {
        where: 'no',
        why: 'large weights can even make it singular',
      },
    },
    formulaMathml: '<math display="block" class="tml-display"><mrow><msub><mi>w</mi><mrow><mi>i</mi><mi>j</mi></mrow></msub><mo>=</mo><mrow><munder><mo movablelimits="false">∑</mo><mi>k</mi></munder></mrow><mfrac><mrow><msub><mi>d</mi><mrow><mi>i</mi><mi>k</mi></mrow></msub><mo>−</mo><msub><mi>d</mi><mrow><mi>i</mi><mi>j</mi></mrow></msub><mrow><mi>cos</mi><mo>⁡</mo><mspace width="0.1667em"></mspace></mrow><msub><mi>γ</mi><mi>i</mi></msub></mrow><mrow><mi>|</mi><msub><mi>e</mi><mrow><mi>i</mi><mi>j</mi></mrow></msub><mi>|</mi><mspace width="0.1667em"></mspace><mrow><mspace width="0.1667em"></mspace><mi>sin</mi><mo>⁡</mo><mspace width="0.1667em"></mspace></mrow><msub><mi>γ</mi><mi>i</mi></msub></mrow></mfrac><mo separator="true">,</mo><mspace width="0.2778em"></mspace><msub><mi>d</mi><mrow><mi>i</mi><mi>j</mi></mrow></msub><mo>=</mo><mfrac><mrow><mi>|</mi><msub><mi>e</mi><mrow><mi>i</mi><mi>j</mi></mrow></msub><msup><mi>|</mi><mn>2</mn></msup><mo>+</mo><msub><mi>ω</mi><mi>i</mi></msub><mo>−</mo><msub><mi>ω</mi><mi>j</mi></msub></mrow><mrow><mn>2</mn><mspace width="0.1667em"></mspace><mi>|</mi><msub><mi>e</mi><mrow><mi>i</mi><mi>j</mi></mrow></msub><mi>|</mi></mrow></mfrac></mrow></math>',
  },
  {
    id: 'alexa-wardetzky',
    label: 'Alexa–Wardetzky',
    summary: 'Edge vectors against the vector area of each face, stabilised by λ where they see nothing.',
    formulaLatex: 'S_f = \\delta^{\\mathrm T}\\Bigl(\\tfrac{1}{|a|}\\,B B^{\\mathrm T} + \\lambda\\, C C^{\\mathrm T}\\Bigr)\\delta',
    citation: 'M. Alexa, M. Wardetzky: Discrete Laplacians on general polygonal meshes. ACM Trans. Graph. 30(4), 2011; Herholz 2012, eq. 4.29',
    bibtex: '@article{alexa2011,\n  author = {Marc Alexa and Max Wardetzky},\n  title = {Discrete {L}aplacians on general polygonal meshes},\n  journal = {ACM Transactions on Graphics},\n  volume = {30},\n  number = {4},\n  year = {2011},\n  doi = {10.1145/2010324.1964997}\n}',
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
        where: 'some',
        why: 'consistent on linear functions; λ = 0 stabilises nothing, and large λ drowns the rest',
      },
    },
    formulaMathml: '<math display="block" class="tml-display"><mrow><msub><mi>S</mi><mi>f</mi></msub><mo>=</mo><msup><mi>δ</mi><mrow><mi mathvariant="normal">T</mi><mspace></mspace></mrow></msup><mo fence="true" symmetric="true" minsize="1.8em" maxsize="1.8em">(</mo><mstyle displaystyle="false" scriptlevel="0"><mfrac><mn>1</mn><mrow><mi>|</mi><mi>a</mi><mi>|</mi></mrow></mfrac></mstyle><mspace width="0.1667em"></mspace><mi>B</mi><msup><mi>B</mi><mrow class="tml-med-pad"><mi mathvariant="normal">T</mi><mspace></mspace></mrow></msup><mo>+</mo><mi>λ</mi><mspace width="0.1667em"></mspace><mi>C</mi><msup><mi>C</mi><mrow class="tml-med-pad"><mi mathvariant="normal">T</mi><mspace></mspace></mrow></msup><mo fence="true" symmetric="true" minsize="1.8em" maxsize="1.8em">)</mo><mi>δ</mi></mrow></math>',
  },
  {
    id: 'alexa-wardetzky-weighted',
    label: 'Alexa–Wardetzky, weighted',
    summary: 'Alexa and Wardetzky\'s operator with points on the edges that weights of the vertices move.',
    formulaLatex: 'S_f = \\delta^{\\mathrm T}\\Bigl(\\tfrac{1}{|a|}\\,B (B^w)^{\\mathrm T} + \\lambda\\, C C^{\\mathrm T}\\Bigr)\\delta,\\; b^w_i = x_i + \\tfrac{|e_i|^2 + \\omega_i - \\omega_{i+1}}{2|e_i|^2}\\, e_i',
    citation: 'P. Herholz: General discrete Laplace operators on polygonal meshes. Diploma thesis, Humboldt-Universität zu Berlin, 2012, Lemma 4 and eq. 4.31',
    bibtex: '@mastersthesis{herholz2012,\n  author = {Philipp Herholz},\n  title = {General discrete {L}aplace operators on polygonal meshes},\n  type = {Diploma thesis},\n  school = {Humboldt-Universit{\\"a}t zu Berlin},\n  year = {2012}\n}',
    parameters: [
      {
        id: 'lambda',
        label: 'λ',
        hint: 'the stabiliser of the unweighted operator',
        kind: 'real',
        min: 0,
        max: 1000000,
        sliderMax: 2,
        step: 0.01,
        initial: 1,
      },
    ],
    takesVertexWeights: true,
    claims: {
      symmetric: {
        where: 'triangles',
        why: 'on larger faces only few weights leave it symmetric',
      },
      local: {
        where: 'yes',
        why: 'a sum over faces',
      },
      positiveWeights: {
        where: 'no',
        why: 'already without weights of vertices, λ > ½ makes diagonals negative',
      },
      positiveSemidefinite: {
        where: 'no',
        why: 'large weights turn dual edges around',
      },
      constantsInKernel: {
        where: 'yes',
        why: 'only differences along edges enter',
      },
      linearPrecision: {
        where: 'triangles',
        why: 'on larger faces only the transpose is precise',
      },
      maximumPrinciple: {
        where: 'no',
        why: 'negative weights let values overshoot',
      },
      convergent: {
        where: 'no',
        why: 'large weights can even make it singular',
      },
    },
    formulaMathml: '<math display="block" class="tml-display"><mrow><msub><mi>S</mi><mi>f</mi></msub><mo>=</mo><msup><mi>δ</mi><mrow><mi mathvariant="normal">T</mi><mspace></mspace></mrow></msup><mo fence="true" symmetric="true" minsize="1.8em" maxsize="1.8em">(</mo><mstyle displaystyle="false" scriptlevel="0"><mfrac><mn>1</mn><mrow><mi>|</mi><mi>a</mi><mi>|</mi></mrow></mfrac></mstyle><mspace width="0.1667em"></mspace><mi>B</mi><mo form="prefix" stretchy="false">(</mo><msup><mi>B</mi><mi class="tml-med-pad">w</mi></msup><msup><mo form="postfix" stretchy="false">)</mo><mrow><mi mathvariant="normal">T</mi><mspace></mspace></mrow></msup><mo>+</mo><mi>λ</mi><mspace width="0.1667em"></mspace><mi>C</mi><msup><mi>C</mi><mrow class="tml-med-pad"><mi mathvariant="normal">T</mi><mspace></mspace></mrow></msup><mo fence="true" symmetric="true" minsize="1.8em" maxsize="1.8em">)</mo><mi>δ</mi><mo separator="true">,</mo><mspace width="0.2778em"></mspace><msubsup><mi>b</mi><mi>i</mi><mi>w</mi></msubsup><mo>=</mo><msub><mi>x</mi><mi>i</mi></msub><mo>+</mo><mstyle displaystyle="false" scriptlevel="0"><mfrac><mrow><mi>|</mi><msub><mi>e</mi><mi>i</mi></msub><msup><mi>|</mi><mn>2</mn></msup><mo>+</mo><msub><mi>ω</mi><mi>i</mi></msub><mo>−</mo><msub><mi>ω</mi><mrow><mi>i</mi><mo>+</mo><mn>1</mn></mrow></msub></mrow><mrow><mn>2</mn><mi>|</mi><msub><mi>e</mi><mi>i</mi></msub><msup><mi>|</mi><mn>2</mn></msup></mrow></mfrac></mstyle><mspace width="0.1667em"></mspace><msub><mi>e</mi><mi>i</mi></msub></mrow></math>',
  },
  {
    id: 'planar',
    label: 'Planar',
    summary: 'Each face is projected along its vector area and triangulated there; the cotangents of its triangles are summed.',
    formulaLatex: 'w_{ij} = \\tfrac12\\left(\\cot\\gamma_{ij} + \\cot\\gamma_{ji}\\right)',
    citation: 'P. Herholz: General discrete Laplace operators on polygonal meshes. Diploma thesis, Humboldt-Universität zu Berlin, 2012, section 4.2.4',
    bibtex: '@mastersthesis{herholz2012,\n  author = {Philipp Herholz},\n  title = {General discrete {L}aplace operators on polygonal meshes},\n  type = {Diploma thesis},\n  school = {Humboldt-Universit{\\"a}t zu Berlin},\n  year = {2012}\n}',
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
  {
    id: 'orthogonal-dual',
    label: 'Orthogonal dual',
    summary: 'Dual edges are made orthogonal to the edges, with dual vertices as near to the barycentres as that allows; a weight is the signed length of the dual edge over that of the edge.',
    formulaLatex: 'w_{ij} = \\frac{d_k + d_l}{|e_{ij}|},\\quad \\langle v_k - v_l,\\, e_{ij}\\rangle = 0,\\quad \\sum_k |v_k - b_k|^2 \\to \\min',
    citation: 'P. Herholz: General discrete Laplace operators on polygonal meshes. Diploma thesis, Humboldt-Universität zu Berlin, 2012, section 4.1',
    bibtex: '@mastersthesis{herholz2012,\n  author = {Philipp Herholz},\n  title = {General discrete {L}aplace operators on polygonal meshes},\n  type = {Diploma thesis},\n  school = {Humboldt-Universit{\\"a}t zu Berlin},\n  year = {2012}\n}',
    parameters: [],
    takesVertexWeights: false,
    claims: {
      symmetric: {
        where: 'yes',
        why: 'one weight per edge',
      },
      local: {
        where: 'yes',
        why: 'weights sit on edges only',
      },
      positiveWeights: {
        where: 'no',
        why: 'a dual vertex may lie beyond an edge of its face',
      },
      positiveSemidefinite: {
        where: 'no',
        why: 'enough negative weights make the energy negative',
      },
      constantsInKernel: {
        where: 'yes',
        why: 'only differences along edges enter',
      },
      linearPrecision: {
        where: 'yes',
        why: 'dual edges orthogonal to the edges close up around a vertex',
      },
      maximumPrinciple: {
        where: 'no',
        why: 'negative weights let values overshoot',
      },
      convergent: {
        where: 'no',
        why: 'where the constraints fight, the nearest dual lies far from the mesh',
      },
    },
    formulaMathml: '<math display="block" class="tml-display"><mrow><msub><mi>w</mi><mrow><mi>i</mi><mi>j</mi></mrow></msub><mo>=</mo><mfrac><mrow><msub><mi>d</mi><mi>k</mi></msub><mo>+</mo><msub><mi>d</mi><mi>l</mi></msub></mrow><mrow><mi>|</mi><msub><mi>e</mi><mrow><mi>i</mi><mi>j</mi></mrow></msub><mi>|</mi></mrow></mfrac><mo separator="true">,</mo><mspace width="1em"></mspace><mrow><mo fence="true" form="prefix" stretchy="false">⟨</mo><msub><mi>v</mi><mi>k</mi></msub><mo>−</mo><msub><mi>v</mi><mi>l</mi></msub><mo separator="true">,</mo><mspace width="0.1667em"></mspace><msub><mi>e</mi><mrow><mi>i</mi><mi>j</mi></mrow></msub><mo fence="true" form="postfix" stretchy="false">⟩</mo></mrow><mo>=</mo><mn>0</mn><mo separator="true">,</mo><mspace width="1em"></mspace><mrow><munder><mo movablelimits="false">∑</mo><mi>k</mi></munder></mrow><mi>|</mi><msub><mi>v</mi><mi>k</mi></msub><mo>−</mo><msub><mi>b</mi><mi>k</mi></msub><msup><mi>|</mi><mn>2</mn></msup><mo>→</mo><mrow><mi>min</mi><mo>⁡</mo><mspace width="0.1667em"></mspace></mrow></mrow></math>',
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
    id: 'skew-grid',
    label: 'Skewed grid',
    summary: 'Parallelograms of growing size in the plane.',
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
        id: 'shear',
        label: 'shear',
        hint: 'how far the upper side is moved along x',
        kind: 'real',
        min: 0,
        max: 100,
        sliderMax: 2,
        step: 0.01,
        initial: 0.5,
      },
      {
        id: 'stretch',
        label: 'stretch',
        hint: 'how much faster the spacing is at the end than at the start',
        kind: 'real',
        min: 1,
        max: 100,
        sliderMax: 10,
        step: 0.1,
        initial: 3,
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
  {
    id: 'uv-sphere',
    label: 'Sphere of meridians',
    summary: 'Planar quads, and triangles around both poles.',
    parameters: [
      {
        id: 'nu',
        label: 'meridians',
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
        label: 'bands',
        hint: 'from pole to pole',
        kind: 'integer',
        min: 2,
        max: 2000,
        sliderMax: 64,
        step: 1,
        initial: 16,
      },
    ],
  },
  {
    id: 'ico-sphere',
    label: 'Sphere of triangles',
    summary: 'An icosahedron whose triangles are cut into four again and again.',
    parameters: [
      {
        id: 'level',
        label: 'level',
        hint: 'how often each triangle is cut into four',
        kind: 'integer',
        min: 0,
        max: 8,
        sliderMax: 5,
        step: 1,
        initial: 3,
      },
    ],
  },
  {
    id: 'hexagon-sphere',
    label: 'Sphere of hexagons',
    summary: 'The dual of the sphere of triangles: twelve pentagons among hexagons.',
    parameters: [
      {
        id: 'level',
        label: 'level',
        hint: '0 is the dodecahedron',
        kind: 'integer',
        min: 0,
        max: 8,
        sliderMax: 5,
        step: 1,
        initial: 3,
      },
      {
        id: 'kind',
        label: 'vertices',
        hint: 'on the sphere, or where all faces are flat and touch it',
        kind: 'choice',
        choices: [
          'on-sphere',
          'flat',
        ],
        initial: 'on-sphere',
      },
    ],
  },
  {
    id: 'cube',
    label: 'Cube',
    summary: 'Squares on the sides of a cube of edge 1.',
    parameters: [
      {
        id: 'n',
        label: 'quads an edge',
        hint: '',
        kind: 'integer',
        min: 1,
        max: 500,
        sliderMax: 32,
        step: 1,
        initial: 8,
      },
    ],
  },
  {
    id: 'cube-sphere',
    label: 'Sphere of quads',
    summary: 'A cube of n × n quads a side, blown up to a ball.',
    parameters: [
      {
        id: 'n',
        label: 'quads an edge',
        hint: '',
        kind: 'integer',
        min: 1,
        max: 500,
        sliderMax: 32,
        step: 1,
        initial: 8,
      },
    ],
  },
  {
    id: 'cylinder',
    label: 'Cylinder',
    summary: 'Planar quads around a tube that is open at both ends.',
    parameters: [
      {
        id: 'nu',
        label: 'quads around',
        hint: '',
        kind: 'integer',
        min: 3,
        max: 2000,
        sliderMax: 128,
        step: 1,
        initial: 24,
      },
      {
        id: 'nv',
        label: 'quads along',
        hint: '',
        kind: 'integer',
        min: 1,
        max: 2000,
        sliderMax: 64,
        step: 1,
        initial: 8,
      },
      {
        id: 'radius',
        label: 'radius',
        hint: '',
        kind: 'real',
        min: 0.01,
        max: 1000000,
        sliderMax: 10,
        step: 0.01,
        initial: 0.5,
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
    id: 'disc',
    label: 'Disc',
    summary: 'A polygon and rings of planar quads around it.',
    parameters: [
      {
        id: 'n',
        label: 'corners a ring',
        hint: '',
        kind: 'integer',
        min: 3,
        max: 2000,
        sliderMax: 64,
        step: 1,
        initial: 12,
      },
      {
        id: 'rings',
        label: 'rings',
        hint: '',
        kind: 'integer',
        min: 0,
        max: 2000,
        sliderMax: 32,
        step: 1,
        initial: 5,
      },
    ],
  },
  {
    id: 'concave-hexagons',
    label: 'Concave hexagons',
    summary: 'The plane tiled by hexagons with two concave corners each.',
    parameters: [
      {
        id: 'nx',
        label: 'hexagons a row',
        hint: '',
        kind: 'integer',
        min: 1,
        max: 1000,
        sliderMax: 32,
        step: 1,
        initial: 6,
      },
      {
        id: 'ny',
        label: 'rows',
        hint: '',
        kind: 'integer',
        min: 1,
        max: 2000,
        sliderMax: 64,
        step: 1,
        initial: 12,
      },
      {
        id: 'depth',
        label: 'depth',
        hint: 'how far the long sides are pushed in; 0: bricks',
        kind: 'real',
        min: 0,
        max: 0.95,
        sliderMax: 0.95,
        step: 0.01,
        initial: 0.4,
      },
    ],
  },
  {
    id: 'voronoi',
    label: 'Voronoi cells',
    summary: 'Convex polygons of three to about ten corners in a rectangle.',
    parameters: [
      {
        id: 'nx',
        label: 'cells a row',
        hint: '',
        kind: 'integer',
        min: 1,
        max: 1000,
        sliderMax: 48,
        step: 1,
        initial: 12,
      },
      {
        id: 'ny',
        label: 'rows',
        hint: '',
        kind: 'integer',
        min: 1,
        max: 1000,
        sliderMax: 48,
        step: 1,
        initial: 12,
      },
      {
        id: 'jitter',
        label: 'jitter',
        hint: 'how far the sites are shaken; 0: regular hexagons',
        kind: 'real',
        min: 0,
        max: 1,
        sliderMax: 1,
        step: 0.01,
        initial: 0.7,
      },
      {
        id: 'seed',
        label: 'seed',
        hint: 'another seed, another mesh; the same on every platform',
        kind: 'integer',
        min: 0,
        max: 2147483647,
        sliderMax: 100,
        step: 1,
        initial: 1,
      },
    ],
  },
  {
    id: 'l-tiles',
    label: 'L tiles',
    summary: 'A rectangle cut into L-shaped polygons with ten corners each.',
    parameters: [
      {
        id: 'nx',
        label: 'pairs along x',
        hint: '',
        kind: 'integer',
        min: 1,
        max: 500,
        sliderMax: 16,
        step: 1,
        initial: 3,
      },
      {
        id: 'ny',
        label: 'pairs along y',
        hint: '',
        kind: 'integer',
        min: 1,
        max: 1000,
        sliderMax: 32,
        step: 1,
        initial: 6,
      },
    ],
  },
  {
    id: 'tetris',
    label: 'Tetris',
    summary: 'A rectangle cut into T, L, J and S pieces with ten corners each.',
    parameters: [
      {
        id: 'nx',
        label: 'blocks along x',
        hint: '',
        kind: 'integer',
        min: 1,
        max: 500,
        sliderMax: 16,
        step: 1,
        initial: 3,
      },
      {
        id: 'ny',
        label: 'blocks along y',
        hint: '',
        kind: 'integer',
        min: 1,
        max: 500,
        sliderMax: 16,
        step: 1,
        initial: 3,
      },
    ],
  },
  {
    id: 'polygon',
    label: 'Polygon',
    summary: 'One regular polygon.',
    parameters: [
      {
        id: 'n',
        label: 'corners',
        hint: '',
        kind: 'integer',
        min: 3,
        max: 10000,
        sliderMax: 24,
        step: 1,
        initial: 6,
      },
    ],
  },
  {
    id: 'star',
    label: 'Star',
    summary: 'One concave polygon.',
    parameters: [
      {
        id: 'points',
        label: 'points',
        hint: '',
        kind: 'integer',
        min: 3,
        max: 5000,
        sliderMax: 16,
        step: 1,
        initial: 5,
      },
      {
        id: 'inner',
        label: 'inner radius',
        hint: 'radius of the corners between the points',
        kind: 'real',
        min: 0.05,
        max: 1,
        sliderMax: 1,
        step: 0.01,
        initial: 0.4,
      },
    ],
  },
  {
    id: 'wavy-polygon',
    label: 'Wavy polygon',
    summary: 'One polygon that lies in no plane: regular seen from above, twice up and twice down.',
    parameters: [
      {
        id: 'n',
        label: 'corners',
        hint: '',
        kind: 'integer',
        min: 4,
        max: 10000,
        sliderMax: 24,
        step: 1,
        initial: 6,
      },
      {
        id: 'height',
        label: 'height',
        hint: 'from the lowest to the highest corner or nearly so',
        kind: 'real',
        min: 0,
        max: 100,
        sliderMax: 2,
        step: 0.01,
        initial: 0.5,
      },
    ],
  },
  {
    id: 'trapezium',
    label: 'Trapezium',
    summary: 'The face of Herholz 2012, Table 4.1.',
    parameters: [],
  },
  {
    id: 'two-components',
    label: 'Two components',
    summary: 'An open saddle beneath a closed sphere.',
    parameters: [
      {
        id: 'n',
        label: 'quads an edge',
        hint: '',
        kind: 'integer',
        min: 1,
        max: 500,
        sliderMax: 32,
        step: 1,
        initial: 6,
      },
    ],
  },
];

/** The conversion table, in the order of menus. */
export const conversions: readonly MakerInfo[] = [
  {
    id: 'dual',
    label: 'Dual mesh',
    summary: 'A face around each inner vertex, its corners in the middles of the faces.',
    parameters: [],
  },
  {
    id: 'quads',
    label: 'Quads',
    summary: 'Each face of n corners becomes n quads around its middle.',
    parameters: [
      {
        id: 'rule',
        label: 'rule',
        hint: 'keep the surface, or smooth it',
        kind: 'choice',
        choices: [
          'linear',
          'catmull-clark',
        ],
        initial: 'linear',
      },
    ],
  },
  {
    id: 'pair-triangles',
    label: 'Pairs of triangles',
    summary: 'Neighbouring triangles become quads where these are convex.',
    parameters: [],
  },
  {
    id: 'triangles',
    label: 'Triangles',
    summary: 'Diagonals cut each face into triangles.',
    parameters: [
      {
        id: 'rule',
        label: 'rule',
        hint: 'which diagonals cut a face',
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
  },
  {
    id: 'noise',
    label: 'Noise',
    summary: 'Each vertex moves at random along its normal.',
    parameters: [
      {
        id: 'amplitude',
        label: 'amplitude',
        hint: 'of the mean edge length',
        kind: 'real',
        min: 0,
        max: 100,
        sliderMax: 1,
        step: 0.01,
        initial: 0.3,
      },
      {
        id: 'seed',
        label: 'seed',
        hint: 'another seed, another noise; the same on every platform',
        kind: 'integer',
        min: 0,
        max: 4294967295,
        sliderMax: 100,
        step: 1,
        initial: 1,
      },
    ],
  },
];
