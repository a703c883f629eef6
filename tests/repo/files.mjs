import { execFileSync } from 'node:child_process';
import { existsSync, readFileSync } from 'node:fs';
import { join } from 'node:path';
import { fileURLToPath } from 'node:url';

export const root = fileURLToPath(new URL('../..', import.meta.url));

/** All text files that git tracks or would track, as {path: text}. */
export function repositoryFiles() {
  // The folder may belong to somebody else than who runs the tests, as in a container.
  const listing = ['-c', 'safe.directory=*', 'ls-files', '-z', '--cached', '--others', '--exclude-standard'];
  const paths = execFileSync('git', listing, { cwd: root, encoding: 'utf8', maxBuffer: 2 ** 26 }).split('\0');
  const files = {};
  for (const path of new Set(paths.filter((path) => path && existsSync(join(root, path))))) {
    const bytes = readFileSync(join(root, path));
    if (!bytes.includes(0)) files[path] = bytes.toString('utf8');
  }
  return files;
}

/** The operator table, as the native command line tells it. */
export function operatorTable() {
  const program = process.env.POLYLAP_NATIVE_BIN ?? join(root, 'build/native/bin/polylap');
  return JSON.parse(execFileSync(program, ['operators', '--json'], { encoding: 'utf8' }));
}
