/** All figures there are, each loaded when it is wanted. A new one is its folder, with figure.ts, en.json and de.json, and its id here. */
import { written } from './digits.js';
import type { Figure } from './figure.js';
import type { Lang, Shared, Words } from './words.js';

/** In the order of their numbers, which is that of the article. */
export const ids: readonly [string, ...string[]] = [
  'dirichlet-energy',
  'circumcentric-dual',
  'power-weights',
  'vector-area',
  'checkerboard',
  'one-interior-vertex',
  'maximum-principle',
  'negative-weights',
  'two-cuts',
  'orthogonal-dual',
  'noisy-smoothing',
  'soap-film',
];

const figures = import.meta.glob<Figure>('./*/figure.ts', { import: 'figure' });
const words = import.meta.glob<Words>('./*/{en,de}.json', { import: 'default' });
const shared = import.meta.glob<Shared>('./{en,de}.json', { import: 'default' });

/** A figure with what it says. */
export interface Loaded {
  readonly figure: Figure;
  readonly words: Words;
  readonly shared: Shared;
}

export type Load = (id: string, lang: Lang) => Promise<Loaded>;

/** @throws Error where there is no such figure, or it cannot be had */
export const load: Load = async (id, lang) => {
  const from = <T>(all: Record<string, () => Promise<T>>, path: string): Promise<T> => {
    const found = all[path];
    if (!found) throw new Error(`there is no figure ${id}`);
    return found();
  };
  const [figure, own, common] = await Promise.all([
    from(figures, `./${id}/figure.ts`),
    from(words, `./${id}/${lang}.json`),
    from(shared, `./${lang}.json`),
  ]);
  return { figure: written(figure, lang), words: own, shared: common };
};
