/** What figures say: in both languages the same things, and words for all that is shown. */
import { readdirSync, readFileSync } from 'node:fs';
import { afterAll, beforeAll, describe, expect, it } from 'vitest';
import type { Client } from '../../wasm/src/index.js';
import { createClient } from '../../wasm/src/node.js';
import { type Figure, initialSettings } from '../../web/figures/figure.js';
import { ids, load } from '../../web/figures/list.js';
import { languages, sayer, type Words } from '../../web/figures/words.js';
import { readyWords } from '../../web/figures/words.mjs';

const folder = new URL('../../web/figures/', import.meta.url);
type Tree = string | Tree[] | { [key: string]: Tree };
const read = (path: string): Tree => JSON.parse(readFileSync(new URL(path, folder), 'utf8'));

/** Path → text. */
function leaves(tree: Tree, path = ''): [string, string][] {
  if (typeof tree === 'string') return [[path, tree]];
  return Object.entries(tree).flatMap(([key, below]) => leaves(below as Tree, path ? `${path}.${key}` : key));
}

/** What must be the same in every language: what is filled in, and how many links there are. */
const marks = (text: string) => ({
  filled: (text.replace(/\$\$[^$]*\$\$|\$[^$]*\$/g, '').match(/\{\w+\}/g) ?? []).sort(),
  links: text.split('](').length,
});

const figures = import.meta.glob<Figure>('../../web/figures/*/figure.ts', { import: 'figure' });
const figureOf = (id: string): Promise<Figure> =>
  (figures[`../../web/figures/${id}/figure.ts`] as () => Promise<Figure>)();

let client: Client;
beforeAll(async () => {
  client = await createClient();
});
afterAll(() => client.close());

it('every folder is in the list, in the order of the numbers', async () => {
  const folders = readdirSync(folder, { withFileTypes: true }).filter((entry) => entry.isDirectory());
  expect(folders.map(({ name }) => name).sort()).toEqual([...ids].sort());
  const numbers = await Promise.all(ids.map(async (id) => (await figureOf(id)).number));
  expect(numbers).toEqual([...numbers].sort((one, other) => one - other));
  expect(new Set(numbers).size).toBe(numbers.length);
});

describe.each([['what figures share', ''], ...ids.map((id) => [id, `${id}/`])])('%s', (_, path) => {
  it('says the same in both languages', () => {
    const [english, german] = languages.map((lang) => leaves(read(`${path}${lang}.json`)));
    expect(german?.map(([key]) => key).sort()).toEqual(english?.map(([key]) => key).sort());
    const other = new Map(german);
    for (const [key, text] of english ?? []) expect([key, marks(other.get(key) ?? '')]).toEqual([key, marks(text)]);
  });

  it('says it in words and not in marks', () => {
    for (const lang of languages)
      for (const [key, text] of leaves(readyWords(read(`${path}${lang}.json`)) as Tree)) {
        expect([key, text.trim()]).not.toEqual([key, '']);
        expect(text.replace(/<annotation[\s\S]*?<\/annotation>/g, '')).not.toMatch(/\$|\]\(|\s(style|on\w+)=/);
      }
  });
});

describe.each(ids)('%s', (id) => {
  it('has a word for each number, control and choice, and draws in both languages', async () => {
    const figure = await figureOf(id);
    const settings = initialSettings(figure);
    const data = figure.kind === 'drawn' ? await figure.compute(client, settings) : null;
    const readings = figure.kind === 'drawn' ? figure.read(data, settings) : await figure.compute(client, settings);
    for (const lang of languages) {
      const words = readyWords(read(`${id}/${lang}.json`)) as unknown as Words;
      expect(Object.keys(words.readings).sort()).toEqual(readings.map((reading) => reading.id).sort());
      // Handles have their names from the drawing.
      const named = figure.controls.filter(({ kind }) => kind !== 'handle');
      expect(Object.keys(words.controls).sort()).toEqual(named.map((control) => control.id).sort());
      for (const control of figure.controls)
        if (control.kind === 'choice')
          expect(Object.keys(words.choices?.[control.id] ?? {}).sort()).toEqual([...control.choices].sort());
      if (figure.kind !== 'drawn') continue;
      const drawing = figure.draw(data, settings, sayer(words));
      expect(drawing).toMatch(/^<svg /);
      // Colours are classes, and no policy allows styles in attributes.
      expect(drawing).not.toMatch(/\s(style|fill|stroke|on\w+)=|NaN|undefined/);
    }
  });

  it('writes numbers in German with a comma', async () => {
    const { figure, words } = await load(id, 'de');
    if (figure.kind !== 'drawn') return;
    const settings = initialSettings(figure);
    const data = await figure.compute(client, settings);
    const drawn = [...figure.draw(data, settings, sayer(words)).matchAll(/>([^<]+)</g)].map(([, text]) => text);
    const shown = [...figure.read(data, settings).map(({ text }) => text), ...drawn];
    for (const text of shown) expect(text).not.toMatch(/\d\.\d/);
    expect(shown.some((text) => /\d,\d/.test(text ?? ''))).toBe(true);
  });
});
