// Builds what is embedded and what is carried about, into dist/ beside the page:  node web/embed/build.mjs
import { mkdir, writeFile } from 'node:fs/promises';
import { dirname, join } from 'node:path';
import { fileURLToPath } from 'node:url';
import { build } from 'vite';
import { viteSingleFile } from 'vite-plugin-singlefile';
import { figureWords } from '../figures/words.mjs';
import { inNode, meshPicture } from '../light.mjs';
import { replace } from '../replace.mjs';
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

/** How long plugins take is nobody's concern. */
const quiet = { checks: { pluginTimings: false } };

/** @returns the texts of what is built, by their extensions */
async function built({ plugins = [], ...rest }) {
  const results = await build({
    configFile: false,
    root: web,
    publicDir: false,
    logLevel: 'warn',
    plugins: [threeParts(), figureWords(), ...plugins],
    build: { target, write: false, modulePreload: false, rolldownOptions: quiet, ...rest },
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
    rolldownOptions: { ...quiet, output: { codeSplitting: false } },
  });

async function offline(parts) {
  // Whoever takes the site along has the whole page beside the figures.
  const fullPage = isPublished ? site.href : '../polylap.html';
  const isMesh = (path) => path.startsWith('meshes/');
  const noCompared = replace({ 'web/figures/compared': 'web/embed/only-drawn.ts' });
  const [compared, drawn] = await Promise.all([
    script('embed/offline.ts', [homeIs("''"), inlined(parts, isMesh)]),
    script('embed/offline.ts', [homeIs("''"), inlined(parts, () => false), noCompared]),
  ]);
  const files = await inNode((node) => {
    const picture = (figure, settings) => meshPicture(node.client, figure.state(settings), node);
    return offlineFiles(node, { compared, drawn, picture, fullPage });
  });
  for (const [id, text] of files) await write(`offline/${id}.html`, text);
}

/** What home.ts takes for the address of its script. */
const homeIs = (code) => ({
  name: 'home',
  enforce: 'pre',
  transform: (text, id) => (id.endsWith('/web/embed/home.ts') ? text.replace('import.meta.url', code) : null),
});

/** The page with another script. */
const entry = {
  name: 'entry',
  transformIndexHtml: { order: 'pre', handler: (html) => html.replace('./src/main.ts', './embed/page.ts') },
};

const parts = await inlinedParts();
const carry = inlined(parts);
const page = [entry, replace({ 'web/embed/home': 'web/embed/page-home.ts' }), carry, viteSingleFile()];
// Of a module there is no currentScript, and elsewhere no import.meta.
const own = `(document.currentScript ?? document.querySelector('script[src*="polylap-compare"]'))?.src`;
await Promise.all([
  built({ plugins: page }).then(({ html }) => write('polylap.html', sealedPage(html))),
  script('embed/element.ts', [homeIs(own), carry]).then(({ js }) => write('polylap-compare.js', js)),
  script('embed/host.ts').then(({ js }) => write('polylap-frame.js', js)),
  offline(parts),
]);
