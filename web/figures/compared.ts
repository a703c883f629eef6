/** A figure that compares: the page itself with its two views, in place of the picture that stood there. */
import { crowd, type Member } from '../embed/crowd.js';
import { adopt } from '../src/adopt.js';
import type { App } from '../src/app.js';
import { h } from '../src/dom.js';
import { mount } from '../src/mount.js';
import type { Client } from '../src/polylap.js';
import type { State } from '../src/state.js';
import embedStyles from '../src/styles/embed.css?inline';
import styles from '../src/styles/main.css?inline';
import { languageOf, setLanguage } from '../src/words.js';

export interface ComparedPage {
  /** Done when all of it is there. @throws Error, a sentence, where it cannot be */
  show(state: State): Promise<void>;
  dispose(): void;
}

interface Options {
  keys: 'capture' | 'release';
  lang: string;
}

export async function startCompared(drawing: HTMLElement, client: Client, options: Options): Promise<ComparedPage> {
  await setLanguage(languageOf(options.lang));
  const host = h('div', { class: 'views', controls: 'none' });
  drawing.append(host);
  const ground = h('div', { class: 'ground' });
  const root = host.attachShadow({ mode: 'open' });
  root.append(h('div', { class: 'embed' }, ground));
  for (const text of [styles, embedStyles]) adopt(ground, text);
  const mounted = mount(ground, {
    client: Promise.resolve(client),
    settings: { controls: 'none', views: 'both', keys: options.keys, wheel: 'scroll', touch: 'scroll' },
    asleep: true,
    onStale: () => crowd.look(),
    start: async () => {},
  });
  const { app } = mounted;
  const member: Member = {
    get stale() {
      return mounted.viewer.stale && app.results.get().mesh !== null && app.work.idle;
    },
    seen: () => {},
    wake: () => mounted.wake(),
    sleep: () => mounted.sleep(),
  };
  const hide = (hidden: boolean) => {
    for (const before of drawing.querySelectorAll<HTMLElement>('.still, .start')) before.hidden = hidden;
  };
  await mounted.ready;
  return {
    async show(wanted) {
      const now = app.state.get();
      const isSame = JSON.stringify(now.source) === JSON.stringify(wanted.source);
      // What belongs to who looks stays while the mesh does.
      const { camera, selected, selectedFace } = isSame && app.results.get().mesh ? now : wanted;
      app.results.set({ error: null });
      const only = wanted.delta.open && wanted.shown === 'delta' ? 'delta' : 'both';
      if (only === 'both') mounted.set({ views: 'both' });
      await app.goTo({ ...wanted, camera, selected, selectedFace });
      if (only === 'delta') mounted.set({ views: 'delta' });
      await settled(app);
      const { error } = app.results.get();
      if (error) throw new Error(`${error.title}: ${error.text}`);
      if (host.classList.contains('shown')) return;
      host.classList.add('shown');
      hide(true);
      crowd.add(host, member);
    },
    dispose() {
      crowd.remove(host);
      mounted.dispose();
      host.remove();
      hide(false);
    },
  };
}

/** Until nothing is under way, and both sides have their numbers. */
function settled(app: App): Promise<void> {
  const done = () => {
    const { mesh, error, a, b } = app.results.get();
    return app.work.idle && (error !== null || (mesh !== null && a.weights !== null && b.weights !== null));
  };
  return new Promise((resolve) => {
    let timer: ReturnType<typeof setTimeout> | undefined;
    let stop = () => {};
    stop = app.results.watch(
      (results) => [results],
      () => {
        clearTimeout(timer);
        timer = setTimeout(() => {
          if (!done()) return;
          stop();
          resolve();
        });
      },
    );
  });
}
