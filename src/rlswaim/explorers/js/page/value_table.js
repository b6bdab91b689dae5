// A table of texts whose cells change alone when their text does.
import { element, headRow, scrolling, set } from './elements.js';

/** @typedef {{ cells: string[], data?: Record<string, unknown> }} Row */

export class ValueTable {
  /** @param {string} caption @param {string[]} heads */
  constructor(caption, heads) {
    this.heads = heads;
    this.body = element('tbody');
    const table = element(
      'table',
      { class: 'values' },
      element('caption', {}, caption),
      headRow(heads),
      this.body,
    );
    this.node = scrolling(caption, table);
  }

  /** @param {Row[]} rows */
  show(rows) {
    while (this.body.rows.length < rows.length) {
      const cells = this.heads.slice(1).map(() => element('td'));
      this.body.append(element('tr', {}, element('th', { scope: 'row' }), ...cells));
    }
    while (this.body.rows.length > rows.length) this.body.lastChild.remove();
    rows.forEach(({ cells, data = {} }, i) => {
      const row = this.body.rows[i];
      for (const [name, value] of Object.entries(data)) row.dataset[name] = String(value);
      cells.forEach((text, k) => {
        set(row.cells[k], text);
      });
    });
  }
}
