// Small tools for the page: elements, numbers as text, controls, the colors of the page's theme.

export function element(tag, attributes = {}, ...children) {
  const made = document.createElement(tag);
  for (const [name, value] of Object.entries(attributes)) {
    if (value !== false && value !== undefined) made.setAttribute(name, value === true ? '' : value);
  }
  made.append(...children);
  return made;
}

// K_A -> K with subscript A
export function symbol(name) {
  const [letter, index] = name.split('_');
  return index ? [element('i', {}, letter), element('sub', {}, index)] : [letter];
}

// Changes the text that is there: a new text in place of it would cost the page much more.
export function set(node, text) {
  const only = node.firstChild;
  if (!(only instanceof Text) || only.nextSibling) node.textContent = text;
  else if (only.data !== text) only.data = text;
}

export function press(button, pressed) {
  if (button.getAttribute('aria-pressed') !== String(pressed)) button.setAttribute('aria-pressed', pressed);
}

export function digits(value, count) {
  if (value !== 0 && Math.abs(value) < 1e-3) return value.toExponential(count - 1);
  return value === 0 ? '0' : value.toPrecision(count);
}

const short = (text) => text.replace(/(\.\d*?)0+(?=e|$)/, '$1').replace(/\.(?=e|$)/, '');

export function number(value, count = 4) {
  const size = Math.abs(value);
  const large = size >= 10 ** (count - 1) && size < 1e6;
  const text = large ? String(Number(value.toPrecision(count))) : short(digits(value, count));
  return text.replaceAll('-', '−').replace('e+', 'e');
}

// A value of a slider, for a program or an address: with as many digits as it takes.
export const plain = (value) => (typeof value === 'number' ? String(value) : value);

export const complex = (re, im) =>
  im === 0 ? number(re) : `${number(re)} ${im < 0 ? '−' : '+'} ${number(Math.abs(im))}j`;

export function button(text, act, attributes = {}) {
  const made = element('button', { type: 'button', ...attributes }, text);
  made.addEventListener('click', act);
  return made;
}

export function buttons(label, entries, act) {
  const made = entries.map(([text, title], i) => button(text, () => act(i), { title }));
  return {
    group: element(
      'div',
      { class: 'buttons', role: 'group', 'aria-label': label },
      element('span', {}, label),
      ...made,
    ),
    made,
  };
}

// entries: [[value, text], ...]
export function select(label, entries, act) {
  const list = element('select', {}, ...entries.map(([value, text]) => element('option', { value }, text)));
  list.addEventListener('change', () => act(list.value));
  return { list, node: element('label', {}, element('span', {}, label), list) };
}

// A part of the workbench that costs nothing while it is closed.
export function panel(name, title, toggled, ...children) {
  const extra = element('small');
  const node = element(
    'details',
    { class: 'panel', 'data-panel': name },
    element('summary', {}, element('b', {}, title), extra),
    ...children,
  );
  node.addEventListener('toggle', toggled);
  return { node, extra };
}

// A color of the print figures, lightened on a dark page.
export function mix(color, share) {
  if (!share) return color;
  const parts = color
    .match(/[0-9a-f]{2}/gi)
    .map((hex) => Math.round(parseInt(hex, 16) * (1 - share) + 255 * share));
  return `rgb(${parts.join()})`;
}

const COLORS = ['plane', 'unstable', 'grid', 'axis', 'ink', 'muted', 'line', 'good', 'bad'];

// The page's colors, read anew only when its theme changes.
export function themeOf(root, system) {
  const style = getComputedStyle(root);
  const read = (name) => style.getPropertyValue(`--${name}`).trim();
  const lift = Number(read('lift'));
  const names = Object.keys(system.branches);
  const branches = Object.fromEntries(
    names.map((name, i) => [name, { color: mix(system.branches[name], lift), mark: i }]),
  );
  return {
    ...Object.fromEntries(COLORS.map((name) => [name, read(name)])),
    branch: (name) => branches[name],
  };
}

export function onThemeChange(act) {
  const watch = new MutationObserver(act);
  for (const node of [document.documentElement, document.body]) {
    watch.observe(node, {
      attributes: true,
      attributeFilter: ['data-theme', 'data-mode', 'data-jp-theme-light', 'class'],
    });
  }
  const media = matchMedia('(prefers-color-scheme: dark)');
  media.addEventListener('change', act);
  return () => {
    watch.disconnect();
    media.removeEventListener('change', act);
  };
}

const REST = 150; // ms without a change, for a view that nobody sees

// When to draw a view. What the hand changes is drawn at once, when all changes of its event are in; a second time in one
// frame waits for the next frame, and so does what follows from the page's own layout. Off the screen it waits for rest.
export class Drawing {
  constructor(el, draw) {
    Object.assign(this, { draw, frame: 0, due: false, seen: false, drawn: false });
    this.watch = new IntersectionObserver((entries) => this.#note(entries.at(-1).isIntersecting), {
      rootMargin: '200px',
    });
    this.watch.observe(el);
  }

  #note(seen) {
    const shows = seen && !this.seen;
    this.seen = seen;
    if (shows) this.next();
  }

  #go() {
    clearTimeout(this.rest);
    this.due = false;
    this.drawn = true;
    this.draw();
  }

  #frame() {
    this.due = true;
    this.frame ||= requestAnimationFrame(() => {
      this.frame = 0;
      if (this.due) this.#go();
    });
  }

  next() {
    if (this.seen || !this.drawn) return this.#frame();
    clearTimeout(this.rest);
    this.rest = setTimeout(() => this.#frame(), REST);
  }

  now() {
    const atOnce = this.seen && this.frame === 0;
    this.next();
    if (atOnce) queueMicrotask(() => this.due && this.#go());
  }

  stop() {
    this.due = false;
    this.watch.disconnect();
    clearTimeout(this.rest);
    cancelAnimationFrame(this.frame);
  }
}
