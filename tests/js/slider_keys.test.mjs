// The places that the keys of a slider step to.
import assert from 'node:assert/strict';
import { test } from 'node:test';

const { nextPlace, roundPlaces } = await import(
  new URL('../../src/rlswaim/explorers/js/page/slider_keys.js', import.meta.url).href
);

/** 280 steps over seven decades on each side of 0, with three digits. */
const sizes = Array.from({ length: 281 }, (_, k) => Number((1e-4 * 10 ** (k / 40)).toPrecision(3)));
const wide = [...sizes.map((v) => -v).reverse(), 0, 0.618, ...sizes].sort((a, b) => a - b);
const feet = Array.from({ length: 421 }, (_, k) => k);
const even = Array.from({ length: 100 }, (_, k) => Number((0.01 * (k + 1)).toFixed(2)));

function presses(grid, coarse, from, to) {
  const places = roundPlaces(grid, coarse);
  let [value, count] = [from, 0];
  for (; value < to; count++) value = nextPlace(places, value, 1);
  assert.equal(value, to);
  return count;
}

test('from 0 to 1 in few presses, each to a number of one digit', () => {
  assert.ok(presses(wide, false, 0, 1) <= 25);
  assert.equal(presses(wide, true, 0, 1), 5);
  for (const place of roundPlaces(wide, false))
    assert.ok(Math.abs(place) === 1e3 || /^\d(\.0+)?e/.test(Math.abs(place).toExponential(2)), `${place}`);
});

test('a place between two goes on to the next round one; at the end it stays', () => {
  const places = roundPlaces(wide, false);
  assert.equal(nextPlace(places, 0.618, 1), 0.8);
  assert.equal(nextPlace(places, 0.618, -1), 0.6);
  assert.equal(nextPlace(places, 1e3, 1), 1e3);
  assert.equal(nextPlace(wide, 0.618, 1), wide[wide.indexOf(0.618) + 1]);
});

test('feet and even places step one by one, coarse by ten', () => {
  assert.equal(nextPlace(roundPlaces(feet, false), 60, 1), 61);
  assert.equal(nextPlace(roundPlaces(feet, true), 60, 1), 70);
  assert.equal(nextPlace(roundPlaces(feet, true), 420, 1), 420);
  assert.equal(nextPlace(roundPlaces(even, false), 0.5, -1), 0.49);
});
