// A line at the top of a view: that a shared state was opened, what of it was changed, what went wrong.
import { button, element, set } from './elements.js';

const MOST = 3; // notes that are told one by one

export class Notice {
  /** @param {() => void} reset back to the start of the view */
  constructor(reset) {
    this.words = element('output'); // a status
    this.reset = button('Back to the start', reset, { hidden: true });
    this.node = element('div', { class: 'notice' }, this.words, this.reset);
    this.hasFailed = false;
  }

  /** @param {string} words */
  #say(words) {
    set(this.words, words);
    this.reset.hidden = words === '';
  }

  /** A state came with the address. @param {string[]} notes on what of it was changed */
  opened(notes) {
    const more = notes.length > MOST ? [`So are ${notes.length - MOST} more entries of the address.`] : [];
    this.#say(['A shared state was opened.', ...notes.slice(0, MOST), ...more].join(' '));
  }

  /** A text in a box was changed. @param {string} note */
  typed(note) {
    set(this.words, note);
  }

  /** @param {unknown} error */
  failed(error) {
    console.error(error);
    this.hasFailed = true;
    const reason = error instanceof Error ? error.message : String(error);
    this.#say(`This state could not be drawn (${reason}). Move a slider, or go back.`);
  }

  /** What failed before has gone well. */
  mended() {
    if (!this.hasFailed) return;
    this.hasFailed = false;
    this.clear();
  }

  clear() {
    if (this.words.textContent) this.#say('');
  }
}
