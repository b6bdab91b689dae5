// A plane with two axes, drawn as layers of marks one upon the other.
import { write } from './context.js';
import { multiples, stepOf, tick } from './ticks.js';

/** @import { Graphics, Theme, View } from '../types.d.ts' */
/** @typedef {(plane: Plane) => void} Layer */

export class Plane {
  /** @param {Graphics} g @param {View} view @param {Theme} theme */
  constructor(g, view, theme) {
    this.g = g;
    this.view = view;
    this.theme = theme;
    g.lineJoin = 'round';
  }

  /** @param {string} color @param {number} width */
  stroke(color, width) {
    const { g } = this;
    g.strokeStyle = color;
    g.lineWidth = width;
    g.stroke();
  }

  /**
   * Words at a place in px, legible over lines.
   * @param {string} words @param {number} px @param {number} py
   */
  text(words, px, py, color = this.theme.ink, align = 'center') {
    write(this.g, words, px, py, color, align, this.theme.plane);
  }

  clear() {
    this.g.clearRect(0, 0, this.view.width, this.view.height);
    return this;
  }

  #frame() {
    const { x, y, w, h } = this.view.frame;
    this.g.beginPath();
    this.g.rect(x, y, w, h);
  }

  /** Draws layers within the frame. @param {...Layer} layers */
  layers(...layers) {
    this.g.save();
    this.#frame();
    this.g.clip();
    for (const layer of layers) layer(this);
    this.g.restore();
    return this;
  }

  border() {
    this.#frame();
    this.stroke(this.theme.axis, 1);
    return this;
  }

  /** Numbers below and left of the frame. @param {number} [xStep] @param {number} [yStep] 0 for none */
  numbers(xStep, yStep) {
    const { g, view, theme } = this;
    const { x, y, h } = view.frame;
    for (const at of multiples(xStep, view.left, view.right))
      write(g, tick(at, xStep), view.X(at), y + h + 10, theme.muted);
    for (const at of yStep ? multiples(yStep, view.bottom, view.top) : [])
      write(g, tick(at, yStep), x - 5, view.Y(at), theme.muted, 'right');
    return this;
  }

  /** What the axes are. @param {string} below @param {string} beside */
  labels(below, beside) {
    const { g, theme } = this;
    const { x, y, w, h } = this.view.frame;
    write(g, below, x + w / 2, this.view.height - 8, theme.ink);
    g.save();
    g.translate(7, y + h / 2);
    g.rotate(-Math.PI / 2);
    write(g, beside, 0, 0, theme.ink);
    g.restore();
    return this;
  }

  /**
   * A whole picture: ground, grid, numbers, labels, then the layers.
   * @param {string} below @param {string} beside @param {Layer[]} layers
   * @param {boolean} bare no numbers beside it
   */
  chart(below, beside, layers, bare = false) {
    const { left, right, bottom, top, frame } = this.view;
    const x = stepOf(right - left, frame.w, 70);
    const y = bare ? 0 : stepOf(top - bottom, frame.h, 45);
    this.clear().layers(ground, grid(x, y)).border().numbers(x, y).labels(below, beside);
    return this.layers(...layers);
  }
}

/** @type {Layer} */
export function ground({ g, view: { frame }, theme }) {
  g.fillStyle = theme.plane;
  g.fillRect(frame.x, frame.y, frame.w, frame.h);
}

/** Lines at round numbers. @param {number} xStep @param {number} yStep 0 for none @returns {Layer} */
export const grid = (xStep, yStep) => (plane) => {
  const { g, view, theme } = plane;
  const { x, y, w, h } = view.frame;
  g.beginPath();
  for (const at of multiples(xStep, view.left, view.right)) {
    g.moveTo(view.X(at), y);
    g.lineTo(view.X(at), y + h);
  }
  for (const at of yStep ? multiples(yStep, view.bottom, view.top) : []) {
    g.moveTo(x, view.Y(at));
    g.lineTo(x + w, view.Y(at));
  }
  plane.stroke(theme.grid, 1);
};
