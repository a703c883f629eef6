import { Matrix4, Scene, type Texture, Vector3 } from 'three';
import type { Geometry } from '../polylap.js';
import { type Layer, type LayerName, vertexNormal } from './layers.js';
import { Markers } from './markers.js';
import { type Colours, Surface } from './surface.js';

/** From how many pixels an edge on there is room to hatch the area around a vertex. */
const roomyEdge = 16;

interface Painted {
  uniforms: Record<string, { value: unknown }>;
}

/** What a view shows of the mesh: its surface, what is drawn over it, and marks. */
export class Content {
  readonly scene = new Scene();
  readonly surface: Surface;
  readonly markers: Markers;
  private readonly layers = new Map<LayerName, Layer>();

  constructor(
    readonly geometry: Geometry,
    triangles: Texture,
    map: Texture,
    private readonly meanEdge: number,
    zIsUp: boolean,
  ) {
    this.surface = new Surface(geometry, geometry.positions.length / 3, triangles, map);
    this.markers = new Markers(this.surface.positions.texture, 0.35 * meanEdge);
    this.scene.add(this.surface.mesh, this.markers.object);
    this.scene.matrixAutoUpdate = false;
    if (zIsUp) this.scene.matrix.makeRotationX(-Math.PI / 2);
    this.scene.updateMatrixWorld(true);
  }

  /** @returns the layer that was there, and is to be disposed of */
  setLayer(name: LayerName, layer: Layer | null, visible: boolean): Layer | null {
    const before = this.layers.get(name) ?? null;
    if (before) this.scene.remove(before.object);
    this.layers.delete(name);
    if (layer) {
      layer.object.visible = visible;
      this.layers.set(name, layer);
      this.scene.add(layer.object);
      layer.object.updateMatrixWorld(true);
    }
    return before;
  }

  showLayer(name: LayerName, visible: boolean): void {
    const layer = this.layers.get(name);
    if (layer) layer.object.visible = visible;
  }

  recolour(colours: Colours): void {
    const take = ({ uniforms }: Painted) => {
      for (const [name, colour] of Object.entries(colours)) if (uniforms[name]) uniforms[name].value = colour;
    };
    take(this.surface.material);
    take(this.markers.material);
    for (const { material, ink } of this.layers.values()) {
      take(material);
      if (material.uniforms.ink) material.uniforms.ink.value = colours[ink];
    }
  }

  /** Before it is drawn: sizes in pixels become those of the screen. */
  fit(width: number, height: number, ratio: number, lengthPerPixel: number): void {
    for (const layer of this.layers.values()) layer.fit(width, height, ratio, lengthPerPixel);
    for (const { uniforms } of [this.surface.material, this.markers.material])
      if (uniforms.pixelRatio) uniforms.pixelRatio.value = ratio;
    this.markers.crowd(this.meanEdge < roomyEdge * lengthPerPixel);
  }

  /** Of a vertex, in the world. */
  placeOf(vertex: number): Vector3 {
    return new Vector3().fromArray(this.surface.points, 3 * vertex).applyMatrix4(this.scene.matrix);
  }

  toModel(world: Vector3): Vector3 {
    return world.clone().applyMatrix4(new Matrix4().copy(this.scene.matrix).invert());
  }

  /** In the model. */
  normalOf(vertex: number): [number, number, number] {
    return vertexNormal(this.geometry, this.surface.faceNormals, vertex);
  }

  dispose(): void {
    this.surface.dispose();
    for (const layer of this.layers.values()) layer.dispose();
    this.markers.dispose();
  }
}
