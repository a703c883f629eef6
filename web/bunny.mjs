// Makes the quad bunny of the gallery from the npm package `bunny`.
// The Stanford bunny's 3674 triangles are simplified to 2500, paired into quads, and these cut into four by Catmull and Clark's rules:
// about 5000 vertices as in Herholz 2012, p. 31. It is closed: the package's bunny has no holes. Needs the wasm preset.
import { readFile } from 'node:fs/promises';
import bunny from 'bunny';
import { MeshoptSimplifier } from 'meshoptimizer/simplifier';

const triangles = 2500;
/** In mean edge lengths; for the noisy one. */
export const noise = { amplitude: 0.3, seed: 1 };

const obj = (positions, faces) =>
  [...positions.map((p) => `v ${p.join(' ')}`), ...faces.map((f) => `f ${f.map((v) => v + 1).join(' ')}`), ''].join(
    '\n',
  );

/** The simplified bunny: OBJ text without the vertices that are no longer used. */
async function simplified() {
  await MeshoptSimplifier.ready;
  const points = new Float32Array(bunny.positions.flat());
  const all = new Uint32Array(bunny.cells.flat());
  const [corners] = MeshoptSimplifier.simplify(all, points, 3, 3 * triangles, 1, ['Regularize']);
  const [number, count] = MeshoptSimplifier.compactMesh(corners); // numbers the corners anew, too
  const positions = new Array(count);
  for (const [old, fresh] of number.entries()) if (fresh < count) positions[fresh] = bunny.positions[old];
  const faces = [];
  for (let k = 0; k < corners.length; k += 3) faces.push([...corners.slice(k, k + 3)]);
  return obj(positions, faces);
}

/** The built module with one call that opens what a call returned. */
export async function loadModule() {
  const build = new URL('../build/wasm/', import.meta.url);
  const { default: createModule } = await import(new URL('polylap.js', build));
  const module = await createModule({ wasmBinary: await readFile(new URL('polylap.wasm', build)) });
  const get = ({ ok, error }) => {
    if (error) throw new Error(error.message);
    return ok;
  };
  const open = (text) => get(module.open(new TextEncoder().encode(text), 'mesh.obj', false, 0, undefined));
  return { module, get, open };
}

/** The quad bunny as OBJ text, rounded to four decimals of its ten units. */
export async function quadBunny({ module, get, open }) {
  const sessions = [open(await simplified())];
  for (const [id, settings] of [
    ['pair-triangles', {}],
    ['quads', { rule: 'catmull-clark' }],
  ])
    sessions.push(get(module.convert(sessions.at(-1), module.Side.a, id, settings)));
  const text = new TextDecoder().decode(get(module.file(sessions.at(-1), module.Side.a, 'obj')));
  for (const session of sessions) session.delete();
  return text.replace(/-?\d+\.\d+(e-?\d+)?/g, (number) => String(Number(Number(number).toFixed(4))));
}
