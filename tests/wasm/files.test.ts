/** Mesh files: every format in and out, what reading did, and repair on request. */
import { describe, expect, it } from 'vitest';
import { load, type MeshFormat } from '../../wasm/src/node.js';
import { failure } from './help.js';

const polylap = await load();
const formats: MeshFormat[] = ['obj', 'off', 'ply', 'stl'];
const decode = (bytes: Uint8Array) => new TextDecoder().decode(bytes);

describe('files', () => {
  it.each(['obj', 'off', 'ply'] as const)('%s keeps polygons and every digit', (format) => {
    const first = polylap.make({ shape: 'concave-hexagons', noise: 0.3 });
    const bytes = first.file(format);
    expect(decode(bytes.slice(0, 400))).toMatch({ obj: /^v /m, off: /^OFF/, ply: /^ply/ }[format]);
    const second = polylap.open(bytes, `again.${format.toUpperCase()}`);
    expect(second.surface()).toEqual(first.surface());
    expect(second.geometry()).toEqual(first.geometry());
    expect(second.info()).toEqual(first.info());
  });

  it('stl is binary, in triangles, single precision, and says that it was welded', () => {
    const triangles = polylap.make({ shape: 'torus', nu: 8, nv: 6 }).convert({ conversion: 'triangles' });
    const bytes = triangles.file('stl');
    expect(bytes.length).toBe(84 + 50 * 96);
    const welded = polylap.open(bytes, 'torus.stl');
    expect(welded.info()).toMatchObject({ vertices: 48, faces: 96, notes: ['288 corners welded to 48 vertices'] });
    expect(welded.shape().area).toBeCloseTo(triangles.shape().area, 5);
    expect(triangles.info().notes).toEqual([]);
  });

  it('stl refuses a face of more corners and names it', () => {
    const error = failure(() => polylap.make({ shape: 'grid', nx: 2, ny: 2 }).file('stl'));
    expect(error).toMatchObject({ code: 'bad-argument', element: 0 });
  });

  it('are of the side that is named', () => {
    const torus = polylap.make({ shape: 'torus', nu: 8, nv: 6 });
    const loaded = torus.file('off');
    torus.smooth({ id: 'planar' }, { time: 0.01 }, { side: 'b' });
    expect(torus.file('off')).toEqual(loaded);
    expect(torus.file('off', { side: 'b' })).not.toEqual(loaded);
  });

  it('of an unknown format are refused', () => {
    const grid = polylap.make({ shape: 'grid', nx: 1, ny: 1 });
    expect(failure(() => grid.file('gltf' as never)).message).toContain(formats.join("' or '"));
    expect(failure(() => polylap.open('', 'mesh.gltf')).code).toBe('bad-argument');
  });

  it.each<[string, string, number]>([
    ['broken.off', 'OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 x\n3 0 1 2\n', 5],
    [
      'broken.ply',
      'ply\nformat ascii 1.0\nelement vertex 1\nproperty float x\nproperty float y\nproperty float z\nelement face 1\nproperty list uchar int vertex_indices\nend_header\n0 0 zero\n3 0 0 0\n',
      10,
    ],
    ['broken.stl', 'solid a\nfacet normal 0 0 1\nouter loop\nvertex 0 0 x\nendloop\nendfacet\nendsolid a\n', 4],
  ])('%s is refused with its line', (name, text, line) => {
    expect(failure(() => polylap.open(text, name))).toMatchObject({ code: 'parse-error', line });
  });
});

describe('repair', () => {
  // Two squares side by side, their common edge not shared: vertices 1 = 4, 2 = 7; the second looks the other way.
  const squares = [
    ...['0 0 0', '1 0 0', '1 1 0', '0 1 0', '1 0 0', '2 0 0', '2 1 0', '1 1 0'].map((point) => `v ${point}`),
    ...['1 2 3 4', '5 8 7 6', '2 3 4 1', '1 2 2'].map((face) => `f ${face}`),
  ].join('\n');

  it('is not done unless asked for', () => {
    expect(failure(() => polylap.open(squares, 'squares.obj'))).toMatchObject({
      code: 'bad-mesh',
      element: 3,
      line: 12,
    });
    expect(failure(() => polylap.open(squares, 'squares.obj', { repair: false })).code).toBe('bad-mesh');
  });

  it('lists each change by the file’s own numbers, and keeps them traceable', () => {
    const session = polylap.open(squares, 'squares.obj', { repair: true });
    const { vertices, faces, edges, components, repairs } = session.info();
    expect([vertices, faces, edges, components]).toEqual([6, 2, 7, 1]);
    const changes = Object.fromEntries(repairs.changes.map(({ kind, elements }) => [kind, [...elements]]));
    expect(changes['merged-vertices']).toEqual([4, 7]);
    expect(changes['degenerate-faces']).toEqual([3]);
    expect(changes['duplicate-faces']).toEqual([2]);
    expect(changes['turned-faces']?.length).toBe(1);
    for (const { message, elements } of repairs.changes) expect(message).toContain(String(elements.length));
    expect([...repairs.originalVertices]).toEqual([0, 1, 2, 3, 5, 6]);
    expect([...repairs.originalFaces]).toEqual([0, 1]);
    expect(session.weights({ id: 'planar' }).nonzeroOrdered).toBeGreaterThan(0);
  });

  it('merges what is close only as far as it is told', () => {
    const near = squares.replace('v 1 0 0\nv 2', 'v 1.001 0 0\nv 2').replace(/v 1 1 0\nf/, 'v 1.001 1 0\nf');
    const open = (mergeDistance: number) => polylap.open(near, 'near.obj', { repair: true, mergeDistance }).info();
    expect(open(0).vertices).toBe(8);
    expect(open(0.001).vertices).toBe(6);
    expect(failure(() => open(-1)).code).toBe('bad-argument');
    expect(failure(() => open('far' as never)).code).toBe('bad-argument');
    expect(failure(() => polylap.open(near, 'near.obj', { repair: 'yes' as never })).code).toBe('bad-argument');
  });

  it('of a sound mesh changes nothing and says so', () => {
    const torus = polylap.make({ shape: 'torus', nu: 8, nv: 6 });
    const { repairs } = polylap.open(torus.file('obj'), 'torus.obj', { repair: true }).info();
    expect(repairs.changes).toEqual([]);
    expect([...repairs.originalVertices]).toEqual([...Array(48).keys()]);
    expect([...torus.info().repairs.originalVertices]).toEqual([]);
  });
});
