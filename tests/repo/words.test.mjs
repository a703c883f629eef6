// The page's words in other languages: none is missing, none is left over, and all take the values that the English ones take.
import { afterEach, describe, expect, it } from 'vitest';
import { conversions, operators, properties, shapes } from '../../wasm/src/generated.ts';
import { words as choiceWords } from '../../web/src/format.ts';
import { language, languageOf, setLanguage, t, told } from '../../web/src/words.ts';
import { repositoryFiles } from './files.mjs';

const files = repositoryFiles();
const { texts, messages } = JSON.parse(files['web/src/words/de.json']);
const sources = (pattern) => Object.entries(files).filter(([path]) => pattern.test(path));

/** What t() and word() are called with, in the sources. */
function spoken() {
  const found = new Set();
  const literal = /\b(?:t|word)\(\s*(?:'((?:[^'\\]|\\.)*)'|"((?:[^"\\]|\\.)*)")/g;
  const text = (inner) => inner.replace(/\\(.)/g, '$1');
  for (const [, source] of sources(/^web\/(src|embed)\/.*\.ts$/))
    for (const [, single, double] of source.matchAll(literal)) found.add(text(single ?? double));
  return found;
}

/** What the page takes from the tables of the core, as it shows it. */
function fromTables() {
  const makers = [...operators, ...shapes, ...conversions];
  const parameters = makers.flatMap((maker) => maker.parameters);
  return new Set(
    [
      ...makers.flatMap(({ label, summary }) => [label, summary]),
      ...conversions.map(({ label }) => label.toLowerCase()),
      ...operators.flatMap(({ claims }) => Object.values(claims).flatMap(({ where, why }) => [where, why])),
      ...properties.flatMap(({ label, meaning }) => [label, meaning]),
      ...parameters.flatMap(({ label, hint, choices = [] }) => [label, hint, ...choices.map(choiceWords)]),
    ].filter(Boolean),
  );
}

/** Whatever the core and the page can say, with the pieces of long literals together. */
const said = sources(/^(core\/src|core\/include|wasm\/(src|bindings)|web\/src)\/.*\.(cpp|hpp|ts)$/)
  .map(([, source]) => source.replace(/"\s*\n\s*"/g, ''))
  .join('\n');

const placeholders = (text) => [...text.matchAll(/\{([*#]?\w+)\}/g)].map(([, name]) => name.replace('#', '')).sort();
const known = new Set([...spoken(), ...fromTables()]);

afterEach(() => setLanguage('en'));

describe('German', () => {
  it('has a text for all that is said', () => {
    expect(known.size).toBeGreaterThan(600);
    expect([...known].filter((key) => !(key in texts))).toEqual([]);
  });

  it('has no text that nobody says', () => {
    const stale = Object.keys(texts).filter((key) => !known.has(key) && !said.includes(`"${key}"`));
    expect(stale).toEqual([]);
  });

  it('takes the same values', () => {
    const unlike = Object.entries(texts).filter(([key, text]) => {
      const forms = key.split('|');
      if (!key.includes('{n}') || forms.length === 1) return `${placeholders(key)}` !== `${placeholders(text)}`;
      const others = text.split('|');
      return (
        forms.length !== others.length ||
        forms.some((form, k) => `${placeholders(form)}` !== `${placeholders(others[k])}`)
      );
    });
    expect(unlike).toEqual([]);
    expect(messages.filter(([key, text]) => `${placeholders(key)}` !== `${placeholders(text)}`)).toEqual([]);
  });

  it('keeps what stands around a text', () => {
    const edge = (text) => [/^\s/, /\s$/, /^,/].map((end) => end.test(text)).join();
    const unlike = Object.entries(texts).filter(([key, text]) => edge(key) !== edge(text));
    // After the letter of a side that claims something.
    expect(unlike.map(([key]) => key)).toEqual([' claims {where}: {why}.']);
    expect(Object.entries(texts).filter(([key, text]) => key.endsWith('.') && !text.endsWith('.'))).toEqual([]);
  });

  it('reads messages that there are', () => {
    const pieces = (pattern) => pattern.split(/\{[*#]?\w+\}/).map((piece) => piece.trim());
    const words = (piece) => piece.split(/[^\p{L}]+/u).filter((word) => word.length > 3);
    const strange = messages.filter(([key]) =>
      pieces(key)
        .flatMap(words)
        .some((word) => !said.includes(word)),
    );
    expect(strange).toEqual([]);
    expect(new Set(messages.map(([key]) => key)).size).toBe(messages.length);
  });

  it('reads each message by its own pattern, whatever stands before it', async () => {
    await setLanguage('de');
    const values = (name) => (name.startsWith('#') ? '7' : name.startsWith('*') ? 'cancelled' : "'k'");
    const others = (name) => (name.startsWith('*') ? 'abgebrochen' : values(name));
    const wrong = messages.flatMap(([key, text]) => {
      const filled = key.replace(/\{([*#]?\w+)\}/g, (_, name) => values(name));
      const names = new Map([...key.matchAll(/\{([*#]?\w+)\}/g)].map(([, name]) => [name.replace('#', ''), name]));
      const expected = text.replace(/\{(\*?\w+)\}/g, (_, name) => others(names.get(name)));
      return told(filled) === expected ? [] : [`${filled} → ${told(filled)}`];
    });
    expect(wrong).toEqual([]);
  });

  it('is spoken once it is loaded, and numbers choose their form', async () => {
    expect([language(), t('Weights'), t('{n} face|{n} faces', { n: 1 })]).toEqual(['en', 'Weights', '1\u00a0face']);
    await setLanguage('de');
    expect(language()).toBe('de');
    expect(t('Weights')).toBe('Gewichte');
    expect(t('{n} face|{n} faces', { n: 1 })).toBe('1\u00a0Facette');
    expect(t('{n} face|{n} faces', { n: 2048 })).toBe('2\u202f048\u00a0Facetten');
    expect(t('and {some} more', { some: '$&' })).toBe('und $& weitere');
    expect(t('said by nobody')).toBe('said by nobody');
    await setLanguage('en');
    expect(t('Weights')).toBe('Weights');
  });

  it('says a composed message as a whole or not at all', async () => {
    await setLanguage('de');
    expect(told('line 3: face 0 has 2 corners, fewer than 3')).toBe('Zeile 3: Facette 0 hat 2 Ecken, weniger als 3');
    expect(told('face 12: its vector area is zero')).toBe('Facette 12: die Vektorfläche ist null');
    expect(told("line 1: vertex 0 has 'x.5', which is no finite number")).toBe(
      "Zeile 1: Knoten 0 hat 'x.5', das ist keine endliche Zahl",
    );
    expect(told('the smallest eigenvalue is -1.5e-16, the largest 8.25')).toBe(
      'der kleinste Eigenwert ist -1,5e-16, der größte 8,25',
    );
    expect(told('face 12: something that nobody has words for')).toBe('face 12: something that nobody has words for');
    await setLanguage('en');
    expect(told('face 12: its vector area is zero')).toBe('face 12: its vector area is zero');
  });

  it('is asked for by a tag of it', () => {
    expect(languageOf('de')).toBe('de');
    expect(languageOf(null, 'de-AT')).toBe('de');
    expect(languageOf('en', 'de')).toBe('en');
    expect(languageOf('fr', undefined, 'DE')).toBe('de');
    expect(languageOf('fr')).toBe('en');
  });
});
