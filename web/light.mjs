// What the light pages are made with: modules of the site run in Node, on the real core.
import { readFile, rm } from 'node:fs/promises';
import { fileURLToPath } from 'node:url';
import { build, createServer } from 'vite';
import config from './light.config.mjs';
import { nodeFiles } from './node-files.mjs';
import { thumbnail } from './thumbnail.mjs';

const dist = new URL('../dist/', import.meta.url);

/** Builds the scripts and styles. @returns for a source file below web/: the files that a page needs, as paths in the site */
export async function bundle() {
  await build({ ...config, logLevel: 'warn' });
  const manifest = new URL('light.json', dist);
  const chunks = JSON.parse(await readFile(manifest, 'utf8'));
  await rm(manifest);
  return (source) => {
    const { file, css = [] } = chunks[source];
    return { scripts: [file], styles: css };
  };
}

/**
 * @param use gets `load`, which imports a module of web/ or wasm/, and a client in this thread
 */
export async function inNode(use) {
  const server = await createServer({
    ...config,
    plugins: [...config.plugins, nodeFiles()],
    logLevel: 'error',
    appType: 'custom',
    optimizeDeps: { noDiscovery: true },
    server: { middlewareMode: true, hmr: false, ws: false, watch: null, fs: { allow: ['..'] } },
  });
  const load = (path) => server.ssrLoadModule(fileURLToPath(new URL(path, import.meta.url)));
  try {
    const { createClient } = await load('../wasm/src/node.ts');
    const client = await createClient();
    try {
      return await use({ load, client });
    } finally {
      client.close();
    }
  } finally {
    await server.close();
  }
}

/** The style of a picture that stands alone. */
export async function pictureStyle() {
  const read = (path) => readFile(new URL(path, import.meta.url), 'utf8');
  const [palette, drawing] = await Promise.all(['src/styles/palette.css', 'figures/drawing.css'].map(read));
  const own =
    ':root{--face:light-dark(#efece4,#252a33);--mesh-line:light-dark(#4d4d52,#aeb4c0)}.paper{fill:var(--card)}';
  return `${palette}${drawing}${own}`
    .replaceAll(/\/\*[\s\S]*?\*\//g, '')
    .replaceAll(/\s+/g, ' ')
    .replaceAll(/ ?([{};,>]) ?/g, '$1')
    .trim();
}

/** The mesh of a state as a picture. @param client what can make it */
export async function meshPicture(client, { source }, { load }) {
  const { presets } = await load('src/state.ts');
  const { made, yUp } = await meshOf(client, source, presets);
  const { geometry, boundary } = made;
  return thumbnail(geometry, { closed: boundary.length === 0, yUp });
}

async function meshOf(client, source, presets) {
  const preset = source.kind === 'preset' ? presets.find(({ id }) => id === source.id) : null;
  const shape = preset ? preset.shape : { shape: source.shape?.id, ...source.shape?.parameters };
  const path = preset?.file;
  let made = path
    ? await client.open(await readFile(new URL(`../build/public/${path}`, import.meta.url)), path)
    : await client.make(shape);
  const changes = [
    ...(preset?.change ? [preset.change] : []),
    ...(source.changes ?? []).map(({ id, parameters }) => ({ conversion: id, ...parameters })),
  ];
  for (const change of changes) made = await made.convert(change);
  return { made, yUp: path !== undefined };
}
