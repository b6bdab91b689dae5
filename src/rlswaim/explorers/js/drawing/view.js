// Which part of a plane a frame of the picture shows.
/** @import { Frame, View } from '../types.d.ts' */

const MARGIN = { left: 50, right: 12, top: 10, bottom: 36 };

/** The picture without its margin. @param {number} width @param {number} height @returns {Frame} */
export function frameOf(width, height, { left, right, top, bottom } = MARGIN) {
  return { x: left, y: top, w: Math.max(width - left - right, 1), h: Math.max(height - top - bottom, 1) };
}

/**
 * @param {number[]} x from and to @param {number[]} y from and to
 * @param {Frame} frame @param {number} width of the picture @param {number} height of the picture
 * @returns {View}
 */
export function viewOf([left, right], [bottom, top], frame, width, height) {
  const [sx, sy] = [frame.w / (right - left), frame.h / (top - bottom)];
  const [below, beside] = [frame.y + frame.h, frame.x + frame.w];
  return {
    ...{ left, right, bottom, top, sx, sy, scale: Math.max(sx, sy), tolerance: 0.25, frame, width, height },
    X: (x) => frame.x + (x - left) * sx,
    Y: (y) => below - (y - bottom) * sy,
    x: (px) => left + (px - frame.x) / sx,
    y: (py) => bottom + (below - py) / sy,
    holds: (px, py) => px >= frame.x && px <= beside && py >= frame.y && py <= below,
  };
}
