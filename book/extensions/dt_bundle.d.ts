/** What the tables' script uses of DataTables, which itables brings along. */
export default class DataTable {
  constructor(table: HTMLElement, options: object);
  destroy(): void;
}
