// The frequencies at which a loop's response is drawn: even in each decade, and close about each resonance.

/** @typedef {import('./multiple_roots.js').Root} Root */
/** @typedef {import('./cut_loop.js').CutLoop} CutLoop */

const IN_A_DECADE = 24;
const DECADES = 6; // at most, but for what has to be seen
const LIGHT = 0.5; // damping ratio below which a root has a resonance of its own
const AROUND = 24; // points on each side of it
const REACH = 5.5; // widths sinh(5.5) to each side

/**
 * A root as one of continuous time: of z the logarithm over the period.
 * @param {Root} root
 * @param {number} period s
 */
const natural = ({ x, y }, period) =>
  period ? { x: Math.log(Math.hypot(x, y)) / period, y: Math.atan2(y, x) / period } : { x, y };

/**
 * About a resonance: the frequency of the root, that of the largest value of its factor alone, and points so
 * close that a circle in the plane of L is drawn as one.
 * @param {{ x: number, y: number }} root
 */
function around({ x, y }) {
  const width = Math.max(Math.abs(x), 1e-6 * y);
  const peak = y > Math.abs(x) ? [Math.sqrt(y * y - x * x)] : [];
  const beside = Array.from({ length: 2 * AROUND + 1 }, (_, k) => Math.sinh(REACH * (k / AROUND - 1)));
  return [...peak, ...beside.map((step) => y + width * step)];
}

/**
 * The ends of the frequency axis, whole decades: all roots but the origin, and what else has to be seen.
 * @param {number[]} sizes rad/s
 * @param {number} period s
 */
function endsOf(sizes, period) {
  const seen = sizes.filter((size) => size > 1e-9 && size < 1e9);
  const [least, most] = seen.length ? [Math.min(...seen), Math.max(...seen)] : [0.1, 10];
  const last = 10 ** Math.ceil(Math.log10(2 * most));
  const first = 10 ** Math.floor(Math.log10(least / 2));
  const end = period ? Math.PI / period : last;
  return [Math.max(Math.min(first, end / 10), 10 ** -DECADES * end), end];
}

/**
 * Rising frequencies (rad/s).
 * @param {Pick<CutLoop, 'parts' | 'period'>} loop
 * @param {number[]} also frequencies that have to be among them
 */
export function frequenciesOf({ parts, period }, also = []) {
  const needed = also.filter((w) => w > 0);
  const roots = [...parts.poles, ...parts.zeros].map((root) => natural(root, period));
  const sizes = roots.map(({ x, y }) => Math.hypot(x, y));
  const [least, end] = endsOf([...sizes, ...needed], period);
  const first = Math.min(least, ...needed);
  const decades = Math.log10(end / first);
  const count = Math.ceil(IN_A_DECADE * decades);
  const even = Array.from({ length: count + 1 }, (_, k) => first * 10 ** ((decades * k) / count));
  const light = roots.filter(({ x, y }) => y > 0 && Math.abs(x) < LIGHT * Math.hypot(x, y));
  const all = [...even, ...light.flatMap(around), ...needed].filter((w) => w >= first && w <= end);
  return Float64Array.from(new Set(all)).sort();
}
