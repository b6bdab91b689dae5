// The vehicle without control: poles from the two tables that Python sends, as the coupling or a slider runs.
import { trace } from '../maths/tracing.js';
import { roots } from '../maths/aberth.js';
import { matchRoots } from '../maths/match_roots.js';
import { element, set } from '../page/dom.js';
import { Table, legend, mount, number, plane } from '../page/live_view.js';
import { Plot } from '../drawing/plot.js';
import { initialize } from '../page/sliders.js';

const MARKS = { 'short period': '^', 'mode 1': 's', 'mode 2': 'd', attitude: 'o' };
const SIGNS = { 'short period': '▲', 'mode 1': '■', 'mode 2': '◆', attitude: '●' };
const NAMES = {
  coupling: 'the coupling',
  omega_1: 'ω₁',
  omega_2: 'ω₂',
  q_D: 'qD',
  C_payload: 'the payload’s CNα (1/rad)',
  C_fins: 'the fins’ CNα (1/rad)',
  l_payload: 'the payload’s station',
  l_fins: 'the fins’ station',
};
const LADDER = [1, 1.25, 1.6, 2, 2.5, 3.2, 4, 5, 6.4, 8, 10];

// The table has one value a foot; between two of them the picture takes the straight line.
function along(values, station) {
  const left = Math.max(0, Math.min(Math.floor(station), values.length - 2));
  return values[left] + (station - left) * (values[left + 1] - values[left]);
}

function place(payload, factors, surface) {
  for (const [name, values] of Object.entries(payload.shapes))
    factors[`${name}_${surface}`] = along(values, factors[`l_${surface}`]);
}

function factorsOf(payload, state) {
  const factors = { coupling: 1, ...state };
  for (const surface of payload.surfaces) place(payload, factors, surface);
  return factors;
}

// Tables of sums of products, with numbers in place of names: they are summed thousands of times in a frame.
const compiled = new WeakMap();

function tablesOf(payload) {
  if (!compiled.has(payload)) {
    const names = Object.keys(payload.coefficients);
    const factors = [
      ...new Set(Object.values(payload.coefficients).flatMap((products) => products.flatMap(([, of]) => of))),
    ];
    const coefficients = Object.values(payload.coefficients).map((products) =>
      products
        .filter(([weight]) => weight !== 0)
        .map(([weight, of]) => [weight, of.map((name) => factors.indexOf(name))]),
    );
    const indexed = (table) =>
      table.map(([weight, power, of]) => [weight, power, of.map((name) => names.indexOf(name))]);
    const blocks = Object.entries(payload.blocks).map(([name, table]) => [name, indexed(table)]);
    compiled.set(payload, { factors, coefficients, determinant: indexed(payload.determinant), blocks });
  }
  return compiled.get(payload);
}

function coefficientsOf({ factors, coefficients }, values, found) {
  const given = factors.map((name) => values[name]);
  for (let n = 0; n < coefficients.length; n++) {
    let sum = 0;
    for (const [weight, of] of coefficients[n]) {
      let value = weight;
      for (let k = 0; k < of.length; k++) value *= given[of[k]];
      sum += value;
    }
    found[n] = sum;
  }
  return found;
}

function polynomial(table, coefficients, c) {
  c.fill(0);
  for (const [weight, power, of] of table) {
    let value = weight;
    for (let k = 0; k < of.length; k++) value *= coefficients[of[k]];
    c[power] += value;
  }
  return c;
}

// The whole vehicle's, without the attitude's root at the origin.
function fill(payload, factors, room, c) {
  const tables = tablesOf(payload);
  polynomial(tables.determinant, coefficientsOf(tables, factors, room.found), room.whole);
  for (let k = 0; k < c.length; k++) c[k] = room.whole[k + 1];
}

const room = () => ({ found: new Float64Array(24), whole: new Float64Array(8) });

export function poles(payload, state) {
  const c = new Float64Array(7);
  fill(payload, factorsOf(payload, state), room(), c);
  return roots(c);
}

// The poles that each motion would have by itself, with its name.
function uncoupled(payload, state) {
  const tables = tablesOf(payload);
  const coefficients = coefficientsOf(tables, factorsOf(payload, state), new Float64Array(24));
  const found = { x: [], y: [], names: [] };
  for (const [name, table] of tables.blocks) {
    const order = Math.max(...table.map(([, power]) => power));
    const c = polynomial(table, coefficients, new Float64Array(order + 1));
    const { x, y } = roots(name === 'short period' ? c.slice(1) : c);
    found.x.push(...x);
    found.y.push(...y);
    found.names.push(...x.map(() => name));
  }
  return found;
}

function curve(payload, state, running) {
  const factors = factorsOf(payload, state);
  const own = room();
  const surface = payload.surfaces.find((name) => `l_${name}` === running);
  return {
    fill(t, c) {
      factors[running] = t;
      if (surface) place(payload, factors, surface);
      fill(payload, factors, own, c);
    },
    middle: (a, b) => (a + b) / 2,
  };
}

const nodes = (from, to, count) =>
  Array.from({ length: count + 1 }, (_, k) => from + ((to - from) * k) / count);

// Paths of the poles: while the coupling rises from nothing to all, and while the chosen parameter runs from where it
// is to both ends of its slider. The names are those of the motions that the poles grow out of.
export function paths(payload, state, view) {
  const start = uncoupled(payload, state);
  const rising = trace(curve(payload, state, 'coupling'), nodes(0, 1, 16), start, view);
  const end = rising.at(-1);
  const exact = poles(payload, state);
  const partner = matchRoots(end.x, end.y, exact.x, exact.y, new Int32Array(6));
  const present = { x: Array.from(partner, (p) => exact.x[p]), y: Array.from(partner, (p) => exact.y[p]) };
  if (state.running === 'coupling') return { start, present, names: start.names, runs: [rising] };
  const { grid } = payload.parameters.find(({ name }) => name === state.running);
  const here = state[state.running];
  const moving = curve(payload, state, state.running);
  const runs = [grid[0], grid.at(-1)]
    .filter((to) => to !== here)
    .map((to) => trace(moving, nodes(here, to, 16), present, view));
  return { start, present, names: start.names, runs };
}

function ladder(value) {
  const decade = 10 ** Math.floor(Math.log10(value));
  return decade * LADDER.find((rung) => rung * decade >= value * (1 - 1e-12));
}

// The window holds all poles where they start and where they are, its borders on a ladder: it stands still meanwhile.
function windowOf(points, canvas) {
  const reach = (values, least) => ladder(Math.max(1.12 * values.reduce((a, b) => Math.max(a, b), 0), least));
  const x = points.flatMap((p) => [...p.x]);
  const y = points.flatMap((p) => [...p.y]);
  const side = Math.max(
    reach(x, 0.4),
    reach(
      x.map((v) => -v),
      0.4,
    ),
  );
  const range = { x: [-side, side], y: [-0.05, 1].map((share) => share * reach(y, 0.4)) };
  const scale = Math.max(canvas.clientWidth / (2 * side), canvas.clientHeight / range.y[1]);
  return { range, view: { left: -side, right: side, top: range.y[1], scale, tolerance: 0.3 } };
}

function picture(canvas, theme, range, { start, present, names, runs }, isCoupling) {
  const plot = new Plot(canvas, theme, { ...range, xLabel: 'Re s (1/s)', yLabel: 'Im s (1/s)' }).axes();
  plot.g.fillStyle = theme.unstable;
  plot.g.fillRect(plot.X(0), 0, plot.width, plot.Y(range.y[0]));
  plot.line(
    [
      [0, range.y[0]],
      [0, range.y[1]],
    ],
    theme.axis,
    1.5,
  );
  plot.line(
    [
      [range.x[0], 0],
      [range.x[1], 0],
    ],
    theme.axis,
    1,
  );
  names.forEach((name, i) => {
    for (const run of runs) {
      const points = run.map((p) => [p.x[i], Math.abs(p.y[i])]);
      plot.line(points, theme[name], 2);
      if (!isCoupling) continue;
      const k = points.length >> 1;
      const [a, b] = [points[Math.max(0, k - 1)], points[Math.min(points.length - 1, k + 1)]];
      const [ax, ay, bx, by] = [plot.X(a[0]), plot.Y(a[1]), plot.X(b[0]), plot.Y(b[1])];
      const size = Math.hypot(bx - ax, by - ay);
      if (size > 0.5)
        plot.arrow(bx - (9 * (bx - ax)) / size, by - (9 * (by - ay)) / size, bx, by, theme[name], 2);
    }
  });
  plot.mark('o', 0, 0, theme.attitude, 4);
  names.forEach((name, i) => {
    plot.mark('x', start.x[i], Math.abs(start.y[i]), theme[name], 5);
    plot.mark(MARKS[name], present.x[i], Math.abs(present.y[i]), theme[name]);
  });
  plot.finish();
}

// In words: what grows, and how fast.
function verdict(found) {
  const upper = found.filter(({ im, name }) => im >= 0 && name !== 'attitude').sort((a, b) => b.re - a.re);
  const [worst] = upper;
  const kind = worst.im
    ? `pair at ${number(worst.re)} ± ${number(worst.im)}j 1/s`
    : `real root at ${number(worst.re)} 1/s`;
  const from = ` (from ${worst.name})`;
  if (worst.re > 0)
    return [
      'Unstable',
      `: the ${kind}${from} doubles its motion every ${number(Math.LN2 / worst.re, 3)} s.`,
      'unstable',
    ];
  if (worst.re === 0)
    return ['Neutral', `: beside the attitude the ${kind}${from} neither grows nor decays.`, 'neutral'];
  return [
    'No divergence',
    `: but for the attitude, which nothing restores, all roots decay; the slowest, the ${kind}${from}, halves its motion every ${number(-Math.LN2 / worst.re, 3)} s.`,
    'stable',
  ];
}

const digits = (value) =>
  value === 0 ? '0' : Math.abs(value) < 1e-3 ? value.toExponential(7) : value.toPrecision(8);

function render({ model, el }) {
  const payload = model.get('payload');
  const what = element('span');
  const { canvas, figure } = plane('paths', [element('b', {}, 'Poles of the vehicle'), what]);
  const word = element('b');
  const reason = element('span');
  const table = new Table(
    'Poles of the vehicle without control',
    ['grows out of', 'real (1/s)', 'imaginary (1/s)', 'ω (rad/s)', 'ζ', 'stability'],
    'poles',
  );
  const signs = legend([
    ['×', 'each motion by itself'],
    ...Object.entries(SIGNS).map(([name, sign]) => [sign, name]),
  ]);

  function draw(state, theme) {
    const range = windowOf([uncoupled(payload, state), poles(payload, state)], canvas);
    const found = paths(payload, state, range.view);
    const isCoupling = state.running === 'coupling';
    picture(canvas, theme, range.range, found, isCoupling);
    const list = [
      { re: 0, im: 0, name: 'attitude' },
      ...found.names.map((name, i) => ({ re: found.present.x[i], im: found.present.y[i], name })),
    ];
    const [status, why, kind] = verdict(list);
    set(word, status);
    set(reason, why);
    word.className = kind;
    const { grid, unit } = payload.parameters.find(({ name }) => name === state.running) ?? {};
    set(
      what,
      isCoupling
        ? ' while the coupling rises from nothing to all'
        : ` while ${NAMES[state.running] ?? state.running} runs from ${number(grid[0])} to ${number(grid.at(-1))} ${unit}`,
    );
    table.show(
      list.map(({ re, im, name }) => {
        const size = Math.hypot(re, im);
        const said = re > 0 ? 'unstable' : re < 0 ? 'stable' : 'neutrally stable';
        return {
          cells: [
            `${SIGNS[name]} ${name}`,
            digits(re),
            digits(im),
            digits(size),
            size ? digits(-re / size) : '–',
            said,
          ],
          data: { re, im, branch: name },
          kind: re > 0 ? 'unstable' : 'stable',
        };
      }),
    );
    canvas.setAttribute(
      'aria-label',
      `Poles of the vehicle without control${what.textContent}. ${status}${why}`,
    );
    return `${status}${why}`;
  }
  const nodesOfView = [element('p', { class: 'verdict' }, word, reason), figure, signs, table.node];
  return mount({ model, el }, { nodes: nodesOfView, canvases: [canvas], draw });
}

export default { initialize, render };
