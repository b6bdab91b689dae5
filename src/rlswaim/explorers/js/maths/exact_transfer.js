// The transfer function of a state space without rounding: integer coefficients over a power of two.

/**
 * A polynomial with the coefficients integers[i] / 2^exponent, constant term first.
 * @typedef {{ integers: bigint[], exponent: number }} Exact
 */
/** @typedef {bigint[][]} Matrix */

const DIGITS = 1074; // binary digits after the point of the smallest double

/**
 * The number as an odd integer times a power of two.
 * @param {number} value
 * @returns {[bigint, number]}
 */
function parts(value) {
  if (value === 0) return [0n, 0];
  const power = Math.max(Math.floor(Math.log2(Math.abs(value))) - 54, -DIGITS);
  let integer = BigInt(scaled(value, -power));
  let zeros = 0;
  while (integer % 2n === 0n) [integer, zeros] = [integer / 2n, zeros + 1];
  return [integer, power + zeros];
}

/** value 2^power, where the power alone may overflow. @param {number} value @param {number} power */
export function scaled(value, power) {
  const half = Math.trunc(power / 2);
  return value * 2 ** half * 2 ** (power - half);
}

/**
 * Rows of numbers as integers over one power of two.
 * @param {number[][]} rows
 * @returns {{ rows: Matrix, exponent: number }}
 */
function integersOf(rows) {
  const all = rows.map((row) => row.map(parts));
  const exponent = Math.max(0, ...all.flat().map(([integer, power]) => (integer ? -power : 0)));
  const shifted = all.map((row) => row.map(([integer, power]) => integer << BigInt(power + exponent)));
  return { rows: shifted, exponent };
}

/** A polynomial of given coefficients, without rounding. @param {ArrayLike<number>} c @returns {Exact} */
export function exactly(c) {
  const { rows, exponent } = integersOf([Array.from(c)]);
  return { integers: rows[0], exponent };
}

/**
 * @param {Matrix} a
 * @param {Matrix} b
 * @returns {Matrix}
 */
function product(a, b) {
  return a.map((row) => {
    const sum = new Array(b[0].length).fill(0n);
    row.forEach((value, k) => {
      if (value)
        b[k].forEach((other, j) => {
          if (other) sum[j] += value * other;
        });
    });
    return sum;
  });
}

// The traces of A, A^2 ... A^n: powers up to the root of n, and products of these.
/** @param {Matrix} A */
function traces(A) {
  const n = A.length;
  const steps = Math.ceil(Math.sqrt(n));
  const low = [A];
  while (low.length < steps) low.push(product(low[low.length - 1], A));
  const found = low.map((power) => power.reduce((sum, row, i) => sum + row[i], 0n));
  let high = low[steps - 1];
  while (found.length < n) {
    for (const power of low) {
      let sum = 0n;
      high.forEach((row, i) => {
        row.forEach((value, j) => {
          if (value && power[j][i]) sum += value * power[j][i];
        });
      });
      found.push(sum);
    }
    if (found.length < n) high = product(high, low[steps - 1]);
  }
  return found.slice(0, n);
}

/**
 * N and D of C (sI - A)^-1 B + D0 = N/D, exact for the numbers given.
 * @param {number[][]} A n by n
 * @param {number[][]} B n by 1
 * @param {number[][]} C 1 by n
 * @param {number} D0
 * @returns {{ N: Exact, D: Exact }}
 */
export function exactTransfer(A, B, C, D0) {
  const n = A.length;
  const [a, b, c] = [A, B, C].map(integersOf);
  // Newton's identities: with the integers a = A 2^e the characteristic polynomial is one of s 2^e.
  const sums = traces(a.rows);
  const d = [1n]; // highest power first
  for (let k = 1; k <= n; k++) {
    let sum = 0n;
    for (let i = 1; i <= k; i++) sum += sums[i - 1] * d[k - i];
    d.push(-sum / BigInt(k));
  }
  /** @type {bigint[]} */
  const markov = []; // C A^i B
  let reached = b.rows;
  for (let i = 0; i < n; i++) {
    markov.push(product(c.rows, reached)[0][0]);
    reached = product(a.rows, reached);
  }
  const numerator = Array.from({ length: n }, (_, k) =>
    markov.slice(0, k + 1).reduce((sum, h, i) => sum + h * d[k - i], 0n),
  );
  // The coefficient of s^(n - k) is d[k] / 2^(e k): all over 2^(e n).
  const e = a.exponent;
  const D = Array.from({ length: n + 1 }, (_, i) => d[n - i] << BigInt(e * i));
  const [[gain], gainExponent] = (() => {
    const { rows, exponent } = integersOf([[D0]]);
    return [rows[0], exponent];
  })();
  const more = b.exponent + c.exponent;
  const N = D.map((value, i) => {
    const strict = i < n ? numerator[n - 1 - i] << BigInt(e * (i + 1) + gainExponent) : 0n;
    return strict + ((value * gain) << BigInt(more));
  });
  return {
    D: { integers: D, exponent: e * n },
    N: { integers: N, exponent: e * n + more + gainExponent },
  };
}
