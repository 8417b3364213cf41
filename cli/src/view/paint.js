const SOLID_VERTEX = `#version 300 es
in vec3 place; in vec3 normal;
uniform mat4 view; uniform mat3 attitude; uniform vec3 middle; uniform vec3 scale;
uniform vec4 plane; uniform vec3 light; uniform float shade;
out vec3 n; out vec3 own; out vec3 world;
void main() {
  own = place;
  n = attitude * (normal / scale);
  world = attitude * (place * scale) + middle;
  if (shade > 0.5) {
    float height = dot(plane.xyz, world) - plane.w;
    world -= light * (height / dot(plane.xyz, light));
  }
  gl_Position = view * vec4(world, 1.0);
}`;

const SOLID_FRAGMENT = `#version 300 es
precision highp float;
in vec3 n; in vec3 own; in vec3 world;
uniform vec4 colour; uniform vec3 eye; uniform vec3 up; uniform vec3 light; uniform float pattern; uniform float shade;
out vec4 result;
void main() {
  if (shade > 0.5) { result = colour; return; }
  vec3 normal = normalize(n);
  vec3 out_ = normalize(eye - world);
  if (dot(normal, out_) < 0.0) normal = -normal;
  vec3 base = colour.rgb;
  // Quarters, so that turning is seen.
  if (pattern > 0.5) {
    vec2 edge = fwidth(own.xy) + 1e-4;
    float quarter = clamp(own.x / edge.x, -1.0, 1.0) * clamp(own.y / edge.y, -1.0, 1.0);
    if (pattern > 1.5) quarter *= clamp(own.z / (fwidth(own.z) + 1e-4), -1.0, 1.0);
    base *= 0.88 + 0.12 * quarter;
  }
  float sky = 0.5 + 0.5 * dot(normal, up);
  float key = max(dot(normal, light), 0.0);
  float head = max(dot(normal, out_), 0.0);
  float gloss = pow(max(dot(normal, normalize(light + out_)), 0.0), 40.0);
  vec3 lit = base * (0.34 + 0.24 * sky + 0.42 * key + 0.16 * head) + 0.10 * gloss;
  result = vec4(lit, colour.a);
}`;

const LINE_VERTEX = `#version 300 es
in vec2 corner; in vec3 a; in vec3 b;
uniform mat4 view; uniform vec2 screen; uniform float width; uniform float nearer;
void main() {
  vec4 p = view * vec4(a, 1.0);
  vec4 q = view * vec4(b, 1.0);
  vec2 way = (q.xy / q.w - p.xy / p.w) * screen;
  vec2 along = length(way) > 1e-6 ? normalize(way) : vec2(1.0, 0.0);
  vec2 across = vec2(-along.y, along.x);
  vec4 at = corner.x < 0.5 ? p : q;
  vec2 shift = (across * corner.y + along * (corner.x - 0.5) * 0.6) * width / screen;
  gl_Position = vec4(at.xy + shift * at.w, at.z - nearer * at.w, at.w);
}`;

const LINE_FRAGMENT = `#version 300 es
precision highp float;
uniform vec4 colour;
out vec4 result;
void main() { result = colour; }`;

const GROUND_FRAGMENT = `#version 300 es
precision highp float;
in vec3 n; in vec3 own; in vec3 world;
uniform vec4 colour; uniform vec4 rule; uniform vec3 eye; uniform vec3 centre; uniform float reach; uniform float cell;
uniform vec3 scale;
out vec4 result;
float lines(vec2 at, float wide) {
  vec2 edge = fwidth(at);
  vec2 off = abs(fract(at - 0.5) - 0.5) / max(edge, vec2(1e-6));
  vec2 fade = 1.0 - clamp(edge * 2.5, 0.0, 1.0);
  vec2 strength = (1.0 - clamp(off - wide, 0.0, 1.0)) * fade;
  return max(strength.x, strength.y);
}
void main() {
  vec2 at = own.xy * scale.xy / cell;
  float line = max(0.45 * lines(at, 0.0), lines(at / 5.0, 0.3));
  float far = 1.0 - smoothstep(0.55 * reach, reach, length(world - centre));
  result = vec4(mix(colour.rgb, rule.rgb, line), far * max(colour.a, line * rule.a));
}`;

/** Draws on one canvas; throws where there is no WebGL. */
class Painter {
  constructor(canvas) {
    const gl = canvas.getContext('webgl2', { antialias: true, stencil: true, alpha: true, preserveDrawingBuffer: true });
    if (!gl) throw new Error('no WebGL');
    this.gl = gl;
    this.canvas = canvas;
    this.solid = this.#program(SOLID_VERTEX, SOLID_FRAGMENT);
    this.ground = this.#program(SOLID_VERTEX, GROUND_FRAGMENT);
    this.line = this.#program(LINE_VERTEX, LINE_FRAGMENT);
    this.meshes = {};
    const meshes = { sphere: sphereMesh(20), cylinder: cylinderMesh(56), cone: coneMesh(28), box: boxMesh(), plane: planeMesh() };
    for (const [name, data] of Object.entries(meshes)) this.meshes[name] = this.#mesh(data);
    this.corners = this.#buffer(new Float32Array([0, -1, 1, -1, 0, 1, 1, 1]));
    this.strip = gl.createBuffer();
    this.lines = gl.createVertexArray();
  }

  #program(vertex, fragment) {
    const { gl } = this;
    const program = gl.createProgram();
    for (const [kind, text] of [[gl.VERTEX_SHADER, vertex], [gl.FRAGMENT_SHADER, fragment]]) {
      const shader = gl.createShader(kind);
      gl.shaderSource(shader, text);
      gl.compileShader(shader);
      gl.attachShader(program, shader);
    }
    ['place', 'normal'].forEach((name, at) => gl.bindAttribLocation(program, at, name));
    ['corner', 'a', 'b'].forEach((name, at) => gl.bindAttribLocation(program, at, name));
    gl.linkProgram(program);
    if (!gl.getProgramParameter(program, gl.LINK_STATUS)) throw new Error(`no shader: ${gl.getProgramInfoLog(program)}`);
    const uniforms = {};
    const count = gl.getProgramParameter(program, gl.ACTIVE_UNIFORMS);
    for (let at = 0; at < count; at += 1) {
      const { name } = gl.getActiveUniform(program, at);
      uniforms[name] = gl.getUniformLocation(program, name);
    }
    return { program, uniforms };
  }

  #buffer(data) {
    const { gl } = this;
    const buffer = gl.createBuffer();
    gl.bindBuffer(gl.ARRAY_BUFFER, buffer);
    gl.bufferData(gl.ARRAY_BUFFER, data, gl.STATIC_DRAW);
    return buffer;
  }

  #mesh(data) {
    const { gl } = this;
    const array = gl.createVertexArray();
    gl.bindVertexArray(array);
    this.#buffer(data);
    for (const at of [0, 1]) {
      gl.enableVertexAttribArray(at);
      gl.vertexAttribPointer(at, 3, gl.FLOAT, false, 24, 12 * at);
    }
    return { array, count: data.length / 6 };
  }

  #set(program, values) {
    const { gl } = this;
    gl.useProgram(program.program);
    for (const [name, value] of Object.entries(values)) {
      const at = program.uniforms[name];
      if (at === undefined) continue;
      if (typeof value === 'number') gl.uniform1f(at, value);
      else if (value.length === 16) gl.uniformMatrix4fv(at, false, value);
      else if (value.length === 9) gl.uniformMatrix3fv(at, false, value);
      else gl[`uniform${value.length}fv`](at, value);
    }
  }

  /** Begins a picture: the size of the canvas in its own pixels, and what all that follows has in common. */
  begin(width, height, shared) {
    const { gl, canvas } = this;
    if (canvas.width !== width || canvas.height !== height) [canvas.width, canvas.height] = [width, height];
    gl.viewport(0, 0, width, height);
    gl.clearColor(0, 0, 0, 0);
    gl.clear(gl.COLOR_BUFFER_BIT | gl.DEPTH_BUFFER_BIT | gl.STENCIL_BUFFER_BIT);
    gl.enable(gl.DEPTH_TEST);
    gl.depthFunc(gl.LEQUAL);
    gl.enable(gl.BLEND);
    gl.blendFuncSeparate(gl.SRC_ALPHA, gl.ONE_MINUS_SRC_ALPHA, gl.ONE, gl.ONE_MINUS_SRC_ALPHA);
    this.shared = { ...shared, shade: 0 };
    this.screen = [width / 2, height / 2];
  }

  #draw(program, mesh, at, values) {
    const { gl } = this;
    this.#set(program, { ...this.shared, middle: at.middle, attitude: matrixOf(at.attitude), scale: at.scale, ...values });
    gl.bindVertexArray(mesh.array);
    gl.drawArrays(gl.TRIANGLES, 0, mesh.count);
  }

  /** A solid of a colour; one that is seen through hides nothing. */
  draw(kind, at, colour, pattern) {
    const { gl } = this;
    const isClear = colour[3] < 1;
    gl.depthMask(!isClear);
    gl.enable(gl.CULL_FACE);
    gl.cullFace(gl.BACK);
    if (!isClear) gl.disable(gl.CULL_FACE);
    this.#draw(this.solid, this.meshes[kind], at, { colour, pattern });
    gl.disable(gl.CULL_FACE);
    gl.depthMask(true);
  }

  /** What of a solid other solids hide, seen through. */
  drawHidden(kind, at, colour) {
    const { gl } = this;
    gl.depthFunc(gl.GREATER);
    this.draw(kind, at, colour, 0);
    gl.depthFunc(gl.LEQUAL);
  }

  drawGround(at, values) {
    const { gl } = this;
    gl.depthMask(false);
    this.#draw(this.ground, this.meshes.plane, at, values);
    gl.depthMask(true);
  }

  /** What solids shade of a plane: each place once. */
  drawShadows(list, plane, colour) {
    const { gl } = this;
    gl.enable(gl.STENCIL_TEST);
    gl.stencilFunc(gl.EQUAL, 0, 255);
    gl.stencilOp(gl.KEEP, gl.KEEP, gl.INCR);
    gl.depthMask(false);
    for (const { kind, at } of list) {
      this.#draw(this.solid, this.meshes[kind], at, { colour, plane, shade: 1, pattern: 0 });
    }
    gl.depthMask(true);
    gl.disable(gl.STENCIL_TEST);
  }

  /** Lines through places, three numbers each, the first so many of them. */
  drawLine(places, colour, width, { count = places.length / 3, nearer = 0, apart = false } = {}) {
    const { gl } = this;
    if (count < 2) return;
    this.#set(this.line, { ...this.shared, colour, width, nearer, screen: this.screen });
    gl.bindVertexArray(this.lines);
    gl.bindBuffer(gl.ARRAY_BUFFER, this.corners);
    gl.enableVertexAttribArray(0);
    gl.vertexAttribPointer(0, 2, gl.FLOAT, false, 0, 0);
    gl.bindBuffer(gl.ARRAY_BUFFER, this.strip);
    gl.bufferData(gl.ARRAY_BUFFER, places, gl.DYNAMIC_DRAW);
    for (const at of [1, 2]) {
      gl.enableVertexAttribArray(at);
      gl.vertexAttribPointer(at, 3, gl.FLOAT, false, apart ? 24 : 12, 12 * (at - 1));
      gl.vertexAttribDivisor(at, 1);
    }
    gl.drawArraysInstanced(gl.TRIANGLE_STRIP, 0, 4, apart ? count / 2 : count - 1);
  }
}
