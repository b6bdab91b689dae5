// The motion at a pole, from numerators whose values are known.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { maths } from './maths.mjs';

const { modeShape } = await maths('mode_shape');

const FEET = [0, 1, 2, 3, 4];
const VEHICLE = { U: 10, l_CG: 2, phi_1: [1, 0, -1, 0, 1], phi_2: [1, -1, 0, 1, -1] };
const constants = (values) =>
  Object.fromEntries(Object.entries(values).map(([name, c]) => [name, [{ factors: [], coefficients: c }]]));
const systemOf = (...inputs) => ({
  vehicle: VEHICLE,
  shapes: {},
  numerators: Object.fromEntries(inputs.map((values, i) => [`input ${i}`, constants(values)])),
});
const still = { alpha: [0], theta: [0], q1: [0], q2: [0] };
const near = (found, wanted) => assert.ok(Math.abs(found - wanted) < 1e-12, `got ${found}, wanted ${wanted}`);

test('one bending mode alone has its own shape, down as z is, with a largest size of 1', () => {
  const mode = modeShape(systemOf({ ...still, q1: [0, 3] }), {}, { re: -0.1, im: 2 });
  assert.deepEqual(mode.shares, { translation: 0, theta: 0, q1: 1, q2: 0 });
  for (const foot of FEET) {
    near(mode.shape.re[foot], VEHICLE.phi_1[foot] / VEHICLE.phi_1[0]);
    near(mode.shape.im[foot], 0);
  }
  near(mode.q1[0], -1);
  near(mode.q1[1], 0);
});

test('a turn about the center of gravity: alpha = theta has no translation', () => {
  const mode = modeShape(systemOf({ ...still, alpha: [2], theta: [2] }), {}, { re: -1, im: 0 });
  assert.deepEqual(mode.shares, { translation: 0, theta: 1, q1: 0, q2: 0 });
  near(mode.shape.re[2], 0);
  near(Math.abs(mode.shape.re[0]), 1);
  near(mode.shape.re[0], -mode.shape.re[4]);
});

test("sideways motion is z' = U (alpha - theta) over s, and at s = 0 the only one that counts", () => {
  const system = systemOf({ ...still, alpha: [1], q1: [4] });
  const { shares } = modeShape(system, {}, { re: 0, im: 5 });
  near(shares.translation / shares.q1, 2 / (4 * Math.sqrt(3 / 5)));
  const resting = modeShape(system, {}, { re: 0, im: 0 });
  assert.deepEqual(resting.shares, { translation: 1, theta: 0, q1: 0, q2: 0 });
});

test('phases between the coordinates stay', () => {
  // At s = j: q1 = j, q2 = 1.
  const { shape } = modeShape(systemOf({ ...still, q1: [0, 1], q2: [1] }), {}, { re: 0, im: 1 });
  const size = Math.hypot(VEHICLE.phi_1[0], VEHICLE.phi_2[0]);
  near(Math.hypot(shape.re[1], shape.im[1]), 1 / size);
  near(shape.re[0] * shape.re[1] + shape.im[0] * shape.im[1], -1 / 2);
});

test('of several inputs the one that rounding spoils least is taken', () => {
  // The first one's values at s = -1 are what rounding left of 1 - 1.
  const spoilt = { alpha: [1, 1 + 1e-15], theta: [1, 1], q1: [1, 1 - 1e-15], q2: [1, 1] };
  const mode = modeShape(systemOf(spoilt, { ...still, q2: [5] }), {}, { re: -1, im: 0 });
  assert.deepEqual(mode.shares, { translation: 0, theta: 0, q1: 0, q2: 1 });
});

test('a pole that moves no output has no shape', () => {
  assert.equal(modeShape(systemOf(still), {}, { re: -1, im: 0 }), null);
});
