// When a view is drawn.

const REST = 150; // ms without a change, for a view that nobody sees

/**
 * What the hand changes is drawn at once, when all changes of its event are in; a second time in one frame
 * waits for the next frame, and so does what follows from the page's own layout. Off the screen a view waits
 * until nothing changes.
 */
export class Redraw {
  /** @param {Element} el @param {() => void} draw */
  constructor(el, draw) {
    this.draw = draw;
    this.frame = 0;
    this.timer = 0;
    this.due = false;
    this.seen = false;
    this.drawn = false;
    this.watch = new IntersectionObserver((entries) => this.#note(entries.at(-1).isIntersecting), {
      rootMargin: '200px',
    });
    this.watch.observe(el);
  }

  /** @param {boolean} seen */
  #note(seen) {
    const shows = seen && !this.seen;
    this.seen = seen;
    if (shows) this.next();
  }

  #go() {
    clearTimeout(this.timer);
    this.due = false;
    this.drawn = true;
    this.draw();
  }

  #frame() {
    this.due = true;
    this.frame ||= requestAnimationFrame(() => {
      this.frame = 0;
      if (this.due) this.#go();
    });
  }

  /** With the next frame. */
  next() {
    if (this.seen || !this.drawn) return this.#frame();
    clearTimeout(this.timer);
    this.timer = window.setTimeout(() => this.#frame(), REST);
  }

  /** When the present event is over. */
  now() {
    const atOnce = this.seen && this.frame === 0;
    this.next();
    if (atOnce) queueMicrotask(() => this.due && this.#go());
  }

  stop() {
    this.due = false;
    this.watch.disconnect();
    clearTimeout(this.timer);
    cancelAnimationFrame(this.frame);
  }
}
