// The article: Markdown of en/ and de/, with the figures and the measured table in their places.
import { readdir, readFile } from 'node:fs/promises';
import { articleHtml, begin, frameOf, json, pathOf, sayer } from './article.mjs';
import { convert, escapeText, figuresOf, referenceList } from './markdown.mjs';

const here = (path) => new URL(path, import.meta.url);

async function sections(lang) {
  const names = (await readdir(here(`${lang}/`))).filter((name) => name.endsWith('.md')).sort();
  const texts = await Promise.all(names.map((name) => readFile(here(`${lang}/${name}`), 'utf8')));
  return texts.join('\n');
}

/**
 * @param load imports a module of web/, see ../light.mjs
 * @returns path in the site → text
 */
export async function thesisFiles({ load, client, filesOf, picture }) {
  const { pageHtml, renderFigure } = await load('figures/render.ts');
  const { firstMesh, measure, tableHtml } = await load('thesis/measured.ts');
  const measured = await measure(client, firstMesh);
  const references = await json(here('references.json'));
  const files = new Map();
  for (const lang of ['en', 'de']) {
    const words = await json(here(`${lang}.json`));
    const say = sayer(words);
    const text = await sections(lang);
    const fullPage = lang === 'en' ? '../index.html' : `../index.html?lang=${lang}`;
    const blocks = { measured: tableHtml(measured, words.table) };
    for (const [k, id] of figuresOf(text).entries()) {
      const { html, number } = await renderFigure(client, id, { lang, fullPage, picture });
      if (number !== k + 1) throw new Error(`the article shows figure ${number}, ${id}, as its figure ${k + 1}`);
      blocks[`figure ${id}`] = html;
    }
    const whole = `${words.lead}\n\n${words.reading}\n\n${begin}\n\n${text}`;
    const { html, headings, cited } = convert(whole, { say, blocks, references });
    const title = escapeText(words.references);
    const list = `<h2 id="references">${title}</h2>\n${referenceList(html, cited, { references, say })}`;
    const page = articleHtml(words, html, [...headings, { level: 2, id: 'references', title }], list);
    files.set(
      pathOf('thesis', lang),
      await pageHtml({ ...frameOf(lang, words), ...filesOf('thesis/article.ts') }, page),
    );
  }
  return files;
}
