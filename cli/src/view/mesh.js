// Meshes of unit size: places and normals, three numbers each, by triangles.
const quad = (out, corners, normals) => {
  for (const at of [0, 1, 2, 0, 2, 3]) out.push(...corners[at], ...normals[at]);
};

const cylinderMesh = (sides) => {
  const out = [];
  const rim = (k) => [Math.cos((2 * Math.PI * k) / sides), Math.sin((2 * Math.PI * k) / sides)];
  for (let k = 0; k < sides; k += 1) {
    const [a, b] = [rim(k), rim(k + 1)];
    quad(
      out,
      [[...a, -0.5], [...b, -0.5], [...b, 0.5], [...a, 0.5]],
      [[...a, 0], [...b, 0], [...b, 0], [...a, 0]],
    );
    for (const end of [-0.5, 0.5]) {
      const normal = [0, 0, 2 * end];
      for (const corner of [[0, 0, end], [...a, end], [...b, end]]) out.push(...corner, ...normal);
    }
  }
  return new Float32Array(out);
};

const coneMesh = (sides) => {
  const out = [];
  const rim = (k) => [Math.cos((2 * Math.PI * k) / sides), Math.sin((2 * Math.PI * k) / sides)];
  for (let k = 0; k < sides; k += 1) {
    const [a, b] = [rim(k), rim(k + 1)];
    for (const [corner, normal] of [[[...a, -0.5], [...a, 1]], [[...b, -0.5], [...b, 1]], [[0, 0, 0.5], [...a, 1]]]) out.push(...corner, ...normal);
    for (const corner of [[0, 0, -0.5], [...b, -0.5], [...a, -0.5]]) out.push(...corner, 0, 0, -1);
  }
  return new Float32Array(out);
};

const sphereMesh = (sides) => {
  const out = [];
  const place = (i, j) => {
    const [across, along] = [(Math.PI * i) / sides, (Math.PI * j) / sides];
    return [Math.sin(across) * Math.cos(along), Math.sin(across) * Math.sin(along), Math.cos(across)];
  };
  for (let i = 0; i < sides; i += 1) {
    for (let j = 0; j < 2 * sides; j += 1) {
      const corners = [place(i, j), place(i + 1, j), place(i + 1, j + 1), place(i, j + 1)];
      quad(out, corners, corners);
    }
  }
  return new Float32Array(out);
};

const boxMesh = () => {
  const out = [];
  for (let axis = 0; axis < 3; axis += 1) {
    for (const side of [-0.5, 0.5]) {
      const corner = (a, b) => {
        const place = [0, 0, 0];
        place[axis] = side;
        place[(axis + 1) % 3] = a;
        place[(axis + 2) % 3] = b;
        return place;
      };
      const normal = [0, 0, 0];
      normal[axis] = 2 * side;
      quad(out, [corner(-0.5, -0.5), corner(0.5, -0.5), corner(0.5, 0.5), corner(-0.5, 0.5)], Array(4).fill(normal));
    }
  }
  return new Float32Array(out);
};

const planeMesh = () => {
  const out = [];
  quad(out, [[-1, -1, 0], [1, -1, 0], [1, 1, 0], [-1, 1, 0]], Array(4).fill([0, 0, 1]));
  return new Float32Array(out);
};

/** The places of a coil between two points, as lines. */
const coil = (a, b, radius) => {
  const way = sub(b, a);
  const attitude = towards(unit(way));
  const [turns, parts] = [9, 14];
  const out = [...a];
  for (let k = 0; k <= turns * parts; k += 1) {
    const share = k / (turns * parts);
    const angle = 2 * Math.PI * turns * share;
    const side = turn(attitude, [radius * Math.cos(angle), radius * Math.sin(angle), 0]);
    out.push(...add(add(a, way, 0.12 + 0.76 * share), side));
  }
  out.push(...b);
  return new Float32Array(out);
};
