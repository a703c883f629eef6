/** The native command line, to compare with. */
import { execFileSync } from 'node:child_process';
import { existsSync, mkdtempSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { fileURLToPath } from 'node:url';
import type { OperatorSpec } from '../../wasm/src/node.js';

const binary =
  process.env.POLYLAP_NATIVE_BIN ?? fileURLToPath(new URL('../../build/native/bin/polylap', import.meta.url));
if (!existsSync(binary)) throw new Error(`${binary} is missing: build it with 'npm run build:native'`);

export const meshFolder = new URL('../data/meshes/', import.meta.url);
export const readMesh = (name: string) => readFileSync(new URL(name, meshFolder));

/** Runs the tool; its standard output. Throws an Error with the line on standard error. */
export function native(...args: string[]): string {
  try {
    return execFileSync(binary, args, { encoding: 'utf8', stdio: 'pipe', maxBuffer: 2 ** 28 });
  } catch (error) {
    throw new Error((error as { stderr: string }).stderr.trim());
  }
}

/** Runs `work` with a folder of its own and removes it afterwards. */
export function inFolder<T>(work: (folder: string) => T): T {
  const folder = mkdtempSync(join(tmpdir(), 'polylap-'));
  try {
    return work(folder);
  } finally {
    rmSync(folder, { recursive: true });
  }
}

/** @param folder where a file of vertex weights can be put */
export function operatorArguments(spec: OperatorSpec, folder: string): string[] {
  const { id, vertexWeights, ...parameters } = spec as OperatorSpec & { vertexWeights?: ArrayLike<number> };
  const settings = Object.entries(parameters).flatMap(([name, value]) => ['--set', `${name}=${value}`]);
  if (!vertexWeights) return ['--operator', id, ...settings];
  const file = join(folder, 'weights.csv');
  writeFixed(
    file,
    Array.from(vertexWeights, (weight, vertex) => [vertex, weight]),
  );
  return ['--operator', id, ...settings, '--weights', file];
}

/** The entries of a MatrixMarket file, "row,column" → value, symmetric ones on both sides. */
export function readMatrixMarket(file: string): Map<string, number> {
  const [header, ...lines] = readFileSync(file, 'utf8').split('\n');
  const entries = new Map<string, number>();
  for (const line of lines.filter((text) => text && !text.startsWith('%')).slice(1)) {
    const [row, column, value] = line.split(' ').map(Number) as [number, number, number];
    entries.set(`${row - 1},${column - 1}`, value);
    if (header?.includes('symmetric')) entries.set(`${column - 1},${row - 1}`, value);
  }
  return entries;
}

export function readCoordinates(objFile: string): number[] {
  const lines = readFileSync(objFile, 'utf8').split('\n');
  return lines.filter((line) => line.startsWith('v ')).flatMap((line) => line.split(' ').slice(1, 4).map(Number));
}

/** The values of rows `vertex,value`, in the order of the vertices. */
export function readValues(csvFile: string): number[] {
  const rows = readFileSync(csvFile, 'utf8').trim().split('\n');
  const values: number[] = [];
  for (const row of rows.filter((text) => /^\d/.test(text))) {
    const [vertex, value] = row.split(',') as [string, string];
    values[Number(vertex)] = Number(value);
  }
  return values;
}

export const writeFixed = (file: string, rows: [number, number][]) =>
  writeFileSync(file, rows.map((row) => row.join(',')).join('\n'));
