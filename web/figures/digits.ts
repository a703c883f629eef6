/** Numbers of figures as the language writes them. */

import { decimals } from '../src/digits.js';
import { exact } from '../src/format.js';
import type { Figure, Reading } from './figure.js';
import type { Lang } from './words.js';

/** Where the decimal mark is a comma, semicolons keep numbers apart. */
export const digitsIn = (lang: Lang, text: string): string =>
  lang === 'de' ? decimals(text.replace(/(\d), (?=[−\d])/g, '$1; '), lang) : text;

/** A figure whose drawing and readings are written in a language; what is in the marks of the drawing stays. */
export function written(figure: Figure, lang: Lang): Figure {
  if (lang === 'en') return figure;
  const read = (readings: readonly Reading[]): readonly Reading[] =>
    readings.map((reading) => ({ ...reading, text: digitsIn(lang, reading.text ?? exact(reading.value)) }));
  if (figure.kind === 'compared')
    return { ...figure, compute: async (client, settings) => read(await figure.compute(client, settings)) };
  return {
    ...figure,
    read: (data, settings) => read(figure.read(data, settings)),
    draw: (...given) => figure.draw(...given).replace(/>([^<]+)</g, (_, text: string) => `>${digitsIn(lang, text)}<`),
  };
}
