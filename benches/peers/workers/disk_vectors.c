/* The disk by hand, in vector types, as fast as a person can make it in C: a worker of run.py.
 *
 * The state is in vectors of four, four and two numbers, which are written as they are read: a wide load of what narrow stores
 * have just written costs almost as much as a sine. No allocation; the parameters are not known to the compiler.
 */
#include "disk.h"

typedef double Four __attribute__((vector_size(32)));
typedef double Two __attribute__((vector_size(16)));

/* q1 ... q4; their rates; q5 and its rate. Or the derivatives of all these. */
typedef struct {
    Four q, r;
    Two last;
} State;

static State packed(const double y[N])
{
    return (State){{y[0], y[1], y[2], y[3]}, {y[5], y[6], y[7], y[8]}, {y[4], y[9]}};
}

static void unpack(const State *s, double y[N])
{
    for (int i = 0; i < 4; ++i) {
        y[i] = s->q[i];
        y[5 + i] = s->r[i];
    }
    y[4] = s->last[0];
    y[9] = s->last[1];
}

/* The rates of the state, as in disk_loops.c. */
static inline State rates(const Parameters *p, const State *y)
{
    double s1, c1, s2, c2;
    sincos(y->q[1], &s2, &c2);
    sincos(y->q[0], &s1, &c1);
    const double r1 = y->r[0], r2 = y->r[1], r3 = y->r[2];
    const double a1 = -2 * r2 * r3 / c2;
    const double a2 = (s2 * 4 * (p->g / p->R) + c2 * (r1 * (r1 * s2 + 2 * r3) - 4 * r2 * r2 * s2)) / (1 + 4 * s2 * s2);
    const double turn = s2 * a1, carry = c2 * r1 * r2;
    const double radial = p->R * (s2 * (r1 * r1 + r2 * r2) - c2 * a2);
    const double across = p->R * (turn + 2 * carry);
    return (State){y->r,
                   {a1, a2, -(turn + carry), c1 * across - s1 * radial},
                   {y->last[1], c1 * radial + s1 * across}};
}

#define INLINE static inline __attribute__((always_inline))

INLINE State plus(State sum, double factor, const State *k)
{
    sum.q += factor * k->q;
    sum.r += factor * k->r;
    sum.last += factor * k->last;
    return sum;
}

/* The sum of weight[j] k[j] for j < count; what is zero in the table costs nothing, since the loop is unrolled. */
INLINE State combined(const double weight[STAGES], const State k[STAGES], int count)
{
    State sum = {{0}, {0}, {0}};
#pragma GCC unroll 12
    for (int j = 0; j < count; ++j)
        if (weight[j] != 0)
            sum = plus(sum, weight[j], &k[j]);
    return sum;
}

/* y + h (sum of A[row][j] k[j]): the newest derivative last and by itself, since all else is known before it. */
INLINE State advanced(const State *y, double h, const State k[STAGES], int row)
{
    const State before = combined(A[row], k, row - 1);
    return plus(plus(*y, h, &before), h * A[row][row - 1], &k[row - 1]);
}

static double dot(const State *x)
{
    const Four squares = x->q * x->q + x->r * x->r;
    const Two rest = x->last * x->last;
    return squares[0] + squares[1] + squares[2] + squares[3] + rest[0] + rest[1];
}

/* Each component over its tolerance at the larger of two points. */
INLINE State weighed(double tolerance, State x, const State *y, const State *z)
{
    for (int i = 0; i < 4; ++i) {
        x.q[i] /= weight(tolerance, fmax(fabs(y->q[i]), fabs(z->q[i])));
        x.r[i] /= weight(tolerance, fmax(fabs(y->r[i]), fabs(z->r[i])));
    }
    for (int i = 0; i < 2; ++i)
        x.last[i] /= weight(tolerance, fmax(fabs(y->last[i]), fabs(z->last[i])));
    return x;
}

static double start_size(const Parameters *p, double tolerance, const State *y, const State *k1)
{
    const State wy = weighed(tolerance, *y, y, y), wk = weighed(tolerance, *k1, y, y);
    const double ff = dot(&wk), guess = first_guess(dot(&wy), ff);
    const State probe = plus(*y, guess, k1);
    const State change = plus(rates(p, &probe), -1, k1);
    const State wc = weighed(tolerance, change, y, y);
    return first_step(guess, ff, dot(&wc));
}

static Counts integrate(const Parameters *p, double tolerance, const double start[N], double end[N])
{
    Counts counts = {0, 2};
    State y = packed(start), k[STAGES];
    k[0] = rates(p, &y);
    double t = 0, h = start_size(p, tolerance, &y, &k[0]);
    for (int last = 0, rejected = 0; !last && counts.steps < 1000000 && !too_small(t, h); ++counts.steps) {
        if (t + 1.01 * h - SPAN > 0) {
            h = SPAN - t;
            last = 1;
        }
#pragma GCC unroll 12
        for (int stage = 1; stage < STAGES; ++stage) {
            const State w = advanced(&y, h, k, stage);
            k[stage] = rates(p, &w);
        }
        const State slope = combined(A[STAGES], k, STAGES);
        const State new = plus(y, h, &slope);
        const State third = combined(THIRD, k, STAGES);
        const State three = weighed(tolerance, plus(slope, -1, &third), &y, &new);
        const State five = weighed(tolerance, combined(FIFTH, k, STAGES), &y, &new);
        const double error = step_error(h, dot(&five), dot(&three)), size = h;
        counts.evaluations += 11;
        if (judge(error, &rejected, &h)) {
            k[0] = rates(p, &new);
            ++counts.evaluations;
            y = new;
            t += size;
        } else {
            last = 0;
        }
    }
    unpack(&y, end);
    return counts;
}
