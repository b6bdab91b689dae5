// What may be asked of a closed loop, and whether it holds: bounds on its poles and on its margins.

/**
 * size: |z| of a pole of discrete time, which then stands here as the s with z = e^(s period).
 * @typedef {{ re: number, im: number, name: string, size?: number }} Pole
 */
/**
 * @typedef {{ gain: { dB: number, omega: number }[], phase: { degrees: number, omega: number }[] }}
 *   Margins
 */
/** @typedef {Record<string, number>} Requirements the bound of each kind that is asked for */
/** @typedef {{ poles: Pole[], margins: Margins | null, isStable: boolean }} Loop */
/**
 * found: the value that counts; name: of the pole that has it, or of none.
 * @typedef {{ holds: boolean, found: number, name: string, omega: number }} Finding
 */

const SETTLED = Math.log(50); // times the slowest pole's time constant until 2 % are left

/**
 * The damping ratio with which a pair of poles alone overshoots by so many percent.
 * @param {number} percent
 */
export function dampingOf(percent) {
  const log = -Math.log(percent / 100);
  return log / Math.hypot(Math.PI, log);
}

/** @param {Pole} pole */
function zetaOf({ re, im }) {
  if (re === -Infinity) return 1; // z = 0
  return re === 0 && im === 0 ? 0 : -re / Math.hypot(re, im);
}
/** The overshoot (%) that belongs to a damping ratio, none from 1 on. @param {number} zeta */
export const overshootOf = (zeta) =>
  zeta >= 1 ? 0 : 100 * Math.exp((-Math.PI * zeta) / Math.sqrt(1 - zeta * zeta));

/**
 * The least of some value over the poles, with the pole that has it.
 * @param {Pole[]} poles @param {(pole: Pole) => number} value
 * @returns {{ found: number, name: string, omega: number }}
 */
function least(poles, value) {
  const [worst] = poles.filter(({ im }) => im >= 0).sort((a, b) => value(a) - value(b));
  return { found: value(worst), name: worst.name, omega: Math.hypot(worst.re, worst.im) };
}

/**
 * The margin nearest to the border; infinite where there is none, 0 where the loop is not stable.
 * @template Each @param {Each[]} all @param {(margin: Each) => number} size @param {boolean} isStable
 */
function nearest(all, size, isStable) {
  const [first] = [...all].sort((a, b) => size(a) - size(b));
  if (!isStable) return { found: 0, name: '', omega: NaN };
  const omega = first ? /** @type {any} */ (first).omega : NaN;
  return { found: first ? size(first) : Infinity, name: '', omega };
}

/**
 * in: the plane alone in which it is asked for; unit: s is a sample where no time is told.
 * @typedef {{ text: string, unit: string, least: number, most: number, fresh: number, in?: 's' | 'z',
 *   find: (loop: Loop, bound: number) => Finding }} Kind
 */

/** @type {Record<string, Kind>} */
export const ASKED = {
  zeta: {
    text: 'least ζ',
    unit: '',
    least: 0.001,
    most: 0.999,
    fresh: 0.1,
    find: ({ poles }, bound) => atLeast(least(poles, zetaOf), bound),
  },
  sigma: {
    text: 'least decay σ',
    unit: '1/s',
    in: 's',
    least: 1e-4,
    most: 1e3,
    fresh: 0.1,
    find: ({ poles }, bound) =>
      atLeast(
        least(poles, ({ re }) => -re),
        bound,
      ),
  },
  radius: {
    text: 'largest |z| at most',
    unit: '',
    in: 'z',
    least: 0.001,
    most: 0.99999,
    fresh: 0.9,
    find({ poles }, bound) {
      const outermost = least(poles, ({ size }) => -size);
      return { ...outermost, found: -outermost.found, holds: -outermost.found <= bound };
    },
  },
  settling: {
    text: 'settling time (2 %) at most',
    unit: 's',
    least: 1e-3,
    most: 1e4,
    fresh: 20,
    find({ poles }, bound) {
      const slowest = least(poles, ({ re }) => -re);
      const time = slowest.found > 0 ? SETTLED / slowest.found : Infinity;
      return { ...slowest, found: time, holds: time <= bound };
    },
  },
  overshoot: {
    text: 'overshoot at most',
    unit: '%',
    least: 0.1,
    most: 99,
    fresh: 30,
    find({ poles }, bound) {
      const worst = least(poles, zetaOf);
      const percent = worst.found > 0 ? overshootOf(worst.found) : Infinity;
      return { ...worst, found: percent, holds: worst.found >= dampingOf(bound) };
    },
  },
  gain: {
    text: 'least gain margin',
    unit: 'dB',
    least: 0.1,
    most: 60,
    fresh: 6,
    find: ({ margins, isStable }, bound) =>
      atLeast(
        nearest(margins?.gain ?? [], ({ dB }) => Math.abs(dB), isStable),
        bound,
      ),
  },
  phase: {
    text: 'least phase margin',
    unit: '°',
    least: 0.1,
    most: 179,
    fresh: 30,
    find: ({ margins, isStable }, bound) =>
      atLeast(
        nearest(margins?.phase ?? [], ({ degrees }) => Math.abs(degrees), isStable),
        bound,
      ),
  },
};

/** @param {{ found: number, name: string, omega: number }} value @param {number} bound @returns {Finding} */
const atLeast = (value, bound) => ({ ...value, holds: value.found >= bound });

/**
 * The part of the s plane that poles have to be in: left of -sigma, and at least so well damped.
 * @param {Requirements} asked
 */
export const regionOf = ({ zeta = 0, sigma = 0, settling = Infinity, overshoot = 100 }) => ({
  sigma: Math.max(sigma, SETTLED / settling),
  zeta: Math.max(zeta, overshoot < 100 ? dampingOf(overshoot) : 0),
});

/**
 * The part of the z plane: within a radius, and at least so well damped.
 * @param {Requirements} asked @param {number} period s
 */
export function regionInZ(asked, period) {
  const { sigma, zeta } = regionOf(asked);
  return { radius: Math.min(asked.radius ?? 1, Math.exp(-sigma * period)), zeta };
}

/** Poles of z as those of s. @param {Pole[]} poles @param {number} period s @returns {Pole[]} */
export const polesOfZ = (poles, period) =>
  poles.map(({ re, im, name }) => {
    const size = Math.hypot(re, im);
    const turn = im === 0 && re >= 0 ? 0 : Math.atan2(im || 0, re);
    return { re: Math.log(size) / period, im: turn / period, name, size };
  });

/**
 * @param {Requirements} asked @param {Loop} loop
 * @returns {(Finding & { kind: string, bound: number })[]}
 */
export const findings = (asked, loop) =>
  Object.entries(asked).map(([kind, bound]) => ({ kind, bound, ...ASKED[kind].find(loop, bound) }));
