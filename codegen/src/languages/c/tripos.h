// Numbers and small linear systems for equations of motion in C99, also usable from C++.
//
// Numbers are doubles; with TRIPOS_FLOAT defined in every file they are floats. With GCC's -ffp-contract=off (and
// without -ffast-math) the values of doubles have the same bits as those of the Rust code from the same model, where
// angles are below 262144 rad in size.
#ifndef TRIPOS_H
#define TRIPOS_H

#include <math.h>
#include <stdint.h>
#include <string.h>

// C++ has no word `restrict`.
#ifdef __cplusplus
#define TRIPOS_RESTRICT
#else
#define TRIPOS_RESTRICT restrict
#endif

#ifdef TRIPOS_FLOAT
typedef float tripos_real;
#define TRIPOS_FUNCTION(name) name##f
#define TRIPOS_EPSILON 1.1920929e-7f
#else
typedef double tripos_real;
#define TRIPOS_FUNCTION(name) name
#define TRIPOS_EPSILON 2.220446049250313e-16
#endif

// A constant with a decimal point.
#define TRIPOS_C(constant) ((tripos_real)(constant))
#define TRIPOS_PI TRIPOS_C(3.141592653589793)

#define tripos_sqrt(x) TRIPOS_FUNCTION(sqrt)(x)
#define tripos_exp(x) TRIPOS_FUNCTION(exp)(x)
#define tripos_log(x) TRIPOS_FUNCTION(log)(x)
#define tripos_asin(x) TRIPOS_FUNCTION(asin)(x)
#define tripos_acos(x) TRIPOS_FUNCTION(acos)(x)
#define tripos_atan(x) TRIPOS_FUNCTION(atan)(x)
#define tripos_sinh(x) TRIPOS_FUNCTION(sinh)(x)
#define tripos_cosh(x) TRIPOS_FUNCTION(cosh)(x)
#define tripos_tanh(x) TRIPOS_FUNCTION(tanh)(x)
#define tripos_abs(x) TRIPOS_FUNCTION(fabs)(x)

// The sign of x: -1, 0 or 1.
static inline tripos_real tripos_sign(tripos_real x)
{
  return x != x ? x : (tripos_real)((x > 0) - (x < 0));
}

// The power of x by repeated multiplication; n may be negative.
static inline tripos_real tripos_power(tripos_real x, int n)
{
  tripos_real base = n < 0 ? 1 / x : x;
  tripos_real product = 1;
  unsigned left = n < 0 ? 0u - (unsigned)n : (unsigned)n;
  while (left > 0) {
    if (left & 1u) product = product * base;
    base = base * base;
    left >>= 1;
  }
  return product;
}

#ifdef TRIPOS_FLOAT

static inline void tripos_sincos(tripos_real x, tripos_real *sine, tripos_real *cosine)
{
  *sine = sinf(x);
  *cosine = cosf(x);
}

#else

// A series in z of the sine or the cosine of a reduced angle.
static inline double tripos_series(const double c[6], double z)
{
  const double low = z * (z * c[2] + c[1]) + c[0];
  const double high = z * (z * c[5] + c[4]) + c[3];
  return (z * (z * z)) * high + low;
}

// The sine and the cosine of x to 0.9 units in the last place. Reduction: W. J. Cody & W. Waite, Software Manual for
// the Elementary Functions (1980), chapter 8. Polynomials: those of FreeBSD's k_sin.c and k_cos.c (Sun Microsystems,
// 1993), evaluated in another order.
static inline void tripos_sincos(double x, double *sine, double *cosine)
{
  // Three parts of pi/2; products of the first two with whole numbers below 2^18 are exact.
  const double p1 = 1.5707963267923333, p2 = 2.5633441515839558e-12, p3 = 1.0562999066987428e-23;
  const double round = 6755399441055744.0;
  static const double s[6] = {-0.16666666666666632,   8.33333333332249e-3,    -1.984126982985795e-4,
                              2.7557313707070068e-6, -2.5050760253406863e-8, 1.58969099521155e-10};
  static const double c[6] = {4.16666666666666e-2,    -1.388888888887411e-3, 2.480158728947673e-5,
                              -2.7557314351390663e-7, 2.087572321298175e-9,  -1.1359647557788195e-11};
  double r = x, minus_tail = 0.0;
  uint64_t quadrant = 0;
  const double size = fabs(x);
  if (!(size <= 262144.0)) {
    *sine = sin(x);
    *cosine = cos(x);
    return;
  }
  if (size > 0.7853981633974483) {
    const double rounded = x * 0.6366197723675814 + round;
    const double n = rounded - round;
    const double a = n * -p1 + x;
    memcpy(&quadrant, &rounded, sizeof quadrant);
    r = n * -p2 + a;
    minus_tail = n * p3 + (n * p2 + (r - a));
  }
  {
    const double z = r * r, w = z * z;
    const double near_one = z * -0.5 + 1.0;
    const double of_sine = r - (minus_tail * near_one + (z * r) * -tripos_series(s, z));
    const double rounded_off = z * -0.5 + (1.0 - near_one);
    const double of_cosine = near_one + (w * tripos_series(c, z) + (minus_tail * r + rounded_off));
    const int swapped = (int)(quadrant & 1u);
    *sine = swapped ? of_cosine : of_sine;
    *cosine = swapped ? of_sine : of_cosine;
    if (quadrant & 2u) *sine = -*sine;
    if ((quadrant + 1u) & 2u) *cosine = -*cosine;
  }
}

#endif

static inline tripos_real tripos_sin(tripos_real x)
{
  tripos_real sine, cosine;
  tripos_sincos(x, &sine, &cosine);
  return sine;
}

static inline tripos_real tripos_cos(tripos_real x)
{
  tripos_real sine, cosine;
  tripos_sincos(x, &sine, &cosine);
  return cosine;
}

// Solves A x = b by Gaussian elimination with partial pivoting of scaled rows. `a` has n rows of n entries; it and `b`
// are overwritten. Returns 0, or 1 if A is singular, and then x is not a number.
static inline int tripos_solve(int n, tripos_real *TRIPOS_RESTRICT a, tripos_real *TRIPOS_RESTRICT b,
                               tripos_real *TRIPOS_RESTRICT x)
{
  int i, j, k, singular = 0;
  // Until the end, x has the sizes of the rows.
  for (i = 0; i < n; i++) {
    x[i] = 0;
    for (j = 0; j < n; j++) {
      const tripos_real size = tripos_abs(a[i * n + j]);
      if (!(size <= x[i])) x[i] = size;
    }
  }
  for (k = 0; k < n; k++) {
    int pivot = k;
    for (i = k + 1; i < n; i++) {
      if (tripos_abs(a[i * n + k]) * x[pivot] > tripos_abs(a[pivot * n + k]) * x[i]) pivot = i;
    }
    if (pivot != k) {
      tripos_real kept;
      for (j = 0; j < n; j++) {
        kept = a[k * n + j];
        a[k * n + j] = a[pivot * n + j];
        a[pivot * n + j] = kept;
      }
      kept = b[k];
      b[k] = b[pivot];
      b[pivot] = kept;
      kept = x[k];
      x[k] = x[pivot];
      x[pivot] = kept;
    }
    if (!(tripos_abs(a[k * n + k]) > 0)) singular = 1;
    for (i = k + 1; i < n; i++) {
      const tripos_real part = a[i * n + k] / a[k * n + k];
      for (j = k + 1; j < n; j++) a[i * n + j] -= part * a[k * n + j];
      b[i] -= part * b[k];
    }
  }
  for (i = n - 1; i >= 0; i--) {
    tripos_real rest = b[i];
    for (j = i + 1; j < n; j++) rest -= a[i * n + j] * x[j];
    x[i] = singular ? TRIPOS_C(NAN) : rest / a[i * n + i];
  }
  return singular;
}

// Functions of the constraints of a model: their residuals, or their slopes along q and then the motion variables.
typedef void (*tripos_constraints)(const tripos_real *p, const tripos_real *q, const tripos_real *v, tripos_real *out);

// Moves a state onto its constraints, by Newton's method with the smallest correction; constraints that follow from
// others are left out. There are m constraints, nq coordinates and nv motion variables; `work` has room for
// m * (nq + nv + 3) numbers. Returns 0 if all constraints hold up to rounding, else 1.
static inline int tripos_project(int m, int nq, int nv, tripos_constraints residuals, tripos_constraints slopes,
                                 const tripos_real *p, tripos_real *q, tripos_real *v, tripos_real *work)
{
  const int n = nq + nv;
  tripos_real *rows = work, *open = work + m * n, *sizes = open + m, *used = sizes + m;
  int step, i, j, k;
  for (step = 0; step < 30; step++) {
    tripos_real most = 0;
    int holds = 1;
    residuals(p, q, v, open);
    slopes(p, q, v, rows);
    for (k = 0; k < m; k++) {
      tripos_real terms = 0;
      sizes[k] = 0;
      used[k] = 0;
      for (j = 0; j < n; j++) {
        const tripos_real slope = rows[k * n + j];
        sizes[k] += slope * slope;
        terms += tripos_abs(slope) * (1 + tripos_abs(j < nq ? q[j] : v[j - nq]));
      }
      if (!(sizes[k] + tripos_abs(open[k]) < TRIPOS_C(HUGE_VAL))) return 1;
      if (!(tripos_abs(open[k]) <= 64 * TRIPOS_EPSILON * terms)) holds = 0;
    }
    for (k = 0; k < m; k++) {
      // Next the row of which, by its own length, most is left.
      int next = -1;
      tripos_real best = 0, length = 0, along;
      for (i = 0; i < m; i++) {
        tripos_real left = 0;
        if (used[i] > 0 || !(sizes[i] > 0)) continue;
        for (j = 0; j < n; j++) left += rows[i * n + j] * rows[i * n + j];
        if (left / sizes[i] > best) {
          next = i;
          best = left / sizes[i];
          length = left;
        }
      }
      if (next < 0 || !(best > TRIPOS_EPSILON)) break;
      used[next] = 1;
      along = open[next] / length;
      for (i = 0; i < m; i++) {
        tripos_real part = 0;
        if (used[i] > 0) continue;
        for (j = 0; j < n; j++) part += rows[i * n + j] * rows[next * n + j];
        part /= length;
        for (j = 0; j < n; j++) rows[i * n + j] -= part * rows[next * n + j];
        open[i] -= part * open[next];
      }
      for (j = 0; j < n; j++) {
        tripos_real *const x = j < nq ? &q[j] : &v[j - nq];
        const tripos_real correction = along * rows[next * n + j];
        const tripos_real share = tripos_abs(correction) / (1 + tripos_abs(*x));
        *x -= correction;
        if (!(share <= most)) most = share;
      }
    }
    if (most <= 16 * TRIPOS_EPSILON) return holds ? 0 : 1;
  }
  return 1;
}

#endif
