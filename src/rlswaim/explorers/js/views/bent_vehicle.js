// The bent vehicle: all forces are sums of the motions by the coefficients that Python sends.
import { element, set } from '../page/dom.js';
import { Table, legend, mount, number, plane, signed } from '../page/live_view.js';
import { Plot } from '../drawing/plot.js';
import { initialize } from '../page/sliders.js';

const LOOKS = { thrust: 'actuator', payload: 'rigid', fins: 'rigid' };
const ROWS = ['Z', 'M', 'F1', 'F2'];
const UNITS = { q_1: '1 ft of q₁', q_2: '1 ft of q₂', theta: '1° of θ', alpha: '1° of α', delta: '1° of δ' };
const RADIAN = Math.PI / 180;
const REACH = 100; // ft above and below

const dot = (coefficients, state) =>
  Object.entries(coefficients).reduce((sum, [name, c]) => sum + c * state[name], 0);

// Loads of each source, and their sums: F_z (down), M_y (nose up), Q_1z and Q_2z.
export function loads(payload, state) {
  const each = payload.sources.map(({ name, rows, incidence }) => ({
    name,
    incidence: dot(incidence, state),
    loads: Object.fromEntries(ROWS.map((row) => [row, dot(rows[row], state)])),
  }));
  const sum = Object.fromEntries(
    ROWS.map((row) => [row, each.reduce((total, { loads: l }) => total + l[row], 0)]),
  );
  return { each, sum };
}

// Height of the axis (ft, up) at a station: the rigid turn and both modes.
const rigid = (payload, state, at) => state.theta * RADIAN * (payload.l_CG - at);
export function height(payload, state, at) {
  const { phi_1, phi_2 } = payload.shapes;
  return rigid(payload, state, at) + state.q_1 * phi_1[at] + state.q_2 * phi_2[at];
}

function picture(canvas, theme, payload, state, { each }) {
  const plot = new Plot(canvas, theme, {
    x: [-75, 525],
    y: [-REACH, REACH],
    xLabel: 'station (ft from the nose)',
    bare: true,
  });
  const { g } = plot;
  plot.axes();
  const axis = Array.from({ length: 421 }, (_, at) => [at, height(payload, state, at)]);
  const part = (from, to) => axis.slice(Math.max(0, from), to + 1);
  plot.line(
    [
      [0, 0],
      [420, 0],
    ],
    theme.axis,
    1,
    [2, 4],
  );
  plot.line(
    [
      [0, rigid(payload, state, 0)],
      [420, rigid(payload, state, 420)],
    ],
    theme.rigid,
    1.5,
    [7, 5],
  );
  plot.line(part(0, 420), theme.grid, 15);
  plot.line(part(0, 420), theme['mode 1'], 2);
  for (const { station } of payload.sources.slice(1))
    plot.line(part(station - 13, station + 13), theme.muted, 5);

  // Lengths of arrows: with the square root of the force, so that small ones can be seen beside the thrust.
  const pixels = (force) =>
    Math.sign(force) * 30 * Math.sqrt(Math.abs(force) / 1e6) * Math.min(1, plot.width / 600);
  const cg = [plot.X(payload.l_CG), plot.Y(0)];
  const down = pixels(payload.weight.force);
  const gamma = payload.weight.gamma_0 * RADIAN;
  plot.arrow(...cg, cg[0] + down * Math.sin(gamma), cg[1] + down * Math.cos(gamma), theme.neutral, 3);
  plot.text('weight', cg[0] + down * Math.sin(gamma) + 4, cg[1] + down * Math.cos(gamma) + 10, theme.muted);
  plot.mark('s', payload.l_CG, 0, theme.neutral, 4);

  // Exhaust and thrust: along the bent axis at G, swung by delta. Angles are stretched like heights.
  const [thrust] = payload.sources;
  const [gx, gy] = [plot.X(thrust.station), plot.Y(axis[thrust.station][1])];
  const turn = state.theta + thrust.incidence.q_1 * state.q_1 + thrust.incidence.q_2 * state.q_2;
  for (const [angle, own] of [
    [-turn, false],
    [state.delta - turn, true],
  ]) {
    const [dx, dy] = [plot.sx, -Math.tan(angle * RADIAN) * plot.sy];
    const scale = pixels(payload.thrust) / Math.hypot(dx, dy);
    const [ex, ey] = [gx + dx * scale, gy + dy * scale];
    if (own) plot.arrow(ex, ey, gx, gy, theme.actuator, 3);
    else {
      g.setLineDash([2, 4]);
      g.strokeStyle = theme.actuator;
      g.lineWidth = 1;
      g.beginPath();
      g.moveTo(gx, gy);
      g.lineTo(ex, ey);
      g.stroke();
      g.setLineDash([]);
    }
    if (own) plot.text('thrust', (gx + ex) / 2, (gy + ey) / 2 + (ey > gy ? 12 : -12), theme.actuator);
  }
  each.forEach(({ name, loads: { Z } }, i) => {
    const { station } = payload.sources[i];
    const [x, y] = [plot.X(station), plot.Y(axis[station][1])];
    plot.arrow(x, y, x, y + pixels(Z), theme[LOOKS[name] ?? 'rigid'], 3);
    const word = i ? name : 'thrust, across';
    if (Math.abs(pixels(Z)) > 4)
      plot.text(word, x + (i ? 0 : -40), y + pixels(Z) + Math.sign(Z) * 9, theme[LOOKS[name] ?? 'rigid']);
  });
  const wind = (state.theta - state.alpha) * RADIAN;
  const [wx, wy] = [plot.X(-70), plot.Y(-0.8 * REACH)];
  plot.arrow(wx, wy, wx + 44, wy + (Math.tan(wind) * 44 * plot.sy) / plot.sx, theme['mode 2'], 2);
  plot.text('air', wx + 14, wy - 12, theme['mode 2'], 'center');
  const key = pixels(1e6);
  plot.arrow(plot.X(515) - key, plot.Y(-0.88 * REACH), plot.X(515), plot.Y(-0.88 * REACH), theme.ink, 3);
  plot.text('1,000,000 lb', plot.X(515) - key - 6, plot.Y(-0.88 * REACH), theme.ink, 'right');
  plot.finish();
  return plot.sy / plot.sx;
}

function spoken({ Z, M, F1, F2 }) {
  const way = (value, plus, minus) => (value === 0 ? '' : ` ${value > 0 ? plus : minus}`);
  const size = (value) => number(Math.abs(value), 3);
  return (
    `Together: a force across of ${size(Z)} lb${way(Z, 'down', 'up')}, a moment of ${size(M)} ft lb${way(M, 'nose up', 'nose down')}; ` +
    `mode 1 is pushed${way(F1, 'down', 'up')} with ${size(F1)} lb, mode 2${way(F2, 'down', 'up')} with ${size(F2)} lb.`
  );
}

function render({ model, el }) {
  const payload = model.get('payload');
  const stretch = element('small');
  const { canvas, figure } = plane('vehicle', [
    element('b', {}, 'The bent vehicle'),
    ', nose to the left',
    stretch,
  ]);
  const words = element('p', { class: 'verdict' });
  const table = new Table('Forces under the sliders', [
    'from',
    'local angle of attack (deg)',
    'force down (lb)',
    'moment nose up (ft lb)',
    'on mode 1 (lb)',
    'on mode 2 (lb)',
  ]);
  const units = new Table('What one unit of each motion gives, all sources together', [
    'for',
    'force down (lb)',
    'moment nose up (ft lb)',
    'on mode 1 (lb)',
    'on mode 2 (lb)',
  ]);
  const signs = legend([
    ['━', 'elastic axis'],
    ['╌', 'rigid axis, turned by θ'],
    ['┄', 'undisturbed axis; exhaust without δ'],
    ['▬', 'payload and fins, with the air’s force across'],
    ['■', 'center of gravity'],
  ]);
  units.show(
    Object.entries(UNITS).map(([name, text]) => ({
      cells: [
        text,
        ...ROWS.map((row) =>
          signed(payload.sources.reduce((sum, { rows }) => sum + (rows[row][name] ?? 0), 0)),
        ),
      ],
    })),
  );

  function draw(state, theme) {
    const found = loads(payload, state);
    const factor = picture(canvas, theme, payload, state, found);
    set(
      stretch,
      `Heights and angles are drawn ${number(factor, 2)} times too large, and an arrow’s length goes with the square root of its force. The weight, ${number(payload.weight.force, 3)} lb, is drawn for a path ${number(payload.weight.gamma_0, 2)}° above the horizon (chapter II’s program).`,
    );
    table.show([
      ...found.each.map(({ name, incidence, loads: l }, i) => ({
        cells: [name, i ? signed(incidence) : '–', ...ROWS.map((row) => signed(l[row]))],
        data: { source: name, ...l },
      })),
      {
        cells: ['sum', '', ...ROWS.map((row) => signed(found.sum[row]))],
        data: { source: 'sum', ...found.sum },
      },
    ]);
    const said = spoken(found.sum);
    set(words, said);
    canvas.setAttribute(
      'aria-label',
      `The vehicle bent by q1 = ${number(state.q_1)} ft and q2 = ${number(state.q_2)} ft, pitched ${number(state.theta)} degrees, at ${number(state.alpha)} degrees angle of attack, exhaust swung ${number(state.delta)} degrees. ${said}`,
    );
    return said;
  }
  return mount(
    { model, el },
    { nodes: [words, figure, signs, table.node, units.node], canvases: [canvas], draw },
  );
}

export default { initialize, render };
