// Undo and redo over snapshots of a state. A drag is one step, however long the hand rests in it, and so is a
// run of quick changes.
import { button } from './elements.js';

const QUIET = 400; // ms

let held = false; // is a button or a finger down?
/** @type {[string, boolean][]} */
const HOLDS = [
  ['pointerdown', true],
  ['pointerup', false],
  ['pointercancel', false],
];
for (const [event, now] of HOLDS) {
  addEventListener(
    event,
    () => {
      held = now;
    },
    { capture: true, passive: true },
  );
}

export class UndoHistory {
  /** @param {{ snapshot(): string, restore(snapshot: string): void }} state */
  constructor(state) {
    this.state = state;
    this.timer = 0;
    this.present = '';
    this.undoButton = button('↶', () => this.undo(), { 'aria-label': 'undo', title: 'undo (Ctrl+Z)' });
    this.redoButton = button('↷', () => this.redo(), { 'aria-label': 'redo', title: 'redo (Ctrl+Shift+Z)' });
    this.begin();
  }

  get buttons() {
    return [this.undoButton, this.redoButton];
  }

  /** From the present state on. */
  begin() {
    this.present = this.state.snapshot();
    /** @type {string[]} */
    this.past = [];
    /** @type {string[]} */
    this.future = [];
    this.#tell();
  }

  /** Something changed: a step ends when nothing more changes for a while. */
  note() {
    clearTimeout(this.timer);
    this.timer = window.setTimeout(() => (held ? this.note() : this.settle()), QUIET);
  }

  settle() {
    clearTimeout(this.timer);
    const now = this.state.snapshot();
    if (now === this.present) return;
    this.past.push(this.present);
    this.present = now;
    this.future = [];
    this.#tell();
  }

  /** @param {'past' | 'future'} from @param {'past' | 'future'} to */
  #move(from, to) {
    this.settle();
    if (this[from].length === 0) return;
    this[to].push(this.present);
    this.present = this[from].pop();
    this.state.restore(this.present);
    this.#tell();
  }

  undo() {
    this.#move('past', 'future');
  }

  redo() {
    this.#move('future', 'past');
  }

  /** The buttons tell whether there is a step to go. */
  #tell() {
    this.undoButton.disabled = this.past.length === 0;
    this.redoButton.disabled = this.future.length === 0;
  }

  stop() {
    clearTimeout(this.timer);
  }
}

/** Ctrl+Z anywhere in a view or on its sliders, but not in a field that has an undo of its own.
 * @param {KeyboardEvent} event @param {Element} el @param {UndoHistory} history
 */
function undone(event, el, history) {
  if (!(event.ctrlKey || event.metaKey) || event.key.toLowerCase() !== 'z') return;
  const room = el.closest('.bench, .side, .widget-vbox') ?? el;
  const target = /** @type {Element} */ (event.target);
  if (target.closest?.('.bench') !== el.closest('.bench')) return; // a bench in the view has its own steps
  if (!room.contains(target) || target.matches('input:not([type=range]), textarea')) return;
  event.preventDefault();
  if (event.shiftKey) history.redo();
  else history.undo();
}

/** Returns what stops listening. @param {Element} el @param {UndoHistory} history */
export function onUndoKeys(el, history) {
  /** @param {KeyboardEvent} event */
  const keys = (event) => undone(event, el, history);
  document.addEventListener('keydown', keys);
  return () => document.removeEventListener('keydown', keys);
}
