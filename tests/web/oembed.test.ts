/** What programs learn that are given the address of a figure. */
import { existsSync, readdirSync, readFileSync } from 'node:fs';
import { join } from 'node:path';
import { describe, expect, it } from 'vitest';
import { dist, useSite } from './browser.js';

const server = useSite();
const text = (path: string) => readFileSync(join(dist, path), 'utf8');
const ids = readdirSync(join(dist, 'figures'))
  .filter((name) => name.endsWith('.svg'))
  .map((name) => name.replace('.svg', ''));
const languages = [
  ['en', ''],
  ['de', 'de/'],
] as const;
const cases = ids.flatMap((id) => languages.map(([lang, folder]) => ({ id, lang, folder })));

it('is there for every figure, in both languages', () => {
  expect(ids.length).toBeGreaterThan(0);
  for (const { id, folder } of cases) expect(existsSync(join(dist, `oembed/${folder}${id}.json`))).toBe(true);
});

describe.each(cases)('$id, $lang', ({ id, folder }) => {
  const page = text(`figures/${folder}${id}.html`);
  const data = JSON.parse(text(`oembed/${folder}${id}.json`)) as Record<string, string | number>;
  const inSite = (address: unknown) => String(address).replace(String(data.provider_url), '');

  it('is what oEmbed 1.0 asks of rich content, and its page leads to it', () => {
    expect(data).toMatchObject({ type: 'rich', version: '1.0', provider_name: 'polylap' });
    for (const size of ['width', 'height', 'thumbnail_width', 'thumbnail_height'])
      expect(data[size], size).toBeGreaterThan(0);
    const [, title] = page.match(/<title>(.*) · polylap<\/title>/) ?? [];
    expect(data.title).toBe(title);
    const [link] = page.match(/<link rel="alternate" type="application\/json\+oembed"[^>]*>/) ?? [];
    const [, href] = link?.match(/href="([^"]*)"/) ?? [];
    expect(inSite(href)).toBe(`oembed/${folder}${id}.json`);
    expect(existsSync(join(dist, inSite(data.thumbnail_url)))).toBe(true);
    const [, width, height] =
      text(inSite(data.thumbnail_url)).match(/^<svg[^>]* width="([\d.]+)" height="([\d.]+)"/) ?? [];
    expect([data.thumbnail_width, data.thumbnail_height]).toEqual(
      [width, height].map((size) => Math.round(Number(size))),
    );
  });

  it('frames the figure alone, with room for all of it', async () => {
    const context = await server.browser.newContext({ viewport: { width: 800, height: 1000 } });
    const host = await context.newPage();
    const address = new URL('/host', server.url).href;
    await host.route(address, (route) =>
      route.fulfill({
        contentType: 'text/html',
        body: String(data.html).replaceAll(String(data.provider_url), server.url).replace('lazy', 'eager'),
      }),
    );
    await host.goto(address);
    const frame = await (await host.waitForSelector('iframe')).contentFrame();
    if (!frame) throw new Error('there is nothing in the frame');
    await frame.waitForFunction(() => document.documentElement.dataset.embed !== undefined);
    expect(new URL(frame.url()).pathname).toContain(`/figures/${folder}${id}.html`);
    for (const other of ['h1', '.site-line', '.beside'])
      expect(await frame.locator(other).isVisible(), other).toBe(false);
    await frame.locator('.drawing').waitFor();
    const wants = await frame.evaluate(() => Math.ceil(document.documentElement.getBoundingClientRect().height));
    expect(wants).toBeLessThanOrEqual(Number(data.height));
    expect(wants).toBeGreaterThan(Number(data.height) - 160);
    await context.close();
  });
});
