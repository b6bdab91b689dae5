// A drawing context that writes SVG: it takes the calls that the pictures make of a canvas.
import { FONT } from './context.js';

/** @import { Graphics } from '../types.d.ts' */

/** @param {number} v */
const round = (v) => Number(v.toFixed(2));
/** @param {unknown} text */
const escaped = (text) =>
  String(text).replaceAll('&', '&amp;').replaceAll('<', '&lt;').replaceAll('"', '&quot;');
/** @type {Record<string, string>} */
const ANCHORS = { left: 'start', center: 'middle', right: 'end' };

/** @implements {Graphics} */
export class SvgContext {
  /** @type {unknown} */
  fillStyle = '#000';
  /** @type {unknown} */
  strokeStyle = '#000';
  lineWidth = 1;
  font = FONT;
  lineJoin = 'miter';
  textAlign = 'left';
  textBaseline = 'middle';
  globalAlpha = 1;
  dash = '';
  clipping = '';
  matrix = [1, 0, 0, 1, 0, 0];
  /** @type {string[]} */
  parts = [];
  /** @type {string[]} */
  clips = [];
  /** @type {string[]} */
  path = [];
  /** @type {object[]} */
  saved = [];

  /** @param {number} width @param {number} height */
  constructor(width, height) {
    this.width = width;
    this.height = height;
  }

  save() {
    const { parts, clips, path, saved, ...state } = this;
    this.saved.push(state);
  }

  restore() {
    Object.assign(this, this.saved.pop());
  }

  clearRect() {}

  /** @param {number} x @param {number} y */
  translate(x, y) {
    const [a, b, c, d, e, f] = this.matrix;
    this.matrix = [a, b, c, d, a * x + c * y + e, b * x + d * y + f];
  }

  /** @param {number} angle */
  rotate(angle) {
    const [a, b, c, d, e, f] = this.matrix;
    const [cos, sin] = [Math.cos(angle), Math.sin(angle)];
    this.matrix = [a * cos + c * sin, b * cos + d * sin, c * cos - a * sin, d * cos - b * sin, e, f];
  }

  /** @param {Iterable<number>} lengths */
  setLineDash(lengths) {
    this.dash = [...lengths].join(' ');
  }

  /** @param {number} x @param {number} y */
  #at(x, y) {
    const [a, b, c, d, e, f] = this.matrix;
    return `${round(a * x + c * y + e)} ${round(b * x + d * y + f)}`;
  }

  beginPath() {
    this.path = [];
  }

  /** @param {number} x @param {number} y */
  moveTo(x, y) {
    this.path.push(`M${this.#at(x, y)}`);
  }

  /** @param {number} x @param {number} y */
  lineTo(x, y) {
    this.path.push(`${this.path.length ? 'L' : 'M'}${this.#at(x, y)}`);
  }

  closePath() {
    this.path.push('Z');
  }

  /** @param {number} x @param {number} y @param {number} w @param {number} h */
  rect(x, y, w, h) {
    const corners = [this.#at(x + w, y), this.#at(x + w, y + h), this.#at(x, y + h)];
    this.path.push(`M${this.#at(x, y)}L${corners.join('L')}Z`);
  }

  /**
   * Lengths stay as they are: nothing here scales.
   * @param {number} x @param {number} y @param {number} r @param {number} from @param {number} to
   */
  arc(x, y, r, from, to, against = false) {
    /** @param {number} angle */
    const point = (angle) => this.#at(x + r * Math.cos(angle), y + r * Math.sin(angle));
    const middle = (from + to) / 2;
    const sweep = against ? 0 : 1;
    const start = this.path.length ? 'L' : 'M';
    /** @param {number} angle */
    const half = (angle) => `A${round(r)} ${round(r)} 0 0 ${sweep} ${point(angle)}`;
    // Two parts, so that a full circle has ends that differ.
    const other = against && to > from ? middle + Math.PI : middle;
    this.path.push(`${start}${point(from)}${half(other)}${half(to)}`);
  }

  /** @param {string} tag @param {Record<string, unknown>} attributes @param {string} [inside] */
  #put(tag, attributes, inside) {
    const opacity = this.globalAlpha === 1 ? '' : this.globalAlpha;
    const all = Object.entries({ ...attributes, 'clip-path': this.clipping, opacity });
    const text = all.map(([name, value]) => (value === '' ? '' : ` ${name}="${escaped(value)}"`)).join('');
    this.parts.push(inside === undefined ? `<${tag}${text}/>` : `<${tag}${text}>${escaped(inside)}</${tag}>`);
  }

  stroke() {
    this.#put('path', {
      d: this.path.join(''),
      fill: 'none',
      stroke: this.strokeStyle,
      'stroke-width': this.lineWidth,
      'stroke-dasharray': this.dash,
      'stroke-linejoin': this.lineJoin,
    });
  }

  fill() {
    this.#put('path', { d: this.path.join(''), fill: this.fillStyle });
  }

  /** @param {number} x @param {number} y @param {number} w @param {number} h */
  fillRect(x, y, w, h) {
    const before = this.path;
    this.path = [];
    this.rect(x, y, w, h);
    this.fill();
    this.path = before;
  }

  /**
   * A picture made of pixels.
   * @param {HTMLCanvasElement} picture @param {number} x @param {number} y @param {number} w
   * @param {number} h
   */
  drawImage(picture, x, y, w, h) {
    const [left, top] = this.#at(x, y).split(' ');
    const place = { x: left, y: top, width: round(w), height: round(h) };
    const style = 'image-rendering: pixelated';
    this.#put('image', { href: picture.toDataURL(), preserveAspectRatio: 'none', style, ...place });
  }

  clip() {
    const id = `clip-${this.clips.length}`;
    this.clips.push(`<clipPath id="${id}"><path d="${this.path.join('')}"/></clipPath>`);
    this.clipping = `url(#${id})`;
  }

  /** @param {string} words @param {number} x @param {number} y @param {Record<string, unknown>} paint */
  #text(words, x, y, paint) {
    const matrix = this.matrix.map((v) => Number(v.toFixed(4))).join(' ');
    const attributes = {
      x: round(x),
      y: round(y),
      'text-anchor': ANCHORS[this.textAlign],
      'dominant-baseline': 'central',
      'font-size': this.font.match(/(\d+(?:\.\d+)?)px/)[1],
      transform: matrix === '1 0 0 1 0 0' ? '' : `matrix(${matrix})`,
    };
    this.#put('text', { ...attributes, ...paint }, words);
  }

  /** @param {string} words @param {number} x @param {number} y */
  fillText(words, x, y) {
    this.#text(words, x, y, { fill: this.fillStyle });
  }

  /** @param {string} words @param {number} x @param {number} y */
  strokeText(words, x, y) {
    const width = { 'stroke-width': this.lineWidth, 'stroke-linejoin': 'round' };
    this.#text(words, x, y, { fill: 'none', stroke: this.strokeStyle, ...width });
  }

  /**
   * The document, on a ground of one color.
   * @param {string} title what it shows, also for a screen reader @param {string} ground
   */
  document(title, ground) {
    const [w, h] = [round(this.width), round(this.height)];
    const size = `width="${w}" height="${h}" viewBox="0 0 ${w} ${h}"`;
    return [
      `<svg xmlns="http://www.w3.org/2000/svg" ${size} font-family="system-ui, sans-serif" role="img">`,
      `<title>${escaped(title)}</title>`,
      `<defs>${this.clips.join('')}</defs>`,
      `<rect width="100%" height="100%" fill="${escaped(ground)}"/>`,
      ...this.parts,
      '</svg>\n',
    ].join('\n');
  }
}
