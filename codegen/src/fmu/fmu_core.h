// The work of a mechanism as a Functional Mock-up Unit: its state, its equations, its events and a stepper. The sources
// of the interfaces include this file; fmu_model.h describes the mechanism.
#ifndef FMU_CORE_H
#define FMU_CORE_H

#include "fmu_model.h"
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

#if defined(_WIN32)
#define EXPORT __declspec(dllexport)
#elif defined(__GNUC__)
#define EXPORT __attribute__((visibility("default")))
#else
#define EXPORT
#endif

typedef enum { OK, WARNING, DISCARD, ERROR, FATAL } Status;
typedef uint32_t Reference;

// Value references: the time, the parameters, the states, their derivatives, the outputs, the event indicators.
enum {
  NX = NQ + NU,
  NIND = NDIV + NCOND + NEVENT,
  FIRST_P = 1,
  FIRST_X = FIRST_P + NP,
  FIRST_DER = FIRST_X + NX,
  FIRST_OUT = FIRST_DER + NX,
  FIRST_IND = FIRST_OUT + NOUT,
  END = FIRST_IND + NIND
};

// Everything that changes during a simulation.
typedef struct {
  double time, tolerance, step, stop;
  double p[NP + 1], x[NX + 1];
  // Signs of the event indicators at the last event.
  signed char sign[NIND + 1];
  bool has_signs, has_stop, has_ended;
} State;

static bool is_finite(double x)
{
  return x - x == 0;
}

static void derivatives(const State *s, const double *x, double *out)
{
  F(derivative)(s->p, x, x + NQ, out, out + NQ);
}

static void outputs(const State *s, double *out)
{
#if HAS_OUTPUTS
  F(outputs)(s->p, s->x, s->x + NQ, out);
#else
  (void)s;
  (void)out;
#endif
}

static void indicators(const State *s, const double *x, double *out)
{
#if HAS_DIVISORS
  F(divisors)(s->p, x, x + NQ, out);
#endif
#if HAS_CONDITIONS
  F(conditions)(s->p, x, x + NQ, out + NDIV);
#endif
#if HAS_EVENTS
  F(events)(s->p, x, x + NQ, out + NDIV + NCOND);
#endif
  (void)s;
  (void)x;
  (void)out;
}

static signed char sign_of(double x)
{
  return (signed char)((x > 0) - (x < 0));
}

static void note_signs(State *s)
{
  double values[NIND + 1];
  int k;
  indicators(s, s->x, values);
  for (k = 0; k < NIND; k++) s->sign[k] = sign_of(values[k]);
  s->has_signs = true;
}

// Whether an indicator crossed zero such that the simulation ends; events that do not end it are noted.
static bool crossed(State *s, const double *x, bool note)
{
  double values[NIND + 1];
  bool ends = false;
  int k;
  indicators(s, x, values);
  for (k = 0; k < NIND; k++) {
    const signed char now = sign_of(values[k]);
    if (now == s->sign[k]) continue;
    if (k < NDIV) {
      if (now * s->sign[k] < 0) ends = true;
    } else if (k < NDIV + NCOND) {
      if (now < 0) ends = true;
    } else {
      const int event = k - NDIV - NCOND;
      const int way = now - s->sign[k];
      const bool counts = s->sign[k] != 0 && (event_direction[event] == 0 || way * event_direction[event] > 0);
      if (counts && event_is_terminal[event]) ends = true;
      if (note) s->sign[k] = now;
    }
  }
  return ends;
}

// Moves the state onto the constraints; true if they hold then.
static bool project(State *s)
{
#if NCON > 0
  return F(project)(s->p, s->x, s->x + NQ) == 0;
#else
  (void)s;
  return true;
#endif
}

// Largest residual of the constraints.
static double drift(const State *s)
{
  double most = 0;
#if NCON > 0
  double residuals[NCON];
  int k;
  F(constraints)(s->p, s->x, s->x + NQ, residuals);
  for (k = 0; k < NCON; k++) {
    const double size = fabs(residuals[k]);
    if (!(size <= most)) most = size;
  }
#else
  (void)s;
#endif
  return most;
}

// One step of Dormand and Prince's pair of orders 5 and 4 (J. Comput. Appl. Math. 6, 1980, 19-26). Returns the size of
// its error over the tolerance.
static double try_step(const State *s, double h, double *next)
{
  static const double a[7][6] = {
    {0},
    {1.0 / 5},
    {3.0 / 40, 9.0 / 40},
    {44.0 / 45, -56.0 / 15, 32.0 / 9},
    {19372.0 / 6561, -25360.0 / 2187, 64448.0 / 6561, -212.0 / 729},
    {9017.0 / 3168, -355.0 / 33, 46732.0 / 5247, 49.0 / 176, -5103.0 / 18656},
    {35.0 / 384, 0, 500.0 / 1113, 125.0 / 192, -2187.0 / 6784, 11.0 / 84}};
  static const double e[7] = {71.0 / 57600,       0,          -71.0 / 16695, 71.0 / 1920,
                              -17253.0 / 339200, 22.0 / 525, -1.0 / 40};
  double k[7][NX + 1], most = 0;
  int stage, j, i;
  for (stage = 0; stage < 7; stage++) {
    for (i = 0; i < NX; i++) {
      double sum = 0;
      for (j = 0; j < stage; j++) sum += a[stage][j] * k[j][i];
      next[i] = s->x[i] + h * sum;
    }
    derivatives(s, next, k[stage]);
  }
  for (i = 0; i < NX; i++) {
    double error = 0, size;
    for (j = 0; j < 7; j++) error += e[j] * k[j][i];
    size = fabs(h * error) / (s->tolerance * (1 + fmax(fabs(s->x[i]), fabs(next[i]))));
    if (!is_finite(next[i])) return HUGE_VAL;
    if (!(size <= most)) most = size;
  }
  return most;
}

// Moves the state to an instant, or to an event before it; false if no step succeeds.
static bool advance(State *s, double end)
{
  double next[NX + 1];
  while (s->time < end && !s->has_ended) {
    double h = s->step > 0 ? s->step : 1e-3 * (end - s->time), error;
    const double left = end - s->time;
    const bool is_last = h >= left * (1 - 1e-12);
    if (is_last) h = left;
    error = try_step(s, h, next);
    if (!(error <= 1)) {
      s->step = h * (error < HUGE_VAL ? fmax(0.2, 0.9 * pow(error, -0.2)) : 0.1);
      if (!(s->step > 1e-14 * (1 + fabs(s->time)))) return false;
      continue;
    }
    if (crossed(s, next, false)) {
      // The step is shortened until it ends just before the event.
      double before = 0, after = h;
      int count;
      for (count = 0; count < 60 && after - before > 1e-13 * (1 + fabs(s->time)); count++) {
        const double middle = 0.5 * (before + after);
        try_step(s, middle, next);
        if (crossed(s, next, false)) after = middle;
        else before = middle;
      }
      try_step(s, before, next);
      h = before;
      s->has_ended = true;
    }
    memcpy(s->x, next, sizeof(double) * NX);
    s->time = is_last && !s->has_ended ? end : s->time + h;
    if (!is_last || error > 0.1) s->step = h * fmin(5, 0.9 * pow(fmax(error, 1e-10), -0.2));
    if (NCON > 0 && !project(s)) return false;
    crossed(s, s->x, true);
  }
  return true;
}

static void start(State *s)
{
  memset(s, 0, sizeof *s);
  memcpy(s->p, start_p, sizeof(double) * NP);
  memcpy(s->x, start_x, sizeof(double) * NX);
  s->time = START_TIME;
  s->tolerance = TOLERANCE;
}

static bool get(const State *s, Reference reference, double *value)
{
  double values[(NX > NOUT ? NX : NOUT) + NIND + 1];
  if (reference == 0) {
    *value = s->time;
  } else if (reference < FIRST_X) {
    *value = s->p[reference - FIRST_P];
  } else if (reference < FIRST_DER) {
    *value = s->x[reference - FIRST_X];
  } else if (reference < FIRST_OUT) {
    derivatives(s, s->x, values);
    *value = values[reference - FIRST_DER];
  } else if (reference < FIRST_IND) {
    outputs(s, values);
    *value = values[reference - FIRST_OUT];
  } else if (reference < END) {
    indicators(s, s->x, values);
    *value = values[reference - FIRST_IND];
  } else {
    return false;
  }
  return true;
}

static bool set(State *s, Reference reference, double value)
{
  if (reference >= FIRST_P && reference < FIRST_X) s->p[reference - FIRST_P] = value;
  else if (reference >= FIRST_X && reference < FIRST_DER) s->x[reference - FIRST_X] = value;
  else return false;
  return true;
}

// Slope of an unknown along a known variable.
#if HAS_SLOPES
typedef struct {
  double of_state[NX * NX + 1], of_parameters[NX * NP + 1], of_outputs[NOUT * (NX + NP) + 1];
} Slopes;

static void find_slopes(const State *s, Slopes *slopes)
{
  F(jacobian)(s->p, s->x, s->x + NQ, slopes->of_state);
#if NP > 0
  F(parameter_jacobian)(s->p, s->x, s->x + NQ, slopes->of_parameters);
#endif
#if HAS_OUTPUTS
  F(output_jacobian)(s->p, s->x, s->x + NQ, slopes->of_outputs);
#endif
}

static bool slope(const Slopes *slopes, Reference unknown, Reference known, double *value)
{
  int column;
  if (known >= FIRST_X && known < FIRST_DER) column = (int)(known - FIRST_X);
  else if (known >= FIRST_P && known < FIRST_X) column = NX + (int)(known - FIRST_P);
  else return false;
  if (unknown >= FIRST_X && unknown < FIRST_DER) {
    *value = unknown == known;
  } else if (unknown >= FIRST_DER && unknown < FIRST_OUT) {
    const int row = (int)(unknown - FIRST_DER);
    *value = column < NX ? slopes->of_state[row * NX + column] : slopes->of_parameters[row * NP + column - NX];
  } else if (unknown >= FIRST_OUT && unknown < FIRST_IND) {
    *value = slopes->of_outputs[(int)(unknown - FIRST_OUT) * (NX + NP) + column];
  } else {
    return false;
  }
  return true;
}
#endif

#define NO_SLOPES "These variables have no slopes."

// Products of the slopes with a seed: `unknowns` by `knowns`, or transposed. False if there are no such slopes.
static bool products(const State *s, const Reference unknowns[], size_t rows, const Reference knowns[], size_t columns,
                     const double seed[], double result[], bool transposed)
{
#if HAS_SLOPES
  Slopes *slopes = (Slopes *)malloc(sizeof(Slopes));
  size_t i, j;
  bool is_known = slopes != NULL;
  if (!slopes) return false;
  find_slopes(s, slopes);
  for (i = 0; i < (transposed ? columns : rows); i++) result[i] = 0;
  for (i = 0; i < rows && is_known; i++) {
    for (j = 0; j < columns && is_known; j++) {
      double value = 0;
      is_known = slope(slopes, unknowns[i], knowns[j], &value);
      if (transposed) result[j] += value * seed[i];
      else result[i] += value * seed[j];
    }
  }
  free(slopes);
  return is_known;
#else
  (void)s;
  (void)unknowns;
  (void)rows;
  (void)knowns;
  (void)columns;
  (void)seed;
  (void)result;
  (void)transposed;
  return false;
#endif
}

// What both versions of the interface do with variables and stored states. Each function returns NULL, or the reason
// why it failed.
static const char *get_values(const State *s, const Reference references[], size_t count, double values[])
{
  size_t k;
  for (k = 0; k < count; k++) {
    if (!get(s, references[k], &values[k])) return "There is no variable with this value reference.";
  }
  return NULL;
}

static const char *set_values(State *s, const Reference references[], size_t count, const double values[])
{
  size_t k;
  for (k = 0; k < count; k++) {
    if (!set(s, references[k], values[k])) return "Only parameters, inputs and states can be set.";
  }
  return NULL;
}

// Copies a state into the memory of a stored one, which is made if there is none.
static const char *store(const void *state, void **stored)
{
  if (!*stored) *stored = malloc(sizeof(State));
  if (!*stored) return "There is no memory for a state.";
  memcpy(*stored, state, sizeof(State));
  return NULL;
}

static void discard(void **stored)
{
  if (!stored) return;
  free(*stored);
  *stored = NULL;
}

static const char *write_bytes(const void *stored, void *bytes, size_t size)
{
  if (size < sizeof(State)) return "The state needs more bytes.";
  memcpy(bytes, stored, sizeof(State));
  return NULL;
}

static const char *read_bytes(const void *bytes, size_t size, void **stored)
{
  return size == sizeof(State) ? store(bytes, stored) : "The bytes are not a state of this model.";
}

#endif
