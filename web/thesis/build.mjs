// The article: Markdown of en/ and de/, with the figures and the measured table in their places.
import { readdir, readFile } from 'node:fs/promises';
import { convert, escapeText, figuresOf, referenceList } from './markdown.mjs';

const here = (path) => new URL(path, import.meta.url);
const json = async (path) => JSON.parse(await readFile(here(path), 'utf8'));

export const sayer =
  (words) =>
  (name, values = {}) =>
    words[name].replaceAll(/\{(\w+)\}/g, (_, key) => String(values[key]));

async function sections(lang) {
  const names = (await readdir(here(`${lang}/`))).filter((name) => name.endsWith('.md')).sort();
  const texts = await Promise.all(names.map((name) => readFile(here(`${lang}/${name}`), 'utf8')));
  return texts.join('\n');
}

/** Headings as nested lists. */
function contents(headings) {
  const link = ({ id, title }) => `<a href="#${id}">${title}</a>`;
  const chapters = headings.filter(({ level }) => level === 2);
  const items = chapters.map((chapter, k) => {
    const from = headings.indexOf(chapter) + 1;
    const to = k + 1 < chapters.length ? headings.indexOf(chapters[k + 1]) : headings.length;
    const inner = headings.slice(from, to).map((heading) => `<li>${link(heading)}</li>`);
    return `<li>${link(chapter)}${inner.length ? `<ul>${inner.join('')}</ul>` : ''}</li>`;
  });
  return `<ol>${items.join('\n')}</ol>`;
}

/** A figure that is not there yet leaves its place empty. */
function missing(error) {
  if (!/^there is no figure/.test(error.message)) throw error;
  console.warn(error.message);
  return '';
}

/**
 * @param load imports a module of web/, see ../light.mjs
 * @returns path in the site → text
 */
export async function thesisFiles({ load, client, filesOf, ...pictures }) {
  const { pageHtml, renderFigure } = await load('figures/render.ts');
  const { firstMesh, measure, tableHtml } = await load('thesis/measured.ts');
  const measured = await measure(client, firstMesh);
  const references = await json('references.json');
  const files = new Map();
  for (const lang of ['en', 'de']) {
    const words = await json(`${lang}.json`);
    const say = sayer(words);
    const text = await sections(lang);
    const fullPage = lang === 'en' ? '../index.html' : `../index.html?lang=${lang}`;
    const blocks = { measured: tableHtml(measured, words.table) };
    for (const [k, id] of figuresOf(text).entries()) {
      const html = await renderFigure(client, id, { lang, fullPage, number: k + 1, ...pictures }).then(
        (made) => made.html,
        missing,
      );
      blocks[`figure ${id}`] = html;
    }
    // One text with its introduction, so that citations are numbered through.
    const mark = '<!-- begin -->';
    const all = convert(`${words.lead}\n\n${words.reading}\n\n${mark}\n\n${text}`, { say, blocks, references });
    const [lead, body] = all.html.split(mark);
    const headings = [...all.headings, { level: 2, id: 'references', title: escapeText(words.references) }];
    const page = `<article class="article">
<header class="opening"><p class="kicker">${escapeText(words.kicker)}</p>
<h1>${escapeText(words.title)}</h1>
${lead}</header>
<nav class="contents" aria-labelledby="contents"><h2 class="name" id="contents">${escapeText(words.contents)}</h2>
${contents(headings)}</nav>
<div class="text">
${body}<h2 id="references">${escapeText(words.references)}</h2>
${referenceList(all.html, all.cited, { references, say })}</div>
</article>`;
    files.set(
      lang === 'en' ? 'thesis/index.html' : `thesis/${lang}.html`,
      await pageHtml(
        {
          up: '../',
          lang,
          title: words.title,
          description: words.description,
          other: lang === 'en' ? 'de.html' : 'index.html',
          ...filesOf('thesis/article.ts'),
        },
        page,
      ),
    );
  }
  return files;
}
