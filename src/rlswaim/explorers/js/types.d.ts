// Shapes of data that several scripts share.

/** Parts of roots, by place. */
export type Numbers = ArrayLike<number>;
export interface Roots {
  x: Numbers;
  y: Numbers;
}
/** Roots, each with the name of the branch that it lies on. */
export interface NamedRoots extends Roots {
  branches: string[];
}
/** All branches of a locus at one value t of what runs. */
export interface Point extends Roots {
  t: number;
}
export interface Pole {
  re: number;
  im: number;
  name: string;
}
export interface Crossing {
  gain: number;
  omega: number;
  direction: number;
}
export interface Locus {
  from: number;
  end: number;
  open: NamedRoots;
  zeros: Roots;
  breaks: { x: number; y: number }[];
  crossings: Crossing[];
  branches: Point[];
  present: Point;
}

/** What a locus draws: which parameter runs, which gains are off, whether it shows poles or zeros. */
export interface What {
  running: string;
  off: string[];
  of: string;
  gain?: string;
  name?: string;
}

/** A rectangle of the picture in px. */
export interface Frame {
  x: number;
  y: number;
  w: number;
  h: number;
}
/**
 * The part of a plane that a frame shows: its borders, px per unit, and the way from one to the other and
 * back.
 */
export interface View {
  left: number;
  right: number;
  bottom: number;
  top: number;
  sx: number;
  sy: number;
  /** px per unit and px of error, for tracing */
  scale: number;
  tolerance: number;
  frame: Frame;
  width: number;
  height: number;
  X(x: number): number;
  Y(y: number): number;
  x(px: number): number;
  y(py: number): number;
  holds(px: number, py: number): boolean;
}
/** A window on the s plane for any size of the picture: its center, lower border and width. */
export interface Camera {
  x: number;
  y: number;
  w: number;
}

/** The calls that drawings make of a canvas's context, and that an SVG takes as well. */
export type Graphics = Pick<
  CanvasRenderingContext2D,
  | 'arc'
  | 'beginPath'
  | 'clearRect'
  | 'clip'
  | 'closePath'
  | 'fill'
  | 'fillRect'
  | 'fillText'
  | 'lineTo'
  | 'moveTo'
  | 'rect'
  | 'restore'
  | 'rotate'
  | 'save'
  | 'setLineDash'
  | 'stroke'
  | 'strokeText'
  | 'translate'
> & {
  fillStyle: unknown;
  strokeStyle: unknown;
  lineWidth: number;
  font: string;
  lineJoin: string;
  textAlign: string;
  textBaseline: string;
  globalAlpha: number;
};

/** Colors of the page, and of a view's own things by name, each of which has a sign too. */
export interface Theme {
  plane: string;
  unstable: string;
  grid: string;
  axis: string;
  ink: string;
  muted: string;
  color(name: string): string;
  sign(name: string): string;
}

/** What anywidget gives a view: the traits of the widget in Python. */
export interface Model {
  get(name: string): any;
  set(name: string, value: unknown): void;
  save_changes(): void;
  on(event: string, act: () => void): void;
  off(event: string, act: () => void): void;
}
export interface Context {
  model: Model;
  el: HTMLElement;
}

/** Values of parameters by name: numbers, and texts where a parameter is a choice. */
export type Values = Record<string, any>;
export interface Parameter {
  name: string;
  grid: any[];
  unit?: string;
  meaning?: string;
}
export interface Payload {
  view: string;
  system: string;
  parameters: Parameter[];
  own: string[];
  initial: Values;
  presets: any[];
  [name: string]: any;
}
/** What Python sends of a control system. */
export type System = Payload & import('./maths/terms.js').System;

/** Does work step by step. */
export type Steps<Part, Result> = Generator<Part, Result>;
