// The largest real part of the roots of Section VII's polynomial over sensor and jet stations, from the table of terms
// that Python sends.
import { aberth, roots } from './aberth.js';

export const STATIONS = 421;
export const STEPS = [28, 14, 7, 3, 1];
const AT_JET = ['', 'arm', 'phi_1r', 'phi_2r'];
const AT_SENSOR = ['', 'phi_1', 'phi_2'];

// At fixed gains: the polynomial that each pair of shapes multiplies, and the shapes.
export function planOf({ terms, shapes, pairs }, gains) {
  const parts = AT_SENSOR.map(() => AT_JET.map(() => new Float64Array(10)));
  for (const { factors, coefficients } of terms) {
    const weight = factors.reduce((w, name) => w * (gains[name] ?? 1), 1);
    const index = (names) =>
      Math.max(
        0,
        names.findIndex((name) => name && factors.includes(name)),
      );
    const sum = parts[index(AT_SENSOR)][index(AT_JET)];
    coefficients.forEach((c, k) => (sum[k] += weight * c));
  }
  const values = Object.fromEntries(Object.entries(shapes).map(([name, shape]) => [name, shape.values]));
  return { parts, values, pairs };
}

const ONE = { at: () => 1 };

export function polynomial({ parts, values }, sensor, jet, c) {
  c.fill(0);
  AT_SENSOR.forEach((z, i) => {
    const left = (values[z] ?? ONE).at(sensor);
    AT_JET.forEach((r, j) => {
      const weight = left * (values[r] ?? ONE).at(jet);
      for (let k = 0; k < 10; k++) c[k] += weight * parts[i][j][k];
    });
  });
  return c;
}

// A root at the origin comes out of a sweep as a speck on either side of it.
function largest(x) {
  const value = x.reduce((a, b) => Math.max(a, b), -Infinity);
  return Math.abs(value) < 1e-12 ? 0 : value;
}

export function rootsAt(plan, sensor, jet) {
  return roots(polynomial(plan, sensor, jet, new Float64Array(10)));
}

export const abscissaAt = (plan, sensor, jet) => largest(rootsAt(plan, sensor, jet).x);

// The line of zero through n by n values `step` feet apart, by straight pieces (marching squares): x, y, x, y for each.
function zeroLine(values, n, step) {
  const path = [];
  const share = (a, b) => a / (a - b);
  for (let j = 0; j + 1 < n; j++) {
    for (let s = 0; s + 1 < n; s++) {
      const at = j * n + s;
      const [a, b, c, d] = [values[at], values[at + 1], values[at + n + 1], values[at + n]];
      const [p, q, r, t] = [a > 0, b > 0, c > 0, d > 0];
      if (p === q && q === r && r === t) continue;
      const points = [];
      if (p !== q) points.push(s + share(a, b), j);
      if (q !== r) points.push(s + 1, j + share(b, c));
      if (t !== r) points.push(s + share(d, c), j + 1);
      if (p !== t) points.push(s, j + share(a, d));
      path.push(...points.map((v) => v * step));
    }
  }
  return Float32Array.from(path);
}

// First the pairs asked for, then one row after the other, { step, jet, values }, coarse ones first, and after the last
// of each fineness the line of zero. Each cell's roots start from those of the cell beside it.
export function* rows(plan, steps = STEPS) {
  yield { pairs: plan.pairs.map(({ sensor, jet }) => abscissaAt(plan, sensor, jet)) };
  const c = new Float64Array(10);
  const across = new Float64Array(10 * AT_SENSOR.length);
  for (const step of steps) {
    const side = Math.ceil(STATIONS / step);
    const all = new Float64Array(side * side);
    let [x, y] = [new Float64Array(9), new Float64Array(9)];
    let first = null;
    for (let jet = 0; jet < STATIONS; jet += step) {
      // The row's own polynomials: only the sensor is left to run.
      AT_SENSOR.forEach((_, i) => {
        for (let k = 0; k < 10; k++) {
          let sum = plan.parts[i][0][k];
          for (let j = 1; j < AT_JET.length; j++) sum += plan.values[AT_JET[j]][jet] * plan.parts[i][j][k];
          across[10 * i + k] = sum;
        }
      });
      const values = new Float64Array(side);
      if (first) [x, y] = first.map((points) => points.slice());
      for (let n = 0; n < values.length; n++) {
        const p = plan.values.phi_1[n * step];
        const q = plan.values.phi_2[n * step];
        for (let k = 0; k < 10; k++) c[k] = across[k] + p * across[10 + k] + q * across[20 + k];
        values[n] = cell(c, x, y, first !== null || n > 0);
        if (n === 0) first = [x.slice(), y.slice()];
      }
      all.set(values, (jet / step) * side);
      yield { step, jet, values };
    }
    const count = (test) => all.reduce((sum, value) => sum + Number(test(value)), 0);
    yield {
      step,
      line: zeroLine(all, side, step),
      stable: count((v) => v < 0),
      neutral: count((v) => v === 0),
    };
  }
}

// Aberth keeps real points real, so they start a little off the axis. The sum of the roots tells whether all were found.
function cell(c, x, y, warm) {
  if (warm) {
    for (let i = 0; i < 9; i++) y[i] += (i % 2 ? 1e-7 : -1.3e-7) * (Math.abs(x[i]) + 1e-6);
    aberth(c, 9, x, y, 1e-5);
    let sum = c[8];
    let size = Math.abs(c[8]);
    for (let i = 0; i < 9; i++) {
      sum += x[i];
      size += Math.abs(x[i]);
    }
    if (Math.abs(sum) <= 1e-10 * size) return largest(x);
  }
  const found = roots(c);
  x.set(found.x);
  y.set(found.y);
  return largest(x);
}
