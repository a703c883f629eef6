/** Where the script was when it began: the full page lies beside it. */
const script = import.meta.url;

/** The address of the full page; null where it cannot be known. */
export function fullPage(): string | null {
  try {
    const { protocol } = new URL(script);
    return /^(https?|file):$/.test(protocol) ? new URL('index.html', script).href : null;
  } catch {
    return null;
  }
}
