// How a desk is laid out, as a text of the page's address: 52_57_map.poles.responses.

/**
 * @typedef {object} DeskState
 * @property {number} across percent of the width for the locus
 * @property {number} down percent of the height for the first row
 * @property {string[] | null} panels the panels that are chosen; null: as they are
 */

/** @type {[number, number]} */
export const RANGE = [20, 80];
/** @type {DeskState} */
export const START = { across: 52, down: 57, panels: null };
const FORM = /^(\d\d)_(\d\d)_([a-z-]+(?:\.[a-z-]+)*)?$/;
const OPEN = 'open'; // what a plain &desk in an address stands for

/** @param {DeskState} desk */
export const deskText = ({ across, down, panels }) => `${across}_${down}_${(panels ?? []).join('.')}`;

/** Undefined for a text without sense. @param {string} text @returns {DeskState | undefined} */
export function deskFrom(text) {
  if (text === OPEN) return { ...START };
  const [whole, across, down, panels] = FORM.exec(text) ?? [];
  const isSensible = [across, down].every((share) => Number(share) >= RANGE[0] && Number(share) <= RANGE[1]);
  if (!whole || !isSensible) return undefined;
  return { across: Number(across), down: Number(down), panels: panels ? panels.split('.') : [] };
}
