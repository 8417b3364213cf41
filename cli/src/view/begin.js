for (const root of document.querySelectorAll('figure.view')) {
  const data = JSON.parse(root.querySelector('script[type="application/json"]').textContent);
  try {
    root.player = new Player(root, data);
    if (data.live) root.player.live = new Live(root.player, EQUATIONS[data.live.equations]);
    root.classList.add('ready');
    // In a page it begins when somebody has come to it.
    if (data.alone && !root.player.calm.matches) root.player.play();
    else if (!root.player.calm.matches) {
      new IntersectionObserver((list, watch) => {
        if (!list.some((each) => each.isIntersecting)) return;
        watch.disconnect();
        root.player.play();
      }, { threshold: 0.6 }).observe(root.player.stage);
    }
  } catch (error) {
    root.classList.add('without');
    root.querySelector('.view-said').textContent = `This browser cannot draw the view (${error.message}).`;
  }
}
