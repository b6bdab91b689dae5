// Places on the imaginary axis where N/D is real: by a polynomial whose roots leave no doubt, and by
// intervals.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { maths } from './maths.mjs';
import { randomPoints, seeded } from './random.mjs';

const { roots } = await maths('aberth');
const { certainRealPhases } = await maths('certain_real_phases');
const { searched } = await maths('real_phases');

const counted = ({ x, y }) => Array.from(x, (v, i) => ({ x: v, y: y[i], count: 1 }));
const rising = (values) => values.sort((a, b) => a - b);

test('both ways give the same places', () => {
  const random = seeded(1968);
  let places = 0;
  let certain = 0;
  for (let i = 0; i < 2000; i++) {
    const n = 1 + Math.floor(random() * 11);
    const poles = counted(randomPoints(random, n));
    const zeros = counted(randomPoints(random, Math.floor(random() * n)));
    const free = Math.floor(random() * 3); // poles at the origin
    if (free > 0) poles.push({ x: 0, y: 0, count: free });
    const found = certainRealPhases(poles, zeros);
    if (!found) continue;
    certain++;
    const wanted = rising(searched(poles, zeros));
    assert.equal(found.length, wanted.length, JSON.stringify({ poles, zeros, found, wanted }));
    for (const [k, omega] of rising(found).entries()) {
      places++;
      assert.ok(Math.abs(omega - wanted[k]) < 1e-9 * omega, `${omega} ${wanted[k]}`);
    }
  }
  assert.ok(certain > 1900 && places > 1900, `${certain} ${places}`);
});

test('doubt is told: two places that nearly or quite coincide, and a loop that is real everywhere', () => {
  for (const off of [0, 1e-15, 1e-13]) {
    // The odd part of Π(s + poles) is s (s^2 + 1)^2, but for the difference.
    const { x, y } = roots(Float64Array.of(3, 1, 2, 2 + off, 3, 1));
    assert.equal(certainRealPhases(counted({ x: x.map((v) => -v), y }), []), null);
  }
  assert.equal(certainRealPhases(counted({ x: [-1, 1], y: [0, 0] }), []), null);
});

test('two places near each other are both found', () => {
  const { x, y } = roots(Float64Array.of(3, 1, 2, 2 + 1e-6, 3, 1)); // omega^2 = 1 +- 1e-3
  const poles = counted({ x: x.map((v) => -v), y });
  const squares = rising(certainRealPhases(poles, [])).map((omega) => omega ** 2 - 1);
  assert.equal(squares.length, 2);
  for (const [k, sign] of [-1, 1].entries()) assert.ok(Math.abs(squares[k] - sign * 1e-3) < 2e-6, squares);
});
