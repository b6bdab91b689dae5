// Computes the rows of the station map: in a worker, or in short turns on the page where no worker may start.
import { rows } from '../maths/abscissa.js';
import { inSlices, slice } from '../page/slices.js';

/** @typedef {import('./station_pixels.js').Part} Part */

const SLICE = 4; // ms
const PATIENCE = 1000; // ms, while paper waits

export class MapCalculator {
  /** @param {(parts: Part[]) => void} receive */
  constructor(receive) {
    this.receive = receive;
    this.id = 0; // of the last plan: what still comes of an earlier one is not taken
    /** @type {any} */
    this.plan = null;
    this.halt = () => {};
    /** @type {Worker | null} */
    this.worker = null;
    try {
      const address = URL.createObjectURL(new Blob([MAP_WORKER], { type: 'text/javascript' }));
      this.worker = new Worker(address, { type: 'module' });
      this.worker.onmessage = ({ data }) => data.id === this.id && receive(data.parts);
      this.worker.onerror = () => this.#withoutWorker();
    } catch {
      this.worker = null;
    }
  }

  #withoutWorker() {
    this.worker = null;
    if (this.plan) this.#here();
  }

  #here() {
    const { id } = this;
    const steps = /** @type {Generator<Part>} */ (rows(this.plan));
    this.halt = inSlices(steps, SLICE, ({ parts }) => id === this.id && this.receive(parts));
  }

  /** @param {object} plan */
  start(plan) {
    this.drop();
    this.plan = plan;
    if (this.worker) this.worker.postMessage({ id: this.id, plan });
    else this.#here();
  }

  /**
   * What comes within a second, now; the last plan counts no more. Returns whether that is all.
   * @param {object} plan
   */
  atOnce(plan) {
    this.drop();
    const { parts, done } = slice(/** @type {Generator<Part>} */ (rows(/** @type {any} */ (plan))), PATIENCE);
    this.receive(parts);
    return done;
  }

  /** The last plan counts no more. */
  drop() {
    this.halt();
    this.id += 1;
    this.plan = null;
  }

  stop() {
    this.drop();
    this.worker?.terminate();
  }
}
