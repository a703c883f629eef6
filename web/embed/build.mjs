// Builds what is embedded and what is carried about, into dist/ beside the page:  node web/embed/build.mjs
import { mkdir, writeFile } from 'node:fs/promises';
import { dirname, join } from 'node:path';
import { fileURLToPath } from 'node:url';
import { build } from 'vite';
import { viteSingleFile } from 'vite-plugin-singlefile';
import { figureWords } from '../figures/words.mjs';
import { inNode, meshPicture } from '../light.mjs';
import { isPublished, site } from '../site.mjs';
import { threeParts } from '../three-parts.mjs';
import { target } from '../vite.config.mjs';
import { inlined, inlinedParts, sealedPage } from './inlined.mjs';
import { offlineFiles } from './offline.mjs';

const web = fileURLToPath(new URL('..', import.meta.url));
const dist = join(web, '../dist');
async function write(name, text) {
  const file = join(dist, name);
  await mkdir(dirname(file), { recursive: true });
  await writeFile(file, text);
}

/** @returns the texts of what is built, by their extensions */
async function built({ plugins = [], ...rest }) {
  const results = await build({
    configFile: false,
    root: web,
    publicDir: false,
    logLevel: 'warn',
    plugins: [threeParts(), figureWords(), ...plugins],
    build: { target, write: false, modulePreload: false, ...rest },
  });
  const { output } = Array.isArray(results) ? results[0] : results;
  const texts = output.map((file) => [file.fileName.replace(/.*\./, ''), file.source ?? file.code]);
  const kinds = new Map(texts);
  if (kinds.size < texts.length) throw new Error(`not one file: ${output.map(({ fileName }) => fileName).join(', ')}`);
  return Object.fromEntries(kinds);
}

/** A script that works as a module and without being one. */
const script = (entry, plugins) =>
  built({
    plugins,
    lib: { entry: join(web, entry), formats: ['iife'], name: 'polylap' },
    rolldownOptions: { output: { codeSplitting: false } },
  });

async function offline(plugins) {
  // Whoever takes the site along has the whole page beside the figures.
  const fullPage = isPublished ? site.href : '../polylap.html';
  const { js, css } = await script('embed/offline.ts', plugins);
  const files = await inNode((node) => {
    const picture = (figure, settings) => meshPicture(node.client, figure.state(settings), node);
    return offlineFiles(node, { script: js, style: css, picture, fullPage });
  });
  for (const [id, text] of files) await write(`offline/${id}.html`, text);
}

const carry = inlined(await inlinedParts());
await Promise.all([
  built({ plugins: [carry, viteSingleFile()] }).then(({ html }) => write('polylap.html', sealedPage(html))),
  script('embed/host.ts').then(({ js }) => write('polylap-frame.js', js)),
  offline([carry]),
]);
