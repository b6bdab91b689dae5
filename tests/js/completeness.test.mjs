// The lists of break-aways and crossings of random loops, against the roots of D + k N at many gains: both ways.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { maths } from './maths.mjs';
import { polynomials, randomPoints, seeded } from './random.mjs';

const { breakAways } = await maths('break_aways');
const { IMAGINARY_AXIS, UNIT_CIRCLE, crossings } = await maths('crossings');
const { factored } = await maths('factored_loop');
const { roots } = await maths('aberth');
const { sharpened } = await maths('sharpened');

const OUTSIDE = new Map([
  [IMAGINARY_AXIS, (x) => x],
  [UNIT_CIRCLE, (x, y) => Math.hypot(x, y) - 1],
]);

function randomLoop(random, most, radius, middle) {
  const n = 1 + Math.floor(random() * most);
  const m = Math.floor(random() * n);
  return {
    poles: randomPoints(random, n, radius, middle),
    zeros: randomPoints(random, m, radius, middle),
    gain: (random() < 0.5 ? -1 : 1) * 10 ** (2 * random() - 1),
  };
}

// Rising gains that avoid the listed ones and their neighborhoods, where counts by rounded roots are not sure.
function gainsAbout(listed) {
  const grid = [];
  for (let e = -6; e <= 6; e += 0.02) grid.push(10 ** e, -(10 ** e));
  for (const k of listed) grid.push(k * (1 - 1e-4), k * (1 + 1e-4));
  return grid
    .filter((g) => listed.every((k) => Math.abs(g - k) > 0.9e-4 * Math.abs(k)))
    .sort((a, b) => a - b);
}

// Counts at all gains, and for each stretch between two of them what the list says about it.
function compare(loop, list, count, change) {
  const { D, N } = polynomials(loop);
  const gains = gainsAbout(list.map(({ gain }) => gain));
  let before = null;
  let last = null;
  for (const k of gains) {
    const c = D.map((v, i) => v + k * N[i]);
    const now = count(sharpened(c, roots(c)));
    if (before !== null && before * k > 0) {
      const told = list
        .filter(({ gain }) => gain > before && gain < k)
        .reduce((sum, entry) => sum + change(entry), 0);
      assert.equal(now - last, told, JSON.stringify({ loop, from: before, to: k, list }));
    }
    [before, last] = [k, now];
  }
}

for (const [name, boundary, radius, middle] of [
  ['imaginary axis', IMAGINARY_AXIS, 3, -0.7],
  ['unit circle', UNIT_CIRCLE, 1.2, 0.1],
]) {
  test(`crossings of the ${name} are those of the roots, and no others`, () => {
    const random = seeded(1964);
    const outside = OUTSIDE.get(boundary);
    let seen = 0;
    for (let i = 0; i < 80; i++) {
      const loop = randomLoop(random, 8, radius, middle);
      const list = crossings(factored(loop), boundary);
      seen += list.length;
      const isEnd = ({ omega }) => omega === 0 || omega === Math.PI;
      compare(
        loop,
        list,
        ({ x, y }) => x.filter((v, j) => outside(v, y[j]) > 0).length,
        (c) => c.direction * (isEnd(c) ? 1 : 2),
      );
    }
    assert.ok(seen > 70);
  });
}

test('real break-aways change the number of real roots by two, and nothing else does', () => {
  const random = seeded(1965);
  let seen = 0;
  for (let i = 0; i < 80; i++) {
    const loop = randomLoop(random, 8, 3, -0.7);
    const list = breakAways(factored(loop)).filter(({ gain }) => gain !== 0);
    seen += list.length;
    const { D, N } = polynomials(loop);
    // Whether two real roots meet or part as the gain rises: the sign of the second derivative tells it.
    const change = ({ gain, x, y }) => {
      if (y !== 0) return 0;
      const real = [-1e-4, 1e-4].map((off) => {
        const c = D.map((v, k) => v + gain * (1 + off) * N[k]);
        const all = roots(c);
        const nearest = all.x
          .map((v, j) => [Math.hypot(v - x, all.y[j]), all.y[j]])
          .sort((a, b) => a[0] - b[0]);
        return nearest.slice(0, 2).filter(([, im]) => im === 0).length;
      });
      assert.equal(Math.abs(real[1] - real[0]), 2, JSON.stringify({ loop, gain, x }));
      return Math.sign(gain) * (real[1] - real[0]);
    };
    compare(loop, list, ({ y }) => y.filter((v) => v === 0).length, change);
  }
  assert.ok(seen > 70);
});

test('at each break-away two roots coincide, up to order 20', () => {
  const random = seeded(1966);
  for (let i = 0; i < 60; i++) {
    const loop = randomLoop(random, 20, 3, -0.7);
    const { D, N } = polynomials(loop);
    for (const { gain, x, y } of breakAways(factored(loop))) {
      const c = D.map((v, k) => v + gain * N[k]);
      const all = sharpened(c, roots(c));
      const [, second] = all.x.map((v, j) => Math.hypot(v - x, all.y[j] - y)).sort((a, b) => a - b);
      assert.ok(second < 1e-2 * Math.hypot(x, y), JSON.stringify({ loop, gain, x, y, second }));
    }
  }
});

test('crossings up to order 20 satisfy their equation and are as many as the phase has turns', () => {
  const random = seeded(1967);
  for (let i = 0; i < 60; i++) {
    const loop = randomLoop(random, 20, 3, -0.7);
    const list = crossings(factored(loop));
    const phases = [];
    const argument = (w) => {
      const angle = ({ x, y }) => x.reduce((sum, v, j) => sum - Math.atan((w - y[j]) / v), 0);
      return angle(loop.zeros) - angle(loop.poles);
    };
    // A dense walk along the axis in steps that no turn escapes.
    for (let w = 1e-7; w < 1e4; w += Math.max(1e-5, 2e-4 * w)) phases.push(Math.floor(argument(w) / Math.PI));
    const turns = phases.slice(1).filter((v, j) => v !== phases[j]).length;
    assert.equal(list.filter(({ omega }) => omega > 1e-7 && omega < 1e4).length, turns, JSON.stringify(loop));
  }
});
