// Runs of a mechanism: `model` is a module of equations, such as kane.mjs beside this file.
import { integrate } from './dop853.mjs';
import { closesLoops, keeping } from './constraints.mjs';

/** q' and v' of a state y that has q first, then the motion variables v. */
export function rightHandSide(model, p) {
  const n = model.COORDINATES.length;
  return (t, y, out) => {
    const [qDot, vDot] = model.derivative(p, y.subarray(0, n), y.subarray(n));
    for (let i = 0; i < n; i += 1) out[i] = qDot[i];
    for (let i = 0; i < vDot.length; i += 1) out[n + i] = vDot[i];
  };
}

/** What ends a run: what the equations divide by changes its sign, or a condition does in its direction. Conditions stand first. */
function watched(model, p, directions) {
  const n = model.COORDINATES.length;
  const { DIVISORS, CONDITIONS } = model;
  if (!DIVISORS.length && !CONDITIONS.length) return null;
  return {
    directions: [...(directions ?? CONDITIONS.map(() => -1)), ...DIVISORS.map(() => 0)],
    divides: [...CONDITIONS.map(() => false), ...DIVISORS.map(() => true)],
    values: (t, y) => {
      const [q, v] = [y.subarray(0, n), y.subarray(n)];
      const conditions = CONDITIONS.length ? model.conditions(p, q, v, model.reactions(p, q, v)) : [];
      return [...conditions, ...(DIVISORS.length ? model.divisors(p, q, v) : [])];
    },
  };
}

/** T + V at a state. */
export function energy(model, p, y) {
  const n = model.COORDINATES.length;
  const [q, v] = [y.subarray(0, n), y.subarray(n)];
  return model.kinetic_energy(p, q, v) + model.potential_energy(p, q);
}

/**
 * Runs a motion from coordinates q and generalized speeds u over a span [from, to]; q closes the loops, as `assemble` finds it. States are
 * kept on the constraints after each step.
 *
 * Options are those of `integrate` but for `watch` and `keep`; `directions` says in which direction each condition ends a run (-1: where it falls below
 * zero, which is usual; 1, 0), and `holds` which of them must hold at the start, all if it is left out. States in what is returned have the
 * coordinates first, then the motion variables of the equations. A stop that was watched has the name of what ended it; "open" is where q
 * does not close the loops to nine digits.
 */
export function run(model, { p = model.DEFAULTS, q, u, span, directions, holds, ...options }) {
  const start = Float64Array.from([...q, ...model.motion_variables(p, q, u)]);
  const ended = (stop) => ({ t: [span[0]], y: [start], end: { t: span[0], y: start }, stop, steps: 0, rejected: 0, evaluations: 0 });
  if (!start.every(Number.isFinite)) return ended({ kind: 'undefined' });
  if (!closesLoops(model, p, q)) return ended({ kind: 'open' });
  const keep = keeping(model, p);
  if (keep && !keep(start, () => 1)) return ended({ kind: 'adrift' });
  const watch = watched(model, p, directions);
  const name = (at) => [...model.CONDITIONS, ...model.DIVISORS][at];
  const values = watch?.values(span[0], start) ?? [];
  const outside = model.CONDITIONS.findIndex((_, at) => (holds?.[at] ?? true) && values[at] < 0);
  if (outside >= 0) return ended({ kind: 'watched', at: outside, name: name(outside) });
  const done = integrate(rightHandSide(model, p), span, start, { ...options, watch, keep });
  if (done.stop.kind === 'watched') done.stop.name = name(done.stop.at);
  return done;
}

/** The generalized speeds of a state. */
export function speeds(model, p, y) {
  const n = model.COORDINATES.length;
  return model.generalized_speeds(p, y.subarray(0, n), y.subarray(n));
}
