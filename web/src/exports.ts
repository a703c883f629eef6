/** What can be taken away from the page, each as a file. */
import { specOf } from './answers.js';
import type { App } from './app.js';
import { csv, matrixMarket } from './numbers-text.js';
import type { MeshFormat, Side } from './polylap.js';
import { known } from './results.js';
import { nameOf, operatorOf, type State, sides } from './state.js';

export interface SavedFile {
  name: string;
  contents: Blob;
}

const text = (name: string, contents: string): SavedFile => ({ name, contents: new Blob([contents]) });

/** The mesh's name as part of a file name. */
function stem(app: App): string {
  const name = nameOf(app.state.get().source).replace(/\.(obj|off|ply|stl)$/i, '');
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
  if (!mesh) throw new Error('There is no mesh yet.');
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
  const comment = `polylap: ${letter} of ${operatorOf(choices[side]).label}${parameters.join('')}; ${nameOf(app.state.get().source)}`;
  return text(`${stem(app)}-${side}-${letter}.mtx`, matrixMarket(matrices[which], comment));
}

/** The row of the selected vertex on both sides; null where no row is known. */
export function rowFile(app: App): SavedFile | null {
  const { selected } = app.state.get();
  const { a, b } = app.results.get();
  const rows = [known(a.row), known(b.row)].map((row) => (row?.vertex === selected ? row : null));
  if (selected === null || rows.includes(null)) return null;
  const [one, other] = rows.map((row) => new Map([...(row?.columns ?? [])].map((j, k) => [j, row?.values[k] ?? 0])));
  const columns = [...new Set([...(one?.keys() ?? []), ...(other?.keys() ?? [])])].sort((p, q) => p - q);
  const lines = columns.map((j) => [j, one?.get(j) ?? 0, other?.get(j) ?? 0]);
  return text(`${stem(app)}-row-${selected}.csv`, csv(['column', 'S_A', 'S_B'], lines));
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

/** The rows of the selected vertex as they are drawn; null where none is. */
export function stencilFile(app: App, side: Side): SavedFile | null {
  const drawn = document.querySelectorAll<SVGSVGElement>('.row .stencils svg')[sides.indexOf(side)];
  const { selected } = app.state.get();
  return drawn && selected !== null ? text(`${stem(app)}-vertex-${selected}-${side}.svg`, standalone(drawn)) : null;
}

const styled = ['fill', 'stroke', 'stroke-width', 'stroke-dasharray', 'stroke-linecap', 'stroke-linejoin', 'font'];

/** An SVG that needs no style sheet. */
export function standalone(drawn: SVGSVGElement): string {
  const copy = drawn.cloneNode(true) as SVGSVGElement;
  const originals = [drawn, ...drawn.querySelectorAll<SVGElement>('*')];
  for (const [k, element] of [copy, ...copy.querySelectorAll<SVGElement>('*')].entries()) {
    const style = getComputedStyle(originals[k] as SVGElement);
    for (const property of styled) element.setAttribute(property, style.getPropertyValue(property));
    element.removeAttribute('class');
  }
  const { width, height } = drawn.viewBox.baseVal;
  copy.setAttribute('xmlns', 'http://www.w3.org/2000/svg');
  copy.setAttribute('width', String(width));
  copy.setAttribute('height', String(height));
  copy.removeAttribute('aria-hidden');
  return new XMLSerializer().serializeToString(copy);
}

export const pictureName = (app: App, view: string) => `${stem(app)}-${view}.png`;

/** Hands a file to the browser. */
export function save({ name, contents }: SavedFile): void {
  const url = URL.createObjectURL(contents);
  const link = document.createElement('a');
  link.href = url;
  link.download = name;
  link.click();
  setTimeout(() => URL.revokeObjectURL(url), 60_000);
}
