// The kinds of sections that a compensator in discrete time has, each 1 at z = 1 where it can be.
/** @typedef {import('./sections_in_s.js').Kind} Kind */
/** @typedef {import('./sections_in_s.js').Place} Place */

const FARTHEST = 10; // of a root from the origin
const NEAREST = 1e-4; // to z = 1: a real root nearer to it is at it
const LONGEST = 12; // samples of a delay
const FLATTEST = 1e-3; // rad, of the angle of a pair

/** As a number is told. @param {number} v */
const short = (v) => Number(v.toPrecision(5));
/** A real root at z = at: (z - at)/(1 - at), or z - 1. @param {number} at */
const root = (at) => (at === 1 ? [-1, 1] : [-at / (1 - at), 1 / (1 - at)]);

/** A pair at size e^(+-j angle). @param {number} size @param {number} angle rad */
function pair(size, angle) {
  const c = [size * size, -2 * size * Math.cos(angle), 1];
  const at = (1 - size) ** 2 + 4 * size * Math.sin(angle / 2) ** 2; // c at z = 1
  return c.map((v) => v / at);
}

/** @param {number} _ @param {number} value */
const orOne = (_, value) => (Math.abs(value - 1) < NEAREST ? 1 : value);
/** @param {Place} to */
const sizeAngle = ({ re, im }) => [short(Math.hypot(re, im)), short(Math.atan2(im, re))];
/** Where a root of s lies: e^(-zeta omega) with its angle. @param {number} omega @param {number} zeta */
const decayed = (omega, zeta) => short(Math.exp(-zeta * omega));
/** An angle that a pair may have. @param {number} omega */
const angleOf = (omega) => short(Math.min(Math.max(omega, FLATTEST), Math.PI - FLATTEST));

/** @type {Pick<Kind, 'names' | 'least' | 'most' | 'snap' | 'moved'>} */
const REAL = {
  names: ['z'],
  least: [-FARTHEST],
  most: [FARTHEST],
  snap: orOne,
  moved: (_values, _isZero, { re }) => [short(re)],
};
/** @type {Pick<Kind, 'names' | 'least' | 'most' | 'moved'>} */
const PAIR = {
  names: ['|z|', 'angle (rad)'],
  least: [0, FLATTEST],
  most: [FARTHEST, Math.PI - FLATTEST],
  moved: (_values, _isZero, to) => sizeAngle(to),
};

/** @type {Record<string, Kind>} */
export const SECTIONS_IN_Z = {
  zpole: {
    ...REAL,
    text: 'Real pole',
    fresh: (omega) => [decayed(omega, 1)],
    ratio: ([at]) => ({ N: [1], D: root(at) }),
  },
  zzero: {
    ...REAL,
    text: 'Real zero',
    fresh: (omega) => [decayed(omega, 1)],
    ratio: ([at]) => ({ N: root(at), D: [1] }),
  },
  zpoles: {
    ...PAIR,
    text: 'Pole pair',
    fresh: (omega) => [decayed(omega, 0.5), angleOf(omega)],
    ratio: ([size, angle]) => ({ N: [1], D: pair(size, angle) }),
  },
  zzeros: {
    ...PAIR,
    text: 'Zero pair',
    fresh: (omega) => [decayed(omega, 0.1), angleOf(omega)],
    ratio: ([size, angle]) => ({ N: pair(size, angle), D: [1] }),
  },
  znotch: {
    text: 'Notch',
    names: ['angle (rad)', '|z| of zeros', '|z| of poles'],
    least: [FLATTEST, 0, 0],
    most: [Math.PI - FLATTEST, FARTHEST, FARTHEST],
    fresh: (omega) => [angleOf(omega), decayed(omega, 0.05), decayed(omega, 0.5)],
    ratio: ([angle, zero, pole]) => ({ N: pair(zero, angle), D: pair(pole, angle) }),
    moved([, zero, pole], isZero, to) {
      const [size, angle] = sizeAngle(to);
      return isZero ? [angle, size, pole] : [angle, zero, size];
    },
  },
  zlead: {
    text: 'Lead or lag',
    names: ['zero z', 'pole z'],
    least: [-FARTHEST, -FARTHEST],
    most: [1 - NEAREST, 1 - NEAREST],
    fresh: (omega) => [decayed(omega, 0.5), decayed(omega, 2)],
    ratio: ([zero, pole]) => ({ N: root(zero), D: root(pole) }),
    moved: ([zero, pole], isZero, { re }) => (isZero ? [short(re), pole] : [zero, short(re)]),
  },
  zdelay: {
    text: 'Delay',
    names: ['n of z⁻ⁿ (samples)'],
    least: [1],
    most: [LONGEST],
    fresh: () => [1],
    ratio: ([n]) => ({ N: [1], D: [...Array(n).fill(0), 1] }),
    snap: (_, value) => Math.round(value),
  },
};
