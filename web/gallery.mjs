// Makes what the gallery shows:  node web/gallery.mjs  writes to build/public the meshes that are files, a picture of each entry, and what was
// measured of it. Needs the wasm preset and the node packages.
import { mkdir, rm, writeFile } from 'node:fs/promises';
import { fileURLToPath } from 'node:url';
import { runnerImport } from 'vite';
import { loadModule, quadBunny } from './bunny.mjs';
import { patchwork, polygonSoup, quad } from './soups.mjs';
import { thumbnail } from './thumbnail.mjs';

const target = new URL('../build/public/', import.meta.url);
const source = (name) => fileURLToPath(new URL(`src/${name}.ts`, import.meta.url));
const configuration = { root: fileURLToPath(new URL('.', import.meta.url)), configFile: false, logLevel: 'error' };
const [{ module: gallery }, { module: state }] = await Promise.all(
  ['gallery', 'state'].map((name) => runnerImport(source(name), configuration)),
);

const loaded = await loadModule();
const { module, get, open } = loaded;
const sides = ['a', 'b'];

const write = async (path, text) => {
  const file = new URL(path, target);
  await mkdir(new URL('.', file), { recursive: true });
  await writeFile(file, text);
};

/** Path → OBJ text of the meshes that are files. */
const files = new Map([
  ['meshes/quad-bunny.obj', await quadBunny(loaded)],
  ['meshes/quad.obj', quad()],
  ['meshes/polygon-soup.obj', polygonSoup()],
  ['meshes/patchwork.obj', patched({ shape: 'hexagon-sphere', level: 3 })],
]);

function patched(shape) {
  const session = make(shape);
  const { offsets, corners } = get(session.geometry());
  const coordinates = get(session.coordinates());
  session.delete();
  const points = Array.from({ length: coordinates.length / 3 }, (_, v) => [...coordinates.subarray(3 * v, 3 * v + 3)]);
  const faces = Array.from({ length: offsets.length - 1 }, (_, f) => [...corners.subarray(offsets[f], offsets[f + 1])]);
  return patchwork(points, faces, { size: 6 });
}

function make({ shape, noise = 0, seed = 1, ...settings }) {
  return get(module.make(shape, shape === 'voronoi' ? { ...settings, seed } : settings, noise, seed));
}

/** @returns a session with the mesh of an entry, and whether y is up in it */
function sessionOf({ kind, id, shape, changes = [] }) {
  const preset =
    kind === 'preset'
      ? state.presets.find((entry) => entry.id === id)
      : { shape: { shape: shape.id, ...shape.parameters } };
  const conversions = preset.change ? [preset.change, ...changes] : changes;
  let session = preset.file ? open(files.get(preset.file)) : make(preset.shape);
  for (const { conversion, id: name = conversion, parameters, side: _, moves: __, ...settings } of conversions) {
    const before = session;
    session = get(module.convert(before, module.Side.a, name, parameters ?? settings));
    before.delete();
  }
  return { session, yUp: preset.file !== undefined };
}

function measure(entry) {
  const { session, yUp } = sessionOf(entry.source);
  try {
    const { vertices, faces, minCorners, maxCorners, boundary } = get(session.info());
    const chosen = gallery.stateOf(entry, state.initialState());
    const negative = sides.map((side) => {
      const { operator, parameters } = chosen.sides[side];
      get(session.setOperator(module.Side[side], operator, parameters, undefined));
      const reply = session.weights(module.Side[side], undefined);
      return reply.error ? null : reply.ok.negativeOrdered;
    });
    const picture = thumbnail(get(session.geometry()), { closed: boundary.length === 0, yUp });
    return { vertices, faces, minCorners, maxCorners, negative, picture };
  } finally {
    session.delete();
  }
}

await rm(new URL('gallery/', target), { recursive: true, force: true });
for (const [path, text] of files) await write(path, text);
const facts = {};
/** Source → picture. */
const pictures = new Map();
for (const entry of gallery.groups.flatMap(({ entries }) => entries)) {
  const { picture, ...measured } = measure(entry);
  const key = JSON.stringify(entry.source);
  if (!pictures.has(key)) {
    pictures.set(key, `gallery/${entry.id}.svg`);
    await write(pictures.get(key), picture);
  }
  facts[entry.id] = { ...measured, picture: pictures.get(key) };
}
await write('gallery/facts.json', `${JSON.stringify(facts)}\n`);
