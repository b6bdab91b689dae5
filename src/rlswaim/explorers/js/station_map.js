// The map over sensor and jet stations: computed beside the page, coarse first, drawn as it comes.
import { STATIONS, abscissaAt, planOf, rootsAt, rows } from './abscissa.js';
import { Table, apply, element, initialize, legend, mount, number, plane, set, signed } from './live.js';
import { Plot } from './plot.js';

const STATIONS_OF = ['sensor', 'jet'];
const FINE = 0.002; // 1/s: the scale is straight below and logarithmic above
const ENDS = 10;
const TICKS = [-10, -1, -0.1, 0, 0.1, 1, 10];

// Place of a value on the scale, from 0 to 1.
const share = (value) => Math.max(0, Math.min(1, 0.5 + (0.5 * Math.asinh(value / FINE)) / Math.asinh(ENDS / FINE)));

// Rows of the map from a worker made of the same scripts, or in short turns on the page where no worker may start.
function calculator(code, receive) {
  let id = 0;
  let worker = null;
  let last = null;
  function here() {
    const mine = id;
    const left = rows(last);
    const turn = () => {
      if (mine !== id) return;
      const until = performance.now() + 4;
      const found = [];
      let next = { done: false };
      while (!next.done && performance.now() < until) {
        next = left.next();
        if (!next.done) found.push(next.value);
      }
      receive(found, next.done);
      if (!next.done) setTimeout(turn);
    };
    turn();
  }
  try {
    const address = URL.createObjectURL(new Blob([code], { type: 'text/javascript' }));
    worker = new Worker(address, { type: 'module' });
    worker.onmessage = ({ data }) => data.id === id && receive(data.rows, data.done);
    worker.onerror = () => {
      worker = null;
      if (last) here();
    };
  } catch {
    worker = null;
  }
  return {
    start(plan) {
      id += 1;
      last = plan;
      if (worker) worker.postMessage({ id, plan });
      else here();
    },
    stop() {
      id += 1;
      worker?.terminate();
    },
  };
}

// The line of zero through the values at every `step`-th station, by straight pieces (marching squares).
export function zeroLine(values, step) {
  const path = [];
  const cross = (a, b) => a / (a - b);
  for (let j = 0; j + step < STATIONS; j += step) {
    for (let s = 0; s + step < STATIONS; s += step) {
      const [a, b] = [values[j * STATIONS + s], values[j * STATIONS + s + step]];
      const [d, c] = [values[(j + step) * STATIONS + s], values[(j + step) * STATIONS + s + step]];
      if (a > 0 === b > 0 && b > 0 === c > 0 && c > 0 === d > 0) continue;
      const points = [];
      if (a > 0 !== b > 0) points.push([s + step * cross(a, b), j]);
      if (b > 0 !== c > 0) points.push([s + step, j + step * cross(b, c)]);
      if (d > 0 !== c > 0) points.push([s + step * cross(d, c), j + step]);
      if (a > 0 !== d > 0) points.push([s, j + step * cross(a, d)]);
      for (let k = 0; k + 1 < points.length; k += 2) path.push([points[k], points[k + 1]]);
    }
  }
  return path;
}

function render({ model, el }) {
  const payload = model.get('payload');
  const gains = payload.parameters.map(({ name }) => name).filter((name) => !STATIONS_OF.includes(name));
  const palette = payload.palette.map((hex) => Number.parseInt(hex.slice(5) + hex.slice(3, 5) + hex.slice(1, 3), 16) | 0xff000000);
  const values = new Float64Array(STATIONS * STATIONS);
  const image = new ImageData(STATIONS, STATIONS);
  const pixels = new Int32Array(image.data.buffer);
  const picture = element('canvas', { width: STATIONS, height: STATIONS });
  let [plan, key, step, line, cursor, cases, total] = [null, '', 0, [], null, [], null];
  let complete = false;

  const { canvas, figure } = plane('stations', [element('b', {}, 'Largest real part of all poles'), ' (1/s) for every sensor and jet'], { tabindex: '0', role: 'application' });
  const scale = plane('scale', 'color of the map (1/s): below zero all poles decay');
  const words = element('p', { class: 'verdict' });
  const word = element('b');
  const rest = element('span');
  const progress = element('p', { class: 'crossings' });
  words.append(word, rest);
  const table = new Table('The pairs of Table 3 at these gains', ['case', 'sensor (ft)', 'jet (ft)', 'largest real part (1/s)', 'stable']);
  const signs = legend([
    ['✚', 'the pair chosen'],
    ['○', 'pairs of Table 3'],
    ['━', 'zero: stable within'],
    ['◌', 'the keyboard’s mark: arrow keys move it (with Shift ten feet), Enter picks'],
  ]);

  function receive(found, done) {
    for (const row of found) {
      if (row.step !== step && step) line = zeroLine(values, step);
      step = row.step;
      row.values.forEach((value, n) => {
        const color = palette[Math.round(share(value) * (palette.length - 1))];
        for (let j = row.jet; j < Math.min(STATIONS, row.jet + step); j++) {
          for (let s = n * step; s < Math.min(STATIONS, (n + 1) * step); s++) {
            values[j * STATIONS + s] = value;
            pixels[(STATIONS - 1 - j) * STATIONS + s] = color;
          }
        }
      });
    }
    if (done) {
      line = zeroLine(values, 1);
      total = { stable: 0, neutral: 0 };
      for (const value of values) {
        if (value < 0) total.stable += 1;
        if (value === 0) total.neutral += 1;
      }
    }
    complete = done;
    picture.getContext('2d').putImageData(image, 0, 0);
    view.redraw();
  }
  const machine = calculator(payload.worker, receive);

  function restart(state) {
    const now = JSON.stringify(gains.map((name) => state[name]));
    if (now === key) return;
    key = now;
    plan = planOf(payload, Object.fromEntries(gains.map((name) => [name, state[name]])));
    [step, line, complete] = [0, [], false];
    machine.start(plan);
    cases = payload.pairs.map((pair) => ({ ...pair, value: abscissaAt(plan, pair.sensor, pair.jet) }));
    table.show(cases.map(({ case: at, sensor, jet, value }) => ({
      cells: [at, sensor, jet, signed(value), value < 0 ? 'yes' : value > 0 ? 'no' : 'neutral'].map(String),
      data: { case: at, value },
    })));
  }

  function drawMap(state, theme) {
    const plot = new Plot(canvas, theme, { x: [-0.5, 420.5], y: [-0.5, 420.5], xLabel: 'station of the sensor (ft)', yLabel: 'station of the jet (ft)' }).axes();
    const { g } = plot;
    g.imageSmoothingEnabled = false;
    if (step) g.drawImage(picture, plot.X(-0.5), plot.Y(420.5), 421 * plot.sx, 421 * plot.sy);
    g.beginPath();
    for (const [[ax, ay], [bx, by]] of line) {
      g.moveTo(plot.X(ax), plot.Y(ay));
      g.lineTo(plot.X(bx), plot.Y(by));
    }
    g.strokeStyle = '#000';
    g.lineWidth = 1.5;
    g.stroke();
    const ring = (sensor, jet, radius, color, width) => {
      g.beginPath();
      g.arc(plot.X(sensor), plot.Y(jet), radius, 0, 2 * Math.PI);
      g.strokeStyle = color;
      g.lineWidth = width;
      g.stroke();
    };
    for (const { sensor, jet } of cases) {
      ring(sensor, jet, 4, '#fff', 3);
      ring(sensor, jet, 4, '#000', 1.3);
    }
    const [x, y] = [plot.X(state.sensor), plot.Y(state.jet)];
    for (const [color, width] of [['#fff', 5], ['#000', 2]]) {
      g.strokeStyle = color;
      g.lineWidth = width;
      g.beginPath();
      g.moveTo(x - 10, y);
      g.lineTo(x + 10, y);
      g.moveTo(x, y - 10);
      g.lineTo(x, y + 10);
      g.stroke();
    }
    if (cursor) {
      g.setLineDash([3, 3]);
      ring(cursor.sensor, cursor.jet, 9, '#fff', 4);
      ring(cursor.sensor, cursor.jet, 9, '#000', 2);
      g.setLineDash([]);
    }
    plot.finish();
    return plot;
  }

  function drawScale(theme) {
    const plot = new Plot(scale.canvas, theme, { x: [0, 1], y: [0, 1], bare: true });
    const { g } = plot;
    payload.palette.forEach((color, k) => {
      g.fillStyle = color;
      const width = (plot.width - 16) / payload.palette.length;
      g.fillRect(8 + k * width, 0, width + 1, 12);
    });
    for (const tick of TICKS) plot.text(signed(tick, 1), 8 + share(tick) * (plot.width - 16), 20, theme.muted, tick === -ENDS ? 'left' : tick === ENDS ? 'right' : 'center', false);
  }

  let plot;
  function draw(state, theme) {
    restart(state);
    plot = drawMap(state, theme);
    drawScale(theme);
    const pair = rootsAt(plan, state.sensor, state.jet);
    const value = abscissaAt(plan, state.sensor, state.jet);
    const right = value > 0 ? pair.x.filter((x) => x > 0).length : 0;
    word.className = value > 0 ? 'unstable' : 'stable';
    set(word, value < 0 ? 'Stable' : value > 0 ? 'Unstable' : 'Neutral');
    const why = `: with the sensor at ${number(state.sensor)} ft and the jet at ${number(state.jet)} ft the largest real part is ${signed(value)} 1/s${right ? `; ${right} of 9 poles lie right of the axis` : ''}.`;
    set(rest, why);
    Object.assign(words.dataset, { value });
    set(progress, complete
      ? `All ${(STATIONS * STATIONS).toLocaleString('en')} pairs at one foot: ${total.stable.toLocaleString('en')} stable, ${total.neutral.toLocaleString('en')} with a root at zero and none right of it.`
      : `Computing: every ${step || 28} ft …`);
    el.dataset.step = complete ? 'complete' : String(step);
    const there = cursor ? ` The mark is at sensor ${cursor.sensor} ft, jet ${cursor.jet} ft: ${signed(abscissaAt(plan, cursor.sensor, cursor.jet))} 1/s.` : '';
    canvas.setAttribute('aria-label', `Map of the largest real part over sensor and jet stations. ${word.textContent}${why} Arrow keys move a mark, Enter picks its pair.${there}`);
    scale.canvas.setAttribute('aria-label', 'Color scale from −10 to +10 1/s, purple below zero, orange above');
    return cursor ? there.trim() : `${word.textContent}${why}`;
  }

  const within = (value) => Math.max(0, Math.min(STATIONS - 1, Math.round(value)));
  canvas.addEventListener('click', ({ offsetX, offsetY }) => {
    if (!plot) return;
    cursor = null;
    apply(model, {
      sensor: within(plot.x[0] + (offsetX - plot.pad.left) / plot.sx),
      jet: within(plot.y[0] + (plot.height - plot.pad.bottom - offsetY) / plot.sy),
    });
    view.redraw();
  });
  const MOVES = { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, 1], ArrowDown: [0, -1] };
  canvas.addEventListener('keydown', (event) => {
    const move = MOVES[event.key];
    if (move) {
      const by = event.shiftKey ? 10 : 1;
      cursor ??= { sensor: model.get('sensor'), jet: model.get('jet') };
      cursor = { sensor: within(cursor.sensor + by * move[0]), jet: within(cursor.jet + by * move[1]) };
    } else if ((event.key === 'Enter' || event.key === ' ') && cursor) {
      apply(model, cursor);
      cursor = null;
    } else if (event.key === 'Escape') cursor = null;
    else return;
    event.preventDefault();
    view.redraw();
  });
  canvas.addEventListener('blur', () => {
    cursor = null;
    view.redraw();
  });

  const view = { nodes: [words, figure, scale.figure, progress, signs, table.node], canvases: [canvas, scale.canvas], draw, stop: machine.stop };
  return mount({ model, el }, view);
}

export default { initialize, render };
