// The parts of the README that are made from the operator table:  node tests/repo/readme.mjs  writes them anew.
import { readFileSync, realpathSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { fileURLToPath } from 'node:url';
import { readTables } from '../../wasm/generate.mjs';
import { root } from './files.mjs';

export { readTables };

const marks = /(<!-- operators: made by npm run generate -->\n)[\s\S]*?(<!-- end of operators -->)/;
const claimWords = {
  yes: 'yes',
  planar: 'planar faces',
  triangles: 'triangles',
  some: 'some parameters',
  no: '**no**',
};

const row = (cells) => `| ${cells.map((cell) => cell.replaceAll('|', '\\|')).join(' | ')} |\n`;
const grid = (head, rows) => row(head) + row(head.map(() => '---')) + rows.map(row).join('');
const html = (text) => text.replaceAll('&', '&amp;').replaceAll('<', '&lt;');

function describe(parameter) {
  if (parameter.kind === 'choice') {
    const choices = parameter.choices.map((choice) => (choice === parameter.initial ? `**${choice}**` : choice));
    return `\`${parameter.id}\`: ${choices.join(', ')}`;
  }
  const range = `[${parameter.min}, ${parameter.max}]${parameter.kind === 'integer' ? ', whole' : ''}`;
  return `\`${parameter.id}\` ∈ ${range}, **${parameter.initial}**`;
}

/** Of one operator: what it is, what it takes (defaults in bold), from where it comes, and why it claims what it claims. */
function reasons({ id, label, summary, citation, parameters, takesVertexWeights, claims }, properties) {
  const takes = parameters.map(describe);
  if (takesVertexWeights) takes.push('a weight ω per vertex, **0**');
  const head = `<b>${html(label)}</b>, <code>${id}</code>. ${html(summary)}`;
  const lines = properties.map((property) => {
    const { where, why } = claims[property.id];
    return [property.label, claimWords[where], why];
  });
  const table = grid(['Property', 'Holds', 'Why'], lines);
  const parameterLine = takes.length > 0 ? `Parameters: ${takes.join('; ')}.\n\n` : '';
  return `<details>\n<summary>${head}</summary>\n\n${parameterLine}${citation}.\n\n${table}\n</details>\n`;
}

/** The “no free lunch” table: operators × properties, and the reasons to be unfolded. */
export function operatorMarkdown({ operators, properties }) {
  const table = grid(
    ['Operator', ...properties.map(({ label }) => label)],
    operators.map(({ label, claims }) => [label, ...properties.map(({ id }) => claimWords[claims[id].where])]),
  );
  const meanings = properties.map(({ label, meaning }) => `- *${label}*: ${meaning}\n`).join('');
  return `\n${table}\n${meanings}\n${operators.map((info) => reasons(info, properties)).join('')}\n`;
}

/** The README as it should be. */
export function updated(readme, tables) {
  if (!marks.test(readme)) throw new Error('the README has no marks around the operators');
  return readme.replace(marks, (_, open, close) => open + operatorMarkdown(tables) + close);
}

/** The fenced code blocks of one language, in order. */
export const codeBlocks = (readme, language) =>
  [...readme.matchAll(/^```(\w+)\n([\s\S]*?)^```$/gm)]
    .filter((block) => block[1] === language)
    .map((block) => block[2]);

if (process.argv[1] && realpathSync(process.argv[1]) === fileURLToPath(import.meta.url)) {
  const path = join(root, 'README.md');
  writeFileSync(path, updated(readFileSync(path, 'utf8'), await readTables()));
}
