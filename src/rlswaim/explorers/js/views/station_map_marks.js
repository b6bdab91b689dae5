// The marks of the station map and of its color scale.
import { plus, ring } from '../drawing/marks.js';
import { number, signed } from '../drawing/numbers.js';
import { END, shareOf } from './station_pixels.js';

/** @import { Layer } from '../drawing/plane.js' */
/** @import { Part, Pixels } from './station_pixels.js' */
/** @typedef {{ sensor: number, jet: number }} Pair stations in feet */

const TICKS = [-10, -1, -0.1, 0, 0.1, 1, 10];
const [BLACK, WHITE] = ['#000', '#fff'];

/** @param {Pixels[]} shown @returns {Layer} */
export const pixels =
  (shown) =>
  ({ g, view: { X, Y, sx, sy } }) => {
    const context = /** @type {CanvasRenderingContext2D} */ (g);
    context.imageSmoothingEnabled = false;
    for (const { step, side, canvas } of shown)
      context.drawImage(canvas, X(-0.5), Y(step * side - 0.5), step * side * sx, step * side * sy);
  };

/** The line of zero. @param {Part | null} whole @returns {Layer} */
export const zeroLine = (whole) => (plane) => {
  const {
    g,
    view: { X, Y },
  } = plane;
  const line = whole?.line ?? new Float32Array();
  g.beginPath();
  for (let k = 0; k < line.length; k += 4) {
    g.moveTo(X(line[k]), Y(line[k + 1]));
    g.lineTo(X(line[k + 2]), Y(line[k + 3]));
  }
  plane.stroke(BLACK, 1.5);
};

/** @param {Pair} pair @returns {Layer} */
export const pairOfTable3 = ({ sensor, jet }) => ring(sensor, jet, 4, 1.3, { color: BLACK, edge: WHITE });

/** @param {Pair} pair @returns {Layer} */
export const chosenPair = ({ sensor, jet }) => plus(sensor, jet, 10, BLACK, 2, WHITE);

/** The keyboard's mark. @param {Pair | null} pair @returns {Layer} */
export const cursorMark = (pair) => (plane) => {
  if (!pair) return;
  plane.g.setLineDash([3, 3]);
  ring(pair.sensor, pair.jet, 9, 2, { color: BLACK, edge: WHITE })(plane);
  plane.g.setLineDash([]);
};

/** The colors from left to right with some values below. @param {string[]} palette @returns {Layer} */
export const colorScale =
  (palette) =>
  ({ g, view, theme }) => {
    const { x, w } = view.frame;
    const width = w / palette.length;
    palette.forEach((color, k) => {
      g.fillStyle = color;
      g.fillRect(x + k * width, 0, width + 1, 12);
    });
    g.fillStyle = theme.muted;
    g.textBaseline = 'middle';
    for (const tick of TICKS) {
      g.textAlign = tick === -END ? 'left' : tick === END ? 'right' : 'center';
      g.fillText(signed(tick, 1), x + shareOf(tick) * w, 20);
    }
  };

/**
 * How far the map is.
 * @param {import('./station_pixels.js').StationPixels} map @param {number} count of all pairs
 */
export function progressWords({ complete, step, whole }, count) {
  if (!complete) return `Computing: every ${step} ft …`;
  const { stable, neutral } = whole;
  const at = neutral ? `, ${number(neutral, 6)} neutral, with a root at zero and none right of it` : '';
  return `All ${number(count, 6)} pairs at one foot: ${number(stable, 6)} stable${at}.`;
}
