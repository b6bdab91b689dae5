// Draws the upper half of the s plane: what lies below the real axis mirrors it. On a canvas, or as SVG.
import { multiples, polygon, write } from './canvas.js';
import { number } from '../page/dom.js';
import { ladder } from './camera.js';

const STEPS = [1, 2, 5, 10];
const DAMPING = [0.8, 0.6, 0.4, 0.2, 0.1];

// Below the axis by more than rounding.
const below = (p, i) => p.y[i] < -1e-7 * Math.abs(p.x[i]);

// One shape for each branch: told apart without color too. Each is a path about the origin.
const MARKS = [
  (g, r) => g.rect(-r, -r, 2 * r, 2 * r),
  (g, r) => g.arc(0, 0, 1.1 * r, 0, 2 * Math.PI),
  (g, r) => polygon(g, [0, -1.3 * r, 1.25 * r, r, -1.25 * r, r]),
  (g, r) => polygon(g, [0, -1.5 * r, 1.5 * r, 0, 0, 1.5 * r, -1.5 * r, 0]),
  (g, r) => polygon(g, [0, 1.3 * r, 1.25 * r, -r, -1.25 * r, -r]),
  (g, r) => polygon(g, [-1.3 * r, 0, r, -1.25 * r, r, 1.25 * r]),
  (g, r) => polygon(g, [1.3 * r, 0, -r, -1.25 * r, -r, 1.25 * r]),
  (g, r) =>
    polygon(g, [0, -1.4 * r, 1.35 * r, -0.4 * r, 0.85 * r, 1.2 * r, -0.85 * r, 1.2 * r, -1.35 * r, -0.4 * r]),
];
export const SIGNS = ['■', '●', '▲', '◆', '▼', '◀', '▶', '⬟'];

// Round steps for an axis, about `apart` pixels from each other.
export const stepOf = (range, pixels, apart) => ladder(range / Math.max(2, pixels / apart), STEPS);

export function tick(value, step) {
  const decimals = Math.max(0, -Math.floor(Math.log10(step)));
  const large = Math.abs(value) >= 1e5;
  const text =
    decimals < 3 && !large
      ? value.toFixed(decimals)
      : value === 0
        ? '0'
        : Number(value.toPrecision(6)).toExponential();
  return text.replaceAll('-', '−').replace('e+', 'e');
}

export class Picture {
  constructor(g, view, theme) {
    Object.assign(this, { g, view, theme });
    g.lineJoin = 'round';
  }

  stroke(color, width) {
    const { g } = this;
    g.strokeStyle = color;
    g.lineWidth = width;
    g.stroke();
  }

  text(words, x, y, color, align) {
    write(this.g, words, x, y, color, align, this.theme.plane);
  }

  // Plane, lines of constant damping and frequency, axes with their numbers; then clips to the plane.
  background() {
    const { g, theme, view } = this;
    const { left, right, bottom, top, width, height, X, Y } = view;
    const { x: x0, y: y0, w, h } = view.frame;
    const step = stepOf(right - left, w, 70);
    g.clearRect(0, 0, width, height);
    this.#ground();
    for (const x of multiples(step, left, right)) write(g, tick(x, step), X(x), y0 + h + 10, theme.muted);
    for (const y of multiples(step, 0, top)) write(g, tick(y, step), x0 - 5, Y(y), theme.muted, 'right');
    write(g, 'Re s (1/s)', x0 + w / 2, height - 8, theme.ink);
    g.save();
    g.translate(7, y0 + h / 2);
    g.rotate(-Math.PI / 2);
    write(g, 'Im s (1/s)', 0, 0, theme.ink);
    g.restore();
    this.#clip();
    this.#grid(step);
    this.#dampings();
    this.#axes();
  }

  // The small window about the origin: its own plane, with a border and its enlargement.
  backgroundOfInset(magnify) {
    const { g, theme, view } = this;
    const { x, y, w, h } = view.frame;
    const step = stepOf(view.right - view.left, w, 60);
    this.#ground();
    this.#clip();
    this.#grid(step);
    this.#axes();
    for (const at of multiples(step, view.left, view.right))
      if (at) write(g, tick(at, step), view.X(at), y + h - 8, theme.muted, 'center', theme.plane);
    for (const at of multiples(step, step, view.top))
      write(g, tick(at, step), view.X(0) + 4, view.Y(at), theme.muted, 'left', theme.plane);
    this.text(`×${magnify.toLocaleString('en')} about the origin`, x + 6, y + 10, theme.ink, 'left');
  }

  border() {
    const { g, theme, view } = this;
    g.beginPath();
    g.rect(view.frame.x, view.frame.y, view.frame.w, view.frame.h);
    this.stroke(theme.axis, 1);
  }

  #ground() {
    const { g, theme, view } = this;
    const { x, y, w, h } = view.frame;
    const axis = Math.min(Math.max(view.X(0), x), x + w);
    g.fillStyle = theme.plane;
    g.fillRect(x, y, w, h);
    g.fillStyle = theme.unstable;
    g.fillRect(axis, y, x + w - axis, h);
  }

  #clip() {
    const { g, view } = this;
    g.save();
    g.beginPath();
    g.rect(view.frame.x, view.frame.y, view.frame.w, view.frame.h);
    g.clip();
  }

  #grid(step) {
    const { g, theme, view } = this;
    const { left, right, bottom, top, X, Y } = view;
    const far = Math.hypot(Math.max(-left, right), top);
    const near = Math.hypot(Math.max(left, -right, 0), Math.max(bottom, 0));
    g.beginPath();
    for (const radius of multiples(step, Math.max(near, step), far)) {
      const r = radius * view.scale;
      g.moveTo(X(0) + r, Y(0));
      g.arc(X(0), Y(0), r, 0, Math.PI, true);
    }
    for (const zeta of DAMPING) {
      g.moveTo(X(0), Y(0));
      g.lineTo(X(-zeta * far), Y(far * Math.sqrt(1 - zeta * zeta)));
    }
    this.stroke(theme.grid, 1);
  }

  #dampings() {
    const { left, top, scale, X, Y } = this.view;
    if (left >= 0) return;
    let last = -Infinity;
    for (const zeta of DAMPING) {
      const up = Math.sqrt(1 - zeta * zeta);
      const radius = Math.min((top - 9 / scale) / up, (16 / scale + left) / -zeta);
      const x = X(-zeta * radius);
      if (Math.abs(x - last) > 32 || radius * up < 0.9 * top)
        this.text(`ζ ${zeta}`, x, Y(up * radius), this.theme.muted);
      last = x;
    }
  }

  #axes() {
    const { g, theme, view } = this;
    const { x, y, w, h } = view.frame;
    g.beginPath();
    g.moveTo(x, view.Y(0));
    g.lineTo(x + w, view.Y(0));
    this.stroke(theme.axis, 1);
    g.beginPath();
    g.moveTo(view.X(0), y);
    g.lineTo(view.X(0), y + h);
    this.stroke(theme.axis, 1.5);
  }

  finish() {
    this.g.restore();
  }

  // The traced branches. Where a root above the axis and its mirror image come from different branches, the two
  // colors alternate: such a motion belongs to neither alone.
  branches(points, names, width) {
    const { g, theme } = this;
    const over = [];
    names.forEach((name, i) => {
      const { color } = theme.branch(name);
      let from = 0;
      let apart = false;
      for (let k = 0; k < points.length; k++) {
        const mixed = below(points[k], i) && names[mirror(points[k], i)] !== name;
        if (mixed === apart) continue;
        // Leaving the axis the dashes start at the point before, returning to it they end here.
        const to = mixed ? k - 1 : k;
        if (apart) over.push([from, to, i, color]);
        else this.#run(points, from, to, i, color, width);
        [from, apart] = [Math.max(to, 0), mixed];
      }
      if (apart) over.push([from, points.length - 1, i, color]);
      else this.#run(points, from, points.length - 1, i, color, width);
    });
    if (over.length === 0) return;
    g.setLineDash([7, 7]);
    for (const [from, to, i, color] of over) this.#run(points, from, to, i, color, width);
    g.setLineDash([]);
  }

  #run(points, from, to, i, color, width) {
    if (to <= from) return;
    const { g } = this;
    const { X, Y } = this.view;
    g.beginPath();
    g.moveTo(X(points[from].x[i]), Y(Math.abs(points[from].y[i])));
    for (let k = from + 1; k <= to; k++) g.lineTo(X(points[k].x[i]), Y(Math.abs(points[k].y[i])));
    this.stroke(color, width);
  }

  // Arrow heads in the direction of the run, one in each stretch of `every` pixels.
  arrows(points, names, every) {
    const { g, theme } = this;
    const { X, Y, holds } = this.view;
    names.forEach((name, i) => {
      let left = every / 2;
      g.beginPath();
      for (let k = 1; k < points.length; k++) {
        const [a, b] = [points[k - 1], points[k]];
        const [x, y] = [X(b.x[i]), Y(Math.abs(b.y[i]))];
        const [dx, dy] = [x - X(a.x[i]), y - Y(Math.abs(a.y[i]))];
        const length = Math.sqrt(dx * dx + dy * dy);
        left -= length;
        if (left > 0 || length === 0 || below(b, i)) continue;
        left = every;
        const [mx, my] = [x - dx / 2, y - dy / 2];
        if (!holds(mx, my)) continue;
        const [ux, uy] = [(6 * dx) / length, (6 * dy) / length];
        polygon(g, [
          mx + ux,
          my + uy,
          mx - 0.7 * ux + 0.8 * uy,
          my - 0.7 * uy - 0.8 * ux,
          mx - 0.7 * ux - 0.8 * uy,
          my - 0.7 * uy + 0.8 * ux,
        ]);
      }
      g.fillStyle = theme.branch(name).color;
      g.fill();
    });
  }

  // Closed-loop poles: the branch's own filled shape.
  poles(point, names) {
    const { g, theme } = this;
    const { X, Y } = this.view;
    names.forEach((name, i) => {
      const { color, mark } = theme.branch(name);
      g.save();
      g.translate(X(point.x[i]), Y(Math.abs(point.y[i])));
      g.beginPath();
      MARKS[mark % MARKS.length](g, 5);
      this.stroke(theme.plane, 3);
      g.fillStyle = color;
      g.fill();
      this.stroke(theme.ink, 1);
      g.restore();
    });
  }

  crosses(open) {
    const { g, theme, view } = this;
    open.branches.forEach((name, i) => {
      const [x, y] = [view.X(open.x[i]), view.Y(Math.abs(open.y[i]))];
      g.beginPath();
      g.moveTo(x - 5, y - 5);
      g.lineTo(x + 5, y + 5);
      g.moveTo(x - 5, y + 5);
      g.lineTo(x + 5, y - 5);
      this.stroke(theme.plane, 4);
      this.stroke(theme.branch(name).color, 2);
    });
  }

  zeros({ x, y }) {
    x.forEach((re, i) => this.ring(re, Math.abs(y[i]), 5, 1.6, this.theme.plane));
  }

  ring(re, im, radius, width, inside) {
    const { g, theme } = this;
    g.beginPath();
    g.arc(this.view.X(re), this.view.Y(Math.abs(im)), radius, 0, 2 * Math.PI);
    if (inside) {
      g.fillStyle = inside;
      g.fill();
    }
    this.stroke(theme.ink, width);
  }

  // The roots that the report prints: upright crosses.
  printed(roots) {
    const { g, theme, view } = this;
    for (const { re, im } of roots) {
      const [x, y] = [view.X(re), view.Y(Math.abs(im))];
      g.beginPath();
      g.moveTo(x - 8, y);
      g.lineTo(x + 8, y);
      g.moveTo(x, y - 8);
      g.lineTo(x, y + 8);
      this.stroke(theme.plane, 4);
      this.stroke(theme.ink, 1.6);
    }
  }

  dot(re, im, color) {
    const { g } = this;
    g.beginPath();
    g.arc(this.view.X(re), this.view.Y(Math.abs(im)), 2.6, 0, 2 * Math.PI);
    g.fillStyle = color;
    g.fill();
  }

  // A small open diamond on the imaginary axis with the gain and the frequency beside it.
  crossing({ gain, omega }) {
    const { g, theme } = this;
    const [x, y] = [this.view.X(0), this.view.Y(omega)];
    if (!this.view.holds(x, y)) return;
    g.beginPath();
    polygon(g, [x, y - 5, x + 5, y, x, y + 5, x - 5, y]);
    g.fillStyle = theme.plane;
    g.fill();
    this.stroke(theme.ink, 1.2);
    const at = number(gain, 3);
    this.text(omega ? `${at} · ω ${number(omega, 3)}` : at, x + 9, y - 14, theme.ink, 'left');
  }
}

function mirror(p, i) {
  let best = i;
  let least = Infinity;
  for (let j = 0; j < p.x.length; j++) {
    const d = Math.abs(p.x[j] - p.x[i]) + Math.abs(p.y[j] + p.y[i]);
    if (j !== i && d < least) [best, least] = [j, d];
  }
  return best;
}
