// Poses from the terms of links, as the command computes them. Rotations are three rows: (components in the inertial frame) = rotation .
// (components in the frame).
const IDENTITY = [[1, 0, 0], [0, 1, 0], [0, 0, 1]];

const product = (a, b) => a.map((row) => [0, 1, 2].map((j) => row[0] * b[0][j] + row[1] * b[1][j] + row[2] * b[2][j]));

/** The turn about an axis by an angle: it takes components after the turn to those before. */
const about = (axis, angle) => {
  const [j, k] = [(axis + 1) % 3, (axis + 2) % 3];
  const r = IDENTITY.map((row) => [...row]);
  [r[j][j], r[j][k], r[k][j], r[k][k]] = [Math.cos(angle), -Math.sin(angle), Math.sin(angle), Math.cos(angle)];
  return r;
};

/** Euler parameters of a rotation, by the largest of the four (Shepperd 1978). */
const eulerOf = (r) => {
  const trace = r[0][0] + r[1][1] + r[2][2];
  const sizes = [trace, r[0][0], r[1][1], r[2][2]];
  const which = sizes.indexOf(Math.max(...sizes));
  let q = [1 + trace, r[2][1] - r[1][2], r[0][2] - r[2][0], r[1][0] - r[0][1]];
  if (which > 0) {
    const i = which - 1;
    const [j, k] = [(i + 1) % 3, (i + 2) % 3];
    q = [r[k][j] - r[j][k], 0, 0, 0];
    q[1 + i] = 1 + 2 * r[i][i] - trace;
    q[1 + j] = r[j][i] + r[i][j];
    q[1 + k] = r[k][i] + r[i][k];
  }
  const length = Math.hypot(...q) || 1;
  return q.map((x) => x / length);
};

/** Every frame and point of a mechanism, from the values of its links. */
const poseOf = ({ frames, points }, values) => {
  let at = 0;
  const next = (count) => values.slice(at, at += count);
  const rotations = [];
  for (const frame of frames) {
    if (!frame) rotations.push(IDENTITY);
    else if (frame[1] !== null) rotations.push(product(rotations[frame[0]], about(frame[1], next(1)[0])));
    else {
      const c = next(9);
      rotations.push(product(rotations[frame[0]], [0, 1, 2].map((i) => [c[i], c[3 + i], c[6 + i]])));
    }
  }
  const places = [];
  for (const point of points) {
    if (!point) places.push([0, 0, 0]);
    else {
      const components = next(3);
      places.push(add(places[point[0]], rotations[point[1]].map((row) => dot(row, components))));
    }
  }
  return { rotations, places };
};

/** A motion from its states: the points and frames that are shown, at each instant. */
const motionOf = (model, live, { p, t, y, title, ending }) => {
  const n = live.q.length;
  const points = live.points.map(() => new Float64Array(3 * t.length));
  const frames = live.frames.map(() => new Float64Array(4 * t.length));
  y.forEach((state, at) => {
    const { rotations, places } = poseOf(live.links, model.places(p, state.subarray(0, n)));
    live.points.forEach((point, which) => points[which].set(places[point], 3 * at));
    live.frames.forEach((frame, which) => {
      const q = eulerOf(rotations[frame]);
      const list = frames[which];
      // Of the two that turn alike the nearer to the one before.
      const same = at ? q.reduce((sum, x, i) => sum + x * list[4 * (at - 1) + i], 0) : 1;
      list.set(same < 0 ? q.map((x) => -x) : q, 4 * at);
    });
  });
  const resting = (list, width) => (list.every((x, i) => x === list[i % width]) ? list.slice(0, width) : list);
  return new Motion({
    title, ending, objections: [], t: Float64Array.from(t),
    points: points.map((list) => resting(list, 3)), frames: frames.map((list) => resting(list, 4)),
  });
};
