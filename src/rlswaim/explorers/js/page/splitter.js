// A line between panels that is dragged, or moved by the arrow keys, to give one of them more room.
import { element } from './elements.js';

const STEP = 2; // percent a key
/** @type {Record<string, number>} */
const WAYS = { ArrowLeft: -STEP, ArrowUp: -STEP, ArrowRight: STEP, ArrowDown: STEP, Home: -100, End: 100 };

/**
 * @typedef {object} Split
 * @property {string} label
 * @property {boolean} isUpright whether the line stands, and moves to the left and right
 * @property {[number, number]} range percent of the room
 * @property {() => number} get
 * @property {(percent: number) => void} put
 * @property {() => void} restore back to the start
 */

/** @param {Split} split */
export function splitter({ label, isUpright, range, get, put, restore }) {
  const [least, most] = range;
  const node = element('div', {
    class: `splitter ${isUpright ? 'upright' : 'lying'}`,
    role: 'separator',
    tabindex: '0',
    'aria-label': label,
    'aria-orientation': isUpright ? 'vertical' : 'horizontal',
    'aria-valuemin': least,
    'aria-valuemax': most,
    title: 'drag, or arrow keys; double click: as at first',
  });
  /** @param {number} percent */
  const go = (percent) => put(Math.round(Math.min(Math.max(percent, least), most)));
  node.addEventListener('keydown', (event) => {
    if (!WAYS[event.key]) return;
    event.preventDefault();
    go(get() + WAYS[event.key]);
  });
  node.addEventListener('pointerdown', (event) => {
    event.preventDefault();
    node.focus();
    node.setPointerCapture(event.pointerId);
  });
  node.addEventListener('pointermove', ({ pointerId, clientX, clientY }) => {
    if (!node.hasPointerCapture(pointerId)) return;
    const { left, top, width, height } = node.parentElement.getBoundingClientRect();
    go(100 * (isUpright ? (clientX - left) / width : (clientY - top) / height));
  });
  node.addEventListener('dblclick', restore);
  /** The line tells where it stands. */
  const tell = () => node.setAttribute('aria-valuenow', String(get()));
  return { node, tell };
}
