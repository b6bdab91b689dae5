// Margins in words.
import assert from 'node:assert/strict';
import { test } from 'node:test';

const { marginWords } = await import(
  new URL('../../src/rlswaim/explorers/js/page/locus_words.js', import.meta.url).href
);

test('a stable loop without crossings keeps stable at any gain', () => {
  assert.equal(
    marginWords({ gain: [], phase: [] }, true),
    'Phase margins: the loop’s size is nowhere 1. Gain margins: no crossing, any gain.',
  );
});

test('the margin that is used up first comes first, and the least delay is told', () => {
  const gain = [
    { dB: 12, factor: 4, omega: 1 },
    { dB: -6, factor: 0.5, omega: 3 },
  ];
  const phase = [
    { degrees: -100, omega: 10, delay: 0.454 },
    { degrees: 45, omega: 2, delay: 0.393 },
  ];
  assert.equal(
    marginWords({ gain, phase }, true),
    'Phase margins: +45° (ω = 2 rad/s), −100° (ω = 10 rad/s). Delay margin: 0.393 s. ' +
      'Gain margins: −6 dB (×0.5, ω = 3 rad/s), +12 dB (×4, ω = 1 rad/s).',
  );
});

test('a loop that is not stable has none, and one that is not closed is not spoken of', () => {
  assert.match(
    marginWords({ gain: [{ dB: 6, factor: 2, omega: 1 }], phase: [] }, false),
    /none, as this loop/,
  );
  assert.equal(marginWords(null, true), '');
});
