/* The disk in closed form, as a person derives it. */
#include <math.h>

typedef struct {
    double R, g;
} Parameters;

/* The rates of the state: 41 operations, two sines and cosines.
 *
 * The moment about the vertical gives q1'', that about the axis of symmetry q3''. The moment about the contact line, with the
 * normal force from the vertical motion of the centre, gives q2''. The centre has no horizontal acceleration, so that the
 * contact point has minus that of the offset R sin q2 (-sin q1, cos q1) between them: `radial` along it, `across` at right
 * angles.
 */
static inline void disk_rates(const Parameters *p, const double y[10], double out[10])
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
