// Markdown of the article and of the class page into HTML, when the site is built. What it knows beyond Markdown:
//   $…$, $$…$$               formulas
//   ## Heading {#id}         the same address in all languages
//   [@key], [@one; @other]   citations of references.json, numbered as they come
//   [#id]                    "Figure 3"
//   ::figure id, ::other     blocks that come from elsewhere, a line each
//   :::exercise Title {#id} … :::answer … :::
import { Marked } from 'marked';
import { inline, mathml } from '../figures/words.mjs';

export const escapeText = (text) =>
  text.replaceAll('&', '&amp;').replaceAll('<', '&lt;').replaceAll('>', '&gt;').replaceAll('"', '&quot;');

const figureLine = /^::figure ([\w-]+)$/gm;
const citation = /\[(@[\w-]+(?:; @[\w-]+)*)\]/;
const keysOf = (list) => list.split('; ').map((key) => key.slice(1));

/** The figures of a text, in order. */
export const figuresOf = (text) => [...text.matchAll(figureLine)].map(([, id]) => id);

/** Where what was asked for is missing, the build ends. */
function wanted(found, what) {
  if (found === undefined || found === -1) throw new Error(`there is no ${what}`);
  return found;
}

/**
 * @param text Markdown
 * @param say words of the interface by name, with {values}
 * @param blocks name of a block → its HTML; for ::figure id it is `figure id`
 * @param references key → {text, doi}
 * @returns the HTML, the headings of levels 2 and 3, and the keys that are cited, in order
 */
export function convert(text, { say, blocks = {}, references = {} }) {
  const figures = figuresOf(text);
  const cited = [];
  const headings = [];
  const times = new Map();
  let exercises = 0;

  const heading = (level, html, isListed = level <= 3) => {
    const [, title, id] = wanted(html.match(/^(.*?)\s*\{#([\w-]+)\}$/s) ?? undefined, `id in the heading ${html}`);
    if (isListed) headings.push({ level, id, title });
    return `<h${level} id="${id}">${title} <a class="anchor" href="#${id}" aria-label="${escapeText(say('link'))}">#</a></h${level}>\n`;
  };

  const cite = (key) => {
    const { text: entry } = wanted(references[key], `reference ${key}`);
    if (!cited.includes(key)) cited.push(key);
    const time = (times.get(key) ?? 0) + 1;
    times.set(key, time);
    return `<a id="cite-${key}-${time}" href="#ref-${key}" role="doc-noteref" title="${escapeText(entry)}">${cited.indexOf(key) + 1}</a>`;
  };

  const extensions = [
    {
      name: 'math-block',
      level: 'block',
      start: (source) => source.match(/^\$\$/m)?.index,
      tokenizer(source) {
        const [raw, latex] = source.match(/^\$\$([^$]+)\$\$(?:\n|$)/) ?? [];
        return raw && { type: 'math-block', raw, latex: latex.trim() };
      },
      renderer: ({ latex }) => `<div class="formula">${mathml(latex, true)}</div>\n`,
    },
    {
      name: 'math',
      level: 'inline',
      start: (source) => source.indexOf('$'),
      tokenizer(source) {
        const [raw] = source.match(/^\$[^$]+\$[.,:;!?)]*/) ?? [];
        return raw && { type: 'math', raw };
      },
      renderer: ({ raw }) => inline(raw),
    },
    {
      name: 'citation',
      level: 'inline',
      start: (source) => source.match(citation)?.index,
      tokenizer(source) {
        const [raw, keys] = source.match(new RegExp(`^${citation.source}`)) ?? [];
        return raw && { type: 'citation', raw, keys: keysOf(keys) };
      },
      renderer: ({ keys }) => `<span class="cite">[${keys.map(cite).join(', ')}]</span>`,
    },
    {
      name: 'figure-name',
      level: 'inline',
      start: (source) => source.match(/\[#[\w-]+\](?!\()/)?.index,
      tokenizer(source) {
        const [raw, id] = source.match(/^\[#([\w-]+)\](?!\()/) ?? [];
        return raw && { type: 'figure-name', raw, id };
      },
      renderer({ id }) {
        const number = wanted(figures.indexOf(id), `figure ${id} in the text`) + 1;
        return `<a href="#figure-${id}">${say('figure', { number })}</a>`;
      },
    },
    {
      name: 'block',
      level: 'block',
      start: (source) => source.match(/^::[a-z]/m)?.index,
      tokenizer(source) {
        const [raw, name] = source.match(/^::([a-z][^\n]*)(?:\n|$)/) ?? [];
        return raw && { type: 'block', raw, block: name.trim() };
      },
      renderer: ({ block }) => `${wanted(blocks[block], `block ${block}`)}\n`,
    },
    {
      name: 'exercise',
      level: 'block',
      start: (source) => source.match(/^:::exercise/m)?.index,
      tokenizer(source) {
        const [raw, title, question, answer] =
          source.match(/^:::exercise ([^\n]+)\n([\s\S]*?)\n:::answer\n([\s\S]*?)\n:::(?:\n|$)/) ?? [];
        if (!raw) return undefined;
        const parts = [question, answer].map((part) => this.lexer.blockTokens(part, []));
        return { type: 'exercise', raw, title: this.lexer.inlineTokens(title), question: parts[0], answer: parts[1] };
      },
      childTokens: ['title', 'question', 'answer'],
      renderer({ title, question, answer }) {
        const number = ++exercises;
        const name = this.parser.parseInline(title);
        return `<section class="exercise">
${heading(3, `<span class="number">${say('exercise', { number })}</span> ${name}`, false)}${this.parser.parse(question)}<details>
<summary>${say('answer')}</summary>
<div class="answer">${this.parser.parse(answer)}</div></details>
</section>\n`;
      },
    },
  ];

  const renderer = {
    heading({ depth, tokens }) {
      return heading(depth, this.parser.parseInline(tokens));
    },
    table(token) {
      const row = (cells, inner) => `<tr>${cells.map(inner).join('')}</tr>\n`;
      const read = ({ tokens }) => this.parser.parseInline(tokens);
      const head = row(token.header, (cell) => `<th scope="col">${read(cell)}</th>`);
      const body = token.rows.map((cells) =>
        row(cells, (cell, k) => (k === 0 ? `<th scope="row">${read(cell)}</th>` : `<td>${read(cell)}</td>`)),
      );
      const labels = token.header.map(({ text: name }) => name).join(', ');
      return `<div class="wide" role="region" tabindex="0" aria-label="${escapeText(labels)}"><table>\n<thead>${head}</thead>\n<tbody>${body.join('')}</tbody>\n</table></div>\n`;
    },
  };

  const html = new Marked({ extensions, renderer }).parse(text);
  return { html, headings, cited };
}

/** The list of what is cited. @param times how often each key is cited in the HTML */
export function referenceList(html, cited, { references, say }) {
  const items = cited.map((key) => {
    const { text, doi } = references[key];
    const link = doi ? ` <a href="https://doi.org/${encodeURI(doi)}">doi.org/${escapeText(doi)}</a>` : '';
    const count = html.split(`id="cite-${key}-`).length - 1;
    const back = Array.from({ length: count }, (_, k) => {
      const label = escapeText(say('back', { number: k + 1 }));
      return ` <a class="back" href="#cite-${key}-${k + 1}" role="doc-backlink" aria-label="${label}">↑</a>`;
    });
    return `<li id="ref-${key}">${escapeText(text)}.${link}${back.join('')}</li>`;
  });
  return `<ol class="references">\n${items.join('\n')}\n</ol>\n`;
}
