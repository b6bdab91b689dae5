// How a root goes with its frequency and by steps: of s, or of z = e^(s period).

/** @typedef {[number, number]} Place real and imaginary part */
/**
 * omega: the frequency of a root (rad/s); at: where it is at another one, equally damped; stepped: one step
 * of a key to the right or up.
 * @typedef {{ omega: (re: number, im: number) => number,
 *   at: (re: number, im: number, omega: number) => Place,
 *   stepped: (re: number, im: number, right: number, up: number) => Place }} Movement
 */

const FACTOR = 1.05; // of a step in s
const STEP = 0.01; // in z

/** @type {Movement} */
const IN_S = {
  omega: Math.hypot,
  at(re, im, omega) {
    const factor = omega / Math.hypot(re, im);
    return [re * factor, im * factor];
  },
  stepped(re, im, right, up) {
    const factor = FACTOR ** (right || up);
    return right || im === 0 ? [re * factor, im * factor] : [re / factor, im];
  },
};

/** @param {number} re @param {number} im */
const logarithm = (re, im) => [Math.log(Math.hypot(re, im)), Math.atan2(im, re)];

/** @param {number} period s @returns {Movement} */
const inZ = (period) => ({
  omega: (re, im) => Math.hypot(...logarithm(re, im)) / period,
  at(re, im, omega) {
    const [decay, turn] = logarithm(re, im);
    const wanted = (omega * period) / Math.hypot(decay, turn);
    const factor = turn > 0 ? Math.min(wanted, Math.PI / turn) : wanted;
    const size = Math.exp(decay * factor);
    return im === 0
      ? [Math.sign(re) * size, 0]
      : [size * Math.cos(turn * factor), size * Math.sin(turn * factor)];
  },
  stepped: (re, im, right, up) =>
    im === 0 ? [re + STEP * (right || up), 0] : [re + STEP * right, im + STEP * up],
});

/** @param {number} period s, 0 in continuous time */
export const movementOf = (period) => (period ? inZ(period) : IN_S);
