import type { WebGLRenderer } from 'three';
import { t } from '../words.js';
import { boxWithin } from './box-within.js';

/** What a renderer draws within an element, twice as fine as on screen, over a colour or nothing. */
export async function photograph(
  renderer: WebGLRenderer,
  draw: () => void,
  place: HTMLElement,
  background: string | null,
): Promise<Blob> {
  const box = boxWithin(place, renderer.domElement.parentElement as HTMLElement);
  if (box.width === 0) throw new Error(t('That view is not on screen.'));
  const usual = renderer.getPixelRatio();
  const ratio = 2 * usual;
  const picture = document.createElement('canvas');
  const [width, height] = [Math.round(ratio * box.width), Math.round(ratio * box.height)];
  Object.assign(picture, { width, height });
  const context = picture.getContext('2d') as CanvasRenderingContext2D;
  if (background) {
    context.fillStyle = background;
    context.fillRect(0, 0, width, height);
  }
  renderer.setPixelRatio(ratio);
  draw();
  const [x, y] = [ratio * box.left, ratio * box.top];
  context.drawImage(renderer.domElement, x, y, width, height, 0, 0, width, height);
  renderer.setPixelRatio(usual);
  draw();
  return new Promise((resolve, reject) => {
    picture.toBlob((blob) => (blob ? resolve(blob) : reject(new Error(t('The picture is too large to be saved.')))));
  });
}
