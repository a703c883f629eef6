/** The script of pages with figures. */
import './page.css';
import { isEmbedded } from '../embed/wanted.js';
import { followLanguage } from './language.js';
import { hydrateAll } from './mount.js';
import { reachWide } from './wide.js';

followLanguage();
const [figure] = hydrateAll();
if (figure && isEmbedded()) void import('../embed/frame-figure.js').then(({ frameFigure }) => frameFigure(figure));
reachWide(document.querySelectorAll('math[display="block"]'));
