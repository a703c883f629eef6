/** Figures as files, for the build: nothing of it goes into a page. */
import type { Client } from '../src/polylap.js';
import { type Figure, initialSettings, type Settings } from './figure.js';
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
<nav class="site-line"><a class="home" href="${home}">polylap</a><a href="${up}${list}">${say('all')}</a><span class="spring"></span><a href="${other}" hreflang="${otherLang}" lang="${otherLang}">${say('other')}</a></nav>
<main>
${body}
</main>
</body>
</html>
`;
}

/** Paths in the site → text: the pages of all figures in all languages, their posters, their lists. */
export async function figureFiles(
  client: Client,
  options: Pick<Frame, 'scripts' | 'styles'> & Pick<RenderOptions, 'style' | 'picture'> & { site: URL },
): Promise<Map<string, string>> {
  const { scripts, styles, style, picture, site } = options;
  const files = new Map<string, string>();
  for (const lang of languages) {
    const [folder, up] = lang === 'en' ? ['figures/', '../'] : [`figures/${lang}/`, '../../'];
    const sideways = lang === 'en' ? 'de/' : '../';
    const { shared } = await load(ids[0], lang);
    const say = sayer(shared);
    const cards: string[] = [];
    for (const id of ids) {
      const fullPage = `${up}index.html${lang === 'en' ? '' : `?lang=${lang}`}`;
      const figure = await renderFigure(client, id, {
        lang,
        fullPage,
        ...(style && { style }),
        ...(picture && { picture }),
      });
      const number = tag('span', { class: 'number' }, say('figure', { number: figure.number }));
      const offline = tag(
        'p',
        { class: 'offline' },
        tag('a', { href: `${up}offline/${id}.html${lang === 'en' ? '' : `?lang=${lang}`}` }, say('offline')),
      );
      const body = [
        tag('h1', {}, number, escapeText(figure.title)),
        figure.html,
        tag('div', { class: 'beside' }, figure.text),
        offline,
      ].join('\n');
      const frame = {
        up,
        lang,
        scripts,
        styles,
        title: figure.title,
        description: figure.alt,
        other: `${sideways}${id}.html`,
        oembed: new URL(oembedPath(id, lang), site).href,
      };
      files.set(oembedPath(id, lang), oembed(figure, new URL(`${folder}${id}.html`, site), site));
      files.set(`${folder}${id}.html`, await pageHtml(frame, body));
      if (lang === 'en') files.set(`figures/${id}.svg`, figure.poster);
      const poster = tag('img', { src: `${up}figures/${id}.svg`, alt: '', loading: 'lazy' });
      const name = tag('span', {}, number, tag('span', { class: 'name' }, escapeText(figure.title)));
      cards.push(tag('li', {}, tag('a', { href: `${id}.html` }, poster, name)));
    }
    const body = [
      tag('h1', {}, say('figures')),
      tag('p', { class: 'intro' }, say('intro')),
      tag('ul', { class: 'figure-list' }, ...cards),
    ].join('\n');
    const frame = {
      up,
      lang,
      scripts,
      styles,
      title: say('figures'),
      description: say('intro'),
      other: `${sideways}index.html`,
    };
    files.set(`${folder}index.html`, await pageHtml(frame, body));
  }
  return files;
}
