// Which root of one set is which root of the next: the assignment of least total squared distance.

/** @typedef {Float64Array | number[]} Numbers */

// The room for the assignment, made once: it is called hundreds of times in a frame. Larger sets get a larger room.
/** @param {number} most */
const roomFor = (most) => ({
  most,
  cost: new Float64Array(most * most),
  rowPrice: new Float64Array(most),
  columnPrice: new Float64Array(most + 1),
  least: new Float64Array(most),
  rowOf: new Int32Array(most + 1), // of each column; column n stands for "not yet"
  way: new Int32Array(most),
  seen: new Uint8Array(most + 1),
});
let room = roomFor(24);

/**
 * @param {Numbers} x
 * @param {Numbers} y
 */
function atOrigin(x, y) {
  let count = 0;
  for (let i = 0; i < x.length; i++) if (x[i] === 0 && y[i] === 0) count++;
  return count;
}

const FORBIDDEN = 1e30;

/**
 * For each point of a its partner in b, by least total squared distance. A point that stays at the origin itself is not
 * exchanged for another that passes it.
 * @param {Numbers} ax
 * @param {Numbers} ay
 * @param {Numbers} bx
 * @param {Numbers} by
 * @param {Int32Array} partner filled and returned
 */
export function matchRoots(ax, ay, bx, by, partner) {
  const n = ax.length;
  if (n > room.most) room = roomFor(2 * n);
  const { most, cost, rowPrice, rowOf } = room;
  rowOf.fill(-1);
  let taken = 0;
  const zeros = atOrigin(ax, ay);
  const stays = zeros > 0 && zeros === atOrigin(bx, by);
  for (let i = 0; i < n; i++) {
    let nearest = 0;
    let least = Infinity;
    const held = stays && ax[i] === 0 && ay[i] === 0;
    for (let j = 0; j < n; j++) {
      const ex = ax[i] - bx[j];
      const ey = ay[i] - by[j];
      const far = ex * ex + ey * ey;
      const allowed = far < FORBIDDEN && !(held && (bx[j] !== 0 || by[j] !== 0));
      const d = allowed ? far : FORBIDDEN;
      cost[i * most + j] = d;
      if (d < least) {
        least = d;
        nearest = j;
      }
    }
    rowPrice[i] = least;
    partner[i] = rowOf[nearest] < 0 ? nearest : -1; // -1 where two points share the nearest one
    if (partner[i] < 0) continue;
    rowOf[nearest] = i;
    taken++;
  }
  if (taken < n) assign(n, partner);
  return partner;
}

// The assignment problem by shortest augmenting paths (Kuhn, Munkres; Jonker and Volgenant's form) for the points that
// are left: those that have the nearest one to themselves keep it at first.
/**
 * @param {number} n
 * @param {Int32Array} partner
 */
function assign(n, partner) {
  const { columnPrice, rowOf } = room;
  columnPrice.fill(0);
  for (let i = 0; i < n; i++) if (partner[i] < 0) augment(n, i);
  for (let j = 0; j < n; j++) partner[rowOf[j]] = j;
}

// Finds the cheapest chain of exchanges that gives row i a column, and makes them.
/**
 * @param {number} n
 * @param {number} i
 */
function augment(n, i) {
  const { most, cost, rowPrice, columnPrice, least, rowOf, way, seen } = room;
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
      const slack = cost[at * most + j] - rowPrice[at] - columnPrice[j];
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
        rowPrice[rowOf[j]] += delta;
        columnPrice[j] -= delta;
      } else if (j < n) least[j] -= delta;
    }
    column = next;
  }
  while (column !== n) {
    rowOf[column] = rowOf[way[column]];
    column = way[column];
  }
  rowOf[n] = -1;
}
