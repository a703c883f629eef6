/** The table of properties: the same code measures and writes it when the site is built and in the page. */
import { escapeText } from '../figures/svg.js';
import type { Client, Measurement, OperatorInfo, PropertyId, ShapeSpec } from '../src/polylap.js';
import { operators, properties } from '../src/polylap.js';

/** Meshes that tell operators apart, by the names that they have among the words; the first is measured when the site is built. */
export const meshes: Readonly<Record<string, ShapeSpec>> = {
  'skew-grid': { shape: 'skew-grid' },
  grid: { shape: 'grid', nx: 8, ny: 8 },
  'concave-hexagons': { shape: 'concave-hexagons' },
  voronoi: { shape: 'voronoi' },
  saddle: { shape: 'saddle', n: 8, height: 0.6 },
  'noisy-torus': { shape: 'torus', nu: 16, nv: 8, noise: 0.3, seed: 1 },
  'hexagon-sphere': { shape: 'hexagon-sphere' },
  'ico-sphere': { shape: 'ico-sphere' },
};

export const firstMesh = 'skew-grid';

export interface Found {
  readonly verdict: Measurement['verdict'];
  /** How many entries of the matrix are negative weights, where the property is about them. */
  readonly count: number | null;
}

export interface Measured {
  readonly mesh: string;
  readonly vertices: number;
  readonly faces: number;
  /** null where an operator refuses the mesh. */
  readonly operators: Readonly<Record<string, Readonly<Partial<Record<PropertyId, Found>>> | null>>;
}

/** @throws PolylapError when the mesh cannot be made */
export async function measure(client: Client, name: string): Promise<Measured> {
  const mesh = await client.make(meshes[name] as ShapeSpec);
  try {
    const found: Record<string, Measured['operators'][string]> = {};
    for (const { id } of operators) found[id] = await check({ id });
    return { mesh: name, vertices: mesh.vertices, faces: mesh.faces, operators: found };
  } finally {
    await mesh.close();
  }

  async function check(spec: Pick<OperatorInfo, 'id'>) {
    const checked = await mesh.check(spec).catch(() => null);
    if (!checked) return null;
    const { measurements, negativeOrdered } = checked;
    return Object.fromEntries(
      measurements.map(({ property, verdict }) => [
        property,
        { verdict, count: property === 'positiveWeights' && verdict === 'fails' ? negativeOrdered : null },
      ]),
    );
  }
}

/** The words of the table. */
export interface TableWords {
  readonly caption: string;
  readonly operator: string;
  readonly choose: string;
  readonly again: string;
  readonly built: string;
  readonly measuring: string;
  readonly live: string;
  readonly failed: string;
  readonly claims: Readonly<Record<string, string>>;
  readonly verdicts: Readonly<Record<Measurement['verdict'], string>>;
  readonly meshes: Readonly<Record<string, string>>;
  readonly operators: Readonly<Record<string, string>>;
  readonly properties: Readonly<Record<string, string>>;
}

const signs: Record<Measurement['verdict'], string> = { holds: '✓', fails: '✗', 'not-measured': '–' };

const fill = (text: string, values: Readonly<Record<string, string | number>>) =>
  text.replace(/\{(\w+)\}/g, (_, name: string) => String(values[name] ?? ''));

export function status(measured: Measured, when: 'built' | 'live', words: TableWords): string {
  const { mesh, vertices, faces } = measured;
  return fill(words[when], { mesh: words.meshes[mesh] ?? mesh, vertices, faces });
}

export function foundText({ verdict, count }: Found, words: TableWords): string {
  return count === null ? words.verdicts[verdict] : `${words.verdicts[verdict]}, ${count}`;
}

export const foundSign = ({ verdict }: Found): string => signs[verdict];

/** What was found of a property: a study of many meshes is not among what one mesh can show. */
export const foundOf = (measured: Measured, operator: string, property: PropertyId): Found =>
  measured.operators[operator]?.[property] ?? { verdict: 'not-measured', count: null };

/** Relations stay on one line. */
const unbroken = (text: string) => text.replaceAll(/(?<=\S) (?=[\d=≥])|(?<=[=≥]) /g, '\u00a0');

export function tableHtml(measured: Measured, words: TableWords): string {
  const columns = properties.map(
    ({ id, label }) => `<th scope="col">${unbroken(escapeText(words.properties[id] ?? label))}</th>`,
  );
  const rows = operators.map(({ id, label, claims }) => {
    const cells = properties.map(({ id: property }) => {
      const { where } = claims[property];
      const found = foundOf(measured, id, property);
      return `<td data-property="${property}" data-claim="${where}" data-verdict="${found.verdict}"><span class="claim">${escapeText(words.claims[where] ?? where)}</span> <span class="found"><span class="sign" aria-hidden="true">${foundSign(found)}</span> <span class="word">${escapeText(foundText(found, words))}</span></span></td>`;
    });
    return `<tr data-operator="${id}"><th scope="row">${escapeText(words.operators[id] ?? label)}</th>${cells.join('')}</tr>`;
  });
  const options = Object.keys(meshes).map(
    (mesh) =>
      `<option value="${mesh}"${mesh === measured.mesh ? ' selected' : ''}>${escapeText(words.meshes[mesh] ?? mesh)}</option>`,
  );
  return `<div class="measured" id="property-table" data-words="${escapeText(JSON.stringify(words))}">
<form autocomplete="off"><label>${escapeText(words.choose)} <select name="mesh">${options.join('')}</select></label> <button type="submit">${escapeText(words.again)}</button></form>
<p class="when" role="status">${escapeText(status(measured, 'built', words))}</p>
<div class="wide" role="region" tabindex="0" aria-label="${escapeText(words.caption)}"><table aria-label="${escapeText(words.caption)}">
<thead><tr><th scope="col">${escapeText(words.operator)}</th>${columns.join('')}</tr></thead>
<tbody>${rows.join('\n')}</tbody></table></div>
</div>`;
}
