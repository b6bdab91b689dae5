// Where N/D is real on the imaginary axis. The phase of each factor (s - root) runs one way along the axis,
// so that the phase of N/D is bounded over any interval: intervals are halved until one holds no place or
// just one.
import { certainRealPhases } from './certain_real_phases.js';
import { EPS } from './polynomials.js';

/** @typedef {import('./multiple_roots.js').Root} Root */
/** @typedef {{ x: number, y: number, weight: number }} Term */
/**
 * An end of an interval; the angles of its terms start at slot in the room of the phase; edge: a place itself
 * does not count.
 * @typedef {{ at: number, slot: number, phase: number, edge: boolean }} End
 */
/**
 * The phase base - Σ weight atan((omega - y)/x) of the terms.
 * @typedef {{ x: number[], y: number[], weight: number[], base: number, tolerance: number,
 *   room: Float64Array }} Phase
 */

const DEEPEST = 60;
const MOST = 2000; // halvings, beyond which an interval is judged by its ends
const PLACES = DEEPEST + 4; // two ends, one more at each depth, and one to try

// The angles of all terms at each place; made once, and larger when more terms come.
let room = new Float64Array(PLACES * 32);

/**
 * All omega > 0 at which the phase of Π(j omega - zeros) / Π(j omega - poles) passes through a multiple of
 * 180 degrees; both are real or in conjugate pairs. Where a pole or zero stands on the axis itself, at 0 and
 * at infinity none is told.
 * @param {Root[]} poles
 * @param {Root[]} zeros
 * @returns {number[]}
 */
export const realPhases = (poles, zeros) => certainRealPhases(poles, zeros) ?? searched(poles, zeros);

/**
 * The same by intervals alone, whatever the factors.
 * @param {Root[]} poles
 * @param {Root[]} zeros
 * @returns {number[]}
 */
export function searched(poles, zeros) {
  const all = [
    ...zeros.map(({ x, y, count }) => ({ x, y, weight: count })),
    ...poles.map(({ x, y, count }) => ({ x, y, weight: -count })),
  ];
  const sizes = all.map(({ x, y }) => Math.hypot(x, y)).filter((size) => size > 0);
  if (sizes.length === 0 || !sizes.every(Number.isFinite)) return [];
  const top = 1.2345 * Math.exp(sizes.reduce((sum, size) => sum + Math.log(size), 0) / sizes.length);
  // Beyond the top s' = 1/s takes the place of s: of each factor (s - r) remains (s' - 1/r)/s'.
  const order = all.reduce((sum, { weight }) => sum + weight, 0);
  const inverse = all
    .filter(({ x, y }) => x !== 0 || y !== 0)
    .map(({ x, y, weight }) => {
      const square = x * x + y * y;
      return { x: x / square, y: -y / square, weight };
    });
  return [
    ...placesUpTo(all, top),
    ...placesUpTo([...inverse, { x: 0, y: 0, weight: -order }], 1 / top).map((v) => 1 / v),
  ].filter((omega) => omega > 0 && Number.isFinite(omega));
}

/**
 * @param {Term[]} all
 * @param {number} top
 */
function placesUpTo(all, top) {
  const terms = unmirrored(all.filter(({ x }) => x !== 0));
  if (terms.length === 0) return [];
  const onAxis = all.filter(({ x }) => x === 0);
  if (room.length < PLACES * terms.length) room = new Float64Array(2 * PLACES * terms.length);
  const phase = {
    x: terms.map(({ x }) => x),
    y: terms.map(({ y }) => y),
    weight: terms.map(({ weight }) => weight),
    room,
    base: (onAxis.reduce((sum, { weight }) => sum + weight, 0) % 2) * (Math.PI / 2),
    tolerance: 4 * EPS * (4 + terms.reduce((sum, { weight }) => sum + Math.abs(weight), 0)),
  };
  const edges = [0, ...onAxis.map(({ y }) => Math.abs(y)).filter((y) => y > 0 && y < top)];
  // The phase turns fastest beside a root near the axis: halving would come there late.
  const turning = terms.map(({ y }) => y).filter((y) => y > 0 && y < top);
  const places = [...new Set([...edges, ...turning, top])].sort((a, b) => a - b);
  /** @type {number[]} */
  const found = [];
  const budget = { left: MOST };
  let last = endAt(phase, 0, places[0], true);
  for (let k = 1; k < places.length; k++) {
    const next = endAt(phase, k % 2, places[k], edges.includes(places[k]));
    search(phase, last, next, 0, budget, found);
    last = next;
  }
  return found;
}

// Two poles (or zeros) that mirror each other in the axis leave the phase as it is.
/**
 * @param {Term[]} terms
 * @returns {Term[]}
 */
function unmirrored(terms) {
  if (terms.every(({ x }) => x < 0)) return terms;
  const left = terms.map(({ x, y, weight }) => ({ x, y, weight }));
  for (const a of left) {
    for (const b of left) {
      if (a.x * b.x >= 0 || a.weight * b.weight <= 0) continue;
      if (Math.hypot(a.x + b.x, a.y - b.y) > 8 * EPS * Math.hypot(a.x, a.y)) continue;
      const both = Math.sign(a.weight) * Math.min(Math.abs(a.weight), Math.abs(b.weight));
      a.weight -= both;
      b.weight -= both;
    }
  }
  return left.filter(({ weight }) => weight !== 0);
}

/**
 * @param {Phase} phase
 * @param {number} place in the room
 * @param {number} at
 * @param {boolean} edge
 * @returns {End}
 */
function endAt({ x, y, weight, base, room }, place, at, edge) {
  const slot = place * x.length;
  let phase = base;
  for (let i = 0; i < x.length; i++) {
    const angle = -weight[i] * Math.atan((at - y[i]) / x[i]);
    room[slot + i] = angle;
    phase += angle;
  }
  return { at, slot, phase, edge };
}

/**
 * @param {Phase} phase
 * @param {End} a
 * @param {End} b
 * @param {number} depth
 * @param {{ left: number }} budget
 * @param {number[]} found
 */
function search(phase, a, b, depth, budget, found) {
  const { room, x, tolerance } = phase;
  let rise = tolerance;
  let fall = tolerance;
  for (let i = 0; i < x.length; i++) {
    const turn = room[b.slot + i] - room[a.slot + i];
    if (turn > 0) rise += turn;
    else fall -= turn;
  }
  if (Math.ceil((a.phase - fall) / Math.PI) > Math.floor((a.phase + rise) / Math.PI)) return;
  const middle = (a.at + b.at) / 2;
  const small = depth >= DEEPEST || budget.left-- <= 0 || middle <= a.at || middle >= b.at;
  const way = small ? Math.sign(b.phase - a.phase) : direction(phase, a.at, b.at);
  if (way !== 0) {
    const multiples = Math.abs(turns(phase, b, -way) - turns(phase, a, way));
    if (multiples === 0) return;
    if (multiples === 1 || small) {
      found.push(placeBetween(phase, a, b, way));
      return;
    }
  } else if (small) return;
  const m = endAt(phase, depth + 2, middle, false);
  search(phase, a, m, depth + 1, budget, found);
  search(phase, m, b, depth + 1, budget, found);
}

// How many half turns the phase is past. At an edge that stands on one it is taken a little inside the
// interval.
/**
 * @param {Phase} phase
 * @param {End} end
 * @param {number} inwards the sign of the phase's change into the interval
 */
function turns({ tolerance }, { phase, edge }, inwards) {
  const near = Math.round(phase / Math.PI);
  const onOne = edge && Math.abs(phase - near * Math.PI) <= tolerance;
  if (onOne) return inwards > 0 ? near : near - 1;
  return Math.floor(phase / Math.PI);
}

// The sign of the phase's slope if it is the same all over an interval, 0 if that isn't sure.
/**
 * @param {Phase} phase
 * @param {number} from
 * @param {number} to
 */
function direction({ x, y, weight }, from, to) {
  let least = 0;
  let most = 0;
  for (let i = 0; i < x.length; i++) {
    const a = Math.abs(from - y[i]);
    const b = Math.abs(to - y[i]);
    const near = from <= y[i] && y[i] <= to ? 0 : Math.min(a, b);
    const far = Math.max(a, b);
    const steep = (-weight[i] * x[i]) / (near * near + x[i] * x[i]);
    const flat = (-weight[i] * x[i]) / (far * far + x[i] * x[i]);
    least += Math.min(steep, flat);
    most += Math.max(steep, flat);
  }
  if (least > 0) return 1;
  return most < 0 ? -1 : 0;
}

// The one place between two ends, by false position where that is sooner than halving.
/**
 * @param {Phase} phase
 * @param {End} a
 * @param {End} b
 * @param {number} way
 */
function placeBetween(phase, a, b, way) {
  const wanted = Math.PI * Math.max(turns(phase, a, way), turns(phase, b, -way));
  let [low, high, left, right] = [a.at, b.at, a.phase - wanted, b.phase - wanted];
  let m = (low + high) / 2;
  let side = 0;
  for (let turn = 1; turn < 80 && high - low > 2 * EPS * high; turn++) {
    const aim = low + ((high - low) * left) / (left - right);
    m = turn % 4 > 0 && aim > low && aim < high ? aim : (low + high) / 2;
    if (m <= low || m >= high) break;
    const off = endAt(phase, DEEPEST + 3, m, false).phase - wanted;
    if (off === 0) break;
    const now = off * way;
    // An end that stays a second time counts half (Illinois).
    if (now > 0) [high, right, left] = [m, off, side > 0 ? left / 2 : left];
    else [low, left, right] = [m, off, side < 0 ? right / 2 : right];
    side = now;
  }
  return m;
}
