/** What can be taken away from the page, each as a file. */
import { specOf } from './answers.js';
import type { App } from './app.js';
import { h } from './dom.js';
import { stencil } from './layout/stencil.js';
import { csv, matrixMarket } from './numbers-text.js';
import type { MeshFormat, Row, Side } from './polylap.js';
import { known } from './results.js';
import { drawnWeights, entriesOf, largestWeight } from './rows.js';
import { type SavedFile, standalone } from './saving.js';
import { nameOf, operatorOf, type State, sides } from './state.js';
import { t } from './words.js';

const text = (name: string, contents: string): SavedFile => ({ name, contents: new Blob([contents]) });

/** Files are the same in every language. */
const english = (text: string) => text;

/** The mesh's name as part of a file name. */
function stem(app: App): string {
  const name = nameOf(app.state.get().source, english).replace(/\.(obj|off|ply|stl)$/i, '');
  return (
    name
      .normalize('NFKD')
      .replace(/[^\p{L}\p{N}]+/gu, '-')
      .replace(/^-|-$/g, '')
      .toLowerCase() || 'mesh'
  );
}

function meshOf(app: App) {
  const { mesh } = app.results.get();
  if (!mesh) throw new Error(t('There is no mesh yet.'));
  return mesh;
}

/** The side's surface as it stands. */
export async function surfaceFile(app: App, side: Side, format: MeshFormat): Promise<SavedFile> {
  const bytes = await meshOf(app).file(format, { side });
  return { name: `${stem(app)}-${side}.${format}`, contents: new Blob([bytes as Uint8Array<ArrayBuffer>]) };
}

/** The stiffness S or the mass M of the side's operator on its surface. */
export async function matrixFile(app: App, side: Side, which: 'stiffness' | 'mass'): Promise<SavedFile> {
  const mesh = meshOf(app);
  const { sides: choices, vertexWeights } = app.state.get();
  const spec = specOf(choices[side], vertexWeights[side], mesh.vertices);
  const matrices = await mesh.matrices(spec, { side });
  const letter = which === 'stiffness' ? 'S' : 'M';
  const parameters = Object.entries(choices[side].parameters).map(([id, value]) => `, ${id} ${value}`);
  const comment = `polylap: ${letter} of ${operatorOf(choices[side]).label}${parameters.join('')}; ${nameOf(app.state.get().source, english)}`;
  return text(`${stem(app)}-${side}-${letter}.mtx`, matrixMarket(matrices[which], comment));
}

/** The rows of the selected vertex, whatever is on screen; null where none is selected. */
async function selectedRows(app: App): Promise<{ vertex: number; rows: Record<Side, Row> } | null> {
  const mesh = meshOf(app);
  const { selected: vertex, sides: choices, vertexWeights } = app.state.get();
  if (vertex === null) return null;
  const [a, b] = await Promise.all(
    sides.map((side) => mesh.row(specOf(choices[side], vertexWeights[side], mesh.vertices), vertex, { side })),
  );
  return a && b ? { vertex, rows: { a, b } } : null;
}

/** The row of the selected vertex on both sides; null where none is. */
export async function rowFile(app: App): Promise<SavedFile | null> {
  const asked = await selectedRows(app);
  if (!asked) return null;
  const [one, other] = sides.map((side) => {
    const { columns, values } = asked.rows[side];
    return new Map([...columns].map((j, k) => [j, values[k] ?? 0]));
  });
  const columns = [...new Set([...(one?.keys() ?? []), ...(other?.keys() ?? [])])].sort((p, q) => p - q);
  const lines = columns.map((j) => [j, one?.get(j) ?? 0, other?.get(j) ?? 0]);
  return text(`${stem(app)}-row-${asked.vertex}.csv`, csv(['column', 'S_A', 'S_B'], lines));
}

/** The works that the operators of both sides come from, as BibTeX. */
export const bibliography = ({ sides: choices }: State): string =>
  [...new Set(sides.map((side) => operatorOf(choices[side]).bibtex))].join('\n\n');

export const bibliographyFile = (app: App): SavedFile => text('polylap.bib', `${bibliography(app.state.get())}\n`);

/** Per vertex, what the surfaces and the harmonic functions are; null without a mesh. */
export function valuesFile(app: App): SavedFile | null {
  const { mesh, a, b } = app.results.get();
  if (!mesh) return null;
  const { origin } = mesh.geometry;
  const point = ({ positions }: typeof a, v: number) => origin.map((o, c) => o + (positions[3 * v + c] as number));
  const [one, other] = [known(a.harmonic), known(b.harmonic)];
  const head = ['vertex', 'x_A', 'y_A', 'z_A', 'x_B', 'y_B', 'z_B', 'u_A', 'u_B'];
  const rows = Array.from({ length: mesh.vertices }, (_, v) => [
    v,
    ...point(a, v),
    ...point(b, v),
    one?.values[v],
    other?.values[v],
  ]);
  return text(`${stem(app)}-values.csv`, csv(head, rows));
}

/** The row of the selected vertex as Weights draws it; null where none is selected. @param within whose styles it has */
export async function stencilFile(app: App, side: Side, within: Element): Promise<SavedFile | null> {
  const asked = await selectedRows(app);
  if (!asked) return null;
  const { vertex } = asked;
  const rows = { a: entriesOf(asked.rows.a, vertex), b: entriesOf(asked.rows.b, vertex) };
  const { positions } = app.results.get()[side];
  const weights = drawnWeights(rows[side], vertex);
  const drawn = stencil(meshOf(app).geometry, positions, vertex, weights, largestWeight(rows, vertex));
  // Styles are known only of what is shown somewhere.
  const place = h('div', { class: 'unseen', 'aria-hidden': 'true' }, drawn);
  within.append(place);
  try {
    return text(`${stem(app)}-vertex-${vertex}-${side}.svg`, standalone(drawn));
  } finally {
    place.remove();
  }
}

export const pictureName = (app: App, view: string) => `${stem(app)}-${view}.png`;
