/** Fingers, trackpads and the wheel: on a page of its own, on one that scrolls, and inside another page. */
import type { CDPSession, Frame, Page } from 'playwright-core';
import { afterAll, beforeAll, describe, expect, it } from 'vitest';
import { clickVertex, picture, settled, useSite, type Visit, visit } from './browser.js';

const site = useSite();

type Point = readonly [x: number, y: number];

/** What fingers do, a step at a time. */
class Hand {
  private constructor(private readonly session: CDPSession) {}

  static async on(page: Page): Promise<Hand> {
    return new Hand(await page.context().newCDPSession(page));
  }

  private send(
    type: 'touchStart' | 'touchMove' | 'touchEnd',
    points: readonly Point[],
    timestamp?: number,
  ): Promise<unknown> {
    const touchPoints = points.map(([x, y], id) => ({ x, y, id }));
    return this.session.send('Input.dispatchTouchEvent', { type, touchPoints, timestamp });
  }

  /** @param when it is, in seconds since 1970, whatever the time it takes to arrive */
  async tap(at: Point, when?: number): Promise<void> {
    await Promise.all([this.send('touchStart', [at], when), this.send('touchEnd', [], when && when + 0.03)]);
  }

  async doubleTap(at: Point): Promise<void> {
    const now = Date.now() / 1000;
    await Promise.all([this.tap(at, now), this.tap(at, now + 0.1)]);
  }

  /** Each finger along a straight line, all at once. */
  async drag(from: readonly Point[], to: readonly Point[]): Promise<void> {
    await this.send('touchStart', from);
    const steps = 8;
    for (let step = 1; step <= steps; step++)
      await this.send(
        'touchMove',
        from.map(([x, y], k) => {
          const [u = x, v = y] = to[k] ?? [];
          return [x + ((u - x) * step) / steps, y + ((v - y) * step) / steps];
        }),
      );
    await this.send('touchEnd', []);
  }
}

const cameraOf = (frame: Page | Frame) => frame.evaluate(() => globalThis.polylap.state().camera);
type Camera = Awaited<ReturnType<typeof cameraOf>>;
const length = (v: readonly number[]) => Math.hypot(...v);
const offset = (camera: Camera) => camera?.position.map((c, k) => c - (camera.target[k] ?? 0)) ?? [];
const distance = (camera: Camera) => length(offset(camera));
/** Waits until the camera rests elsewhere than before. */
const moved = async (frame: Page | Frame, before: Camera): Promise<Camera> => {
  await frame.waitForFunction(
    (was) => JSON.stringify(globalThis.polylap.state().camera) !== was,
    JSON.stringify(before),
  );
  return cameraOf(frame);
};
const middle = async (page: Page | Frame): Promise<Point> => {
  const box = await page.locator('[data-view=a]').boundingBox();
  if (!box) throw new Error('no view');
  return [box.x + box.width / 2, box.y + box.height / 2];
};

describe('a page of its own', () => {
  const at = {} as Visit;
  let hand: Hand;
  beforeAll(async () => {
    Object.assign(at, await visit(site, { hasTouch: true }));
    hand = await Hand.on(at.page);
  });
  afterAll(() => at.close?.());

  it('zooms by the wheel', async () => {
    const { page } = at;
    await clickVertex(page, 'a', await page.evaluate(() => globalThis.polylap.state().selected ?? 0));
    const before = await cameraOf(page);
    const [x, y] = await middle(page);
    await page.mouse.move(x, y);
    await page.mouse.wheel(0, 200);
    expect(distance(await moved(page, before))).toBeGreaterThan(1.05 * distance(before));
    expect(await page.locator('.view-hint').count()).toBe(0);
  });

  it('turns by one finger, zooms and moves by two', async () => {
    const { page } = at;
    const [x, y] = await middle(page);
    const first = await cameraOf(page);
    await hand.drag([[x, y]], [[x + 20, y + 80]]);
    const turned = await moved(page, first);
    expect(distance(turned)).toBeCloseTo(distance(first), 6);
    expect(length(turned?.target.map((c, k) => c - (first?.target[k] ?? 0)) ?? [1])).toBeLessThan(1e-9);
    expect(length(offset(turned).map((c, k) => c - (offset(first)[k] ?? 0)))).toBeGreaterThan(0.1 * distance(first));
    await hand.drag(
      [
        [x - 30, y],
        [x + 30, y],
      ],
      [
        [x - 90, y],
        [x + 90, y],
      ],
    );
    const nearer = await moved(page, turned);
    expect(distance(nearer)).toBeLessThan(0.8 * distance(turned));
    await hand.drag(
      [
        [x - 30, y],
        [x + 30, y],
      ],
      [
        [x + 40, y + 30],
        [x + 100, y + 30],
      ],
    );
    const panned = await moved(page, nearer);
    expect(panned?.target).not.toEqual(nearer?.target);
    expect(distance(panned) / distance(nearer)).toBeCloseTo(1, 1);
  });

  it('shows all of the mesh again after a double tap', async () => {
    const { page } = at;
    const [x, y] = await middle(page);
    const before = await cameraOf(page);
    await hand.doubleTap([x, y]);
    await page.waitForFunction(
      (was) => JSON.stringify(globalThis.polylap.state().camera?.target) !== was,
      JSON.stringify(before?.target),
    );
    const home = await cameraOf(page);
    await page.locator('[data-view=a]').focus();
    await page.keyboard.press('0');
    expect(await cameraOf(page)).toEqual(home);
  });

  it('picks by a tap, also from beside the mesh', async () => {
    const { page } = at;
    const seen = async (vertex: number) => page.evaluate((of) => globalThis.polylap.project('a', of), vertex);
    const front = await page.evaluate(() => {
      const total = globalThis.polylap.results().mesh?.vertices ?? 0;
      const selected = globalThis.polylap.state().selected;
      for (let vertex = 0; vertex < total; vertex++)
        if (vertex !== selected && globalThis.polylap.project('a', vertex)?.visible) return vertex;
      return -1;
    });
    const place = await seen(front);
    await hand.tap([(place?.x ?? 0) + 1, (place?.y ?? 0) + 1]);
    await page.waitForFunction((of) => globalThis.polylap.state().selected === of, front);
    // The lowest vertex of all on the screen, from below it by what a finger covers.
    const lowest = await page.evaluate(() => {
      const total = globalThis.polylap.results().mesh?.vertices ?? 0;
      const all = Array.from({ length: total }, (_, vertex) => ({
        vertex,
        ...globalThis.polylap.project('a', vertex),
      }));
      return all.reduce((low, each) => ((each.y ?? 0) > (low.y ?? 0) ? each : low));
    });
    await hand.tap([lowest.x ?? 0, (lowest.y ?? 0) + 18]);
    await page.waitForFunction((of) => globalThis.polylap.state().selected === of, lowest.vertex);
  });

  it('pins by one tap, and by a double tap nothing', async () => {
    const { page } = at;
    await page.getByRole('tab', { name: 'Harmonic' }).click();
    const [x, y] = await middle(page);
    const pins = () => page.evaluate(() => globalThis.polylap.state().harmonic.pins.length);
    await hand.tap([x, y + 60]);
    await page.waitForFunction(() => globalThis.polylap.state().harmonic.pins.length === 1);
    const before = await cameraOf(page);
    await hand.drag([[x, y]], [[x + 60, y]]);
    await moved(page, before);
    const turned = await cameraOf(page);
    await hand.doubleTap([x, y + 60]);
    await moved(page, turned);
    expect(await pins()).toBe(1);
    // Had the first of both taps pinned and the second one unpinned, there would be more to undo than the one pin.
    await page.keyboard.press('Control+z');
    await page.waitForFunction(() => globalThis.polylap.state().harmonic.pins.length === 0);
  });

  it('drags the label of a pin, and leaves the mesh where it is', async () => {
    const { page } = at;
    await page.getByRole('button', { name: 'Two pins, 0 and 1' }).click();
    await settled(page);
    const before = await cameraOf(page);
    const label = page.locator('[data-view=a] .pin-label:not(.unplaced)').first();
    const box = await label.boundingBox();
    if (!box) throw new Error('no label');
    const pins = () => page.evaluate(() => globalThis.polylap.state().harmonic.pins.map(({ vertex }) => vertex));
    const old = await pins();
    await hand.drag(
      [[box.x + box.width / 2, box.y + box.height / 2]],
      [[...(await middle(page))].map((c, k) => c + 70 * k) as unknown as Point],
    );
    await page.waitForFunction(
      (was) => globalThis.polylap.state().harmonic.pins.some(({ vertex }) => !was.includes(vertex)),
      old,
    );
    expect(await pins()).toHaveLength(2);
    expect(await cameraOf(page)).toEqual(before);
    expect(at.troubles).toEqual([]);
  });
});

describe('a page that scrolls', () => {
  it('leaves the wheel to it, and says once what zooms', async () => {
    const { page, troubles, close } = await visit(site, { viewport: { width: 1000, height: 700 } });
    await page.locator('[data-view=a]').focus();
    await page.keyboard.press('ArrowLeft');
    const before = await cameraOf(page);
    const top = () => page.evaluate(() => window.scrollY);
    await page.evaluate(() => window.scrollTo(0, 0));
    await page.mouse.move(...(await middle(page)));
    await page.mouse.wheel(0, 60);
    await page.waitForFunction(() => window.scrollY > 0);
    expect(await page.locator('.view-hint').textContent()).toMatch(/wheel zooms/);
    expect(await page.locator('.notice').textContent()).toMatch(/wheel zooms/);
    await picture(page, 'wheel-hint');
    expect(await cameraOf(page)).toEqual(before);
    const scrolled = await top();
    await page.keyboard.down('Control');
    await page.mouse.wheel(0, -60);
    await page.keyboard.up('Control');
    const after = await moved(page, before);
    expect(distance(after)).toBeLessThan(distance(before));
    expect(await top()).toBe(scrolled);
    await page.mouse.move(2, 2);
    await page.locator('.view-hint').waitFor({ state: 'detached' });
    await page.mouse.move(...(await middle(page)));
    await page.mouse.wheel(0, -20);
    await page.waitForFunction((was) => window.scrollY < was, scrolled);
    expect(await page.locator('.view-hint').count()).toBe(0);
    expect(troubles).toEqual([]);
    await close();
  });
});

describe('inside another page', () => {
  let page: Page;
  let frame: Frame;
  let hand: Hand;
  beforeAll(async () => {
    const context = await site.browser.newContext({
      viewport: { width: 1240, height: 800 },
      hasTouch: true,
      reducedMotion: 'reduce',
    });
    page = await context.newPage();
    await page.setContent(
      `<body style="margin:0"><iframe src="${site.url}" style="display:block;width:1220px;height:780px;border:0"></iframe><p style="height:3000px">More</p>`,
    );
    const handle = await page.locator('iframe').elementHandle();
    frame = (await handle?.contentFrame()) as Frame;
    await settled(frame as unknown as Page);
    hand = await Hand.on(page);
    await frame.locator('[data-view=a]').focus();
    await page.keyboard.press('ArrowLeft');
  });
  afterAll(() => page?.context().close());
  const top = () => page.evaluate(() => window.scrollY);
  /** Until the host rests at its top: a scroll goes on for some frames. */
  const scrollBack = () =>
    page.evaluate(
      () =>
        new Promise<void>((done) => {
          let rest = 0;
          const look = () => {
            rest = window.scrollY === 0 ? rest + 1 : 0;
            if (rest > 20) return done();
            window.scrollTo(0, 0);
            requestAnimationFrame(look);
          };
          look();
        }),
    );

  it('leaves the wheel to its host, and zooms with Ctrl', async () => {
    const before = await cameraOf(frame);
    await page.mouse.move(...(await middle(frame)));
    await page.mouse.wheel(0, 80);
    await page.waitForFunction(() => window.scrollY > 0);
    expect(await cameraOf(frame)).toEqual(before);
    expect(await frame.locator('.view-hint').isVisible()).toBe(true);
    await scrollBack();
    await page.keyboard.down('Control');
    await page.mouse.wheel(0, -60);
    await page.keyboard.up('Control');
    expect(distance(await moved(frame, before))).toBeLessThan(distance(before));
    expect(await top()).toBe(0);
  });

  it('lets one finger scroll up and down, and turn sideways', async () => {
    await scrollBack();
    const [x, y] = await middle(frame);
    await hand.drag([[x, y]], [[x, y - 160]]);
    await page.waitForFunction(() => window.scrollY > 40);
    await scrollBack();
    const before = await cameraOf(frame);
    await hand.drag([[x, y]], [[x + 160, y]]);
    const turned = await moved(frame, before);
    expect(distance(turned)).toBeCloseTo(distance(before), 6);
    expect(await top()).toBe(0);
  });

  it('gives two fingers to the mesh', async () => {
    await scrollBack();
    const [x, y] = await middle(frame);
    const before = await cameraOf(frame);
    await hand.drag(
      [
        [x - 30, y],
        [x + 30, y],
      ],
      [
        [x - 30, y - 120],
        [x + 30, y - 120],
      ],
    );
    const panned = await moved(frame, before);
    expect(panned?.target).not.toEqual(before?.target);
    expect(await top()).toBe(0);
    await hand.drag(
      [
        [x - 80, y],
        [x + 80, y],
      ],
      [
        [x - 30, y],
        [x + 30, y],
      ],
    );
    expect(distance(await moved(frame, panned))).toBeGreaterThan(1.2 * distance(panned));
    expect(await top()).toBe(0);
  });

  it('shows all of the mesh after a double tap, and picks by a tap', async () => {
    const before = await cameraOf(frame);
    const [x, y] = await middle(frame);
    await hand.doubleTap([x, y]);
    await moved(frame, before);
    const other = await frame.evaluate(() => {
      const total = globalThis.polylap.results().mesh?.vertices ?? 0;
      const { selected } = globalThis.polylap.state();
      for (let vertex = 0; vertex < total; vertex++) {
        const at = globalThis.polylap.project('a', vertex);
        if (vertex !== selected && at?.visible) return { vertex, ...at };
      }
      throw new Error('no vertex is seen');
    });
    await hand.tap([other.x, other.y]);
    await frame.waitForFunction((of) => globalThis.polylap.state().selected === of, other.vertex);
  });
});
