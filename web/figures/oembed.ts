/** What programs ask for that are given the address of a figure and are to show it: oEmbed 1.0 (https://oembed.com), as JSON. */
import type { Rendered } from './render.js';
import { tag } from './svg.js';
import type { Lang } from './words.js';

/** Of a frame, in px; it tells the page around what it really takes. */
const width = 720;
/** What controls, numbers and caption take, at most. */
const below = 420;

/** In the site. */
export const oembedPath = (id: string, lang: Lang): string => `oembed/${lang === 'en' ? '' : `${lang}/`}${id}.json`;

/** @param page address of the figure's page @param site where the site is */
export function oembed({ id, title, poster }: Rendered, page: URL, site: URL): string {
  const [, drawn = 0, tall = 0] = (poster.match(/viewBox="0 0 ([\d.]+) ([\d.]+)"/) ?? []).map(Number);
  const height = Math.ceil(tall * Math.min(1, width / drawn)) + below;
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
