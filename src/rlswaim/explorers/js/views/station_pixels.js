// The station map as pictures, one for each fineness: a pixel for each pair of stations, see-through where it
// has not come.
import { STATIONS, STEPS } from '../maths/abscissa.js';
import { element } from '../page/elements.js';

/**
 * @typedef {object} Pixels
 * @property {number} step ft
 * @property {number} side px
 * @property {HTMLCanvasElement} canvas
 * @property {CanvasRenderingContext2D} g
 * @property {ImageData} line
 */
/**
 * @typedef {object} Part what the calculator sends: the pairs of Table 3, a row, or at last the line of zero
 * @property {number[]} [pairs]
 * @property {number} [step]
 * @property {number} [jet]
 * @property {Float64Array} [values]
 * @property {Float32Array} [line] x, y, x, y of each piece
 * @property {number} [stable] pairs
 * @property {number} [neutral] pairs
 */

const FINE = 0.002; // 1/s: the scale is straight below and logarithmic above
export const END = 10;

/** The place of a value on the scale, from 0 to 1. @param {number} value 1/s */
export const shareOf = (value) =>
  Math.max(0, Math.min(1, 0.5 + (0.5 * Math.asinh(value / FINE)) / Math.asinh(END / FINE)));

/** A color as a pixel of an ImageData. @param {string} hex */
const pixelOf = (hex) => Number.parseInt(hex.slice(5) + hex.slice(3, 5) + hex.slice(1, 3), 16) | 0xff000000;

export class StationPixels {
  /** @param {string[]} palette */
  constructor(palette) {
    this.palette = palette.map(pixelOf);
    /** The last fineness that is whole, and the one that comes in. @type {Pixels[]} */
    this.shown = [];
    /** The line of zero of the last fineness that is whole. @type {Part | null} */
    this.whole = null;
    /** Two of each fineness serve in turn. @type {Map<number, Pixels[]>} */
    this.made = new Map();
  }

  get step() {
    return this.shown.at(-1)?.step ?? STEPS[0];
  }

  get complete() {
    return this.whole?.step === 1;
  }

  /** What is shown stays until the first row of a new map comes. */
  restart() {
    this.shown = this.shown.slice(-1);
    this.whole = null;
  }

  /** @param {Part} part */
  take(part) {
    if (part.line) this.whole = part;
    else if (part.values) this.#paint(part);
  }

  /** @param {number} step */
  #make(step) {
    const side = Math.ceil(STATIONS / step);
    const canvas = element('canvas', { width: side, height: side });
    // A canvas in plain memory: rows go in fast.
    const g = canvas.getContext('2d', { willReadFrequently: true });
    return { step, side, canvas, g, line: g.createImageData(side, 1) };
  }

  /** @param {number} step */
  #next(step) {
    const [last, idle] = this.made.get(step) ?? [];
    const pixels = idle ?? this.#make(step);
    pixels.g.clearRect(0, 0, pixels.side, pixels.side);
    this.made.set(step, last ? [pixels, last] : [pixels]);
    return pixels;
  }

  /** @param {Part} part */
  #paint({ step, jet, values }) {
    if (this.shown.at(-1)?.step !== step) this.shown = [...this.shown.slice(-1), this.#next(step)];
    const { side, g, line } = this.shown.at(-1);
    const pixels = new Int32Array(line.data.buffer);
    values.forEach((value, n) => {
      pixels[n] = this.palette[Math.round(shareOf(value) * (this.palette.length - 1))];
    });
    g.putImageData(line, 0, side - 1 - jet / step);
  }
}
