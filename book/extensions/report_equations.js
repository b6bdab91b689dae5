/* Printed numbers of the report: ties each to its ledger row, and shows a card on hover, focus or touch. */
const STATIC = new URL('.', import.meta.url);
const AGREEMENT = new URL('../book/12-agreement.html', STATIC);
const LINGER = 250; // ms in which the pointer may travel from the number to the card

/** Loads the ledger's texts, once. @returns {Promise<any>} */
async function ledger() {
  return (await import(new URL('printed_numbers.js', STATIC).href)).default;
}

/** Returns the ledger row's id of a printed number. @param {Element} number */
function entryOf(number) {
  const named = [...number.classList].find((name) => name.startsWith('entry-'));
  return /** @type {HTMLElement} */ (number).dataset.entry ?? named?.slice('entry-'.length) ?? '';
}

/** @param {string} tag @param {string} text @param {string} [name] of the class */
function element(tag, text, name = '') {
  const made = document.createElement(tag);
  made.textContent = text;
  made.className = name;
  return made;
}

const card = element('div', '', 'printed-card');
card.hidden = true;
card.setAttribute('role', 'region');
card.setAttribute('aria-label', 'Printed number');
card.setAttribute('aria-live', 'polite');

/** The number that the card is about. @type {Element | undefined} */
let current;
/** @type {number | undefined} */
let hiding;

function hide() {
  clearTimeout(hiding);
  current?.classList.remove('printed-current');
  current = undefined;
  card.hidden = true;
}

function hideSoon() {
  clearTimeout(hiding);
  hiding = window.setTimeout(hide, LINGER);
}

/** Fills the card with a row of the ledger. @param {string} entry @param {any} data */
function fill(entry, data) {
  const [where, quantity, printed, computed, unit, difference, verdict, reason, kind, first] =
    data.rows[entry];
  const of = unit === '1' || unit === '-' ? '' : ` ${unit}`;
  const list = element('div', '', 'printed-pair');
  const off = difference === '' ? '' : ` (${difference} %)`;
  for (const [term, text] of [
    ['printed', printed + of],
    ['computed', computed + of + off],
  ]) {
    list.append(element('span', term), element('b', text));
  }
  const row = /** @type {HTMLAnchorElement} */ (element('a', 'Its row in Agreement'));
  row.href = `${AGREEMENT}#${entry}`;
  card.replaceChildren(element('p', `${where}: ${quantity}`), list, element('p', verdict, 'printed-verdict'));
  if (data.reasons[reason]) card.append(element('p', data.reasons[reason]));
  if (kind === 'given') card.append(element('p', 'Data or a choice of the report: it agrees by itself.'));
  if (first) card.append(element('p', `The same number again: row ${first} judges it.`));
  card.append(row);
  card.dataset.entry = entry;
  card.style.setProperty(
    '--verdict',
    getComputedStyle(/** @type {Element} */ (current)).getPropertyValue('--verdict'),
  );
}

/** Puts the card below the number, or above it where there is no room. @param {Element} number */
function place(number) {
  const at = number.getBoundingClientRect();
  const width = document.documentElement.clientWidth;
  const below = at.bottom + 8 + card.offsetHeight <= window.innerHeight;
  const top = below ? at.bottom + 8 : Math.max(4, at.top - 8 - card.offsetHeight);
  const left = Math.max(4, Math.min(at.left, width - card.offsetWidth - 4));
  card.style.top = `${top + window.scrollY}px`;
  card.style.left = `${left + window.scrollX}px`;
}

/** @param {Element} number */
async function show(number) {
  clearTimeout(hiding);
  if (number === current) return;
  hide();
  current = number;
  number.classList.add('printed-current');
  const data = await ledger();
  const entry = entryOf(number);
  if (number !== current || !data.rows[entry]) return;
  fill(entry, data);
  card.hidden = false;
  place(number);
}

/** @param {Event} event @returns {Element | null} */
function numberAt(event) {
  return event.target instanceof Element ? event.target.closest('.printed') : null;
}

function listen() {
  document.addEventListener('pointerover', (event) => {
    if (event.pointerType === 'touch') return;
    const number = numberAt(event);
    if (number) show(number);
    else if (event.target instanceof Node && card.contains(event.target)) clearTimeout(hiding);
    else if (current && !isStepping()) hideSoon();
  });
  document.addEventListener('click', (event) => {
    const number = numberAt(event);
    if (number) show(number);
    else if (!(event.target instanceof Node && card.contains(event.target))) hide();
  });
  document.addEventListener('keydown', (event) => {
    if (event.key === 'Escape' && current) hide();
  });
}

function isStepping() {
  return document.activeElement?.classList.contains('printed-numbers-button') ?? false;
}

/** Which number an arrow key leads to. @param {string} key @param {number} at @param {number} count */
function step(key, at, count) {
  if (key === 'ArrowRight' || key === 'ArrowDown') return Math.min(at + 1, count - 1);
  if (key === 'ArrowLeft' || key === 'ArrowUp') return Math.max(at - 1, 0);
  if (key === 'Home') return 0;
  return key === 'End' ? count - 1 : -1;
}

/** Says how many numbers there are, and of which verdicts. @param {Element[]} numbers */
function summary(numbers) {
  const counts = new Map();
  for (const number of numbers) {
    const verdict = [...number.classList].find((name) => name.startsWith('verdict-')) ?? '';
    const words = verdict.slice('verdict-'.length).replaceAll('-', ' ');
    counts.set(words, (counts.get(words) ?? 0) + 1);
  }
  const parts = [...counts].map(([words, count]) => `${count} ${words}`);
  return `${numbers.length} printed numbers: ${parts.join(', ')}. Arrow keys step, Enter opens a row.`;
}

/** Gives an equation or a table one tab stop for all of its numbers. @param {Element} frame */
function addButton(frame) {
  const numbers = [...frame.querySelectorAll('.printed')];
  const button = /** @type {HTMLButtonElement} */ (
    element('button', summary(numbers), 'printed-numbers-button')
  );
  button.type = 'button';
  let at = 0;
  button.addEventListener('focus', () => show(numbers[at]));
  button.addEventListener('blur', hideSoon);
  button.addEventListener('click', (event) => {
    event.stopPropagation();
    card.querySelector('a')?.click();
  });
  button.addEventListener('keydown', (event) => {
    const next = step(event.key, at, numbers.length);
    if (next < 0) return;
    event.preventDefault();
    at = next;
    numbers[at].scrollIntoView({ block: 'nearest', inline: 'nearest' });
    show(numbers[at]);
  });
  frame.querySelector('mjx-container')?.setAttribute('tabindex', '-1'); // MathJax makes it a tab stop, too
  frame.before(button);
}

/** On the ledger's page: finds the row that the address names and scrolls to it. */
function findRow() {
  const entry = decodeURIComponent(window.location.hash.slice(1));
  const table = document.querySelector('table#printed-numbers');
  const box = document.querySelector('.dt-search input');
  if (!entry || !table || !(box instanceof HTMLInputElement)) return false;
  box.value = entry;
  box.dispatchEvent(new Event('input', { bubbles: true }));
  const row = [...table.querySelectorAll('tbody tr')].find(
    (tr) => tr.firstElementChild?.textContent === entry,
  );
  if (!row) return false;
  document.getElementById(entry)?.removeAttribute('id');
  row.id = entry;
  row.classList.add('printed-row-found');
  row.scrollIntoView({ block: 'center' });
  return true;
}

/** The table is made by a script of its own, so it may come late. @param {number} tries */
function findRowWhenThere(tries) {
  if (!findRow() && tries > 0) window.setTimeout(() => findRowWhenThere(tries - 1), 100);
}

async function start() {
  await /** @type {any} */ (window).MathJax?.startup?.promise;
  document.body.append(card);
  // MathJax writes each formula a second time, as MathML for screen readers, with the same classes.
  for (const double of document.querySelectorAll('mjx-assistive-mml .printed'))
    double.removeAttribute('class');
  const numbers = /** @type {HTMLElement[]} */ ([...document.querySelectorAll('.printed')]);
  for (const number of numbers) number.dataset.entry = entryOf(number);
  const frames = new Set(numbers.map((number) => number.closest('div.math, table')));
  for (const frame of frames) if (frame) addButton(frame);
  listen();
  if (window.location.hash && document.querySelector('#printed-numbers')) findRowWhenThere(50);
  window.addEventListener(
    'hashchange',
    () => document.querySelector('#printed-numbers') && findRowWhenThere(5),
  );
  document.documentElement.dataset.printedNumbers = String(numbers.length);
}

if (document.readyState === 'complete') start();
else window.addEventListener('load', start);
