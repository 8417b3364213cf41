const digits = (x, count = 3) => (Number.isFinite(x) ? String(Number(x.toPrecision(count))) : '–').replace('-', '−');

/** A factor of speed as people say it. */
const speedName = (factor) => {
  if (factor === 1) return 'real time';
  return factor < 1 ? `1/${digits(1 / factor)} speed` : `${digits(factor)} × speed`;
};

/** A speed at which the whole motion is a matter of seconds. */
const usualSpeed = (span) => {
  if (span >= 1.5 && span <= 45) return 1;
  const exact = span / 10;
  const power = 10 ** Math.floor(Math.log10(exact));
  return power * [1, 2, 5, 10].reduce((a, b) => (Math.abs(b - exact / power) < Math.abs(a - exact / power) ? b : a));
};

/** The controls of a view, and its clock. */
class Player {
  constructor(root, data) {
    this.root = root;
    this.data = data;
    this.motions = data.motions.map((motion) => Motion.read(motion, data.place, data.turn));
    this.motions[0].acted(data.arrows);
    this.#span();
    this.t = this.from;
    this.stage = root.querySelector('.view-stage');
    this.picture = new Picture(this.stage, data, this.motions);
    this.find = (name) => root.querySelector(`.view-${name}`);
    this.calm = matchMedia('(prefers-reduced-motion: reduce)');
    this.speed = usualSpeed(this.span);
    this.#fill();
    this.#listen();
    if (this.picture.camera.home.isTravelling) this.#followChosen(String(data.follow[0]?.[1] ?? ''));
    this.draw();
    this.say();
  }

  /** From when to when there is something to see. */
  #span() {
    const [first] = this.motions;
    this.from = first.from;
    this.to = this.motions.reduce((to, m) => (Math.abs(m.to - this.from) > Math.abs(to - this.from) ? m.to : to), first.to);
    this.span = Math.abs(this.to - this.from);
  }

  /** Shows other motions from now on; those of the file with what is seen through. */
  show(motions, isOfFile) {
    this.motions = motions;
    this.picture.motions = motions;
    this.#span();
    this.root.classList.toggle('changed', !isOfFile);
    this.find('ghosts').closest('label').hidden = motions.length < 2;
    this.find('forces').disabled = !isOfFile;
    this.picture.before = undefined;
    this.t = clamp(this.t, Math.min(this.from, this.to), Math.max(this.from, this.to));
    this.draw();
    if (!this.playing) this.say();
  }

  #fill() {
    const option = (select, value, text) => select.append(new Option(text, value));
    const speed = this.find('speed');
    for (const k of [0.05, 0.1, 0.25, 0.5, 1, 2, 4, 10]) option(speed, k * this.speed, speedName(k * this.speed));
    speed.value = String(this.speed);
    const follow = this.find('follow');
    option(follow, '', 'nothing');
    for (const [name, point] of this.data.follow) option(follow, point, name);
    const trace = this.find('trace');
    option(trace, 'usual', this.data.traced.length ? this.data.traced.map((at) => this.data.points[at]).join(', ') : 'nothing');
    if (this.data.traced.length) option(trace, '', 'nothing');
    option(trace, 'all', 'all points');
    this.data.points.forEach((name, at) => option(trace, at, name));
    const forces = this.find('forces');
    for (const [factor, text] of [[0, 'none'], [1, 'shown'], [3, '3 × as long'], [10, '10 × as long'], [30, '30 × as long']]) option(forces, factor, text);
    const { list } = this.data.arrows;
    forces.closest('label').hidden = !list.length;
    // A few say what acts, many hide what moves.
    this.#forcesChosen(list.length <= 8 ? 1 : 0);
    const scrub = this.find('scrub');
    scrub.max = 1000;
    this.find('ghosts').closest('label').hidden = this.motions.length < 2;
  }

  #listen() {
    const { stage, picture } = this;
    this.find('play').addEventListener('click', () => this.toggle());
    this.find('home').addEventListener('click', () => this.home());
    this.find('scrub').addEventListener('input', (event) => {
      this.pause();
      this.seek(this.from + ((this.to - this.from) * event.target.value) / 1000);
    });
    this.find('scrub').addEventListener('change', () => this.say());
    this.find('speed').addEventListener('change', (event) => { this.speed = Number(event.target.value); });
    this.find('follow').addEventListener('change', (event) => this.#followChosen(event.target.value));
    this.find('trace').addEventListener('change', (event) => this.#traceChosen(event.target.value));
    this.find('forces').addEventListener('change', (event) => this.#forcesChosen(Number(event.target.value)));
    for (const name of ['axes', 'names', 'ghosts']) {
      this.find(name).addEventListener('change', (event) => {
        picture.shows[name] = event.target.checked;
        this.draw();
      });
    }
    stage.addEventListener('keydown', (event) => this.#key(event));
    this.#point(stage);
    new ResizeObserver(() => this.draw()).observe(stage);
    matchMedia('(prefers-color-scheme: dark)').addEventListener('change', () => this.#repaint());
    const onPaper = (is) => {
      picture.onPaper = is;
      this.#repaint();
    };
    matchMedia('print').addEventListener('change', (event) => onPaper(event.matches));
    window.addEventListener('beforeprint', () => onPaper(true));
    window.addEventListener('afterprint', () => onPaper(false));
    document.addEventListener('tripos:time', (event) => {
      if (event.detail.from !== this) this.seek(event.detail.t);
    });
  }

  #repaint() {
    this.picture.refresh();
    this.draw();
  }

  /** One finger or button turns, two move and zoom. */
  #point(stage) {
    const { camera } = this.picture;
    const held = new Map();
    const middle = () => {
      const all = [...held.values()];
      return [0, 1].map((i) => all.reduce((sum, at) => sum + at[i], 0) / all.length);
    };
    const apart = () => {
      const [a, b] = [...held.values()];
      return b ? Math.hypot(a[0] - b[0], a[1] - b[1]) : 0;
    };
    stage.addEventListener('pointerdown', (event) => {
      if (event.target.closest('button, input, select, label')) return;
      stage.setPointerCapture(event.pointerId);
      held.set(event.pointerId, [event.clientX, event.clientY]);
    });
    stage.addEventListener('pointermove', (event) => {
      if (!held.has(event.pointerId)) return;
      const [before, wide] = [middle(), apart()];
      held.set(event.pointerId, [event.clientX, event.clientY]);
      const now = middle();
      const [x, y] = [(now[0] - before[0]) / stage.clientHeight, (now[1] - before[1]) / stage.clientHeight];
      if (held.size > 1) {
        camera.pan(x, y);
        if (wide) camera.zoom(wide / apart());
      } else if (event.shiftKey || event.buttons & 6) camera.pan(x, y);
      else camera.orbit(3.2 * x, 3.2 * y);
      this.draw();
    });
    for (const name of ['pointerup', 'pointercancel']) stage.addEventListener(name, (event) => held.delete(event.pointerId));
    stage.addEventListener('contextmenu', (event) => event.preventDefault());
    stage.addEventListener('wheel', (event) => {
      // In a page the wheel scrolls, unless somebody is at the view.
      if (!this.data.alone && !event.ctrlKey && document.activeElement !== stage) return;
      event.preventDefault();
      camera.zoom(Math.exp(clamp(event.deltaY, -200, 200) / 500));
      this.draw();
    }, { passive: false });
  }

  #key(event) {
    if (event.target !== this.stage || event.altKey || event.ctrlKey || event.metaKey) return;
    const { camera } = this.picture;
    const step = (parts) => () => { this.pause(); this.seek(this.t + (this.to - this.from) * parts); this.say(); };
    const look = (act) => () => { act(); this.draw(); };
    const keys = event.shiftKey ? {
      ArrowLeft: look(() => camera.orbit(-0.1, 0)),
      ArrowRight: look(() => camera.orbit(0.1, 0)),
      ArrowUp: look(() => camera.orbit(0, 0.1)),
      ArrowDown: look(() => camera.orbit(0, -0.1)),
      '+': look(() => camera.zoom(1 / 1.15)),
    } : {
      ' ': () => this.toggle(),
      ArrowLeft: step(-0.01),
      ArrowRight: step(0.01),
      ArrowUp: () => this.#faster(1),
      ArrowDown: () => this.#faster(-1),
      Home: step(-2),
      End: step(2),
      '+': look(() => camera.zoom(1 / 1.15)),
      '=': look(() => camera.zoom(1 / 1.15)),
      '-': look(() => camera.zoom(1.15)),
      '0': () => this.home(),
      a: () => this.find('axes').click(),
      n: () => this.find('names').click(),
      g: () => this.find('ghosts').click(),
      f: () => this.#forcesChosen(this.picture.shows.forces && this.motions[0].forces ? 0 : 1),
    };
    const act = keys[event.key];
    if (!act) return;
    event.preventDefault();
    act();
  }

  #faster(step) {
    const select = this.find('speed');
    select.selectedIndex = clamp(select.selectedIndex + step, 0, select.options.length - 1);
    this.speed = Number(select.value);
    this.say();
  }

  #followChosen(value) {
    this.find('follow').value = value;
    this.picture.follow(value === '' ? undefined : Number(value));
    this.draw();
  }

  /** Arrows of forces so many times as long as usual; none at 0. */
  #forcesChosen(factor) {
    this.find('forces').value = factor;
    this.picture.shows.forces = factor;
    this.root.classList.toggle('forceless', !factor);
    this.draw();
    this.say();
  }

  #traceChosen(value) {
    const all = this.data.points.map((_, at) => at);
    const usual = { usual: this.data.traced, '': [], all };
    this.picture.traced = usual[value] ?? [Number(value)];
    this.draw();
  }

  home() {
    this.picture.camera.reset();
    if (this.picture.followed !== undefined) this.picture.follow(this.picture.followed);
    this.draw();
    this.say();
  }

  toggle() {
    if (this.playing) {
      this.pause();
      this.say();
    } else this.play();
  }

  play() {
    if (Math.abs(this.t - this.to) < 1e-9 * this.span) this.seek(this.from);
    this.playing = true;
    this.find('play').setAttribute('aria-label', 'Pause');
    this.root.classList.add('playing');
    // Where a motion stops is told, not every moment of it.
    this.find('said').setAttribute('aria-live', 'off');
    let before = performance.now();
    let told = before;
    const tick = (now) => {
      if (!this.playing) return;
      const t = this.t + (Math.sign(this.to - this.from) * this.speed * (now - before)) / 1000;
      before = now;
      this.seek(t);
      if (now - told > 250) {
        told = now;
        this.say();
      }
      if (this.t === this.to) {
        this.pause();
        this.say();
      } else requestAnimationFrame(tick);
    };
    requestAnimationFrame(tick);
  }

  pause() {
    this.playing = false;
    this.find('said').setAttribute('aria-live', 'polite');
    this.find('play').setAttribute('aria-label', 'Play');
    this.root.classList.remove('playing');
  }

  seek(t) {
    this.t = clamp(t, Math.min(this.from, this.to), Math.max(this.from, this.to));
    this.draw();
    document.dispatchEvent(new CustomEvent('tripos:time', { detail: { t: this.t, scene: this.data.scene, from: this } }));
  }

  clock() {
    const places = Math.max(0, 3 - Math.ceil(Math.log10(this.span || 1)));
    return `${this.t.toFixed(places).replace('-', '−')} s`;
  }

  draw() {
    this.picture.draw(this.t);
    const scrub = this.find('scrub');
    const share = this.span ? (1000 * (this.t - this.from)) / (this.to - this.from) : 0;
    if (Math.abs(scrub.value - share) >= 0.5) scrub.value = share;
    scrub.style.setProperty('--share', `${share / 10}%`);
    scrub.setAttribute('aria-valuetext', this.clock());
    this.find('clock').textContent = `t = ${this.clock()}`;
    this.live?.curve.draw();
  }

  /** The largest forces, where they are shown. */
  #forces(motion) {
    const all = this.picture.shows.forces ? forcesOf(motion, this.data.arrows) : [];
    const told = all.slice(0, 4).map(({ kind, name, newtons }) => `${FORCE_WORDS[kind]}${name} ${digits(newtons)} N`);
    return told.length ? ` Forces: ${told.join('; ')}${all.length > 4 ? `, and ${all.length - 4} smaller` : ''}.` : '';
  }

  /** Says in words what is seen: where each body is, and what else there is to know. */
  say() {
    const [motion] = this.motions;
    motion.seek(this.t);
    const place = (point) => `(${motion.point(point).map((x) => digits(Math.abs(x) < 1e-6 * this.data.size ? 0 : x)).join(', ')}) m`;
    const shown = this.data.follow.slice(0, 4).map(([name, point]) => `${name} at ${place(point)}`);
    const more = this.data.follow.length > 4 ? `, and ${this.data.follow.length - 4} more` : '';
    const ended = this.motions.filter((each) => Math.abs(each.to - this.from) < Math.abs(this.t - this.from) * (1 - 1e-9));
    const early = ended.map((each) => ` ${each.title}: ended before, at t = ${digits(each.to, 5)} s.`).join('');
    const apart = this.motions.slice(1).map((other) => {
      other.seek(this.t);
      const most = Math.max(...this.data.follow.map(([, point]) => size(sub(other.point(point), motion.point(point)))));
      return ` ${other.title}: up to ${digits(most)} m apart from it.`;
    }).join('');
    this.find('said').textContent = `At t = ${this.clock()}: ${shown.join('; ')}${more}.${this.#forces(motion)}${apart}${early}`;
  }
}
