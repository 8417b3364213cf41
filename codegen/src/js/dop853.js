// The method DOP853 for y' = f(t, y): steps of order 8 as long as their errors allow, values inside them, and ends where something changes
// its sign. It needs nothing but itself, in Node and in browsers.
//
// The formulae are those of E. Hairer, S. P. Nørsett & G. Wanner, "Solving Ordinary Differential Equations I" (2nd edition, 1993), II.5
// (steps and errors) and II.6 (inside), of P. J. Prince & J. R. Dormand's method of 1981; coefficients are rounded to doubles.

// When the stages are, as parts of a step; and the weights of the stages before each, the stage first. Row 12 is the new point, 13 to 15
// serve what is inside.
const INSTANTS = [
  0, 0.05260015195876773, 0.0789002279381516, 0.1183503419072274, 0.2816496580927726, 1 / 3, 0.25, 4 / 13, 127 / 195, 0.6, 6 / 7, 1, 1, 0.1, 0.2,
  7 / 9,
];
const STAGES = [
  [],
  [[0, 0.05260015195876773]],
  [[0, 0.0197250569845379], [1, 0.0591751709536137]],
  [[0, 0.02958758547680685], [2, 0.08876275643042054]],
  [[0, 0.2413651341592667], [2, -0.8845494793282861], [3, 0.924834003261792]],
  [[0, 0.037037037037037035], [3, 0.17082860872947386], [4, 0.12546768756682242]],
  [[0, 0.037109375], [3, 0.17025221101954405], [4, 0.06021653898045596], [5, -0.017578125]],
  [
    [0, 0.03709200011850479], [3, 0.17038392571223998], [4, 0.10726203044637328], [5, -0.015319437748624402],
    [6, 0.008273789163814023]
  ],
  [
    [0, 0.6241109587160757], [3, -3.3608926294469414], [4, -0.868219346841726], [5, 27.59209969944671],
    [6, 20.154067550477894], [7, -43.48988418106996]
  ],
  [
    [0, 0.47766253643826434], [3, -2.4881146199716677], [4, -0.590290826836843], [5, 21.230051448181193],
    [6, 15.279233632882423], [7, -33.28821096898486], [8, -0.020331201708508627]
  ],
  [
    [0, -0.9371424300859873], [3, 5.186372428844064], [4, 1.0914373489967295], [5, -8.149787010746927],
    [6, -18.52006565999696], [7, 22.739487099350505], [8, 2.4936055526796523], [9, -3.0467644718982196]
  ],
  [
    [0, 2.273310147516538], [3, -10.53449546673725], [4, -2.0008720582248625], [5, -17.9589318631188],
    [6, 27.94888452941996], [7, -2.8589982771350235], [8, -8.87285693353063], [9, 12.360567175794303],
    [10, 0.6433927460157636]
  ],
  [
    [0, 0.054293734116568765], [5, 4.450312892752409], [6, 1.8915178993145003], [7, -5.801203960010585],
    [8, 0.3111643669578199], [9, -0.1521609496625161], [10, 0.20136540080403034], [11, 0.04471061572777259]
  ],
  [
    [0, 0.056167502283047954], [6, 0.25350021021662483], [7, -0.2462390374708025], [8, -0.12419142326381637],
    [9, 0.15329179827876568], [10, 0.00820105229563469], [11, 0.007567897660545699], [12, -0.008298]
  ],
  [
    [0, 0.03183464816350214], [5, 0.028300909672366776], [6, 0.053541988307438566], [7, -0.05492374857139099],
    [10, -0.00010834732869724932], [11, 0.0003825710908356584], [12, -0.00034046500868740456], [13, 0.1413124436746325]
  ],
  [
    [0, -0.42889630158379194], [5, -4.697621415361164], [6, 7.683421196062599], [7, 4.06898981839711],
    [8, 0.3567271874552811], [12, -0.0013990241651590145], [13, 2.9475147891527724], [14, -9.15095847217987]
  ],
];
// Differences from solutions of order 5 and 3, and the last coefficients of the polynomial inside.
const FIFTH = [
  [0, 0.01312004499419488], [5, -1.2251564463762044], [6, -0.4957589496572502], [7, 1.6643771824549864],
  [8, -0.35032884874997366], [9, 0.3341791187130175], [10, 0.08192320648511571], [11, -0.022355307863886294]
];
const THIRD = [[0, 0.2440944881889764], [8, 0.7338466882816118], [11, 0.022058823529411766]];
const INSIDE = [
  [
    [0, -8.428938276109013], [5, 0.5667149535193777], [6, -3.0689499459498917], [7, 2.38466765651207],
    [8, 2.117034582445028], [9, -0.871391583777973], [10, 2.2404374302607883], [11, 0.6315787787694688],
    [12, -0.08899033645133331], [13, 18.148505520854727], [14, -9.194632392478356], [15, -4.436036387594894]
  ],
  [
    [0, 10.427508642579134], [5, 242.28349177525817], [6, 165.20045171727028], [7, -374.5467547226902],
    [8, -22.113666853125306], [9, 7.733432668472264], [10, -30.674084731089398], [11, -9.332130526430229],
    [12, 15.697238121770845], [13, -31.139403219565178], [14, -9.35292435884448], [15, 35.81684148639408]
  ],
  [
    [0, 19.985053242002433], [5, -387.0373087493518], [6, -189.17813819516758], [7, 527.8081592054236],
    [8, -11.57390253995963], [9, 6.8812326946963], [10, -1.0006050966910838], [11, 0.7777137798053443],
    [12, -2.778205752353508], [13, -60.19669523126412], [14, 84.32040550667716], [15, 11.99229113618279]
  ],
  [
    [0, -25.69393346270375], [5, -154.18974869023643], [6, -231.5293791760455], [7, 357.6391179106141],
    [8, 93.40532418362432], [9, -37.45832313645163], [10, 104.0996495089623], [11, 29.8402934266605],
    [12, -43.53345659001114], [13, 96.32455395918828], [14, -39.17726167561544], [15, -149.72683625798564]
  ],
];

const END = 12;
const [SAFETY, SHRINK, GROW] = [0.9, 0.333, 6];
/** How often a zero is halved, and how near to one f is looked at, in parts of a step. */
const [HALVINGS, NEAR] = [80, [1e-4, 1e-8, 1e-12]];

/** 16 units in the last place of t: no step is shorter. */
const shortest = (t) => 16 * Math.max(Math.abs(t) * 2 ** -52, Number.MIN_VALUE);

/** One step, its error, and what is inside. */
class Step {
  constructor(f, y, { rtol, atol }) {
    this.f = f;
    this.n = y.length;
    this.rtol = rtol;
    this.atol = Float64Array.from(y, (_, i) => Math.max(typeof atol === 'number' ? atol : atol[i], Number.MIN_VALUE));
    this.y = Float64Array.from(y);
    this.end = new Float64Array(this.n);
    this.inner = new Float64Array(this.n);
    this.k = STAGES.map(() => new Float64Array(this.n));
    this.polynomial = STAGES.slice(0, 8).map(() => new Float64Array(this.n));
    this.evaluations = 0;
  }

  /** f as a stage; whether all of it is a number. */
  #evaluate(t, y, stage) {
    this.evaluations += 1;
    this.f(t, y, this.k[stage]);
    return this.k[stage].every(Number.isFinite);
  }

  #combined(row, i) {
    let sum = 0;
    for (const [stage, weight] of row) sum += weight * this.k[stage][i];
    return sum;
  }

  #advance(row, h, out) {
    for (let i = 0; i < this.n; i += 1) out[i] = this.y[i] + h * this.#combined(row, i);
  }

  begin(t) {
    this.t = t;
    return this.#evaluate(t, this.y, 0);
  }

  #weight(i, magnitude) {
    return this.atol[i] + this.rtol * magnitude;
  }

  #norm(x) {
    return Math.sqrt(x.reduce((sum, value, i) => sum + (value / this.#weight(i, Math.abs(this.y[i]))) ** 2, 0));
  }

  /** Hairer's first step: such that the eighth power of it, times the larger of the norms of y' and y'', is 0.01. */
  first(length) {
    const [size, slope] = [this.#norm(this.y), this.#norm(this.k[0])];
    const guess = Math.min(size <= 1e-5 || slope <= 1e-5 ? 1e-6 : (0.01 * size) / slope, Math.abs(length));
    const h = guess * Math.sign(length);
    for (let i = 0; i < this.n; i += 1) this.inner[i] = this.y[i] + h * this.k[0][i];
    if (!this.#evaluate(this.t + h, this.inner, 1)) return guess;
    const bend = this.#norm(this.k[1].map((value, i) => value - this.k[0][i])) / guess;
    const larger = Math.max(slope, bend);
    const next = larger <= 1e-15 ? Math.max(1e-6, 1e-3 * guess) : (0.01 / larger) ** (1 / 8);
    return Math.min(100 * guess, next, Math.abs(length));
  }

  /** A step to t1: its error, at most 1 if it is good, or not a number if f is none on the way. */
  attempt(t1) {
    const h = t1 - this.t;
    this.t1 = t1;
    this.known = false;
    for (let stage = 1; stage < END; stage += 1) {
      this.#advance(STAGES[stage], h, this.end);
      if (!this.#evaluate(this.t + INSTANTS[stage] * h, this.end, stage)) return NaN;
    }
    let [fifth, third] = [0, 0];
    for (let i = 0; i < this.n; i += 1) {
      const slope = this.#combined(STAGES[END], i);
      this.end[i] = this.y[i] + h * slope;
      const weight = this.#weight(i, Math.max(Math.abs(this.y[i]), Math.abs(this.end[i])));
      fifth += (this.#combined(FIFTH, i) / weight) ** 2;
      third += ((slope - this.#combined(THIRD, i)) / weight) ** 2;
    }
    const both = fifth + 0.01 * third;
    const error = (Math.abs(h) * fifth) / Math.sqrt((both > 0 ? both : 1) * Math.max(this.n, 1));
    return error <= 1 && !this.#evaluate(t1, this.end, END) ? NaN : error;
  }

  /** Makes ready what is inside a good step. */
  #prepare() {
    if (this.known) return;
    const h = this.t1 - this.t;
    for (let stage = END + 1; stage < STAGES.length; stage += 1) {
      this.#advance(STAGES[stage], h, this.inner);
      this.#evaluate(this.t + INSTANTS[stage] * h, this.inner, stage);
    }
    const [r0, r1, r2, r3, ...rest] = this.polynomial;
    for (let i = 0; i < this.n; i += 1) {
      const rise = this.end[i] - this.y[i];
      const bend = h * this.k[0][i] - rise;
      [r0[i], r1[i], r2[i], r3[i]] = [this.y[i], rise, bend, rise - h * this.k[END][i] - bend];
      rest.forEach((r, at) => { r[i] = h * this.#combined(INSIDE[at], i); });
    }
    this.known = true;
  }

  /** y at a part of a good step, to order 7. */
  inside(part, out) {
    this.#prepare();
    const [r0, r1, r2, r3, r4, r5, r6, r7] = this.polynomial;
    const rest = 1 - part;
    for (let i = 0; i < this.n; i += 1) {
      const inner = r4[i] + part * (r5[i] + rest * (r6[i] + part * r7[i]));
      out[i] = r0[i] + part * (r1[i] + rest * (r2[i] + part * (r3[i] + rest * inner)));
    }
    return out;
  }

  /** Goes on from the end of a good step, or from where it is kept; says why it cannot. */
  accept(keep) {
    this.t = this.t1;
    this.y.set(this.end);
    this.k[0].set(this.k[END]);
    if (!keep) return null;
    if (!this.moved(keep, this.y)) return 'adrift';
    const isMoved = this.y.some((value, i) => value !== this.end[i]);
    return isMoved && !this.#evaluate(this.t, this.y, 0) ? 'undefined' : null;
  }

  /** Moves a state to where it is kept, in place; says whether it could. */
  moved(keep, y) {
    return keep(y, (i) => this.#weight(i, Math.min(Math.abs(y[i]), 1)));
  }
}

/** Values that end a run where they change their sign: over each step, and inside it. */
class Guard {
  constructor(step, watch) {
    this.step = step;
    this.watch = watch;
    this.state = new Float64Array(step.n);
    this.before = watch ? watch.values(step.t, step.y) : [];
  }

  /** The first change inside a good step, as a part of it and with its place among what is watched. */
  zero() {
    const { step, watch } = this;
    if (!watch) return null;
    const after = watch.values(step.t1, step.end);
    const found = [];
    after.forEach((value, at) => {
      const direction = watch.directions[at];
      const [a, b] = [this.before[at], value];
      const falls = a > 0 && b <= 0 && direction <= 0;
      const rises = a < 0 && b >= 0 && direction >= 0;
      if (!falls && !rises) return;
      const part = this.#halved(at, Math.sign(a));
      if (watch.divides[at] && (this.#isPole(at, part, a, b) || this.#isPassed(part))) return;
      found.push({ part, at });
    });
    this.after = after;
    return found.reduce((first, each) => (first && first.part <= each.part ? first : each), null);
  }

  accept() {
    this.before = this.after ?? this.before;
  }

  #value(at, part) {
    const { step } = this;
    return this.watch.values(step.t + part * (step.t1 - step.t), step.inside(part, this.state))[at];
  }

  #halved(at, side) {
    let [low, high] = [0, 1];
    for (let count = 0; count < HALVINGS && high - low > 2 ** -52; count += 1) {
      const middle = (low + high) / 2;
      if (side * this.#value(at, middle) > 0) low = middle;
      else high = middle;
    }
    return high;
  }

  /** Whether the value goes through infinity, not zero. */
  #isPole(at, part, a, b) {
    return Math.abs(this.#value(at, part)) > Math.max(Math.abs(a), Math.abs(b));
  }

  /** Whether f stays as large next to the zero as it is elsewhere: what is divided is zero as well, and the motion passes. */
  #isPassed(zero) {
    const { step } = this;
    const rates = (part) => {
      const out = new Float64Array(step.n);
      step.f(step.t + part * (step.t1 - step.t), step.inside(part, this.state), out);
      return out.map(Math.abs);
    };
    const far = [rates(0.5 * zero), rates(0.5 + 0.5 * zero)];
    const largest = Math.max(...far[0], ...far[1]);
    const near = NEAR.flatMap((d) => [zero - d, zero + d]).filter((part) => part >= 0 && part <= 1);
    return near.every((part) => rates(part).every((rate, i) => rate <= 100 * Math.max(far[0][i], far[1][i], 1e-9 * largest)));
  }
}

/**
 * Integrates y' = f(t, y) from t0 to t1, also back in time.
 *
 * f(t, y, out) writes y' to `out`. Options: `rtol` and `atol`, the error of a step that is allowed, relative and absolute (a number, or
 * one a component); `times`, instants in the order of the run at which y is wanted; `watch`, with `values(t, y)`, `directions` (-1 where
 * a fall through zero ends the run, 1 where a rise does, 0 for both) and `divides` (whether f divides by the value); `keep(y, weight)`, which
 * moves a state in place to where it is to be after each step and says whether it could, `weight(i)` being the error of component i that a
 * step may have; `limit`, the most steps.
 *
 * Returns { t, y, end: { t, y }, stop: { kind, at }, steps, rejected, evaluations }: y has a row for each of the `times` that were
 * reached, each kept by itself. The kind of stop is "end", "watched" (with the place `at` of what ended it), "steps" (too many), "short" (the
 * step fell below rounding), "adrift" (a state could not be kept) or "undefined" (f has no value where a step begins).
 *
 * What changes its sign twice within one step is not seen.
 */
export function integrate(f, [t0, t1], y0, options = {}) {
  const { times = [], watch = null, keep = null, limit = 100000 } = options;
  const step = new Step(f, y0, { rtol: options.rtol ?? 1e-9, atol: options.atol ?? 1e-9 });
  const forth = Math.sign(t1 - t0) || 1;
  const out = { t: [], y: [], steps: 0, rejected: 0 };
  // A value that cannot be kept is as the step has it.
  const kept = (y) => {
    const moved = Float64Array.from(y);
    return keep && step.moved(keep, moved) ? moved : y;
  };
  const show = (end, at) => {
    while (out.t.length < times.length && forth * (times[out.t.length] - end) <= 0) {
      const t = times[out.t.length];
      out.t.push(t);
      out.y.push(kept(at(t)));
    }
  };
  const done = (stop, t, y) => ({ ...out, end: { t, y: Float64Array.from(y) }, stop, evaluations: step.evaluations });
  const defined = step.begin(t0);
  show(t0, () => Float64Array.from(y0));
  if (!defined) return done({ kind: 'undefined' }, t0, y0);
  if (t0 === t1) return done({ kind: 'end' }, t0, y0);
  const guard = new Guard(step, watch);
  let size = step.first(t1 - t0);
  let failed = false;
  for (;;) {
    if (out.steps + out.rejected >= limit) return done({ kind: 'steps' }, step.t, step.y);
    // The last step is stretched or shortened a little to end where the run does.
    const last = 1.01 * size >= Math.abs(t1 - step.t);
    const error = step.attempt(last ? t1 : step.t + forth * size);
    const length = Math.abs(step.t1 - step.t);
    if (!(error <= 1)) {
      if (length <= shortest(step.t)) return done({ kind: 'short' }, step.t, step.y);
      out.rejected += 1;
      failed = true;
      size = Math.max(Number.isNaN(error) ? 0.5 * length : length * Math.max(SHRINK, SAFETY * error ** -0.125), shortest(step.t));
      continue;
    }
    out.steps += 1;
    const { t } = step;
    const inside = (when) => step.inside((when - t) / (step.t1 - t), new Float64Array(step.n));
    const zero = guard.zero();
    if (zero) {
      const end = t + zero.part * (step.t1 - t);
      show(end, inside);
      return done({ kind: 'watched', at: zero.at }, end, kept(step.inside(zero.part, new Float64Array(step.n))));
    }
    show(step.t1, (when) => (when === step.t1 ? Float64Array.from(step.end) : inside(when)));
    const next = length * Math.min(GROW, Math.max(SHRINK, SAFETY * error ** -0.125));
    size = failed ? Math.min(next, length) : next;
    failed = false;
    guard.accept();
    const hindrance = step.accept(keep);
    if (hindrance) return done({ kind: hindrance }, step.t, step.y);
    if (last) return done({ kind: 'end' }, step.t, step.y);
  }
}
