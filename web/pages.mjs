// Makes the light pages in dist/, beside the full page: figures, the article, and how to use them in class:  node web/pages.mjs  Needs the wasm preset,
// build/public and the node packages.
import { mkdir, writeFile } from 'node:fs/promises';
import { pathToFileURL } from 'node:url';
import { classFiles } from './class/build.mjs';
import { bundle, inNode, meshPicture, pictureStyle } from './light.mjs';
import { site } from './site.mjs';
import { thesisFiles } from './thesis/build.mjs';

/**
 * @param load imports a module of web/
 * @param filesOf the scripts and styles that a page with this source needs
 * @returns paths in the site → texts
 */
export async function lightFiles({ load, client, filesOf }) {
  const { figureFiles } = await load('figures/render.ts');
  const style = await pictureStyle();
  const picture = (figure, settings) => meshPicture(client, figure.state(settings), { load });
  return new Map([
    ...(await figureFiles(client, { ...filesOf('figures/page.ts'), style, picture, site })),
    ...(await thesisFiles({ load, client, filesOf, picture })),
    ...(await classFiles({ load, filesOf, site })),
  ]);
}

async function main() {
  const dist = new URL('../dist/', import.meta.url);
  const filesOf = await bundle();
  const files = await inNode(({ load, client }) => lightFiles({ load, client, filesOf }));
  for (const [path, text] of files) {
    const file = new URL(path, dist);
    await mkdir(new URL('.', file), { recursive: true });
    await writeFile(file, text);
  }
}

if (import.meta.url === pathToFileURL(process.argv[1] ?? '').href) await main();
