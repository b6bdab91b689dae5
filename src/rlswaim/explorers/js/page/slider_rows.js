// The sliders above a view stay in sight while the page scrolls under them: all of them where they take less
// than half of the screen, else the one in use.

const MOST = 0.45; // of the screen's height
const USES = ['pointerdown', 'focusin'];

/** The page's own header keeps the top of the window. */
const headerHeight = () =>
  /** @type {HTMLElement} */ (document.querySelector('.bd-header-article'))?.offsetHeight ?? 0;

/**
 * Returns what lets them go.
 * @param {HTMLElement} panel the sliders and the view
 */
export function keepInSight(panel) {
  const box = /** @type {HTMLElement} */ (panel.querySelector(':scope > .rlswaim-sliders'));
  if (!box) return () => {};
  const rows = [...box.children];
  panel.classList.add('rlswaim-panel');
  const place = () => {
    panel.classList.remove('one-sticks');
    const isWhole = box.offsetHeight <= MOST * innerHeight;
    const height = isWhole ? box.offsetHeight : /** @type {HTMLElement} */ (rows[0]).offsetHeight;
    panel.classList.toggle('one-sticks', !isWhole);
    panel.style.setProperty('--header', `${headerHeight()}px`);
    panel.style.setProperty('--rows', `${height}px`);
  };
  /** @param {unknown} target */
  const use = (target) => {
    const used = rows.find((row) => row.contains(/** @type {Node} */ (target)));
    for (const row of used ? rows : []) row.classList.toggle('in-use', row === used);
  };
  const used = (/** @type {Event} */ { target }) => use(target);
  const resized = new ResizeObserver(place);
  resized.observe(panel);
  addEventListener('resize', place);
  for (const kind of USES) panel.addEventListener(kind, used);
  use(rows[0]);
  return () => {
    resized.disconnect();
    removeEventListener('resize', place);
    for (const kind of USES) panel.removeEventListener(kind, used);
  };
}
