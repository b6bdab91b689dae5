// Roots of polynomials, and which root of one set is which of another.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { maths } from './maths.mjs';
import { expanded, randomPoints, seeded } from './random.mjs';

const { aberth, anchor, roots } = await maths('aberth');
const { matchRoots } = await maths('match_roots');
const { distinctRoots } = await maths('multiple_roots');
const { combine, evaluate, multiply, termsAt, trimmed } = await maths('polynomials');
const { evaluatePrecisely, sharpened } = await maths('sharpened');

const EPS = 2 ** -52;

test('polynomials add and multiply', () => {
  assert.deepEqual([...multiply([1, 2], [3, 4, 5])], [3, 10, 13, 10]);
  assert.deepEqual([...combine([1, 2, 3], [1], -2)], [-1, 2, 3]);
  assert.deepEqual([...trimmed([0, 1, 0])], [0, 1]);
  assert.deepEqual(evaluate([1, 2, 3], 0, 1), [-2, 2]);
  assert.equal(termsAt([1, -2, 3], 2), 17);
});

test('each root satisfies its polynomial to rounding, at orders up to 110', () => {
  const random = seeded(1);
  for (const n of [1, 2, 5, 8, 14, 31, 32, 60, 110]) {
    const c = Float64Array.from({ length: n + 1 }, () => 2 * random() - 1);
    const { x, y } = roots(c);
    assert.equal(x.length, n);
    for (let i = 0; i < n; i++) {
      const left = Math.hypot(...evaluate(c, x[i], y[i]));
      const terms = termsAt(c, Math.hypot(x[i], y[i]));
      assert.ok(left <= 8 * n * EPS * terms, `order ${n}: ${left} beside ${terms}, ${x[i]}, ${y[i]}, ${c}`);
    }
  }
});

test('points near the origin go to roots that are not', () => {
  for (const [c, wanted] of [
    [[0.5, 1], [-0.5]],
    [
      [6, 5, 1],
      [-3, -2],
    ],
  ]) {
    const x = wanted.map((_, i) => 1e-16 * (i + 1));
    const y = wanted.map(() => 0);
    aberth(c, wanted.length, x, y);
    const found = x.toSorted((a, b) => a - b);
    assert.ok(
      found.every((v, i) => Math.abs(v - wanted[i]) < 1e-12),
      String(found),
    );
  }
});

test('roots of very different sizes, zeros at the origin exactly so', () => {
  const wanted = [0, 0, -1e-12, -1e-3, -1, -1e6, -1e12];
  const { x, y } = roots(expanded({ x: wanted, y: wanted.map(() => 0) }));
  const found = [...x].sort((a, b) => Math.abs(a) - Math.abs(b));
  assert.ok(found.every((v, i) => Math.abs(v - wanted[i]) <= 1e-12 * Math.abs(wanted[i])));
  assert.ok(y.every((v) => v === 0));
});

test('a polynomial whose values overflow', () => {
  const { x } = roots([1e300, 0, 0, 0, -1]);
  assert.ok(x.some((v) => Math.abs(v / 1e75 - 1) < 1e-12));
});

test('coefficients that span the whole double range', () => {
  const j = (x, y) => [x, y];
  for (const [c, wanted] of [
    [
      [1e-300, 1, 1e300],
      [j(-0.5e-300, Math.sqrt(0.75) * 1e-300), j(-0.5e-300, -Math.sqrt(0.75) * 1e-300)],
    ],
    [
      [1, 1e150, 1e150, 1],
      [j(-1e-150, 0), j(-1, 0), j(-1e150, 0)],
    ],
    [
      [4, -4e140, 2e280, -2e140, 1],
      [j(1e-140, 1e-140), j(1e-140, -1e-140), j(1e140, 1e140), j(1e140, -1e140)],
    ],
    [
      [5e-324, 1, 1e308],
      [j(-5e-324, 0), j(-1e-308, 0)],
    ],
    [
      [-3e-31, 1.5e49, 0, -2e44, -2e-16],
      [j(2e-80, 0), j(274, 0), j(-274, 0), j(-1e60, 0)],
    ],
    // No number holds these roots, about -1e-600 and -1e600.
    [
      [1e-300, 1e300, 1e-300],
      [j(0, 0), j(-Infinity, 0)],
    ],
  ]) {
    const { x, y } = roots(c);
    assert.equal(x.length, wanted.length);
    for (const [re, im] of wanted) {
      const isNear = (v, i) =>
        (v === re && y[i] === im) || Math.hypot(v - re, y[i] - im) < 1e-3 * Math.hypot(re, im);
      assert.ok(x.some(isNear), `${c}: got ${x} and ${y}, wanted ${re}, ${im}`);
    }
  }
});

test('random coefficients of any size: the roots multiply and add up to what the coefficients say', () => {
  const random = seeded(5);
  const sum = (values) => values.reduce((total, v) => total + v, 0);
  for (let i = 0; i < 300; i++) {
    const c = Array.from(
      { length: 3 + 7 * random() },
      () => (random() < 0.5 ? -1 : 1) * 10 ** (-307 + 614 * random()),
    );
    const { x, y } = roots(c);
    assert.equal(x.length, c.length - 1);
    const sizes = x.map((v, k) => Math.hypot(v, y[k]));
    if (sizes.some((v) => v < 1e-290 || v === Infinity)) continue;
    const product = sum(sizes.map(Math.log));
    assert.ok(Math.abs(product - Math.log(Math.abs(c[0])) + Math.log(Math.abs(c.at(-1)))) < 1e-9, `${c}`);
    assert.ok(Math.abs(sum(y)) <= 1e-9 * Math.max(...sizes), `${c}`);
  }
});

test('what is no number ends in bounded time', () => {
  for (const c of [[NaN, 1, 1], [Infinity, 1], [1, NaN], [], [0], [0, 0, 0], [1e308, 1e308, 1e308]]) {
    const { x, y } = roots(c);
    assert.equal(x.length, y.length);
  }
  const partner = matchRoots([NaN, 1, 2], [0, 0, NaN], [1, NaN, 3], [0, 0, 0], new Int32Array(3));
  assert.deepEqual([...partner].sort(), [0, 1, 2]);
});

test('Aberth keeps points apart where Newton would merge them', () => {
  const c = [1 - 1e-12, 2, 1]; // -1 +- 1e-6
  const [x, y] = [
    [-1.3, -0.7],
    [1e-8, -1.3e-8],
  ];
  aberth(c, 2, x, y);
  assert.ok(Math.abs(Math.abs(x[0] - x[1]) - 2e-6) < 1e-9);
});

test('the root at the origin is the nearest one', () => {
  const [x, y] = [
    [-1, 1e-9, 2],
    [0, 1e-9, 0],
  ];
  anchor([0, -2, 1, 1], x, y);
  assert.deepEqual([x[1], y[1]], [0, 0]);
});

test('ill-conditioned roots are mended where rounding moved them by more than 1e-11', () => {
  let c = [1];
  // Exact in double precision.
  for (let r = 1; r <= 15; r++) c = [...c, 0].map((v, k) => r * v + (c[k - 1] ?? 0));
  const found = sharpened(c, roots(c)).x.sort((a, b) => b - a);
  for (const [i, v] of found.entries()) assert.ok(Math.abs(v + i + 1) < 1e-11 * (i + 1), `${v}`);
  assert.equal(evaluatePrecisely([1 + EPS, -2, 1], 1, 0)[0], EPS);
});

/** How far the coefficients of the roots found are from c, in the unit of the sizes of their terms. */
function misfit(c, found) {
  const each = found.flatMap((root) => new Array(root.count).fill(root));
  const [x, y] = ['x', 'y'].map((axis) => each.map((root) => root[axis]));
  const unit = expanded({ x: each.map((root) => -Math.hypot(root.x, root.y)), y: y.map(() => 0) });
  return Math.max(
    ...expanded({ x, y }).map((v, k) => Math.abs(v - c[k]) / unit[k]),
    Math.abs(x.length + 1 - c.length),
  );
}

test('multiple roots of random polynomials are found with their multiplicity', () => {
  const random = seeded(3);
  for (let i = 0; i < 50; i++) {
    const { x, y } = randomPoints(random, 3, 3, -4);
    const double = [-0.3 - 0.2 * random(), -0.3];
    const points = { x: [...x, double[0], double[0]], y: [...y, 0, 0] };
    const c = expanded(points);
    const found = distinctRoots(c, c);
    const count = found.filter((root) => root.count === 2 && Math.abs(root.x - double[0]) < 1e-9);
    assert.equal(count.length, 1, JSON.stringify(points));
    assert.ok(misfit(c, found) < 1e-14, JSON.stringify(points));
  }
});

test('a double root at the origin stays there', () => {
  const found = distinctRoots(Float64Array.of(0, 0, 2, 3, 1), Float64Array.of(0, 0, 2, 3, 1));
  assert.deepEqual(
    found.filter(({ count }) => count === 2).map(({ x, y }) => [x, y]),
    [[0, 0]],
  );
  assert.equal(found.length, 3);
});

test('pairs that are repeated beside each other are found as such, or singly: all coefficients fit', () => {
  const random = seeded(4);
  for (let i = 0; i < 100; i++) {
    const [a, b, m] = [10 ** (2 * random()), 10 ** (-2 + 2 * random()), 2 + Math.floor(3 * random())];
    const [x, y] = [-a, b * a].map((v) => new Array(m).fill(v));
    const c = expanded({ x: [...x, ...x], y: [...y, ...y.map((v) => -v)] });
    const found = distinctRoots(c, c);
    if (process.env.SHOW) console.log(a.toPrecision(4), b.toPrecision(3), m, found.length, misfit(c, found));
    assert.ok(misfit(c, found) < 1e-11, JSON.stringify([a, b, m, found]));
    if (found.length === 2) assert.ok(Math.abs(found[0].x + a) < 1e-6 * a && found[0].count === m);
  }
});

test('the match has the least total squared distance', () => {
  const random = seeded(2);
  const orders = (n) =>
    n === 0
      ? [[]]
      : orders(n - 1).flatMap((p) => Array.from({ length: n }, (_, i) => p.toSpliced(i, 0, n - 1)));
  const all = orders(6);
  for (let i = 0; i < 60; i++) {
    const [a, b] = [randomPoints(random, 6), randomPoints(random, 6)];
    const cost = (p) => p.reduce((sum, j, k) => sum + (a.x[k] - b.x[j]) ** 2 + (a.y[k] - b.y[j]) ** 2, 0);
    const found = cost([...matchRoots(a.x, a.y, b.x, b.y, new Int32Array(6))]);
    assert.ok(found <= Math.min(...all.map(cost)) * (1 + 1e-12));
  }
});

test('a match of more points than the room was made for', () => {
  const random = seeded(4);
  const a = randomPoints(random, 110);
  const order = Array.from(a.x.keys()).sort((i, j) => ((i * 37) % 110) - ((j * 37) % 110));
  const b = { x: order.map((i) => a.x[i]), y: order.map((i) => a.y[i]) };
  const partner = matchRoots(a.x, a.y, b.x, b.y, new Int32Array(110));
  for (const [i, j] of partner.entries()) assert.deepEqual([b.x[j], b.y[j]], [a.x[i], a.y[i]]);
});
