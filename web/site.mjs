/** Where the site will be, for those who need its whole address: where `npm start` serves it, unless POLYLAP_SITE is set when it is built. */
export const site = new URL((process.env.POLYLAP_SITE ?? 'http://localhost:4173').replace(/\/?$/, '/'));

/** Whether others can reach it. */
export const isPublished = !['localhost', '127.0.0.1', '0.0.0.0', '[::1]'].includes(site.hostname);
