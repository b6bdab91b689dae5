// The ascent: straight lines between flights that Python has integrated.
import { element, set } from '../page/dom.js';
import { Table, legend, mount, number, plane, signed } from '../page/live_view.js';
import { Plot } from '../drawing/plot.js';
import { initialize } from '../page/sliders.js';

const PANELS = {
  q_D: ['dynamic pressure q', 'D', 'lb/ft²'],
  h: ['altitude h', '', 'ft'],
  U: ['speed U', '', 'ft/s'],
};

// Neighbors in a list of nodes, and their shares.
function shares(nodes, value) {
  const last = nodes.length - 2;
  const at = Math.max(
    0,
    Math.min(
      last,
      nodes.findLastIndex((node) => node <= value),
    ),
  );
  return [at, (value - nodes[at]) / (nodes[at + 1] - nodes[at])];
}

const mixed = (a, b, share) => a.map((v, k) => v + share * (b[k] - v));

// A table's row for the present program.
function rowOf(table, { nodes }, state) {
  const [i, p] = shares(nodes.upright, state.upright);
  const [k, q] = shares(nodes.level, state.level);
  return mixed(mixed(table[i][k], table[i][k + 1], q), mixed(table[i + 1][k], table[i + 1][k + 1], q), p);
}

function at(times, values, t) {
  const [k, share] = shares(times, t);
  return values[k] + share * (values[k + 1] - values[k]);
}

export function flight(payload, state) {
  const curves = Object.fromEntries(
    Object.keys(PANELS).map((name) => [name, rowOf(payload.curves[name], payload, state)]),
  );
  const there = Object.fromEntries(
    Object.keys(PANELS).map((name) => [name, at(payload.times, curves[name], payload.printed.t)]),
  );
  const [time, size] = rowOf(payload.peak, payload, state);
  return { curves, there, peak: { time, size } };
}

const most = (table) => table.flat(2).reduce((a, b) => Math.max(a, b), 0);

function render({ model, el }) {
  const payload = model.get('payload');
  const { times, printed, accuracy, initial } = payload;
  const planes = Object.fromEntries(
    Object.entries(PANELS).map(([name, [word, index, unit]]) => [
      name,
      plane('history', [element('b', {}, word, element('sub', {}, index)), ` (${unit})`]),
    ]),
  );
  const program = plane('history', [element('b', {}, 'pitch program γ', element('sub', {}, '0')), ' (deg)']);
  const tops = Object.fromEntries(
    Object.keys(PANELS).map((name) => [name, 1.05 * most(payload.curves[name])]),
  );
  const first = flight(payload, initial);
  const words = element('p', { class: 'verdict' });
  const table = new Table(`At ${printed.t} s`, ['', 'here', 'in the report', 'off by (%)']);
  const signs = legend([
    ['━', 'this program'],
    ['┄', 'the book’s program'],
    ['◆', `printed, at ${printed.t} s`],
    ['▲', 'largest dynamic pressure'],
  ]);
  const note = element(
    'p',
    {},
    `Between the ${payload.nodes.upright.length * payload.nodes.level.length} programs that are flown ahead the curves are straight-line means, off by at most ${number(accuracy.U, 2)} ft/s, ${number(accuracy.h, 2)} ft and ${number(accuracy.q_D, 2)} lb/ft².`,
  );

  function picture(name, theme, found) {
    const plot = new Plot(planes[name].canvas, theme, {
      x: [0, times.at(-1)],
      y: [0, tops[name]],
      xLabel: 'time (s)',
    }).axes();
    const points = (curve) => curve.map((v, k) => [times[k], v]);
    plot.line(points(first.curves[name]), theme.neutral, 1.5, [2, 4]);
    plot.line(points(found.curves[name]), theme.rigid, 2);
    if (name === 'q_D') {
      plot.line(
        [
          [found.peak.time, 0],
          [found.peak.time, found.peak.size],
        ],
        theme.axis,
        1,
        [4, 4],
      );
      plot.mark('^', found.peak.time, found.peak.size, theme.corrected);
      const late = found.peak.time > 60;
      plot.text(
        `${number(found.peak.time, 3)} s`,
        plot.X(found.peak.time) + (late ? -9 : 9),
        plot.Y(found.peak.size) - 8,
        theme.ink,
        late ? 'right' : 'left',
      );
    }
    plot.mark('d', printed.t, printed[name], theme.ink, 4);
    plot.finish();
    planes[name].canvas.setAttribute(
      'aria-label',
      `${PANELS[name].slice(0, 2).join('')} against time: ${number(found.there[name])} ${PANELS[name][2]} at ${printed.t} s, printed ${number(printed[name])}.`,
    );
  }

  function draw(state, theme) {
    const found = flight(payload, state);
    for (const name of Object.keys(PANELS)) picture(name, theme, found);
    const plot = new Plot(program.canvas, theme, {
      x: [0, times.at(-1)],
      y: [0, 95],
      xLabel: 'time (s)',
    }).axes();
    for (const [{ upright, level }, color, width, dash] of [
      [initial, theme.neutral, 1.5, [2, 4]],
      [state, theme.rigid, 2, []],
    ]) {
      plot.line(
        [
          [0, 90],
          [upright, 90],
          [level, 0],
          [Math.max(level, times.at(-1)), 0],
        ],
        color,
        width,
        dash,
      );
    }
    plot.finish();
    const told = `Vertical until ${number(state.upright)} s, level at ${number(state.level)} s`;
    program.canvas.setAttribute('aria-label', `Flight path angle against time: ${told}.`);
    const rows = Object.entries(PANELS).map(([name, [word, index, unit]]) => ({
      cells: [
        `${word}${index} (${unit})`,
        number(found.there[name]),
        number(printed[name]),
        signed(100 * (found.there[name] / printed[name] - 1), 3),
      ],
      data: { quantity: name, value: found.there[name] },
    }));
    const { time, size } = found.peak;
    table.show([
      ...rows,
      {
        cells: [
          'largest qD (lb/ft²)',
          number(size),
          number(printed.q_D),
          signed(100 * (size / printed.q_D - 1), 3),
        ],
        data: { quantity: 'peak', value: size, time },
      },
    ]);
    const said = `${told}: the largest dynamic pressure, ${number(size)} lb/ft², comes at ${number(time, 3)} s; the report has ${number(printed.q_D)} at ${printed.t} s.`;
    set(words, said);
    return said;
  }
  const all = [planes.q_D, planes.h, planes.U, program];
  const nodes = [
    words,
    element('div', { class: 'planes' }, ...all.map((p) => p.figure)),
    signs,
    note,
    table.node,
  ];
  return mount({ model, el }, { nodes, canvases: all.map((p) => p.canvas), draw });
}

export default { initialize, render };
