// Root loci from the table of terms that Python sends: nothing here knows any physics.
import {
  EPS,
  anchor,
  derivative,
  evaluate,
  flatten,
  multiply,
  pairing,
  refine,
  roots,
  settle,
  subtract,
} from './roots.js';

// The value of each factor of the table: a parameter itself, or a mode's shape at the station that a parameter gives.
export function factorsOf(system, state) {
  const factors = { ...state };
  for (const [factor, shape] of Object.entries(system.shapes))
    factors[factor] = along(shape.values, state[shape.at]);
  for (const factor of leftOut(system, state)) factors[factor] = 0;
  return factors;
}

const leftOut = ({ choice }, state) => (choice ? choice.zero[state[choice.name]] : []);

// The table has one value a foot; between two of them the picture takes the straight line.
function along(values, station) {
  const left = Math.min(Math.floor(station), values.length - 2);
  return values[left] + (station - left) * (values[left + 1] - values[left]);
}

const longest = (terms) => terms.reduce((most, term) => Math.max(most, term.coefficients.length), 1);

// Multiplies out all factors but the free ones: a shorter table of the same kind.
export function collapse(terms, factors, free) {
  const merged = new Map();
  const size = longest(terms);
  for (const term of terms) {
    const left = term.factors.filter((f) => free.includes(f));
    const weight = term.factors.reduce((w, f) => (free.includes(f) ? w : w * factors[f]), 1);
    const key = left.join();
    if (!merged.has(key)) merged.set(key, { factors: left, coefficients: new Float64Array(size) });
    const sum = merged.get(key).coefficients;
    term.coefficients.forEach((c, k) => (sum[k] += weight * c));
  }
  return [...merged.values()];
}

function fill(table, factors, c) {
  c.fill(0);
  for (const term of table) {
    let weight = 1;
    for (const f of term.factors) weight *= factors[f];
    for (let k = 0; k < term.coefficients.length; k++) c[k] += weight * term.coefficients[k];
  }
  return c;
}

// The polynomial of a list of terms at the values of its factors, constant term first.
export const polynomial = (terms, factors) => fill(terms, factors, new Float64Array(longest(terms)));

export const polynomialOf = (system, state) => polynomial(system.terms, factorsOf(system, state));

// What a locus draws if nobody says: the loop that is closed last.
export const lastLoop = (system) => ({ running: system.closing.at(-1), off: [], of: 'poles' });

const withoutGains = (state, gains = []) => ({
  ...state,
  ...Object.fromEntries(gains.map((gain) => [gain, 0])),
});

// The loop as D + k N, in the gain k that runs: its roots are the closed-loop poles, or the zeros that the poles run to
// in a later loop, whose gain multiplies them.
export function openLoop(system, state, what = lastLoop(system)) {
  const { running, off, of, gain } = what;
  const factors = factorsOf(system, withoutGains(state, off));
  const zeros = of === 'zeros';
  if (zeros) factors[gain] = 1;
  factors[running] = 1;
  const size = longest(system.terms);
  const [D, N] = [new Float64Array(size), new Float64Array(size)];
  for (const term of system.terms) {
    if (zeros && !term.factors.includes(gain)) continue;
    let weight = 1;
    for (const f of term.factors) weight *= factors[f];
    const sum = term.factors.includes(running) ? N : D;
    for (let k = 0; k < term.coefficients.length; k++) sum[k] += weight * term.coefficients[k];
  }
  let n = size;
  while (n > 1 && D[n - 1] === 0 && N[n - 1] === 0) n--;
  return { D: D.subarray(0, n), N: N.subarray(0, n) };
}

// Values that depend on a few places of the sliders alone, kept while other sliders move: the last ones of each system.
const KEPT = 24;
const memory = new WeakMap();

function once(system, key, make) {
  if (!memory.has(system)) memory.set(system, new Map());
  const values = memory.get(system);
  const value = values.get(key) ?? make();
  values.delete(key);
  values.set(key, value);
  if (values.size > KEPT) values.delete(values.keys().next().value);
  return value;
}

const placesOf = (system, state) => system.parameters.map(({ name }) => state[name]).join();

// Made when it is asked for, and kept.
function lazy(make) {
  let value;
  return () => (value ??= make());
}

// The open loop with what its own polynomials tell: it stays while its gain runs.
function loopOf(system, state, what) {
  const { running, off = [], of = 'poles', gain } = what;
  const still = withoutGains(state, [...off, running, gain ?? running]);
  return once(system, `loop ${running} ${of} ${placesOf(system, still)}`, () => {
    const loop = openLoop(system, state, what);
    return {
      ...loop,
      breaks: breakAways(loop),
      crossings: lazy(() => crossings(loop)),
      zeros: lazy(() => roots(loop.N)),
    };
  });
}

// The open-loop poles, each with the branch that leaves from it: the vehicle's from Python, the actuators' are factors.
export function namedPoles(system, state) {
  const poles = [
    ...system.poles,
    ...system.actuators.map((a) => ({ re: -state[a.factor], im: 0, branch: a.branch })),
  ];
  return { x: poles.map((p) => p.re), y: poles.map((p) => p.im), branches: poles.map((p) => p.branch) };
}

const trimmed = (c) => c.slice(0, c.findLastIndex((v) => v !== 0) + 1);

// The sum of the sizes of a polynomial's terms at a distance from the origin: rounding is in proportion to it.
const termsAt = (c, size) => c.reduceRight((sum, v) => sum * size + Math.abs(v), 0);

// Gains where two branches meet: double roots of D + k N, that is N D' - D N' = 0. A multiple open-loop pole is met at the
// gain 0, not at the rounding of D there: with a zero on it too, D/N would be a gain of any size.
export function breakAways({ D, N }) {
  const P = trimmed(N);
  if (P.length === 0) return [];
  const meeting = roots(subtract(multiply(P, derivative(D)), multiply(D, derivative(P))));
  return meeting.x.flatMap((x, i) => {
    const y = meeting.y[i];
    const [dx, dy] = evaluate(D, x, y);
    if (Math.hypot(dx, dy) <= 100 * D.length * EPS * termsAt(D, Math.hypot(x, y)))
      return y >= 0 ? [{ gain: 0, x, y }] : [];
    const [nx, ny] = evaluate(P, x, y);
    const size = nx * nx + ny * ny;
    const gain = -(dx * nx + dy * ny) / size;
    const real = Math.abs(dy * nx - dx * ny) / size <= 1e-7 * Math.abs(gain);
    return real && y >= 0 ? [{ gain, x, y }] : [];
  });
}

// Even (first = 0) or odd part on the imaginary axis, in w^2: c(jw) = even + j w odd.
const parts = (c, first) =>
  Float64Array.from({ length: (c.length - first + 1) >> 1 }, (_, k) => c[2 * k + first] * (-1) ** k);

const sum = (a, b) =>
  subtract(
    a,
    b.map((v) => -v),
  );

// Gains at which a branch crosses the imaginary axis: D/N is real at s = jw. With even and odd parts in u = w^2 that is
// D_odd N_even = D_even N_odd, or w = 0.
export function crossings({ D, N }) {
  if (N.every((v) => v === 0)) return [];
  // A root that stays at the origin hides another one that passes it.
  if (D[0] === 0 && N[0] === 0) return crossings({ D: D.slice(1), N: N.slice(1) });
  const [De, Do, Ne, No] = [parts(D, 0), parts(D, 1), parts(N, 0), parts(N, 1)];
  const u = roots(subtract(multiply(Do, Ne), multiply(De, No)));
  const squares = u.x.filter((x, i) => x > 0 && Math.abs(u.y[i]) <= 1e-9 * x);
  return [0, ...squares.map(Math.sqrt)].flatMap((omega) => {
    const [dx, dy] = evaluate(D, 0, omega);
    const [nx, ny] = evaluate(N, 0, omega);
    const gain = -(dx * nx + dy * ny) / (nx * nx + ny * ny);
    if (!Number.isFinite(gain) || gain === 0) return [];
    const [sx, sy] = evaluate(
      subtract(
        derivative(D),
        derivative(N).map((v) => -gain * v),
      ),
      0,
      omega,
    );
    return [{ gain, omega, direction: -Math.sign(nx * sx + ny * sy) }];
  });
}

// Plain loops from here on: they run thousands of times in a frame.
function permuted({ t, x, y }, partner) {
  const moved = { t, x: x.slice(), y: y.slice() };
  for (let i = 0; i < x.length; i++) {
    moved.x[i] = x[partner[i]];
    moved.y[i] = y[partner[i]];
  }
  return moved;
}

const real = ({ x, y }, i) => Math.abs(y[i]) <= 1e-6 * Math.abs(x[i]);

const flat = (x, y, i) => Math.abs(y[i]) <= 1e-10 * Math.abs(x[i]);
const twin = (x, y, i, j) =>
  y[i] * y[j] < 0 &&
  Math.abs(y[i] + y[j]) < 1e-6 * Math.abs(y[i]) &&
  Math.hypot(x[i] - x[j], y[i] + y[j]) < 1e-6 * Math.abs(y[i]);

// A root that moves by less than a third of the distance to the next one is not taken for it.
const NEAR = 0.1;
const DEEPEST = 28;

let made = 0;

// A point of a trace: the roots, and for each root the square of the distance to the next one, infinite where two coincide.
function pointOf(t, x, y) {
  const n = x.length;
  const gap = x.slice(); // arrays made by slice are several times cheaper here than new Float64Arrays
  gap.fill(Infinity);
  for (let i = 0; i < n; i++) {
    for (let j = 0; j < i; j++) {
      const dx = x[i] - x[j];
      const dy = y[i] - y[j];
      const d = dx * dx + dy * dy;
      if (d < gap[i]) gap[i] = d;
      if (d < gap[j]) gap[j] = d;
    }
  }
  let apart = true;
  for (let i = 0; i < n; i++) {
    if (gap[i] > 1e-10 * (x[i] * x[i] + y[i] * y[i])) continue;
    gap[i] = Infinity;
    apart = false;
  }
  // kx, ky: as x, y, but of roots that coincide where each came from; turns: how often the order has changed; follows: which
  // point it was put in order after (by number: points that held each other would all stay), and how that stood then.
  return {
    t,
    x,
    y,
    gap,
    apart,
    kx: x,
    ky: y,
    clear: false,
    far: false,
    turns: 0,
    number: made++,
    follows: -1,
    seen: 0,
  };
}

// Follows all roots along a curve { fill(t, c), middle(a, b), breaks } from one value of t to another, halving each step
// until the drawn polyline is within `tolerance` pixels of the curve and no root moves so far that it could be taken for
// another. view: { left, right, top, scale (pixels per 1/s), tolerance }, or BLIND where only the names matter.
function tracer(curve, n, view) {
  const c = new Float64Array(n + 1);
  const partner = new Int32Array(n);
  const spare = new Float64Array(n);
  const { left, right, top, scale, tolerance } = view;
  const worst = (tolerance / scale) ** 2;
  const long = (8 / scale) ** 2;
  let points;

  // Aberth keeps real points real, so they start a little off the axis to be able to leave it.
  function solve(t, a, b, atBreak) {
    const x = a.x.slice();
    const y = a.y.slice();
    for (let i = 0; i < n; i++) {
      x[i] = (a.x[i] + b.x[i]) / 2;
      y[i] = (a.y[i] + b.y[i]) / 2 + (i % 2 ? 1e-8 : -1.3e-8) * (Math.abs(x[i]) + 1e-9);
    }
    curve.fill(t, c);
    refine(c, n, x, y, 1e-3);
    settle(x, y);
    anchor(c, x, y);
    if (atBreak) meet(t, x, y);
    return pointOf(t, x, y);
  }

  // At a break-away the roots that meet there are known better than they can be found.
  function meet(t, px, py) {
    for (const { gain, x, y } of curve.breaks ?? []) {
      if (gain !== t) continue;
      for (const at of y === 0 ? [0] : [y, -y]) {
        const off = px.map((v, i) => Math.hypot(v - x, py[i] - at));
        for (let k = 0; k < 2; k++) {
          const i = off.indexOf(Math.min(...off));
          [px[i], py[i], off[i]] = [x, at, Infinity];
        }
      }
    }
  }

  function turn(values) {
    for (let i = 0; i < n; i++) spare[i] = values[i];
    for (let i = 0; i < n; i++) values[i] = spare[partner[i]];
  }

  // Puts a point's roots in the order of the point before. Two that coincide can't tell which is which: the next
  // point then asks where they came from.
  function order(before, point) {
    if (point.follows === before.number && point.seen === before.turns) return;
    point.follows = before.number;
    point.seen = before.turns;
    compare(before, point);
    if (!point.clear) {
      pairing(before.kx, before.ky, point.x, point.y, partner);
      meeting(before, point);
      let moved = false;
      for (let i = 0; i < n; i++) moved ||= partner[i] !== i;
      if (moved) {
        turn(point.x);
        turn(point.y);
        turn(point.gap);
        point.turns++;
        compare(before, point);
        point.clear = false;
      }
    }
    if (!point.apart) keep(point, before);
  }

  // Where two branches meet on the real axis both pairings are equally near. The right one of two real roots is the upper one
  // of a pair and the other way round, so that a step over both a meeting and a parting finds them in the same order.
  function meeting({ kx, ky }, { x, y }) {
    for (let i = 0; i < n; i++) {
      for (let j = i + 1; j < n; j++) {
        const [p, q] = [partner[i], partner[j]];
        const forms = flat(kx, ky, i) && flat(kx, ky, j) && twin(x, y, p, q);
        const parts = flat(x, y, p) && flat(x, y, q) && twin(kx, ky, i, j);
        if ((forms && kx[i] > kx[j] !== y[p] > y[q]) || (parts && ky[i] > ky[j] !== x[p] > x[q])) {
          [partner[i], partner[j]] = [q, p];
        }
      }
    }
  }

  // Clear: each root moves little beside the distance to the next one, and no other pairing can be nearer. Far: one doesn't.
  function compare(before, point) {
    const { x, y } = point;
    point.far = false;
    point.clear = before.apart;
    for (let i = 0; i < n; i++) {
      const dx = x[i] - before.x[i];
      const dy = y[i] - before.y[i];
      if (dx * dx + dy * dy <= NEAR * before.gap[i]) continue;
      point.far = true;
      point.clear = false;
      return;
    }
  }

  function keep(point, before) {
    const { x, y, gap } = point;
    [point.kx, point.ky] = [x.slice(), y.slice()];
    for (let i = 0; i < n; i++)
      if (gap[i] === Infinity) [point.kx[i], point.ky[i]] = [before.kx[i], before.ky[i]];
  }

  function rough(a, m, b, depth) {
    if (depth < 16 && (m.far || b.far)) return true;
    for (let i = 0; i < n; i++) {
      const bx = b.x[i] - a.x[i];
      const by = b.y[i] - a.y[i];
      const move = bx * bx + by * by;
      // Between two nodes no root leaves the real axis or comes to it, other than at the nodes themselves.
      const corner = a.gap[i] !== Infinity && b.gap[i] !== Infinity && real(a, i) !== real(b, i);
      if (corner && (depth < 16 || move > worst)) return true;
      if (Math.max(a.x[i], m.x[i], b.x[i]) < left || Math.min(a.x[i], m.x[i], b.x[i]) > right) continue;
      if (Math.min(Math.abs(a.y[i]), Math.abs(m.y[i]), Math.abs(b.y[i])) > top) continue;
      const mx = m.x[i] - a.x[i];
      const my = m.y[i] - a.y[i];
      const part = move > 0 ? Math.max(0, Math.min(1, (bx * mx + by * my) / move)) : 0;
      const offX = mx - part * bx;
      const offY = my - part * by;
      if (offX * offX + offY * offY > worst) return true;
      // Far from halfway along: the speed changes as beside a break-away, and the middle says little of the rest.
      if (Math.abs(part - 0.5) > 0.15 && move > long) return true;
    }
    return false;
  }

  // Nothing that is seen moves: each root less than the tolerance, or farther off the window than it moves.
  function still(a, b) {
    for (let i = 0; i < n; i++) {
      const dx = b.x[i] - a.x[i];
      const dy = b.y[i] - a.y[i];
      const move = Math.sqrt(dx * dx + dy * dy);
      if (move * scale <= tolerance) continue;
      const off = Math.max(
        left - Math.max(a.x[i], b.x[i]),
        Math.min(a.x[i], b.x[i]) - right,
        Math.min(Math.abs(a.y[i]), Math.abs(b.y[i])) - top,
      );
      if (move > off) return false;
    }
    return true;
  }

  function segment(a, b, depth) {
    order(a, b); // a may have changed its order since
    if (b.clear && still(a, b)) {
      points.push(b);
      return;
    }
    const m = solve(curve.middle(a.t, b.t), a, b, false);
    order(a, m);
    order(m, b);
    if (depth < DEEPEST && rough(a, m, b, depth)) {
      segment(a, m, depth + 1);
      segment(m, b, depth + 1);
    } else points.push(m, b);
  }

  // The points from a to the value t, the last one there.
  return (a, t) => {
    points = [];
    segment(a, solve(t, a, a, true), 0);
    return points;
  };
}

// Traces t over the nodes, a stretch at each step; at last returns the points { t, x, y }, whose branches are in the order
// of start: { x, y } at the first node. Traced back, a curve has the same branches as on its way forth.
export function* tracing(curve, nodes, start, view) {
  const to = tracer(curve, start.x.length, view);
  const points = [pointOf(nodes[0], [...start.x], [...start.y])];
  for (const t of nodes.slice(1)) {
    for (const point of to(points.at(-1), t)) points.push(point);
    yield;
  }
  return points;
}

// Runs to the end what goes step by step.
export function finished(steps) {
  let step = steps.next();
  while (!step.done) step = steps.next();
  return step.value;
}

export const trace = (curve, nodes, start, view) => finished(tracing(curve, nodes, start, view));

const BLIND = { left: Infinity, right: -Infinity, top: -Infinity, scale: 1, tolerance: Infinity };

// The roots of the curve at t beside a guess, in its order, to the last digits.
function pointBeside(curve, t, guess) {
  const n = guess.x.length;
  const x = guess.x.slice();
  const y = guess.y.map((v, i) => v + (i % 2 ? 1e-8 : -1.3e-8) * Math.abs(x[i]));
  const c = new Float64Array(n + 1);
  curve.fill(t, c);
  refine(c, n, x, y);
  flatten(x, y);
  anchor(c, x, y);
  return permuted({ t, x, y }, pairing(guess.x, guess.y, x, y, new Int32Array(n)));
}

// The roots at one value of t inside a traced curve, in the order of its branches.
function pointAt(curve, points, t) {
  const next = Math.max(
    1,
    points.findIndex((p, i) => i > 0 && (p.t - t) * (points[i - 1].t - t) <= 0),
  );
  const [a, b] = [points[next - 1], points[next]];
  const part = a.t === b.t ? 0 : (t - a.t) / (b.t - a.t);
  const between = (k) => a[k].map((v, i) => v + part * (b[k][i] - v));
  return pointBeside(curve, t, { x: between('x'), y: between('y') });
}

const gainCurve = ({ D, N }, sign, breaks) => ({
  breaks,
  fill(t, c) {
    for (let k = 0; k < c.length; k++) c[k] = D[k] + t * N[k];
  },
  middle: (a, b) => (a === 0 || b === 0 ? (a + b) / 2 : sign * Math.sqrt(a * b)),
});

// Gains at which a trace stops in any case, in rising size: from 0 by thirds of a decade, and where branches meet.
function gainNodes([first, most], breaks) {
  const steps = Math.round(3 * Math.log10(most / first));
  const regular = Array.from({ length: steps + 1 }, (_, i) => first * (most / first) ** (i / steps));
  return [...new Set([0, ...regular, ...breaks])].sort((a, b) => a - b);
}

// The roots as one gain rises from 0, of one sign: traced as far as asked, and kept.
function pathOf(system, state, running, sign, start) {
  return once(system, `path ${running} ${sign} ${placesOf(system, { ...state, [running]: 0 })}`, () => {
    const loop = loopOf(system, state, { running });
    const breaks = loop.breaks.filter((b) => b.gain * sign > 0);
    const nodes = gainNodes(
      system.running[running].magnitudes,
      breaks.map((b) => b.gain * sign),
    );
    const curve = gainCurve(loop, sign, breaks);
    const to = tracer(curve, start.x.length, BLIND);
    const points = [pointOf(0, [...start.x], [...start.y])];
    return (gain) => {
      const before = nodes.filter((size) => size < Math.abs(gain));
      while (points.length < before.length)
        points.push(to(points.at(-1), sign * nodes[points.length]).at(-1));
      return pointBeside(curve, gain, to(points[before.length - 1], gain).at(-1));
    };
  });
}

// The closed-loop poles { x, y, branches }, each with the name of the open-loop pole that it grows out of as the loops are
// closed one after the other, in the report's order.
export function closedLoop(system, state) {
  return once(system, `poles ${placesOf(system, state)}`, () => {
    const poles = namedPoles(system, state);
    let now = withoutGains(state, system.closing);
    for (const running of system.closing) {
      const gain = state[running];
      if (gain === 0) continue;
      const end = pathOf(system, now, running, Math.sign(gain), poles)(gain);
      [poles.x, poles.y] = [end.x, end.y];
      now = { ...now, [running]: gain };
    }
    return poles;
  });
}

// The parameter that runs as a curve of roots, its nodes on both sides of the present value, and what marks it.
function runningCurve(system, state, what) {
  return system.running[what.running].magnitudes
    ? runningGain(system, state, what)
    : runningStation(system, state, what.running);
}

function runningGain(system, state, what) {
  const t = state[what.running];
  const sign = t < 0 ? -1 : 1;
  const { magnitudes } = system.running[what.running];
  const last = Math.max(magnitudes[1], Math.abs(t));
  const loop = loopOf(system, state, what);
  const within = ({ gain: k }) => k * sign > 0 && k * sign < last;
  const breaks = loop.breaks.filter(within);
  const inside = gainNodes(
    magnitudes,
    breaks.map((b) => b.gain * sign),
  ).filter((size) => size < last);
  const nodes = [...inside, last];
  const before = nodes.filter((size) => size < t * sign).map((size) => size * sign);
  return {
    kind: 'gain',
    curve: gainCurve(loop, sign, breaks),
    from: 0,
    end: sign * last,
    back: [t, ...before.reverse()],
    forth: [t, ...nodes.filter((size) => size > t * sign).map((size) => size * sign)],
    zeros: loop.zeros(),
    breaks,
    crossings: () =>
      loop
        .crossings()
        .filter(within)
        .map((c) => ({ ...c, direction: sign * c.direction })), // as its size rises
  };
}

function runningStation(system, state, station) {
  const { ends, step } = system.running[station];
  const off = leftOut(system, state);
  const free = Object.keys(system.shapes).filter((f) => system.shapes[f].at === station && !off.includes(f));
  const table = collapse(system.terms, factorsOf(system, state), free);
  const shape = {};
  const curve = {
    fill(t, c) {
      for (const f of free) shape[f] = along(system.shapes[f].values, t);
      fill(table, shape, c);
    },
    middle: (a, b) => (a + b) / 2,
  };
  const t = state[station];
  const inner = [];
  for (let at = Math.ceil(ends[0] / step) * step; at <= ends[1]; at += step) inner.push(at);
  const nodes = [...new Set([ends[0], ...inner, ends[1]])];
  return {
    kind: 'station',
    curve,
    from: ends[0],
    end: ends[1],
    back: [t, ...nodes.filter((at) => at < t).reverse()],
    forth: [t, ...nodes.filter((at) => at > t)],
    idle: free.length === 0,
    zeros: { x: [], y: [] },
    breaks: [],
    crossings: (branches) => axisCrossings(curve, branches),
  };
}

// Where traced branches cross the imaginary axis, by false position between two points (Illinois: the end that stays
// counts half). Where a root stays at the origin, another that passes it there is told by the next coefficient's sign.
function axisCrossings(curve, points) {
  const c = new Float64Array(points[0].x.length + 1);
  const next = (t) => {
    curve.fill(t, c);
    return c[0] === 0 ? c[1] : NaN;
  };
  return points.slice(1).flatMap((b, k) => {
    const a = points[k];
    const found = throughOrigin(next, a.t, b.t, c);
    const anchored = !Number.isNaN(next(b.t));
    for (let i = 0; i < a.x.length; i++) {
      if (a.x[i] * b.x[i] >= 0 || Math.max(Math.abs(a.x[i]), Math.abs(b.x[i])) < 1e-9) continue;
      const m = crossingOf(curve, a, b, i);
      // Of a pair the upper root tells of both.
      if (m.y[i] < -1e-12 || (anchored && m.y[i] < 1e-9)) continue;
      found.push({ gain: m.t, omega: Math.max(0, m.y[i]), direction: Math.sign(b.x[i] - a.x[i]) });
    }
    return found;
  });
}

function throughOrigin(next, from, to, c) {
  let [low, high] = [from, to];
  const [first, last] = [next(low), next(high)];
  if (!(first * last < 0)) return [];
  const direction = Math.sign((first - last) / c[2]);
  for (let turn = 0; turn < 50; turn++) {
    const t = (low + high) / 2;
    if (next(t) * first > 0) low = t;
    else high = t;
  }
  return [{ gain: high, omega: 0, direction }];
}

function crossingOf(curve, a, b, i) {
  let [low, high, m] = [a, b, b];
  let [left, right] = [a.x[i], b.x[i]];
  for (
    let turn = 0;
    turn < 60 && Math.abs(m.x[i]) > 1e-12 * Math.hypot(m.x[i], m.y[i]) && high.t - low.t > 1e-12 * high.t;
    turn++
  ) {
    m = pointAt(curve, [low, high], low.t + ((high.t - low.t) * left) / (left - right));
    if (m.x[i] * right > 0) [high, right, left] = [m, m.x[i], left / 2];
    else [low, left, right] = [m, m.x[i], right / 2];
  }
  return m;
}

function* tracedBothWays({ curve, back, forth }, start, view) {
  return [yield* tracing(curve, back, start, view), yield* tracing(curve, forth, start, view)];
}

// The locus of any parameter: { running, off, of, gain }. A gain runs from 0 to the end of its range, on the side of its
// sign; a station from the nose to the tail. Each branch has the name of the present pole on it.
export function rootLocus(system, state, view, what = lastLoop(system)) {
  const running = runningCurve(system, state, what);
  const { kind, curve, from, end, zeros, breaks } = running;
  const start = presentRoots(system, state, what, curve);
  const [back, forth] = finished(tracedBothWays(running, start, view));
  const branches = [...back.slice(1).reverse(), ...forth];
  const { x, y } = branches[0];
  return {
    kind,
    from,
    end,
    open: { x, y, branches: start.branches },
    zeros,
    breaks,
    crossings: running.crossings(branches),
    branches,
    names: start.branches,
    present: { t: state[what.running], x: start.x, y: start.y },
  };
}

// The roots at the present value: the named poles, or the zeros, which have no names of their own.
function presentRoots(system, state, what, curve) {
  const { running, off, of } = what;
  if (of !== 'zeros') return closedLoop(system, withoutGains(state, off));
  const c = new Float64Array(loopOf(system, state, what).D.length);
  curve.fill(state[running], c);
  const { x, y } = roots(c);
  return { x, y, branches: x.map(() => 'zero') };
}

// The closed-loop poles at the present gains as a station runs over its range, step by step: from the present one both ways,
// so that a branch is the one that the locus calls so. Empty at last where the feedback makes no use of it.
export function* poleMapping(system, state, present, view, station = system.maps[0]) {
  const running = runningStation(system, state, station);
  return running.idle ? [] : yield* tracedBothWays(running, present, view);
}

export const poleMap = (...given) => finished(poleMapping(...given));

// The value of the running parameter at which a branch of a locus comes nearest to a point: the nearest place on the drawn
// line first, then golden section on the curve itself.
export function gainAt(system, state, what, branch, x, y, locus) {
  const points = locus.branches;
  const distance = (p) => Math.hypot(p.x[branch] - x, p.y[branch] - y);
  let best = 0;
  let least = Infinity;
  for (let k = 1; k < points.length; k++) {
    const [a, b] = [points[k - 1], points[k]];
    const [dx, dy] = [b.x[branch] - a.x[branch], b.y[branch] - a.y[branch]];
    const [ex, ey] = [x - a.x[branch], y - a.y[branch]];
    const part = Math.max(0, Math.min(1, (ex * dx + ey * dy) / (dx * dx + dy * dy || 1)));
    const off = Math.hypot(ex - part * dx, ey - part * dy);
    if (off < least) [least, best] = [off, part < 0.5 ? k - 1 : k];
  }
  const { curve } = runningCurve(system, state, what);
  let low = points[Math.max(0, best - 1)];
  let high = points[Math.min(points.length - 1, best + 1)];
  const at = (share) => pointAt(curve, points, low.t + share * (high.t - low.t));
  const GOLDEN = (Math.sqrt(5) - 1) / 2;
  let [first, second] = [at(1 - GOLDEN), at(GOLDEN)];
  while (Math.abs(high.t - low.t) > 1e-9 * Math.max(Math.abs(low.t), Math.abs(high.t))) {
    if (distance(first) <= distance(second)) [high, second, first] = [second, first, null];
    else [low, first, second] = [first, second, null];
    first ??= at(1 - GOLDEN);
    second ??= at(GOLDEN);
  }
  return [low, first, second, high].reduce((p, q) => (distance(q) < distance(p) ? q : p)).t;
}

const decibels = (factor) => 20 * Math.log10(factor);

// Gain and phase margins of the loop that is drawn, k N/D at the present gain: by which factor the gain may change before a
// root crosses the axis, how far the phase is from -180 degrees where the loop's size is 1, and the delay (s) that would use
// it up. null where nothing is fed back.
export function margins(system, state, what = lastLoop(system)) {
  if (!system.running[what.running].magnitudes || what.of === 'zeros') return null;
  const { D, N, crossings: crossed } = loopOf(system, state, what);
  const k = state[what.running];
  if (k === 0 || N.every((v) => v === 0)) return null;
  const gain = crossed()
    .map((c) => ({ factor: c.gain / k, dB: decibels(c.gain / k), omega: c.omega }))
    .filter(({ factor }) => factor > 0);
  const square = (c) => {
    const [even, odd] = [parts(c, 0), parts(c, 1)];
    return sum(multiply(even, even), Float64Array.of(0, ...multiply(odd, odd)));
  };
  const u = roots(
    subtract(
      square(D),
      square(N).map((v) => k * k * v),
    ),
  );
  const phase = Array.from(u.x.keys())
    .filter((i) => u.x[i] > 0 && Math.abs(u.y[i]) <= 1e-9 * u.x[i])
    .map((i) => {
      const omega = Math.sqrt(u.x[i]);
      const [dx, dy] = evaluate(D, 0, omega);
      const [nx, ny] = evaluate(N, 0, omega);
      const degrees = (Math.atan2(-k * (ny * dx - nx * dy), -k * (nx * dx + ny * dy)) * 180) / Math.PI;
      return { degrees, omega, delay: (((degrees + 360) % 360) * Math.PI) / 180 / omega };
    });
  const byOmega = (a, b) => a.omega - b.omega;
  return { gain: gain.sort(byOmega), phase: phase.sort(byOmega) };
}

// The closed-loop poles alone, unordered: to choose the window before anything is traced.
export const closedLoopPoles = (system, state) => roots(polynomialOf(system, state));
