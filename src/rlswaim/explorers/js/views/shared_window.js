// One window on the s plane for several workbenches: it holds the poles of all, and where one goes all go.

/** @import { Camera } from '../types.d.ts' */
/** @import { Workbench } from './workbench.js' */

export class SharedWindow {
  constructor() {
    /** @type {Map<Workbench, number[][]>} */
    this.points = new Map();
    /** @type {Camera | null} */
    this.camera = null;
  }

  /**
   * What all planes hold: the points of this one, which it tells, and those of the others.
   * @param {Workbench} bench @param {number[][]} points
   */
  with(bench, points) {
    this.points.set(bench, points);
    return [...this.points.values()].flat();
  }

  /** The others follow a plane whose window is another now. @param {Workbench} bench */
  drawn(bench) {
    const { camera } = bench.state.shown;
    const moved = camera !== this.camera;
    this.camera = camera;
    const key = windowKey(bench);
    for (const other of this.points.keys()) {
      if (moved) other.state.shown.camera = camera;
      if (other !== bench && windowKey(other) !== key) other.page.follow();
    }
  }

  /** @param {Workbench} bench */
  leave(bench) {
    this.points.delete(bench);
  }
}

/** @param {Workbench} bench */
const windowKey = ({ plane: { view } }) => view && [view.left, view.right, view.bottom].join();
