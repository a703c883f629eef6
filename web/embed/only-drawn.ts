/** Takes the place of figures/compared.ts in files of figures that are drawn. */
import type { ComparedPage } from '../figures/compared.js';

export async function startCompared(): Promise<ComparedPage> {
  throw new Error('There are only drawings in this file.');
}
