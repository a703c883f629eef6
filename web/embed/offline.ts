/** The script of a figure in a file of its own, see offline.mjs: it has both languages in it, and shows one. */
import '../figures/page.css';
import './offline.css';
import { hydrateAll, type Mounted } from '../figures/mount.js';
import { frameFigure } from './frame-figure.js';
import { isEmbedded, wanted } from './wanted.js';

const main = document.querySelector('main') as HTMLElement;
const other = document.querySelector('template') as HTMLTemplateElement;
const change = document.querySelector('.site-line button') as HTMLButtonElement;

let figures: Mounted[] = hydrateAll(main);

/** Puts what is on screen away, and what was put away on screen. */
function changeLanguage(): void {
  for (const figure of figures) figure.destroy();
  const still = main.querySelector('.still');
  if (still) other.content.querySelector('.still')?.replaceChildren(...still.childNodes);
  const shown = document.createDocumentFragment();
  shown.append(...main.childNodes);
  main.append(other.content);
  other.content.append(shown);
  const { documentElement: page } = document;
  const before = { lang: page.lang, title: document.title, change: change.textContent };
  page.lang = change.lang;
  document.title = other.dataset.title ?? '';
  change.textContent = other.dataset.change ?? '';
  change.lang = before.lang;
  other.dataset.title = before.title;
  other.dataset.change = before.change ?? '';
  figures = hydrateAll(main);
}

change.addEventListener('click', changeLanguage);
if ((wanted().get('lang') ?? navigator.language).startsWith(change.lang)) changeLanguage();
const [figure] = figures;
if (isEmbedded() && figure) frameFigure(figure);
