// The method DOP853 in JavaScript, against closed forms: node method.mjs FOLDER, with dop853.mjs and, of the pendulum, kane.mjs and run.mjs.
// Ends with status 0 and a line for each thing that held, or with the first that did not.
import assert from 'node:assert/strict';
import { join, resolve } from 'node:path';
import { pathToFileURL } from 'node:url';

const [folder] = process.argv.slice(2);
const from = (file) => import(pathToFileURL(resolve(join(folder, file))).href);
const { integrate } = await from('dop853.mjs');
const { run } = await from('run.mjs');
const pendulum = await from('kane.mjs');

/** y'' = -y from (1, 0): cos t, -sin t. */
const wave = (t, y, out) => { [out[0], out[1]] = [y[1], -y[0]]; };
const off = (t, y) => Math.hypot(y[0] - Math.cos(t), y[1] + Math.sin(t));
const held = (what) => console.log(`${what}: held`);

// Errors follow the tolerance over five decades: with steps of order 8, tenfold steps take 1e8 of it.
{
  const runs = [1e-5, 1e-8, 1e-11].map((rtol) => integrate(wave, [0, 20], [1, 0], { rtol, atol: rtol }));
  const errors = runs.map(({ end }) => off(end.t, end.y));
  const order = Math.log(errors[0] / errors[2]) / Math.log(runs[2].steps / runs[0].steps);
  assert(errors.every((error, at) => error < 30 * [1e-5, 1e-8, 1e-11][at]), `${errors}`);
  assert(order > 7 && order < 10, `order ${order}`);
  held('order');
}
// Inside steps the error is that of their ends, to two digits; and the run is the same whoever looks.
{
  const times = Array.from({ length: 401 }, (_, at) => at / 20);
  const options = { rtol: 1e-9, atol: 1e-9 };
  const [seen, unseen] = [integrate(wave, [0, 20], [1, 0], { ...options, times }), integrate(wave, [0, 20], [1, 0], options)];
  const worst = Math.max(...seen.t.map((t, at) => off(t, seen.y[at])));
  assert.equal(seen.t.length, 401);
  assert(worst < 1e-7 && seen.steps < 60, `${worst} in ${seen.steps} steps`);
  assert.deepEqual([...seen.end.y], [...unseen.end.y]);
  held('inside');
}
// There and back; and rtol is heeded where atol is tiny: e^-t over thirty e-foldings keeps its digits.
{
  const back = integrate(wave, [3, 0], [Math.cos(3), -Math.sin(3)], { rtol: 1e-12, atol: 1e-12, times: [3, 2, 0] });
  assert.deepEqual(back.t, [3, 2, 0]);
  assert(back.y.every((y, at) => off(back.t[at], y) < 1e-11));
  const decay = integrate((t, y, out) => { out[0] = -y[0]; }, [0, 30], [1], { rtol: 1e-9, atol: 1e-30 });
  assert(Math.abs(decay.end.y[0] * Math.exp(30) - 1) < 1e-7, `${decay.end.y}`);
  held('backward and relative');
}
// A condition ends the run where it falls through zero: cos t at pi/2; in the other direction at 3 pi/2.
{
  const watch = (directions) => ({ values: (t, y) => [y[0]], directions, divides: [false] });
  for (const [direction, t] of [[-1, Math.PI / 2], [1, 1.5 * Math.PI], [0, Math.PI / 2]]) {
    const { stop, end, t: times } = integrate(wave, [0, 9], [1, 0], { rtol: 1e-11, atol: 1e-11, watch: watch([direction]), times: [0, 1, 8] });
    assert.deepEqual([stop.kind, stop.at, times.length], ['watched', 0, t > 8 ? 3 : 2]);
    assert(Math.abs(end.t - t) < 1e-9, `${end.t}`);
  }
  held('conditions');
}
// x' = v/x with v' = 1/4 divides by x, which is zero at t = 2 from x = -1 and v = -1/2 - 1e-9: no motion beyond. With v = 1 the exact zero
// of 0/0 is passed: x' = (x v)/x has none. A pole of the divisor, tan t at pi/2, is no zero.
{
  const divides = (values) => ({ values, directions: [0], divides: [true] });
  const point = (t, y, out) => { [out[0], out[1]] = [y[1] / y[0], 0.25]; };
  const ended = integrate(point, [0, 10], [-1, -0.5 - 1e-9], { rtol: 1e-6, atol: 1e-9, watch: divides((t, y) => [y[0]]) });
  assert(['watched', 'short'].includes(ended.stop.kind) && ended.end.t < 2.01, JSON.stringify(ended.stop));
  const passes = (t, y, out) => { [out[0], out[1]] = [(y[0] * y[1]) / y[0], 0]; };
  const passed = integrate(passes, [0, 3], [-1, 1], { watch: divides((t, y) => [y[0]]) });
  assert(passed.stop.kind === 'end' && Math.abs(passed.end.y[0] - 2) < 1e-9, JSON.stringify(passed.stop));
  const pole = integrate(wave, [0, 3], [1, 0], { rtol: 1e-4, atol: 1e-4, watch: divides((t) => [Math.tan(t)]) });
  assert.equal(pole.stop.kind, 'end');
  held('divisors');
}
// Ends that are no motion: too many steps, a solution that reaches infinity (y' = y^2 at t = 1), a start without a value.
{
  assert.equal(integrate(wave, [0, 1e6], [1, 0], { limit: 50 }).stop.kind, 'steps');
  const blown = integrate((t, y, out) => { out[0] = y[0] * y[0]; }, [0, 2], [1], { limit: 10000 });
  assert(['short', 'steps'].includes(blown.stop.kind) && Math.abs(blown.end.t - 1) < 1e-6, JSON.stringify(blown.stop));
  assert.equal(integrate((t, y, out) => { out[0] = 1 / y[0] / 0 - 1 / 0; }, [0, 2], [1]).stop.kind, 'undefined');
  held('ends');
}
// Ten seconds of a pendulum that was let go at 2 rad: after four periods, 2 pi sqrt(l/g) / agm(1, cos(1)) each, it is there and at rest, to
// a thousand times the tolerance of a step; and its energy is kept.
{
  const [theta, g] = [2, 9.81];
  let [a, b] = [1, Math.cos(theta / 2)];
  while (Math.abs(a - b) > 1e-15) [a, b] = [(a + b) / 2, Math.sqrt(a * b)];
  const period = (2 * Math.PI) / Math.sqrt(g) / a;
  for (const rtol of [1e-6, 1e-9, 1e-12]) {
    const { end, stop } = run(pendulum, { q: [theta], u: [0], span: [0, 4 * period], rtol, atol: rtol });
    assert(stop.kind === 'end' && 4 * period > 10);
    assert(Math.hypot(end.y[0] - theta, end.y[1]) < 1000 * rtol, `${rtol}: ${end.y}`);
    const [q, u] = [end.y.subarray(0, 1), end.y.subarray(1)];
    const energy = pendulum.kinetic_energy(pendulum.DEFAULTS, q, u) + pendulum.potential_energy(pendulum.DEFAULTS, q);
    assert(Math.abs(energy - g * (1 - Math.cos(theta))) < 1000 * rtol, `${rtol}: ${energy}`);
  }
  held('pendulum');
}
