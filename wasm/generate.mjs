// Writes src/generated.ts from the operator table of the built module:  node wasm/generate.mjs
import { readFile, writeFile } from 'node:fs/promises';
import { pathToFileURL } from 'node:url';
import temml from 'temml';

const target = new URL('src/generated.ts', import.meta.url);
const build = new URL('../build/wasm/', import.meta.url);

const quote = (text) => `'${text.replaceAll('\\', '\\\\').replaceAll("'", "\\'")}'`;
const key = (name) => (/^[a-z]\w*$/i.test(name) ? name : quote(name));
const typeName = (id) => id.replace(/(?:^|-)(.)/g, (_, letter) => letter.toUpperCase());
const union = (names) => names.map((name) => `\n  | ${quote(name)}`).join('');

/** A value as TypeScript, one entry a line. */
function literal(value, indent = '') {
  const inner = `${indent}  `;
  const block = (open, lines, close) =>
    lines.length ? `${open}\n${lines.map((line) => `${inner}${line},\n`).join('')}${indent}${close}` : open + close;
  if (typeof value === 'string') return quote(value);
  if (typeof value !== 'object') return String(value);
  if (Array.isArray(value))
    return block(
      '[',
      value.map((item) => literal(item, inner)),
      ']',
    );
  return block(
    '{',
    Object.entries(value).map(([name, item]) => `${key(name)}: ${literal(item, inner)}`),
    '}',
  );
}

function specType({ id, label, summary, parameters }) {
  const fields = parameters.map((parameter) => {
    const choice = parameter.kind === 'choice';
    const type = choice ? parameter.choices.map(quote).join(' | ') : 'number';
    const notes = [parameter.label, parameter.hint, choice ? '' : `in [${parameter.min}, ${parameter.max}]`];
    return `  /** ${notes.filter(Boolean).join('; ')}; default ${parameter.initial}. */\n  ${key(parameter.id)}?: ${type};\n`;
  });
  return `/** ${label}. ${summary} */\nexport interface ${typeName(id)}Spec {\n  id: ${quote(id)};\n${fields.join('')}}\n`;
}

/** Without inline styles, which a strict content security policy would refuse. */
const mathml = (latex) =>
  temml.renderToString(latex, { displayMode: true, throwOnError: true }).replaceAll(/ style="[^"]*"/g, '');

/** The text of generated.ts for a table and the core's error codes. */
export function generate(table, properties, errorCodes) {
  const operators = table.map((info) => ({ ...info, formulaMathml: mathml(info.formulaLatex) }));
  return `// Made from the operator table by wasm/generate.mjs; do not edit.
import type { OperatorInfo, PropertyInfo } from './types.js';

export type ErrorCode =${union(errorCodes)};

export type PropertyId =${union(properties.map(({ id }) => id))};

export type OperatorId =${union(table.map(({ id }) => id))};

${table.map(specType).join('\n')}
/** Which operator, with which parameters; what is left out takes its default. */
export type OperatorSpec = ${table.map(({ id }) => `${typeName(id)}Spec`).join(' | ')};

/** The operator table, in the order of menus. */
export const operators: readonly OperatorInfo[] = ${literal(operators)};

/** The property table. */
export const properties: readonly PropertyInfo[] = ${literal(properties)};
`;
}

/** The text that generated.ts should have. */
export async function generateFromBuild() {
  const { default: createModule } = await import(new URL('polylap.js', build));
  const module = await createModule({ wasmBinary: await readFile(new URL('polylap.wasm', build)) });
  return generate(module.operators().ok, module.properties().ok, module.errorCodes().ok);
}

if (import.meta.url === pathToFileURL(process.argv[1] ?? '').href) await writeFile(target, await generateFromBuild());
