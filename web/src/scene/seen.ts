import { Matrix4, type PerspectiveCamera, type Vector3 } from 'three';
import type { Content } from './content.js';
import type { Colours } from './surface.js';

/** Of a view. Lengths on the page are CSS pixels from its upper left corner; points and normals are the model's, 3 coordinates each. */
export interface Seen {
  width: number;
  height: number;
  points: Float32Array;
  /** Of the faces, unit length. */
  normals: Float32Array;
  colours: Colours;
  /** A direction of the model, as the eye sees it. */
  toEye: (direction: Vector3) => Vector3;
  /** A point of the model on the page, how far it is from the eye, and whether it is before it. */
  at: (point: Vector3) => { x: number; y: number; depth: number; before: boolean; eye: Vector3 };
}

/** @param camera with the aspect of the box */
export function seenBy(
  camera: PerspectiveCamera,
  shown: Content,
  { width, height }: { width: number; height: number },
  colours: Colours,
): Seen {
  const { matrixWorldInverse, near } = camera;
  const turned = new Matrix4().multiplyMatrices(matrixWorldInverse, shown.scene.matrix);
  const clip = camera.projectionMatrix.clone();
  return {
    width,
    height,
    points: shown.surface.points,
    normals: shown.surface.faceNormals,
    colours,
    toEye: (direction) => direction.clone().transformDirection(turned),
    at: (point) => {
      const eye = point.clone().applyMatrix4(turned);
      const { x, y } = eye.clone().applyMatrix4(clip);
      return { x: ((x + 1) / 2) * width, y: ((1 - y) / 2) * height, depth: -eye.z, before: -eye.z > near, eye };
    },
  };
}
