/** Where the script was when it began: the full page lies beside it. */
const script = import.meta.url;

/** The address of the full page; null where it cannot be known. */
export function fullPage(): string | null {
  try {
    const { protocol } = new URL(script);
    if (!/^(https?|file):$/.test(protocol)) return null;
    // From a disk only the page that is one file works.
    return new URL(protocol === 'file:' ? 'polylap.html' : 'index.html', script).href;
  } catch {
    return null;
  }
}
