// Undo and redo over snapshots of the state. A run of quick changes, such as a drag, is one step.

const QUIET = 400; // ms

export class History {
  constructor(read, write, changed) {
    Object.assign(this, { read, write, changed, past: [], future: [] });
    this.present = read();
  }

  // Something changed: a step ends when nothing more changes for a while.
  note() {
    clearTimeout(this.timer);
    this.timer = setTimeout(() => this.settle(), QUIET);
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
