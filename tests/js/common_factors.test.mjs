// Zeros and poles in groups near each other, some of which are common: what is found fits both polynomials.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { maths } from './maths.mjs';
import { polynomials, seeded } from './random.mjs';

const { factored } = await maths('factored_loop');
const { misfit } = await maths('fitted_roots');
const { crossings, IMAGINARY_AXIS } = await maths('crossings');

/** Two zero pairs and three pole pairs out of three that are apart by 1e-2 to 1e-9 of their size. */
function nearLoop(seed) {
  const random = seeded(seed);
  const [x, y] = [-(10 ** (4 * random() - 3)), 10 ** (3 * random() - 1)];
  const step = Math.hypot(x, y) * 10 ** (-9 + 7 * random());
  const places = [
    [x, y],
    [x + step, y],
    [x, y + step],
  ];
  const pairs = (count) => {
    const chosen = Array.from({ length: count }, () => places[Math.floor(3 * random())]);
    return { x: chosen.flatMap(([a]) => [a, a]), y: chosen.flatMap(([, b]) => [b, -b]) };
  };
  const [zeros, poles] = [pairs(2), pairs(3)];
  return { zeros, poles: { x: [...poles.x, -3], y: [...poles.y, 0] }, gain: 1 };
}

const upper = (roots) => roots.filter(({ y }) => y >= 0);

test('300 loops with groups near each other: no coefficient is missed', () => {
  for (let seed = 0; seed < 300; seed++) {
    const { D, N } = polynomials(nearLoop(seed));
    const { poles, zeros, common } = factored({ D, N });
    const n = N.slice(0, 5);
    assert.ok(misfit(D, D.map(Math.abs), upper([...poles, ...common])) < 1e-11, `poles, seed ${seed}`);
    assert.ok(misfit(n, n.map(Math.abs), upper([...zeros, ...common])) < 1e-11, `zeros, seed ${seed}`);
  }
});

test('of three pole pairs beside a double zero one is common, and the crossing is right', () => {
  const at = (...pairs) => ({ x: pairs.flatMap(([x]) => [x, x]), y: pairs.flatMap(([, y]) => [y, -y]) });
  const [a, b] = [
    [-0.002, 28.05],
    [-0.001, 28.05],
  ];
  const loop = { zeros: at(a, a), poles: at(a, b, b), gain: 1 };
  loop.poles.x.push(-3);
  loop.poles.y.push(0);
  const [wanted] = crossings(factored(loop), IMAGINARY_AXIS).filter(({ gain }) => gain > 0);
  const parts = factored(polynomials(loop));
  assert.deepEqual(
    parts.common.map(({ count }) => count),
    [1, 1],
  );
  const [found, ...more] = crossings(parts, IMAGINARY_AXIS).filter(({ gain }) => gain > 0);
  assert.deepEqual(more, []);
  assert.ok(Math.abs(found.gain / wanted.gain - 1) < 1e-9, `got ${found.gain}, wanted ${wanted.gain}`);
});
