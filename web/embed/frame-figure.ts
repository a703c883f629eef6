/** The page of a figure, in a frame. */
import type { Settings } from '../figures/figure.js';
import type { Mounted } from '../figures/mount.js';
import { mayBeSandboxed } from '../src/place.js';
import { standalone } from '../src/saving.js';
import { serveFrame } from './frame.js';
import { wanted } from './wanted.js';
import './frame-figure.css';

/** What belongs to the whole page does what the address asks for, too, where it means something to a figure. */
export function frameFigure(figure: Mounted): void {
  const asked = wanted();
  const { documentElement: page } = document;
  page.dataset.embed = '';
  for (const name of ['theme', 'controls']) {
    const value = asked.get(name);
    if (value !== null) page.dataset[name] = value;
  }
  // In the frame there is no room for the whole page; from a sandbox there is no way out of it.
  if (!mayBeSandboxed()) for (const link of figure.element.querySelectorAll('a')) link.setAttribute('target', '_blank');

  const set = async (settings: Settings) => {
    figure.set(settings);
    await figure.wake();
  };
  const methods = {
    getState: () => ({ figure: figure.id, settings: figure.settings() }),
    setState: async (state: unknown) => {
      const { figure: id = figure.id, settings } = Object(state) as { figure?: unknown; settings?: unknown };
      if (id !== figure.id) throw new Error(`the state is of the figure ${id}, and this is ${figure.id}`);
      if (typeof settings !== 'object' || settings === null) throw new Error('the state has no settings');
      await set(settings as Settings);
    },
    reset: async () => {
      figure.reset();
      await figure.wake();
    },
    toSVG: () => drawing(figure.element),
    toPNG: () => picture(drawing(figure.element)),
  };
  const frame = serveFrame({ methods, releasesKeys: () => ['release', 'none'].includes(asked.get('keys') ?? '') });

  const given = Object.keys(figure.settings()).flatMap((id) => {
    const text = asked.get(id);
    return text === null ? [] : [[id, Number.isNaN(Number(text)) ? text : Number(text)]];
  });
  if (given.length > 0) figure.set(Object.fromEntries(given));
  new MutationObserver(() => {
    if (figure.element.dataset.state === 'ready') frame?.tell('state-change', methods.getState());
  }).observe(figure.element, { attributeFilter: ['data-state'] });
  frame?.tell('ready', methods.getState());
}

/** As a file of its own; several pictures stand side by side. */
function drawing(figure: HTMLElement): string {
  const gap = 24;
  let [x, tallest] = [0, 0];
  const pictures = [...figure.querySelectorAll<SVGSVGElement>('.drawing svg')].map((svg) => {
    const { width, height } = svg.viewBox.baseVal;
    const placed = standalone(svg).replace('<svg ', `<svg x="${x}" y="0" `);
    x += width + gap;
    tallest = Math.max(tallest, height);
    return placed;
  });
  if (pictures.length === 0)
    throw new Error('What this figure shows is no drawing: the full page saves pictures of it.');
  const size = `${x - gap} ${tallest}`;
  const [width, height] = size.split(' ');
  return `<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 ${size}" width="${width}" height="${height}">${pictures.join('')}</svg>`;
}

/** Twice as fine as on screen. */
async function picture(svg: string): Promise<Blob> {
  const address = URL.createObjectURL(new Blob([svg], { type: 'image/svg+xml' }));
  try {
    const image = new Image();
    image.src = address;
    await image.decode();
    const canvas = document.createElement('canvas');
    [canvas.width, canvas.height] = [2 * image.width, 2 * image.height];
    canvas.getContext('2d')?.drawImage(image, 0, 0, canvas.width, canvas.height);
    return await new Promise((resolve, reject) => {
      canvas.toBlob((blob) => (blob ? resolve(blob) : reject(new Error('the picture is too large'))));
    });
  } finally {
    URL.revokeObjectURL(address);
  }
}
