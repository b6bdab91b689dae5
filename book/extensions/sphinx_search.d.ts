/** What Sphinx's searchtools.js and language_data.js give to the page of the search. */
declare var WORDS_AND_NUMBERS: RegExp;
declare var splitQuery: (query: string) => string[];
declare const Search: {
  htmlToText: (page: string, anchor: string) => string;
  makeSearchSummary: (page: string, words: Set<string>, anchor: string) => HTMLElement | null;
};
