/** Looks at a place from a distance: turns about what is up. */
class Camera {
  constructor(home) {
    this.home = home;
    this.reset();
  }

  reset() {
    Object.assign(this, { ...this.home, target: [...this.home.target] });
  }

  get back() {
    const { up, ahead, right } = this.home;
    const flat = add(times(right, Math.sin(this.azimuth)), ahead, -Math.cos(this.azimuth));
    return add(times(flat, Math.cos(this.elevation)), up, Math.sin(this.elevation));
  }

  get eye() {
    return add(this.target, this.back, this.distance);
  }

  get above() {
    // Nearly from above or below, what is ahead is above.
    const tilt = Math.cos(this.elevation);
    return Math.abs(tilt) > 1e-3 ? this.home.up : times(this.home.ahead, Math.sign(this.elevation));
  }

  orbit(sideways, upwards) {
    this.azimuth -= sideways;
    this.elevation = clamp(this.elevation + upwards, -1.55, 1.55);
  }

  zoom(factor) {
    this.distance = clamp(this.distance * factor, 0.02 * this.home.distance, 40 * this.home.distance);
  }

  /** Moves by parts of the height of the picture. */
  pan(sideways, upwards) {
    const back = this.back;
    const right = unit(cross(this.above, back));
    const scale = 2 * this.distance * Math.tan(Camera.ANGLE / 2);
    this.target = add(add(this.target, right, -sideways * scale), cross(back, right), upwards * scale);
  }

  view(aspect) {
    const narrow = Math.min(1, aspect / Camera.ASPECT);
    const distance = this.distance / narrow;
    const eye = add(this.target, this.back, distance);
    const near = 0.01 * distance;
    const far = distance + 60 * this.home.distance;
    return { eye, view: multiply(perspective(Camera.ANGLE, aspect, near, far), lookAt(eye, this.target, this.above)) };
  }
}
Camera.ANGLE = 0.5;
// What fits into a picture of this width, of its height, fits into wider ones, and is seen from farther in narrower ones.
Camera.ASPECT = 1.5;

/** From where all of a motion is seen well: across its plane if it has one that stands upright, else from beside and above. */
const homeOf = (data, motions) => {
  const { up, plane } = data;
  let [low, high] = [[Infinity, Infinity, Infinity], [-Infinity, -Infinity, -Infinity]];
  const take = (place, reach) => {
    low = low.map((x, i) => Math.min(x, place[i] - reach));
    high = high.map((x, i) => Math.max(x, place[i] + reach));
  };
  const solids = data.solids.filter((solid) => solid.kind !== 'ground');
  for (const motion of motions) {
    const step = Math.max(1, Math.floor(motion.last / 300));
    for (let at = 0; at <= motion.last; at += step) {
      motion.seek(motion.t[at]);
      for (const solid of solids) {
        const ends = solid.ends ? solid.ends.map((end) => motion.point(end)) : [placed(motion, solid).middle];
        for (const end of ends) take(end, solid.reach);
      }
    }
    motion.seek(motion.from);
  }
  const middle = times(add(low, high), 0.5);
  const extent = size(sub(high, low)) || data.size;
  // What travels far is followed, and seen as large as it is.
  const isTravelling = extent > 4.5 * data.size;
  const stands = plane && Math.abs(dot(plane, up)) < 0.5;
  const lies = plane && !stands;
  const side = [[1, 0, 0], [0, 1, 0], [0, 0, 1]].find((axis) => Math.abs(dot(axis, up)) < 0.5);
  // Axis 1 to the right.
  let ahead = stands ? times(plane, -1) : unit(cross(up, unit(sub(side, times(up, dot(side, up))))));
  let right = unit(cross(ahead, up));
  if (stands && right[0] + right[1] + right[2] < -0.5) {
    [ahead, right] = [times(ahead, -1), times(right, -1)];
  }
  const home = {
    up,
    ahead,
    right,
    target: middle,
    distance: 1,
    azimuth: stands ? -0.3 : lies ? 0 : 0.62,
    elevation: stands ? 0.16 : lies ? 0.95 : 0.36,
    isTravelling,
    reach: Math.max(extent, 2 * data.size),
  };
  const camera = new Camera(home);
  const { back } = camera;
  const sideways = unit(cross(camera.above, back));
  const half = isTravelling ? [1, 1, 1].map(() => 0.85 * data.size) : times(sub(high, low), 0.5).map((x) => Math.max(x, 0.1 * data.size));
  // How far a box of these halves reaches along a direction.
  const along = (way) => half.reduce((sum, x, i) => sum + x * Math.abs(way[i]), 0);
  const needed = Math.max(along(cross(back, sideways)), along(sideways) / Camera.ASPECT);
  home.distance = (1.08 * needed) / Math.tan(Camera.ANGLE / 2) + 0.6 * along(back);
  return home;
};
