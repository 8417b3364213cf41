// Vectors are arrays of three, rotations Euler parameters [w, x, y, z], matrices of WebGL by columns.
const add = (a, b, k = 1) => [a[0] + k * b[0], a[1] + k * b[1], a[2] + k * b[2]];
const sub = (a, b) => add(a, b, -1);
const dot = (a, b) => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
const cross = (a, b) => [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];
const size = (a) => Math.hypot(a[0], a[1], a[2]);
const times = (a, k) => [a[0] * k, a[1] * k, a[2] * k];
const unit = (a) => times(a, 1 / (size(a) || 1));
const clamp = (x, low, high) => Math.min(high, Math.max(low, x));

/** The rotation q after r. */
const compose = ([a, b, c, d], [w, x, y, z]) => [
  a * w - b * x - c * y - d * z,
  a * x + b * w + c * z - d * y,
  a * y - b * z + c * w + d * x,
  a * z + b * y - c * x + d * w,
];

/** A vector turned by q. */
const turn = ([w, x, y, z], v) => {
  const t = times(cross([x, y, z], v), 2);
  return add(add(v, t, w), cross([x, y, z], t));
};

/** On the even way from one attitude to another (Shoemake 1985). */
const slerp = (a, b, share) => {
  let cos = a[0] * b[0] + a[1] * b[1] + a[2] * b[2] + a[3] * b[3];
  const sign = cos < 0 ? -1 : 1;
  cos = Math.min(1, Math.abs(cos));
  const angle = Math.acos(cos);
  const near = angle < 1e-4;
  const from = near ? 1 - share : Math.sin(angle * (1 - share)) / Math.sin(angle);
  const to = sign * (near ? share : Math.sin(angle * share) / Math.sin(angle));
  const q = [0, 1, 2, 3].map((i) => from * a[i] + to * b[i]);
  const length = Math.hypot(...q) || 1;
  return q.map((x) => x / length);
};

/** The shortest turn that takes axis 3 to a direction. */
const towards = (d) => {
  if (d[2] < -0.999999) return [0, 1, 0, 0];
  const q = [1 + d[2], -d[1], d[0], 0];
  const length = Math.hypot(...q);
  return q.map((x) => x / length);
};

/** Nine entries of a rotation, by columns. */
const matrixOf = (q) => [...turn(q, [1, 0, 0]), ...turn(q, [0, 1, 0]), ...turn(q, [0, 0, 1])];

const multiply = (a, b) => {
  const out = new Float32Array(16);
  for (let column = 0; column < 4; column += 1) {
    for (let row = 0; row < 4; row += 1) {
      let sum = 0;
      for (let k = 0; k < 4; k += 1) sum += a[4 * k + row] * b[4 * column + k];
      out[4 * column + row] = sum;
    }
  }
  return out;
};

const perspective = (angle, aspect, near, far) => {
  const f = 1 / Math.tan(angle / 2);
  const m = new Float32Array(16);
  m[0] = f / aspect;
  m[5] = f;
  m[10] = (far + near) / (near - far);
  m[11] = -1;
  m[14] = (2 * far * near) / (near - far);
  return m;
};

const lookAt = (eye, target, up) => {
  const back = unit(sub(eye, target));
  const right = unit(cross(up, back));
  const above = cross(back, right);
  return new Float32Array([
    right[0], above[0], back[0], 0,
    right[1], above[1], back[1], 0,
    right[2], above[2], back[2], 0,
    -dot(right, eye), -dot(above, eye), -dot(back, eye), 1,
  ]);
};
