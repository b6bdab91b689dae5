// A plane with two axes on a canvas. Ranges are [left, right] and [bottom, top] in the quantities' units.
import { contextOf, multiples, polygon, write } from './canvas.js';

const PAD = { left: 50, right: 12, top: 10, bottom: 36 };

function stepOf(span, count) {
  const rough = span / Math.max(count, 1);
  const decade = 10 ** Math.floor(Math.log10(rough));
  return decade * [1, 2, 5, 10].find((rung) => rung * decade >= rough * (1 - 1e-9));
}

function ticks([from, to], count) {
  const step = stepOf(to - from, count);
  const decimals = Math.max(0, -Math.floor(Math.log10(step) + 1e-9));
  return multiples(step, from, to).map((value) => {
    const text = Math.abs(value) >= 1e4 ? value.toLocaleString('en') : value.toFixed(decimals);
    return [value, (Number(text) === 0 ? '0' : text).replace('-', '−')];
  });
}

export class Plot {
  constructor(canvas, theme, { x, y, xLabel = '', yLabel = '', bare = false }) {
    const [width, height] = [canvas.clientWidth, canvas.clientHeight];
    const pad = bare ? { left: 8, right: 8, top: 8, bottom: 36 } : PAD;
    Object.assign(this, { theme, x, y, xLabel, yLabel, width, height, pad, bare });
    this.sx = (width - pad.left - pad.right) / (x[1] - x[0]);
    this.sy = (height - pad.top - pad.bottom) / (y[1] - y[0]);
    const g = (this.g = contextOf(canvas, width, height));
    g.lineJoin = 'round';
    g.clearRect(0, 0, width, height);
  }

  X(x) {
    return this.pad.left + (x - this.x[0]) * this.sx;
  }

  Y(y) {
    return this.height - this.pad.bottom - (y - this.y[0]) * this.sy;
  }

  // Plane, grid and numbers; then clips to the plane until `finish`.
  axes() {
    const { g, theme, x, y, width, height } = this;
    const [left, right, bottom, top] = [this.X(x[0]), this.X(x[1]), this.Y(y[0]), this.Y(y[1])];
    g.fillStyle = theme.plane;
    g.fillRect(left, top, right - left, bottom - top);
    g.lineWidth = 1;
    g.strokeStyle = theme.grid;
    g.beginPath();
    for (const [value, text] of ticks(x, (right - left) / 70)) {
      g.moveTo(this.X(value), top);
      g.lineTo(this.X(value), bottom);
      this.text(text, this.X(value), bottom + 10, theme.muted, 'center', false);
    }
    for (const [value, text] of this.bare ? [] : ticks(y, (bottom - top) / 45)) {
      g.moveTo(left, this.Y(value));
      g.lineTo(right, this.Y(value));
      this.text(text, left - 5, this.Y(value), theme.muted, 'right', false);
    }
    g.stroke();
    g.strokeStyle = theme.axis;
    g.strokeRect(left, top, right - left, bottom - top);
    this.text(this.xLabel, (left + right) / 2, height - 8, theme.ink, 'center', false);
    g.save();
    g.translate(7, (top + bottom) / 2);
    g.rotate(-Math.PI / 2);
    this.text(this.yLabel, 0, 0, theme.ink, 'center', false);
    g.restore();
    g.save();
    g.beginPath();
    g.rect(left, top, right - left, bottom - top);
    g.clip();
    return this;
  }

  finish() {
    this.g.restore();
  }

  line(points, color, width = 2, dash = []) {
    const { g } = this;
    g.beginPath();
    for (const [x, y] of points) g.lineTo(this.X(x), this.Y(y));
    g.setLineDash(dash);
    g.strokeStyle = color;
    g.lineWidth = width;
    g.stroke();
    g.setLineDash([]);
  }

  // Pixels; a halo keeps words legible over lines.
  text(words, x, y, color, align = 'center', halo = true) {
    write(this.g, words, x, y, color, align, halo && this.theme.plane);
  }

  // From pixel to pixel, with a head at its end.
  arrow(x0, y0, x1, y1, color, width = 2) {
    const { g } = this;
    const size = Math.hypot(x1 - x0, y1 - y0);
    if (size < 1) return;
    const head = Math.min(9, size);
    const [ux, uy] = [(x1 - x0) / size, (y1 - y0) / size];
    g.strokeStyle = g.fillStyle = color;
    g.lineWidth = width;
    g.beginPath();
    g.moveTo(x0, y0);
    g.lineTo(x1 - 0.8 * head * ux, y1 - 0.8 * head * uy);
    g.stroke();
    g.beginPath();
    polygon(g, [
      x1,
      y1,
      x1 - head * ux - 0.45 * head * uy,
      y1 - head * uy + 0.45 * head * ux,
      x1 - head * ux + 0.45 * head * uy,
      y1 - head * uy - 0.45 * head * ux,
    ]);
    g.fill();
  }

  // A point by its sign, told apart without color too: 'x', 'o', 's', 'd', '^', '.'.
  mark(sign, x, y, color, size = 5) {
    const { g, theme } = this;
    const [px, py] = [this.X(x), this.Y(y)];
    if (sign === 'x') {
      for (const [stroke, width] of [
        [theme.plane, 4],
        [color, 2],
      ]) {
        g.strokeStyle = stroke;
        g.lineWidth = width;
        g.beginPath();
        for (const k of [-1, 1]) {
          g.moveTo(px - size, py - k * size);
          g.lineTo(px + size, py + k * size);
        }
        g.stroke();
      }
      return;
    }
    const shapes = {
      s: [-1, -1, 1, -1, 1, 1, -1, 1],
      d: [0, -1.4, 1.4, 0, 0, 1.4, -1.4, 0],
      '^': [0, -1.3, 1.25, 1, -1.25, 1],
    };
    g.beginPath();
    if (shapes[sign])
      polygon(
        g,
        shapes[sign].map((v, k) => (k % 2 ? py : px) + size * v),
      );
    else g.arc(px, py, sign === '.' ? 0.5 * size : size, 0, 2 * Math.PI);
    g.lineWidth = 3;
    g.strokeStyle = theme.plane;
    g.stroke();
    g.fillStyle = color;
    g.fill();
    g.lineWidth = 1;
    g.strokeStyle = theme.ink;
    g.stroke();
  }
}
