// A canvas's context in CSS pixels, and what every drawing puts on it: words and polygons.
/** @import { Graphics } from '../types.d.ts' */

export const FONT = '11px system-ui, sans-serif';

/** @type {WeakSet<HTMLCanvasElement>} */
const prepared = new WeakSet();

/** @type {((canvas: HTMLCanvasElement) => Graphics) | null} */
let other = null;

/**
 * While draw runs, what is meant for a canvas goes to the context that is returned for it.
 * @param {(canvas: HTMLCanvasElement) => Graphics} contextFor @param {() => void} draw
 */
export function drawnOn(contextFor, draw) {
  other = contextFor;
  try {
    draw();
  } finally {
    other = null;
  }
}

/**
 * A canvas's context, one unit a CSS pixel. Setting the font is slow: it is set with the canvas's size alone.
 * @param {HTMLCanvasElement} canvas @param {number} width @param {number} height
 * @returns {Graphics}
 */
export function contextOf(canvas, width, height) {
  if (other) return other(canvas);
  const ratio = globalThis.devicePixelRatio || 1;
  const [w, h] = [Math.round(width * ratio), Math.round(height * ratio)];
  const g = canvas.getContext('2d');
  if (!prepared.has(canvas) || canvas.width !== w || canvas.height !== h) {
    [canvas.width, canvas.height] = [w, h];
    g.font = FONT;
    prepared.add(canvas);
  }
  g.setTransform(ratio, 0, 0, ratio, 0, 0);
  return g;
}

/**
 * Writes words at a place in px; a halo keeps them legible over lines.
 * @param {Graphics} g @param {string} words @param {number} x @param {number} y @param {string} color
 * @param {string} [halo]
 */
export function write(g, words, x, y, color, align = 'center', halo = undefined) {
  g.textAlign = align;
  g.textBaseline = 'middle';
  if (halo) {
    g.strokeStyle = halo;
    g.lineWidth = 3;
    g.strokeText(words, x, y);
  }
  g.fillStyle = color;
  g.fillText(words, x, y);
}

/** @param {Graphics} g @param {number[]} points x, y, x, y, ... */
export function polygon(g, points) {
  g.moveTo(points[0], points[1]);
  for (let k = 2; k < points.length; k += 2) g.lineTo(points[k], points[k + 1]);
  g.closePath();
}
