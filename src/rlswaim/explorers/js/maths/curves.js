// Curves along the vehicle: cubic pieces between nodes that Python sends, with values and slopes.

/** @typedef {{ x: number[], y: number[], slope: number[] }} Curve along the vehicle (ft) */

/**
 * The value of a curve and its derivative.
 * @param {Curve} curve @param {number} station
 * @returns {[number, number]}
 */
export function curveAt({ x, y, slope }, station) {
  let k = 0;
  while (k < x.length - 2 && x[k + 1] <= station) k++;
  const h = x[k + 1] - x[k];
  const t = (station - x[k]) / h;
  const chord = (y[k + 1] - y[k]) / h;
  const [a, b] = [slope[k], slope[k + 1]];
  // y + h t (a + t (3 chord - 2 a - b + t (a + b - 2 chord)))
  const [square, cube] = [3 * chord - 2 * a - b, a + b - 2 * chord];
  return [y[k] + h * t * (a + t * (square + t * cube)), a + t * (2 * square + 3 * t * cube)];
}

/** @type {WeakMap<object, ArrayLike<number>>} */
const known = new WeakMap();

/**
 * The values of a curve at each foot; a table is taken as it is.
 * @param {Curve | ArrayLike<number>} given
 * @returns {ArrayLike<number>}
 */
export function atFeet(given) {
  if (!('slope' in given)) return given;
  const values =
    known.get(given) ??
    Float64Array.from({ length: given.x.at(-1) + 1 }, (_, foot) => curveAt(given, foot)[0]);
  known.set(given, values);
  return values;
}
