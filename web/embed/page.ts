/** The script of polylap.html: the page, or what a frame shows of it. */
import { isEmbedded, wanted } from './wanted.js';
import { names } from './wish.js';

const asked = wanted();
if (isEmbedded() || names.some((name) => name !== 'lang' && asked.has(name))) void import('./frame-page.js');
else void import('../src/main.js');
