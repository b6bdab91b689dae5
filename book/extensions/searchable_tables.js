/** Make the tables of cells with the tag "searchable" searchable; on paper all of their rows stand. */
import DataTable from './dt_bundle.js';

const GREEK = 'alpha beta gamma delta epsilon zeta eta theta iota kappa lambda mu nu xi omicron pi rho';
const NAMES = `${GREEK} sigma sigma tau upsilon phi chi psi omega`.split(' ');

/**
 * A cell as its reader may type it: a symbol with its index as K_A, a Greek letter as itself and by its name.
 * @param {string} html
 */
function asTyped(html) {
  const text = String(html)
    .replace(/<sub[^>]*>/g, '_')
    .replace(/<[^>]+>/g, '');
  return `${text} ${text.replace(/[α-ω]/g, (letter) => NAMES[letter.charCodeAt(0) - 'α'.charCodeAt(0)])}`;
}

/** @type {object} */
const OPTIONS = {
  autoWidth: false,
  columnDefs: [
    {
      targets: '_all',
      render: (/** @type {string} */ data, /** @type {string} */ use) =>
        use === 'filter' ? asTyped(data) : data,
    },
  ],
  layout: { bottomEnd: 'paging', bottomStart: 'info', topEnd: 'search', topStart: 'pageLength' },
  lengthMenu: [10, 25, 100, 1000],
  order: [],
  scrollX: true,
};

/** What can be scrolled can be reached by the keyboard. @param {HTMLElement} table */
function reachable(table) {
  const box = table.closest('.dt-scroll-body');
  box?.setAttribute('tabindex', '0');
  box?.setAttribute('role', 'region');
  box?.setAttribute('aria-label', 'All printed numbers');
}

/** A plain table stands on paper, whose head repeats on each page. @param {HTMLElement} table */
function makeSearchable(table) {
  let shown = new DataTable(table, OPTIONS);
  reachable(table);
  window.addEventListener('beforeprint', () => shown.destroy());
  window.addEventListener('afterprint', () => {
    shown = new DataTable(table, OPTIONS);
    reachable(table);
  });
}

for (const table of document.querySelectorAll('.tag_searchable table')) {
  table.id = 'printed-numbers';
  table.classList.add('display', 'compact');
  makeSearchable(/** @type {HTMLElement} */ (table));
}
