// Draws what nobody asked for while the page rests: the first moves of a hand then find the code compiled. Once a page.
const ROUNDS = 150;
const SPARE = 3; // ms of rest that a round wants

let begun = false;

// draw: takes a state. Each round changes one of the gains by a little.
export function practise({ running }, state, draw) {
  if (begun) return;
  begun = true;
  const gains = Object.keys(running).filter((name) => running[name].magnitudes);
  let left = ROUNDS;
  const go = (rest) => {
    for (; left > 0 && rest.timeRemaining() > SPARE; left--) {
      const name = gains[left % gains.length];
      draw({ ...state, [name]: state[name] * (1 + 1e-3 * left) });
    }
    if (left > 0) requestIdleCallback(go);
  };
  globalThis.requestIdleCallback?.(go);
}
