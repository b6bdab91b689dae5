// What a reader takes away from a workbench: the link, the picture, the poles, the call of the library.

import { pythonWith } from '../page/compensator_python.js';
import { button, element, panel, set } from '../page/elements.js';
import { LinkCopier } from '../page/link_copier.js';
import { polesAsText } from '../page/pole_table.js';
import { pythonOfLoop } from '../page/python_of_loop.js';
import { download, fileName, svgOf } from '../page/take_away.js';

/** @import { Workbench } from './workbench.js' */

export class TakeAway {
  /** @param {Workbench} bench */
  constructor(bench) {
    this.bench = bench;
    this.copier = new LinkCopier(() => this.bench.page.writeAddress());
    this.link = this.copier.link;
    this.said = this.copier.said;
    this.code = element('code');
    const row = element(
      'div',
      { class: 'controls' },
      button('Picture (SVG)', () => this.#savePicture()),
      button('Poles (CSV)', () => this.#savePoles()),
      button('Copy as Python', () => this.copier.copy(this.#call(), 'call', 'below')),
    );
    const shown = element('pre', { tabindex: '0' }, this.code);
    const title = 'Take away: picture, poles, Python';
    this.node = panel('takeaway', title, () => this.bench.page.later(), row, shown).node;
  }

  #call() {
    const { system, state } = this.bench;
    const compensator = state.inLoop === state.system ? null : state.compensator;
    if (system.given) return pythonOfLoop(system.given, state.values.k, compensator);
    return pythonWith(system, state.values, compensator);
  }

  /** @param {string} words */
  say(words) {
    this.copier.say(words);
  }

  /** @param {string} what */
  #fileName(what) {
    const { system, state } = this.bench;
    return fileName(system.system, system.given ? { k: state.values.k } : state.told, what);
  }

  #savePoles() {
    const { poles, state, words } = this.bench;
    download(this.#fileName('poles.csv'), 'text/csv', polesAsText(poles, state.values, words.poles));
  }

  #savePicture() {
    const { plane, page, system } = this.bench;
    const { width, height } = plane.view;
    const title = plane.canvas.ariaLabel ?? system.system;
    const text = svgOf(width, height, title, page.theme.plane, (g) => plane.paint(g));
    download(this.#fileName('locus.svg'), 'image/svg+xml', text);
  }

  /** The call of the library follows when the hand rests. */
  later() {
    set(this.code, this.#call());
  }
}
