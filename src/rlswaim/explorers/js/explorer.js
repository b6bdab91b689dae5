// The view: parameters in, picture, table and words out. The same state always gives the same picture.
import { closedLoopPoles, namedPoles, openLoop, poleMap, rootLocus } from './locus.js';
import { Picture, SIGNS, viewOf } from './picture.js';
import { roots } from './roots.js';

const MAGNIFY = [1, 3, 10, 100, 1000, 10000];

function element(tag, attributes = {}, ...children) {
  const made = document.createElement(tag);
  for (const [name, value] of Object.entries(attributes)) made.setAttribute(name, value);
  made.append(...children);
  return made;
}

// K_A -> K with subscript A
function symbol(name) {
  const [letter, index] = name.split('_');
  return index ? [element('i', {}, letter), element('sub', {}, index)] : [letter];
}

const set = (node, text) => node.textContent === text || (node.textContent = text);

function digits(value, count) {
  if (value !== 0 && Math.abs(value) < 1e-3) return value.toExponential(count - 1);
  return value === 0 ? '0' : value.toPrecision(count);
}

const number = (value, count = 4) => digits(value, count).replace(/(\.\d*?)0+(?=e|$)/, '$1').replace(/\.(?=e|$)/, '').replaceAll('-', '−');

// A cell with eight digits, of which the last three are set back: enough to compare, easy to read.
class Figure {
  constructor() {
    this.parts = [new Text(), new Text(), new Text()];
    this.cell = element('td', {}, this.parts[0], element('span', { class: 'fine' }, this.parts[1]), this.parts[2]);
  }

  show(value) {
    if (value === this.value) return;
    this.value = value;
    const text = Number.isNaN(value) ? '–' : digits(value, 8);
    const end = text.includes('e') ? text.indexOf('e') : text.length;
    const kept = end > 3 ? end - 3 : end;
    [text.slice(0, kept), text.slice(kept, end), text.slice(end)].forEach((part, k) => (this.parts[k].data = part));
  }
}

function spoken(pole, poles) {
  const at = `${pole.re > 0 ? '+' : ''}${number(pole.re)}`;
  if (pole.im === 0) return `a real root at ${at} 1/s (from ${pole.name})`;
  const off = poles.map((p) => Math.hypot(p.re - pole.re, p.im + pole.im));
  const twin = poles[off.indexOf(Math.min(...off))].name;
  return `a pair at ${at} ± ${number(pole.im)}j 1/s (from ${twin === pole.name ? twin : `${pole.name} and ${twin}`})`;
}

// In words: is it stable, and why.
export function verdict(poles) {
  const upper = poles.filter((p) => p.im >= 0).sort((a, b) => b.re - a.re);
  const bad = upper.filter((p) => p.re > 0);
  const worst = bad[0] ?? upper[0];
  if (bad.length) {
    const count = poles.filter((p) => p.re > 0).length;
    const also = bad.slice(1).map((p) => spoken(p, poles));
    return {
      word: 'unstable',
      short: `Unstable: ${count} of ${poles.length} roots ${count > 1 ? 'lie' : 'lies'} right of the imaginary axis.`,
      long: ` because of ${spoken(worst, poles)}: its motion doubles every ${number(Math.LN2 / worst.re, 3)} s.${
        also.length ? ` Also right of the axis: ${also.join('; ')}.` : ''
      }`,
    };
  }
  if (worst.re === 0) {
    return { word: 'neutral', short: 'Neutrally stable: a root lies on the imaginary axis.', long: `: ${spoken(worst, poles)} neither grows nor decays.` };
  }
  return {
    word: 'stable',
    short: 'Stable: all roots lie left of the imaginary axis.',
    long: `: all roots lie left of the imaginary axis. The slowest is ${spoken(worst, poles)}; its motion halves every ${number(-Math.LN2 / worst.re, 3)} s.`,
  };
}

// Each parameter and the place of its slider keep each other: a slider that moves sets the value, a value set
// otherwise moves the slider to the nearest place and stays as it is.
function nearest(parameter, value) {
  const off = parameter.grid.map((place) => (typeof place === 'string' ? Number(place !== value) : Math.abs(place - value)));
  return off.indexOf(Math.min(...off));
}

function initialize({ model }) {
  for (const parameter of model.get('payload').parameters) {
    const { name, grid } = parameter;
    const place = `${name}_at`;
    model.on(`change:${name}`, () => {
      const at = nearest(parameter, model.get(name));
      if (at < 0 || at === model.get(place)) return;
      model.set(place, at);
      model.save_changes();
    });
    model.on(`change:${place}`, () => {
      const at = model.get(place);
      if (nearest(parameter, model.get(name)) === at) return;
      model.set(name, grid[at]);
      model.save_changes();
    });
  }
}

function apply(model, values) {
  for (const [name, value] of Object.entries(values)) model.set(name, value);
  model.save_changes();
}

function mix(color, share) {
  if (!share) return color;
  const parts = color.match(/[0-9a-f]{2}/gi).map((hex) => Math.round(parseInt(hex, 16) * (1 - share) + 255 * share));
  return `rgb(${parts.join()})`;
}

// The page's colors, read anew only when its theme changes.
function themeOf(root, system) {
  const style = getComputedStyle(root);
  const read = (name) => style.getPropertyValue(`--${name}`).trim();
  const lift = Number(read('lift'));
  const names = Object.keys(system.branches);
  const branches = Object.fromEntries(names.map((name, i) => [name, { color: mix(system.branches[name], lift), mark: i }]));
  return {
    ...Object.fromEntries(['plane', 'unstable', 'grid', 'axis', 'ink', 'muted'].map((name) => [name, read(name)])),
    branch: (name) => branches[name],
  };
}

function onThemeChange(act) {
  const watch = new MutationObserver(act);
  for (const node of [document.documentElement, document.body]) {
    watch.observe(node, { attributes: true, attributeFilter: ['data-theme', 'data-mode', 'data-jp-theme-light', 'class'] });
  }
  const media = matchMedia('(prefers-color-scheme: dark)');
  media.addEventListener('change', act);
  return () => {
    watch.disconnect();
    media.removeEventListener('change', act);
  };
}

function buttons(label, entries, press) {
  const made = entries.map(([text, title]) => element('button', { type: 'button', ...(title && { title }) }, text));
  made.forEach((button, i) => button.addEventListener('click', () => press(i)));
  return { group: element('div', { class: 'buttons', role: 'group', 'aria-label': label }, element('span', {}, label), ...made), made };
}

function plane(kind) {
  const canvas = element('canvas', { role: 'img', 'data-plane': kind });
  const caption = element('figcaption');
  return { canvas, caption, figure: element('figure', {}, caption, canvas) };
}

function legend() {
  const entries = [
    ['×', 'open-loop pole'],
    ['○', 'open-loop zero'],
    ['■ ● ▲ ◆ ▼', 'closed-loop poles, as in the table'],
    ['▸', 'rising gain'],
    ['◇', 'crossing, with its gain'],
    ['•', 'break-away point; in the map, every 100 ft'],
    ['╌', 'a pair whose two roots left different poles'],
  ];
  const item = ([sign, meaning]) => element('li', {}, element('span', { 'aria-hidden': 'true' }, sign), ` ${meaning}`);
  return element('ul', { class: 'legend' }, ...entries.map(item));
}

class PoleTable {
  constructor() {
    const heads = ['leaves from', 'real (1/s)', 'imaginary (1/s)', 'ω (rad/s)', 'ζ', 'stability'];
    const head = element('tr', {}, ...heads.map((text) => element('th', { scope: 'col' }, text)));
    this.body = element('tbody');
    this.rows = [];
    this.node = element('table', { class: 'poles' }, element('caption', {}, 'Closed-loop poles'), element('thead', {}, head), this.body);
  }

  #newRow() {
    const sign = element('span', { 'aria-hidden': 'true' });
    const name = new Text();
    const figures = Array.from({ length: 4 }, () => new Figure());
    const word = element('td');
    const node = element('tr', {}, element('th', { scope: 'row' }, sign, ' ', name), ...figures.map((f) => f.cell), word);
    this.body.append(node);
    this.rows.push({ node, sign, name, figures, word });
  }

  show(poles, theme) {
    while (this.rows.length < poles.length) this.#newRow();
    while (this.rows.length > poles.length) this.rows.pop().node.remove();
    poles.forEach(({ re, im, name }, i) => {
      const row = this.rows[i];
      const { color, mark } = theme.branch(name);
      if (row.color !== color) row.sign.style.color = row.color = color;
      set(row.sign, SIGNS[mark]);
      if (row.name.data !== name) row.name.data = name;
      if (row.re === re && row.im === im) return;
      [row.re, row.im] = [re, im];
      Object.assign(row.node.dataset, { re, im, branch: name });
      const size = Math.hypot(re, im);
      [re, im, size, -re / size].forEach((value, k) => row.figures[k].show(value));
      const [word, kind] = re > 0 ? ['unstable', 'unstable'] : [re < 0 ? 'stable' : 'neutrally stable', 'stable'];
      set(row.word, word);
      if (row.word.className !== kind) row.word.className = kind;
    });
  }
}

const pairs = ({ x, y }) => Array.from(x, (re, i) => [re, y[i]]);

// What the window must hold: all poles, and zeros unless they lie far outside.
function worthSeeing(system, state) {
  const poles = [...pairs(namedPoles(system, state)), ...pairs(closedLoopPoles(system, state))];
  const far = 1.5 * Math.max(...poles.map(([x, y]) => Math.hypot(x, y)));
  const zeros = pairs(roots(openLoop(system, state).N));
  return [...poles, ...zeros.filter(([x, y]) => Math.hypot(x, y) <= far)];
}

function drawLocus(canvas, view, theme, locus) {
  const picture = new Picture(canvas, view, theme);
  picture.background();
  picture.branches(locus.branches, locus.open.branches, 2);
  picture.arrows(locus.branches, locus.open.branches, 110);
  for (const { x, y } of locus.breaks) picture.dot(x, y, theme.ink);
  picture.zeros(locus.zeros);
  picture.crosses(locus.open);
  for (const crossing of locus.crossings) picture.crossing(crossing);
  picture.poles(locus.present, locus.open.branches);
  picture.finish();
}

function drawMap(canvas, view, theme, locus, sides, unit) {
  const names = locus.open.branches;
  const picture = new Picture(canvas, view, theme);
  picture.background();
  for (const side of sides) picture.branches(side, names, 2);
  for (const side of sides) {
    for (const p of side) {
      if (p.t % 100 === 0) names.forEach((name, i) => p.y[i] >= 0 && picture.dot(p.x[i], p.y[i], theme.branch(name).color));
    }
  }
  for (const side of sides) {
    const end = side.at(-1);
    names.forEach((name, i) => {
      const moved = Math.hypot(end.x[i] - locus.present.x[i], end.y[i] - locus.present.y[i]) * view.scale;
      if (end.y[i] >= 0 && moved > 14) picture.text(`${end.t} ${unit}`, view.X(end.x[i]) + 6, view.Y(end.y[i]) - 8, theme.muted, 'left');
    });
  }
  picture.poles(locus.present, names);
  picture.finish();
}

function render({ model, el }) {
  const system = model.get('payload');
  const running = system.locus.parameter;
  const moving = system.map;
  el.classList.add('rlswaim-explorer');
  el.dataset.explorer = system.system;

  const presets = buttons('Designs', [...system.presets.map((p) => [p.name, `the report's ${p.name}`]), ['Reset']], (i) =>
    apply(model, system.presets[i]?.values ?? { ...system.initial, magnify: 1 }),
  );
  const zoom = buttons('Magnify', MAGNIFY.map((m) => [`×${m.toLocaleString('en')}`, `${m} times about the origin`]), (i) =>
    apply(model, { magnify: MAGNIFY[i] }),
  );
  const word = element('b');
  const reason = element('span');
  const live = element('span', { class: 'unseen', role: 'status', 'aria-live': 'polite' });
  const locusPlane = plane('locus');
  const mapPlane = plane('map');
  const crossings = element('span');
  const poleTable = new PoleTable();
  const locusEnd = element('span');
  const locusNow = element('small');
  const mapNow = element('small');
  locusPlane.caption.append(element('b', {}, 'Root locus'), ', ', ...symbol(running), ' from 0 to ', locusEnd, locusNow);
  mapPlane.caption.append(element('b', {}, 'Pole map'), `, ${moving.parameter} from ${moving.ends.join(' to ')} ${moving.unit}`, mapNow);
  el.append(
    presets.group,
    element('p', { class: 'verdict' }, word, reason),
    live,
    element('div', { class: 'planes' }, locusPlane.figure, mapPlane.figure),
    zoom.group,
    legend(),
    element('p', { class: 'crossings' }, ...symbol(running), crossings),
    element('div', { class: 'scroll', tabindex: '0', role: 'region', 'aria-label': 'pole table' }, poleTable.node),
  );

  let theme;
  let frame = 0;
  let [width, height] = [0, 0];

  function draw() {
    frame = 0;
    const state = Object.fromEntries(system.parameters.map(({ name }) => [name, model.get(name)]));
    if (width === 0) return; // not on the page yet
    const start = performance.now();
    theme ??= themeOf(el, system);
    const view = viewOf(worthSeeing(system, state), width, height, model.get('magnify'));
    const locus = rootLocus(system, state, view);
    const sides = poleMap(system, state, locus.present, view);
    drawLocus(locusPlane.canvas, view, theme, locus);
    drawMap(mapPlane.canvas, view, theme, locus, sides, moving.unit);
    tell(state, locus, sides);
    el.dispatchEvent(new CustomEvent('rlswaim:drawn', { bubbles: true, detail: { ms: performance.now() - start } }));
  }

  function tell(state, locus, sides) {
    const poles = Array.from(locus.present.x, (re, i) => ({ re, im: locus.present.y[i], name: locus.open.branches[i] }));
    const { word: status, short, long } = verdict(poles);
    poleTable.show(poles, theme);
    set(word, status === 'neutral' ? 'Neutrally stable' : status[0].toUpperCase() + status.slice(1));
    set(reason, long);
    set(live, short);
    word.className = status;
    set(locusEnd, number(locus.end));
    set(locusNow, `filled marks at ${number(state[running])}`);
    const still = `${number(state[moving.parameter])} ${moving.unit}`;
    set(mapNow, sides.length ? `filled marks at ${still}` : `no influence: the feedback leaves out the bending`);
    const list = locus.crossings.map((c) => `${number(c.gain)} (ω = ${number(c.omega)} rad/s, to the ${c.direction > 0 ? 'right' : 'left'})`);
    set(crossings, list.length ? `: imaginary axis crossed at ${list.join(', ')}.` : ': no branch crosses the imaginary axis.');
    locusPlane.canvas.setAttribute('aria-label', `Root locus in ${running} from 0 to ${number(locus.end)}. At ${running} = ${number(state[running])}: ${status}${long}`);
    mapPlane.canvas.setAttribute('aria-label', `Closed-loop poles as the ${moving.parameter} runs from ${moving.ends.join(' to ')} ${moving.unit}. At ${still}: ${short}`);
    const same = (values) => Object.entries(values).every(([name, value]) => state[name] === value);
    system.presets.forEach((p, i) => presets.made[i].setAttribute('aria-pressed', same(p.values)));
    MAGNIFY.forEach((m, i) => zoom.made[i].setAttribute('aria-pressed', m === model.get('magnify')));
  }

  const schedule = () => (frame ||= requestAnimationFrame(draw));
  const names = [...system.parameters.map((p) => p.name), 'magnify'];
  for (const name of names) model.on(`change:${name}`, schedule);
  const resized = new ResizeObserver(([entry]) => {
    ({ width, height } = entry.contentRect);
    schedule();
  });
  resized.observe(locusPlane.canvas);
  const unwatch = onThemeChange(() => {
    theme = undefined;
    schedule();
  });
  return () => {
    cancelAnimationFrame(frame);
    resized.disconnect();
    unwatch();
    for (const name of names) model.off(`change:${name}`, schedule);
  };
}

export default { initialize, render };
