// "Use it in class": what people copy is in snippets/, which the tests run.
import { readdir, readFile } from 'node:fs/promises';
import { articleHtml, begin, frameOf, json, pathOf, sayer } from '../thesis/article.mjs';
import { convert, escapeText } from '../thesis/markdown.mjs';

const here = (path) => new URL(path, import.meta.url);

/** @param address where the site is, with a / at its end @returns name → text */
export async function snippets(address) {
  const names = await readdir(here('snippets/'));
  const read = async (name) => (await readFile(here(`snippets/${name}`), 'utf8')).trimEnd();
  const texts = await Promise.all(
    names.map(async (name) => [name, (await read(name)).replaceAll('{{site}}', address)]),
  );
  return Object.fromEntries(texts);
}

/** The script copies the text with the address that the page has. */
const snippetHtml = (name, text, words) =>
  `<div class="snippet" data-snippet="${name}"><pre><code>${escapeText(text)}</code></pre><button type="button" data-copied="${escapeText(words.copied)}" data-selected="${escapeText(words.selected)}">${escapeText(words.copy)}</button></div>`;

async function figureTable(lang, words, { load }) {
  const { ids, load: figure } = await load('figures/list.ts');
  const rows = await Promise.all(
    ids.map(async (id) => {
      const { title } = (await figure(id, lang)).words;
      const page = `../figures/${lang === 'en' ? '' : `${lang}/`}${id}.html`;
      return `<tr><th scope="row"><a href="${page}">${escapeText(title)}</a></th><td><code>${id}</code></td><td><a href="../offline/${id}.html">${escapeText(words.file)}</a></td></tr>`;
    }),
  );
  const head = [words.figureTitle, words.figureId, words.offlineFile];
  const cells = head.map((name) => `<th scope="col">${escapeText(name)}</th>`).join('');
  return `<div class="wide" role="region" tabindex="0" aria-label="${escapeText(head.join(', '))}"><table><thead><tr>${cells}</tr></thead>\n<tbody>${rows.join('\n')}</tbody></table></div>`;
}

/** @param site its address @returns path in the site → text */
export async function classFiles({ load, filesOf, site }) {
  const { pageHtml } = await load('figures/render.ts');
  const files = new Map();
  for (const lang of ['en', 'de']) {
    const words = await json(here(`${lang}.json`));
    const text = await readFile(here(`${lang}.md`), 'utf8');
    const entries = Object.entries(await snippets(site.href));
    const blocks = Object.fromEntries(
      entries.map(([name, snippet]) => [`snippet ${name}`, snippetHtml(name, snippet, words)]),
    );
    blocks.figures = await figureTable(lang, words, { load });
    const { html, headings } = convert(`${words.lead}\n\n${begin}\n\n${text}`, { say: sayer(words), blocks });
    const page = articleHtml(words, html, headings).replace(
      '<div class="text">',
      `<div class="text" data-site="${escapeText(site.href)}">`,
    );
    files.set(pathOf('class', lang), await pageHtml({ ...frameOf(lang, words), ...filesOf('class/class.ts') }, page));
  }
  return files;
}
