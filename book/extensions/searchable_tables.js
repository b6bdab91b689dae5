/** Make the tables of cells with the tag "searchable" searchable; on paper all of their rows stand. */
import DataTable from './dt_bundle.js';

/** @type {object} */
const OPTIONS = {
  autoWidth: false,
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
