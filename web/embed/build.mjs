// Builds what is embedded and what is carried about, into dist/ beside the page:  node web/embed/build.mjs
import { writeFile } from 'node:fs/promises';
import { join } from 'node:path';
import { fileURLToPath } from 'node:url';
import { build } from 'vite';
import { viteSingleFile } from 'vite-plugin-singlefile';
import { threeParts } from '../three-parts.mjs';
import { target } from '../vite.config.mjs';
import { inlined, inlinedParts, sealed } from './inlined.mjs';

const web = fileURLToPath(new URL('..', import.meta.url));
const dist = join(web, '../dist');
const parts = await inlinedParts();

/** @returns the text of one of the files that are built */
const take = (built, ending) => {
  const files = built.output.filter(({ fileName }) => fileName.endsWith(ending));
  if (built.output.length !== 1 || files.length !== 1)
    throw new Error(`not one file: ${built.output.map(({ fileName }) => fileName)}`);
  return files[0].source ?? files[0].code;
};

/** The page as one file. */
const page = await build({
  configFile: false,
  root: web,
  publicDir: false,
  logLevel: 'warn',
  plugins: [threeParts(), inlined(parts), viteSingleFile()],
  build: { target, write: false, modulePreload: false },
});
await writeFile(join(dist, 'polylap.html'), sealed(take(page, '.html')));
