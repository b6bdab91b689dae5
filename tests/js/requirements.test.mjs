// What is asked of a loop, whether it holds, and its text in an address.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { maths } from './maths.mjs';

const { dampingOf, findings, overshootOf, polesOfZ, regionInZ, regionOf } = await maths('requirements');
const { askedFrom, foundWords, textOfAsked } = await import(
  new URL('../../src/rlswaim/explorers/js/page/requirement_text.js', import.meta.url).href
);

const POLES = [
  { re: -1, im: 2, name: 'mode 1' },
  { re: -1, im: -2, name: 'mode 1' },
  { re: -0.5, im: 0, name: 'drift' },
];
const MARGINS = {
  gain: [
    { dB: -8, omega: 1 },
    { dB: 6.5, omega: 4 },
  ],
  phase: [{ degrees: -25, omega: 3 }],
};
const LOOP = { poles: POLES, margins: MARGINS, isStable: true };

/** @param {string} kind @param {number} bound */
const one = (kind, bound, loop = LOOP) => findings({ [kind]: bound }, loop)[0];

test('damping and decay are the least of all poles, with its name', () => {
  assert.deepEqual([one('zeta', 0.44).holds, one('zeta', 0.45).holds], [true, false]);
  assert.equal(one('zeta', 0.4).name, 'mode 1');
  assert.deepEqual([one('sigma', 0.5).holds, one('sigma', 0.51).holds], [true, false]);
  assert.equal(one('sigma', 0.4).name, 'drift');
});

test('settling to 2 % follows from the slowest pole, overshoot from the least damped', () => {
  assert.ok(Math.abs(one('settling', 9).found - Math.log(50) / 0.5) < 1e-12);
  assert.deepEqual([one('settling', 7.9).holds, one('settling', 7.8).holds], [true, false]);
  const percent = overshootOf(1 / Math.sqrt(5));
  assert.ok(Math.abs(dampingOf(percent) - 1 / Math.sqrt(5)) < 1e-14);
  assert.deepEqual(
    [one('overshoot', percent + 0.1).holds, one('overshoot', percent - 0.1).holds],
    [true, false],
  );
});

test('margins count whichever way they lie, and only of a stable loop', () => {
  assert.deepEqual([one('gain', 6.4).holds, one('gain', 6.6).holds], [true, false]);
  assert.deepEqual([one('phase', 24).holds, one('phase', 26).holds], [true, false]);
  assert.equal(one('gain', 1, { ...LOOP, isStable: false }).holds, false);
  assert.match(foundWords(one('gain', 1, { ...LOOP, isStable: false })), /not stable/);
  assert.equal(one('gain', 60, { ...LOOP, margins: { gain: [], phase: [] } }).holds, true);
});

test('what does not decay meets nothing', () => {
  const growing = { ...LOOP, poles: [{ re: 0.1, im: 1, name: 'mode 1' }], isStable: false };
  for (const [kind, bound] of Object.entries({ zeta: 0.001, sigma: 1e-4, settling: 1e4, overshoot: 99 }))
    assert.equal(one(kind, bound, growing).holds, false, kind);
});

test('the region is that of the hardest bounds', () => {
  const { sigma, zeta } = regionOf({ zeta: 0.1, sigma: 0.2, settling: 4, overshoot: 20 });
  assert.equal(sigma, Math.log(50) / 4);
  assert.equal(zeta, dampingOf(20));
  assert.deepEqual(regionOf({}), { sigma: 0, zeta: 0 });
});

test('poles of z are judged as those of s, and by their size', () => {
  const inS = [
    { re: -1, im: 2, name: 'pair' },
    { re: -1, im: -2, name: 'pair' },
    { re: -3, im: 0, name: 'real' },
  ];
  const T = 0.2;
  const inZ = inS.map(({ re, im, name }) => {
    const size = Math.exp(re * T);
    return { re: size * Math.cos(im * T), im: size * Math.sin(im * T), name };
  });
  const loop = { poles: polesOfZ(inZ, T), margins: null, isStable: true };
  for (const kind of ['zeta', 'settling', 'overshoot']) {
    const [ours, wanted] = [one(kind, 0.4, loop), one(kind, 0.4, { ...loop, poles: inS })];
    assert.ok(Math.abs(ours.found - wanted.found) < 1e-12 * Math.abs(wanted.found), kind);
  }
  const size = Math.exp(-T);
  assert.deepEqual(
    [one('radius', size + 1e-9, loop).holds, one('radius', size - 1e-9, loop).holds],
    [true, false],
  );
});

test('roots of z that s has not: at the origin, on the negative axis', () => {
  const loop = (/** @type {number} */ re) => ({
    poles: polesOfZ([{ re, im: 0, name: '' }], 1),
    margins: null,
    isStable: true,
  });
  assert.equal(one('zeta', 0.999, loop(0)).holds, true);
  assert.equal(one('settling', 0.001, loop(0)).found, 0);
  const turning = -Math.log(0.5) / Math.hypot(Math.log(0.5), Math.PI);
  assert.ok(Math.abs(one('zeta', 0.1, loop(-0.5)).found - turning) < 1e-15);
  assert.equal(one('zeta', 0.001, loop(-1.5)).holds, false);
});

test('the region in z is within a circle', () => {
  assert.deepEqual(regionInZ({}, 0.1), { radius: 1, zeta: 0 });
  assert.equal(regionInZ({ radius: 0.9, settling: 2 }, 0.1).radius, Math.exp((-Math.log(50) / 2) * 0.1));
  assert.equal(regionInZ({ radius: 0.5, settling: 2, zeta: 0.3 }, 0.1).radius, 0.5);
});

test('what is asked in z alone or in s alone', () => {
  assert.equal(askedFrom('radius_0.9'), undefined);
  assert.deepEqual(askedFrom('radius_0.9~zeta_0.1', true), { radius: 0.9, zeta: 0.1 });
  assert.equal(askedFrom('sigma_1', true), undefined);
});

test('the text gives it back, and nonsense is none', () => {
  const asked = { zeta: 0.1, settling: 20, phase: 30 };
  assert.equal(textOfAsked(asked), 'zeta_0.1~settling_20~phase_30');
  assert.deepEqual(askedFrom(textOfAsked(asked)), asked);
  assert.deepEqual(askedFrom(''), {});
  const bad = [
    'zeta',
    'zeta_',
    'zeta_2',
    'zeta_-1',
    'zeta_NaN',
    'x_1',
    '__proto___1',
    'zeta_.1~zeta_.2',
    'toString_1',
  ];
  for (const text of [...bad, 'sigma_1e308', '~', 'zeta_0.1_2'])
    assert.equal(askedFrom(text), undefined, text);
});
