/** Takes the place of home.ts where the script is that of a full page. */
export { ownAddress as fullPage } from '../src/place.js';
