// Root loci from the table of terms that Python sends: nothing here knows any physics.
import { derivative, evaluate, multiply, pairing, refine, roots, settle, subtract } from './roots.js';

// The value of each factor of the table: a parameter itself, or a mode's shape at the station that a parameter gives.
export function factorsOf(system, state) {
  const factors = { ...state };
  for (const [factor, shape] of Object.entries(system.shapes)) factors[factor] = along(shape.values, state[shape.at]);
  for (const factor of system.choice.zero[state[system.choice.name]]) factors[factor] = 0;
  return factors;
}

// The table has one value a foot; between two of them the picture takes the straight line.
function along(values, station) {
  const left = Math.min(Math.floor(station), values.length - 2);
  return values[left] + (station - left) * (values[left + 1] - values[left]);
}

// Multiplies out all factors but the free ones: a shorter table of the same kind.
export function collapse(terms, factors, free) {
  const merged = new Map();
  for (const term of terms) {
    const left = term.factors.filter((f) => free.includes(f));
    const weight = term.factors.reduce((w, f) => (free.includes(f) ? w : w * factors[f]), 1);
    const key = left.join();
    if (!merged.has(key)) merged.set(key, { factors: left, coefficients: new Float64Array(term.coefficients.length) });
    const sum = merged.get(key).coefficients;
    term.coefficients.forEach((c, k) => (sum[k] += weight * c));
  }
  return [...merged.values()];
}

function fill(table, factors, c) {
  c.fill(0);
  for (const term of table) {
    let weight = 1;
    for (const f of term.factors) weight *= factors[f];
    for (let k = 0; k < c.length; k++) c[k] += weight * term.coefficients[k];
  }
}

// The loop as D + k N, in the gain k.
export function openLoop(system, state) {
  const gain = system.locus.parameter;
  const table = collapse(system.terms, factorsOf(system, state), [gain]);
  const part = (size) => table.find((t) => t.factors.length === size)?.coefficients;
  const D = part(0);
  return { D, N: part(1) ?? new Float64Array(D.length) };
}

// The open-loop poles, each with the branch that leaves from it: the vehicle's from Python, the actuators' are factors.
export function namedPoles(system, state) {
  const poles = [...system.poles, ...system.actuators.map((a) => ({ re: -state[a.factor], im: 0, branch: a.branch }))];
  return { x: poles.map((p) => p.re), y: poles.map((p) => p.im), branches: poles.map((p) => p.branch) };
}

const trimmed = (c) => c.slice(0, c.findLastIndex((v) => v !== 0) + 1);

// Gains where two branches meet: double roots of D + k N, that is N D' - D N' = 0.
export function breakAways({ D, N }) {
  const P = trimmed(N);
  if (P.length === 0) return [];
  const meeting = roots(subtract(multiply(P, derivative(D)), multiply(D, derivative(P))));
  return meeting.x.flatMap((x, i) => {
    const y = meeting.y[i];
    const [dx, dy] = evaluate(D, x, y);
    const [nx, ny] = evaluate(P, x, y);
    const size = nx * nx + ny * ny;
    const gain = -(dx * nx + dy * ny) / size;
    const real = Math.abs(dy * nx - dx * ny) / size <= 1e-7 * Math.abs(gain);
    return real && y >= 0 ? [{ gain, x, y }] : [];
  });
}

// Gains at which a branch crosses the imaginary axis: D/N is real at s = jw. With even and odd parts in u = w^2 that is
// D_odd N_even = D_even N_odd, or w = 0.
export function crossings({ D, N }) {
  if (N.every((v) => v === 0)) return [];
  const part = (c, first) => Float64Array.from({ length: (c.length - first + 1) >> 1 }, (_, k) => c[2 * k + first] * (-1) ** k);
  const [De, Do, Ne, No] = [part(D, 0), part(D, 1), part(N, 0), part(N, 1)];
  const u = roots(subtract(multiply(Do, Ne), multiply(De, No)));
  const squares = u.x.filter((x, i) => x > 0 && Math.abs(u.y[i]) <= 1e-9 * x);
  return [0, ...squares.map(Math.sqrt)].flatMap((omega) => {
    const [dx, dy] = evaluate(D, 0, omega);
    const [nx, ny] = evaluate(N, 0, omega);
    const gain = -(dx * nx + dy * ny) / (nx * nx + ny * ny);
    if (!Number.isFinite(gain) || gain === 0) return [];
    const [sx, sy] = evaluate(subtract(derivative(D), derivative(N).map((v) => -gain * v)), 0, omega);
    return [{ gain, omega, direction: -Math.sign(nx * sx + ny * sy) }];
  });
}

// Plain loops from here on: they run thousands of times in a frame.
function permuted({ t, x, y }, partner) {
  const n = x.length;
  const moved = { t, x: new Float64Array(n), y: new Float64Array(n) };
  for (let i = 0; i < n; i++) {
    moved.x[i] = x[partner[i]];
    moved.y[i] = y[partner[i]];
  }
  return moved;
}

const real = ({ x, y }, i) => Math.abs(y[i]) <= 1e-6 * Math.abs(x[i]);

const DEEPEST = 14;

// Follows all roots as t runs over the nodes, halving each step until the drawn polyline is within `tolerance` pixels
// of the curve and no root moves so far that it could be taken for another.
// curve: { fill(t, c), middle(a, b) }; start: { x, y } at the first node, in the order of the branches.
// view: { left, right, top, scale (pixels per 1/s), tolerance }. Returns points { t, x, y }.
export function trace(curve, nodes, start, view) {
  const n = start.x.length;
  const c = new Float64Array(n + 1);
  const partner = new Int32Array(n);

  // Aberth keeps real points real, so they start a little off the axis to be able to leave it.
  function solve(t, a, b) {
    const x = new Float64Array(n);
    const y = new Float64Array(n);
    for (let i = 0; i < n; i++) {
      x[i] = (a.x[i] + b.x[i]) / 2;
      y[i] = (a.y[i] + b.y[i]) / 2 + (i % 2 ? 1e-8 : -1.3e-8) * (Math.abs(x[i]) + 1e-9);
    }
    curve.fill(t, c);
    refine(c, n, x, y, 1e-3);
    settle(x, y);
    return { t, x, y };
  }

  // Puts a point's roots in the order of the point before. Two that coincide can't tell which is which: the next
  // point then asks where they came from (kx, ky).
  function order(before, point) {
    if (clear(before, point)) return keep(point, before);
    pairing(before.kx, before.ky, point.x, point.y, partner);
    return keep(permuted(point, partner), before);
  }

  // Each root within half the distance to the next one: no other pairing can be nearer.
  function clear(before, { x, y }) {
    for (let i = 0; i < n; i++) {
      const dx = x[i] - before.x[i];
      const dy = y[i] - before.y[i];
      if (before.gap[i] === Infinity || dx * dx + dy * dy > 0.25 * before.gap[i]) return false;
    }
    return true;
  }

  function keep(point, before) {
    const { x, y } = point;
    const gap = (point.gap = new Float64Array(n));
    const kx = (point.kx = x.slice());
    const ky = (point.ky = y.slice());
    for (let i = 0; i < n; i++) {
      let least = Infinity;
      for (let j = 0; j < n; j++) {
        const dx = x[i] - x[j];
        const dy = y[i] - y[j];
        const d = dx * dx + dy * dy;
        if (d < least && j !== i) least = d;
      }
      gap[i] = least;
      if (least <= 1e-10 * (x[i] * x[i] + y[i] * y[i])) {
        gap[i] = Infinity;
        if (before) [kx[i], ky[i]] = [before.kx[i], before.ky[i]];
      }
    }
    return point;
  }

  function rough(a, m, b, depth) {
    const { left, right, top, scale, tolerance } = view;
    const worst = (tolerance / scale) ** 2;
    const long = (8 / scale) ** 2;
    for (let i = 0; i < n; i++) {
      const bx = b.x[i] - a.x[i];
      const by = b.y[i] - a.y[i];
      const move = bx * bx + by * by;
      // Between two nodes no root leaves the real axis or comes to it, other than at the nodes themselves.
      const meets = a.gap[i] === Infinity || b.gap[i] === Infinity;
      if (depth < 10 && (move > 0.5 * a.gap[i] || (!meets && real(a, i) !== real(b, i)))) return true;
      if (Math.max(a.x[i], m.x[i], b.x[i]) < left || Math.min(a.x[i], m.x[i], b.x[i]) > right) continue;
      if (Math.min(Math.abs(a.y[i]), Math.abs(m.y[i]), Math.abs(b.y[i])) > top) continue;
      const mx = m.x[i] - a.x[i];
      const my = m.y[i] - a.y[i];
      const part = move > 0 ? Math.max(0, Math.min(1, (bx * mx + by * my) / move)) : 0;
      const offX = mx - part * bx;
      const offY = my - part * by;
      if (offX * offX + offY * offY > worst) return true;
      // Far from halfway along: the speed changes as beside a break-away, and the middle says little of the rest.
      if (Math.abs(part - 0.5) > 0.15 && move > long) return true;
    }
    return false;
  }

  const points = [keep({ t: nodes[0], x: Float64Array.from(start.x), y: Float64Array.from(start.y) })];

  function segment(a, b, depth) {
    const m = order(a, solve(curve.middle(a.t, b.t), a, b));
    b = order(m, b);
    if (depth < DEEPEST && rough(a, m, b, depth)) return segment(segment(a, m, depth + 1), b, depth + 1);
    points.push(m, b);
    return b;
  }

  let last = points[0];
  for (const t of nodes.slice(1)) last = segment(last, order(last, solve(t, last, last)), 0);
  return points;
}

// The roots at one value of t inside a traced curve, in the order of its branches.
function pointAt(curve, points, t) {
  const next = points.findIndex((p, i) => i > 0 && (p.t - t) * (points[i - 1].t - t) <= 0);
  const [a, b] = [points[next - 1], points[next]];
  const part = a.t === b.t ? 0 : (t - a.t) / (b.t - a.t);
  const guess = {};
  for (const k of ['x', 'y']) guess[k] = a[k].map((v, i) => v + part * (b[k][i] - v));
  const x = guess.x.slice();
  const y = guess.y.map((v, i) => v + (i % 2 ? 1e-8 : -1.3e-8) * Math.abs(x[i]));
  const c = new Float64Array(x.length + 1);
  curve.fill(t, c);
  refine(c, x.length, x, y);
  settle(x, y);
  const partner = pairing(guess.x, guess.y, x, y, new Int32Array(x.length));
  return permuted({ t, x, y }, partner);
}

// The root locus of the present state: its gain runs from 0 to the end of its range, on the side of its sign.
export function rootLocus(system, state, view) {
  const loop = openLoop(system, state);
  const gain = state[system.locus.parameter];
  const sign = gain < 0 ? -1 : 1;
  const [first, most] = system.locus.magnitudes;
  const last = Math.max(most, Math.abs(gain));
  const within = ({ gain: k }) => k * sign > 0 && k * sign < last;
  const breaks = breakAways(loop).filter(within);
  const steps = Math.round(3 * Math.log10(most / first));
  const regular = Array.from({ length: steps + 1 }, (_, i) => first * (most / first) ** (i / steps));
  const nodes = [...new Set([0, ...regular, ...breaks.map((b) => b.gain * sign), last])].sort((a, b) => a - b);
  const curve = {
    fill(t, c) {
      for (let k = 0; k < c.length; k++) c[k] = loop.D[k] + t * loop.N[k];
    },
    middle: (a, b) => (a === 0 || b === 0 ? (a + b) / 2 : sign * Math.sqrt(a * b)),
  };
  const open = namedPoles(system, state);
  const branches = trace(curve, nodes.map((t) => t * sign), open, view);
  return {
    end: sign * last,
    open,
    zeros: roots(loop.N),
    breaks,
    crossings: crossings(loop).filter(within).map((c) => ({ ...c, direction: sign * c.direction })), // as its size rises
    branches,
    present: pointAt(curve, branches, gain),
  };
}

// The closed-loop poles at the present gains as another parameter, a station, runs over its range: from the present
// one both ways, so that a branch is the one that the locus calls so. Empty where the choice makes no use of it.
export function poleMap(system, state, present, view) {
  const { parameter, ends, step } = system.map;
  const off = system.choice.zero[state[system.choice.name]];
  const free = Object.keys(system.shapes).filter((f) => system.shapes[f].at === parameter && !off.includes(f));
  if (free.length === 0) return [];
  const table = collapse(system.terms, factorsOf(system, state), free);
  const here = state[parameter];
  const shape = {};
  const curve = {
    fill(t, c) {
      for (const f of free) shape[f] = along(system.shapes[f].values, t);
      fill(table, shape, c);
    },
    middle: (a, b) => (a + b) / 2,
  };
  return ends.map((end) => {
    const nodes = [here];
    const sign = Math.sign(end - here);
    for (let t = (sign > 0 ? Math.floor(here / step) + 1 : Math.ceil(here / step) - 1) * step; sign * (end - t) > 0; t += sign * step) nodes.push(t);
    if (sign) nodes.push(end);
    return trace(curve, nodes, present, view);
  });
}

// The closed-loop poles alone, unordered: to choose the window before anything is traced.
export function closedLoopPoles(system, state) {
  const { D, N } = openLoop(system, state);
  const gain = state[system.locus.parameter];
  return roots(D.map((d, k) => d + gain * N[k]));
}
