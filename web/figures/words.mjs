// The words of figures: JSON as people write it, with $LaTeX$, *emphasis* and [links](address), into HTML when the site is built.
import { readFile } from 'node:fs/promises';
import temml from 'temml';

/** Whatever is not below these is plain text. */
const prose = ['caption', 'try', 'why', 'sources', 'readings', 'controls'];

const escapeText = (text) =>
  text.replaceAll('&', '&amp;').replaceAll('<', '&lt;').replaceAll('>', '&gt;').replaceAll('"', '&quot;');

/** Without inline styles, which a strict content security policy would refuse. */
export const mathml = (latex, displayMode = false) =>
  temml.renderToString(latex, { displayMode, throwOnError: true }).replaceAll(/ style="[^"]*"/g, '');

/** A formula with the point after it, which would begin the next line otherwise. */
export function inline(part) {
  const end = part.lastIndexOf('$');
  const [formula, after] = [mathml(part.slice(1, end)), part.slice(end + 1)];
  return after ? `<span class="joined">${formula}${after}</span>` : formula;
}

/** @param text with $…$, $$…$$, *…* and […](…) */
export function html(text) {
  return text
    .split(/(\$\$[^$]+\$\$|\$[^$]+\$[.,:;!?)]*)/)
    .map((part) => {
      if (part.startsWith('$$')) return mathml(part.slice(2, -2), true);
      if (part.startsWith('$')) return inline(part);
      return escapeText(part)
        .replaceAll(/\*([^*]+)\*/g, '<em>$1</em>')
        .replaceAll(/\[([^\]]+)\]\(([^)\s]+)\)/g, '<a href="$2">$1</a>');
    })
    .join('');
}

function each(value, change) {
  if (typeof value === 'string') return change(value);
  if (Array.isArray(value)) return value.map((entry) => each(entry, change));
  return Object.fromEntries(Object.entries(value).map(([key, entry]) => [key, each(entry, change)]));
}

/** The words as a figure uses them. */
export const readyWords = (words) =>
  Object.fromEntries(
    Object.entries(words).map(([key, value]) => [key, prose.includes(key) ? each(value, html) : value]),
  );

/** Vite: what is imported from en.json and de.json of figures is ready to be shown. */
export const figureWords = () => ({
  name: 'figure-words',
  enforce: 'pre',
  async load(id) {
    if (!/\/web\/figures\/(?:[^/]+\/)?(?:en|de)\.json$/.test(id)) return null;
    try {
      return JSON.stringify(readyWords(JSON.parse(await readFile(id, 'utf8'))));
    } catch (error) {
      throw new Error(`${id}: ${error.message}`);
    }
  },
});
