/** How `<polylap-compare>` lives: it sleeps where nobody sees it, wakes as it was, moves, goes, and leaves nothing behind. */
import { describe, expect, it } from 'vitest';
import type { PolylapCompare } from '../../web/embed/element.js';
import { difference } from './acts.js';
import { picture } from './browser.js';
import { liveContexts, showsNegative, soon, started, stateOf, toldBy, useHosts } from './hosts.js';

const hosts = useHosts();
const meshes = ['noisy-torus', 'saddle', 'grid-8', 'quad', 'cube', 'noisy-saddle'];
const element = (id: string, attributes = '') => `<polylap-compare id="${id}" ${attributes}></polylap-compare>`;
const many = (count: number, attributes = '') =>
  Array.from({ length: count }, (_, k) => element(`e${k}`, `mesh="${meshes[k % meshes.length]}" ${attributes}`)).join(
    '',
  );

/** Whether an element has a context. */
const isAwake = (id: string) =>
  globalThis.contexts.some(
    (context) =>
      !context.isContextLost() &&
      context.canvas instanceof HTMLCanvasElement &&
      (context.canvas.getRootNode() as ShadowRoot).host?.id === id,
  );

describe('twelve figures on one page', () => {
  it('one below the other: those out of view hold no context', async () => {
    const { page, troubles, requests, close } = await hosts.open(many(12, 'controls="none"'), { early: true });
    await page.waitForFunction(isAwake, 'e0');
    // Far below nothing has begun.
    expect(await toldBy(page, 'e11', 'ready')).toEqual([]);
    for (let k = 0; k < 12; k += 2) {
      await page.locator(`#e${k}`).scrollIntoViewIfNeeded();
      await page.waitForFunction(isAwake, `e${k}`);
    }
    await page.waitForFunction(
      () =>
        document.querySelectorAll('polylap-compare').length ===
        globalThis.told.filter(({ type }) => type === 'ready').length,
    );
    await page.waitForFunction(() => globalThis.contexts.filter((each) => !each.isContextLost()).length <= 4);
    expect(await page.evaluate(isAwake, 'e0')).toBe(false);
    expect(await page.evaluate(() => globalThis.mostContexts)).toBeLessThan(9);
    expect(page.workers().length).toBe(2);
    expect(requests.filter((path) => path.startsWith('/lib/'))).toEqual(['/lib/polylap-compare.js']);
    expect(troubles).toEqual([]);
    await close();
  });

  it('all in view: eight are awake, the others show their picture, and who is used wakes', async () => {
    const { page, troubles, close } = await hosts.open(`<div class="deck">${many(12, 'controls="none"')}</div>`, {
      style: '.deck { display: grid; grid-template-columns: repeat(4, 1fr) } polylap-compare { height: 250px }',
      viewport: { width: 1300, height: 940 },
    });
    await page.waitForFunction(() => globalThis.contexts.filter((each) => !each.isContextLost()).length === 8);
    const asleep = await page.evaluate(() =>
      [...document.querySelectorAll('polylap-compare')]
        .filter(
          ({ id }) =>
            !globalThis.contexts.some(
              (context) =>
                !context.isContextLost() &&
                ((context.canvas as HTMLCanvasElement).getRootNode() as ShadowRoot).host?.id === id,
            ),
        )
        .map(({ id }) => id),
    );
    expect(asleep.length).toBe(4);
    // Each shows its mesh: it is not one colour.
    for (const id of asleep) {
      await soon(() =>
        page.evaluate((of) => {
          const canvas = document.getElementById(of)?.shadowRoot?.querySelector<HTMLCanvasElement>('canvas.scene');
          const context = canvas?.getContext('2d');
          if (!canvas || !context || canvas.width === 0) return 0;
          const { data } = context.getImageData(0, 0, canvas.width, canvas.height);
          return new Set(Array.from({ length: data.length / 4 }, (_, k) => data.slice(4 * k, 4 * k + 4).join())).size;
        }, id),
      ).toBeGreaterThan(5);
    }
    await picture(page, 'element-twelve');
    const [first = ''] = asleep;
    await page.locator(`#${first} [data-view=a]`).hover();
    await page.waitForFunction(isAwake, first);
    await page.waitForFunction(() => globalThis.contexts.filter((each) => !each.isContextLost()).length === 8);
    expect(await page.evaluate(() => globalThis.mostContexts)).toBeLessThanOrEqual(9);
    expect(troubles).toEqual([]);
    await close();
  });
});

it('wakes with the same camera, state and picture', async () => {
  const { page, troubles, close } = await hosts.open(`${element('one', 'controls="none"')}<p class="long"></p>`, {
    style: '.long { height: 3000px }',
  });
  await page.evaluate(() => (document.getElementById('one') as PolylapCompare).step(2));
  await page.locator('#one [data-view=a]').focus();
  for (const key of ['ArrowLeft', 'ArrowLeft', 'ArrowUp', '+']) await page.keyboard.press(key);
  const before = await stateOf(page, 'one');
  expect(before.camera).not.toBeNull();
  const seen = () => page.locator('#one .stage').screenshot();
  await page.evaluate(() => (document.activeElement as HTMLElement).blur());
  const picture = await seen();
  await page.evaluate(() => scrollTo(0, 2500));
  await page.waitForFunction(() => globalThis.contexts.every((each) => each.isContextLost()));
  // What scripts ask of it meanwhile, it does.
  const png = await page.evaluate(
    async () => (await (document.getElementById('one') as PolylapCompare).toPNG('a')).size,
  );
  expect(png).toBeGreaterThan(1000);
  await page.waitForFunction(() => globalThis.contexts.every((each) => each.isContextLost()));
  await page.evaluate(() => scrollTo(0, 0));
  await page.waitForFunction(isAwake, 'one');
  expect(await stateOf(page, 'one')).toEqual(before);
  await soon(async () => difference(page, picture, await seen())).toBeLessThan(1e-3);
  expect(troubles).toEqual([]);
  await close();
});

it('sleeps where the document is hidden', async () => {
  const { page, close } = await hosts.open(element('one'));
  await page.waitForFunction(isAwake, 'one');
  const turn = (state: DocumentVisibilityState) =>
    page.evaluate((now) => {
      Object.defineProperty(document, 'visibilityState', { value: now, configurable: true });
      document.dispatchEvent(new Event('visibilitychange'));
    }, state);
  await turn('hidden');
  expect(await liveContexts(page)).toBe(0);
  await turn('visible');
  expect(await liveContexts(page)).toBe(1);
  await close();
});

describe('in and out of the document', () => {
  it('moved, it goes on; removed, it leaves nothing; put back, it is as it was', async () => {
    const { page, troubles, close } = await hosts.open(`<div id="here">${element('one')}</div><div id="there"></div>`);
    await page.evaluate(() => (document.getElementById('one') as PolylapCompare).step(2));
    const before = await stateOf(page, 'one');
    await page.evaluate(() => document.getElementById('there')?.append(document.getElementById('one') as Element));
    await page.waitForFunction(isAwake, 'one');
    expect((await toldBy(page, 'one', 'ready')).length).toBe(1);
    expect(await stateOf(page, 'one')).toEqual(before);
    // Out of the document: no context, no picture, and nothing listens any more.
    await page.evaluate(() => {
      Object.assign(globalThis, { kept: document.getElementById('one') });
      document.getElementById('one')?.remove();
    });
    await page.waitForFunction(() => globalThis.contexts.every((each) => each.isContextLost()));
    const inside = await page.evaluate(() =>
      (globalThis as unknown as { kept: Element }).kept.shadowRoot?.querySelector('.polylap'),
    );
    expect(inside).toBeNull();
    await page.keyboard.press(']');
    await page.evaluate(() =>
      document.getElementById('here')?.append((globalThis as unknown as { kept: Element }).kept),
    );
    await page.waitForFunction(isAwake, 'one');
    expect(await stateOf(page, 'one')).toEqual(before);
    await showsNegative(page, 'one', 2048, 0);
    expect(troubles).toEqual([]);
    await close();
  });

  it('comes and goes many times, and the page is not heavier for it', async () => {
    const { page, troubles, close } = await hosts.open(element('first'), { early: false });
    const session = await page.context().newCDPSession(page);
    const weigh = async () => {
      await session.send('HeapProfiler.collectGarbage');
      const { metrics } = await session.send('Performance.getMetrics');
      const of = (name: string) => metrics.find((metric) => metric.name === name)?.value ?? Number.NaN;
      return { listeners: of('JSEventListeners'), nodes: of('Nodes') };
    };
    await session.send('Performance.enable');
    const visit = (count: number) =>
      page.evaluate(async (times) => {
        for (let k = 0; k < times; k++) {
          const made = document.createElement('polylap-compare');
          made.setAttribute('mesh', 'quad');
          made.setAttribute('loading', 'eager');
          document.body.prepend(made);
          await made.getState();
          made.remove();
          await new Promise((done) => setTimeout(done));
        }
      }, count);
    await visit(5);
    await page.evaluate(() => globalThis.contexts.splice(0));
    const before = await weigh();
    await visit(15);
    // A context that the test holds would hold all that was around it.
    await page.evaluate(() => globalThis.contexts.splice(0));
    await soon(async () => (await weigh()).listeners - before.listeners).toBeLessThan(300);
    await soon(async () => (await weigh()).nodes - before.nodes).toBeLessThan(1500);
    expect(await liveContexts(page)).toBeLessThanOrEqual(1);
    expect(page.workers().length).toBe(2);
    expect(troubles).toEqual([]);
    await close();
  });

  it('made by a script, and by one that came before its own', async () => {
    const { page, troubles, close } = await hosts.open('<div id="place"></div>', { early: true });
    await page.evaluate(() => {
      const made = document.createElement('polylap-compare');
      made.id = 'made';
      made.setAttribute('mesh', 'grid-2');
      document.getElementById('place')?.append(made);
    });
    await started(page);
    await showsNegative(page, 'made', 16, 0);
    expect(troubles).toEqual([]);
    await close();
  });
});

describe('loading', () => {
  it('by a button over the poster, near the viewport, or at once', async () => {
    const { page, requests, troubles, close } = await hosts.open(
      `${element('click', 'loading="click" poster="poster.svg" alt="A torus"')}<p class="long"></p>${element('lazy')}${element('eager', 'loading="eager"')}`,
      {
        early: true,
        style: '.long { height: 3000px }',
        files: {
          'poster.svg': '<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 4 3"><rect width="4" height="3"/></svg>',
        },
      },
    );
    await soon(() => toldBy(page, 'eager', 'ready')).toHaveLength(1);
    expect(await toldBy(page, 'lazy', 'ready')).toEqual([]);
    expect(await toldBy(page, 'click', 'ready')).toEqual([]);
    expect(requests).toContain('/course/poster.svg');
    await page.locator('#click').getByRole('img', { name: 'A torus' }).waitFor();
    await picture(page, 'element-poster');
    await page.locator('#click').getByRole('button', { name: 'Start' }).click();
    await soon(() => toldBy(page, 'click', 'ready')).toHaveLength(1);
    expect(await page.locator('#click').getByRole('button', { name: 'Start' }).count()).toBe(0);
    await page.locator('#lazy').scrollIntoViewIfNeeded();
    await soon(() => toldBy(page, 'lazy', 'ready')).toHaveLength(1);
    expect(troubles).toEqual([]);
    await close();
  });
});

describe('autoplay', () => {
  it('smooths in sight, so many steps, and waits out of sight', async () => {
    const { page, close } = await hosts.open(
      `${element('one', 'autoplay="3"')}<p class="long"></p>${element('two', 'autoplay="2" loading="eager"')}`,
      { reducedMotion: 'no-preference', style: '.long { height: 3000px }' },
    );
    await soon(async () => (await stateOf(page, 'one')).step).toBe(3);
    expect((await stateOf(page, 'one')).task).toBe('smooth');
    await page.waitForFunction(
      () => document.querySelector('#one')?.shadowRoot?.querySelector('[data-action=play]')?.textContent === 'Play',
    );
    expect((await stateOf(page, 'two')).step).toBe(0);
    await page.locator('#two').scrollIntoViewIfNeeded();
    await soon(async () => (await stateOf(page, 'two')).step).toBe(2);
    await close();
  });

  it('not for those who ask for less motion', async () => {
    const { page, close } = await hosts.open(element('one', 'autoplay'));
    expect(await page.locator('#one').getByRole('button', { name: 'Play' }).isVisible()).toBe(true);
    expect((await stateOf(page, 'one')).step).toBe(0);
    await close();
  });
});
