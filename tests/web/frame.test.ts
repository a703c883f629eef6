/** Frames: what their addresses ask for, and what they and the pages around them say to each other. */
import { readFileSync } from 'node:fs';
import { join } from 'node:path';
import { pathToFileURL } from 'node:url';
import type { Frame, Page } from 'playwright-core';
import { afterAll, beforeAll, describe, expect, it } from 'vitest';
import { dist, useSite } from './browser.js';

const site = useSite();

/** As long as anything else may take. */
const eventually = <T>(look: () => T) => expect.poll(look, { timeout: 30_000 });

interface Message {
  polylap: 1;
  id?: unknown;
  result?: unknown;
  error?: { message: string };
  event?: string;
  detail?: Record<string, unknown>;
}

interface Host {
  page: Page;
  frame: Frame;
  /** What the host has heard, of whomever. */
  heard: () => Promise<Message[]>;
  /** Says something to the frame, as it is. */
  say: (message: unknown) => Promise<void>;
  /** Asks for a method. @returns the reply */
  ask: (method: string, ...params: unknown[]) => Promise<Message>;
  reply: (id: unknown) => Promise<Message>;
  /** Until an event has come. */
  event: (name: string) => Promise<Message>;
  close: () => Promise<void>;
}

const attribute = (value: string) => value.replaceAll('&', '&amp;').replaceAll('"', '&quot;');

/** A page that listens to its frames. @param markup what is in it; the first frame is the one that is spoken to */
async function host(markup: string): Promise<Host> {
  const context = await site.browser.newContext({ viewport: { width: 1000, height: 900 }, reducedMotion: 'reduce' });
  context.setDefaultTimeout(30_000);
  const page = await context.newPage();
  const address = new URL('/host', site.url).href;
  const listen = '<script>var heard = []; addEventListener("message", (e) => heard.push(e.data))</script>';
  await page.route(address, (route) =>
    route.fulfill({ contentType: 'text/html', body: `<!doctype html><body>${listen}${markup}` }),
  );
  await page.goto(address, { waitUntil: 'commit' });
  const frame = await (await page.waitForSelector('iframe')).contentFrame();
  if (!frame) throw new Error('there is nothing in the frame');
  const heard = () =>
    page.evaluate(() =>
      (globalThis as unknown as { heard: Message[] }).heard.map((message) => {
        // Of what is binary, what it is.
        const { result } = message;
        return result instanceof Blob ? { ...message, result: { type: result.type, size: result.size } } : message;
      }),
    );
  const say = (message: unknown) =>
    page.evaluate((said) => document.querySelector('iframe')?.contentWindow?.postMessage(said, '*'), message);
  /** Until there is a message of which this part is so. */
  const until = async (part: 'id' | 'event', value: unknown) => {
    await page.waitForFunction(
      ([name, wanted]) => (globalThis as unknown as { heard: Message[] }).heard.some((one) => one?.[name] === wanted),
      [part, value] as const,
    );
    return (await heard()).find((message) => message?.[part] === value) as Message;
  };
  let next = 0;
  return {
    page,
    frame,
    heard,
    say,
    ask: async (method, ...params) => {
      const id = `ask-${next++}`;
      await say({ polylap: 1, id, method, params });
      return until('id', id);
    },
    event: (name) => until('event', name),
    reply: (id) => until('id', id),
    close: () => context.close(),
  };
}

const figure = (query = '') =>
  `<iframe data-polylap width="720" height="500" src="${site.url}figures/one-interior-vertex.html?embed${query}"></iframe>`;

describe('what is said', () => {
  const at = {} as Host;
  beforeAll(async () => {
    // Another frame, which has no business here.
    Object.assign(
      at,
      await host(
        `${figure()}<iframe id="stranger" srcdoc="<script>var heard=[];addEventListener('message',(e)=>heard.push(e.data))</script>"></iframe>`,
      ),
    );
  });
  afterAll(() => at.close?.());

  it('begins with ready and the height that the content wants', async () => {
    expect(await at.event('ready')).toMatchObject({ polylap: 1, detail: { figure: 'one-interior-vertex' } });
    const told = async () => (await at.heard()).findLast(({ event }) => event === 'size')?.detail;
    const wants = () =>
      at.frame.evaluate(() => ({
        width: innerWidth,
        height: Math.ceil(document.documentElement.getBoundingClientRect().height),
      }));
    // The last that it said: while the page is laid out it may say more.
    await eventually(async () => JSON.stringify(await told()) === JSON.stringify(await wants())).toBe(true);
    const content = await at.frame.evaluate(
      () => document.querySelector('.live-figure')?.getBoundingClientRect().height ?? 0,
    );
    expect(Number((await told())?.height)).toBeGreaterThanOrEqual(content);
    expect(Number((await told())?.height)).toBeLessThan(content + 40);
  });

  it('answers requests, by their ids', async () => {
    const state = await at.ask('getState');
    expect(state.result).toMatchObject({ figure: 'one-interior-vertex', settings: { lambda: 1 } });
    expect((await at.ask('setState', { settings: { lambda: 0.25 } })).error).toBeUndefined();
    expect((await at.ask('getState')).result).toMatchObject({ settings: { lambda: 0.25 } });
    // 4λ/(1 + 2λ)
    expect(await at.frame.locator('[data-reading="a"]').getAttribute('data-value')).toMatch(/^0\.66666/);
    expect((await at.event('state-change')).detail).toMatchObject({ settings: { lambda: 0.25 } });
    expect((await at.ask('reset')).error).toBeUndefined();
    expect((await at.ask('getState')).result).toMatchObject({ settings: { lambda: 1 } });
    await at.say({ polylap: 1, id: 7, method: 'getState' });
    expect(await at.reply(7)).toMatchObject({ result: { figure: 'one-interior-vertex' } });
  });

  it('gives pictures', async () => {
    expect((await at.ask('toSVG')).result).toMatch(/^<svg xmlns="http:\/\/www\.w3\.org\/2000\/svg"[\s\S]*<\/svg>$/);
    const png = (await at.ask('toPNG')).result as { type: string; size: number };
    expect(png.type).toBe('image/png');
    expect(png.size).toBeGreaterThan(5000);
  });

  it('says what is wrong with a request', async () => {
    expect((await at.ask('nonsense')).error?.message).toContain('there is no method nonsense: there are getState');
    expect((await at.ask('constructor')).error?.message).toContain('there is no method constructor');
    expect((await at.ask('setState', 'x')).error?.message).toBe('the state has no settings');
    expect((await at.ask('setState', { figure: 'two-cuts', settings: {} })).error?.message).toContain(
      'of the figure two-cuts',
    );
    expect((await at.ask('setState', { settings: {} })).result).toBeNull();
  });

  it('hears nothing that is malformed, and nothing from anybody else', async () => {
    const before = (await at.heard()).length;
    for (const message of [
      null,
      7,
      'getState',
      [],
      {},
      { id: 1, method: 'getState' },
      { polylap: 2, id: 1, method: 'getState' },
      { polylap: 1, method: 'getState' },
      { polylap: 1, id: 1 },
      { polylap: 1, id: {}, method: 'getState' },
      { polylap: 1, id: 1, method: 7 },
      { polylap: 1, id: 1, result: 'getState' },
    ])
      await at.say(message);
    const stranger = at.page.frames().find((frame) => frame.url() === 'about:srcdoc') as Frame;
    const request = { polylap: 1, id: 'stranger', method: 'getState' };
    await stranger.evaluate((said) => window.parent.frames[0]?.postMessage(said, '*'), request);
    await at.frame.evaluate((said) => window.postMessage(said, '*'), request);
    // What came after them all is answered.
    await at.ask('getState');
    expect((await at.heard()).slice(before)).toHaveLength(1);
    expect(await stranger.evaluate(() => (globalThis as unknown as { heard: unknown[] }).heard)).toEqual([]);
  });
});

describe('keys=release', () => {
  it('hands the keys of decks to the page around, and uses none of them', async () => {
    const at = await host(`${figure('&keys=release')}<script src="${site.url}polylap-frame.js"></script><script>
      var pressed = []; addEventListener('keydown', (e) => pressed.push(e.key + ' ' + e.keyCode))</script>`);
    const { page, frame } = at;
    await at.event('ready');
    const slider = frame.locator('input[name="lambda"]');
    const value = () => slider.inputValue();
    // A click on the slider leaves the focus to the page.
    await slider.click();
    const [before, scroll] = [await value(), await frame.evaluate(() => scrollY)];
    const keys = ['ArrowRight', 'ArrowLeft', 'ArrowDown', 'ArrowUp', 'Space', 'PageDown', 'PageUp'];
    for (const key of keys) await page.keyboard.press(key);
    const pressed = () => page.evaluate(() => (globalThis as unknown as { pressed: string[] }).pressed);
    await eventually(async () => (await pressed()).length).toBe(keys.length);
    expect(await pressed()).toEqual([
      'ArrowRight 39',
      'ArrowLeft 37',
      'ArrowDown 40',
      'ArrowUp 38',
      '  32',
      'PageDown 34',
      'PageUp 33',
    ]);
    expect([await value(), await frame.evaluate(() => scrollY)]).toEqual([before, scroll]);
    expect((await at.event('key')).detail).toMatchObject({ type: 'keydown', key: 'ArrowRight', code: 'ArrowRight' });
    // Who comes to it by keys, uses it.
    await slider.focus();
    await page.keyboard.press('ArrowRight');
    await eventually(value).not.toBe(before);
    expect(await pressed()).toHaveLength(keys.length);
    // Other keys are nobody else's.
    await page.keyboard.press('x');
    await at.ask('getState');
    expect(await pressed()).toHaveLength(keys.length);
    await at.close();
  });

  it('holds for the whole page, too', async () => {
    const at = await host(
      `<iframe width="1000" height="600" src="${site.url}index.html?embed&keys=release&mesh=noisy-torus"></iframe>`,
    );
    const { page, frame } = at;
    await at.event('ready');
    const handed = async () =>
      (await at.heard()).filter(({ event, detail }) => event === 'key' && detail?.type === 'keydown');
    await frame.getByRole('tab', { name: 'Smooth' }).click();
    await page.keyboard.press('ArrowRight');
    await eventually(async () => (await handed()).length).toBe(1);
    expect((await at.ask('getState')).result).toMatchObject({ task: 'smooth' });
    // Where arrows would turn the mesh.
    await frame.locator('.view').first().click();
    const camera = async () => ((await at.ask('getState')).result as { camera: unknown }).camera;
    await eventually(camera).not.toBe(null);
    const before = await camera();
    for (const key of ['ArrowUp', 'Space', 'PageDown']) await page.keyboard.press(key);
    await eventually(async () => (await handed()).length).toBe(4);
    expect(await camera()).toEqual(before);
    await at.close();
  });

  it('is a choice', async () => {
    const at = await host(figure());
    await at.event('ready');
    await at.frame.locator('body').click({ position: { x: 5, y: 5 } });
    await at.page.keyboard.press('ArrowRight');
    await at.ask('getState');
    expect((await at.heard()).filter(({ event }) => event === 'key')).toEqual([]);
    await at.close();
  });
});

describe('polylap-frame.js', () => {
  it('gives frames their height, and makes promises of messages', async () => {
    const at = await host(`${figure()}<script src="${site.url}polylap-frame.js"></script>`);
    const { page } = at;
    const inside = () => at.frame.evaluate(() => document.documentElement.scrollHeight - innerHeight);
    await eventually(inside).toBe(0);
    expect(await at.frame.evaluate(() => innerHeight)).not.toBe(500);
    interface Helper {
      polylapFrame: (frame: HTMLIFrameElement) => {
        call: (method: string, ...params: unknown[]) => Promise<unknown>;
        on: (event: string, listener: (detail: unknown) => void) => () => void;
      };
    }
    const told = await page.evaluate(async () => {
      const { polylapFrame } = globalThis as unknown as Helper;
      const frame = polylapFrame(document.querySelector('iframe') as HTMLIFrameElement);
      const changes: unknown[] = [];
      const stop = frame.on('state-change', (detail) => changes.push(detail));
      await frame.call('setState', { settings: { lambda: 2 } });
      const state = await frame.call('getState');
      stop();
      const refused = await frame.call('nonsense').catch((error: Error) => error.message);
      return { state, refused, changes: changes.length };
    });
    expect(told.state).toMatchObject({ settings: { lambda: 2 } });
    expect(told.refused).toContain('there is no method nonsense');
    expect(told.changes).toBeGreaterThan(0);
    await at.close();
  });
});

describe.each(['index.html', 'polylap.html', 'polylap.html in a srcdoc'])('%s', (name) => {
  const at = {} as Host;
  const asked = 'embed&mesh=noisy-torus&a=cotan&task=smooth&controls=some&views=b&theme=dark&lang=de';
  beforeAll(async () => {
    const frame = name.endsWith('srcdoc')
      ? `<iframe width="900" height="600" sandbox="allow-scripts" srcdoc="${attribute(readFileSync(join(dist, 'polylap.html'), 'utf8'))}"></iframe>`
      : `<iframe width="900" height="600" src="${site.url}${name}?${asked}"></iframe>`;
    Object.assign(at, await host(frame));
    await at.event('ready');
    // A srcdoc has no address of its own to ask with; what is behind its # can be set.
    if (name.endsWith('srcdoc')) {
      await at.page.evaluate((hash) => {
        const { contentWindow } = document.querySelector('iframe') as HTMLIFrameElement;
        contentWindow?.location.replace(`about:srcdoc#${hash}`);
      }, asked);
      await at.frame.waitForFunction(
        () => document.querySelector('polylap-compare')?.getAttribute('task') === 'smooth',
      );
    }
  });
  afterAll(() => at.close?.());

  it('shows what its address asks for', async () => {
    await at.frame.getByRole('tab', { name: 'Glätten', selected: true }).waitFor();
    expect((await at.ask('getState')).result).toMatchObject({
      task: 'smooth',
      sides: { a: { operator: 'cotan' } },
      source: { kind: 'preset', id: 'noisy-torus' },
    });
    expect(await at.frame.locator('.card[data-side="a"]').isVisible()).toBe(false);
    expect(await at.frame.locator('.card[data-side="b"]').isVisible()).toBe(true);
    const scheme = () => at.frame.locator('.polylap').evaluate((page) => getComputedStyle(page).colorScheme);
    expect(await scheme()).toBe('dark');
    // It fills what it gets.
    await eventually(async () => (await at.heard()).findLast(({ event }) => event === 'size')?.detail).toMatchObject({
      height: 600,
    });
  });

  it('has the methods of the element, and tells what the element tells', async () => {
    expect((await at.ask('step', 2)).result).toBe(2);
    expect((await at.event('step')).detail).toMatchObject({ step: 1 });
    expect((await at.ask('reset')).error).toBeUndefined();
    const { result } = await at.ask('getState');
    expect(result).toMatchObject({ step: 0 });
    await at.ask('setState', { ...(result as object), selected: 17 });
    await eventually(async () =>
      (await at.heard()).some(({ event, detail }) => event === 'pick' && detail?.vertex === 17),
    ).toBe(true);
    expect(await at.ask('matrix', 'b')).toMatchObject({ result: { stiffness: { rows: 512, cols: 512 } } });
    expect(await at.ask('toPNG', 'b')).toMatchObject({ result: { type: 'image/png' } });
    expect((await at.ask('toSVG', 'b')).result).toMatch(/^<svg /);
    const square = 'v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 1 2 3 4\n';
    const open = (text: string) =>
      at.page.evaluate((obj) => {
        const { contentWindow } = document.querySelector('iframe') as HTMLIFrameElement;
        const params = [new Blob([obj]), 'square.obj'];
        contentWindow?.postMessage({ polylap: 1, id: obj.length, method: 'load', params }, '*');
        return obj.length;
      }, text);
    expect(await at.reply(await open(square))).toMatchObject({ result: { vertices: 4, faces: 1 } });
    expect((await at.reply(await open(`${square}f 1 2 9\n`)))?.error?.message).toMatch(/(line|Zeile) 6/);
    expect((await at.ask('setState', { version: 99 })).error?.message).toBeTruthy();
  });
});

describe('polylap.html from a disk', () => {
  it('does what is asked for behind the #, and follows when that changes', async () => {
    const page = await site.browser.newPage();
    const address = pathToFileURL(join(dist, 'polylap.html')).href;
    await page.goto(`${address}#mesh=torus?nu=12%26nv=8&task=check&lang=de`);
    const state = () => page.evaluate(() => document.querySelector('polylap-compare')?.getState());
    await page.locator('polylap-compare').waitFor();
    expect(await state()).toMatchObject({
      task: 'check',
      source: { shape: { id: 'torus', parameters: { nu: 12, nv: 8 } } },
    });
    await page.evaluate(() => {
      location.hash = '#mesh=torus?nu=12%26nv=8&task=dual';
    });
    await eventually(state).toMatchObject({ task: 'dual' });
    await page.close();
  });

  it('shows a figure that is asked for', async () => {
    const page = await site.browser.newPage();
    await page.goto(`${pathToFileURL(join(dist, 'polylap.html')).href}#figure=two-cuts`);
    await page.locator('[data-figure="two-cuts"]').waitFor();
    await page.close();
  });
});
