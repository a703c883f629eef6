/** One file for each figure, with both languages and all that it takes in it. */
import { sealed } from './inlined.mjs';

const escaped = (text) =>
  text.replaceAll('&', '&amp;').replaceAll('<', '&lt;').replaceAll('>', '&gt;').replaceAll('"', '&quot;');

/** The picture of a mesh says the same in both languages: offline.ts takes it along. */
const still = /(?<=<div class="still" aria-hidden="true">)[\s\S]*?(?=<\/div>)/;

/** Nothing outside is linked to but the whole page: wherever the file is kept, nothing else is beside it. */
const content = (figure, say) =>
  `<h1><span class="number">${say('figure', { number: figure.number })}</span>${escaped(figure.title)}</h1>\n${figure.html}\n<div class="beside">${figure.text}</div>`;

/**
 * @param node what inNode of light.mjs gives
 * @param drawn script and style of figures of that kind, as `compared`
 * @param picture of the mesh of a figure that compares
 * @param fullPage its address
 * @returns by the id of each figure: the text of its file
 */
export async function offlineFiles({ load, client }, { picture, fullPage, ...scripts }) {
  const [{ renderFigure, ids }, { load: figureOf }, { sayer }] = await Promise.all([
    load('figures/render.ts'),
    load('figures/list.ts'),
    load('figures/words.ts'),
  ]);
  const files = new Map();
  for (const id of ids) {
    const [english, german] = await Promise.all(
      ['en', 'de'].map(async (lang) => {
        const figure = await renderFigure(client, id, { lang, fullPage, picture });
        const loaded = await figureOf(id, lang);
        const say = sayer(loaded.shared);
        return { ...figure, kind: loaded.figure.kind, content: content(figure, say), change: say('other') };
      }),
    );
    const { js, css } = scripts[english.kind];
    const title = (figure) => escaped(`${figure.title} · polylap`);
    files.set(
      id,
      sealed(
        `<!doctype html>
<html lang="en">
<head>
<meta charset="utf-8">
<meta name="viewport" content="width=device-width, initial-scale=1">
<title>${title(english)}</title>
<meta name="description" content="${escaped(english.alt)}">
<link rel="icon" href="data:,">
<style>${css}</style>
</head>
<body>
<nav class="site-line"><span class="home">polylap</span><span class="spring"></span><button type="button" lang="de">${english.change}</button></nav>
<main>
${english.content}
</main>
<template data-title="${title(german)}" data-change="${german.change}">
${german.content.replace(still, '')}
</template>
</body>
</html>
`,
        js,
      ),
    );
  }
  return files;
}
