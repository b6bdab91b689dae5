// Elements of a page: how they are made, and how their texts change.
import { letterOf } from '../drawing/letters.js';

/**
 * @template {keyof HTMLElementTagNameMap} Tag
 * @param {Tag} tag @param {Record<string, unknown>} attributes left out where false or undefined
 * @param {...(Node | string)} children
 * @returns {HTMLElementTagNameMap[Tag]}
 */
export function element(tag, attributes = {}, ...children) {
  const made = document.createElement(tag);
  for (const [name, value] of Object.entries(attributes)) {
    if (value !== false && value !== undefined) made.setAttribute(name, value === true ? '' : String(value));
  }
  made.append(...children);
  return made;
}

/** K_A becomes K with subscript A. @param {string} name */
export function symbol(name) {
  const [word, index] = name.split('_');
  const letter = letterOf(word);
  return index ? [element('i', {}, letter), element('sub', {}, index)] : [letter];
}

/**
 * Changes the text that is there: a new text in place of it would cost the page much more.
 * @param {Node} node @param {string} text
 */
export function set(node, text) {
  const only = node.firstChild;
  if (!(only instanceof Text) || only.nextSibling) node.textContent = text;
  else if (only.data !== text) only.data = text;
}

/** @param {HTMLElement} button @param {boolean} pressed */
export function press(button, pressed) {
  if (button.getAttribute('aria-pressed') !== String(pressed))
    button.setAttribute('aria-pressed', String(pressed));
}

/** @param {string} text @param {() => void} act @param {Record<string, unknown>} attributes */
export function button(text, act, attributes = {}) {
  const made = element('button', { type: 'button', ...attributes }, text);
  made.addEventListener('click', act);
  return made;
}

/**
 * Elements in a row.
 * @param {string} kind @param {string} label of the group @param {...(Node | string)} children
 */
export const group = (kind, label, ...children) =>
  element('div', { class: kind, role: 'group', 'aria-label': label }, ...children);

/**
 * A list to choose from, with its label.
 * @param {string} label @param {[unknown, string][]} entries values and texts
 * @param {(value: string) => void} act
 */
export function select(label, entries, act) {
  const options = entries.map(([value, text]) => element('option', { value }, text));
  const list = element('select', {}, ...options);
  list.addEventListener('change', () => act(list.value));
  /** @param {unknown} value */
  const choose = (value) => {
    if (list.value !== String(value)) list.value = String(value);
  };
  return { list, choose, node: element('label', {}, element('span', {}, label), list) };
}

/**
 * A part of a view that costs nothing while it is closed.
 * @param {string} name @param {string} title @param {() => void} toggled @param {...Node} children
 */
export function panel(name, title, toggled, ...children) {
  const extra = element('small');
  const summary = element('summary', {}, element('b', {}, title), extra);
  const node = element('details', { class: 'panel', 'data-panel': name }, summary, ...children);
  node.addEventListener('toggle', toggled);
  return { node, extra };
}

/**
 * A canvas under a caption.
 * @param {string} kind @param {Record<string, unknown>} attributes @param {...(Node | string)} caption
 */
export function picture(kind, attributes, ...caption) {
  // Until it is drawn and told in words, a picture is called by its caption.
  const name = caption.map((part) => (typeof part === 'string' ? part : part.textContent)).join('') || kind;
  const canvas = element('canvas', { role: 'img', 'aria-label': name, 'data-plane': kind, ...attributes });
  return { canvas, figure: element('figure', {}, element('figcaption', {}, ...caption), canvas) };
}

/** What the signs in a picture mean. @param {[string, string][]} entries */
export function legend(entries) {
  const items = entries.map(([sign, meaning]) =>
    element('li', {}, element('span', { 'aria-hidden': 'true' }, sign), ` ${meaning}`),
  );
  return element('ul', { class: 'legend' }, ...items);
}

/**
 * A table that scrolls sideways where it is wider than the page.
 * @param {string} label @param {Node} table
 */
export const scrolling = (label, table) =>
  element('div', { class: 'scroll', tabindex: '0', role: 'region', 'aria-label': label }, table);

/** @param {string[]} texts */
export const headRow = (texts) =>
  element('thead', {}, element('tr', {}, ...texts.map((text) => element('th', { scope: 'col' }, text))));
