/** The script of pages with figures. */
import './page.css';
import { followLanguage } from './language.js';
import { hydrateAll } from './mount.js';

followLanguage();
hydrateAll();
