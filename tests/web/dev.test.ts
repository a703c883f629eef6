/** `npm run dev`: the light pages are made when they are asked for. */
import { fileURLToPath } from 'node:url';
import { createServer, type ViteDevServer } from 'vite';
import { afterAll, beforeAll, expect, it } from 'vitest';

const file = (path: string) => fileURLToPath(new URL(`../../web/${path}`, import.meta.url));
let server: ViteDevServer;
let url: string;
beforeAll(async () => {
  const config = { root: file(''), configFile: file('vite.config.mjs'), logLevel: 'error' as const };
  server = await createServer({ ...config, server: { port: 0, host: 'localhost' } });
  await server.listen();
  url = server.resolvedUrls?.local[0] ?? '';
});
afterAll(() => server.close());

const get = async (path: string) => {
  const answer = await fetch(url + path, { headers: { accept: 'text/html' } });
  return [answer.status, await answer.text()] as const;
};

it.each([
  ['figures/', /<h1>/],
  ['figures/two-cuts.html', /data-reading="w02" data-value="-0\.2006/],
  ['figures/de/two-cuts.html', /<html lang="de">/],
  ['figures/negative-weights.svg', /^<svg /],
  ['thesis/index.html', /<article|<main/],
])('%s is there', async (path, content) => {
  const [status, text] = await get(path);
  expect([status, content.test(text)]).toEqual([200, true]);
});

it('pages have the scripts of the sources, which the server has', async () => {
  const [, page] = await get('figures/two-cuts.html');
  const script = page.match(/<script type="module" src="\.\.\/([^"]+)"/)?.[1];
  expect(script).toBe('figures/page.ts');
  const [status, code] = await get(script ?? '');
  expect([status, code]).toEqual([200, expect.stringContaining('hydrateAll')]);
});

it('the full page is still there', async () => {
  const [status, page] = await get('');
  expect([status, page]).toEqual([200, expect.stringContaining('main.ts')]);
});
