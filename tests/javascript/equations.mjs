// What modules of equations give at states: node equations.mjs < QUESTIONS > ANSWERS, both JSON.
//
// A question has a module, by its path, and either states { p, q, v }, a run { p, q, u, span, rtol, atol }, or a pose to be closed,
// { p, q, free }.
import { readFileSync } from 'node:fs';
import { dirname, join } from 'node:path';
import { pathToFileURL } from 'node:url';

const questions = JSON.parse(readFileSync(0, 'utf8'));
const answers = [];
for (const { module, states, run: asked, assemble: pose } of questions) {
  const from = (path) => import(pathToFileURL(path).href);
  const model = await from(module);
  const n = model.COORDINATES.length;
  if (pose) {
    const { assemble } = await from(join(dirname(module), 'constraints.mjs'));
    const q = assemble(model, pose.p, pose.q, pose.free);
    answers.push({ q, open: q && model.constraints(pose.p, q, model.VARIABLES.map(() => 0)).slice(0, model.LOOPS) });
    continue;
  }
  if (asked) {
    const { run, speeds } = await from(join(dirname(module), 'run.mjs'));
    const { end, stop } = run(model, asked);
    const [q, v] = [end.y.subarray(0, n), end.y.subarray(n)];
    answers.push({
      t: end.t, y: [...end.y], stop, shown: [...q, ...speeds(model, asked.p, end.y)],
      open: model.CONSTRAINTS.length ? model.constraints(asked.p, q, v) : [],
    });
    continue;
  }
  answers.push(states.map(({ p, q, v }) => {
    const [qDot, vDot] = model.derivative(p, q, v);
    return {
      q: qDot, v: vDot, accelerations: model.accelerations(p, q, v), t: model.kinetic_energy(p, q, v), potential: model.potential_energy(p, q),
      u: model.generalized_speeds(p, q, v), divisors: model.divisors?.(p, q, v) ?? [],
      conditions: model.conditions?.(p, q, v, model.reactions(p, q, v)) ?? [], names: [model.PARAMETERS, model.COORDINATES, model.SPEEDS, model.TITLE],
    };
  }));
}
// Numbers that JSON has not are named.
process.stdout.write(JSON.stringify(answers, (_, value) => (typeof value === 'number' && !Number.isFinite(value) ? String(value) : value)));
