/**
 * What "Use it in class" gives to copy, in the places where lecturers put it: the very files of the page, each in a real host page on another origin, with
 * no network but the two local servers.
 */
import { execFileSync } from 'node:child_process';
import {
  existsSync,
  mkdirSync,
  mkdtempSync,
  readdirSync,
  readFileSync,
  rmSync,
  statSync,
  writeFileSync,
} from 'node:fs';
import { createServer, type Server } from 'node:http';
import type { AddressInfo } from 'node:net';
import { tmpdir } from 'node:os';
import { extname, join, normalize } from 'node:path';
import { fileURLToPath, pathToFileURL } from 'node:url';
import { marked } from 'marked';
import type { BrowserContextOptions, FrameLocator, Locator, Page } from 'playwright-core';
import { afterAll, beforeAll, describe, expect, it } from 'vitest';
import { complaints } from './acts.js';
import { dist, open, picture, pixels, useSite } from './browser.js';

const root = fileURLToPath(new URL('../..', import.meta.url));
const site = useSite();
const snippet = (name: string) =>
  readFileSync(join(root, 'web/class/snippets', name), 'utf8')
    .trimEnd()
    .replaceAll('{{site}}', site.url);

/** A page of somebody else. */
const around = (body: string, head = '') =>
  `<!doctype html>\n<html lang="en"><head><meta charset="utf-8"><title>A course</title>${head}</head>\n<body>\n${body}\n</body></html>`;

const types: Record<string, string> = { '.js': 'text/javascript', '.css': 'text/css', '.html': 'text/html' };
const pages = new Map<string, { html: string; headers: Record<string, string> }>();
let server: Server;
let host = '';
let folder = '';

beforeAll(async () => {
  folder = mkdtempSync(join(tmpdir(), 'polylap-hosts-'));
  // The pages of the host, and reveal.js as npm brings it.
  server = createServer((request, response) => {
    const { pathname } = new URL(request.url ?? '/', 'http://localhost');
    const page = pages.get(pathname);
    const file = join(root, 'node_modules/reveal.js/dist', normalize(pathname.replace('/reveal.js/', '/')));
    if (page) response.writeHead(200, { 'content-type': 'text/html; charset=utf-8', ...page.headers }).end(page.html);
    else if (pathname.startsWith('/reveal.js/') && existsSync(file) && statSync(file).isFile())
      response.writeHead(200, { 'content-type': types[extname(file)] ?? 'text/plain' }).end(readFileSync(file));
    else response.writeHead(pathname === '/favicon.ico' ? 204 : 404).end();
  });
  await new Promise<void>((done) => server.listen(0, 'localhost', done));
  host = `http://localhost:${(server.address() as AddressInfo).port}`;
});
afterAll(async () => {
  server.closeAllConnections();
  await new Promise((done) => server.close(done));
  rmSync(folder, { recursive: true, force: true });
});

declare global {
  /** WebGL contexts of the document that are alive. */
  var contextsNow: () => number;
}

interface Visit {
  page: Page;
  /** Errors and warnings, what a policy forbade, and whatever was asked of anybody but the two servers. */
  troubles: string[];
  close: () => Promise<void>;
}

async function visit(address: string, options: BrowserContextOptions = {}): Promise<Visit> {
  const context = await site.browser.newContext({
    viewport: { width: 1200, height: 900 },
    reducedMotion: 'reduce',
    ...options,
  });
  context.setDefaultTimeout(30_000);
  const page = await context.newPage();
  const troubles: string[] = [];
  await page.addInitScript(() => {
    const contexts: WebGL2RenderingContext[] = [];
    const get = HTMLCanvasElement.prototype.getContext as (this: HTMLCanvasElement, ...given: unknown[]) => unknown;
    HTMLCanvasElement.prototype.getContext = function (this: HTMLCanvasElement, ...given: unknown[]) {
      const context = get.apply(this, given);
      if (context instanceof WebGL2RenderingContext && !contexts.includes(context)) contexts.push(context);
      return context;
    } as typeof HTMLCanvasElement.prototype.getContext;
    globalThis.contextsNow = () => contexts.filter((context) => !context.isContextLost()).length;
    document.addEventListener('securitypolicyviolation', ({ effectiveDirective, blockedURI }) =>
      console.error(`forbidden: ${effectiveDirective} ${blockedURI}`),
    );
  });
  page.on('console', (message) => {
    // The software renderer reports each screenshot and each pick as slow.
    if (['error', 'warning'].includes(message.type()) && !message.text().includes('GPU stall due to ReadPixels'))
      troubles.push(message.text());
  });
  page.on('pageerror', (error) => troubles.push(`uncaught: ${error.message}`));
  page.on('request', (request) => {
    const url = request.url();
    if (!url.startsWith(site.url) && !url.startsWith(host) && !/^(data|blob|file|about):/.test(url))
      troubles.push(`left both servers: ${url}`);
  });
  await page.goto(address);
  return { page, troubles, close: () => context.close() };
}

/** Serves a page of the host and opens it. */
function show(html: string, headers: Record<string, string> = {}, options: BrowserContextOptions = {}): Promise<Visit> {
  const path = `/course/${pages.size}.html`;
  pages.set(path, { html, headers });
  return visit(host + path, options);
}

/** The quad of the figure two-cuts: its weights as they are printed, and others after a corner was moved. */
async function moveCorner(around: Page | FrameLocator | Locator): Promise<void> {
  const reading = around.locator('[data-figure="two-cuts"] [data-reading="w02"]');
  expect(Number(await reading.getAttribute('data-value'))).toBeCloseTo(-0.2006, 4);
  await around.locator('[data-figure="two-cuts"] [data-handle]').first().press('ArrowUp');
  await expect.poll(() => reading.getAttribute('data-value').then(Number)).not.toBeCloseTo(-0.2006, 4);
  expect(Number(await reading.getAttribute('data-value'))).toBeLessThan(0.5);
}

/** Of an element with two operators: the negative weights of both. */
const negative = (element: Locator) =>
  Promise.all(
    ['a', 'b'].map((side) =>
      element.locator(`[data-side=${side}] [data-readout=negative]`).first().getAttribute('data-value'),
    ),
  );

describe('a plain page on another origin', () => {
  it('shows two operators', async () => {
    const { page, troubles, close } = await show(around(snippet('element.html')));
    await expect.poll(() => negative(page.locator('polylap-compare'))).toEqual(['2048', '0']);
    await picture(page, 'host-element');
    expect(troubles).toEqual([]);
    await close();
  });

  it('shows a figure', async () => {
    const { page, troubles, close } = await show(around(snippet('figure.html')));
    await moveCorner(page);
    expect(troubles).toEqual([]);
    await close();
  });

  it('shows a figure in a frame that takes the height it needs', async () => {
    const { page, troubles, close } = await show(around(snippet('iframe.html')));
    await moveCorner(page.frameLocator('iframe'));
    const inside = page.frames()[1];
    await expect
      .poll(async () => {
        const needed = await inside?.evaluate(() => document.documentElement.scrollHeight);
        return (await page.locator('iframe').evaluate((frame) => frame.clientHeight)) - (needed ?? 0);
      })
      .toBe(0);
    await picture(page, 'host-iframe');
    expect(troubles).toEqual([]);
    await close();
  });

  it('shows two operators in a frame', async () => {
    const { page, troubles, close } = await show(around(snippet('iframe-compare.html')));
    const frame = page.frameLocator('iframe').locator('polylap-compare');
    await expect.poll(async () => Number((await negative(frame))[0])).toBeGreaterThan(900);
    expect(await negative(frame)).toEqual([expect.stringMatching(/^\d+$/), '0']);
    expect(await frame.getByRole('tab', { name: 'Smooth' }).isVisible()).toBe(true);
    await picture(page, 'host-iframe-compare');
    expect(troubles).toEqual([]);
    await close();
  });

  it('shows a poster', async () => {
    const { page, troubles, close } = await show(around(snippet('poster.html')));
    await expect
      .poll(() => page.locator('img').evaluate((image: HTMLImageElement) => image.naturalWidth))
      .toBeGreaterThan(100);
    await page.locator('a').click();
    await page.waitForURL(`${site.url}figures/two-cuts.html`);
    expect(troubles).toEqual([]);
    await close();
  });

  it('steers the element', async () => {
    const { page, troubles, close } = await show(
      around(`${snippet('steer.html')}\n${snippet('element.html').split('\n')[0]}`),
    );
    await page.getByRole('button', { name: 'Three steps' }).click();
    await expect
      .poll(() => page.locator('#areas').textContent())
      .toMatch(/^After step 3: areas \d+\.\d\d and \d+\.\d\d$/);
    const areas = ((await page.locator('#areas').textContent()) ?? '').match(/\d+\.\d\d/g)?.map(Number) ?? [];
    // Less than those of the noisy torus, and nearly the same.
    expect(areas[0]).toBeGreaterThan(1);
    expect(Math.abs((areas[0] ?? 0) - (areas[1] ?? 0))).toBeLessThan(0.1 * (areas[0] ?? 0));
    expect(troubles).toEqual([]);
    await close();
  });

  it('steers a frame', async () => {
    const { page, troubles, close } = await show(around(snippet('steer-frame.html')));
    const frame = page.frameLocator('iframe');
    await moveCorner(frame);
    const settings = page.locator('#settings');
    await expect.poll(() => settings.textContent()).toMatch(/^\{/);
    const moved = await settings.textContent();
    await page.getByRole('button', { name: 'Start again' }).click();
    await expect.poll(() => settings.textContent()).not.toBe(moved);
    await expect
      .poll(() => frame.locator('[data-reading="w02"]').getAttribute('data-value').then(Number))
      .toBeCloseTo(-0.2006, 4);
    expect(troubles).toEqual([]);
    await close();
  });
});

it('a page on a disk, with the file of a figure beside it', async () => {
  const offline = readFileSync(join(dist, 'offline/two-cuts.html'));
  writeFileSync(join(folder, 'two-cuts.html'), offline);
  writeFileSync(join(folder, 'lecture.html'), around(snippet('file.html')));
  const { page, troubles, close } = await visit(pathToFileURL(join(folder, 'lecture.html')).href, { offline: true });
  await moveCorner(page.frameLocator('iframe'));
  expect(troubles).toEqual([]);
  await close();
});

describe('reveal.js', () => {
  const deck = (slides: string, script: string) =>
    around(
      `<div class="reveal"><div class="slides"><section><h1>Laplacians</h1></section>${slides}<section><h2>The end</h2></section></div></div>
<script src="/reveal.js/reveal.js"></script>${script}
<script>Reveal.initialize({ transition: 'none' });</script>`,
      '<link rel="stylesheet" href="/reveal.js/reset.css"><link rel="stylesheet" href="/reveal.js/reveal.css"><link rel="stylesheet" href="/reveal.js/theme/white.css">',
    );
  interface Reveal {
    getIndices: () => { h: number };
  }
  const slideOf = (page: Page) =>
    page.evaluate(() => (globalThis as unknown as { Reveal: Reveal }).Reveal.getIndices().h);

  it('turns its slides with arrow keys, whatever was clicked, and the figures work on them', async () => {
    const [slides = '', script = ''] = snippet('reveal.html').split(/<!--.*-->/);
    const { page, troubles, close } = await show(deck(slides, script));
    const slide = () => slideOf(page);
    await page.locator('.reveal.ready').waitFor();
    expect(await slide()).toBe(0);
    await page.keyboard.press('ArrowRight');
    expect(await slide()).toBe(1);
    // By dragging a corner.
    const quad = page.locator('polylap-compare[figure="two-cuts"]');
    const reading = quad.locator('[data-reading="w02"]');
    await expect.poll(() => reading.getAttribute('data-value').then(Number)).toBeCloseTo(-0.2006, 4);
    const corner = (await quad.locator('[data-handle]').first().boundingBox()) ?? { x: 0, y: 0, width: 0, height: 0 };
    const [x, y] = [corner.x + corner.width / 2, corner.y + corner.height / 2];
    await page.mouse.move(x, y);
    await page.mouse.down();
    await page.mouse.move(x + 6, y - 25, { steps: 3 });
    await page.mouse.up();
    await expect.poll(() => reading.getAttribute('data-value').then(Number)).not.toBeCloseTo(-0.2006, 4);
    await picture(page, 'host-reveal-figure');
    await page.keyboard.press('ArrowRight');
    expect(await slide()).toBe(2);
    const torus = page.locator('polylap-compare[mesh]');
    await expect.poll(() => negative(torus)).toEqual(['2048', '0']);
    // Slides are scaled to the screen, and the surface with them: it touches the edges of its view nowhere.
    const view = (await torus.locator('[data-view=b]').boundingBox()) ?? { x: 0, y: 0, width: 0, height: 0 };
    const column = (share: number) =>
      Array.from({ length: 40 }, (_, k) => ({
        x: view.x + share * view.width,
        y: view.y + ((k + 0.5) / 40) * view.height,
      }));
    const colours = async (share: number) =>
      new Set((await pixels(page, column(share))).map((colour) => colour.join()));
    expect((await colours(0.5)).size).toBeGreaterThan(3);
    for (const share of [0.02, 0.98]) expect((await colours(share)).size).toBe(1);
    await torus.locator('[data-view=a]').click();
    await picture(page, 'host-reveal-torus');
    await page.keyboard.press('ArrowRight');
    expect(await slide()).toBe(3);
    await page.keyboard.press('ArrowLeft');
    await page.keyboard.press('ArrowLeft');
    expect(await slide()).toBe(1);
    expect(troubles).toEqual([]);
    await close();
  });

  it('gets the keys back from a frame, too', async () => {
    const [frame = '', script = ''] = snippet('iframe.html')
      .replace('?embed', '?embed&keys=release')
      .split(/<!--.*-->/);
    const { page, troubles, close } = await show(deck(`<section>${frame}</section>`, script));
    await page.locator('.reveal.ready').waitFor();
    await page.keyboard.press('ArrowRight');
    const inside = page.frameLocator('iframe');
    await inside.locator('figcaption').click();
    expect(await page.evaluate(() => document.activeElement?.tagName)).toBe('IFRAME');
    await page.keyboard.press('ArrowRight');
    await expect.poll(() => slideOf(page)).toBe(2);
    await page.keyboard.press('ArrowLeft');
    await expect.poll(() => slideOf(page)).toBe(1);
    expect(troubles).toEqual([]);
    await close();
  });
});

describe('a Jupyter notebook', () => {
  /** What IPython would show of the last line of a cell: the class only carries its HTML, or, for frames, writes it. */
  const ipython = `class HTML:
    def __init__(self, data): self.data = data
    def _repr_html_(self): return self.data

class IFrame:
    def __init__(self, src, width, height): self.src, self.width, self.height = src, width, height
    def _repr_html_(self): return f'<iframe width="{self.width}" height="{self.height}" src="{self.src}" frameborder="0" allowfullscreen></iframe>'
`;
  const run = `import ast, sys
cell = ast.parse(sys.stdin.read())
last = ast.Expression(cell.body.pop().value)
names = {}
exec(compile(cell, "cell", "exec"), names)
print(eval(compile(last, "cell", "eval"), names)._repr_html_())
`;
  const output = (cell: string): string => {
    const work = join(folder, 'notebook');
    mkdirSync(join(work, 'IPython'), { recursive: true });
    writeFileSync(join(work, 'IPython/__init__.py'), '');
    writeFileSync(join(work, 'IPython/display.py'), ipython);
    writeFileSync(join(work, 'run.py'), run);
    writeFileSync(join(work, 'two-cuts.html'), readFileSync(join(dist, 'offline/two-cuts.html')));
    return execFileSync('python3', ['run.py'], { cwd: work, input: cell, encoding: 'utf8', maxBuffer: 2 ** 26 });
  };
  /** As nbconvert writes a cell and its output. */
  const exported = (cell: string) => {
    const code = cell.replaceAll('&', '&amp;').replaceAll('<', '&lt;');
    return around(
      `<main><div class="jp-Cell jp-CodeCell jp-Notebook-cell"><div class="jp-Cell-inputWrapper" tabindex="0"><div class="jp-InputArea jp-Cell-inputArea"><div class="jp-InputPrompt jp-InputArea-prompt">In [1]:</div><div class="jp-CodeMirrorEditor jp-Editor jp-InputArea-editor" data-type="inline"><div class="highlight hl-ipython3"><pre>${code}</pre></div></div></div></div>
<div class="jp-Cell-outputWrapper"><div class="jp-OutputArea jp-Cell-outputArea"><div class="jp-OutputArea-child jp-OutputArea-executeResult"><div class="jp-OutputPrompt jp-OutputArea-prompt">Out[1]:</div><div class="jp-RenderedHTMLCommon jp-RenderedHTML jp-OutputArea-output jp-OutputArea-executeResult" data-mime-type="text/html" tabindex="0">
${output(cell)}
</div></div></div></div></div></main>`,
      '<style>.jp-OutputArea-child{display:table;table-layout:fixed;width:100%}.jp-OutputArea-output{overflow:auto}</style>',
    );
  };

  it('carries the figure in its output, and needs no network', async () => {
    writeFileSync(join(folder, 'notebook.html'), exported(snippet('notebook.py')));
    const { page, troubles, close } = await visit(pathToFileURL(join(folder, 'notebook.html')).href, { offline: true });
    await moveCorner(page.frameLocator('iframe'));
    expect(troubles).toEqual([]);
    await close();
  });

  it('shows the figure of the site', async () => {
    const { page, troubles, close } = await show(exported(snippet('notebook-online.py')));
    await moveCorner(page.frameLocator('iframe'));
    expect(troubles).toEqual([]);
    await close();
  });
});

describe('Markdown', () => {
  it('hands the lines through', async () => {
    const { page, troubles, close } = await show(around(await marked.parse(snippet('page.md'))));
    expect(await page.locator('em').textContent()).toBe('find out which');
    await moveCorner(page);
    expect(troubles).toEqual([]);
    await close();
  });

  it('of Quarto has them in a raw block', async () => {
    const [, title, raw] = snippet('slides.qmd').match(/^## (.*)\n\n```\{=html\}\n([\s\S]*?)\n```$/) ?? [];
    // As Quarto lays a document out.
    const { page, troubles, close } = await show(
      around(
        `<div id="quarto-content" class="page-columns page-rows-contents page-layout-article"><main class="content" id="quarto-document-content"><section id="which-way-to-cut" class="level2"><h2 class="anchored">${title}</h2>\n${raw}\n</section></main></div>`,
      ),
    );
    expect(await page.locator('h2').first().textContent()).toBe('Which way to cut?');
    const quad = page.locator('polylap-compare');
    await expect
      .poll(() => quad.locator('[data-reading="w02"]').getAttribute('data-value').then(Number))
      .toBeCloseTo(-0.2006, 4);
    expect(troubles).toEqual([]);
    await close();
  });
});

describe('a learning platform', () => {
  const policy = () =>
    `default-src 'none'; img-src 'self'; style-src 'self'; script-src 'self'; frame-src ${new URL(site.url).origin} ${host}; form-action 'none'; base-uri 'none'`;

  it('with a strict policy allows the frame, and nothing of it is forbidden', async () => {
    const { page, troubles, close } = await show(around(snippet('lms.html')), { 'content-security-policy': policy() });
    await moveCorner(page.frameLocator('iframe'));
    await picture(page, 'host-lms');
    expect(troubles).toEqual([]);
    await close();
  });

  it('that puts what lecturers write into a sandbox of its own shows it all the same', async () => {
    pages.set('/course/unit.html', {
      html: around(snippet('lms.html')),
      headers: { 'content-security-policy': `${policy()}; sandbox allow-scripts` },
    });
    const { page, troubles, close } = await show(
      around('<iframe src="unit.html" sandbox="allow-scripts" width="1100" height="850"></iframe>'),
      { 'content-security-policy': policy() },
    );
    await moveCorner(page.frameLocator('iframe').frameLocator('iframe'));
    expect(troubles).toEqual([]);
    await close();
  });
});

describe('a deck of twelve on one page', () => {
  const ids = readdirSync(join(dist, 'figures')).flatMap((name) => name.match(/^(.*)\.svg$/)?.[1] ?? []);
  const element = (attributes: string) => `<section><polylap-compare ${attributes}></polylap-compare></section>`;
  const script = () => snippet('element.html').split('\n')[0] ?? '';
  /** Scrolls through all of them. @returns the most WebGL contexts that there were */
  const leaf = async (page: Page, isThere: (one: Locator) => Promise<void>): Promise<number> => {
    const all = await page.locator('polylap-compare').all();
    expect(all.length).toBe(12);
    let most = 0;
    for (const one of [...all, ...all.slice(0, 3)]) {
      await one.scrollIntoViewIfNeeded();
      await isThere(one);
      most = Math.max(most, await page.evaluate(() => globalThis.contextsNow()));
    }
    return most;
  };

  it('of all figures: each is there, and those that were passed answer', async () => {
    expect(ids.length).toBe(12);
    const { page, troubles, close } = await show(
      around(ids.map((id) => element(`figure="${id}"`)).join('\n') + script()),
    );
    const most = await leaf(page, async (one) => {
      const number = one.locator('[data-reading][data-value], [data-readout="negative"][data-value]').first();
      await expect.poll(() => number.getAttribute('data-value').then(Number)).toBeGreaterThanOrEqual(-10);
    });
    expect(most).toBeGreaterThan(0);
    expect(most).toBeLessThan(16);
    await moveCorner(page);
    expect(await page.evaluate(() => globalThis.contextsNow())).toBeLessThan(16);
    await picture(page, 'host-deck');
    expect(troubles).toEqual([]);
    await close();
  });

  it('of pairs of operators: each has its numbers and its picture', async () => {
    const { page, troubles, close } = await show(
      around(Array.from({ length: 12 }, () => element('mesh="grid-8" controls="none"')).join('\n') + script()),
    );
    const most = await leaf(page, async (one) => expect.poll(() => negative(one)).toEqual(['256', '0']));
    expect(most).toBeGreaterThan(1);
    expect(most).toBeLessThan(16);
    expect(troubles).toEqual([]);
    await close();
  });
});

describe('the page that they are copied from', () => {
  const paths = { en: 'class/index.html', de: 'class/de.html' };

  it.each(['en', 'de'] as const)('%s: has them all, with its own address, and copies them', async (lang) => {
    const { page, troubles, close } = await open(site, site.url + paths[lang], {
      permissions: ['clipboard-read', 'clipboard-write'],
    });
    const names = readdirSync(join(root, 'web/class/snippets')).sort();
    const shown = await page.locator('[data-snippet]').evaluateAll((all) => all.map((each) => each.dataset.snippet));
    expect([...shown].sort()).toEqual(names);
    for (const name of names) {
      const place = page.locator(`[data-snippet="${name}"]`);
      expect(await place.locator('code').textContent()).toBe(snippet(name));
      await place.getByRole('button').click();
      await expect.poll(() => page.evaluate(() => navigator.clipboard.readText())).toBe(snippet(name));
    }
    const links = await page
      .locator('main a[href]')
      .evaluateAll((all) => all.map((each) => each.getAttribute('href') ?? ''));
    const broken = links.filter((link) =>
      link.startsWith('#')
        ? !readFileSync(join(dist, paths[lang]), 'utf8').includes(`id="${link.slice(1)}"`)
        : !existsSync(join(dist, normalize(join('class', link.replace(/[?#].*$/, ''))))),
    );
    expect(links.length).toBeGreaterThan(30);
    expect(broken).toEqual([]);
    expect(troubles).toEqual([]);
    await close();
  });

  it('names the attributes, methods, events and parts that the element has', () => {
    const element = readFileSync(join(root, 'web/embed/element.ts'), 'utf8');
    const wish = readFileSync(join(root, 'web/embed/wish.ts'), 'utf8');
    const quoted = (text: string | undefined) =>
      [...(text ?? '').matchAll(/'([\w-]+)'/g)].map(([, name]) => name ?? '');
    const attributes = [/contentNames = \[([^\]]*)\]/, /export const names = \[([^\]]*)\]/].flatMap((list) =>
      quoted(wish.match(list)?.[1]),
    );
    const methods = [...element.matchAll(/^ {2}async (\w+)\(/gm)].map(([, name]) => name ?? '');
    const parts = quoted(element.match(/const parts[^{]*\{([^}]*)\}/)?.[1]?.replaceAll(/'[^']*':/g, ''));
    expect(attributes.length).toBeGreaterThan(15);
    expect(methods.length).toBeGreaterThan(7);
    expect(parts.length).toBeGreaterThan(15);
    for (const lang of ['en', 'de'] as const) {
      const said = readFileSync(join(root, `web/class/${lang}.md`), 'utf8');
      const missing = [...attributes, ...parts].filter((name) => !said.includes(`\`${name}\``));
      expect(missing).toEqual([]);
      expect(methods.filter((name) => !said.includes(`\`${name}(`))).toEqual([]);
    }
  });

  it.each([
    ['en', 'light', { colorScheme: 'light' as const }],
    ['de', 'narrow and dark', { viewport: { width: 320, height: 700 }, hasTouch: true, colorScheme: 'dark' as const }],
    ['de', 'without scripts', { javaScriptEnabled: false }],
  ] as const)('axe, %s, %s: finds nothing, and nothing is wider than the screen', async (lang, name, options) => {
    const { page, close } = await open(site, site.url + paths[lang], options);
    const all = await page.locator('.snippet code').allTextContents();
    expect(all.length).toBeGreaterThan(10);
    const [wide, room] = [page.locator('html'), page.viewportSize()?.width ?? 0] as const;
    expect((await wide.boundingBox())?.width).toBeLessThanOrEqual(room);
    if (name === 'without scripts') {
      expect(await page.getByRole('button').count()).toBe(0);
      expect(all.every((text) => !text.includes('{{'))).toBe(true);
    } else {
      expect(await page.evaluate(() => document.documentElement.scrollWidth)).toBeLessThanOrEqual(room);
      expect(await complaints(page)).toEqual([]);
      await picture(page, `class-${lang}-${name}`, true);
    }
    await close();
  });
});
