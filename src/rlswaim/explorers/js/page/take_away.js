// What a reader takes away: a picture, the poles, a link, the call of the library.
import { plain } from './dom.js';
import { SvgContext } from '../drawing/svg.js';

export function download(name, type, text) {
  const address = URL.createObjectURL(new Blob([text], { type }));
  const link = Object.assign(document.createElement('a'), { href: address, download: name });
  document.body.append(link);
  link.click();
  link.remove();
  setTimeout(() => URL.revokeObjectURL(address), 10_000);
}

// draw: takes the context.
export function svgOf(width, height, title, ground, draw) {
  const g = new SvgContext(width, height);
  draw(g);
  return g.document(title, ground);
}

export async function copy(text) {
  try {
    await navigator.clipboard.writeText(text);
    return true;
  } catch {
    return false; // no permission, or no clipboard here
  }
}

const quoted = (value) => (typeof value === 'string' ? JSON.stringify(value) : plain(value));

// The call that gives the same closed loop.
export function pythonOf({ python }, state) {
  const none = (name) =>
    Object.entries(python.none?.[name] ?? {}).some(([other, value]) => state[other] === value);
  const given = Object.entries(python.arguments).map(
    ([name, keyword]) => `${keyword}=${none(name) ? 'None' : quoted(state[name])}`,
  );
  return [
    'import rlswaim as rl',
    '',
    `eqs = ${python.equations}`,
    `loop = rl.${python.function}(eqs, ${given.join(', ')})`,
    'loop.poles()',
    '',
  ].join('\n');
}
