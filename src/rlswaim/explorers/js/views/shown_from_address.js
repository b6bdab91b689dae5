// What an address says of a workbench beside its parameters: the locus, the window, the panels' choices.
import { isWindow } from '../drawing/camera.js';
import { MOST } from '../maths/compensator.js';
import { leftOut } from '../page/address_values.js';
import { askedFrom } from '../page/requirement_text.js';
import { deskFrom } from './desk_state.js';
import { DURATIONS, GUSTS } from './excitations.js';
import { PICTURES } from './frequency_panel.js';

/** @import { Shown, WorkbenchState } from './workbench_state.js' */

const LARGEST = 1e4; // times that the neighborhood of the origin is magnified

/** @param {number} first @param {number} end */
const placesFrom = (first, end) => (/** @type {number} */ at) =>
  Number.isInteger(at) && at >= first && at < end;

/**
 * Whether a number makes sense, by name.
 * @param {WorkbenchState} state
 * @returns {Record<string, (value: number) => boolean>}
 */
const sensible = ({ base: system, inputs }) => ({
  map: placesFrom(0, system.maps.length),
  input: placesFrom(0, inputs.length),
  printed: placesFrom(-1, system.presets.length),
  mode: placesFrom(0, system.poles.length + system.actuators.length + MOST.order),
  duration: (value) => (system.durations ?? DURATIONS).includes(value),
  cloud: placesFrom(0, 2),
  gust: (value) => GUSTS.includes(value),
  magnify: (value) => value >= 1 && value <= LARGEST,
});

/**
 * What makes sense of it, and notes on the rest.
 * @param {WorkbenchState} state @param {Record<string, string>} texts
 * @returns {{ shown: Partial<Shown>, magnify: number | undefined, notes: string[] }}
 */
export function shownFrom(state, texts) {
  /** @type {Record<string, any>} */
  const found = {};
  /** @type {string[]} */
  const notes = [];
  /** @param {string} name @param {(text: string) => unknown} read undefined for what makes no sense */
  const take = (name, read) => {
    const text = texts[`view.${name}`];
    if (text === undefined) return;
    const value = read(text);
    if (value === undefined) notes.push(leftOut(`view.${name}`, 'not one that can be shown'));
    else found[name] = value;
  };
  for (const [name, isSensible] of Object.entries(sensible(state)))
    take(name, (text) => (text !== '' && isSensible(Number(text)) ? Number(text) : undefined));
  take('locus', (text) => state.loci.find(({ key }) => key === text)?.key);
  take('frequency', (text) => PICTURES.find(([kind]) => kind === text)?.[0]);
  take('compensator', (text) => (state.compensatorFrom(text) ? text : undefined));
  take('requirements', (text) => (askedFrom(text, Boolean(state.period)) ? text : undefined));
  take('window', windowFrom);
  take('desk', deskFrom);
  const { magnify, window, ...shown } = found;
  return { shown: window ? { ...shown, camera: window } : shown, magnify, notes };
}

/** Middle, lower border and width of a window on the s plane. @param {string} text */
function windowFrom(text) {
  const [x, y, w, ...more] = text.split('_').map((part) => (part === '' ? NaN : Number(part)));
  return more.length === 0 && isWindow({ x, y, w }) ? { x, y, w } : undefined;
}
