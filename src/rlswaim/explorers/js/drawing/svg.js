// A drawing context that writes SVG: it takes the calls that the pictures make of a canvas.
import { FONT } from './canvas.js';

const round = (v) => Number(v.toFixed(2));
const escaped = (text) =>
  String(text).replaceAll('&', '&amp;').replaceAll('<', '&lt;').replaceAll('"', '&quot;');
const ANCHORS = { left: 'start', center: 'middle', right: 'end' };
const PLAIN = {
  fillStyle: '#000',
  strokeStyle: '#000',
  lineWidth: 1,
  font: FONT,
  lineJoin: 'miter',
  textAlign: 'left',
  textBaseline: 'middle',
  globalAlpha: 1,
};

export class SvgContext {
  constructor(width, height) {
    Object.assign(this, PLAIN, { width, height });
    this.parts = [];
    this.clips = [];
    this.kept = [];
    this.dash = '';
    this.clipping = '';
    this.matrix = [1, 0, 0, 1, 0, 0];
    this.path = [];
  }

  save() {
    const { matrix, dash, clipping } = this;
    this.kept.push({
      matrix,
      dash,
      clipping,
      ...Object.fromEntries(Object.keys(PLAIN).map((name) => [name, this[name]])),
    });
  }

  restore() {
    Object.assign(this, this.kept.pop());
  }

  setTransform() {}
  clearRect() {}

  translate(x, y) {
    const [a, b, c, d, e, f] = this.matrix;
    this.matrix = [a, b, c, d, a * x + c * y + e, b * x + d * y + f];
  }

  rotate(angle) {
    const [a, b, c, d, e, f] = this.matrix;
    const [cos, sin] = [Math.cos(angle), Math.sin(angle)];
    this.matrix = [a * cos + c * sin, b * cos + d * sin, c * cos - a * sin, d * cos - b * sin, e, f];
  }

  setLineDash(lengths) {
    this.dash = lengths.join(' ');
  }

  #at(x, y) {
    const [a, b, c, d, e, f] = this.matrix;
    return `${round(a * x + c * y + e)} ${round(b * x + d * y + f)}`;
  }

  beginPath() {
    this.path = [];
  }

  moveTo(x, y) {
    this.path.push(`M${this.#at(x, y)}`);
  }

  lineTo(x, y) {
    this.path.push(`${this.path.length ? 'L' : 'M'}${this.#at(x, y)}`);
  }

  closePath() {
    this.path.push('Z');
  }

  rect(x, y, w, h) {
    this.path.push(
      `M${this.#at(x, y)}L${this.#at(x + w, y)}L${this.#at(x + w, y + h)}L${this.#at(x, y + h)}Z`,
    );
  }

  // Lengths stay as they are: nothing here scales.
  arc(x, y, r, from, to, against = false) {
    const point = (angle) => this.#at(x + r * Math.cos(angle), y + r * Math.sin(angle));
    const middle = (from + to) / 2;
    const sweep = against ? 0 : 1;
    const start = this.path.length ? 'L' : 'M';
    const half = (angle) => `A${round(r)} ${round(r)} 0 0 ${sweep} ${point(angle)}`;
    // Two parts, so that a full circle has ends that differ.
    const other = against && to > from ? middle + Math.PI : middle;
    this.path.push(`${start}${point(from)}${half(other)}${half(to)}`);
  }

  #put(tag, attributes, inside) {
    const all = {
      ...attributes,
      'clip-path': this.clipping,
      opacity: this.globalAlpha === 1 ? '' : this.globalAlpha,
    };
    const text = Object.entries(all)
      .map(([name, value]) => (value === '' ? '' : ` ${name}="${escaped(value)}"`))
      .join('');
    this.parts.push(inside === undefined ? `<${tag}${text}/>` : `<${tag}${text}>${escaped(inside)}</${tag}>`);
  }

  stroke() {
    const { strokeStyle: stroke, lineWidth, dash, lineJoin } = this;
    this.#put('path', {
      d: this.path.join(''),
      fill: 'none',
      stroke,
      'stroke-width': lineWidth,
      'stroke-dasharray': dash,
      'stroke-linejoin': lineJoin,
    });
  }

  fill() {
    this.#put('path', { d: this.path.join(''), fill: this.fillStyle });
  }

  fillRect(x, y, w, h) {
    const before = this.path;
    this.path = [];
    this.rect(x, y, w, h);
    this.fill();
    this.path = before;
  }

  clip() {
    const id = `clip-${this.clips.length}`;
    this.clips.push(`<clipPath id="${id}"><path d="${this.path.join('')}"/></clipPath>`);
    this.clipping = `url(#${id})`;
  }

  #text(words, x, y, paint) {
    const transform =
      this.matrix.map(round).join() === '1,0,0,1,0,0'
        ? ''
        : `matrix(${this.matrix.map((v) => Number(v.toFixed(4))).join(' ')})`;
    const size = this.font.match(/(\d+(?:\.\d+)?)px/)[1];
    const weight = this.font.startsWith('600') ? '600' : '';
    this.#put(
      'text',
      {
        x: round(x),
        y: round(y),
        'text-anchor': ANCHORS[this.textAlign],
        'dominant-baseline': 'central',
        'font-size': size,
        'font-weight': weight,
        transform,
        ...paint,
      },
      words,
    );
  }

  fillText(words, x, y) {
    this.#text(words, x, y, { fill: this.fillStyle });
  }

  strokeText(words, x, y) {
    this.#text(words, x, y, {
      fill: 'none',
      stroke: this.strokeStyle,
      'stroke-width': this.lineWidth,
      'stroke-linejoin': 'round',
    });
  }

  // The document, on a ground of one color; `title` says what it shows, also to a screen reader.
  document(title, ground) {
    const { width, height } = this;
    return [
      `<svg xmlns="http://www.w3.org/2000/svg" width="${round(width)}" height="${round(height)}" viewBox="0 0 ${round(width)} ${round(height)}" font-family="system-ui, sans-serif" role="img">`,
      `<title>${escaped(title)}</title>`,
      `<defs>${this.clips.join('')}</defs>`,
      `<rect width="100%" height="100%" fill="${escaped(ground)}"/>`,
      ...this.parts,
      '</svg>\n',
    ].join('\n');
  }
}
