// Undo and redo over snapshots of the state. A drag, however long the hand rests in it, or a run of quick changes is one step.
import { button } from './dom.js';

const QUIET = 400; // ms

let held = false; // is a button or a finger down?
for (const [event, now] of [
  ['pointerdown', true],
  ['pointerup', false],
  ['pointercancel', false],
]) {
  addEventListener(event, () => (held = now), { capture: true, passive: true });
}

export class History {
  constructor(read, write, changed) {
    Object.assign(this, { read, write, changed, past: [], future: [] });
    this.present = read();
  }

  // Something changed: a step ends when nothing more changes for a while.
  note() {
    clearTimeout(this.timer);
    this.timer = setTimeout(() => (held ? this.note() : this.settle()), QUIET);
  }

  settle() {
    clearTimeout(this.timer);
    const now = this.read();
    if (now === this.present) return;
    this.past.push(this.present);
    this.present = now;
    this.future = [];
    this.changed();
  }

  #move(from, to) {
    this.settle();
    if (from.length === 0) return;
    to.push(this.present);
    this.present = from.pop();
    this.write(this.present);
    this.changed();
  }

  undo() {
    this.#move(this.past, this.future);
  }

  redo() {
    this.#move(this.future, this.past);
  }

  stop() {
    clearTimeout(this.timer);
  }
}

// Ctrl+Z anywhere in a view or on its sliders, but not in a field that has an undo of its own.
function undone(event, el, history) {
  if (!(event.ctrlKey || event.metaKey) || event.key.toLowerCase() !== 'z') return;
  const room = el.closest('.side, .widget-vbox') ?? el;
  if (!room.contains(event.target) || event.target.matches('input:not([type=range]), textarea')) return;
  event.preventDefault();
  if (event.shiftKey) history.redo();
  else history.undo();
}

// Returns what stops listening.
export function onUndoKeys(el, history) {
  const keys = (event) => undone(event, el, history);
  document.addEventListener('keydown', keys);
  return () => document.removeEventListener('keydown', keys);
}

// Buttons for both, and what tells them how far they can go.
export function undoButtons(history) {
  const [undo, redo] = [
    button('↶', () => history.undo(), { 'aria-label': 'undo', title: 'undo (Ctrl+Z)' }),
    button('↷', () => history.redo(), { 'aria-label': 'redo', title: 'redo (Ctrl+Shift+Z)' }),
  ];
  const tell = () => {
    undo.disabled = history.past.length === 0;
    redo.disabled = history.future.length === 0;
  };
  return { undo, redo, tell };
}
