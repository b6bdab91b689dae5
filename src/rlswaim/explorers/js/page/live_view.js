// What the live views beside the root loci share: elements, words, colors, and the way from a change to a drawing.
import { Drawing, element, mix, onThemeChange, set } from './dom.js';
import { keep } from './state_keeping.js';

const formats = Array.from(
  { length: 8 },
  (_, count) => new Intl.NumberFormat('en', { maximumSignificantDigits: Math.max(count, 1) }),
);

export function number(value, count = 4) {
  if (!Number.isFinite(value)) return '–';
  const size = Math.abs(value);
  if (value === 0 || (size >= 1e-3 && size < 1e12)) return formats[count].format(value).replace('-', '−');
  const [digits, power] = value.toExponential(count - 1).split('e');
  const raised = [...power.replace('+', '')].map((d) => '⁻⁰¹²³⁴⁵⁶⁷⁸⁹'['-0123456789'.indexOf(d)]).join('');
  return `${Number(digits)}·10${raised}`.replace('-', '−');
}

export const signed = (value, count) => (value > 0 ? '+' : '') + number(value, count);

export function apply(model, values) {
  for (const [name, value] of Object.entries(values)) model.set(name, value);
  model.save_changes();
}

function themeOf(root, colors) {
  const style = getComputedStyle(root);
  const read = (name) => style.getPropertyValue(`--${name}`).trim();
  const own = Object.entries(colors).map(([name, color]) => [name, mix(color, Number(read('lift')))]);
  const page = ['plane', 'unstable', 'grid', 'axis', 'ink', 'muted', 'bad', 'good'].map((name) => [
    name,
    read(name),
  ]);
  return Object.fromEntries([...page, ...own]);
}

export function plane(kind, caption, attributes = {}) {
  const canvas = element('canvas', { role: 'img', 'data-plane': kind, ...attributes });
  const words = element('figcaption', {}, ...[caption].flat());
  return { canvas, caption: words, figure: element('figure', {}, words, canvas) };
}

export function legend(entries) {
  const item = ([sign, meaning]) =>
    element('li', {}, element('span', { 'aria-hidden': 'true' }, sign), ` ${meaning}`);
  return element('ul', { class: 'legend' }, ...entries.map(item));
}

// A table of texts whose cells change alone when their text does.
export class Table {
  constructor(caption, heads, name = 'values') {
    this.body = element('tbody');
    this.caption = element('caption', {}, caption);
    const head = element('tr', {}, ...heads.map((text) => element('th', { scope: 'col' }, text)));
    this.table = element('table', { class: name }, this.caption, element('thead', {}, head), this.body);
    this.node = element(
      'div',
      { class: 'scroll', tabindex: '0', role: 'region', 'aria-label': caption },
      this.table,
    );
    this.width = heads.length;
  }

  show(rows) {
    while (this.body.rows.length < rows.length) {
      const cells = Array.from({ length: this.width - 1 }, () => element('td'));
      this.body.append(element('tr', {}, element('th', { scope: 'row' }), ...cells));
    }
    while (this.body.rows.length > rows.length) this.body.lastChild.remove();
    rows.forEach(({ cells, data = {}, kind = '' }, i) => {
      const row = this.body.rows[i];
      Object.assign(row.dataset, data);
      cells.forEach((text, k) => set(row.cells[k], text));
      if (row.lastChild.className !== kind) row.lastChild.className = kind;
    });
  }
}

// Puts a view on the page. view: { nodes, canvases, draw(state, theme, seen) }. The same state always gives the same picture.
export function mount({ model, el }, view) {
  const payload = model.get('payload');
  el.classList.add('rlswaim-explorer');
  el.dataset.explorer = payload.system;
  const entries = [
    ...payload.presets,
    { name: 'Reset', label: 'back to the start', values: payload.initial },
  ];
  const buttons = entries.map(({ name, label, values }) => {
    const button = element('button', { type: 'button', title: label }, name);
    button.addEventListener('click', () => apply(model, values));
    return button;
  });
  const kept = keep(model, payload, el, (values) => apply(model, values));
  const group = element(
    'div',
    { class: 'buttons', role: 'group', 'aria-label': 'Presets' },
    element('span', {}, 'Try'),
    ...buttons,
    ...kept.nodes,
  );
  const live = element('span', { class: 'unseen', role: 'status', 'aria-live': 'polite' });
  el.append(group, ...view.nodes, live);

  let theme;
  let arrived = false;
  function draw() {
    if (!view.canvases[0].clientWidth) return; // not on the page yet
    if (!arrived) kept.arrive();
    arrived = true;
    const start = performance.now();
    theme ??= themeOf(el, payload.colors);
    const state = Object.fromEntries(payload.parameters.map(({ name }) => [name, model.get(name)]));
    const words = view.draw(state, theme, drawing.seen);
    set(live, words);
    const same = (values) => Object.entries(values).every(([name, value]) => state[name] === value);
    entries.forEach(({ values }, i) =>
      buttons[i].setAttribute('aria-pressed', i < entries.length - 1 && same(values)),
    );
    const detail = { ms: performance.now() - start, ...view.detail };
    el.dispatchEvent(new CustomEvent('rlswaim:drawn', { bubbles: true, detail }));
  }
  const drawing = new Drawing(el, draw);
  const follow = () => drawing.next();
  const changed = () => {
    kept.note();
    drawing.now();
  };
  const names = payload.parameters.map(({ name }) => `change:${name}`);
  for (const name of names) model.on(name, changed);
  const resized = new ResizeObserver(follow);
  for (const canvas of view.canvases) resized.observe(canvas);
  const unwatch = onThemeChange(() => {
    theme = undefined;
    follow();
  });
  view.redraw = follow;
  return () => {
    drawing.stop();
    kept.stop();
    resized.disconnect();
    unwatch();
    view.stop?.();
    for (const name of names) model.off(name, changed);
  };
}
