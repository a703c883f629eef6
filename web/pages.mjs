// Makes the light pages in dist/, beside the full page: figures, the article, and how to use them in class:  node web/pages.mjs  Needs the wasm preset,
// build/public and the node packages.
import { mkdir, writeFile } from 'node:fs/promises';
import { classFiles } from './class/build.mjs';
import { bundle, inNode, meshPicture, pictureStyle } from './light.mjs';
import { site } from './site.mjs';
import { thesisFiles } from './thesis/build.mjs';

const dist = new URL('../dist/', import.meta.url);
const filesOf = await bundle();
const style = await pictureStyle();
const files = await inNode(async ({ load, client }) => {
  const { figureFiles } = await load('figures/render.ts');
  const picture = (figure, settings) => meshPicture(client, figure.state(settings), { load });
  return new Map([
    ...(await figureFiles(client, { ...filesOf('figures/page.ts'), style, picture, site })),
    ...(await thesisFiles({ load, client, filesOf, picture })),
    ...(await classFiles({ load, filesOf, site })),
  ]);
});
for (const [path, text] of files) {
  const file = new URL(path, dist);
  await mkdir(new URL('.', file), { recursive: true });
  await writeFile(file, text);
}
