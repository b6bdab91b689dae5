// What a reader takes away: a picture, the poles, a link, the call of the library.
import { SvgContext } from '../drawing/svg.js';
import { flightAt } from '../maths/burn.js';

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
 * A file's name that tells the state: rate-attitude_K_A=1.8_K_C=10_poles.csv.
 * @param {string} system @param {Values} values @param {string} what
 */
export function fileName(system, values, what) {
  const parts = Object.entries(values).map(([name, value]) => `${name}=${value}`.replaceAll(' ', '-'));
  return [system, ...parts, what].join('_');
}

/**
 * Rows as CSV, each with the values of the parameters in columns of their own.
 * @param {string[]} heads @param {unknown[][]} rows @param {Values} values
 */
export function asText(heads, rows, values) {
  /** @param {unknown} cell */
  const quoted = (cell) => (/[",\n]/.test(String(cell)) ? `"${String(cell).replaceAll('"', '""')}"` : cell);
  const all = [[...heads, ...Object.keys(values)], ...rows.map((row) => [...row, ...Object.values(values)])];
  return `${all.map((row) => row.map(quoted).join()).join('\n')}\n`;
}

/** A number as programs write it, from one as the page does: −1,234.5 or 6.7·10⁻⁴. @param {string} text */
function plain(text) {
  const trimmed = text.trim();
  const digits = trimmed
    .replace(/·10(?=[⁻⁰¹²³⁴⁵⁶⁷⁸⁹])/, 'e')
    .replace(/[⁻⁰¹²³⁴⁵⁶⁷⁸⁹]/g, (d) => '-0123456789'['⁻⁰¹²³⁴⁵⁶⁷⁸⁹'.indexOf(d)])
    .replace('−', '-')
    .replace(/(?<=\d),(?=\d{3})/g, '');
  return digits !== '' && Number.isFinite(Number(digits)) ? digits : trimmed;
}

/** A table of the page, with the parameters. @param {HTMLTableElement} table @param {Values} values */
export function tableAsText(table, values) {
  /** @param {HTMLTableRowElement} row */
  const texts = ({ cells }) => Array.from(cells, (cell) => cell.textContent);
  const rows = Array.from(table.tBodies[0].rows, (row) => texts(row).map(plain));
  return asText(texts(table.tHead.rows[0]), rows, values);
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
 * The call that makes the equations, with the vehicle's data where they are other than the report's.
 * @param {string} own @param {import('../maths/vehicle_data.js').Plant | undefined} plant
 * @param {Values} values
 */
function equationsOf(own, plant, values) {
  if (plant?.burn) {
    const { U, q_D } = flightAt(plant.burn, values);
    return `${own}(${values.t}, U=${U}, q_D=${q_D})`;
  }
  const changes = (plant?.parameters ?? [])
    .filter((name) => values[name] !== plant.own[name])
    .map(
      (name) =>
        `${name}=${name === 'gravity' ? (values.gravity === 'kept' ? 'True' : 'False') : values[name]}`,
    );
  return changes.length ? `rl.with_other_data(${own}, ${changes.join(', ')})` : own;
}

/**
 * The call that gives the same closed loop.
 * @param {import('../types.d.ts').System} system
 * @param {Values} values
 */
export function pythonOf({ python, plant }, values) {
  /** @param {string} name */
  const none = (name) =>
    Object.entries(python.none?.[name] ?? {}).some(([other, value]) => values[other] === value);
  /** @param {string} name */
  const value = (name) =>
    none(name) ? 'None' : [JSON.stringify(values[name]), ...(python.over?.[name] ?? [])].join(' / ');
  const given = Object.entries(python.arguments).map(([name, keyword]) => `${keyword}=${value(name)}`);
  const made = python.equations
    ? [
        'import rlswaim as rl',
        ...(plant?.burn ? [`from rlswaim.practice.burn import ${python.equations}`] : []),
        '',
        `eqs = ${equationsOf(python.equations, plant, values)}`,
        `loop = rl.${python.function}(eqs, `,
      ]
    : [`from ${python.module} import ${python.function}`, '', `loop = ${python.function}(`];
  return `${made.join('\n')}${given.join(', ')})\nloop.poles()\n`;
}
