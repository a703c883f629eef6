/**
 * The words of the page. The English text in the sources is the key to every other language, which is loaded when it is asked for: English costs nothing.
 * One language for the document, however many pages are in it.
 */
import { count } from './digits.js';

export type Language = 'en' | 'de';
export type Values = Readonly<Record<string, string | number>>;

/** What another language brings along; null where it has no words for a text. */
export interface Translation {
  text: (english: string) => string | null;
  /** Of messages that were composed elsewhere, with numbers and names in them. */
  message: (english: string) => string | null;
}

const translations: Readonly<Record<Exclude<Language, 'en'>, () => Promise<Translation>>> = {
  de: async () => (await import('./words/german.js')).german,
};

let chosen: { language: Language; translation: Translation | null } = { language: 'en', translation: null };

export const language = (): Language => chosen.language;

/** From then on; what is on screen already stays as it is. @throws Error when the words cannot be loaded */
export async function setLanguage(wanted: Language): Promise<void> {
  chosen = { language: wanted, translation: wanted === 'en' ? null : await translations[wanted]() };
}

/** The first of the tags that is of a language there is: `de-AT` is German. */
export function languageOf(...tags: readonly (string | null | undefined)[]): Language {
  for (const tag of tags) {
    const primary = tag?.split('-')[0]?.toLowerCase();
    if (primary === 'en' || primary === 'de') return primary;
  }
  return 'en';
}

/**
 * A text in the language of the page.
 * @param english with `{name}` where a value goes. A text about `{n}` things has its forms between bars, as many as
 * Intl.PluralRules tells apart in the language, `one` before `other`: `{n} face|{n} faces`.
 */
export function t(english: string, values?: Values): string {
  const text = chosen.translation?.text(english) ?? english;
  return values ? filled(text, values) : text;
}

/** A text of a table that is read before the language is known: `t` is due when it is shown. */
/* @__NO_SIDE_EFFECTS__ */
export const word = (english: string): string => english;

/** A message of the core, or one that was thrown: in English where there are no words for it. */
export const told = (english: string): string => chosen.translation?.message(english) ?? english;

function filled(text: string, values: Values): string {
  const { n } = values;
  const forms = n === undefined ? [text] : text.split('|');
  const one = forms.length > 1 && new Intl.PluralRules(chosen.language).select(Number(n)) === 'one';
  return (forms[one ? 0 : forms.length - 1] as string).replace(/\{(\w+)\}( ?)/g, (_, name: string, space: string) =>
    // A number stays with what it counts.
    name === 'n' ? count(Number(n)) + space.replace(' ', '\u00a0') : `${values[name]}${space}`,
  );
}
