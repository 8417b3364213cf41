/** A colour as the browser computes it, rgb(1, 2, 3), in parts. */
const rgb = (text, alpha = 1) => [...text.match(/[\d.]+/g).slice(0, 3).map((x) => Number(x) / 255), alpha];

/** Between two colours. */
const mixed = (a, b, share) => rgb(a).map((x, i) => x + share * (rgb(b)[i] - x));

const PATTERN = { sphere: 2, cylinder: 1 };

/** What is drawn of a view at one instant. */
class Picture {
  constructor(stage, data, motions) {
    this.stage = stage;
    this.data = data;
    this.motions = motions;
    this.painter = new Painter(stage.querySelector('.view-solids'));
    this.words = stage.querySelector('.view-words');
    this.pen = this.words.getContext('2d');
    this.camera = new Camera(homeOf(data, motions));
    this.traced = [...data.traced];
    this.shows = { axes: true, names: false, ghosts: true, forces: 1 };
    this.rod = 0.016 * data.size;
    this.solids = data.solids.map((solid) => this.#meshed(solid));
    this.refresh();
  }

  /** A solid as a mesh with its lengths. */
  #meshed(solid) {
    const scales = {
      sphere: () => [solid.radius, solid.radius, solid.radius],
      cylinder: () => [solid.radius, solid.radius, solid.length],
      box: () => solid.size,
    };
    const meshes = { sphere: 'sphere', cylinder: 'cylinder', rod: 'cylinder', box: 'box' };
    const radius = solid.radius || 0.6 * this.rod;
    return { ...solid, radius, mesh: meshes[solid.kind], scale: scales[solid.kind]?.() };
  }

  /** Takes solids of other sizes. */
  reshape(solids) {
    this.solids = solids.map((solid) => this.#meshed(solid));
  }

  /** Asks the page for its colours anew: by day, at night, on paper. */
  refresh() {
    const probe = document.createElement('i');
    this.stage.append(probe);
    const of = (name) => {
      probe.style.color = `var(--view-${name})`;
      return getComputedStyle(probe).color;
    };
    const body = [1, 2, 3, 4, 5, 6, 7, 8].map((at) => of(`body-${at}`));
    const ghost = [1, 2, 3, 4].map((at) => of(`ghost-${at}`));
    this.colours = {
      body, ghost,
      axes: [1, 2, 3].map((at) => of(`axis-${at}`)),
      force: { weight: of('weight'), applied: of('applied'), reaction: of('reaction') },
      pin: of('pin'), ink: of('ink'), ground: of('ground'), rule: of('rule'), shadow: of('shadow'), halo: of('halo'),
    };
    probe.remove();
  }

  #colourOf(solid, at, colours) {
    if (solid.body === null) return this.data.stated ? colours.body[at % 8] : colours.pin;
    return colours.body[solid.body % 8];
  }

  draw(t) {
    const { camera, painter, stage } = this;
    const [wide, high] = [stage.clientWidth, stage.clientHeight];
    if (!wide || !high) return;
    const ratio = Math.min(window.devicePixelRatio || 1, 2.5);
    this.t = t;
    for (const motion of this.motions) motion.seek(t);
    this.#follow();
    const { eye, view } = camera.view(wide / high);
    const { up, right } = camera.home;
    const light = unit(add(add(times(up, 1.5), right, -0.55), camera.home.ahead, -0.75));
    painter.begin(Math.round(wide * ratio), Math.round(high * ratio), { view, eye, up, light });
    this.ratio = ratio;
    this.view = view;
    this.#drawGround();
    this.#drawTraces();
    const opaque = this.#solidsOf(this.motions[0]);
    const ground = this.#groundPlane();
    if (ground) {
      const shading = opaque.filter(({ at }) => dot(ground, [...at.middle, 0]) - ground[3] > -1e-9);
      const plane = [...ground.slice(0, 3), ground[3] + 2e-4 * this.data.size];
      painter.drawShadows(shading, plane, rgb(this.colours.shadow, this.isDark() ? 0.42 : 0.2));
    }
    for (const { kind, at, colour, pattern } of opaque) painter.draw(kind, at, rgb(colour), pattern);
    this.#drawSprings(this.motions[0], rgb(this.colours.ink));
    if (this.shows.axes) this.#drawAxes();
    this.#drawForces();
    if (this.shows.ghosts) {
      this.motions.slice(1).forEach((motion, which) => {
        const colour = this.colours.ghost[which % 4];
        for (const { kind, at } of this.#solidsOf(motion)) painter.draw(kind, at, rgb(colour, 0.42), 0);
        this.#drawSprings(motion, rgb(colour, 0.6));
      });
    }
    this.#write(wide, high, ratio);
    if (this.onPaper) this.#copy();
  }

  /** Puts the solids under the words: of the two pictures browsers print but one. */
  #copy() {
    const { pen, words, painter } = this;
    pen.save();
    pen.setTransform(1, 0, 0, 1, 0, 0);
    pen.globalCompositeOperation = 'destination-over';
    pen.drawImage(painter.gl.canvas, 0, 0, words.width, words.height);
    pen.restore();
  }

  isDark() {
    const [r, g, b] = rgb(this.colours.halo);
    return r + g + b < 1.5;
  }

  /** Keeps what is followed where it is in the picture. */
  #follow() {
    if (this.followed === undefined) return;
    const now = this.motions[0].point(this.followed);
    if (this.before) this.camera.target = add(this.camera.target, sub(now, this.before));
    this.before = now;
  }

  /** Follows a point from now on; nothing stays where it is. */
  follow(point) {
    this.followed = point;
    this.before = undefined;
    if (point !== undefined) {
      this.motions[0].seek(this.t ?? this.motions[0].from);
      this.camera.target = this.motions[0].point(point);
    } else {
      this.camera.target = [...this.camera.home.target];
    }
  }

  #solidsOf(motion) {
    const list = [];
    this.solids.forEach((solid, at) => {
      if (!solid.mesh) return;
      const colour = this.#colourOf(solid, at, this.colours);
      list.push({ kind: solid.mesh, at: placed(motion, solid), colour, pattern: PATTERN[solid.kind] || 0 });
    });
    return list;
  }

  #ground() {
    return this.solids.find((solid) => solid.kind === 'ground');
  }

  /** The plane of the ground: its normal and its height along it. */
  #groundPlane() {
    const ground = this.#ground();
    if (!ground) return null;
    const { middle, attitude } = placed(this.motions[0], ground);
    let normal = turn(attitude, [0, 0, 1]);
    if (dot(normal, this.camera.home.up) < 0) normal = times(normal, -1);
    return [...normal, dot(normal, middle)];
  }

  #drawGround() {
    const ground = this.#ground();
    if (!ground) return;
    const { middle, attitude } = placed(this.motions[0], ground);
    const [a, b, c, height] = this.#groundPlane();
    const normal = [a, b, c];
    const reach = 1.6 * Math.max(this.camera.home.isTravelling ? 4 * this.data.size : this.camera.home.reach, this.camera.distance * 0.4);
    const near = add(this.camera.target, normal, height - dot(normal, this.camera.target));
    const cell = 10 ** Math.floor(Math.log10(this.data.size / 2));
    // The quad moves with what is looked at, by whole cells, so that its lines stay.
    const [x, y] = [turn(attitude, [1, 0, 0]), turn(attitude, [0, 1, 0])];
    const off = sub(near, middle);
    const whole = (axis) => Math.round(dot(off, axis) / (5 * cell)) * 5 * cell;
    const centre = add(add(middle, x, whole(x)), y, whole(y));
    const edge = Math.ceil(reach / (5 * cell)) * 5 * cell + 5 * cell;
    this.cell = cell;
    this.painter.drawGround(
      { middle: centre, attitude, scale: [edge, edge, 1] },
      { colour: rgb(this.colours.ground, 0.85), rule: rgb(this.colours.rule, 1), centre: near, reach, cell },
    );
  }

  #drawTraces() {
    const colours = (which) => (which ? this.colours.ghost[(which - 1) % 4] : this.colours.ink);
    this.motions.forEach((motion, which) => {
      if (which && !this.shows.ghosts) return;
      for (const point of this.traced) {
        const way = motion.way(point);
        if (way.length < 6) continue;
        const width = 1.1 * this.ratio;
        const now = motion.point(point);
        const past = new Float32Array([...way.subarray(0, 3 * (motion.low + 1)), ...now]);
        const ahead = new Float32Array([...now, ...way.subarray(3 * motion.high)]);
        this.painter.drawLine(ahead, mixed(colours(which), this.colours.halo, 0.7), width);
        this.painter.drawLine(past, mixed(colours(which), this.colours.halo, 0.15), 1.9 * this.ratio, { nearer: 2e-4 });
      }
    });
  }

  #drawSprings(motion, colour) {
    for (const solid of this.solids.filter((each) => each.kind === 'spring')) {
      const [a, b] = solid.ends.map((end) => motion.point(end));
      this.painter.drawLine(coil(a, b, 0.028 * this.data.size), colour, 2 * this.ratio);
    }
  }

  /** The arrows that are long enough to be seen, each with its tip. */
  #arrows() {
    const { data, shows, motions: [motion] } = this;
    const { usual, cut } = data.arrows;
    const scale = (shows.forces * USUAL_ARROW * data.size) / usual;
    const longest = cut * USUAL_ARROW * data.size;
    const seen = shows.forces ? forcesOf(motion, data.arrows) : [];
    const drawn = seen.map((each) => {
      const own = scale * each.newtons;
      const way = times(each.force, Math.min(scale, longest / each.newtons));
      return { ...each, way, tip: add(each.tail, way), isCut: own > 1.001 * longest };
    });
    return drawn.filter(({ way }) => size(way) > 0.004 * data.size);
  }

  #drawForces() {
    for (const { kind, tail, way, isCut } of this.#arrows()) {
      const parts = arrowOf(tail, way, 0.5 * this.rod, isCut);
      // A weight acts inside of its body.
      for (const { kind: mesh, at } of parts) this.painter.drawHidden(mesh, at, rgb(this.colours.force[kind], 0.45));
      for (const { kind: mesh, at } of parts) this.painter.draw(mesh, at, rgb(this.colours.force[kind]), 0);
    }
  }

  #axesOf(frame, origin, length, width) {
    const q = frame === null ? [1, 0, 0, 0] : this.motions[0].frame(frame);
    [[1, 0, 0], [0, 1, 0], [0, 0, 1]].forEach((axis, at) => {
      const line = new Float32Array([...origin, ...add(origin, turn(q, axis), length)]);
      this.painter.drawLine(line, rgb(this.colours.axes[at]), width * this.ratio, { nearer: 0.0006 });
    });
  }

  #drawAxes() {
    const motion = this.motions[0];
    this.#axesOf(null, [0, 0, 0], 0.3 * this.data.size, 2.4);
    for (const [frame, point] of this.data.triads) this.#axesOf(frame, motion.point(point), 0.16 * this.data.size, 2);
  }

  /** Where a place is in the picture, in pixels of the page; nothing behind the eye. */
  onScreen(place, wide, high) {
    const m = this.view;
    const at = [0, 1, 3].map((i) => m[i] * place[0] + m[4 + i] * place[1] + m[8 + i] * place[2] + m[12 + i]);
    return at[2] > 0 ? [(0.5 + 0.5 * (at[0] / at[2])) * wide, (0.5 - 0.5 * (at[1] / at[2])) * high] : null;
  }

  /** Names of axes and points, over the solids. */
  #write(wide, high, ratio) {
    const { pen, words, data } = this;
    [words.width, words.height] = [Math.round(wide * ratio), Math.round(high * ratio)];
    pen.scale(ratio, ratio);
    pen.font = '600 12px system-ui, sans-serif';
    pen.textBaseline = 'middle';
    pen.lineWidth = 3;
    pen.lineJoin = 'round';
    const put = (text, place, colour, shift = [0, 0]) => {
      const at = this.onScreen(place, wide, high);
      if (!at) return;
      pen.strokeStyle = this.colours.halo;
      pen.fillStyle = colour;
      pen.strokeText(text, at[0] + shift[0], at[1] + shift[1]);
      pen.fillText(text, at[0] + shift[0], at[1] + shift[1]);
    };
    if (this.shows.axes) {
      [[1, 0, 0], [0, 1, 0], [0, 0, 1]].forEach((axis, at) => {
        put(`${data.inertial}${at + 1}`, times(axis, 0.34 * data.size), this.colours.axes[at], [-6, 0]);
      });
    }
    if (this.shows.names) {
      const motion = this.motions[0];
      data.points.forEach((name, at) => {
        const place = motion.point(at);
        const dot_ = this.onScreen(place, wide, high);
        if (!dot_) return;
        pen.fillStyle = this.colours.ink;
        pen.beginPath();
        pen.arc(dot_[0], dot_[1], 2.4, 0, 7);
        pen.fill();
        put(name, place, this.colours.ink, [7, -8]);
      });
      for (const { kind, name, tip } of this.#arrows()) put(`${FORCE_WORDS[kind]}${name}`, tip, this.colours.force[kind], [6, 0]);
    }
  }
}
