/** A drawing as a file of its own. */
import { escapeText } from './svg.js';

const gap = 24;
const margin = 16;

/**
 * Several pictures stand side by side.
 * @param style what palette.css and drawing.css say
 */
export function posterSvg(drawing: string, style: string, title: string): string {
  const pictures = drawing.match(/<svg[\s\S]*?<\/svg>/g) ?? [];
  const boxes = pictures.map((picture) => {
    const [, width, height] = picture.match(/viewBox="0 0 ([\d.]+) ([\d.]+)"/) ?? [];
    return { width: Number(width), height: Number(height), inner: picture };
  });
  let x = margin;
  const height = 2 * margin + Math.max(0, ...boxes.map((box) => box.height));
  const placed = boxes.map((box) => {
    const y = margin + (height - 2 * margin - box.height) / 2;
    const place = `<svg x="${x}" y="${y}" width="${box.width}" height="${box.height}"`;
    x += box.width + gap;
    // An image has nothing to hold on to.
    return box.inner
      .replace(/^<svg xmlns="[^"]*"/, place)
      .replaceAll(/ (data-[\w-]+|role|tabindex|aria-[\w-]+)="[^"]*"/g, '');
  });
  const width = x - gap + margin;
  return `<svg xmlns="http://www.w3.org/2000/svg" class="poster" viewBox="0 0 ${width} ${height}" width="${width}" height="${height}"><title>${escapeText(title)}</title><style>${style}</style><rect class="paper" width="100%" height="100%"/>${placed.join('')}</svg>\n`;
}
