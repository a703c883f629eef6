/** Computes a figure and shows it as markup; and its link into the full page. */
import type { Client } from '../src/polylap.js';
import { linkOf } from '../src/share.js';
import { type Figure, initialSettings, type Settings } from './figure.js';
import type { Loaded } from './list.js';
import type { Shown } from './markup.js';
import { type Lang, sayer } from './words.js';

/** @param page address of the full page, without a hash */
export async function permalink(figure: Figure, settings: Settings, page: string): Promise<string> {
  const text = figure.file?.(settings);
  const { hash } = await linkOf(figure.state(settings), text === undefined ? null : new Blob([text]));
  return page + hash;
}

interface Wanted {
  lang: Lang;
  fullPage: string;
  /** Those it begins with, unless told. */
  settings?: Settings;
  /** What stands in place of a drawing that is no SVG. */
  picture?: string;
}

export async function render(
  client: Client,
  loaded: Loaded,
  { lang, fullPage, settings: given, picture = '' }: Wanted,
): Promise<Shown> {
  const { figure, words } = loaded;
  const settings = given ?? initialSettings(figure);
  const link = await permalink(figure, settings, fullPage);
  const shown = { ...loaded, lang, settings, permalink: link };
  if (figure.kind === 'compared')
    return { ...shown, drawing: picture, readings: await figure.compute(client, settings) };
  const data = await figure.compute(client, settings);
  return { ...shown, drawing: figure.draw(data, settings, sayer(words)), readings: figure.read(data, settings) };
}
