/** The scripts of the site lie in a folder of it: pages in folders of their own find the same files. */
const here = import.meta.url;
const addressOf = (path: string): URL => new URL(`../${path}`, here);

/**
 * What lies beside the page: meshes, pictures, what was measured of them.
 * @param path as in build/public
 * @throws Error, a sentence, when it cannot be had
 */
export async function publicFile(path: string, signal?: AbortSignal): Promise<Blob> {
  const answer = await fetch(addressOf(path), { signal: signal ?? null });
  if (!answer.ok) throw new Error(`the file ${path} could not be loaded: the server says ${answer.status}`);
  return answer.blob();
}

/** Where an image shows it. */
export const publicUrl = (path: string): string => addressOf(path).href;
