// Random numbers that are the same on every run, and random loops made of them.

/** A generator of numbers between 0 and 1 (mulberry32). */
export function seeded(seed) {
  let state = seed;
  return () => {
    state = (state + 0x6d2b79f5) | 0;
    let t = Math.imul(state ^ (state >>> 15), 1 | state);
    t = (t + Math.imul(t ^ (t >>> 7), 61 | t)) ^ t;
    return ((t ^ (t >>> 14)) >>> 0) / 4294967296;
  };
}

/** n points, real or in conjugate pairs, within a circle of a radius about (middle, 0). */
export function randomPoints(random, n, radius = 3, middle = -0.7) {
  const [x, y] = [[], []];
  while (x.length < n) {
    const re = middle + radius * (2 * random() - 1);
    if (n - x.length > 1 && random() < 0.6) {
      const im = radius * random() + 0.05;
      x.push(re, re);
      y.push(im, -im);
    } else {
      x.push(re);
      y.push(0);
    }
  }
  return { x, y };
}

/** The polynomial with given roots and a leading coefficient, constant term first. */
export function expanded({ x, y }, lead = 1) {
  let [re, im] = [[lead], [0]];
  for (let i = 0; i < x.length; i++) {
    const [a, b] = [re, im];
    re = [...a, 0].map((_, k) => (a[k - 1] ?? 0) - (x[i] * (a[k] ?? 0) - y[i] * (b[k] ?? 0)));
    im = [...a, 0].map((_, k) => (b[k - 1] ?? 0) - (x[i] * (b[k] ?? 0) + y[i] * (a[k] ?? 0)));
  }
  return Float64Array.from(re);
}

/** D and N of equal length from poles, zeros and a gain. */
export function polynomials({ poles, zeros, gain }) {
  const D = expanded(poles);
  const N = new Float64Array(D.length);
  N.set(expanded(zeros, gain));
  return { D, N };
}
