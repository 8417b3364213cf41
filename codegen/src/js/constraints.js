// Keeps runs on the constraints of a mechanism, and finds poses that close its loops.
//
// A correction is the smallest there is, by Newton's method; conditions that follow from others are left out. E. Hairer, C. Lubich &
// G. Wanner, "Geometric Numerical Integration" (2nd edition, 2006), IV.4; axes are found as by P. Businger & G. H. Golub (Numer. Math. 7,
// 1965, 269-276).

/** What is left of a row of length 1, if it counts as following from others. */
const DEPENDENT = 1e-8;
/** Corrections of one state; the part of a drift that may be left by the last; and units in the last place that are rounding. */
const [CORRECTIONS, DRIFT_LEFT, CORRECTION_ROUNDING] = [8, 1e-3, 16];
/** Steps of Newton's method towards a pose, halvings of one, and what may be left of a loop, over what it is made of. */
const [POSE_STEPS, POSE_HALVINGS, POSE_OPEN] = [100, 40, 1e-13];
/** What may be open where a pose is stated, or where a loop has to follow from the others, over what loops are made of. */
const STATED_OPEN = 1e-9;

/** The smallest x, in components over their weights, for which rows · x = open. */
function leastCorrection(rows, open, weights) {
  const x = new Float64Array(weights.length);
  const left = rows.map((row, k) => {
    const form = Float64Array.from(row, (slope, i) => slope * weights[i]);
    return { form, open: open[k], size: Math.hypot(...form) };
  });
  const share = ({ form, size }) => (size > 0 ? Math.hypot(...form) / size : 0);
  while (left.length) {
    // Next the row of which, by its own length, most is left.
    const shares = left.map(share);
    const next = shares.indexOf(Math.max(...shares));
    if (!(shares[next] > DEPENDENT)) break;
    const [{ form, open: rest }] = left.splice(next, 1);
    const length = Math.hypot(...form);
    const along = rest / length;
    const axis = form.map((value) => value / length);
    axis.forEach((value, i) => { x[i] += along * value * weights[i]; });
    for (const other of left) {
      const part = other.form.reduce((sum, value, i) => sum + value * axis[i], 0);
      axis.forEach((value, i) => { other.form[i] -= part * value; });
      other.open -= part * along;
    }
  }
  return x;
}

/** The sum of |slope · x| of a row, with a bound on |x|. */
const termsOf = (row, y, bound) => row.reduce((sum, slope, i) => sum + Math.abs(slope) * bound(Math.abs(y[i])), 0);

/** The constraints that a run can drift from. */
class Constraints {
  constructor(model, p) {
    Object.assign(this, { model, p, n: model.COORDINATES.length });
  }

  values(y) {
    return this.model.constraints(this.p, y.subarray(0, this.n), y.subarray(this.n));
  }

  slopes(y) {
    const all = this.model.constraint_slopes(this.p, y.subarray(0, this.n), y.subarray(this.n));
    return this.model.CONSTRAINTS.map((_, k) => all.slice(k * y.length, (k + 1) * y.length));
  }

  /** Moves a state onto them, in place; says whether it is there. `weight(i)` is the error of component i that a step may have. */
  keep(y, weight) {
    const weights = Float64Array.from(y, (_, i) => weight(i));
    let before;
    let isSettled = false;
    for (let count = 0; ; count += 1) {
      const [open, rows] = [this.values(y), this.slopes(y)];
      if (![...open, ...rows.flat()].every(Number.isFinite)) return false;
      before ??= open;
      // Values are rounded as they are computed: the sine of an angle of a thousand turns is as exact as that of a small one.
      const isWithin = (bound) => open.every((value, k) => Math.abs(value) <= 2 ** -51 * termsOf(rows[k], y, bound));
      if (isWithin((x) => Math.min(x, 1))) return true;
      if (count === CORRECTIONS) {
        return isSettled || isWithin((x) => x) || open.every((value, k) => Math.abs(value) <= DRIFT_LEFT * Math.abs(before[k]));
      }
      const x = leastCorrection(rows, open, weights);
      x.forEach((value, i) => { y[i] -= value; });
      // Down to the rounding of the constraints, or of the largest component.
      const isRounding = (bound) => {
        const largest = y.reduce((most, value) => Math.max(most, bound(Math.abs(value))), 0);
        return x.every((value) => Math.abs(value) <= CORRECTION_ROUNDING * 2 ** -52 * largest);
      };
      if (isRounding((value) => Math.min(value, 1))) return true;
      isSettled ||= isRounding((value) => value);
    }
  }
}

/** The loops of a mechanism as functions of its coordinates, at these parameters. */
class Loops {
  constructor(model, p) {
    const { LOOPS, COORDINATES, VARIABLES } = model;
    this.constraints = new Constraints(model, p);
    this.count = LOOPS;
    this.state = (q) => Float64Array.from([...q, ...VARIABLES.map(() => 0)]);
    this.n = COORDINATES.length;
  }

  open(q) {
    return this.constraints.values(this.state(q)).slice(0, this.count);
  }

  rows(q) {
    return this.constraints.slopes(this.state(q)).slice(0, this.count).map((row) => row.slice(0, this.n));
  }

  /** What each loop is made of. */
  sizes(q) {
    return this.rows(q).map((row) => termsOf(row, q, (x) => Math.max(x, 1)));
  }

  /** Whether all are closed to this part of what they are made of, those too that follow from others. */
  areClosed(q, part) {
    const { model, p } = this.constraints;
    const sizes = this.sizes(q);
    const following = model.redundant_constraints?.(p, q) ?? [];
    const most = Math.max(...sizes);
    return this.open(q).every((value, k) => Math.abs(value) <= part * sizes[k]) && following.every((value) => Math.abs(value) <= STATED_OPEN * most);
  }
}

/**
 * Coordinates near q that close the loops, at parameters p; null where none are found. `free` has the places of those that may move, all if
 * it is left out; where the loops leave some of these open, they move as little as can be.
 */
export function assemble(model, p, q, free = model.COORDINATES.map((_, i) => i)) {
  if (!model.LOOPS) return [...q];
  const loops = new Loops(model, p);
  let [now, open] = [[...q], loops.open(q)];
  const ones = free.map(() => 1);
  for (let step = 0; step < POSE_STEPS; step += 1) {
    const rows = loops.rows(now).map((row) => free.map((i) => row[i]));
    const x = leastCorrection(rows, open, ones);
    let better = null;
    for (let share = 1, count = 0; count < POSE_HALVINGS && !better; share /= 2, count += 1) {
      const next = [...now];
      free.forEach((i, k) => { next[i] -= share * x[k]; });
      const left = loops.open(next);
      if (Math.hypot(...left) < Math.hypot(...open)) better = [next, left];
    }
    if (!better) break;
    [now, open] = better;
  }
  return loops.areClosed(now, POSE_OPEN) ? now : null;
}

/** Whether stated coordinates close the loops, to as many digits as people write. */
export function closesLoops(model, p, q) {
  return !model.LOOPS || new Loops(model, p).areClosed(q, STATED_OPEN);
}

/** What moves the states of a run onto its constraints, for `integrate`; none where no run can drift from any. */
export function keeping(model, p) {
  if (!model.CONSTRAINTS.length) return null;
  const constraints = new Constraints(model, p);
  return (y, weight) => constraints.keep(y, weight);
}
