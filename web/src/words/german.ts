/** German: texts by their English, composed messages by patterns. */
import type { Translation } from '../words.js';
import words from './de.json';
import { type Pattern, reader } from './messages.js';

const texts: Readonly<Record<string, string>> = words.texts;

export const german: Translation = {
  text: (english) => texts[english] ?? null,
  message: reader(words.messages as unknown as Pattern[], texts, (digits) => digits.replace('.', ',')),
};
