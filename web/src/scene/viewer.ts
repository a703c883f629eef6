import { Matrix4, type Texture, Vector3 } from 'three';
import { type ColourMap, colourTexture } from '../colour-maps.js';
import { meanEdge } from '../mean-edge.js';
import type { Geometry } from '../polylap.js';
import { type View, views } from '../state.js';
import { type Box, boxWithin } from './box-within.js';
import { LinkedCamera } from './camera.js';
import { readColours } from './colours.js';
import { Content } from './content.js';
import { triangleTexture } from './data-texture.js';
import { flightTo } from './flight.js';
import type { Gestures } from './host-scroll.js';
import { HoverRing } from './hover-ring.js';
import { type Label, Labels } from './labels.js';
import type { Layer, LayerName } from './layers.js';
import type { Mark } from './markers.js';
import { photograph } from './photograph.js';
import { type Aim, type Meant, meant, meantPoint } from './pick.js';
import { hidden } from './ray.js';
import { Retired } from './retired.js';
import { Screen } from './screen.js';
import { type Seen, seenBy } from './seen.js';
import type { Colours, Interval, Surface } from './surface.js';

interface Hooks {
  afterFrame(): void;
  /** The graphics card took the picture away. */
  lost(): void;
  restored(): void;
  /** Asleep, and what it shows is not what it would show. */
  stale(): void;
}

/**
 * Two views of the mesh in one canvas: one renderer, one camera, a scissored rectangle each. Draws when something changed, not otherwise.
 * It sleeps at first: holds nothing on the graphics card, and shows the picture it fell asleep with.
 */
export class Viewer {
  readonly camera: LinkedCamera;
  private readonly screen: Screen;
  private readonly observer = new ResizeObserver(() => this.resize());
  /** Whether waking up would change the picture. */
  stale = true;
  private readonly maps: Record<ColourMap, Texture> = {
    viridis: colourTexture('viridis'),
    cividis: colourTexture('cividis'),
    'red-blue': colourTexture('red-blue'),
  };
  private readonly labels: Record<View, Labels>;
  private readonly ring: HoverRing;
  private shown: Record<View, Content> | null = null;
  /** Where the third view shows A on its left and B on its right: which share of it is A's. */
  private swipe: number | null = null;
  private geometry: Geometry | null = null;
  private triangles: Texture | null = null;
  private frame = 0;
  private readonly retired = new Retired();
  private readonly hiddenLayers = new Set<LayerName>();
  /** Of the loaded mesh. */
  meanEdge = 1;
  private framed = false;
  private framedAspect = 0;

  constructor(
    canvas: HTMLCanvasElement,
    private readonly places: Record<View, HTMLElement>,
    gestures: Gestures,
    private readonly hooks: Hooks,
  ) {
    this.camera = new LinkedCamera(
      () => this.request(),
      () => {
        this.framed = false;
      },
      gestures,
    );
    this.labels = { a: new Labels(places.a), b: new Labels(places.b), delta: new Labels(places.delta) };
    this.ring = new HoverRing(places, (view, vertex) => this.project(view, vertex));
    for (const view of views) this.camera.attach(places[view]);
    this.screen = new Screen(canvas, {
      lost: () => hooks.lost(),
      restored: () => {
        this.resize();
        this.request();
        hooks.restored();
      },
    });
    this.observer.observe(this.screen.stage);
    for (const view of views) this.observer.observe(places[view]);
  }

  // --- waking and sleeping ------------------------------------------------------------------------------------------------

  get awake(): boolean {
    return this.screen.renderer !== null;
  }

  /** @throws where there is no WebGL */
  wake(): void {
    if (this.awake) return;
    this.screen.wake();
    this.resize();
  }

  /** Gives the graphics card back what it holds; what was drawn last stays in sight. */
  sleep(): void {
    if (!this.awake) return;
    this.screen.keepPicture(() => this.draw());
    this.release();
  }

  dispose(): void {
    this.clear();
    this.release();
    this.observer.disconnect();
    this.camera.dispose();
  }

  /** What three keeps for each geometry, material and texture goes with these; they come again when they are drawn. */
  private release(): void {
    cancelAnimationFrame(this.frame);
    this.frame = 0;
    this.retired.dispose();
    for (const shown of Object.values(this.shown ?? {})) shown.dispose();
    this.triangles?.dispose();
    for (const map of Object.values(this.maps)) map.dispose();
    this.screen.end();
  }

  // --- what is shown ------------------------------------------------------------------------------------------------------

  setMesh(geometry: Geometry, zIsUp: boolean): void {
    this.clear();
    this.geometry = geometry;
    this.triangles = triangleTexture(geometry);
    this.meanEdge = meanEdge(geometry);
    const make = () => new Content(geometry, this.triangles as Texture, this.maps.viridis, this.meanEdge, zIsUp);
    this.shown = { a: make(), b: make(), delta: make() };
    this.recolour();
    this.framed = true;
    this.framedAspect = 0;
    this.fit();
  }

  move(view: View, points: Float32Array): void {
    const surface = this.shown?.[view].surface;
    if (!surface || surface.points === points) return;
    surface.move(points);
    this.request();
  }

  /** Puts a layer in the place of the one with that name; null: none. */
  setLayer(view: View, name: LayerName, layer: Layer | null): void {
    const shown = this.shown?.[view];
    if (!shown) return;
    const before = shown.setLayer(name, layer, !this.hiddenLayers.has(name));
    if (!before && !layer) return;
    if (before) this.retired.add(before);
    if (layer) this.recolour();
    this.request();
  }

  showLayer(name: LayerName, visible: boolean): void {
    if (visible) this.hiddenLayers.delete(name);
    else this.hiddenLayers.add(name);
    for (const view of views) this.shown?.[view].showLayer(name, visible);
    this.request();
  }

  /** See Surface.fade. */
  fade(faded: number, edges: number): void {
    for (const view of views) this.shown?.[view].surface.fade(faded, edges);
    this.request();
  }

  /** @param allowed see Surface.show */
  setValues(
    view: View,
    values: Float64Array | null,
    range: Interval | null,
    map: ColourMap,
    allowed: Interval | null = null,
  ): void {
    this.shown?.[view].surface.show(values, range, this.maps[map], allowed);
    this.request();
  }

  setIsolines(count: number): void {
    for (const view of views) this.shown?.[view].surface.drawIsolines(count);
    this.request();
  }

  setMarks(view: View, groups: readonly { mark: Mark; vertices: ArrayLike<number> }[]): void {
    this.shown?.[view].markers.show(groups);
    this.request();
  }

  /** @param share of the third view that shows A, beside B; null: it shows the difference */
  setSwipe(share: number | null): void {
    this.swipe = share;
    this.request();
  }

  /** @param vertex under the pointer, or null */
  hover(vertex: number | null): void {
    this.ring.set(vertex);
    for (const view of views) {
      this.labels[view].hovered = vertex;
      this.placeLabels(view, this.boxOf(view));
    }
  }

  setLabels(view: View, group: string, labels: readonly Label[]): void {
    this.labels[view].set(group, labels);
    requestAnimationFrame(() => this.placeLabels(view, this.boxOf(view)));
  }

  /** Reads the colours anew, after the theme changed. */
  recolour(): void {
    const colours = this.colours();
    for (const view of views) this.shown?.[view].recolour(colours);
    this.request();
  }

  private colours(): Colours {
    return readColours(this.screen.stage);
  }

  // --- vertices and pixels ------------------------------------------------------------------------------------------------

  /** Where a vertex is on the page, and whether nothing hides it. */
  project(view: View, vertex: number): { x: number; y: number; visible: boolean } | null {
    const shown = this.shown?.[view];
    const box = this.places[view].getBoundingClientRect();
    if (!shown || !this.geometry || box.width === 0) return null;
    this.aim(box);
    const world = shown.placeOf(vertex);
    const eye = shown.toModel(this.camera.camera.position);
    const screen = world.project(this.camera.camera);
    const visible =
      Math.abs(screen.x) <= 1 &&
      Math.abs(screen.y) <= 1 &&
      !hidden(eye, vertex, shown.surface.points, this.geometry.triangles);
    return { x: box.x + ((screen.x + 1) / 2) * box.width, y: box.y + ((1 - screen.y) / 2) * box.height, visible };
  }

  /** What there is to see in a view, for drawing it elsewhere; null where it is not on screen. */
  seen(view: View): Seen | null {
    const shown = this.shown?.[view];
    const box = this.boxOf(view);
    if (!shown || box.width === 0 || box.height === 0) return null;
    this.aim(box);
    return seenBy(this.camera.camera, shown, box, this.colours());
  }

  /** The length that a pixel of a view covers where a vertex is. */
  lengthPerPixel(view: View, vertex: number): number {
    const shown = this.shown?.[view];
    const { height } = this.places[view].getBoundingClientRect();
    return shown && height > 0 ? this.camera.lengthPerPixel(shown.placeOf(vertex), height) : 0;
  }

  /** The vertex meant by a point of the page. */
  pick(view: View, clientX: number, clientY: number, touch = false): number | null {
    return this.meant(view, clientX, clientY, touch).vertex;
  }

  /** What is meant by a point of the page. */
  meant(view: View, clientX: number, clientY: number, touch = false): Meant {
    const aimed = this.aimAt(view, clientX, clientY, touch);
    return aimed && this.geometry
      ? meant(aimed.aim, this.geometry, aimed.surface.points)
      : { vertex: null, face: null };
  }

  /** Which of some points by the surface, 3 coordinates each, is meant by a point of the page. */
  pickPoint(view: View, clientX: number, clientY: number, points: Float32Array, touch: boolean): number | null {
    const aimed = this.aimAt(view, clientX, clientY, touch);
    if (!aimed || !this.geometry) return null;
    return meantPoint(aimed.aim, points, aimed.surface.points, this.geometry.triangles, 0.3 * this.meanEdge);
  }

  private aimAt(view: View, clientX: number, clientY: number, touch: boolean): { aim: Aim; surface: Surface } | null {
    const box = this.places[view].getBoundingClientRect();
    const [x, y] = [clientX - box.x, clientY - box.y];
    const there = this.contentsOf(view, box.width).find(({ from, to }) => from <= x && x < to);
    if (!there || box.width === 0) return null;
    this.aim(box);
    const { camera } = this.camera;
    const { scene, surface } = there.shown;
    const clip = new Matrix4().multiplyMatrices(camera.projectionMatrix, camera.matrixWorldInverse);
    const { width, height } = box;
    return { aim: { x, y, width, height, touch, clip: clip.multiply(scene.matrix) }, surface };
  }

  /** A vertex that is seen near the middle of the first view there is, rather below it: there the surface faces the eye. */
  front(): number | null {
    const view = views.find((each) => this.places[each].clientWidth > 0) ?? 'a';
    const { x, y, width, height } = this.places[view].getBoundingClientRect();
    for (const down of [0.6, 0.72, 0.5, 0.4, 0.28]) {
      const vertex = this.pick(view, x + 0.5 * width, y + down * height);
      if (vertex !== null) return vertex;
    }
    return null;
  }

  normalOf(view: View, vertex: number): [number, number, number] {
    return this.shown?.[view].normalOf(vertex) ?? [0, 0, 1];
  }

  /** Flies to where a vertex and the edges around it are seen, unless they are in full view already. */
  flyTo(view: View, vertex: number): void {
    const shown = this.shown?.[view];
    const box = this.places[view].getBoundingClientRect();
    if (!shown || !this.geometry || box.height === 0) return;
    this.aim(box);
    const flight = flightTo(shown, vertex, box.height, this.camera);
    if (flight) this.camera.fly(flight);
  }

  // --- drawing ------------------------------------------------------------------------------------------------------------

  request(): void {
    if (!this.awake) {
      this.stale = true;
      this.hooks.stale();
      return;
    }
    this.frame ||= requestAnimationFrame(() => {
      this.frame = 0;
      this.draw();
    });
  }

  /** A view as a PNG, without what lies over it. @throws Error when it is asleep */
  async photograph(view: View, transparent: boolean): Promise<Blob> {
    const { renderer } = this.screen;
    if (!renderer) throw new Error('what sleeps draws nothing');
    const place = this.places[view];
    const background = transparent ? null : getComputedStyle(place.closest('.card') ?? document.body).backgroundColor;
    return photograph(renderer, () => this.draw(), place, background);
  }

  private resize(): void {
    this.screen.resize();
    // A camera that nobody has touched keeps the mesh in full view.
    if (this.framed) this.fit();
    if (this.awake) this.draw();
    else this.request();
  }

  private fit(): void {
    const box = views
      .map((view) => this.places[view].getBoundingClientRect())
      .find(({ width, height }) => width > 0 && height > 0);
    const shown = this.shown?.a;
    if (!box || !shown || !this.geometry) return;
    const aspect = box.width / box.height;
    if (Math.abs(aspect - this.framedAspect) < 1e-3) return;
    this.framedAspect = aspect;
    const points = Array.from({ length: this.geometry.positions.length / 3 }, (_, vertex) => shown.placeOf(vertex));
    const flat = points.every((point) => Math.abs(point.y) < 1e-9) || points.every((point) => Math.abs(point.z) < 1e-9);
    const upright = points.some((point) => Math.abs(point.y) > 1e-9);
    this.camera.frame(
      points,
      flat ? (upright ? new Vector3(0, 0, 1) : new Vector3(0, 1, 0.02)) : new Vector3(0.12, 0.9, 1),
      aspect,
    );
    this.request();
  }

  private aim({ width, height }: { width: number; height: number }): void {
    const { camera } = this.camera;
    camera.aspect = width / height;
    camera.updateProjectionMatrix();
    camera.updateMatrixWorld();
  }

  private draw(): void {
    const { shown, geometry } = this;
    const { renderer } = this.screen;
    if (!renderer) return;
    this.stale = false;
    renderer.setScissorTest(false);
    renderer.clear();
    if (!shown || !geometry) return;
    const stage = this.screen.stage.clientHeight;
    const ratio = renderer.getPixelRatio();
    renderer.setScissorTest(true);
    for (const view of views) {
      const box = this.boxOf(view);
      const { left } = box;
      if (box.width === 0 || box.height === 0) continue;
      this.aim(box);
      const lengthPerPixel = this.camera.lengthPerPixel(this.camera.centre(), box.height);
      const bottom = stage - box.top - box.height;
      renderer.setViewport(left, bottom, box.width, box.height);
      for (const { shown: content, from, to } of this.contentsOf(view, box.width)) {
        content.fit(box.width, box.height, ratio, lengthPerPixel);
        renderer.setScissor(left + from, bottom, to - from, box.height);
        renderer.render(content.scene, this.camera.camera);
      }
      this.placeLabels(view, box);
    }
    this.ring.place();
    this.retired.dispose();
    this.hooks.afterFrame();
  }

  /** They lie over the canvas: nothing is drawn for them. */
  private placeLabels(view: View, box: Box): void {
    const shown = this.shown?.[view];
    if (!shown || !this.geometry || box.width === 0) return;
    this.aim(box);
    this.labels[view].place(this.camera.camera, shown, box.width, box.height);
  }

  /** What is held on the graphics card, in numbers. */
  get held(): Screen['held'] {
    return this.screen.held;
  }

  /** What a view of that width shows, from which pixel to which. */
  private contentsOf(view: View, width: number): { shown: Content; from: number; to: number }[] {
    const { shown, swipe } = this;
    if (!shown) return [];
    if (view !== 'delta' || swipe === null) return [{ shown: shown[view], from: 0, to: width }];
    const middle = Math.round(swipe * width);
    return [
      { shown: shown.a, from: 0, to: middle },
      { shown: shown.b, from: middle, to: width },
    ].filter(({ from, to }) => from < to);
  }

  private boxOf(view: View): Box {
    return boxWithin(this.places[view], this.screen.stage);
  }

  private clear(): void {
    if (this.shown) this.retired.add(...Object.values(this.shown));
    if (this.triangles) this.retired.add(this.triangles);
    this.shown = null;
    this.triangles = null;
  }
}
