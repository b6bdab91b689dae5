// The state of each explorer of a page in the page's address: #rate-attitude:K_A=1.8,K_C=10&single-sensor:K_z=2

const PART = /^([\w-]+(?:\.\d+)?):(.*)$/;

function partsOf(hash) {
  return new Map(
    hash
      .replace(/^#/, '')
      .split('&')
      .map((part) => PART.exec(part)?.slice(1))
      .filter(Boolean),
  );
}

// A text that came from elsewhere may be broken: then it says nothing.
function decoded(text) {
  try {
    return decodeURIComponent(text);
  } catch {
    return '';
  }
}

// JupyterLab's address is its own.
export const inLab = () => document.body.dataset.jpThemeLight !== undefined;

// A page may show a system twice: the second is told apart by a number, unless it has a name of its own.
export function nameOf(el) {
  const { name, explorer } = el.dataset;
  const twins = [...document.querySelectorAll(`[data-explorer="${explorer}"]`)];
  const at = twins.indexOf(el);
  return name ?? (at > 0 ? `${explorer}.${at + 1}` : explorer);
}

// The explorer's own part of the address, as texts by name.
export function readAddress(name, hash = inLab() ? '' : location.hash) {
  const own = partsOf(hash).get(name);
  if (!own) return {};
  return Object.fromEntries(
    own
      .split(',')
      .map((pair) => pair.split('=').map(decoded))
      .filter((pair) => pair.length === 2),
  );
}

// The page's address with the explorer's part replaced, or left out if there is nothing to say.
export function addressWith(name, values, hash = location.hash) {
  const all = partsOf(hash);
  const own = Object.entries(values)
    .map(([key, value]) => `${key}=${encodeURIComponent(value)}`)
    .join(',');
  if (own) all.set(name, own);
  else all.delete(name);
  const joined = [...all].map(([key, value]) => `${key}:${value}`).join('&');
  return joined ? `#${joined}` : '';
}

export function writeAddress(name, values) {
  if (inLab()) return;
  const hash = addressWith(name, values);
  // An anchor of the page stays until there is something to say.
  if (hash === location.hash || (!hash && partsOf(location.hash).size === 0)) return;
  history.replaceState(history.state, '', hash || location.pathname + location.search);
}
