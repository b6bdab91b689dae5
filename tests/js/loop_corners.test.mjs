// Break-aways and crossings where they are hard to tell. The values were found with 50 digits (mpmath) or by
// hand.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { maths } from './maths.mjs';
import { expanded, polynomials, seeded } from './random.mjs';

const { breakAways } = await maths('break_aways');
const { UNIT_CIRCLE, crossings } = await maths('crossings');
const { factored } = await maths('factored_loop');
const { evaluatePrecisely } = await maths('sharpened');
const { roots } = await maths('aberth');

const at = (...points) => ({ x: points.map((p) => p[0] ?? p), y: points.map((p) => p[1] ?? 0) });
const pair = (x, y) => [
  [x, y],
  [x, -y],
];
const near = (found, wanted, relative = 1e-9) =>
  assert.ok(Math.abs(found - wanted) <= relative * Math.abs(wanted), `got ${found}, wanted ${wanted}`);
const gainsOf = (list) => list.map(({ gain }) => gain).sort((a, b) => a - b);

function both(loop, check) {
  check(factored(loop));
  check(factored(polynomials(loop)));
}

test('a root that zeros and poles have in common stands still and meets nothing', () => {
  both({ poles: at(0, -1, -2), zeros: at(0), gain: 1 }, (loop) => {
    assert.deepEqual(loop.common, [{ x: 0, y: 0, count: 1 }]);
    const [only, ...more] = breakAways(loop);
    assert.deepEqual(more, []);
    near(only.gain, 0.25);
    near(only.x, -1.5);
  });
});

test('common roots anywhere, also of multiplied-out polynomials', () => {
  const shared = [...pair(-0.31, 2.7), -4.2];
  const loop = { poles: at(-1, -3, ...shared), zeros: at(...shared), gain: 2 };
  both(loop, (parts) => {
    assert.equal(parts.common.length, 3);
    const [only, ...more] = breakAways(parts);
    assert.deepEqual(more, []);
    near(only.gain, 0.5, 1e-9);
    assert.equal(crossings(parts).length, 1);
  });
});

test('twenty simple poles: nineteen break-aways, none at gain 0', () => {
  const poles = at(...Array.from({ length: 20 }, (_, i) => -1 - i));
  const exact = breakAways(factored({ poles, zeros: at(), gain: 1 }));
  assert.equal(exact.length, 19);
  near(gainsOf(exact)[0], -8.39e14, 0.05);
  near(gainsOf(exact)[18], 1.17e16, 0.05);
  let integers = [1n];
  for (let r = 1n; r <= 20n; r++) integers = [...integers, 0n].map((v, k) => r * v + (integers[k - 1] ?? 0n));
  const D = Float64Array.from(integers, Number);
  const multiplied = breakAways(factored({ D, N: [1] }));
  assert.equal(multiplied.length, 19);
  // Rounding of the coefficients alone moves the middle ones by a third: they are those of the rounded ones.
  for (const { gain, x } of multiplied) near(gain, -evaluatePrecisely(D, x, 0)[0], 1e-5);
  for (const [i, gain] of gainsOf(exact).entries()) near(gainsOf(multiplied)[i], gain, 0.4);
});

test('poles on the axis leave it at k = 0: no crossing there', () => {
  both({ poles: at(...pair(0, 0.7), ...pair(0, 3.1), -2), zeros: at(-1), gain: 1 }, (loop) => {
    for (const { gain } of crossings(loop)) assert.ok(Math.abs(gain) > 1e-6);
    assert.deepEqual(
      crossings(loop).filter(({ omega }) => Math.abs(omega - 0.7) < 1e-3 || Math.abs(omega - 3.1) < 1e-3),
      [],
    );
  });
});

test('roots that run along the axis do not cross it', () => {
  for (const loop of [
    { poles: at(...pair(0, 1)), zeros: at(), gain: 1 },
    { poles: at(-1, 1), zeros: at(), gain: 1 },
    { poles: at(0, 0, ...pair(0, 3)), zeros: at(), gain: 1 },
  ])
    both(loop, (parts) => assert.deepEqual(crossings(parts), []));
});

test('a near cancellation at the axis', () => {
  // D/N is real at w = 5 + 5e-9 to first order: the pole leaves to the right for positive gains.
  const loop = { poles: at(...pair(0, 5), -1, -2), zeros: at(...pair(1e-8, 5)), gain: 1 };
  both(loop, (parts) => {
    for (const { gain, omega, direction } of crossings(parts)) {
      const c = polynomials(loop);
      const found = [0.999, 1.001].map((f) => {
        const all = roots(c.D.map((v, k) => v + f * gain * c.N[k]));
        const i = all.y.reduce((b, y, j) => (Math.abs(y - omega) < Math.abs(all.y[b] - omega) ? j : b), 0);
        return all.x[i];
      });
      assert.equal(Math.sign((found[1] - found[0]) * gain), direction);
    }
  });
});

test('multiple poles are one pole of a multiplicity', () => {
  for (const c of [expanded(at(-1, -1, -1)), expanded(at(1, 1, 1, 1, 1, 1)), expanded(at(0.9, 0.9, 0.9))]) {
    const { poles } = factored({ D: c, N: [1] });
    assert.equal(poles.length, 1);
    assert.equal(poles[0].count, c.length - 1);
    near(poles[0].x, Math.round(poles[0].x * 10) / 10, 1e-9);
    assert.deepEqual(
      breakAways(factored({ D: c, N: [1] })).map(({ gain, count }) => [gain, count]),
      [[0, c.length - 1]],
    );
  }
});

test('the unit circle as boundary', () => {
  both({ poles: at(1, 0.5), zeros: at(), gain: 1 }, (loop) => {
    const list = crossings(loop, UNIT_CIRCLE);
    const out = list.find(({ gain }) => gain > 0 && gain < 1);
    near(out.gain, 0.5);
    near(out.omega, 0.7227342478134157);
    assert.equal(out.direction, 1);
    // The other one leaves at z = -1, at a negative gain.
    assert.deepEqual(
      list.filter(({ omega }) => omega === Math.PI).map(({ gain }) => gain),
      [-3],
    );
  });
});

test('a long delay', () => {
  const a = Math.exp(-0.001);
  const delayed = { poles: at(a, ...new Array(100).fill(0)), zeros: at(), gain: 3.5 * (1 - a) };
  both(delayed, (loop) => {
    const first = crossings(loop, UNIT_CIRCLE)
      .filter(({ gain }) => gain > 0)
      .sort((p, q) => p.gain - q.gain)[0];
    near(first.gain, 4.649, 1e-3);
    assert.equal(first.direction, 1);
  });
});

test('more than two branches meet in one place', () => {
  // D + N = (s + 2)^3
  const D = Float64Array.of(3, 10, 6, 1);
  const found = breakAways(factored({ D, N: [5, 2] })).filter(({ count }) => count === 3);
  assert.equal(found.length, 1);
  near(found[0].gain, 1);
  near(found[0].x, -2);
});

test('three branches meet in one place, however rounding splits it', () => {
  const random = seeded(3);
  const tenth = (most) => Math.round(most * random() * 10 + 1) / 10;
  for (let i = 0; i < 100; i++) {
    const [a, gain, other] = [tenth(4), tenth(5), tenth(1) + 5];
    const N = Float64Array.of(tenth(10), tenth(1), i % 2, 0, 0);
    const D = expanded(at(-a, -a, -a, -other)).map((v, k) => v - gain * N[k]);
    const found = breakAways(factored({ D, N })).filter(({ x, y }) => Math.hypot(x + a, y) < 1e-3 * a);
    assert.deepEqual(
      found.map(({ count }) => count),
      [3],
      JSON.stringify({ a, gain, other, N: [...N], found }),
    );
    near(found[0].gain, gain, 1e-9);
  }
});

test('complex break-aways have a real gain', () => {
  both({ poles: at(0, -4, ...pair(-2, 4)), zeros: at(), gain: 1 }, (loop) => {
    const list = breakAways(loop);
    assert.deepEqual(list.map(({ gain }) => Math.round(gain * 1e6) / 1e6).sort(), [100, 64].sort());
  });
});

test('degenerate loops', () => {
  for (const [D, N] of [
    [
      [1, 1],
      [0, 0],
    ],
    [
      [0, 0],
      [1, 0],
    ],
    [[1], [1]],
    [
      [NaN, 1],
      [1, 0],
    ],
    [[1e308, 1e308, 1], [1e308]],
    [[1e-308, 1], [1e-308]],
  ]) {
    const loop = factored({ D, N });
    for (const { gain } of [...breakAways(loop), ...crossings(loop)]) assert.ok(Number.isFinite(gain));
  }
});
