// The station map's calculator, on a table of terms of order 9 with known roots.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { maths } from './maths.mjs';
import { expanded } from './random.mjs';

const { STATIONS, abscissaAt, planOf, rootsAt, rows } = await maths('abscissa');

const feet = (along) => Array.from({ length: STATIONS }, (_, foot) => along(foot / (STATIONS - 1)));
const left = [-1, -2, -3, -4, -5, -6, -7, -8];
const others = [...expanded({ x: left, y: left.map(() => 0) })];
const times = (factor) => [...others.map((v) => factor * v), 0];

// The polynomial (s + K (sensor - jet)) (s + 1) ... (s + 8), with the stations as parts of the length.
const SYSTEM = {
  terms: [
    { factors: [], coefficients: [0, ...others] },
    { factors: ['K', 'phi_1'], coefficients: times(1) },
    { factors: ['K', 'phi_1r'], coefficients: times(-1) },
    { factors: ['K', 'phi_2', 'phi_2r'], coefficients: times(0) },
  ],
  shapes: {
    phi_1: { at: 'sensor', values: feet((part) => part) },
    phi_2: { at: 'sensor', values: feet((part) => 1 - part) },
    arm: { at: 'jet', values: feet(() => 1) },
    phi_1r: { at: 'jet', values: feet((part) => part) },
    phi_2r: { at: 'jet', values: feet((part) => part * part) },
  },
  pairs: [
    { sensor: 210, jet: 0 },
    { sensor: 0, jet: 42 },
  ],
};
const PLAN = planOf(SYSTEM, { K: 0.5 });
const wanted = (sensor, jet) => Math.max(-1, (-0.5 * (sensor - jet)) / 420);
const isNear = (found, value) => assert.ok(Math.abs(found - value) < 1e-8, `got ${found}, wanted ${value}`);

test('one pair of stations', () => {
  assert.equal(rootsAt(PLAN, 210, 0).x.length, 9);
  isNear(abscissaAt(PLAN, 210, 0), -0.25);
  isNear(abscissaAt(PLAN, 0, 42), 0.05);
  assert.equal(abscissaAt(PLAN, 100, 100), 0);
});

test('rows hold the pairs asked for, all pairs of stations, and how many are stable or neutral', () => {
  const [asked, ...found] = rows(PLAN, [28]);
  asked.pairs.forEach((value, i) => {
    isNear(value, [-0.25, 0.05][i]);
  });
  const whole = found.pop();
  assert.equal(found.length, 16);
  for (const { step, jet, values } of found) {
    assert.equal(step, 28);
    values.forEach((value, n) => {
      isNear(value, wanted(28 * n, jet));
    });
  }
  assert.deepEqual([whole.stable, whole.neutral], [120, 16]);
});

test('the line of zero lies between stable and unstable pairs', () => {
  const { line } = [...rows(PLAN, [14])].at(-1);
  assert.ok(line.length >= 4 * 29);
  for (let k = 0; k < line.length; k += 2) assert.ok(Math.abs(line[k] - line[k + 1]) <= 14, `${k}`);
});
