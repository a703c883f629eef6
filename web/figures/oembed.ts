/** What programs ask for that are given the address of a figure and are to show it: oEmbed 1.0 (https://oembed.com), as JSON. */
import type { Rendered } from './render.js';
import { tag } from './svg.js';
import type { Lang } from './words.js';

/** Of a frame, in px. */
const width = 720;

/** As figure.css lays it out in a frame of that width, or a little more; the frame tells the page around what it really takes. */
function heightOf({ html, poster }: Rendered): number {
  const count = (pattern: RegExp) => html.match(pattern)?.length ?? 0;
  const [, drawn = 1, tall = 0] = (poster.match(/viewBox="0 0 ([\d.]+) ([\d.]+)"/) ?? []).map(Number);
  // See poster.ts.
  const pictures = Math.max(1, (poster.match(/<svg x=/g) ?? []).length);
  const aspect = (tall - 32) / ((drawn - 32 - 24 * (pictures - 1)) / pictures);
  const drawing = pictures === 1 ? 600 * aspect : Math.ceil(pictures / 2) * (330 * aspect + 12);
  const controls = 55 + 36 * Math.min(1, Math.floor(count(/<label class="slider"|<fieldset/g) / 2));
  const readings = 31 * Math.ceil(count(/<dt>/g) / 2);
  const caption = html.replace(/^[\s\S]*<figcaption>/, '').replace(/<[^>]*>/g, '');
  return Math.ceil(drawing + controls + readings + 30 + 23 * Math.ceil(caption.length / 82) + 136);
}

/** In the site. */
export const oembedPath = (id: string, lang: Lang): string => `oembed/${lang === 'en' ? '' : `${lang}/`}${id}.json`;

/** @param page address of the figure's page @param site where the site is */
export function oembed(figure: Rendered, page: URL, site: URL): string {
  const { id, title, poster } = figure;
  const [, drawn = 0, tall = 0] = (poster.match(/viewBox="0 0 ([\d.]+) ([\d.]+)"/) ?? []).map(Number);
  const height = heightOf(figure);
  const src = new URL('?embed', page).href;
  return JSON.stringify({
    type: 'rich',
    version: '1.0',
    title,
    provider_name: 'polylap',
    provider_url: site.href,
    html: tag('iframe', { src, title, width, height, loading: 'lazy', 'data-polylap': '' }, ''),
    width,
    height,
    thumbnail_url: new URL(`figures/${id}.svg`, site).href,
    thumbnail_width: Math.round(drawn),
    thumbnail_height: Math.round(tall),
  });
}
