// What a reader takes away: a picture, the poles, a link, the call of the library.
import { SvgContext } from '../drawing/svg.js';

/** @import { Graphics, Values } from '../types.d.ts' */

/** @param {string} name @param {string} type @param {string} text */
export function download(name, type, text) {
  const address = URL.createObjectURL(new Blob([text], { type }));
  const link = Object.assign(document.createElement('a'), { href: address, download: name });
  document.body.append(link);
  link.click();
  link.remove();
  setTimeout(() => URL.revokeObjectURL(address), 10_000);
}

/**
 * @param {number} width @param {number} height @param {string} title @param {string} ground
 * @param {(g: Graphics) => void} draw
 */
export function svgOf(width, height, title, ground, draw) {
  const g = new SvgContext(width, height);
  draw(g);
  return g.document(title, ground);
}

/** Returns whether there is a clipboard and the permission to use it. @param {string} text */
export async function copy(text) {
  try {
    await navigator.clipboard.writeText(text);
    return true;
  } catch {
    return false;
  }
}

/**
 * The call that gives the same closed loop.
 * @param {import('../types.d.ts').System} system
 * @param {Values} values
 */
export function pythonOf({ python }, values) {
  /** @param {string} name */
  const none = (name) =>
    Object.entries(python.none?.[name] ?? {}).some(([other, value]) => values[other] === value);
  /** @param {string} name */
  const value = (name) =>
    none(name) ? 'None' : [JSON.stringify(values[name]), ...(python.over?.[name] ?? [])].join(' / ');
  const given = Object.entries(python.arguments).map(([name, keyword]) => `${keyword}=${value(name)}`);
  const made = python.equations
    ? ['import rlswaim as rl', '', `eqs = ${python.equations}`, `loop = rl.${python.function}(eqs, `]
    : [`from ${python.module} import ${python.function}`, '', `loop = ${python.function}(`];
  return `${made.join('\n')}${given.join(', ')})\nloop.poles()\n`;
}
