// A text that build.mjs puts into the scripts.
declare const MAP_WORKER: string;
