// A compensator's sections, its text in an address, and its Python.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { maths } from './maths.mjs';

const page = (/** @type {string} */ name) =>
  import(new URL(`../../src/rlswaim/explorers/js/page/${name}.js`, import.meta.url).href);
const { KINDS, isProper, kindsOf, ratioOf, rootsOf } = await maths('compensator');
const { movementOf } = await maths('moved_roots');
const { roots } = await maths('aberth');
const { bounded, compensatorFrom, isSmall, textOf } = await page('compensator_text');
const { pythonWith } = await page('compensator_python');

const NOTCH = { kind: 'notch', values: [3, 0.05, 0.5] };
const DELAY = { kind: 'delay', values: [0.1, 4] };

/** @param {ArrayLike<number>} c @param {number} re @param {number} im */
function size(c, re, im) {
  let [a, b] = [0, 0];
  for (let k = c.length - 1; k >= 0; k--) [a, b] = [a * re - b * im + c[k], a * im + b * re];
  return Math.hypot(a, b);
}

test('each kind has the roots of its polynomials, and is 1 at s = 0 or z = 1', () => {
  for (const [kind, { fresh, ratio, least, most, names }] of Object.entries(KINDS)) {
    const values = fresh(2).map((/** @type {number} */ v, /** @type {number} */ k) => bounded(kind, k, v));
    assert.equal(values.length, names.length);
    assert.ok(
      values.every((/** @type {number} */ v, /** @type {number} */ k) => v >= least[k] && v <= most[k]),
    );
    const { N, D } = ratio(values);
    const still = kindsOf(true).includes(kind) ? 1 : 0;
    assert.ok(Math.abs(size(N, still, 0) / size(D, still, 0) - 1) < 1e-12, kind);
    const { poles, zeros } = rootsOf({ kind, values }, roots);
    assert.deepEqual([zeros.length, poles.length], [N.length - 1, D.length - 1]);
    for (const { re, im } of poles) assert.ok(size(D, re, im) < 1e-12);
    for (const { re, im } of zeros) assert.ok(size(N, re, im) < 1e-12);
  }
});

test('a delay passes all frequencies alike and lags as it should', () => {
  const { N, D } = ratioOf({ place: 'K', gain: 1, sections: [DELAY] });
  for (const omega of [0.1, 1, 10]) assert.ok(Math.abs(size(N, 0, omega) / size(D, 0, omega) - 1) < 1e-13);
});

test('a moved root is where it was moved to', () => {
  for (const [kind, { fresh, moved, least }] of Object.entries(KINDS)) {
    if (!moved) continue;
    const values = fresh(0.7);
    const isDiscrete = kindsOf(true).includes(kind);
    const isReal = least.length < 2 || kind.endsWith('lead');
    const to = isDiscrete ? { re: 0.6, im: isReal ? 0 : 0.3 } : { re: -2, im: isReal ? 0 : 3 };
    const from = rootsOf({ kind, values }, roots).poles[0];
    const { poles } = rootsOf({ kind, values: moved(values, false, to, from) }, roots);
    const { zeros } = rootsOf({ kind, values: moved(values, true, to, from) }, roots);
    const off = [...poles, ...zeros].map(({ re, im }) => Math.hypot(re - to.re, im - to.im));
    if (kind === 'delay') assert.ok(Math.abs(Math.hypot(poles[0].re, poles[0].im) - Math.sqrt(13)) < 3e-3);
    else assert.ok(Math.min(...off) < 1e-3, kind);
  }
});

test('in z a root goes with its frequency along its damping, and keys step it', () => {
  const inZ = movementOf(0.1);
  const [re, im] = inZ.at(0.8, 0.3, 2 * inZ.omega(0.8, 0.3));
  assert.ok(Math.hypot(re - (0.8 ** 2 - 0.3 ** 2), im - 2 * 0.8 * 0.3) < 1e-12); // z^2
  assert.equal(inZ.at(0.8, 0.3, 1e9)[1] < 1e-12, true);
  assert.deepEqual(inZ.stepped(0.5, 0, 0, 1), [0.51, 0]);
  assert.deepEqual(inZ.stepped(0.5, 0.2, -1, 0), [0.49, 0.2]);
});

test('sections in z are no text of a loop in s', () => {
  const text = 'k~1~zpole_0.5~zdelay_2~znotch_0.7_1_0.9';
  assert.equal(compensatorFrom(text, ['k']), undefined);
  assert.equal(textOf(compensatorFrom(text, ['k'], kindsOf(true))), text);
  assert.equal(compensatorFrom('k~1~pole_-1', ['k'], kindsOf(true)), undefined);
  for (const bad of ['zdelay_0', 'zdelay_1.5', 'zdelay_13', 'zpole_11', 'zpoles_0.5_4', 'zlead_1_0'])
    assert.equal(compensatorFrom(`k~1~${bad}`, ['k'], kindsOf(true)), undefined, bad);
});

test('it needs as many poles as zeros', () => {
  const zero = { kind: 'zero', values: [-1] };
  assert.equal(isProper({ place: 'K', gain: 1, sections: [zero] }), false);
  assert.equal(isProper({ place: 'K', gain: 1, sections: [zero, { kind: 'pole', values: [-9] }] }), true);
});

test('its text gives it back', () => {
  const compensator = { place: 'K_A', gain: -1.25, sections: [NOTCH, DELAY, { kind: 'pole', values: [0] }] };
  const text = textOf(compensator);
  assert.equal(text, 'K_A~-1.25~notch_3_0.05_0.5~delay_0.1_4~pole_0');
  assert.equal(encodeURIComponent(text), text);
  assert.deepEqual(compensatorFrom(text, ['K_A']), compensator);
  assert.equal(textOf(null), '');
});

test('a text that makes no sense is none', () => {
  const bad = [
    ...['', '~', 'K_A', 'K_A~', 'K_A~0', 'K_A~1e308', 'K_A~NaN', 'K_A~Infinity', 'K_B~1', '__proto__~1'],
    ...['K_A~1~', 'K_A~1~notch', 'K_A~1~notch_1_2', 'K_A~1~notch_1_.1_.5_3', 'K_A~1~toString_1'],
    ...['K_A~1~__proto__', 'K_A~1~pole_1e308', 'K_A~1~pole_x', 'K_A~1~pole_', 'K_A~1~pole_0x10'],
    ...['K_A~1~delay_0.1_2.5', 'K_A~1~delay_0.1_99', 'K_A~1~delay_1e-9_2', 'K_A~1~poles_0_0.5'],
    `K_A~1${'~pole_-1'.repeat(9)}`,
    `K_A~1${'~delay_0.1_4'.repeat(4)}`,
    `K_A~1${'~pole_-1'.repeat(1e5)}`,
  ];
  for (const text of bad) assert.equal(compensatorFrom(text, ['K_A']), undefined, text.slice(0, 40));
});

test('numbers stay within the bounds of their kind', () => {
  assert.equal(bounded('notch', 1, 7), 1);
  assert.equal(bounded('delay', 1, 2.6), 3);
  assert.equal(bounded('lead', 0, 5), -1e-2);
  assert.equal(isSmall(Array(4).fill(DELAY)), false);
  assert.equal(isSmall(Array(3).fill(DELAY)), true);
});

test('the copied Python multiplies the sections and closes the loop', () => {
  const python = {
    equations: 'rl.printed_equations()',
    function: 'rate_attitude',
    arguments: { K_A: 'K_A', K_C: 'K_C' },
  };
  const compensator = { place: 'K_A', gain: 2, sections: [NOTCH] };
  const text = pythonWith({ python }, { K_A: 1.8, K_C: 10 }, compensator);
  assert.match(text, /L = cut_loop\(lambda K_A: rl\.rate_attitude\(eqs, K_A=K_A, K_C=10\), 1\.8\)/);
  assert.match(text, /C \*= control\.tf\(\[[^\]]+\], \[[^\]]+\]\) {2}# notch: 3, 0\.05, 0\.5/);
  assert.match(text, /loop = control\.feedback\(control\.ss\(C\) \* L\)\nloop\.poles\(\)\n$/);
  assert.equal(pythonWith({ python }, { K_A: 1.8, K_C: 10 }, null).includes('cut_loop'), false);
});
