/** Figures as files, for the build: nothing of it goes into a page. */
import type { Client } from '../src/polylap.js';
import { type Figure, initialSettings, type Say, type Settings } from './figure.js';
import { ids, load } from './list.js';
import { figureHtml, type Shown, textHtml } from './markup.js';
import { oembed, oembedPath } from './oembed.js';
import { posterSvg } from './poster.js';
import { render } from './show.js';
import { escapeText, tag } from './svg.js';
import { type Lang, languages, sayer } from './words.js';

export { ids } from './list.js';
export { languages } from './words.js';

export interface Rendered {
  readonly id: string;
  readonly number: number;
  readonly title: string;
  readonly alt: string;
  /** The figure element. */
  readonly html: string;
  /** What to try, why, sources. */
  readonly text: string;
  /** A whole SVG file. */
  readonly poster: string;
}

export interface RenderOptions {
  lang: Lang;
  /** Address of the full page, as seen from where the figure will stand. */
  fullPage: string;
  /** A picture of the mesh of a figure that compares, as SVG. */
  picture?: (figure: Figure, settings: Settings) => Promise<string>;
  /** The style of posters. */
  style?: string;
}

export async function renderFigure(client: Client, id: string, options: RenderOptions): Promise<Rendered> {
  const { lang, fullPage, picture, style = '' } = options;
  const loaded = await load(id, lang);
  const { figure, words } = loaded;
  const mesh = figure.kind === 'compared' ? await picture?.(figure, initialSettings(figure)) : '';
  const shown: Shown = await render(client, loaded, { lang, fullPage, picture: mesh ?? '' });
  return {
    id,
    number: figure.number,
    title: words.title,
    alt: words.alt,
    html: figureHtml(shown),
    text: textHtml(loaded),
    poster: posterSvg(shown.drawing, style, words.title),
  };
}

/** What the pages of the site are made around. */
export interface Frame {
  /** From the page to the root of the site: '../' in figures/. */
  up: string;
  lang: Lang;
  title: string;
  description: string;
  /** Address of the page in the other language. */
  other: string;
  scripts: readonly string[];
  styles: readonly string[];
  /** Address of its oEmbed. */
  oembed?: string;
}

/** A whole page of the site with its first line. @param body what stands in main */
export async function pageHtml(frame: Frame, body: string): Promise<string> {
  const { up, lang, title, description, other, scripts, styles, oembed: data } = frame;
  const otherLang = languages.find((one) => one !== lang) as Lang;
  const say = sayer((await load(ids[0], lang)).shared);
  const list = lang === 'en' ? 'figures/index.html' : 'figures/de/index.html';
  const page = lang === 'en' ? 'index' : lang;
  const links = [
    [list, 'figures'],
    [`thesis/${page}.html`, 'article'],
    [`class/${page}.html`, 'class'],
  ]
    .map(([path, name]) => tag('a', { href: `${up}${path}` }, say(name as string)))
    .join('');
  const home = `${up}index.html${lang === 'en' ? '' : `?lang=${lang}`}`;
  return `<!doctype html>
<html lang="${lang}">
<head>
<meta charset="utf-8">
<meta name="viewport" content="width=device-width, initial-scale=1">
<title>${escapeText(title)} · polylap</title>
<meta name="description" content="${escapeText(description)}">
<link rel="icon" href="data:,">
<link rel="alternate" hreflang="${otherLang}" href="${other}">
${data ? `${tag('link', { rel: 'alternate', type: 'application/json+oembed', href: data, title })}\n` : ''}${styles.map((file) => tag('link', { rel: 'stylesheet', href: up + file })).join('\n')}
${scripts.map((file) => tag('script', { type: 'module', src: up + file }, '')).join('\n')}
</head>
<body>
<nav class="site-line"><a class="home" href="${home}">polylap</a>${links}<span class="spring"></span><a href="${other}" hreflang="${otherLang}" lang="${otherLang}">${say('other')}</a></nav>
<main>
${body}
</main>
</body>
</html>
`;
}

type Making = Pick<Frame, 'scripts' | 'styles'> & Pick<RenderOptions, 'style' | 'picture'> & { site: URL };

/** Where the pages of a language are. */
const placeOf = (lang: Lang) =>
  lang === 'en'
    ? { folder: 'figures/', up: '../', other: 'de/', query: '' }
    : { folder: `figures/${lang}/`, up: '../../', other: '../', query: `?lang=${lang}` };

/** Paths in the site → text: the pages of all figures in all languages, their posters, their lists. */
export async function figureFiles(client: Client, making: Making): Promise<Map<string, string>> {
  const { style, picture, site } = making;
  const files = new Map<string, string>();
  for (const lang of languages) {
    const { folder, up, query } = placeOf(lang);
    const say = sayer((await load(ids[0], lang)).shared);
    const all: Rendered[] = [];
    for (const id of ids) {
      const fullPage = `${up}index.html${query}`;
      all.push(
        await renderFigure(client, id, { lang, fullPage, ...(style && { style }), ...(picture && { picture }) }),
      );
    }
    for (const [k, figure] of all.entries()) {
      const { id, poster } = figure;
      files.set(oembedPath(id, lang), oembed(figure, new URL(`${folder}${id}.html`, site), site));
      files.set(`${folder}${id}.html`, await figurePage(figure, [all[k - 1], all[k + 1]], lang, making, say));
      if (lang === 'en') files.set(`figures/${id}.svg`, poster);
    }
    files.set(`${folder}index.html`, await listPage(all, lang, making, say));
  }
  return files;
}

const numberOf = ({ number }: Rendered, say: Say): string =>
  tag('span', { class: 'number' }, say('figure', { number }));

type Neighbours = readonly [Rendered | undefined, Rendered | undefined];

function figurePage(figure: Rendered, beside: Neighbours, lang: Lang, making: Making, say: Say): Promise<string> {
  const { id, title } = figure;
  const { up, other, query } = placeOf(lang);
  const { scripts, styles, site } = making;
  const offline = tag('a', { class: 'offline', href: `${up}offline/${id}.html${query}` }, say('offline'));
  const ways = (['prev', 'next'] as const).map((rel, k) => {
    const to = beside[k];
    if (!to) return tag('span', {}, '');
    return tag('a', { rel, href: `${to.id}.html` }, numberOf(to, say), escapeText(to.title));
  });
  const body = [
    tag('h1', {}, numberOf(figure, say), escapeText(title)),
    figure.html,
    tag('div', { class: 'beside' }, figure.text),
    offline,
    tag('nav', { class: 'ways', 'aria-label': say('ways') }, ...ways),
  ].join('\n');
  const oembedAddress = new URL(oembedPath(id, lang), site).href;
  const frame = { up, lang, scripts, styles, title, description: figure.alt, other: `${other}${id}.html` };
  return pageHtml({ ...frame, oembed: oembedAddress }, body);
}

function listPage(all: readonly Rendered[], lang: Lang, making: Making, say: Say): Promise<string> {
  const { up, other } = placeOf(lang);
  const { scripts, styles } = making;
  const cards = all.map((figure) => {
    const { id, title } = figure;
    const poster = tag('img', { src: `${up}figures/${id}.svg`, alt: '', loading: 'lazy' });
    const name = tag('span', {}, numberOf(figure, say), tag('span', { class: 'name' }, escapeText(title)));
    return tag('li', {}, tag('a', { href: `${id}.html` }, poster, name));
  });
  const body = [
    tag('h1', {}, say('figures')),
    tag('p', { class: 'intro' }, say('intro')),
    tag('ul', { class: 'figure-list' }, ...cards),
  ].join('\n');
  const frame = { up, lang, scripts, styles, title: say('figures'), description: say('intro') };
  return pageHtml({ ...frame, other: `${other}index.html` }, body);
}
