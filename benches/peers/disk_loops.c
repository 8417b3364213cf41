/* The disk by hand, in loops over arrays, as such code is usually written: a worker of run.py.
 *
 * No allocation; the length of the state is known to the compiler, the parameters are not.
 */
#include "disk.h"

/* The rates of the state: 41 operations, two sines and cosines.
 *
 * The moment about the vertical gives q1'', that about the axis of symmetry q3''. The moment about the contact line, with the
 * normal force from the vertical motion of the centre, gives q2''. The centre has no horizontal acceleration, so that the
 * contact point has minus that of the offset R sin q2 (-sin q1, cos q1) between them: `radial` along it, `across` at right
 * angles.
 */
static inline void rates(const Parameters *p, const double y[N], double out[N])
{
    double s1, c1, s2, c2;
    sincos(y[1], &s2, &c2);
    sincos(y[0], &s1, &c1);
    const double r1 = y[5], r2 = y[6], r3 = y[7];
    const double a1 = -2 * r2 * r3 / c2;
    const double a2 = (s2 * 4 * (p->g / p->R) + c2 * (r1 * (r1 * s2 + 2 * r3) - 4 * r2 * r2 * s2)) / (1 + 4 * s2 * s2);
    const double turn = s2 * a1, carry = c2 * r1 * r2;
    const double radial = p->R * (s2 * (r1 * r1 + r2 * r2) - c2 * a2);
    const double across = p->R * (turn + 2 * carry);
    for (int i = 0; i < 5; ++i)
        out[i] = y[5 + i];
    out[5] = a1;
    out[6] = a2;
    out[7] = -(turn + carry);
    out[8] = c1 * across - s1 * radial;
    out[9] = c1 * radial + s1 * across;
}

#define INLINE static inline __attribute__((always_inline))
#define EACH for (int i = 0; i < N; ++i)

/* The sum of weights[j] k[j] for j < count; what is zero in the table costs nothing, since the loop is unrolled. */
INLINE void combined(double sum[N], const double weights[STAGES], double k[STAGES][N], int count)
{
    EACH sum[i] = weights[0] * k[0][i];
#pragma GCC unroll 12
    for (int j = 1; j < count; ++j)
        if (weights[j] != 0)
            EACH sum[i] += weights[j] * k[j][i];
}

/* The square of the norm of x over the tolerances at the larger of two points. */
INLINE double squared(double tolerance, const double x[N], const double y[N], const double z[N])
{
    double sum = 0, quotient[N];
    EACH quotient[i] = x[i] / weight(tolerance, fmax(fabs(y[i]), fabs(z[i])));
    EACH sum += quotient[i] * quotient[i];
    return sum;
}

static double start_size(const Parameters *p, double tolerance, const double y[N], const double k1[N])
{
    double probe[N], f[N];
    const double ff = squared(tolerance, k1, y, y), guess = first_guess(squared(tolerance, y, y, y), ff);
    EACH probe[i] = y[i] + guess * k1[i];
    rates(p, probe, f);
    EACH f[i] -= k1[i];
    return first_step(guess, ff, squared(tolerance, f, y, y));
}

static Counts integrate(const Parameters *p, double tolerance, double end[N])
{
    Counts counts = {0, 2};
    double y[N], w[N], new[N], k[STAGES][N], slope[N], three[N], five[N];
    memcpy(y, START, sizeof y);
    rates(p, y, k[0]);
    double t = 0, h = start_size(p, tolerance, y, k[0]);
    for (int last = 0, rejected = 0; !last && counts.steps < 1000000 && !too_small(t, h); ++counts.steps) {
        if (t + 1.01 * h - SPAN > 0) {
            h = SPAN - t;
            last = 1;
        }
#pragma GCC unroll 12
        for (int stage = 1; stage < STAGES; ++stage) {
            combined(w, A[stage], k, stage);
            EACH w[i] = y[i] + h * w[i];
            rates(p, w, k[stage]);
        }
        combined(slope, A[STAGES], k, STAGES);
        combined(three, THIRD, k, STAGES);
        combined(five, FIFTH, k, STAGES);
        EACH new[i] = y[i] + h * slope[i];
        EACH three[i] = slope[i] - three[i];
        const double error = step_error(h, squared(tolerance, five, y, new), squared(tolerance, three, y, new));
        const double size = h;
        counts.evaluations += 11;
        if (judge(error, &rejected, &h)) {
            rates(p, new, k[0]);
            ++counts.evaluations;
            memcpy(y, new, sizeof y);
            t += size;
        } else {
            last = 0;
        }
    }
    memcpy(end, y, sizeof y);
    return counts;
}

static __attribute__((noinline)) void called_rates(const Parameters *p, const double y[N], double out[N])
{
    rates(p, y, out);
}

static double touch_rates(const Parameters *p, double carried)
{
    double y[N], f[N];
    EACH y[i] = START[i] + 1e-300 * carried;
    called_rates(p, y, f);
    return f[6] + f[8] + f[9];
}
