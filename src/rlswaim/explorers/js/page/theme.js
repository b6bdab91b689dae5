// The colors of the page's theme, light or dark.
import { signsOf } from '../drawing/marks.js';

/** @import { Theme } from '../types.d.ts' */

/**
 * A color of the print figures with a share of white: lighter on a dark page.
 * @param {string} color @param {number} share
 */
function lightened(color, share) {
  if (!share) return color;
  const parts = color
    .match(/[0-9a-f]{2}/gi)
    .map((hex) => Math.round(parseInt(hex, 16) * (1 - share) + 255 * share));
  return `rgb(${parts.join()})`;
}

/**
 * The page's colors, and those of a view's own things, each with a sign in the order of their names.
 * @param {Element} root @param {Record<string, string>} own
 * @returns {Theme}
 */
export function themeOf(root, own) {
  const style = getComputedStyle(root);
  /** @param {string} name */
  const read = (name) => style.getPropertyValue(`--${name}`).trim();
  const names = Object.keys(own);
  const colors = new Map(names.map((name) => [name, lightened(own[name], Number(read('lift')))]));
  const signs = signsOf(names);
  return {
    plane: read('plane'),
    unstable: read('unstable'),
    grid: read('grid'),
    axis: read('axis'),
    ink: read('ink'),
    muted: read('muted'),
    color: (name) => colors.get(name),
    sign: (name) => signs.get(name),
  };
}

/** Returns what stops watching. @param {() => void} act */
export function onThemeChange(act) {
  const watch = new MutationObserver(act);
  for (const node of [document.documentElement, document.body]) {
    watch.observe(node, {
      attributes: true,
      attributeFilter: ['data-theme', 'data-mode', 'data-jp-theme-light', 'class'],
    });
  }
  const media = matchMedia('(prefers-color-scheme: dark)');
  media.addEventListener('change', act);
  return () => {
    watch.disconnect();
    media.removeEventListener('change', act);
  };
}
