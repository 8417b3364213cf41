// What modules of equations give at states: node equations.mjs < QUESTIONS > ANSWERS, both JSON.
//
// A question has a module, by its path, and either states { p, q, v }, or a run { p, q, u, span, rtol, atol }.
import { readFileSync } from 'node:fs';
import { dirname, join } from 'node:path';
import { pathToFileURL } from 'node:url';

const questions = JSON.parse(readFileSync(0, 'utf8'));
const answers = [];
for (const { module, states, run: asked } of questions) {
  const from = (path) => import(pathToFileURL(path).href);
  const model = await from(module);
  if (asked) {
    const { run } = await from(join(dirname(module), 'run.mjs'));
    const { end, stop } = run(model, asked);
    answers.push({ t: end.t, y: [...end.y], stop });
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
