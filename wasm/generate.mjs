// Writes src/generated.ts from the operator table of the built module:  node wasm/generate.mjs
import { readFile, writeFile } from 'node:fs/promises';
import { pathToFileURL } from 'node:url';
import temml from 'temml';

const target = new URL('src/generated.ts', import.meta.url);
const build = new URL('../build/wasm/', import.meta.url);

const quote = (text) => `'${text.replaceAll('\\', '\\\\').replaceAll("'", "\\'").replaceAll('\n', '\\n')}'`;
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

const makerNoise = [
  '  /** Noise along the normals, in mean edge lengths; default 0. */\n  noise?: number;\n',
  '  /** Of the noise; whole, below 2³²; default 1. */\n  seed?: number;\n',
];

/** An interface: what it is by `tag`, then every parameter, all optional. */
function specType(tag, { id, label, summary, parameters }, name, more = []) {
  const fields = parameters.map((parameter) => {
    const choice = parameter.kind === 'choice';
    const type = choice ? parameter.choices.map(quote).join(' | ') : 'number';
    const range = `${parameter.kind === 'integer' ? 'whole, ' : ''}in [${parameter.min}, ${parameter.max}]`;
    const notes = [parameter.label, parameter.hint, choice ? '' : range];
    return `  /** ${notes.filter(Boolean).join('; ')}; default ${parameter.initial}. */\n  ${key(parameter.id)}?: ${type};\n`;
  });
  const body = [...fields, ...more.filter((field) => !fields.some((own) => lastName(own) === lastName(field)))].join(
    '',
  );
  return `/** ${label}. ${summary} */\nexport interface ${name} {\n  ${tag}: ${quote(id)};\n${body}}\n`;
}

const lastName = (field) => field.match(/(\S+)\?:[^:]*$/)?.[1];

/** The interfaces of a table and their union. */
function specTypes(tag, table, ending, doc, more = () => []) {
  const name = ({ id }) => typeName(id) + ending;
  const types = table.map((info) => specType(tag, info, name(info), more(info)));
  const own = `${typeName(tag === 'id' ? 'operator' : tag)}Spec`;
  return `${types.join('\n')}\n/** ${doc} */\nexport type ${own} = ${table.map(name).join(' | ')};\n`;
}

const vertexWeights = ['  /** ω, one per vertex, length²; default all 0. */\n  vertexWeights?: ArrayLike<number>;\n'];

/** Without inline styles, which a strict content security policy would refuse. */
const mathml = (latex) =>
  temml.renderToString(latex, { displayMode: true, throwOnError: true }).replaceAll(/ style="[^"]*"/g, '');

/** The text of generated.ts. @param tables see readTables */
export function generate({ operators, properties, shapes, conversions, errorCodes }) {
  const set = operators.map((info) => ({ ...info, formulaMathml: mathml(info.formulaLatex) }));
  const ids = (table) => union(table.map(({ id }) => id));
  const weighted = ({ takesVertexWeights }) => (takesVertexWeights ? vertexWeights : []);
  return `// Made from the tables of the core by wasm/generate.mjs; do not edit.
import type { MakerInfo, OperatorInfo, PropertyInfo } from './types.js';

export type ErrorCode =${union(errorCodes)};

export type PropertyId =${ids(properties)};

export type OperatorId =${ids(operators)};

${specTypes('id', operators, 'Spec', 'Which operator, with which parameters; what is left out takes its default.', weighted)}
${specTypes('shape', shapes, 'Shape', 'Which shape to make; what is left out takes its default.', () => makerNoise)}
${specTypes('conversion', conversions, 'Conversion', 'What to make of a mesh; what is left out takes its default.')}
/** The operator table, in the order of menus. */
export const operators: readonly OperatorInfo[] = ${literal(set)};

/** The property table. */
export const properties: readonly PropertyInfo[] = ${literal(properties)};

/** The shape table, in the order of menus. All shapes take noise and its seed besides their own parameters. */
export const shapes: readonly MakerInfo[] = ${literal(shapes)};

/** The conversion table, in the order of menus. */
export const conversions: readonly MakerInfo[] = ${literal(conversions)};
`;
}

/** The tables of the core, from the built module. */
export async function readTables() {
  const { default: createModule } = await import(new URL('polylap.js', build));
  const module = await createModule({ wasmBinary: await readFile(new URL('polylap.wasm', build)) });
  const names = ['operators', 'properties', 'shapes', 'conversions', 'errorCodes'];
  return Object.fromEntries(names.map((name) => [name, module[name]().ok]));
}

if (import.meta.url === pathToFileURL(process.argv[1] ?? '').href)
  await writeFile(target, generate(await readTables()));
