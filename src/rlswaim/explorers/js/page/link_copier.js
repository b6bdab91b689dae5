// Copies the link of a view, or another text, and says whether it could.
import { inLab } from './address.js';
import { button, element, set } from './elements.js';
import { copy } from './take_away.js';

const WHILE = 4000; // ms that a message stands

export class LinkCopier {
  /** @param {() => void} writeAddress puts the present state into the address */
  constructor(writeAddress) {
    this.said = element('span', { class: 'said', 'aria-live': 'polite' });
    const act = () => {
      writeAddress();
      this.copy(location.href, 'link', 'in the address bar');
    };
    this.link = button('Copy link', act, { hidden: inLab() });
  }

  /** @param {string} text @param {string} what it is @param {string} where it stands as well */
  async copy(text, what, where) {
    this.say((await copy(text)) ? `${what} copied` : `no clipboard here: the ${what} stands ${where}`);
    setTimeout(() => this.say(''), WHILE);
  }

  /** @param {string} words */
  say(words) {
    set(this.said, words);
  }
}
