// Draws the upper half of the s plane on a canvas: what lies below the real axis mirrors it.

const MARGIN = { left: 44, right: 14, top: 8, bottom: 36 };
const LADDER = [1, 1.25, 1.6, 2, 2.5, 3.2, 4, 5, 6.4, 8, 10];
const STEPS = [1, 2, 5, 10];
const DAMPING = [0.8, 0.6, 0.4, 0.2, 0.1];
const FONT = '11px system-ui, sans-serif';

function ladder(value, rungs) {
  const decade = 10 ** Math.floor(Math.log10(value));
  return decade * rungs.find((rung) => rung * decade >= value * (1 - 1e-12));
}

// Below the axis by more than rounding.
const below = (p, i) => p.y[i] < -1e-7 * Math.abs(p.x[i]);

// The part of the plane to show: all given points, its borders on a ladder of round numbers so that they stand still
// while the points move a little; enlarged about the origin by `magnify`.
export function viewOf(points, width, height, magnify) {
  const reach = (values) => 1.08 * values.reduce((most, v) => Math.max(most, v), 0);
  const want = [reach(points.map((p) => -p[0])), reach(points.map((p) => p[0])), reach(points.map((p) => Math.abs(p[1])))];
  const least = 0.4 * Math.max(...want, 1e-6);
  const [l, r, t] = want.map((v) => ladder(Math.max(v, least), LADDER));
  const w = Math.max(width - MARGIN.left - MARGIN.right, 1);
  const h = Math.max(height - MARGIN.top - MARGIN.bottom, 1);
  const scale = Math.min(w / (l + r), h / (1.07 * t));
  const spare = w / scale - l - r;
  const left = -(l + (spare * l) / (l + r)) / magnify;
  const bottom = (-0.07 * t) / magnify;
  const zoom = scale * magnify;
  return {
    left,
    right: left + w / zoom,
    bottom,
    top: bottom + h / zoom,
    scale: zoom,
    tolerance: 0.25,
    width,
    height,
    X: (x) => MARGIN.left + (x - left) * zoom,
    Y: (y) => height - MARGIN.bottom - (y - bottom) * zoom,
  };
}

// One shape for each branch: told apart without color too. Each is a path about the origin.
const MARKS = [
  (g, r) => g.rect(-r, -r, 2 * r, 2 * r),
  (g, r) => g.arc(0, 0, 1.1 * r, 0, 2 * Math.PI),
  (g, r) => polygon(g, [0, -1.3 * r, 1.25 * r, r, -1.25 * r, r]),
  (g, r) => polygon(g, [0, -1.5 * r, 1.5 * r, 0, 0, 1.5 * r, -1.5 * r, 0]),
  (g, r) => polygon(g, [0, 1.3 * r, 1.25 * r, -r, -1.25 * r, -r]),
];
export const SIGNS = ['■', '●', '▲', '◆', '▼'];

function polygon(g, points) {
  for (let k = 0; k < points.length; k += 2) g.lineTo(points[k], points[k + 1]);
  g.closePath();
}

export class Picture {
  constructor(canvas, view, theme) {
    const ratio = globalThis.devicePixelRatio || 1;
    const [w, h] = [Math.round(view.width * ratio), Math.round(view.height * ratio)];
    if (canvas.width !== w || canvas.height !== h) [canvas.width, canvas.height] = [w, h];
    this.view = view;
    this.theme = theme;
    this.g = canvas.getContext('2d');
    this.g.setTransform(ratio, 0, 0, ratio, 0, 0);
    this.g.font = FONT;
    this.g.lineJoin = 'round';
  }

  line(points, color, width) {
    const { g } = this;
    g.beginPath();
    for (const [x, y] of points) g.lineTo(x, y);
    g.strokeStyle = color;
    g.lineWidth = width;
    g.stroke();
  }

  text(words, x, y, color, align = 'center', halo = true) {
    const { g } = this;
    g.textAlign = align;
    g.textBaseline = 'middle';
    if (halo) {
      g.strokeStyle = this.theme.plane;
      g.lineWidth = 3;
      g.strokeText(words, x, y);
    }
    g.fillStyle = color;
    g.fillText(words, x, y);
  }

  // Plane, lines of constant damping and frequency, axes with their numbers; then clips to the plane.
  background() {
    const { g, theme } = this;
    const { left, right, bottom, top, width, height, X, Y } = this.view;
    const [x0, y0, w, h] = [X(left), Y(top), X(right) - X(left), Y(bottom) - Y(top)];
    const step = ladder((right - left) / Math.max(3, w / 70), STEPS);
    const [xs, ys] = [multiples(step, left, right), multiples(step, 0, top)];
    g.clearRect(0, 0, width, height);
    g.fillStyle = theme.plane;
    g.fillRect(x0, y0, w, h);
    g.fillStyle = theme.unstable;
    g.fillRect(X(0), y0, X(right) - X(0), h);

    g.fillStyle = theme.ink;
    for (const x of xs) this.text(short(x, step), X(x), Y(bottom) + 10, theme.muted, 'center', false);
    for (const y of ys) this.text(short(y, step), x0 - 5, Y(y), theme.muted, 'right', false);
    this.text('Re s (1/s)', x0 + w / 2, height - 8, theme.ink, 'center', false);
    g.save();
    g.translate(7, y0 + h / 2);
    g.rotate(-Math.PI / 2);
    this.text('Im s (1/s)', 0, 0, theme.ink, 'center', false);
    g.restore();

    g.save();
    g.beginPath();
    g.rect(x0, y0, w, h);
    g.clip();
    g.beginPath();
    const far = Math.hypot(Math.max(-left, right), top);
    for (let radius = step; radius < far; radius += step) {
      const r = radius * this.view.scale;
      g.moveTo(X(0) + r, Y(0));
      g.arc(X(0), Y(0), r, 0, Math.PI, true);
    }
    for (const zeta of DAMPING) {
      g.moveTo(X(0), Y(0));
      g.lineTo(X(-zeta * far), Y(far * Math.sqrt(1 - zeta * zeta)));
    }
    g.strokeStyle = theme.grid;
    g.lineWidth = 1;
    g.stroke();
    let last = -Infinity;
    for (const zeta of DAMPING) {
      const up = Math.sqrt(1 - zeta * zeta);
      const radius = Math.min((top - 9 / this.view.scale) / up, (16 / this.view.scale + left) / -zeta);
      const x = X(-zeta * radius);
      if (Math.abs(x - last) > 32 || radius * up < 0.9 * top) this.text(`ζ ${zeta}`, x, Y(up * radius), theme.muted);
      last = x;
    }
    this.line([[x0, Y(0)], [x0 + w, Y(0)]], theme.axis, 1);
    this.line([[X(0), y0], [X(0), y0 + h]], theme.axis, 1.5);
  }

  finish() {
    this.g.restore();
  }

  // The traced branches. Where a root above the axis and its mirror image come from different branches, the two
  // colors alternate: such a motion belongs to neither alone.
  branches(points, names, width) {
    const { g, theme } = this;
    const { X, Y } = this.view;
    const over = [];
    names.forEach((name, i) => {
      const { color } = theme.branch(name);
      let run = [];
      let apart = false;
      const end = () => (apart ? over.push([run, color]) : this.line(run, color, width));
      points.forEach((p) => {
        run.push([X(p.x[i]), Y(Math.abs(p.y[i]))]);
        const mixed = below(p, i) && names[mirror(p, i)] !== name;
        if (mixed === apart) return;
        // Leaving the axis the dashes start at the point before, returning to it they end here.
        if (mixed) run.pop();
        end();
        run = run.slice(-1);
        if (mixed) run.push([X(p.x[i]), Y(Math.abs(p.y[i]))]);
        apart = mixed;
      });
      end();
    });
    g.setLineDash([7, 7]);
    for (const [run, color] of over) this.line(run, color, width);
    g.setLineDash([]);
  }

  // Arrow heads in the direction of the run, one in each stretch of `every` pixels.
  arrows(points, names, every) {
    const { g, theme } = this;
    const { X, Y } = this.view;
    names.forEach((name, i) => {
      g.fillStyle = theme.branch(name).color;
      let left = every / 2;
      for (let k = 1; k < points.length; k++) {
        const [a, b] = [points[k - 1], points[k]];
        const [x, y] = [X(b.x[i]), Y(Math.abs(b.y[i]))];
        const [dx, dy] = [x - X(a.x[i]), y - Y(Math.abs(a.y[i]))];
        const length = Math.hypot(dx, dy);
        left -= length;
        if (left > 0 || length === 0 || below(b, i)) continue;
        left = every;
        const [ux, uy] = [(6 * dx) / length, (6 * dy) / length];
        const [mx, my] = [x - dx / 2, y - dy / 2];
        g.beginPath();
        polygon(g, [mx + ux, my + uy, mx - 0.7 * ux + 0.8 * uy, my - 0.7 * uy - 0.8 * ux, mx - 0.7 * ux - 0.8 * uy, my - 0.7 * uy + 0.8 * ux]);
        g.fill();
      }
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
      MARKS[mark](g, 5);
      g.lineWidth = 3;
      g.strokeStyle = theme.plane;
      g.stroke();
      g.fillStyle = color;
      g.fill();
      g.lineWidth = 1;
      g.strokeStyle = theme.ink;
      g.stroke();
      g.restore();
    });
  }

  crosses(open) {
    const { X, Y } = this.view;
    open.branches.forEach((name, i) => {
      const [x, y] = [X(open.x[i]), Y(Math.abs(open.y[i]))];
      for (const [color, width] of [[this.theme.plane, 4], [this.theme.branch(name).color, 2]]) {
        this.line([[x - 5, y - 5], [x + 5, y + 5]], color, width);
        this.line([[x - 5, y + 5], [x + 5, y - 5]], color, width);
      }
    });
  }

  zeros({ x, y }) {
    x.forEach((re, i) => this.ring(re, Math.abs(y[i]), 5, 1.6));
  }

  ring(re, im, radius, width) {
    const { g, theme } = this;
    g.beginPath();
    g.arc(this.view.X(re), this.view.Y(im), radius, 0, 2 * Math.PI);
    g.fillStyle = theme.plane;
    g.fill();
    g.strokeStyle = theme.ink;
    g.lineWidth = width;
    g.stroke();
  }

  dot(re, im, color) {
    const { g } = this;
    g.beginPath();
    g.arc(this.view.X(re), this.view.Y(Math.abs(im)), 2.6, 0, 2 * Math.PI);
    g.fillStyle = color;
    g.fill();
  }

  // A small open diamond on the imaginary axis with the gain beside it.
  crossing({ gain, omega }) {
    const { g, theme } = this;
    const [x, y] = [this.view.X(0), this.view.Y(omega)];
    g.beginPath();
    polygon(g, [x, y - 5, x + 5, y, x, y + 5, x - 5, y]);
    g.fillStyle = theme.plane;
    g.fill();
    g.strokeStyle = theme.ink;
    g.lineWidth = 1.2;
    g.stroke();
    this.text(Number(gain.toPrecision(3)).toString().replace('-', '−'), x + 9, y - 7, theme.ink, 'left');
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

function multiples(step, from, to) {
  const first = Math.ceil(from / step);
  return Array.from({ length: Math.floor(to / step) - first + 1 }, (_, k) => (first + k) * step);
}

function short(value, step) {
  const decimals = Math.max(0, -Math.floor(Math.log10(step)));
  const text = decimals < 3 ? value.toFixed(decimals) : value === 0 ? '0' : Number(value.toPrecision(6)).toExponential();
  return text.replace('-', '−');
}
