// What the runtime finds on the page, and packages without types.
declare const RUNTIME_CSS: string;
declare var MathJax: any;
declare module 'anywidget' {
  /** @param base the module `@jupyter-widgets/base`; gives the classes of the package by name */
  export default function anywidget(base: object): Record<string, unknown>;
}
