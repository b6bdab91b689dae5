// Round numbers along an axis.
import { number } from './numbers.js';

const STEPS = [1, 2, 5, 10];
const FINE = [1, 1.25, 1.6, 2, 2.5, 3.2, 4, 5, 6.4, 8, 10];

/**
 * The next number not below the value, of some in each decade.
 * @param {number} value @param {number[]} rungs
 */
export function ladder(value, rungs = FINE) {
  const decade = 10 ** Math.floor(Math.log10(value));
  return decade * rungs.find((rung) => rung * decade >= value * (1 - 1e-12));
}

/**
 * Steps that stand about `apart` px from each other.
 * @param {number} range @param {number} pixels @param {number} apart
 */
export const stepOf = (range, pixels, apart) => ladder(range / Math.max(2, pixels / apart), STEPS);

/** @param {number} step @param {number} from @param {number} to */
export function multiples(step, from, to) {
  const first = Math.ceil(from / step - 1e-9);
  const count = Math.max(0, Math.floor(to / step + 1e-9) - first + 1);
  return Array.from({ length: count }, (_, k) => (first + k) * step);
}

/** A tick's number, with the decimals that its step takes. @param {number} value @param {number} step */
export function tick(value, step) {
  const decimals = Math.max(0, -Math.floor(Math.log10(step) + 1e-9));
  if (decimals > 2 || Math.abs(value) >= 1e4) return number(Number(value.toPrecision(6)), 6);
  const text = value.toFixed(decimals);
  return (Number(text) === 0 ? '0' : text).replace('-', '−');
}
