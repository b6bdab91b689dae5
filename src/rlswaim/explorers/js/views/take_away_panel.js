// What a reader takes away from a workbench: the link, the picture, the poles, the call of the library.
import { inLab } from '../page/address.js';
import { button, element, panel, set } from '../page/elements.js';
import { polesAsText } from '../page/pole_table.js';
import { copy, download, pythonOf, svgOf } from '../page/take_away.js';

/** @import { Workbench } from './workbench.js' */

const WHILE = 4000; // ms that a message stands

export class TakeAway {
  /** @param {Workbench} bench */
  constructor(bench) {
    this.bench = bench;
    this.said = element('span', { class: 'said', 'aria-live': 'polite' });
    this.link = button('Copy link', () => this.#copy(this.#address(), 'link'), { hidden: inLab() });
    this.code = element('code');
    const row = element(
      'div',
      { class: 'controls' },
      button('Picture (SVG)', () => this.#savePicture()),
      button('Poles (CSV)', () => this.#savePoles()),
      button('Copy as Python', () => this.#copy(this.#call(), 'call')),
    );
    const shown = element('pre', { tabindex: '0' }, this.code);
    const title = 'Take away: picture, poles, Python';
    this.node = panel('takeaway', title, () => this.bench.page.later(), row, shown).node;
  }

  #address() {
    this.bench.page.writeAddress();
    return location.href;
  }

  #call() {
    return pythonOf(this.bench.system, this.bench.state.values);
  }

  /** @param {string} text @param {'link' | 'call'} what */
  async #copy(text, what) {
    const where = what === 'link' ? 'in the address bar' : 'below';
    this.say((await copy(text)) ? `${what} copied` : `no clipboard here: the ${what} stands ${where}`);
    setTimeout(() => this.say(''), WHILE);
  }

  /** @param {string} words */
  say(words) {
    set(this.said, words);
  }

  #savePoles() {
    download(`${this.bench.system.system}-poles.csv`, 'text/csv', polesAsText(this.bench.poles));
  }

  #savePicture() {
    const { plane, page, system } = this.bench;
    const { width, height } = plane.view;
    const title = plane.canvas.ariaLabel ?? system.system;
    const text = svgOf(width, height, title, page.theme.plane, (g) => plane.paint(g));
    download(`${system.system}-locus.svg`, 'image/svg+xml', text);
  }

  /** The call of the library follows when the hand rests. */
  later() {
    set(this.code, this.#call());
  }
}
