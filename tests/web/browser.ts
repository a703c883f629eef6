/** The built page in a real browser: what the tests of this folder share. */
import { existsSync, mkdirSync, readFileSync, statSync } from 'node:fs';
import { createServer, type Server } from 'node:http';
import type { AddressInfo } from 'node:net';
import { extname, join, normalize } from 'node:path';
import { fileURLToPath } from 'node:url';
import { gzipSync } from 'node:zlib';
import { type Browser, type BrowserContextOptions, chromium, type Page } from 'playwright-core';
import { afterAll, beforeAll } from 'vitest';
import type { Side } from '../../wasm/src/types.js';
import type { View } from '../../web/src/state.js';

const root = fileURLToPath(new URL('../..', import.meta.url));
export const dist = process.env.POLYLAP_DIST ?? join(root, 'dist');
export const dataFile = (name: string) => join(root, 'tests/data', name);
const out = join(root, 'tests/web/out');

const types: Record<string, string> = {
  '.html': 'text/html; charset=utf-8',
  '.js': 'text/javascript',
  '.css': 'text/css',
  '.wasm': 'application/wasm',
  '.svg': 'image/svg+xml',
  '.json': 'application/json',
};

/** The page lives below a path, as it may on any host, and nothing else is there. */
const base = '/some/where/';

export const tasks = ['Weights', 'Smooth', 'Harmonic', 'Dual', 'Check'];

export interface Site {
  url: string;
  browser: Browser;
  /** What the server was asked for, in order, with the bytes of each file. */
  sent: { file: string; raw: number; compressed: number }[];
  close: () => Promise<void>;
}

/** How a site is served. */
interface Serving {
  /** With gzip, as hosts do. */
  compressed?: boolean;
}

async function startSite({ compressed = false }: Serving): Promise<Site> {
  if (!existsSync(join(dist, 'index.html')))
    throw new Error(`There is no built page in ${dist}: npm run build makes it.`);
  const sent: Site['sent'] = [];
  const packed = new Map<string, Buffer>();
  const pack = (file: string, bytes: Buffer) => {
    const known = packed.get(file) ?? gzipSync(bytes, { level: 9 });
    packed.set(file, known);
    return known;
  };
  const server: Server = createServer((request, response) => {
    const path = new URL(request.url ?? '/', 'http://localhost').pathname;
    const file = path.startsWith(base) ? join(dist, normalize(path.slice(base.length) || 'index.html')) : '';
    if (!file.startsWith(dist) || !existsSync(file) || !statSync(file).isFile()) {
      response.writeHead(404).end();
      return;
    }
    const bytes = readFileSync(file);
    const body = compressed ? pack(file, bytes) : bytes;
    sent.push({ file: file.slice(dist.length + 1), raw: bytes.length, compressed: body.length });
    response.writeHead(200, {
      'content-type': types[extname(file)] ?? 'application/octet-stream',
      'cache-control': 'max-age=600',
      ...(compressed && { 'content-encoding': 'gzip' }),
    });
    response.end(body);
  });
  await new Promise<void>((done) => server.listen(0, 'localhost', done));
  const browser = await chromium.launch({
    executablePath: process.env.CHROMIUM ?? '/usr/bin/chromium',
    args: [
      '--no-sandbox',
      '--disable-quic',
      '--no-first-run',
      '--disable-background-networking',
      '--disable-component-update',
      '--disable-sync',
    ],
  });
  return {
    url: `http://localhost:${(server.address() as AddressInfo).port}${base}`,
    browser,
    sent,
    close: async () => {
      await browser.close();
      server.closeAllConnections();
      await new Promise((done) => server.close(done));
    },
  };
}

export interface Visit {
  page: Page;
  /** Console errors and warnings, uncaught errors, requests that failed or left the site. */
  troubles: string[];
  /** The addresses that were asked of the server. */
  requests: Set<string>;
  close: () => Promise<void>;
}

/** Opens any page of the site, and listens. @param first runs in the page before anything of its own does */
export async function open(
  site: Site,
  link: string,
  options: BrowserContextOptions = {},
  first?: () => void,
): Promise<Visit> {
  const context = await site.browser.newContext({
    viewport: { width: 1440, height: 900 },
    reducedMotion: 'reduce',
    ...options,
  });
  context.setDefaultTimeout(30_000);
  const page = await context.newPage();
  const troubles: string[] = [];
  page.on('console', (message) => {
    // The software renderer reports each screenshot and each pick as slow.
    if (['error', 'warning'].includes(message.type()) && !message.text().includes('GPU stall due to ReadPixels')) {
      troubles.push(`${message.type()}: ${message.text()}`);
    }
  });
  page.on('pageerror', (error) => troubles.push(`uncaught: ${error.message}`));
  page.on('requestfailed', (request) => troubles.push(`failed: ${request.url()}`));
  page.on('response', (response) => {
    if (response.status() >= 400) troubles.push(`${response.status()}: ${response.url()}`);
  });
  const requests = new Set<string>();
  page.on('request', (request) => {
    if (request.url().startsWith(site.url)) requests.add(request.url());
    else if (!/^(data|blob):/.test(request.url())) troubles.push(`left the site: ${request.url()}`);
  });
  if (first) await page.addInitScript(first);
  await page.goto(link);
  return { page, troubles, requests, close: () => context.close() };
}

/** Opens the full page, or a link to it, and waits for its first numbers. */
export async function visit(site: Site, options: BrowserContextOptions = {}, link = site.url): Promise<Visit> {
  const opened = await open(site, link, options);
  await settled(opened.page);
  return opened;
}

/** A site for the tests of a file: there before the first, closed after the last. */
export function useSite(serving: Serving = {}): Site {
  const site = {} as Site;
  beforeAll(async () => {
    Object.assign(site, await startSite(serving));
  });
  afterAll(() => site.close?.());
  return site;
}

/** One visit for all tests of a file or a group. */
export function useVisit(site: Site): Visit {
  const at = {} as Visit;
  beforeAll(async () => {
    Object.assign(at, await visit(site));
  });
  afterAll(() => at.close?.());
  return at;
}

/** Until both sides know their weights and nothing is under way. */
export async function settled(page: Page): Promise<void> {
  await page.waitForFunction(() => {
    const { mesh, a, b } = globalThis.polylap?.results() ?? {};
    return mesh && a?.weights && b?.weights && a.shape && b.shape && globalThis.polylap.idle();
  });
}

/** The number that a readout of a side shows. */
export async function readout(page: Page, name: string, side?: Side): Promise<number> {
  const selector = `[data-readout="${name}"]`;
  const where = side ? `[data-side="${side}"] ${selector}, [data-of="${side}"]${selector}` : selector;
  const value = await page.locator(where).first().getAttribute('data-value');
  return value === null ? Number.NaN : Number(value);
}

export const negative = async (page: Page) => [
  await readout(page, 'negative', 'a'),
  await readout(page, 'negative', 'b'),
];

/** Waits until a readout of both sides shows these numbers. */
export async function shows(page: Page, name: string, a: number, b: number, tolerance = 0): Promise<void> {
  await page.waitForFunction(
    ([selector, first, second, within]) => {
      const value = (side: string) =>
        Number(
          document.querySelector<HTMLElement>(`[data-side="${side}"] ${selector}, [data-of="${side}"]${selector}`)
            ?.dataset.value ?? Number.NaN,
        );
      return Math.abs(value('a') - first) <= within && Math.abs(value('b') - second) <= within;
    },
    [`[data-readout="${name}"]`, a, b, tolerance] as const,
  );
}

/** Clicks where a vertex is seen. */
export async function clickVertex(page: Page, side: View, vertex: number): Promise<void> {
  const at = await page.evaluate(([of, number]) => globalThis.polylap.project(of, number), [side, vertex] as const);
  if (!at) throw new Error(`vertex ${vertex} is nowhere on side ${side}`);
  if (!at.visible) throw new Error(`vertex ${vertex} is hidden on side ${side}`);
  await page.mouse.click(at.x, at.y);
}

export async function chooseMesh(page: Page, id: string): Promise<void> {
  await page.getByLabel('Mesh', { exact: true }).selectOption(id);
  await page.waitForFunction((wanted) => {
    const { source } = globalThis.polylap.state();
    return source.kind === 'preset' && source.id === wanted;
  }, id);
  await settled(page);
}

export async function openFile(page: Page, name: string, text: string | Buffer): Promise<void> {
  await page.getByLabel('Mesh file').setInputFiles({ name, mimeType: 'text/plain', buffer: Buffer.from(text) });
}

/** For the eye; kept out of the repository. */
export async function picture(page: Page, name: string, fullPage = false): Promise<void> {
  mkdirSync(out, { recursive: true });
  await page.screenshot({ path: join(out, `${name}.png`), fullPage });
}

export type Colour = [number, number, number];

/** What the screen shows at points of the page. */
export async function pixels(page: Page, points: readonly { x: number; y: number }[]): Promise<Colour[]> {
  const png = (await page.screenshot()).toString('base64');
  return page.evaluate(
    async ([data, places]) => {
      const bitmap = await createImageBitmap(await (await fetch(`data:image/png;base64,${data}`)).blob());
      const canvas = new OffscreenCanvas(bitmap.width, bitmap.height);
      const context = canvas.getContext('2d', { willReadFrequently: true }) as OffscreenCanvasRenderingContext2D;
      context.drawImage(bitmap, 0, 0);
      return places.map(({ x, y }) => {
        const [r = 0, g = 0, b = 0] = context.getImageData(Math.round(x), Math.round(y), 1, 1).data;
        return [r, g, b] as Colour;
      });
    },
    [png, points] as const,
  );
}

/** A flat grid of n × n squares as OBJ text. */
export function gridObj(n: number): string {
  const lines: string[] = [];
  for (let j = 0; j <= n; j++) for (let i = 0; i <= n; i++) lines.push(`v ${i} ${j} ${((i * 7 + j * 3) % 5) / 20}`);
  for (let j = 0; j < n; j++) {
    for (let i = 0; i < n; i++) {
      const first = j * (n + 1) + i + 1;
      lines.push(`f ${first} ${first + 1} ${first + n + 2} ${first + n + 1}`);
    }
  }
  return lines.join('\n');
}
