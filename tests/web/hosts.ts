/** Pages of others, with the element on them: one script, and nothing else is asked of any network. */
import { existsSync, readFileSync } from 'node:fs';
import { createServer, type Server } from 'node:http';
import type { AddressInfo } from 'node:net';
import { join } from 'node:path';
import type { BrowserContextOptions, Page } from 'playwright-core';
import { afterAll, beforeAll, expect } from 'vitest';
import type { PolylapCompare } from '../../web/embed/element.js';
import type { State } from '../../web/src/state.js';
import { dist, type Site, useSite } from './browser.js';

export interface Told {
  type: string;
  id: string;
  detail: Record<string, unknown>;
}

/** What the host page notes; see `note`. */
declare global {
  var told: Told[];
  var keys: string[];
  var contexts: WebGLRenderingContext[];
  var mostContexts: number;
}

export interface HostVisit {
  page: Page;
  /** Console errors and warnings, uncaught errors, and what the policy of the host forbade. */
  troubles: string[];
  /** The paths that were asked for. */
  requests: string[];
  close: () => Promise<void>;
}

interface Options extends BrowserContextOptions {
  style?: string;
  lang?: string;
  /** Content-Security-Policy of the host. */
  policy?: string;
  /** Files beside the page, by their paths. */
  files?: Record<string, string>;
  /** Do not wait until all elements have started. */
  early?: boolean;
}

export interface Hosts {
  site: Site;
  open: (body: string, options?: Options) => Promise<HostVisit>;
}

/** Notes what elements tell, the keys that reach the document, and the contexts there are. */
function note(): void {
  globalThis.told = [];
  globalThis.keys = [];
  globalThis.contexts = [];
  globalThis.mostContexts = 0;
  for (const type of ['ready', 'state-change', 'pick', 'step', 'error'])
    addEventListener(type, (event) => {
      if (!(event instanceof CustomEvent)) return;
      globalThis.told.push({ type, id: (event.target as Element).id, detail: event.detail });
    });
  document.addEventListener('keydown', ({ key }) => globalThis.keys.push(key));
  document.addEventListener('securitypolicyviolation', ({ effectiveDirective, blockedURI }) =>
    console.error(`forbidden: ${effectiveDirective} ${blockedURI}`),
  );
  const get = HTMLCanvasElement.prototype.getContext as (this: HTMLCanvasElement, ...given: unknown[]) => unknown;
  HTMLCanvasElement.prototype.getContext = function (this: HTMLCanvasElement, ...given: unknown[]) {
    const context = get.apply(this, given);
    if (context instanceof WebGL2RenderingContext && !globalThis.contexts.includes(context)) {
      globalThis.contexts.push(context);
      const live = globalThis.contexts.filter((each) => !each.isContextLost()).length;
      globalThis.mostContexts = Math.max(globalThis.mostContexts, live);
    }
    return context;
  } as typeof HTMLCanvasElement.prototype.getContext;
}

/** For the tests of a file: a browser, and a server of whatever host pages they want. */
export function useHosts(): Hosts {
  const site = useSite();
  const script = join(dist, 'polylap-compare.js');
  const pages = new Map<string, { html: string; policy: string | undefined }>();
  const files = new Map<string, string>();
  let server: Server;
  beforeAll(async () => {
    if (!existsSync(script)) throw new Error(`There is no ${script}: npm run build makes it.`);
    server = createServer((request, response) => {
      const { pathname } = new URL(request.url ?? '/', 'http://localhost');
      const page = pages.get(pathname);
      const file = files.get(pathname);
      const policy = page?.policy && { 'content-security-policy': page.policy };
      if (page) response.writeHead(200, { 'content-type': 'text/html; charset=utf-8', ...policy }).end(page.html);
      else if (pathname === '/lib/polylap-compare.js')
        response.writeHead(200, { 'content-type': 'text/javascript' }).end(readFileSync(script));
      else if (file !== undefined) response.writeHead(200, { 'content-type': typeOf(pathname) }).end(file);
      else response.writeHead(pathname === '/favicon.ico' ? 204 : 404).end();
    });
    await new Promise<void>((done) => server.listen(0, 'localhost', done));
  });
  afterAll(async () => {
    server.closeAllConnections();
    await new Promise((done) => server.close(done));
  });

  const open = async (body: string, options: Options = {}): Promise<HostVisit> => {
    const { style = '', lang = 'en', policy, files: given = {}, early = false, ...rest } = options;
    const path = `/course/${pages.size}.html`;
    const html = `<!doctype html><html lang="${lang}"><head><meta charset="utf-8"><title>A course</title><link rel="stylesheet" href="style-${pages.size}.css"><script type="module" src="/lib/polylap-compare.js"></script></head><body><main><h1>A course</h1>${body}</main></body></html>`;
    for (const [name, text] of Object.entries(given)) files.set(`/course/${name}`, text);
    files.set(`/course/style-${pages.size}.css`, style);
    pages.set(path, { html, policy });
    const context = await site.browser.newContext({
      viewport: { width: 1200, height: 900 },
      reducedMotion: 'reduce',
      ...rest,
    });
    context.setDefaultTimeout(30_000);
    const page = await context.newPage();
    await page.addInitScript(note);
    const [troubles, requests]: [string[], string[]] = [[], []];
    page.on('console', (message) => {
      // The software renderer reports each screenshot and each pick as slow.
      if (['error', 'warning'].includes(message.type()) && !message.text().includes('GPU stall due to ReadPixels'))
        troubles.push(message.text());
    });
    page.on('pageerror', (error) => troubles.push(`uncaught: ${error.message}`));
    page.on('request', (request) => {
      const { protocol, pathname } = new URL(request.url());
      if (!/^(data|blob):$/.test(protocol)) requests.push(pathname);
    });
    await page.goto(`http://localhost:${(server.address() as AddressInfo).port}${path}`);
    const visit = { page, troubles, requests, close: () => context.close() };
    if (!early) await started(page);
    return visit;
  };
  return { site, open };
}

const typeOf = (path: string) =>
  path.endsWith('.css') ? 'text/css' : path.endsWith('.svg') ? 'image/svg+xml' : 'text/plain';

/** What comes to be true, on however busy a machine. */
export const soon = <T>(get: () => T) => expect.poll(get, { timeout: 30_000 });

/** Until every element has its mesh and its first numbers. */
export async function started(page: Page): Promise<void> {
  await page.evaluate(() => customElements.whenDefined('polylap-compare'));
  await page.evaluate(() => Promise.all([...document.querySelectorAll('polylap-compare')].map((e) => e.getState())));
}

export const stateOf = (page: Page, id: string): Promise<State> =>
  page.evaluate((of) => (document.getElementById(of) as PolylapCompare).getState(), id);

/** What an element has told, of one type. */
export const toldBy = (page: Page, id: string, type: string): Promise<Told['detail'][]> =>
  page.evaluate(
    ([of, what]) => globalThis.told.filter((each) => each.id === of && each.type === what).map(({ detail }) => detail),
    [id, type] as const,
  );

/** WebGL contexts that are there now. */
export const liveContexts = (page: Page): Promise<number> =>
  page.evaluate(() => globalThis.contexts.filter((each) => !each.isContextLost()).length);

/** The number that a readout of a side of an element shows. */
export async function shown(page: Page, id: string, name: string, side: 'a' | 'b'): Promise<number> {
  const value = await page
    .locator(`#${id} [data-side=${side}] [data-readout=${name}]`)
    .first()
    .getAttribute('data-value');
  return value === null ? Number.NaN : Number(value);
}

/** Waits until both sides of an element show these numbers of negative weights. */
export async function showsNegative(page: Page, id: string, a: number, b: number): Promise<void> {
  await page.waitForFunction(
    ([of, first, second]) => {
      const root = document.getElementById(of)?.shadowRoot;
      const value = (side: string) =>
        root?.querySelector<HTMLElement>(`[data-side=${side}] [data-readout=negative]`)?.dataset.value;
      return value('a') === String(first) && value('b') === String(second);
    },
    [id, a, b] as const,
  );
}
