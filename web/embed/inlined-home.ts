/** Takes the place of home.ts in a file that is the full page itself. */
export { ownAddress as fullPage } from '../src/place.js';
