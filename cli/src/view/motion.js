/** A motion of a view: instants, ways of points, turns of frames. What is written are whole numbers, as differences. */
class Motion {
  constructor(parts) {
    Object.assign(this, parts);
    this.last = this.t.length - 1;
  }

  /** As it is written in a view. */
  static read(data, place, turn) {
    return new Motion({
      title: data.title,
      ending: data.ending,
      objections: data.objections,
      t: Motion.#sums(data.t, 1, data.dt).map((x) => x + data.from),
      points: data.points.map((list) => Motion.#sums(list, 3, place)),
      frames: data.frames.map((list) => Motion.#sums(list, 4, turn)),
    });
  }

  /** With forces, as they are written in a view. */
  acted({ list, step }) {
    this.forces = list.map(({ values }) => Motion.#sums(values, 3, step));
    return this;
  }

  /** Differences of vectors of so many entries, added up and scaled. */
  static #sums(list, width, scale) {
    const out = new Float64Array(list.length);
    for (let at = 0; at < list.length; at += 1) out[at] = list[at] + (at < width ? 0 : out[at - width]);
    return out.map((x) => x * scale);
  }

  get from() {
    return this.t[0];
  }

  get to() {
    return this.t[this.last];
  }

  /** Sets the instant; beyond its ends a motion rests where it ended. */
  seek(t) {
    const forth = this.to >= this.from ? 1 : -1;
    let [low, high] = [0, this.last];
    while (high - low > 1) {
      const middle = (low + high) >> 1;
      if (forth * (this.t[middle] - t) <= 0) low = middle;
      else high = middle;
    }
    this.low = low;
    this.high = high;
    const span = this.t[high] - this.t[low];
    this.share = span ? clamp((t - this.t[low]) / span, 0, 1) : 0;
  }

  /** Where a point is at the instant that was set. */
  point(at) {
    return this.#between(this.points[at]);
  }

  /** On the straight way between two instants; what never changes is there once. */
  #between(list) {
    if (list.length === 3) return [list[0], list[1], list[2]];
    const [a, b] = [3 * this.low, 3 * this.high];
    return [0, 1, 2].map((i) => list[a + i] + this.share * (list[b + i] - list[a + i]));
  }

  /** How a frame is turned at the instant that was set. */
  frame(at) {
    const list = this.frames[at];
    if (list.length === 4) return [...list];
    const [a, b] = [4 * this.low, 4 * this.high];
    return slerp([...list.subarray(a, a + 4)], [...list.subarray(b, b + 4)], this.share);
  }

  /** A force at the instant that was set, N. */
  force(at) {
    return this.#between(this.forces[at]);
  }

  /** The whole way of a point, as WebGL takes it; one place for a point that rests. */
  way(at) {
    return Float32Array.from(this.points[at]);
  }
}

/** Where a solid is: its middle, its attitude, and the lengths of its mesh along its own axes. */
const placed = (motion, solid) => {
  if (solid.ends) {
    const [a, b] = solid.ends.map((end) => motion.point(end));
    const way = sub(b, a);
    const length = size(way);
    const middle = times(add(a, b), 0.5);
    return { middle, attitude: towards(unit(way)), scale: [solid.radius, solid.radius, length], ends: [a, b] };
  }
  const frame = motion.frame(solid.frame);
  const middle = add(motion.point(solid.point), turn(frame, solid.position));
  return { middle, attitude: compose(frame, solid.turned), scale: solid.scale };
};
