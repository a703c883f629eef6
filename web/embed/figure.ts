import figureStyles from '../figures/figure.css?inline';
import { initialSettings } from '../figures/figure.js';
import { load } from '../figures/list.js';
import { type Mounted, mount } from '../figures/mount.js';
import { adopt } from '../src/adopt.js';
import { h } from '../src/dom.js';
import { standalone } from '../src/saving.js';
import { sharedClient } from '../src/start-client.js';
import type { State } from '../src/state.js';
import { language } from '../src/words.js';
import { fullPage } from './home.js';

/** So much finer than on screen a picture is. */
const fineness = 2;

/** A drawn figure in an element. It sleeps by itself until it is touched, and takes no WebGL context. */
export class LiveFigure {
  readonly ready = Promise.resolve();
  readonly stale = false;

  private constructor(
    private readonly place: HTMLElement,
    private readonly figure: Mounted,
    /** Of the full page that shows the same. */
    readonly state: State,
  ) {}

  /** @returns what the page shows instead, where the figure is no drawing */
  static async of(id: string, ground: HTMLElement, keys: 'take' | 'release'): Promise<LiveFigure | State> {
    const lang = language();
    const { figure } = await load(id, lang);
    const state = figure.state(initialSettings(figure));
    if (figure.kind === 'compared') return state;
    adopt(ground, figureStyles);
    const place = h('div', { class: 'figure-place', part: 'figure' });
    ground.append(place);
    const page = fullPage();
    const figureIn = await mount(place, id, { lang, client: sharedClient, keys, fullPage: page ?? '' });
    if (!page) place.querySelector('a.permalink')?.remove();
    return new LiveFigure(place, figureIn, state);
  }

  seen(): void {}
  wake(): void {}
  sleep(): void {}
  /** Attributes that change it make it anew. */
  async change(): Promise<void> {}

  async reset(): Promise<void> {
    this.figure.reset();
    await this.figure.wake();
  }

  toSvg(): string {
    const drawing = this.place.querySelector('svg');
    if (!drawing) throw new Error('There is no drawing yet.');
    return standalone(drawing);
  }

  async toPng(): Promise<Blob> {
    const picture = new Image();
    picture.src = `data:image/svg+xml,${encodeURIComponent(this.toSvg())}`;
    await picture.decode();
    const canvas = document.createElement('canvas');
    canvas.width = fineness * picture.width;
    canvas.height = fineness * picture.height;
    canvas.getContext('2d')?.drawImage(picture, 0, 0, canvas.width, canvas.height);
    return new Promise((resolve, reject) => {
      canvas.toBlob((blob) => (blob ? resolve(blob) : reject(new Error('The picture is too large to be saved.'))));
    });
  }

  dispose(): void {
    this.figure.destroy();
    this.place.remove();
  }
}
