/**
 * What an address asks for by name, in its query; or behind its #, where a file or a srcdoc has no query of its own. Links to states are there, too: their
 * names are others.
 */
export function wanted(): URLSearchParams {
  const all = new URLSearchParams(location.search);
  for (const [name, value] of new URLSearchParams(location.hash.slice(1))) all.set(name, value);
  return all;
}

/** Whether the document is to be a part of another one: it is in a frame, or asks for it. */
export const isEmbedded = (): boolean => window !== window.parent || wanted().has('embed');
