/** Files that carry everything in themselves: they work wherever they are opened, and ask no network for anything. */
import { readdirSync, readFileSync, statSync } from 'node:fs';
import { join } from 'node:path';
import { pathToFileURL } from 'node:url';
import type { Frame, Page } from 'playwright-core';
import { afterAll, beforeAll, describe, expect, it } from 'vitest';
import { dist, tasks, useSite } from './browser.js';

const site = useSite();
const file = (path: string) => join(dist, path);
const text = (path: string) => readFileSync(file(path), 'utf8');

/** The largest that a file may be, in bytes. */
const most = 1_600_000;

interface Visit {
  page: Page;
  /** Where the file is: the page's own frame, or one in it. */
  frame: Frame;
  /** Console errors and warnings, uncaught errors, and what the file's own policy forbade. */
  troubles: string[];
  /** What was asked of any network or disk. */
  requests: string[];
  close: () => Promise<void>;
}

/** Opens something without any network, and listens. */
async function quiet(open: (page: Page) => Promise<Frame>): Promise<Visit> {
  const context = await site.browser.newContext({
    viewport: { width: 1440, height: 900 },
    reducedMotion: 'reduce',
    offline: true,
  });
  context.setDefaultTimeout(30_000);
  const page = await context.newPage();
  const troubles: string[] = [];
  const requests: string[] = [];
  await page.addInitScript(() => {
    document.addEventListener('securitypolicyviolation', ({ effectiveDirective, blockedURI, sample }) =>
      console.error(`forbidden: ${effectiveDirective} ${blockedURI} ${sample}`),
    );
  });
  page.on('console', (message) => {
    // The software renderer reports each screenshot and each pick as slow.
    if (['error', 'warning'].includes(message.type()) && !message.text().includes('GPU stall due to ReadPixels'))
      troubles.push(message.text());
  });
  page.on('pageerror', (error) => troubles.push(`uncaught: ${error.message}`));
  page.on('request', (request) => {
    if (!/^(data|blob):/.test(request.url())) requests.push(request.url());
  });
  return { page, frame: await open(page), troubles, requests, close: () => context.close() };
}

/** As long as anything else may take. */
const eventually = <T>(look: () => Promise<T>) => expect.poll(look, { timeout: 30_000 });

/** Until both sides know their weights; in a frame they are in the element. */
const settled = async (frame: Frame) => {
  for (const side of ['a', 'b']) await eventually(() => read(frame, 'negative', side)).toMatch(/^\d+$/);
};

/** What a readout of a side shows. */
const read = (frame: Frame, name: string, side = 'a') => {
  const readout = `[data-readout="${name}"]`;
  return frame
    .locator(`[data-side="${side}"] ${readout}, [data-of="${side}"]${readout}`)
    .first()
    .getAttribute('data-value');
};

/** Presses a button that may be in the menu. */
async function press(frame: Frame, name: string): Promise<void> {
  const menu = frame.getByRole('button', { name: 'Menu' });
  if (await menu.isVisible()) await menu.click();
  await frame.getByRole('button', { name }).click();
}

const inner = async (page: Page): Promise<Frame> => {
  const frame = await (await page.waitForSelector('iframe')).contentFrame();
  if (!frame) throw new Error('there is nothing in the frame');
  return frame;
};
const attribute = (value: string) => value.replaceAll('&', '&amp;').replaceAll('"', '&quot;');
const host = 'http://host.test/';

/** Where lecturers put such a file. */
const places: Record<string, (page: Page, path: string) => Promise<Frame>> = {
  'from a disk': async (page, path) => {
    await page.goto(pathToFileURL(file(path)).href);
    return page.mainFrame();
  },
  'in a srcdoc with a sandbox': async (page, path) => {
    await page.setContent(
      `<iframe width="1400" height="860" sandbox="allow-scripts" srcdoc="${attribute(text(path))}"></iframe>`,
      { waitUntil: 'commit' },
    );
    return inner(page);
  },
  'in a frame with a sandbox': async (page, path) => {
    await page.route(host, (route) =>
      route.fulfill({
        contentType: 'text/html',
        body: `<iframe width="1400" height="860" sandbox="allow-scripts" src="${path}"></iframe>`,
      }),
    );
    await page.route(`${host}${path}`, (route) => route.fulfill({ path: file(path) }));
    await page.goto(host, { waitUntil: 'commit' });
    return inner(page);
  },
};

describe.each(['polylap.html', ...readdirSync(file('offline')).map((name) => `offline/${name}`)])('%s', (path) => {
  const html = text(path);

  it('is no larger than 1.6 MB and asks for nothing in its markup', () => {
    console.log(`${path}: ${(statSync(file(path)).size / 1000).toFixed(1)} kB`);
    expect(statSync(file(path)).size).toBeLessThanOrEqual(most);
    const markup = html.replace(/<(script|style)\b[^>]*>[\s\S]*?<\/\1>/g, '');
    expect(markup).not.toMatch(/\ssrc=(?!"data:)/);
    expect([...markup.matchAll(/<link\b[^>]*\bhref="(?!data:)([^"]*)"/g)].map(([, to]) => to)).toEqual([]);
    expect(markup).not.toMatch(/<[^>]* (style|on\w+)=/);
  });

  it('forbids itself all but what is in it', () => {
    const policy = html.match(/http-equiv="Content-Security-Policy" content="([^"]*)"/)?.[1] ?? '';
    const rules = Object.fromEntries(
      policy.split('; ').map((rule) => [rule.replace(/ .*/, ''), rule.split(' ').slice(1)]),
    );
    expect(rules['default-src']).toEqual(["'none'"]);
    expect(rules['connect-src']).toEqual(["'none'"]);
    expect(rules['worker-src']).toEqual(['blob:']);
    expect(rules['img-src']).toEqual(['data:', 'blob:']);
    const hash = expect.stringMatching(/^'sha256-/);
    expect(rules['script-src']).toEqual([hash, hash, "'wasm-unsafe-eval'"]);
    expect(rules['style-src']).toEqual([hash]);
  });
});

const { 'quad-bunny': bunny } = JSON.parse(text('gallery/facts.json'));

describe('the page as one file', () => {
  describe.each(Object.entries(places))('%s', (name, open) => {
    const at = {} as Visit;
    beforeAll(async () => {
      Object.assign(at, await quiet((page) => open(page, 'polylap.html')));
      await at.frame.locator('[data-side="a"] [data-readout="negative"]').first().waitFor();
    });
    afterAll(() => at.close?.());

    it('opens with 2 048 negative weights against 0', async () => {
      await settled(at.frame);
      expect([await read(at.frame, 'negative', 'a'), await read(at.frame, 'negative', 'b')]).toEqual(['2048', '0']);
    });

    it('does every task', async () => {
      for (const task of tasks) {
        await at.frame.getByRole('tab', { name: task }).click();
        await at.frame.getByRole('tabpanel', { name: task }).waitFor();
      }
      // Measured with what only the whole core can do.
      for (const [side, count] of [
        ['a', '2048'],
        ['b', '0'],
      ])
        await eventually(() => read(at.frame, 'negative-ordered', side)).toBe(count);
      await at.frame.getByRole('tab', { name: 'Smooth' }).click();
      await at.frame.getByRole('button', { name: 'Step', exact: true }).and(at.frame.locator(':visible')).click();
      await eventually(() => read(at.frame, 'step', 'b')).toBe('1');
    });

    it('has its gallery, pictures and meshes', async () => {
      await press(at.frame, 'Gallery…');
      await at.frame.locator('dialog img').first().waitFor();
      for (const image of await at.frame.locator('dialog img').all()) {
        await image.scrollIntoViewIfNeeded();
        await image.evaluate((element: HTMLImageElement) => element.decode());
      }
      await at.frame.locator('[data-entry="quad-bunny"]').click();
      await eventually(() => read(at.frame, 'negative')).toBe(String(bunny.negative[0]));
    });

    it('makes links that can be opened, or says how', async () => {
      await press(at.frame, 'Share…');
      const link = at.frame.locator('#share-link');
      await eventually(() => link.inputValue()).toContain('s=');
      const address = await link.inputValue();
      const note = await at.frame.locator('[data-value=share-note]').textContent();
      if (name.includes('srcdoc')) {
        expect(address).toMatch(/^#v=3&s=/);
        expect(note).toContain('Put it behind the address');
      } else {
        expect(address).toMatch(/^(file|http):.*polylap\.html#v=3&s=/);
        expect(note).not.toContain('Put it behind the address');
      }
      await at.frame.getByRole('button', { name: 'Copy' }).and(at.frame.locator(':visible')).click();
      await at.frame.getByText(/Copied\.|copy it by hand/).waitFor();
      await at.frame.getByRole('button', { name: 'Close' }).and(at.frame.locator(':visible')).click();
    });

    it('saves, and says what a sandbox may do to files', async () => {
      await press(at.frame, 'Save…');
      const sandboxed = name.includes('sandbox');
      for (const action of ['surface', 'png', 'svg', 'stiffness']) {
        const downloaded = sandboxed ? null : at.page.waitForEvent('download');
        await at.frame.locator(`[data-action=save-${action}]`).click();
        await at.frame.getByText(/^Saved as /).waitFor();
        if (downloaded) expect(statSync(await (await downloaded).path()).size).toBeGreaterThan(200);
      }
      const said = await at.frame.getByText(/^Saved as /).textContent();
      if (sandboxed) expect(said).toContain('allow-downloads');
      else expect(said).not.toContain('allow-downloads');
      await at.frame.getByRole('button', { name: 'Close' }).and(at.frame.locator(':visible')).click();
    });

    it('is forbidden nothing that it does, and asks for nothing', () => {
      // What the sandbox forbids is not what the file forbids itself.
      expect(
        at.troubles.filter((trouble) => !/sandboxed.*allow-downloads|Download is disallowed/.test(trouble)),
      ).toEqual([]);
      const asked = { 'from a disk': 1, 'in a srcdoc with a sandbox': 0, 'in a frame with a sandbox': 2 }[name];
      expect(at.requests.length, at.requests.join(', ')).toBe(asked);
    });

    it('would be forbidden anything else', async () => {
      const { frame, troubles } = at;
      expect(await frame.evaluate(() => fetch('data:,').then(String, String))).toContain('Failed to fetch');
      await frame.evaluate(() => document.body.setAttribute('style', 'color: red'));
      await frame.waitForFunction(() => getComputedStyle(document.body).color !== 'rgb(255, 0, 0)');
      expect(troubles).toEqual(
        expect.arrayContaining([
          expect.stringContaining('forbidden: connect-src data'),
          expect.stringContaining('forbidden: style-src-attr inline'),
        ]),
      );
    });
  });
});

/** Touches what is shown: its slider, its drawing, or the button that starts it. */
async function touch({ page, frame }: Visit): Promise<void> {
  const slider = frame.locator('main .controls input[type=range]').first();
  const start = frame.locator('main .start');
  if ((await start.count()) > 0) await start.click();
  else if ((await slider.count()) > 0) {
    await slider.focus();
    await page.keyboard.press('ArrowRight');
  } else {
    await frame.locator('main [data-handle]').first().focus();
    await page.keyboard.press('ArrowRight');
  }
}

describe.each(readdirSync(file('offline')))('the figure %s', (name) => {
  it.each(Object.entries(places))('comes alive %s, in both languages', async (place, open) => {
    const at = await quiet((page) => open(page, `offline/${name}`));
    const { frame } = at;
    await frame.locator('main [data-figure]').waitFor();
    const shown = () => frame.locator('main .drawing').first().innerHTML();
    for (const lang of ['en', 'de']) {
      await frame.waitForFunction((wanted) => document.documentElement.lang === wanted, lang);
      const before = await shown();
      await touch(at);
      await frame.waitForFunction(
        () => document.querySelector<HTMLElement>('main [data-figure]')?.dataset.state === 'ready',
      );
      expect(await shown()).not.toBe(before);
      // In a frame the page around says which language it wants.
      const change = frame.locator('.site-line button');
      if (lang === 'en' && (await change.isVisible())) await change.click();
      else break;
    }
    expect(at.troubles).toEqual([]);
    expect(at.requests.length).toBe(place === 'from a disk' ? 1 : place.includes('srcdoc') ? 0 : 2);
    await at.close();
  });
});

describe('the element in one script', () => {
  it.each(['<script src="polylap-compare.js"></script>', '<script type="module" src="polylap-compare.js"></script>'])(
    'works by %s, with no network',
    async (script) => {
      const at = await quiet(async (page) => {
        const body = `<!doctype html><title>host</title>${script}<polylap-compare mesh="noisy-torus"></polylap-compare>`;
        await page.route(host, (route) => route.fulfill({ contentType: 'text/html', body }));
        await page.route(`${host}polylap-compare.js`, (route) => route.fulfill({ path: file('polylap-compare.js') }));
        await page.goto(host);
        return page.mainFrame();
      });
      await settled(at.frame);
      expect([await read(at.frame, 'negative', 'a'), await read(at.frame, 'negative', 'b')]).toEqual(['2048', '0']);
      expect(at.troubles).toEqual([]);
      expect(at.requests).toEqual([host, `${host}polylap-compare.js`]);
      await at.close();
    },
  );
});
