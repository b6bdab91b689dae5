// Polynomials and their roots. Coefficients run from the constant term up; points are pairs of arrays x, y.

export const EPS = 2.220446049250313e-16;

export function evaluate(c, x, y) {
  let re = 0;
  let im = 0;
  for (let k = c.length - 1; k >= 0; k--) [re, im] = [re * x - im * y + c[k], re * y + im * x];
  return [re, im];
}

export function multiply(a, b) {
  const product = new Float64Array(a.length + b.length - 1);
  a.forEach((p, i) => b.forEach((q, j) => (product[i + j] += p * q)));
  return product;
}

export const derivative = (c) => Float64Array.from(c.slice(1), (v, k) => v * (k + 1));

export function subtract(a, b) {
  return Float64Array.from({ length: Math.max(a.length, b.length) }, (_, k) => (a[k] ?? 0) - (b[k] ?? 0));
}

// Moves n distinct points to the n roots of c, all at once (Aberth's method). Unlike Newton's, two of them never fall
// on one root, so branches stay apart at break-away points. A point rests once |p| is as small as rounding allows, or
// after a step shorter than `close` times the distance to its neighbor: what is left is then smaller by close^2 again.
// Where Aberth's correction has a pole a step would lead anywhere, powers of it overflow: none is longer than a few times
// the size of the largest root.
export function refine(c, n, x, y, close = 1e-6) {
  let largestSquare = 0;
  for (let i = 0; i < n; i++) largestSquare = Math.max(largestSquare, x[i] * x[i] + y[i] * y[i]);
  const longestSquare = 16 * largestSquare || Infinity;
  let left = 2 ** n - 1; // one bit for each point that still moves
  for (let sweep = 0; left && sweep < 80; sweep++) {
    for (let i = 0; i < n; i++) {
      if (!(left & (1 << i))) continue;
      const zx = x[i];
      const zy = y[i];
      const size = Math.sqrt(zx * zx + zy * zy);
      let px = c[n];
      let py = 0;
      let dx = 0;
      let dy = 0;
      let bound = Math.abs(px);
      for (let k = n - 1; k >= 0; k--) {
        let t = dx * zx - dy * zy + px;
        dy = dx * zy + dy * zx + py;
        dx = t;
        t = px * zx - py * zy + c[k];
        py = px * zy + py * zx;
        px = t;
        bound = bound * size + Math.abs(c[k]);
      }
      let q = px * px + py * py;
      if (q <= EPS * EPS * bound * bound) {
        left &= ~(1 << i);
        continue;
      }
      // step = 1 / (p'/p - sum of 1/(z_i - z_j))
      let sx = (dx * px + dy * py) / q;
      let sy = (dy * px - dx * py) / q;
      let gap = Infinity;
      for (let j = 0; j < n; j++) {
        if (j === i) continue;
        const ex = zx - x[j];
        const ey = zy - y[j];
        q = ex * ex + ey * ey || 1e-300;
        if (q < gap) gap = q;
        sx -= ex / q;
        sy += ey / q;
      }
      q = sx * sx + sy * sy || 1e-300;
      const scale = q * longestSquare < 1 ? Math.sqrt(longestSquare / q) : 1 / q;
      x[i] -= sx * scale;
      y[i] += sy * scale;
      if (1 <= q * close * close * gap) left &= ~(1 << i);
    }
  }
}

// Points on circles whose radii the size of the coefficients tells (Bini): sound for roots of very different size.
function startingPoints(c, n) {
  const hull = [];
  const height = (k) => Math.log(Math.abs(c[k]));
  const slope = (a, b) => (height(b) - height(a)) / (b - a);
  for (let k = 0; k <= n; k++) {
    if (c[k] === 0) continue;
    while (hull.length > 1 && slope(hull.at(-2), hull.at(-1)) <= slope(hull.at(-1), k)) hull.pop();
    hull.push(k);
  }
  const x = new Array(n).fill(0.5);
  const y = x.slice();
  for (let h = 1; h < hull.length; h++) {
    const [from, to] = [hull[h - 1], hull[h]];
    const radius = Math.exp(-slope(from, to));
    for (let i = from; i < to; i++) {
      const angle = (2 * Math.PI * (i - from)) / (to - from) + (2 * Math.PI * h) / n + 0.7;
      x[i] = radius * Math.cos(angle);
      y[i] = radius * Math.sin(angle);
    }
  }
  return [x, y];
}

// All roots of a polynomial. Zeros at the origin come out exactly, and real roots exactly real.
export function roots(c) {
  let n = c.length - 1;
  while (n > 0 && c[n] === 0) n--;
  let m = 0;
  while (m < n && c[m] === 0) m++;
  const inner = c.slice(m, n + 1);
  const [x, y] = startingPoints(inner, n - m);
  refine(inner, n - m, x, y);
  flatten(x, y);
  const origin = new Array(m).fill(0);
  return { x: [...origin, ...x], y: [...origin, ...y] };
}

// A root nearer to its own conjugate than any other root is has none: it is real, however small.
export function flatten(x, y) {
  for (let i = 0; i < x.length; i++) {
    if (y[i] === 0) continue;
    let least = Infinity;
    for (let j = 0; j < x.length; j++)
      if (j !== i) least = Math.min(least, Math.hypot(x[i] - x[j], y[i] + y[j]));
    if (2 * Math.abs(y[i]) < least) y[i] = 0;
  }
}

// A polynomial without a constant term has a root at the origin itself: the nearest one there is it.
export function anchor(c, x, y) {
  const n = x.length;
  let missing = 0;
  while (missing < n && c[missing] === 0) missing++;
  if (missing === 0) return;
  for (let i = 0; i < n; i++) if (x[i] === 0 && y[i] === 0) missing--;
  for (; missing > 0; missing--) {
    let nearest = -1;
    let least = Infinity;
    for (let i = 0; i < n; i++) {
      const size = x[i] * x[i] + y[i] * y[i];
      if (size < least && (x[i] !== 0 || y[i] !== 0)) [nearest, least] = [i, size];
    }
    x[nearest] = y[nearest] = 0;
  }
}

// Rounding leaves a real root a little off the axis: a quick look, while a locus is traced.
export function settle(x, y) {
  for (let i = 0; i < x.length; i++) if (Math.abs(y[i]) <= 1e-13 * Math.abs(x[i])) y[i] = 0;
}

// Room for the pairing, made once: it is called hundreds of times in a frame.
const MOST = 24;
const cost = new Float64Array(MOST * MOST);
const [us, vs, least] = [new Float64Array(MOST), new Float64Array(MOST), new Float64Array(MOST)];
const [rowOf, way, seen] = [new Int32Array(MOST), new Int32Array(MOST), new Int32Array(MOST)];

function atOrigin(x, y) {
  let count = 0;
  for (let i = 0; i < x.length; i++) if (x[i] === 0 && y[i] === 0) count++;
  return count;
}

const NEVER = 1e30;

// For each point of a its partner in b, by least total squared distance. What stays at the origin itself is not changed for
// another that passes it.
export function pairing(ax, ay, bx, by, partner) {
  const n = ax.length;
  rowOf.fill(-1); // of each column; column n stands for "not yet"
  let taken = 0;
  const zeros = atOrigin(ax, ay);
  const stays = zeros > 0 && zeros === atOrigin(bx, by);
  for (let i = 0; i < n; i++) {
    us[i] = Infinity;
    const held = stays && ax[i] === 0 && ay[i] === 0;
    for (let j = 0; j < n; j++) {
      const ex = ax[i] - bx[j];
      const ey = ay[i] - by[j];
      const far = ex * ex + ey * ey;
      const may = far < NEVER && !(held && (bx[j] !== 0 || by[j] !== 0));
      const d = (cost[i * MOST + j] = may ? far : NEVER);
      if (d < us[i]) {
        us[i] = d;
        partner[i] = j;
      }
    }
    if (rowOf[partner[i]] < 0) {
      rowOf[partner[i]] = i;
      taken++;
    } else partner[i] = -1; // two points share the nearest one
  }
  if (taken < n) assign(n, partner);
  return partner;
}

// The assignment problem by shortest augmenting paths (Kuhn, Munkres; Jonker and Volgenant's form) for the points that
// are left: those that have the nearest one to themselves keep it at first.
function assign(n, partner) {
  vs.fill(0);
  for (let i = 0; i < n; i++) {
    if (partner[i] >= 0) continue;
    least.fill(Infinity);
    seen.fill(0);
    let column = n;
    rowOf[n] = i;
    while (rowOf[column] >= 0) {
      seen[column] = 1;
      const at = rowOf[column];
      let delta = Infinity;
      let next = n;
      for (let j = 0; j < n; j++) {
        if (seen[j]) continue;
        const slack = cost[at * MOST + j] - us[at] - vs[j];
        if (slack < least[j]) {
          least[j] = slack;
          way[j] = column;
        }
        if (least[j] < delta) {
          delta = least[j];
          next = j;
        }
      }
      for (let j = 0; j <= n; j++) {
        if (seen[j]) {
          us[rowOf[j]] += delta;
          vs[j] -= delta;
        } else least[j] -= delta;
      }
      column = next;
    }
    while (column !== n) {
      rowOf[column] = rowOf[way[column]];
      column = way[column];
    }
    rowOf[n] = -1;
  }
  for (let j = 0; j < n; j++) partner[rowOf[j]] = j;
}
