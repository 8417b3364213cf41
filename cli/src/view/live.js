/** The most steps of a run in the page, and the instants that are shown of it. */
const [MOST_STEPS, SHOWN] = [20000, 900];
/** Poses on the way from the file's, so that a linkage stays the way round it was closed; and how far what is free is displaced in a pose that no
 * small change closes. */
const [ON_THE_WAY, DISPLACED] = [16, [0, -0.1, 0.1]];

/** The largest distance of a curve from the line between its ends, relative to its height; 0 for what rests to rounding. */
const bend = (t, values) => {
  const [last, largest] = [values.length - 1, values.reduce((most, x) => Math.max(most, Math.abs(x)), 0)];
  const height = values.reduce((most, x) => Math.max(most, x), -Infinity) - values.reduce((least, x) => Math.min(least, x), Infinity);
  const slope = (values[last] - values[0]) / (t[last] - t[0] || 1);
  const apart = values.reduce((most, x, at) => Math.max(most, Math.abs(x - values[0] - slope * (t[at] - t[0]))), 0);
  return height > 1e-9 * largest && Number.isFinite(apart / height) ? apart / height : 0;
};

/** The equations of a view, run again where a number is changed. */
class Live {
  constructor(player, model) {
    Object.assign(this, { player, model, live: player.data.live, original: player.motions });
    const { live } = this;
    this.find = player.find;
    this.numbers = { p: [...live.p], start: [...live.q, ...live.u] };
    /** Coordinates that were changed, the last one last. */
    this.moved = [];
    this.curve = new Curve(this.find('curve'), player);
    this.first = this.#run();
    this.now = this.first;
    this.rows = [...live.parameters.map((each) => this.#row(each, 'p')), ...live.start.map((each) => this.#row(each, 'start'))];
    this.#quantities();
    this.find('reset').addEventListener('click', () => this.reset());
    this.find('quantity').addEventListener('change', () => this.#draw());
    this.#draw();
    this.#say();
  }

  /** Whether nothing is changed. */
  get isOfFile() {
    const { p, start } = this.numbers;
    const { live } = this;
    return p.every((x, at) => x === live.p[at]) && start.every((x, at) => x === [...live.q, ...live.u][at]);
  }

  /** Coordinates at the start that close the loops and have what is held where it is; what else moves, moves as little as can be. */
  #closed(free) {
    const { live, model, numbers } = this;
    const held = live.q.map((x, at) => (free.includes(at) ? x : numbers.start[at]));
    const isOfFile = held.every((x, at) => x === live.q[at]) && numbers.p.every((x, at) => x === live.p[at]);
    let q = [...live.q];
    for (let step = 1; step <= ON_THE_WAY && q && !isOfFile; step += 1) {
      const at = (a, b) => a + ((b - a) * step) / ON_THE_WAY;
      const p = live.p.map((x, i) => at(x, numbers.p[i]));
      const from = (by) => q.map((x, i) => (free.includes(i) ? x + by : at(live.q[i], held[i])));
      q = DISPLACED.reduce((found, by) => found ?? assemble(model, p, from(by), free), null);
    }
    return q;
  }

  /** Closes the loops: by the coordinates that the scene leaves open, else by those that were not changed, or were longest ago. */
  #close() {
    const { live, model, numbers } = this;
    if (!model.LOOPS) return;
    const all = live.start.map(({ at }) => at).filter((at) => at < live.q.length);
    const others = (_, first) => all.filter((at) => !this.moved.slice(first).includes(at));
    const choices = live.closing.length ? [live.closing] : this.moved.length ? this.moved.map(others) : [all];
    const q = choices.reduce((found, free) => found ?? this.#closed(free), null);
    if (!q) return;
    q.forEach((x, at) => { numbers.start[at] = x; });
    for (const { put, each, list } of this.rows) if (list === 'start' && each.at < q.length) put(q[each.at]);
  }

  #run() {
    const { live, model } = this;
    const { p, start } = this.numbers;
    const [q, u] = [start.slice(0, live.q.length), start.slice(live.q.length)];
    const [from, to] = live.span;
    const times = Array.from({ length: SHOWN }, (_, at) => from + ((to - from) * at) / (SHOWN - 1));
    const { rtol, atol, directions, holds } = live;
    const by = (own, title) => ({
      ...run(own, { p, q, u, span: live.span, rtol, atol, directions, holds, times, limit: MOST_STEPS }), model: own, title,
    });
    let done = by(model, live.title);
    // A choice of speeds fails there, not the motion.
    const isChoice = model.general && done.stop.kind === 'watched' && done.stop.at >= live.conditions;
    const other = isChoice ? by(model.general, live.general) : done;
    if (Math.abs(other.end.t - live.span[0]) > Math.abs(done.end.t - live.span[0])) done = other;
    const isEnd = done.t.length && done.t[done.t.length - 1] === done.end.t;
    const [t, y] = isEnd ? [done.t, done.y] : [[...done.t, done.end.t], [...done.y, done.end.y]];
    return { ...done, p: [...p], t, y };
  }

  /** A slider and a number for one of what can be changed. */
  #row(each, list) {
    const label = document.createElement('label');
    const name = document.createElement('span');
    name.textContent = each.about ? `${each.name}, ${each.about}` : each.name;
    label.title = name.textContent;
    const [range, number] = ['range', 'number'].map((type) => Object.assign(document.createElement('input'), { type }));
    Object.assign(range, { min: each.from, max: each.to, step: (each.to - each.from) / 400, value: each.value });
    Object.assign(number, { step: 'any', value: each.value });
    range.setAttribute('aria-label', `${list === 'p' ? 'Parameter' : 'Start of'} ${name.textContent}`);
    number.setAttribute('aria-label', `Value of ${each.name}${each.unit ? `, ${each.unit}` : ''}`);
    const unit = document.createElement('span');
    unit.textContent = each.unit;
    label.append(name, range);
    const row = document.createElement('div');
    row.append(label, number, unit);
    this.find(list === 'p' ? 'parameters' : 'start').append(row);
    const put = (value) => {
      range.value = value;
      number.value = Number(value.toPrecision(6));
      const shown = `${digits(value, 4)} ${each.unit}`.trim();
      range.setAttribute('aria-valuetext', shown);
      row.classList.toggle('changed', value !== each.value);
    };
    const change = (value) => {
      if (!Number.isFinite(value)) return;
      this.numbers[list][each.at] = value;
      if (list === 'start' && each.at < this.live.q.length) this.moved = [...this.moved.filter((at) => at !== each.at), each.at];
      put(value);
      this.#soon();
    };
    // A slider that is back where it was gives the file's own number.
    const step = (each.to - each.from) / 400;
    range.addEventListener('input', () => change(Math.abs(range.value - each.value) < step / 2 ? each.value : Number(range.value)));
    number.addEventListener('change', () => change(number.value === '' ? each.value : Number(number.value)));
    put(each.value);
    return { put, each, list };
  }

  /** Once a picture, however often a slider moves. */
  #soon() {
    if (this.waits) return;
    this.waits = true;
    requestAnimationFrame(() => {
      this.waits = false;
      this.update();
    });
  }

  /** Runs the equations with the numbers as they are, and shows the motion. */
  update() {
    const { player, live } = this;
    this.#close();
    const { isOfFile } = this;
    this.now = isOfFile ? this.first : this.#run();
    const { p, t, y, title, model } = this.now;
    const changed = () => motionOf(model, live, { p, t, y, title, ending: '' });
    player.picture.reshape(this.#solids());
    player.show(isOfFile ? this.original : [changed()], isOfFile);
    this.find('reset').disabled = isOfFile;
    this.#draw();
    this.#say();
  }

  reset() {
    const { live } = this;
    this.numbers = { p: [...live.p], start: [...live.q, ...live.u] };
    this.moved = [];
    for (const { put, each } of this.rows) put(each.value);
    this.update();
  }

  /** How far a point is from another at these parameters and coordinates. */
  #apartAt(p, q, [point, middle]) {
    const { places } = poseOf(this.live.links, this.model.places(p, q));
    return size(sub(places[point], places[middle]));
  }

  /** Solids with their sizes at the parameters: as the file's shapes say, or so that what rolls touches where it does. */
  #solids() {
    const { live, model, player, numbers } = this;
    const q = numbers.start.slice(0, live.q.length);
    const values = live.sizes.length ? model.sizes(numbers.p, q) : [];
    let at = 0;
    return player.data.solids.map((solid, which) => {
      const mine = {};
      for (const key of live.sizes[which] ?? []) (mine[key] ??= []).push(values[at++]);
      const touches = live.touches[which];
      if (touches) return { ...solid, radius: (solid.radius * this.#apartAt(numbers.p, q, touches)) / this.#apartAt(live.p, live.q, touches) };
      const own = { ...solid, ...(mine.position && { position: mine.position }), ...(mine.size?.length === 3 && { size: mine.size }) };
      for (const key of ['radius', 'length']) if (mine[key]) [own[key]] = mine[key];
      if (mine.radius && !mine.length && solid.kind === 'cylinder') own.length = (solid.length * own.radius) / solid.radius;
      return own;
    });
  }

  /** What there are curves of: a function of a run, and a unit. */
  #quantities() {
    const { live } = this;
    const n = live.q.length;
    const select = this.find('quantity');
    const state = (index) => ({ p, y, model }) => y.map((s) => (index < n ? s[index] : model.generalized_speeds(p, s.subarray(0, n), s.subarray(n))[index - n]));
    this.choices = live.start.map((each) => ({ name: each.name, unit: each.unit, of: state(each.at) }));
    this.choices.push({ name: 'T + V', unit: 'J', of: (run) => this.#energies(run).map(([a, b]) => a + b) });
    this.choices.forEach(({ name }, at) => select.append(new Option(name, at)));
    select.value = this.#liveliest();
  }

  /** The first choice that bends nearly as much as any: neither what rests nor what grows evenly, such as a place along a straight way. */
  #liveliest() {
    const { t } = this.first;
    const bends = this.choices.slice(0, this.live.start.length).map(({ of }) => bend(t, of(this.first)));
    const most = Math.max(0, ...bends);
    return Math.max(0, bends.findIndex((each) => each > 0 && each >= 0.8 * most));
  }

  #energies({ p, y, model }) {
    const { live } = this;
    const n = live.q.length;
    return y.map((s) => [model.kinetic_energy(p, s.subarray(0, n), s.subarray(n)), model.potential_energy(p, s.subarray(0, n))]);
  }

  #draw() {
    const { name, unit, of } = this.choices[Number(this.find('quantity').value)];
    const runs = this.now === this.first ? [this.first] : [this.first, this.now];
    this.curve.show(runs.map((each) => ({ t: each.t, values: of(each) })), name, unit);
  }

  /** Says what runs, what is changed, how it ended and what kept. */
  #say() {
    const { live, model, now, rows, numbers } = this;
    const value = ({ at }, list) => numbers[list][at];
    const changes = rows.map(({ each, list }) => [each, value(each, list)]).filter(([each, x]) => x !== each.value);
    const told = changes.slice(0, 4).map(([each, x]) => `${each.name} = ${digits(x, 4)} ${each.unit}`.trim() + ` (${digits(each.value, 4)} in the file)`);
    const more = changes.length > 4 ? `, and ${changes.length - 4} more` : '';
    const stops = {
      end: '', steps: `: given up after ${MOST_STEPS} steps`, short: ': steps fell below rounding, the equations have no value beyond',
      undefined: `: the equations have no value ${now.steps ? 'beyond' : 'at this start'}`,
      open: ': with these numbers its constraints cannot be met', adrift: ': it could not be kept on its constraints',
      watched: live.conditions > now.stop.at ? `, where ${now.stop.name} ends it` : `, where ${now.stop.name} is 0, by which the equations divide`,
    };
    const energies = this.#energies(now);
    const total = energies.map(([a, b]) => a + b);
    const scale = Math.max(...energies.map(([a, b]) => Math.abs(a) + Math.abs(b - energies[0][1])));
    const drift = Math.max(...total.map((e) => Math.abs(e - total[0]))) / (scale || 1);
    const kept = live.conserves && total.length > 1 ? ` T + V is constant to ${digits(Math.max(drift, 1e-16), 1)} of the energy that changes.` : '';
    const following = live.closing.map((at) => `${model.COORDINATES[at]} = ${digits(Math.abs(numbers.start[at]) < 1e-12 ? 0 : numbers.start[at], 4)}`);
    const closing = changes.length && following.length && now.stop.kind !== 'open' ? `Its loops are closed by ${following.slice(0, 4).join(', ')}${following.length > 4 ? ', …' : ''}. ` : '';
    const what = changes.length ? `${told.join(', ')}${more}. ${closing}` : 'The numbers of the file. ';
    const unwatched = live.unwatched.length ? ` Not watched here: ${live.unwatched.join(', ')}.` : '';
    const seen = changes.length ? '' : ` ${this.#apart()}`;
    this.find('ran').textContent = `${what}Run in this page by ${now.title}: to t = ${digits(now.end.t, 5)} s in ${now.steps} steps${stops[now.stop.kind]}.${kept}${unwatched}${seen}`;
  }

  /** How far the page's run is from the motion that the command computed, by what is followed. */
  #apart() {
    const { player, first, live } = this;
    this.near ??= motionOf(first.model, live, { ...first, title: '', ending: '' });
    const [own] = this.original;
    let most = 0;
    for (const t of own.t) {
      if ((t - this.near.to) * Math.sign(this.near.to - this.near.from) > 1e-9) break;
      own.seek(t);
      this.near.seek(t);
      for (const [, point] of player.data.follow) most = Math.max(most, size(sub(own.point(point), this.near.point(point))));
    }
    own.seek(player.t);
    return most < 2e-3 * player.data.size
      ? 'It is the motion that the command computed.'
      : `The motion of this page is up to ${digits(most)} m from the motion that the command computed by the scene's own method.`;
  }
}
