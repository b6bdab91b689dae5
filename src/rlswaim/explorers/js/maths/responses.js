// Responses in time from partial fractions of the numerators that Python sends: nothing here knows any physics.
import { closedLoopPoles } from './closed_loop.js';
import { evaluate } from './polynomials.js';
import { factorsOf, polynomial } from './terms.js';

// (e^z - 1)/z, right at and near z = 0 too.
function growth(x, y) {
  if (x === 0 && y === 0) return [1, 0];
  const half = Math.sin(y / 2);
  const re = Math.expm1(x) * Math.cos(y) - 2 * half * half;
  const im = Math.exp(x) * Math.sin(y);
  const size = x * x + y * y;
  return [(re * x + im * y) / size, (im * x - re * y) / size];
}

// Poles so close that their residues would cancel are set apart on a small circle about their mean: m poles at distance r
// from it change the response by r^m, and rounding by EPS/r^(m - 1).
function setApart({ x, y }, scale) {
  const n = x.length;
  const free = new Set(Array(n).keys());
  const moved = { x: Float64Array.from(x), y: Float64Array.from(y) };
  const radius = (m, size) => 2.2e-16 ** (1 / (2 * m - 1)) * size;
  for (let i = 0; i < n; i++) {
    if (!free.has(i)) continue;
    const size = Math.max(Math.hypot(x[i], y[i]), scale);
    const close = [...free].filter((j) => Math.hypot(x[i] - x[j], y[i] - y[j]) < radius(2, size));
    close.forEach((j) => free.delete(j));
    const m = close.length;
    if (m === 1) continue;
    const mean = (v) => close.reduce((total, j) => total + v[j], 0) / m;
    const [cx, cy] = [mean(x), Math.abs(mean(y)) < radius(2, size) ? 0 : mean(y)];
    close.forEach((j, k) => {
      const angle = (2 * Math.PI * k) / m;
      moved.x[j] = cx + radius(m, size) * Math.cos(angle);
      moved.y[j] = cy + (m > 2 ? radius(m, size) * Math.sin(angle) : 0); // two stay beside each other, real if they may
    });
  }
  return moved;
}

// What one pole makes of the input at each time, as pairs: the convolution of e^(pt) with it.
const SHAPES = {
  initial: (x, y) => (t) => {
    const size = Math.exp(x * t);
    return [size * Math.cos(y * t), size * Math.sin(y * t)];
  },
  step: (x, y) => (t) => {
    const [re, im] = growth(x * t, y * t);
    return [t * re, t * im];
  },
  // (1 - cos wt)/2 for one period, in parts 1, e^(jwt) and e^(-jwt): a pole at jw is met without a division by 0.
  gust(x, y, duration) {
    const w = (2 * Math.PI) / duration;
    const during = (t) => {
      const [re, im] = growth(x * t, y * t);
      let [sx, sy] = [re / 2, im / 2];
      for (const turn of [w, -w]) {
        const [gx, gy] = growth(x * t, (y - turn) * t);
        const [c, s] = [Math.cos(turn * t), Math.sin(turn * t)];
        sx -= (gx * c - gy * s) / 4;
        sy -= (gx * s + gy * c) / 4;
      }
      return [t * sx, t * sy];
    };
    const [ex, ey] = during(duration);
    return (t) => {
      if (t <= duration) return during(t);
      const size = Math.exp(x * (t - duration));
      const [c, s] = [size * Math.cos(y * (t - duration)), size * Math.sin(y * (t - duration))];
      return [ex * c - ey * s, ex * s + ey * c];
    };
  },
};

// The outputs at the given times (s) after an input: { input (a key of system.numerators), kind ('step', 'gust' or
// 'initial'), amplitude, duration (s, of a gust) }. Returns { output: Float64Array }.
export function responses(system, state, { input, kind, amplitude, duration }, times) {
  const factors = factorsOf(system, state);
  const numerators = Object.entries(system.numerators[input]).map(([output, terms]) => [
    output,
    polynomial(terms, factors),
  ]);
  const { x, y } = setApart(closedLoopPoles(system, state), 1 / times.at(-1));
  const found = Object.fromEntries(numerators.map(([output]) => [output, new Float64Array(times.length)]));
  for (let i = 0; i < x.length; i++) {
    if (y[i] < 0) continue;
    // amplitude / D'(p), twice for a pair: the real part is both its halves
    let [re, im] = [1, 0];
    for (let j = 0; j < x.length; j++)
      if (j !== i)
        [re, im] = [re * (x[i] - x[j]) - im * (y[i] - y[j]), re * (y[i] - y[j]) + im * (x[i] - x[j])];
    const weight = (amplitude * (y[i] > 0 ? 2 : 1)) / (re * re + im * im);
    const values = Array.from(times, SHAPES[kind](x[i], y[i], duration));
    for (const [output, N] of numerators) {
      const [nx, ny] = evaluate(N, x[i], y[i]);
      const [rx, ry] = [weight * (nx * re + ny * im), weight * (ny * re - nx * im)];
      if (rx === 0 && ry === 0) continue;
      const sum = found[output];
      for (let k = 0; k < sum.length; k++) sum[k] += rx * values[k][0] - ry * values[k][1];
    }
  }
  return found;
}
