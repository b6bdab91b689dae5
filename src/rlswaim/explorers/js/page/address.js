// The state of each explorer of a page in the page's address:
// #rate-attitude:K_A=1.8,K_C=10&single-sensor:K_z=2

/** @typedef {Record<string, unknown>} Values */

const PART = /^([\w-]+(?:\.\d+)?):(.*)$/;
const DESK = /&desk(?:&|$)/; // opens the desk of the first explorer that the address names

/**
 * The parts of an address by the names of their explorers.
 * @param {string} hash
 * @returns {Map<string, string>}
 */
function partsOf(hash) {
  const parts = hash.replace(/^#/, '').split('&');
  return new Map(
    parts.flatMap((part) => {
      const [, name, values] = PART.exec(part) ?? [];
      return name ? [[name, values]] : [];
    }),
  );
}

/** A text that came from elsewhere may be broken: then it says nothing. @param {string} text */
function decoded(text) {
  try {
    return decodeURIComponent(text);
  } catch {
    return '';
  }
}

/** JupyterLab's address is its own. */
export const inLab = () => document.body.dataset.jpThemeLight !== undefined;

/**
 * A page may show a system twice: the second is told apart by a number, unless it has a name of its own.
 * @param {HTMLElement} el
 */
export function nameOf(el) {
  const { name, explorer } = el.dataset;
  const twins = document.querySelectorAll(`[data-explorer="${explorer}"]`);
  const at = [...twins].indexOf(el);
  return name ?? (at > 0 ? `${explorer}.${at + 1}` : explorer);
}

/**
 * The explorer's own part of the address, as texts by name.
 * @param {string} name
 * @returns {Record<string, string>}
 */
export function readAddress(name, hash = inLab() ? '' : location.hash) {
  const parts = partsOf(hash);
  const pairs = (parts.get(name) ?? '')
    .split(',')
    .map((pair) => pair.split('=').map(decoded))
    .filter((pair) => pair.length === 2);
  const isFirst = parts.keys().next().value === name;
  if (isFirst && DESK.test(hash)) pairs.push(['view.desk', 'open']);
  return Object.fromEntries(pairs);
}

/** Goes to an explorer if it is the first that the address names. @param {Element} el @param {string} name */
export function goToAddressed(el, name, hash = location.hash) {
  if (partsOf(hash).keys().next().value !== name) return;
  (el.closest('.bench, .widget-vbox') ?? el).scrollIntoView({ block: 'start', behavior: 'instant' });
}

/**
 * Tells of each new address of the page. The event brings the address: a view that writes its state between
 * the click on a link and the event changes the page's own.
 * @param {(hash: string) => void} act
 * @returns {() => void} ends it
 */
export function onAddress(act) {
  /** @param {HashChangeEvent} event */
  const told = (event) => act(inLab() ? '' : new URL(event.newURL).hash);
  addEventListener('hashchange', told);
  return () => removeEventListener('hashchange', told);
}

/**
 * The page's address with the explorer's part replaced, or left out if there is nothing to say.
 * @param {string} name @param {Values} values
 */
export function addressWith(name, values, hash = location.hash) {
  const all = partsOf(hash);
  const own = Object.entries(values)
    .map(([key, value]) => `${key}=${encodeURIComponent(String(value))}`)
    .join(',');
  if (own) all.set(name, own);
  else all.delete(name);
  const joined = [...all].map(([key, value]) => `${key}:${value}`).join('&');
  return joined ? `#${joined}` : '';
}

/** @param {string} name @param {Values} values */
export function writeAddress(name, values) {
  if (inLab()) return;
  const hash = addressWith(name, values);
  // An anchor of the page stays until there is something to say.
  if (hash === location.hash || (!hash && partsOf(location.hash).size === 0)) return;
  history.replaceState(history.state, '', hash || location.pathname + location.search);
}
