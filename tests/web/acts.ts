/** What the acts of this folder share: people do them, from the first click to the last number. */
import { AxeBuilder } from '@axe-core/playwright';
import type { Page } from 'playwright-core';
import type { State } from '../../web/src/state.js';

export const stateOf = (page: Page): Promise<State> => page.evaluate(() => globalThis.polylap.state());

/** Every number that the page shows, in the order of the page: what it is called, whose it is, its value. */
export const numbersOf = (page: Page): Promise<string[]> =>
  page.evaluate(() => {
    const shown = [...document.querySelectorAll<HTMLElement>('main [data-value]')].filter((e) => e.checkVisibility());
    return shown.map((element) => {
      const side = element.closest<HTMLElement>('[data-side]')?.dataset.side ?? element.dataset.of ?? '';
      return [element.dataset.readout ?? element.textContent, side, element.dataset.value].join(' ');
    });
  });

/** 3V coordinates of both sides. */
export const surfacesOf = (page: Page): Promise<number[][]> =>
  page.evaluate(() => {
    const { a, b } = globalThis.polylap.results();
    return [Array.from(a.positions), Array.from(b.positions)];
  });

/** The link that the page offers, read as a person does who copies it. */
export async function sharedLink(page: Page): Promise<string> {
  const link = page.getByLabel('This link opens the page', { exact: false });
  await link.waitFor();
  return link.inputValue();
}

/** What axe complains about, in one line each. */
/** @param except what is not looked at, as a selector */
export async function complaints(page: Page, except?: string): Promise<string[]> {
  // axe wants to open a page of its own to merge frames; there are no frames here.
  const axe = new AxeBuilder({ page: page as never }).setLegacyMode();
  const { violations } = await (except ? axe.exclude(except) : axe).analyze();
  return violations.flatMap(({ id, nodes }) =>
    nodes.map(({ target, failureSummary }) => `${id}: ${target.join(' ')} ${failureSummary}`),
  );
}

/** How much two pictures differ: the share of pixels of which a channel differs by more than a little. */
export async function difference(page: Page, one: Buffer, other: Buffer): Promise<number> {
  return page.evaluate(
    async (both) => {
      const [first, second] = await Promise.all(
        both.map(async (data) => {
          const bitmap = await createImageBitmap(await (await fetch(`data:image/png;base64,${data}`)).blob());
          const context = new OffscreenCanvas(bitmap.width, bitmap.height).getContext('2d');
          context?.drawImage(bitmap, 0, 0);
          return context?.getImageData(0, 0, bitmap.width, bitmap.height).data ?? new Uint8ClampedArray(0);
        }),
      );
      if (!first || !second || first.length !== second.length || first.length === 0) return 1;
      let pixels = 0;
      for (let k = 0; k < first.length; k += 4)
        if ([0, 1, 2].some((c) => Math.abs((first[k + c] ?? 0) - (second[k + c] ?? 0)) > 8)) pixels++;
      return (4 * pixels) / first.length;
    },
    [one.toString('base64'), other.toString('base64')],
  );
}
