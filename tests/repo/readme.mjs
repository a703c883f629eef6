// The parts of the README that are made from the operator table:  node tests/repo/readme.mjs  writes them anew.
import { readFileSync, realpathSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { fileURLToPath } from 'node:url';
import { operatorTable, root } from './files.mjs';

const marks = /(<!-- operators: made by npm run generate -->\n)[\s\S]*?(<!-- end of operators -->)/;
const claimWords = { yes: 'yes', planar: 'planar faces', triangles: 'triangles', no: 'no' };

function describe(parameter) {
  if (parameter.kind === 'choice') {
    const initial = parameter.choices[parameter.initial] ?? parameter.initial;
    return `\`${parameter.id}\`: ${parameter.choices.map((choice) => (choice === initial ? `**${choice}**` : choice)).join(', ')}`;
  }
  return `\`${parameter.id}\` ∈ [${parameter.min}, ${parameter.max}], **${parameter.initial}**`;
}

/** The table of operators with their parameters (defaults in bold) and claims, and where each comes from. */
export function operatorMarkdown(table) {
  const row = (cells) => `| ${cells.join(' | ')} |\n`;
  const claimed = ['symmetric', 'positiveSemidefinite', 'constantsInKernel', 'linearPrecision', 'positiveWeights'];
  const head = ['Operator', 'Parameters', 'Symmetric', 'PSD', 'S 1 = 0', 'Linear precision', 'Weights ≥ 0'];
  const rows = table.map(({ id, label, parameters, claims }) => {
    const names = parameters.map(describe).join('<br>') || '–';
    return row([`${label}<br>\`${id}\``, names, ...claimed.map((claim) => claimWords[claims[claim].where])]);
  });
  const sources = table.map(({ label, summary, citation }) => `- **${label}.** ${summary} ${citation}.\n`);
  return `\n${row(head)}${row(head.map(() => '---'))}${rows.join('')}\n${sources.join('')}\n`;
}

/** The README as it should be. */
export function updated(readme, table) {
  if (!marks.test(readme)) throw new Error('the README has no marks around the operators');
  return readme.replace(marks, (_, open, close) => open + operatorMarkdown(table) + close);
}

/** The fenced code blocks of one language, in order. */
export const codeBlocks = (readme, language) =>
  [...readme.matchAll(/^```(\w+)\n([\s\S]*?)^```$/gm)]
    .filter((block) => block[1] === language)
    .map((block) => block[2]);

if (process.argv[1] && realpathSync(process.argv[1]) === fileURLToPath(import.meta.url)) {
  const path = join(root, 'README.md');
  writeFileSync(path, updated(readFileSync(path, 'utf8'), operatorTable()));
}
