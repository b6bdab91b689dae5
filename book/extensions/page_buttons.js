/** Do what the theme's buttons for printing and for the full screen ask for. */

document.addEventListener('click', (event) => {
  const at = event.target instanceof Element ? event.target.closest('[data-page-button]') : null;
  const name = at?.getAttribute('data-page-button');
  if (name === 'print') {
    window.print();
  }
  if (name === 'full-screen') {
    // The theme's script puts this function into the window.
    /** @type {Window & { toggleFullScreen?: () => void }} */ (window).toggleFullScreen?.();
  }
});
