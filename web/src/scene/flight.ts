import { Vector3 } from 'three';
import { neighbours } from '../neighbours.js';
import type { Flight, LinkedCamera } from './camera.js';
import type { Content } from './content.js';
import { hidden } from './ray.js';

/** In pixels: edges shorter than the least are flown to until they are as long as wanted. */
const clearEdge = { least: 10, wanted: 36 };

/** Where the camera should fly for a vertex and its edges to be in full view; null if they are. @param height of the view, in pixels */
export function flightTo(content: Content, vertex: number, height: number, camera: LinkedCamera): Flight | null {
  const { geometry, surface, scene } = content;
  const normal = new Vector3(...content.normalOf(vertex)).transformDirection(scene.matrix);
  const at = content.placeOf(vertex);
  const around = neighbours(geometry, vertex).map((other) => content.placeOf(other).distanceTo(at));
  const edge = around.reduce((sum, length) => sum + length, 0) / (around.length || 1);
  const near = edge === 0 || edge >= clearEdge.least * camera.lengthPerPixel(at, height);
  const distance = near ? camera.distance() : camera.distanceFor(edge / clearEdge.wanted, height);
  const seen = (flight: Flight) =>
    camera.wouldShow(at, flight) &&
    !hidden(content.toModel(camera.placeAfter(flight)), vertex, surface.points, geometry.triangles);

  const now = camera.direction();
  const stay = { from: now, target: camera.centre(), distance };
  if (near && normal.dot(now) > 0.5 && seen(stay)) return null;
  // Rather from above and from outside than straight on, where something stands before it.
  const up = new Vector3(0, 1, 0);
  const out = at.clone().sub(stay.target).normalize();
  const wishes = [0.3, 0.8, 1.5].flatMap((lean) =>
    [up, out, now].map((to) => normal.clone().addScaledVector(to, lean)),
  );
  const directions = [...wishes, normal, up, out, normal.clone().negate()]
    .filter((from) => from.length() > 1e-3)
    .map((from) => from.normalize());
  // Around what is in the middle now, or else around the vertex, or between both.
  for (const share of near ? [0, 0.5, 1] : [1]) {
    const target = stay.target.clone().lerp(at, share);
    const from = directions.find((each) => seen({ from: each, target, distance }));
    if (from) return { from, target, distance };
  }
  return { from: normal, target: at, distance };
}
