// Branches traced along a gain, up to high orders, and parameters that no slider gives.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { maths } from './maths.mjs';
import { polynomials, randomPoints, seeded } from './random.mjs';

const { roots } = await maths('aberth');
const { breakAways } = await maths('break_aways');
const { factored } = await maths('factored_loop');
const { gainCurve, gainNodes } = await maths('gain_curve');
const { BLIND } = await maths('line_quality');
const { rootLocus } = await maths('locus');
const { margins } = await maths('margins');
const { responses } = await maths('responses');
const { trace } = await maths('tracing');

const VIEW = { left: -5, right: 3, top: 6, scale: 60, tolerance: 0.25 };

function traced(loop, [first, last], view) {
  const coefficients = polynomials(loop);
  const breaks = breakAways(factored(loop)).filter(({ gain }) => gain > 0 && gain < last);
  const nodes = gainNodes(
    [first, last],
    breaks.map(({ gain }) => gain),
  ).filter((gain) => gain <= last);
  return { ...coefficients, points: trace(gainCurve(coefficients, 1, breaks), nodes, loop.poles, view) };
}

test('branches hold all roots at each gain', () => {
  const random = seeded(7);
  for (let i = 0; i < 20; i++) {
    const loop = { poles: randomPoints(random, 8), zeros: randomPoints(random, 4), gain: 1 };
    const { D, N, points } = traced(loop, [1e-3, 1e3], VIEW);
    for (const { t, x, y } of points.filter((_, k) => k % 10 === 9)) {
      const exact = roots(D.map((v, k) => v + t * N[k]));
      const used = new Set();
      for (let j = 0; j < 8; j++) {
        const off = exact.x.map((v, m) => (used.has(m) ? Infinity : Math.hypot(v - x[j], exact.y[m] - y[j])));
        const nearest = off.indexOf(Math.min(...off));
        assert.ok(off[nearest] < 1e-4 * Math.max(1, Math.hypot(x[j], y[j])), `${off[nearest]}`);
        used.add(nearest);
      }
    }
  }
});

test('coarse gains: each branch ends where it ends when traced in small steps', () => {
  const random = seeded(8);
  for (let i = 0; i < 20; i++) {
    const loop = { poles: randomPoints(random, 8), zeros: randomPoints(random, 4), gain: 1 };
    const { D, N } = polynomials(loop);
    const meetings = breakAways(factored(loop)).filter(({ gain }) => gain > 0 && gain < 50);
    const curve = gainCurve({ D, N }, 1, meetings);
    const steps = (first) =>
      gainNodes(
        [first, 50],
        meetings.map(({ gain }) => gain),
      );
    // One step over all gains but for the break-aways, and about eighty of them.
    const coarse = trace(curve, steps(49), loop.poles, BLIND).at(-1);
    const fine = trace(curve, steps(1e-24), loop.poles, BLIND).at(-1);
    for (let j = 0; j < 8; j++) {
      const off = Math.hypot(coarse.x[j] - fine.x[j], coarse.y[j] - fine.y[j]);
      assert.ok(off < 1e-6 * Math.hypot(fine.x[j], fine.y[j]), JSON.stringify({ loop, j, off }));
    }
  }
});

test('a triple pole is left on three branches', () => {
  const loop = { poles: { x: [-1, -1, -1], y: [0, 0, 0] }, zeros: { x: [], y: [] }, gain: 1 };
  const last = traced(loop, [1e-3, 8], VIEW).points.at(-1);
  const found = Array.from(last.x, (x, i) => [x, last.y[i]]).sort((a, b) => a[1] - b[1]);
  const wanted = [
    [0, -Math.sqrt(3)],
    [-3, 0],
    [0, Math.sqrt(3)],
  ];
  for (const [i, [x, y]] of found.entries()) assert.ok(Math.hypot(x - wanted[i][0], y - wanted[i][1]) < 1e-9);
});

test('roots of very different size: the squares of the terms overflow, the branches do not', () => {
  const random = seeded(10);
  for (const far of [3.5e4, 3.5e5, 1e6, 1e7, 1e9]) {
    const near = randomPoints(random, 28);
    const loop = {
      poles: { x: [far, ...near.x], y: [0, ...near.y] },
      zeros: { x: [], y: [] },
      gain: 1,
    };
    const { D, N } = polynomials(loop);
    const curve = gainCurve({ D, N }, 1, []);
    let solved = 0;
    const fill = (t, c) => {
      solved++;
      curve.fill(t, c);
    };
    const counted = { ...curve, fill };
    const nodes = gainNodes([1e-3, 1e30], []);
    const points = trace(counted, nodes, loop.poles, VIEW);
    assert.ok(solved < 20 * nodes.length, `${solved} solutions for ${nodes.length} nodes`);
    for (const { x } of points) {
      assert.ok(Array.from(x).every(Number.isFinite));
      assert.ok(Math.abs(x[0] / far - 1) < 1e-9);
    }
  }
});

test('coefficients of any size: products of a value and its slope overflow, the roots are found', () => {
  const falling = [
    -0.254662, -89439.6, 0.312816, -1.15678e-5, 1.01804e-7, 7.69803e7, 1460.68, -1.95409e-8, 356979,
    -0.0817849, 4.67819e-8, 2780.95, 1268.54, 5.94439e7, -65101, -2.01927e7, 0.000116616, 1.15429, -4.73366e8,
    5.43416e8, -0.0196049, 2.01185e6, -0.0862558, -8.90929e-8, 1.04186e-5, 9.40479e-7, -0.000275635,
    0.000300345, 6.14958e-5, -3.05327e8,
  ];
  const D = Float64Array.from(falling.slice().reverse(), (c) => c / falling[0]);
  const N = new Float64Array(D.length);
  N[0] = -4e-7;
  const last = trace(gainCurve({ D, N }, -1, []), [0, -1e-3, -1e30], roots(D), BLIND).at(-1);
  const exact = roots(D.map((v, k) => v - 1e30 * N[k]));
  for (const [i, x] of exact.x.entries()) {
    const off = Array.from(last.x, (v, k) => Math.hypot(v - x, last.y[k] - exact.y[i]));
    assert.ok(Math.min(...off) < 1e-9 * Math.hypot(x, exact.y[i]), `${x} ${exact.y[i]} in ${last.x}`);
  }
});

test('a trace whose roots are never found ends', () => {
  let solved = 0;
  const random = seeded(11);
  const curve = {
    fill: (_, c) => {
      solved++;
      c.fill(1);
    },
    middle: (a, b) => (a + b) / 2,
    solve: (_, x, y) => {
      for (let i = 0; i < x.length; i++) [x[i], y[i]] = [6 * random() - 3, 6 * random()];
      return 80 * x.length;
    },
  };
  trace(curve, [0, 1, 2], randomPoints(random, 30), VIEW);
  assert.ok(solved > 100 && solved < 400, `${solved}`);
});

test('101 branches of a long delay', () => {
  const a = Math.exp(-0.001);
  const poles = { x: [a, ...new Array(100).fill(0)], y: new Array(101).fill(0) };
  const loop = { poles, zeros: { x: [], y: [] }, gain: 3.5 * (1 - a) };
  const start = performance.now();
  const view = { left: -1.2, right: 1.2, top: 1.2, scale: 200, tolerance: 0.25 };
  const { points } = traced(loop, [0.1, 10], view);
  assert.ok(performance.now() - start < 20000);
  const last = points.at(-1);
  assert.equal(last.x.length, 101);
  assert.ok(Array.from(last.x).every(Number.isFinite));
  const size = Array.from(last.x, (x, i) => Math.hypot(x, last.y[i]));
  assert.ok(Math.max(...size) > 1);
});

const SYSTEM = {
  terms: [
    { factors: [], coefficients: [0, 2, 3, 1] },
    { factors: ['K'], coefficients: [1, 0.5] },
    { factors: ['K', 'phi'], coefficients: [0, 0, 0.1] },
  ],
  shapes: { phi: { at: 'station', values: [1, 0.5, -0.2, -1] } },
  locus_gains: ['K'],
  maps: ['station'],
  parameters: [{ name: 'K' }, { name: 'station' }],
  poles: [
    { re: 0, im: 0, branch: 'a' },
    { re: -1, im: 0, branch: 'b' },
    { re: -2, im: 0, branch: 'c' },
  ],
  actuators: [],
  numerators: { u: { y: [{ factors: [], coefficients: [1] }] } },
  running: { K: { magnitudes: [1e-2, 1e2] }, station: { ends: [0, 3], step: 1 } },
};

test('any finite value of a parameter returns in bounded time, finite or told', () => {
  const values = [0, -1, 5e-324, 1e20, -1e100, 1e154, 1.7e308, -1.7e308];
  for (const K of values) {
    for (const station of [1.5, -1e308, 1e308]) {
      for (const running of ['K', 'station']) {
        const start = performance.now();
        const locus = rootLocus({ ...SYSTEM }, { K, station }, VIEW, { running, off: [], of: 'poles' });
        assert.ok(performance.now() - start < 5000);
        assert.equal(typeof locus.isFinite, 'boolean');
        if (Math.abs(K) <= 1e20) assert.ok(locus.isFinite, `${K} ${station} ${running}`);
      }
      margins({ ...SYSTEM }, { K, station });
      responses(
        { ...SYSTEM },
        { K, station },
        { input: 'u', kind: 'step', amplitude: 1, duration: 1 },
        [0, 1],
      );
    }
  }
});

test('a response by partial fractions: 1/(s (s + 1) (s + 2)) to a step', () => {
  const times = [0, 0.5, 1, 3];
  const { y } = responses(
    { ...SYSTEM },
    { K: 0, station: 0 },
    { input: 'u', kind: 'step', amplitude: 1, duration: 1 },
    times,
  );
  times.forEach((t, i) => {
    const wanted = t / 2 - 3 / 4 + Math.exp(-t) - Math.exp(-2 * t) / 4;
    assert.ok(Math.abs(y[i] - wanted) < 1e-12, `${y[i]} ${wanted}`);
  });
});

test('margins of 1/(s (s + 1) (s + 2))', () => {
  const system = { ...SYSTEM, terms: [SYSTEM.terms[0], { factors: ['K'], coefficients: [1] }] };
  const { gain, phase } = margins(system, { K: 1, station: 0 });
  assert.ok(Math.abs(gain[0].factor - 6) < 1e-12);
  assert.ok(Math.abs(gain[0].omega - Math.SQRT2) < 1e-12);
  assert.ok(Math.abs(phase[0].omega - 0.44574) < 1e-4);
  assert.ok(Math.abs(phase[0].degrees - 53.41) < 0.01);
});
