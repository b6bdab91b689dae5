// A movable point on a picture: mouse, pen and finger drag it, keys step it, and its own constraint says
// where it may be.
/**
 * @typedef {object} MovablePoint
 * @property {(px: number, py: number, reach: number) => number} grab the number of the point there, else -1
 * @property {(index: number, px: number, py: number) => void} drag to the place allowed that is nearest
 * @property {() => void} [drop] the drag is over
 * @property {(index: number) => void} [open] a click on a point
 * @property {(px: number, py: number, reach: number) => void} [click] a click beside all points
 * @property {(right: number, up: number) => void} step by so many places
 */
/**
 * @typedef {object} Ground what a pointer does that holds no point; without it nothing
 * @property {(from: number[], px: number, py: number) => void} pan
 * @property {() => void} hold a drag of the ground begins
 * @property {(factor: number, px: number, py: number) => void} zoom
 * @property {() => void} fit
 * @property {(px?: number, py?: number, reach?: number) => void} hover without arguments: the pointer is away
 */

/** @type {Record<string, number>} */
const REACH = { mouse: 9, pen: 12, touch: 22 }; // px
const STILL_CLICK = 4; // px that a click may move

/** @type {Record<string, [number, number]>} */
const STEPS = {
  ArrowRight: [1, 0],
  ArrowLeft: [-1, 0],
  ArrowUp: [0, 1],
  ArrowDown: [0, -1],
  PageUp: [0, 10],
  PageDown: [0, -10],
};

/** @param {PointerEvent} event */
export const reachOf = ({ pointerType }) => REACH[pointerType] ?? REACH.mouse;

/** Where on a canvas, in px. @param {Element} canvas @param {{ clientX: number, clientY: number }} event */
export function placeOn(canvas, { clientX, clientY }) {
  const { left, top } = canvas.getBoundingClientRect();
  return [clientX - left, clientY - top];
}

/** The pointers that are down on a canvas: one drags a point or the ground, two zoom. */
class Pointers {
  /** @param {HTMLCanvasElement} canvas @param {MovablePoint} point @param {Ground} [ground] */
  constructor(canvas, point, ground) {
    this.canvas = canvas;
    this.point = point;
    this.ground = ground;
    /** @type {Map<number, number[]>} */
    this.down = new Map();
    /** @type {{ index: number, from: number[], moved: boolean } | null} */
    this.act = null;
  }

  /** @param {PointerEvent} event */
  begin(event) {
    if (event.button > 0) return;
    const [px, py] = placeOn(this.canvas, event);
    this.canvas.setPointerCapture(event.pointerId);
    this.down.set(event.pointerId, [px, py]);
    this.ground?.hover();
    this.act = null;
    if (this.down.size > 1) return;
    this.act = { index: this.point.grab(px, py, reachOf(event)), from: [px, py], moved: false };
    this.ground?.hold();
  }

  /** @param {number} id @param {number} px @param {number} py */
  #pinch(id, px, py) {
    const [other] = [...this.down].filter(([key]) => key !== id).map(([, at]) => at);
    const [qx, qy] = this.down.get(id);
    const before = Math.hypot(qx - other[0], qy - other[1]);
    const after = Math.hypot(px - other[0], py - other[1]);
    if (before > 0 && after > 0) this.ground?.zoom(after / before, (px + other[0]) / 2, (py + other[1]) / 2);
  }

  /** @param {PointerEvent} event */
  move(event) {
    const [px, py] = placeOn(this.canvas, event);
    if (!this.down.has(event.pointerId)) return this.ground?.hover(px, py, reachOf(event));
    if (!this.act && this.down.size === 2) this.#pinch(event.pointerId, px, py);
    this.down.set(event.pointerId, [px, py]);
    const { act } = this;
    if (!act) return;
    act.moved ||= Math.hypot(px - act.from[0], py - act.from[1]) > STILL_CLICK;
    if (!act.moved) return;
    if (act.index >= 0) this.point.drag(act.index, px, py);
    else this.ground?.pan(act.from, px, py);
  }

  /** @param {PointerEvent} event */
  end(event) {
    if (!this.down.delete(event.pointerId)) return;
    const { act, point } = this;
    if (this.down.size === 0) this.act = null;
    if (!act || event.type === 'pointercancel') return;
    if (act.moved) return point.drop?.();
    const [px, py] = placeOn(this.canvas, event);
    if (act.index >= 0 && point.open) point.open(act.index);
    else point.click?.(px, py, reachOf(event));
  }

  /** A finger on a point drags it, two fingers zoom; else the page scrolls. @param {TouchEvent} event */
  touch(event) {
    const [px, py] = placeOn(this.canvas, event.touches[0]);
    if (event.touches.length > 1 || this.point.grab(px, py, REACH.touch) >= 0) event.preventDefault();
  }
}

/** @param {HTMLCanvasElement} canvas @param {MovablePoint} point @param {Ground} [ground] */
export function movable(canvas, point, ground) {
  const pointers = new Pointers(canvas, point, ground);
  canvas.addEventListener('pointerdown', (event) => pointers.begin(event));
  canvas.addEventListener('pointermove', (event) => pointers.move(event));
  canvas.addEventListener('pointerup', (event) => pointers.end(event));
  canvas.addEventListener('pointercancel', (event) => pointers.end(event));
  canvas.addEventListener('touchstart', (event) => pointers.touch(event), { passive: false });
}

/**
 * Steps the point by the arrow keys; other keys are somebody else's.
 * @param {HTMLElement} node @param {MovablePoint} point
 * @param {(event: KeyboardEvent) => boolean} [other] whether it took a key, before the arrows do
 */
export function movableByKeys(node, point, other) {
  node.addEventListener('keydown', (event) => {
    if (event.ctrlKey || event.metaKey || event.altKey) return;
    if (!other?.(event)) {
      if (!STEPS[event.key]) return;
      const times = event.shiftKey ? 10 : 1;
      point.step(...scaled(STEPS[event.key], times));
    }
    event.preventDefault();
    event.stopPropagation();
  });
}

/** @param {[number, number]} step @param {number} times @returns {[number, number]} */
const scaled = ([right, up], times) => [times * right, times * up];
