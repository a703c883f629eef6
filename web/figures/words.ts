/** What figures say. */
import { exact } from '../src/format.js';
import type { Say } from './figure.js';

export type Lang = 'en' | 'de';
export const languages: readonly Lang[] = ['en', 'de'];

type Nested = string | readonly Nested[] | { readonly [key: string]: Nested };

/** A figure's en.json or de.json as words.mjs makes it: HTML in prose, plain text in the rest. */
export interface Words {
  readonly title: string;
  readonly alt: string;
  readonly caption: string;
  readonly try: readonly string[];
  readonly why: readonly string[];
  readonly sources: readonly string[];
  readonly readings: Readonly<Record<string, string>>;
  readonly controls: Readonly<Record<string, string>>;
  readonly choices?: Readonly<Record<string, Readonly<Record<string, string>>>>;
  readonly [own: string]: Nested | undefined;
}

/** The words that all figures share. */
export type Shared = Readonly<Record<string, string>>;

const filled = (words: string, values: Readonly<Record<string, string | number>> = {}): string =>
  words.replace(/\{(\w+)\}/g, (all, name: string) => {
    const value = values[name];
    return value === undefined ? all : typeof value === 'number' ? exact(value) : value;
  });

/** @throws Error for a word that there is not */
export function sayer(words: Words | Shared): Say {
  return (path, values) => {
    const found = path
      .split('.')
      .reduce<unknown>((level, key) => (level as Record<string, unknown> | undefined)?.[key], words);
    if (typeof found !== 'string') throw new Error(`there is no word for ${path}`);
    return filled(found, values);
  };
}

/** HTML as plain text, for names that only are heard. */
export const plain = (html: string): string =>
  html
    .replace(/<[^>]*>/g, '')
    .replaceAll('&lt;', '<')
    .replaceAll('&gt;', '>')
    .replaceAll('&quot;', '"')
    .replaceAll('&amp;', '&');
