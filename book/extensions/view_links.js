// A link into a live view, #rate-attitude:K_A=3, changes the view, which may stand far away: go there.

addEventListener('hashchange', () => {
  const name = /^#([\w-]+):/.exec(location.hash)?.[1];
  const view = document.querySelector(`[data-explorer="${name}"]`);
  (view?.closest('.live-view') ?? view)?.scrollIntoView();
});
