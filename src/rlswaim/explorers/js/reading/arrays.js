// Rows of numbers: [1 2; 3 4], [[1, 2], [3, 4]], array([...]), numpy's print without commas, MATLAB's tables
// with names beside and above.
import { LoopError, quoted } from './loop_error.js';
import { complexFrom, UNSIGNED } from './numbers.js';

/** @typedef {import('./numbers.js').Complex} Complex */

const MOST = 40; // rows and columns
const CALL = /^(?:\w+\.)?(?:array|asarray|matrix|mat)\s*\(([\s\S]*?)(?:,\s*dtype\s*=[\s\w.]*)?\)$/;
const PARTS = String.raw`[+-]?\s*(?:${UNSIGNED})?\s*\*?\s*[ij]`;
// An element: a complex sum, in brackets or not, else one number. Spaces only before an imaginary part.
const ELEMENT = new RegExp(
  String.raw`^(?:\([^()]*\)|[+-]?(?:${UNSIGNED})\s*[+-]\s*(?:${UNSIGNED})?\s*\*?[ij](?![\w])|` +
    String.raw`[+-]?(?:${UNSIGNED})\*?[ij]?(?![\w.])|${PARTS}(?![\w]))`,
);

/** The elements of one row. @param {string} text @param {string} where @returns {Complex[]} */
function rowOf(text, where) {
  const found = [];
  let rest = text.trim();
  while (rest) {
    const element = ELEMENT.exec(rest)?.[0];
    if (element === undefined) throw new LoopError(where, quoted(rest.split(/[\s,]/)[0]), 'a number');
    found.push(complexFrom(element, where));
    const after = rest.slice(element.length);
    const gap = /^\s*,\s*|^\s+|^$/.exec(after);
    if (!gap) throw new LoopError(where, quoted(rest), 'numbers with a space or a comma between them');
    rest = after.slice(gap[0].length);
  }
  return found;
}

/** The inner texts of a row of brackets: [a], [b]. @param {string} text @param {string} where */
function bracketed(text, where) {
  const rows = [...text.matchAll(/\[([^[\]]*)\]/g)].map(([, inner]) => inner);
  if (text.replace(/\[[^[\]]*\]/g, '').replace(/[\s,;]/g, ''))
    throw new LoopError(where, quoted(text), 'rows in brackets, [[1, 2], [3, 4]]');
  return rows;
}

const NAMES = /^[A-Za-z]\w*(?:\([^)]*\))?$/;

/** MATLAB's tables have names of the columns above and one of each row before it. @param {string[]} lines */
function withoutNames(lines) {
  return lines
    .filter(
      (line) =>
        !line
          .trim()
          .split(/\s+/)
          .every((word) => NAMES.test(word) && !/^[ij]$/.test(word)),
    )
    .map((line) => line.replace(/^\s*[A-Za-z]\w*(?:\([^)]*\))?\s+/, ''));
}

/**
 * An array as rows, all of one length. A list may be broken into lines, as numpy does.
 * @param {string} given
 * @param {string} name
 * @returns {Complex[][]}
 */
export function rowsFrom(given, name, isList = false) {
  let text = given.trim().replace(/\.\.\.[^\n]*\n/g, ' ');
  const call = CALL.exec(text);
  if (call) text = call[1].trim();
  const isTuple = /^\(\s*\)$|^\([^()]*,[^()]*\)$/.test(text) && !/^\([^,]*[ij]\s*\)$/.test(text);
  if (isTuple) text = `[${text.slice(1, -1).replace(/,\s*$/, '')}]`;
  /** @type {string[]} */
  let rows;
  const inner = /^\[([\s\S]*)\]$/.exec(text)?.[1];
  if (inner === undefined) {
    if (/[[\]]/.test(text)) throw new LoopError(name, quoted(text), 'brackets that match');
    rows = withoutNames(text.split(/[\n;]/));
  } else if (inner.includes('[')) rows = bracketed(inner.trim(), name);
  else rows = isList && !inner.includes(';') ? [inner] : inner.split(/[;\n]/);
  const found = rows
    .filter((row) => row.trim())
    .map((row, i) => rowOf(row.trim().replace(/,$/, ''), rows.length > 1 ? `${name}, row ${i + 1}` : name));
  const columns = found[0]?.length ?? 0;
  if (found.length > MOST || columns > MOST)
    throw new LoopError(
      `size of ${name}`,
      `${found.length} × ${columns}`,
      `at most ${MOST} rows and columns`,
    );
  found.forEach((row, i) => {
    if (row.length !== columns)
      throw new LoopError(`${name}, row ${i + 1}`, `${row.length} numbers`, `${columns}, as in row 1`);
  });
  return found;
}

/** A row or a column as a list. @param {string} text @param {string} name @returns {Complex[]} */
export function listFrom(text, name) {
  const rows = rowsFrom(text, name, true);
  if (rows.length > 1 && rows[0].length > 1)
    throw new LoopError(name, `${rows.length} × ${rows[0].length} numbers`, 'a single row or column');
  return rows.flat();
}
