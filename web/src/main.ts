import { wanted } from '../embed/wanted.js';
import type { App } from './app.js';
import { explain } from './messages.js';
import { type Mounted, mount } from './mount.js';
import { sharedClient } from './start-client.js';
import { presets, type View } from './state.js';
import { type Language, language, languageOf, setLanguage, t } from './words.js';

/** The page as a document of its own: it follows the address, and its theme and its language are the document's. */
let page: Mounted;

/** @param app goes on in another language */
function show(app?: App): void {
  document.documentElement.lang = language();
  document.title = t('polylap · Laplacians on polygon meshes, side by side');
  page = mount(document.getElementById('app') as HTMLElement, {
    client: sharedClient(),
    whole: true,
    start: async (fresh) => {
      if ((await fresh.follow(location.hash)) || fresh.results.get().mesh) return;
      const { error } = fresh.results.get();
      await fresh.meshes.preset(presets[0]?.id ?? '');
      if (error) fresh.results.set({ error });
    },
    ...(app && { app }),
    speak: (wanted) => void speak(wanted),
    onFrame: () => {
      if (performance.getEntriesByName('polylap:first-frame').length === 0) performance.mark('polylap:first-frame');
    },
  });
  page.app.state.watch(
    (state) => [state.theme],
    (theme) => {
      document.documentElement.dataset.theme = theme;
    },
  );
}

/** What is on screen stays, and undo reaches as far back as before. */
async function speak(wanted: Language): Promise<void> {
  const { app, element } = page;
  try {
    await setLanguage(wanted);
  } catch (reason) {
    app.results.set({ error: { title: t('The other language cannot be loaded'), text: explain(reason) } });
    return;
  }
  const focused = element.contains(document.activeElement);
  show(page.release());
  // The choice again, or the menu that it is in.
  const places = page.element.querySelectorAll<HTMLElement>('[data-action=language], .more');
  if (focused) [...places].find((place) => place.checkVisibility())?.focus();
  const address = new URL(location.href);
  address.searchParams.set('lang', wanted);
  try {
    history.replaceState(history.state, '', address);
  } catch {
    // Some frames have no address that could be changed.
  }
}

/** For the console and for tests: what is on screen, as data. */
const handle = {
  state: () => page.app.state.get(),
  results: () => page.app.results.get(),
  idle: () => page.app.idle,
  /** Where a vertex is on the page, in CSS pixels, and whether nothing hides it. */
  project: (view: View, vertex: number) => page.viewer.project(view, vertex),
  /** What is held on the graphics card; null without one. */
  held: () => (page.viewer.awake ? page.viewer.held : null),
};
declare global {
  var polylap: typeof handle;
}

async function begin(): Promise<void> {
  const asked = wanted();
  if (asked.has('embed')) {
    await import('../embed/frame-page.js');
    return;
  }
  // Where its words cannot be had the page speaks English.
  await setLanguage(languageOf(asked.get('lang'), document.documentElement.lang)).catch(() => {});
  show();
  window.addEventListener('hashchange', () => void page.app.follow(location.hash));
  Object.assign(globalThis, { polylap: handle });
}

void begin();
