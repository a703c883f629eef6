import { PerspectiveCamera, Spherical, Vector3 } from 'three';
import { OrbitControls } from 'three/addons/controls/OrbitControls.js';
import { isLeft } from '../scope.js';
import type { Camera } from '../state.js';
import { type Gestures, leaveScrolling } from './host-scroll.js';

/** Share of the view that a mesh fills at first. */
const fill = 0.94;
const sampleLimit = 20_000;

/** To look at a target from a direction, of unit length, and a distance. */
export interface Flight {
  from: Vector3;
  target: Vector3;
  distance: number;
}

/** One camera for both views, turned by either: what links them. */
export class LinkedCamera {
  readonly camera = new PerspectiveCamera(28, 1, 0.01, 100);
  private readonly target = new Vector3();
  private readonly controls: OrbitControls[] = [];
  private readonly settlers: (() => void)[] = [];
  private home: { position: Vector3; target: Vector3 } | null = null;
  private nudging = 0;
  private resting: Camera | null = null;
  /** Called when somebody has moved it and lets go. */
  onRest: (camera: Camera) => void = () => {};
  /** Called when the wheel was left to the page. */
  onHostWheel: (view: HTMLElement) => void = () => {};

  constructor(
    private readonly changed: () => void,
    /** Somebody has taken the camera: it is theirs from now on. */
    private readonly taken: () => void,
    private readonly gestures: Gestures,
  ) {}

  /** After the gestures have changed. */
  settleGestures(): void {
    for (const settle of this.settlers) settle();
  }

  dispose(): void {
    cancelAnimationFrame(this.nudging);
    for (const controls of this.controls) controls.dispose();
  }

  attach(view: HTMLElement): void {
    const controls = new OrbitControls(this.camera, view);
    controls.target = this.target;
    controls.enableDamping = false;
    controls.zoomToCursor = false;
    controls.addEventListener('change', this.changed);
    controls.addEventListener('start', () => this.take());
    controls.addEventListener('end', () => this.rest());
    this.controls.push(controls);
    this.settlers.push(leaveScrolling(view, this.gestures, () => this.onHostWheel(view)));
    view.addEventListener('keydown', (event) => this.key(event));
  }

  private take(): void {
    cancelAnimationFrame(this.nudging);
    this.taken();
  }

  private key(event: KeyboardEvent): void {
    if (isLeft(event) || event.ctrlKey || event.metaKey || event.altKey) return;
    const turn = Math.PI / 24;
    const moves: Record<string, () => void> = {
      ArrowLeft: () => this.turn(-turn, 0),
      ArrowRight: () => this.turn(turn, 0),
      ArrowUp: () => this.turn(0, -turn),
      ArrowDown: () => this.turn(0, turn),
      '+': () => this.zoom(1 / 1.15),
      '=': () => this.zoom(1 / 1.15),
      '-': () => this.zoom(1.15),
      '0': () => this.goHome(),
    };
    const move = moves[event.key];
    if (!move) return;
    event.preventDefault();
    this.moveBy(move);
  }

  /** Back to where all of the mesh is in view. */
  reset(): void {
    this.moveBy(() => this.goHome());
  }

  private moveBy(move: () => void): void {
    this.take();
    move();
    this.rest();
  }

  private rest(): void {
    this.resting = { position: this.camera.position.toArray(), target: this.target.toArray() };
    this.onRest(this.resting);
  }

  /** Where it rested once; null leaves it where it is. */
  put(camera: Camera | null): void {
    if (!camera || camera === this.resting) return;
    this.take();
    this.resting = camera;
    this.camera.position.set(...camera.position);
    this.target.set(...camera.target);
    this.settle();
  }

  private turn(theta: number, phi: number): void {
    const around = new Spherical().setFromVector3(this.camera.position.clone().sub(this.target));
    around.theta += theta;
    around.phi += phi;
    around.makeSafe();
    this.camera.position.setFromSpherical(around).add(this.target);
    this.settle();
  }

  private zoom(factor: number): void {
    this.camera.position.sub(this.target).multiplyScalar(factor).add(this.target);
    this.settle();
  }

  private settle(): void {
    this.camera.lookAt(this.target);
    this.camera.updateMatrixWorld();
    this.changed();
  }

  private goHome(): void {
    if (!this.home) return;
    this.camera.position.copy(this.home.position);
    this.target.copy(this.home.target);
    this.settle();
  }

  /** Puts the camera where points (in the world) fill a view of this aspect, seen from `from`. */
  frame(points: Iterable<Vector3>, from: Vector3, aspect: number): void {
    const sample = [...points];
    const every = Math.ceil(sample.length / sampleLimit);
    const kept = sample.filter((_, i) => i % every === 0);
    const away = from.clone().normalize();
    const { camera } = this;
    camera.aspect = aspect;
    const tanY = Math.tan((camera.fov * Math.PI) / 360) * fill;
    const tanX = tanY * aspect;
    camera.position.copy(away);
    camera.lookAt(0, 0, 0);
    const right = new Vector3().setFromMatrixColumn(camera.matrix.makeRotationFromQuaternion(camera.quaternion), 0);
    const up = new Vector3().setFromMatrixColumn(camera.matrix, 1);
    // In the frame (right, up, away) each side of the view is a plane; the tightest pair of each gives distance and centre.
    let [xMax, xMin, yMax, yMin, zMax, radius] = [-Infinity, -Infinity, -Infinity, -Infinity, -Infinity, 0];
    for (const point of kept) {
      const x = point.dot(right);
      const y = point.dot(up);
      const z = point.dot(away);
      xMax = Math.max(xMax, x + tanX * z);
      xMin = Math.max(xMin, -x + tanX * z);
      yMax = Math.max(yMax, y + tanY * z);
      yMin = Math.max(yMin, -y + tanY * z);
      zMax = Math.max(zMax, z);
      radius = Math.max(radius, point.length());
    }
    const height = Math.max((xMax + xMin) / (2 * tanX), (yMax + yMin) / (2 * tanY), zMax + 1e-3 * radius);
    const centre = right.multiplyScalar((xMax - xMin) / 2).addScaledVector(up, (yMax - yMin) / 2);
    this.target.copy(centre);
    camera.position.copy(centre).addScaledVector(away, height);
    camera.near = radius / 100;
    camera.far = height + 20 * radius;
    camera.updateProjectionMatrix();
    for (const controls of this.controls) {
      controls.minDistance = radius / 20;
      controls.maxDistance = 15 * radius;
    }
    this.home = { position: camera.position.clone(), target: this.target.clone() };
    this.settle();
  }

  /** A slow turn that comes to rest at home: depth shows itself once. */
  nudge(): void {
    const total = 0.22;
    let turned = 0;
    this.animate(1800, (t) => {
      const angle = (t - 1) * total;
      this.turn(angle - turned, 0);
      turned = angle;
    });
  }

  /** Goes from 0 to 1 within a time, in ms, slower and slower. */
  private animate(span: number, show: (t: number) => void, over = () => {}): void {
    const began = performance.now();
    show(0);
    const frame = (now: number) => {
      const t = Math.min(1, Math.max(0, (now - began) / span));
      show(1 - (1 - t) ** 3);
      if (t < 1) this.nudging = requestAnimationFrame(frame);
      else over();
    };
    this.nudging = requestAnimationFrame(frame);
  }

  /** At once for those who ask for less motion. */
  fly({ from, target, distance }: Flight): void {
    this.take();
    const [nearest = 0] = this.controls.map(({ minDistance }) => minDistance);
    const goal = new Spherical().setFromVector3(from);
    goal.radius = Math.max(distance, nearest);
    goal.makeSafe();
    const away = target.clone();
    const here = this.target.clone();
    const start = new Spherical().setFromVector3(this.camera.position.clone().sub(here));
    // The shorter way round.
    goal.theta -= 2 * Math.PI * Math.round((goal.theta - start.theta) / (2 * Math.PI));
    const between = (one: number, other: number, t: number) => one + t * (other - one);
    const show = (t: number) => {
      this.target.lerpVectors(here, away, t);
      const around = new Spherical(
        start.radius * (goal.radius / start.radius) ** t,
        between(start.phi, goal.phi, t),
        between(start.theta, goal.theta, t),
      );
      this.camera.position.setFromSpherical(around).add(this.target);
      this.settle();
    };
    if (!matchMedia('(prefers-reduced-motion: reduce)').matches) {
      this.animate(500, show, () => this.rest());
      return;
    }
    show(1);
    this.rest();
  }

  centre(): Vector3 {
    return this.target.clone();
  }

  /** From the centre to the eye, unit length. */
  direction(): Vector3 {
    return this.camera.position.clone().sub(this.target).normalize();
  }

  /** Where the eye would be after a flight. */
  placeAfter({ from, target, distance }: Flight): Vector3 {
    return target.clone().addScaledVector(from, distance);
  }

  /** Whether a place would be well inside the view then. */
  wouldShow(place: Vector3, flight: Flight): boolean {
    const then = this.camera.clone();
    then.position.copy(this.placeAfter(flight));
    then.lookAt(flight.target);
    then.updateMatrixWorld();
    const { x, y, z } = place.clone().project(then);
    return Math.max(Math.abs(x), Math.abs(y)) < 0.9 && z < 1;
  }

  /** The length that a pixel covers at a place, in a view of that height. */
  lengthPerPixel(at: Vector3, height: number): number {
    const depth = at.clone().sub(this.camera.position).dot(this.direction().negate());
    return (2 * depth * Math.tan((this.camera.fov * Math.PI) / 360)) / height;
  }

  /** From where a pixel covers a length, in a view of that height. */
  distanceFor(lengthPerPixel: number, height: number): number {
    return (lengthPerPixel * height) / (2 * Math.tan((this.camera.fov * Math.PI) / 360));
  }

  distance(): number {
    return this.camera.position.distanceTo(this.target);
  }
}
