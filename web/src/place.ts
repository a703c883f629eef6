/** What the place where the page was opened lets it do. */

/** The page's address without what was asked of it; null where there is none that can be opened again, as in a srcdoc. */
export function ownAddress(): string | null {
  if (!/^(https?|file):$/.test(location.protocol)) return null;
  const address = new URL(location.href);
  address.search = '';
  address.hash = '';
  return address.href;
}

/** Whether it is in a frame that may not be allowed to save files; that cannot be asked. */
export const mayBeSandboxed = (): boolean => window !== window.parent && window.origin === 'null';
