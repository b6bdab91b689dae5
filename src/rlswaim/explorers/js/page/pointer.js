// Pointer, wheel, fingers and keys on a plane, told to the workbench as acts on poles, curve and window.
import { panned, zoomed } from '../drawing/camera.js';

const REACH = { mouse: 9, pen: 12, touch: 22 }; // px, around a pole or a curve
const STILL_CLICK = 4; // px that a click may move
const WHEEL = 0.0016;
const KEYS = { ArrowRight: 1, ArrowUp: 1, ArrowLeft: -1, ArrowDown: -1, PageUp: 10, PageDown: -10 };
const PAN = { ArrowRight: [-40, 0], ArrowLeft: [40, 0], ArrowUp: [0, 40], ArrowDown: [0, -40] };

// The point of a traced curve nearest to (px, py), if within reach: its branch, t along the chord, and its place.
export function nearestOn(points, view, px, py, reach) {
  let least = reach * reach;
  let found = null;
  const { X, Y } = view;
  for (let k = 1; k < points.length; k++) {
    const [a, b] = [points[k - 1], points[k]];
    for (let i = 0; i < a.x.length; i++) {
      const [ax, ay] = [X(a.x[i]), Y(Math.abs(a.y[i]))];
      const [dx, dy] = [X(b.x[i]) - ax, Y(Math.abs(b.y[i])) - ay];
      const length = dx * dx + dy * dy;
      const part = length ? Math.max(0, Math.min(1, ((px - ax) * dx + (py - ay) * dy) / length)) : 0;
      const off = (ax + part * dx - px) ** 2 + (ay + part * dy - py) ** 2;
      if (off >= least) continue;
      least = off;
      found = {
        branch: i,
        t: a.t + part * (b.t - a.t),
        x: a.x[i] + part * (b.x[i] - a.x[i]),
        y: a.y[i] + part * (b.y[i] - a.y[i]),
      };
    }
  }
  return found;
}

// The pole nearest to (px, py), if within reach; of two at one place the one above the axis.
export function nearestPole({ x, y }, view, px, py, reach) {
  let least = reach * reach;
  let found = -1;
  for (let i = 0; i < x.length; i++) {
    const off = (view.X(x[i]) - px) ** 2 + (view.Y(Math.abs(y[i])) - py) ** 2;
    if (off < least - 1e-9 || (found >= 0 && off < least + 1e-9 && y[found] < 0)) [least, found] = [off, i];
  }
  return found;
}

// acts: view(px, py), main(), pole(px, py, reach) -> index or -1, drag(index, px, py), dropped(), click(px, py, reach),
// open(index), hover(px, py, reach) or hover(), move(camera), fit(), step(places).
// Returns what stops listening to the page.
export function handlePointers(canvas, acts) {
  const down = new Map();
  let act = null;
  let last = null;
  let meant = false; // has the pointer moved here since the page was scrolled?

  const place = (event) => {
    const box = canvas.getBoundingClientRect();
    return [event.clientX - box.left, event.clientY - box.top];
  };
  const reachOf = (event) => REACH[event.pointerType] ?? REACH.mouse;

  function begin(event) {
    if (event.button > 0) return;
    canvas.setPointerCapture(event.pointerId);
    const [px, py] = place(event);
    down.set(event.pointerId, [px, py]);
    acts.hover();
    if (down.size === 2) {
      act = { kind: 'pinch' };
      return;
    }
    const pole = acts.pole(px, py, reachOf(event));
    act = { kind: pole >= 0 ? 'pole' : 'pan', pole, from: [px, py], view: acts.main(), moved: false };
  }

  function pinch(id, px, py) {
    const [other] = [...down].filter(([key]) => key !== id).map(([, at]) => at);
    const [qx, qy] = down.get(id);
    const before = Math.hypot(qx - other[0], qy - other[1]);
    const after = Math.hypot(px - other[0], py - other[1]);
    if (before > 0 && after > 0)
      acts.move(zoomed(acts.main(), after / before, (px + other[0]) / 2, (py + other[1]) / 2));
  }

  function move(event) {
    const [px, py] = place(event);
    if (last && (event.screenX !== last[0] || event.screenY !== last[1])) meant = true;
    last = [event.screenX, event.screenY];
    if (!down.has(event.pointerId)) return acts.hover(px, py, reachOf(event));
    if (act?.kind === 'pinch' && down.size === 2) pinch(event.pointerId, px, py);
    down.set(event.pointerId, [px, py]);
    if (!act?.from) return;
    const [dx, dy] = [px - act.from[0], py - act.from[1]];
    act.moved ||= Math.hypot(dx, dy) > STILL_CLICK;
    if (!act.moved) return;
    if (act.kind === 'pole') acts.drag(act.pole, px, py);
    else acts.move(panned(act.view, dx, dy));
  }

  function end(event) {
    if (!down.delete(event.pointerId)) return;
    const done = act;
    act = down.size ? act : null;
    if (!done?.from || event.type === 'pointercancel') return;
    if (done.moved) return acts.dropped();
    if (done.kind === 'pole') acts.open(done.pole);
    else acts.click(...place(event), reachOf(event));
  }

  // A finger on a pole drags it, two fingers zoom; else the page scrolls.
  function touched(event) {
    const box = canvas.getBoundingClientRect();
    const { clientX, clientY } = event.touches[0];
    if (event.touches.length > 1 || acts.pole(clientX - box.left, clientY - box.top, REACH.touch) >= 0)
      event.preventDefault();
  }

  // Who scrolls the page past the plane doesn't zoom it.
  const scrolled = () => (meant = false);

  function wheel(event) {
    if (!meant && !event.ctrlKey && document.activeElement !== canvas) return;
    event.preventDefault();
    const lines = event.deltaMode === 1 ? 16 : 1;
    const pinched = event.ctrlKey ? 6 : 1; // a trackpad's pinch comes as a wheel with Ctrl
    acts.move(zoomed(acts.main(), Math.exp(-event.deltaY * lines * pinched * WHEEL), ...place(event)));
  }

  canvas.addEventListener('pointerdown', begin);
  canvas.addEventListener('pointermove', move);
  canvas.addEventListener('pointerup', end);
  canvas.addEventListener('pointercancel', end);
  canvas.addEventListener('pointerleave', () => acts.hover());
  canvas.addEventListener('touchstart', touched, { passive: false });
  canvas.addEventListener('wheel', wheel, { passive: false });
  document.addEventListener('scroll', scrolled, { passive: true, capture: true });
  canvas.addEventListener('dblclick', (event) => acts.pole(...place(event), REACH.mouse) < 0 && acts.fit());
  return () => document.removeEventListener('scroll', scrolled, { capture: true });
}

export function handleKeys(node, acts) {
  node.addEventListener('keydown', (event) => {
    if (event.ctrlKey || event.metaKey || event.altKey) return;
    const view = acts.main();
    const middle = [view.frame.x + view.frame.w / 2, view.Y(Math.max(view.bottom, 0))];
    if (event.shiftKey && PAN[event.key]) acts.move(panned(view, ...PAN[event.key]));
    else if (KEYS[event.key]) acts.step(KEYS[event.key]);
    else if (event.key === '+' || event.key === '=') acts.move(zoomed(view, 1.25, ...middle));
    else if (event.key === '-' || event.key === '_') acts.move(zoomed(view, 0.8, ...middle));
    else if (event.key === '0') acts.fit();
    else return;
    event.preventDefault();
    event.stopPropagation();
  });
}
