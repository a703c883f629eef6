import { join } from 'node:path';
import { fileURLToPath } from 'node:url';

const root = fileURLToPath(new URL('..', import.meta.url));

/**
 * Vite: modules that take the place of others.
 * @param modules which of which, by their paths from the root; the extension of those that go is left out
 */
export function replace(modules) {
  const places = new Map(Object.entries(modules).map(([path, other]) => [join(root, path), join(root, other)]));
  return {
    name: 'replace',
    enforce: 'pre',
    resolveId: (source, importer) =>
      (importer && source.startsWith('.') && places.get(join(importer, '..', source.replace(/\.[jt]s$/, '')))) || null,
  };
}
