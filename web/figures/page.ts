/** The script of pages with figures. */
import './page.css';
import { hydrateAll } from './mount.js';

const wanted = new URLSearchParams(location.search).get('lang');
const other = document.querySelector<HTMLAnchorElement>(`a[hreflang="${CSS.escape(wanted ?? '')}"]`);
if (wanted && wanted !== document.documentElement.lang && other) location.replace(other.href);
hydrateAll();
