(() => {
  'use strict';
  /** Opens all that a place is folded in, and shows it. */
  const show = (name) => {
    const place = name && document.getElementById(name);
    if (!place) return;
    let opened = false;
    for (let at = place; at; at = at.parentElement) {
      if (at.localName === 'details' && !at.open) {
        at.open = true;
        opened = true;
      }
    }
    if (opened) place.scrollIntoView();
  };
  const named = (hash) => {
    try {
      return decodeURIComponent(hash.slice(1));
    } catch {
      return '';
    }
  };
  window.addEventListener('hashchange', () => show(named(location.hash)));
  document.addEventListener('click', (event) => {
    // A second click on a link changes no address.
    const link = event.target.closest?.('a[href^="#"]');
    if (link) show(named(link.hash));
  });
  show(named(location.hash));
  // What scrolls by itself is reached by keyboard, and nothing else is.
  const boxes = new ResizeObserver((list) => {
    for (const { target } of list) {
      if (target.scrollWidth > target.clientWidth) target.tabIndex = 0;
      else target.removeAttribute('tabindex');
    }
  });
  for (const box of document.querySelectorAll('.formula, .card')) boxes.observe(box);
  // Paper shows the parts that are open.
  const unfold = document.getElementById('unfold');
  if (unfold) {
    unfold.hidden = false;
    unfold.addEventListener('click', () => {
      for (const part of document.querySelectorAll('main details')) {
        if (!part.closest('figure.view')) part.open = true;
      }
      unfold.hidden = true;
    });
  }
})();
