// Keys on the sliders beside a view, and texts in their boxes. An arrow steps to the next round number, with
// Alt to the slider's next place, with Shift to the next power of ten; a box takes 0,618 as well as 1e-3, and
// nothing beyond its slider's ends.
import { valueFrom } from './address_values.js';

/** @import { Model, Parameter } from '../types.d.ts' */

const ROUND = [1, 2, 3, 4, 6, 8];
/** @type {Record<string, number>} */
export const WAYS = { ArrowRight: 1, ArrowUp: 1, ArrowLeft: -1, ArrowDown: -1 };

/**
 * The places of a slider that its keys step to. Where its own run over decades these are round numbers, some
 * in each decade, which the slider itself need not have; else its own, coarse every tenth.
 * @param {number[]} grid @param {boolean} coarse
 */
export function roundPlaces(grid, coarse) {
  const sizes = grid.map(Math.abs).filter((size) => size > 0);
  const [least, most] = [Math.min(...sizes), Math.max(...sizes)];
  const isWide = sizes.sort((a, b) => a - b)[sizes.length >> 1] < 0.2 * most;
  if (!isWide) return grid.filter((_, k) => k % (coarse ? 10 : 1) === 0 || k === grid.length - 1);
  const [from, to] = [least, most].map((size) => Math.floor(Math.log10(size)));
  const decades = Array.from({ length: to - from + 1 }, (_, k) => from + k);
  const round = decades.flatMap((power) =>
    (coarse ? [1] : ROUND).map((digit) => Number(`${digit}e${power}`)),
  );
  const within = [...round.map((size) => -size), 0, ...round].filter((v) => v > grid[0] && v < grid.at(-1));
  return [grid[0], ...within.filter((v) => v === 0 || Math.abs(v) >= least), grid.at(-1)].sort(
    (a, b) => a - b,
  );
}

/**
 * The next place on the way from a value, which may lie between two; the value itself at the end.
 * @param {number[]} places rising @param {number} value @param {number} way 1 or -1
 */
export const nextPlace = (places, value, way) =>
  (way > 0 ? places.find((place) => place > value) : places.findLast((place) => place < value)) ?? value;

/** A box for numbers alone refuses 0,618. @param {HTMLInputElement | null} box */
const takeAnyDecimals = (box) => box && Object.assign(box, { type: 'text', inputMode: 'decimal' });

/**
 * Puts into a box what its text means: with a point for a comma, and no value beyond the slider's ends.
 * Returns words on what was changed.
 * @param {HTMLInputElement} box @param {Parameter} parameter
 */
function bounded(box, parameter) {
  box.value = box.value.replace(',', '.');
  const { value, note } = valueFrom(parameter, box.value, 'as typed');
  if (note) box.value = String(value ?? ''); // without a value the box goes back to the last one
  return note;
}

/**
 * Takes the arrow keys of the sliders from what draws them. Returns what gives them back.
 * @param {Element} panel with a row for each of the parameters
 * @param {Parameter[]} parameters @param {Model} model
 * @param {(note: string) => void} tell what was changed of a text in a box
 */
export function roundSteps(panel, parameters, model, tell) {
  const numbers = parameters.filter(({ grid }) => typeof grid[0] !== 'string');
  /** @param {Event} event */
  const parameterOf = ({ target }) => {
    const rows = [...panel.querySelectorAll('.widget-hbox')];
    return numbers[rows.indexOf(/** @type {Element} */ (target).closest('.widget-hbox'))];
  };
  /** @param {Event} event */
  const pressed = (event) => {
    const { key, altKey, shiftKey, target } = /** @type {KeyboardEvent} */ (event);
    const parameter =
      WAYS[key] && /** @type {Element} */ (target).matches('[role=slider]') && parameterOf(event);
    if (!parameter) return;
    const { name, grid } = parameter;
    event.preventDefault();
    event.stopPropagation();
    model.set(name, nextPlace(altKey ? grid : roundPlaces(grid, shiftKey), model.get(name), WAYS[key]));
    model.save_changes();
  };
  /** @param {Event} event */
  const typed = (event) => {
    const box = /** @type {HTMLInputElement} */ (event.target);
    const parameter = box.matches('.widget-hbox input') && parameterOf(event);
    if (!parameter) return;
    const note = bounded(box, parameter);
    if (note) setTimeout(() => tell(note)); // when the view has taken the value
  };
  panel.querySelectorAll('.widget-hbox').forEach((row, k) => {
    if (!numbers[k]?.grid.every(Number.isInteger)) takeAnyDecimals(row.querySelector('input'));
  });
  panel.addEventListener('keydown', pressed, true);
  panel.addEventListener('change', typed, true);
  return () => {
    panel.removeEventListener('keydown', pressed, true);
    panel.removeEventListener('change', typed, true);
  };
}
