// What the article and the class page share: words, contents, and what stands around the text.
import { readFile } from 'node:fs/promises';
import { escapeText } from './markdown.mjs';

export const json = async (url) => JSON.parse(await readFile(url, 'utf8'));

export const sayer =
  (words) =>
  (name, values = {}) =>
    words[name].replaceAll(/\{(\w+)\}/g, (_, key) => String(values[key]));

/** Between the introduction and the text, which are converted as one: citations are numbered through. */
export const begin = '<!-- begin -->';

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

/** @param html with `begin` in it @param more what comes after the text */
export function articleHtml(words, html, headings, more = '') {
  const [lead, body] = html.split(begin);
  return `<article class="article">
<header class="opening"><p class="kicker">${escapeText(words.kicker)}</p>
<h1>${escapeText(words.title)}</h1>
${lead}</header>
<nav class="contents" aria-labelledby="contents"><h2 class="name" id="contents">${escapeText(words.contents)}</h2>
${contents(headings)}</nav>
<div class="text">
${body}${more}</div>
</article>`;
}

/** The frame of a page that is there as index.html and as de.html, see figures/render.ts. */
export const frameOf = (lang, { title, description }) => ({
  up: '../',
  lang,
  title,
  description,
  other: lang === 'en' ? 'de.html' : 'index.html',
});

export const pathOf = (folder, lang) => `${folder}/${lang === 'en' ? 'index' : lang}.html`;
