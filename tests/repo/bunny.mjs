// The README's table of the quad bunny's negative weights:  node tests/repo/bunny.mjs  measures and writes it anew.
import { readFileSync, realpathSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { fileURLToPath } from 'node:url';
import { loadModule, noise, quadBunny } from '../../web/bunny.mjs';
import { root } from './files.mjs';

const marks = /(<!-- bunny: made by npm run generate -->\n)[\s\S]*?(<!-- end of bunny -->)/;

/** What Herholz 2012, p. 31, counts on its own bunny of 5000 vertices. */
const thesis = { 'alexa-wardetzky': [20714, 23950], planar: [30, 680] };

/** Vertices, faces, and the negative weights (ordered pairs) of each operator on the smooth and on the noisy bunny. */
export async function measureBunny() {
  const loaded = await loadModule();
  const { module, get, open } = loaded;
  const smooth = open(await quadBunny(loaded));
  const noisy = get(module.convert(smooth, module.Side.a, 'noise', noise));
  const count = (session, id) => {
    get(session.setOperator(module.Side.a, id, {}, undefined));
    return get(session.weights(module.Side.a, undefined)).negativeOrdered;
  };
  const { vertices, faces, boundary, components } = get(smooth.info());
  const counts = Object.keys(thesis).map((id) => ({ id, smooth: count(smooth, id), noisy: count(noisy, id) }));
  for (const session of [smooth, noisy]) session.delete();
  return { vertices, faces, boundary: boundary.length, components, counts };
}

export function bunnyMarkdown({ vertices, faces, counts }) {
  const head = ['Negative weights, ordered pairs', 'smooth', 'noisy', 'thesis: smooth', 'thesis: noisy'];
  const rows = counts.map(({ id, smooth, noisy }) => [`\`${id}\``, smooth, noisy, ...thesis[id]]);
  const row = (cells) => `| ${cells.join(' | ')} |\n`;
  const table = row(head) + row(head.map(() => '---')) + rows.map(row).join('');
  return `
The quad bunny of the gallery, ${vertices} vertices and ${faces} quads, is made when the site is built: the triangles of the npm package \`bunny\` are simplified, paired into quads and
subdivided once. The noise is ${noise.amplitude} mean edge lengths at most, along the normals, seed ${noise.seed}. The thesis (Herholz 2012, p. 31) counts on a quad bunny and a noise of its own.

${table}
`;
}

/** The README as it should be. */
export function withBunny(readme, measured) {
  if (!marks.test(readme)) throw new Error('the README has no marks around the bunny');
  return readme.replace(marks, (_, open, close) => open + bunnyMarkdown(measured) + close);
}

if (process.argv[1] && realpathSync(process.argv[1]) === fileURLToPath(import.meta.url)) {
  const path = join(root, 'README.md');
  writeFileSync(path, withBunny(readFileSync(path, 'utf8'), await measureBunny()));
}
