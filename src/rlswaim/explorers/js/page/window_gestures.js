// Wheel, fingers and keys that move the window on the s plane.
import { panned, zoomed } from '../drawing/camera.js';
import { placeOn } from './movable_point.js';

/** @import { Camera, View } from '../types.d.ts' */
/** @import { Ground } from './movable_point.js' */
/**
 * @typedef {object} Window
 * @property {() => View} view as it will be drawn next
 * @property {(camera: Camera | null) => void} move null: fitted again
 * @property {Ground['hover']} hover
 */

const WHEEL = 0.0016;
const BY_KEY = 1.25;
/** @type {Record<string, [number, number]>} */
const PAN = { ArrowRight: [-40, 0], ArrowLeft: [40, 0], ArrowUp: [0, 40], ArrowDown: [0, -40] };

/** The middle of the window, on the real axis where that is seen. @param {View} view */
export const middleOf = (view) => [view.frame.x + view.frame.w / 2, view.Y(Math.max(view.bottom, 0))];

/** @param {Window} window @returns {Ground} */
export function groundOf({ view, move, hover }) {
  /** @type {View} */
  let held;
  return {
    hold: () => {
      held = view();
    },
    pan: ([x, y], px, py) => move(panned(held, px - x, py - y)),
    zoom: (factor, px, py) => move(zoomed(view(), factor, px, py)),
    fit: () => move(null),
    hover,
  };
}

/** Shift with the arrows pans, plus and minus zoom, 0 fits. @param {Window} window */
export const windowKeys =
  ({ view, move }) =>
  /** @param {KeyboardEvent} event */
  ({ key, shiftKey }) => {
    const now = view();
    const [px, py] = middleOf(now);
    if (shiftKey && PAN[key]) move(panned(now, ...PAN[key]));
    else if (key === '+' || key === '=') move(zoomed(now, BY_KEY, px, py));
    else if (key === '-' || key === '_') move(zoomed(now, 1 / BY_KEY, px, py));
    else if (key === '0') move(null);
    else return false;
    return true;
  };

/**
 * The wheel zooms about the pointer, but not for a reader who scrolls the page past the picture: the pointer
 * has to move there first. Returns what stops listening to the page.
 * @param {HTMLCanvasElement} canvas @param {Ground} ground
 */
export function zoomByWheel(canvas, ground) {
  /** @type {number[] | null} */
  let last = null;
  let meant = false;
  const scrolled = () => {
    meant = false;
  };
  canvas.addEventListener('pointermove', ({ screenX, screenY }) => {
    if (last && (screenX !== last[0] || screenY !== last[1])) meant = true;
    last = [screenX, screenY];
  });
  canvas.addEventListener('pointerleave', () => ground.hover());
  canvas.addEventListener(
    'wheel',
    (event) => {
      if (!meant && !event.ctrlKey && document.activeElement !== canvas) return;
      event.preventDefault();
      const lines = event.deltaMode === 1 ? 16 : 1;
      const pinched = event.ctrlKey ? 6 : 1; // a trackpad's pinch comes as a wheel with Ctrl
      const [px, py] = placeOn(canvas, event);
      ground.zoom(Math.exp(-event.deltaY * lines * pinched * WHEEL), px, py);
    },
    { passive: false },
  );
  document.addEventListener('scroll', scrolled, { passive: true, capture: true });
  return () => document.removeEventListener('scroll', scrolled, { capture: true });
}
