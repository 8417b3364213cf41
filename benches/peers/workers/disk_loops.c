/* The disk by hand, in loops over arrays, as such code is usually written: a worker of run.py.
 *
 * No allocation; the length of the state is known to the compiler, the parameters are not.
 */
#include "disk.h"

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
    disk_rates(p, probe, f);
    EACH f[i] -= k1[i];
    return first_step(guess, ff, squared(tolerance, f, y, y));
}

static Counts integrate(const Parameters *p, double tolerance, const double start[N], double end[N])
{
    Counts counts = {0, 2};
    double y[N], w[N], new[N], k[STAGES][N], slope[N], three[N], five[N];
    memcpy(y, start, sizeof y);
    disk_rates(p, y, k[0]);
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
            disk_rates(p, w, k[stage]);
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
            disk_rates(p, new, k[0]);
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
