// A mechanism as a Functional Mock-up Unit by FMI 3.0: model exchange and co-simulation. fmu_model.h describes the
// mechanism. Source of the interface: Modelica Association, Functional Mock-up Interface Specification 3.0 (2022).
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
typedef void (*Log)(void *environment, Status status, const char *category, const char *message);

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

typedef struct {
  State state;
  void *environment;
  Log log;
  bool may_return_early;
} Instance;

static Status fail(const Instance *instance, const char *message)
{
  if (instance && instance->log) instance->log(instance->environment, ERROR, "logStatusError", message);
  return ERROR;
}

static bool is_finite(double x)
{
  return x - x == 0;
}

static void derivatives(const State *s, const double *x, double *out)
{
#if HAS_DERIVATIVE
  F(derivative)(s->p, x, x + NQ, out, out + NQ);
#else
  F(coordinate_rates)(s->p, x, x + NQ, out);
  F(accelerations)(s->p, x, x + NQ, out + NQ);
#endif
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

EXPORT const char *fmi3GetVersion(void)
{
  return "3.0";
}

EXPORT Status fmi3SetDebugLogging(void *instance, bool on, size_t count, const char *const categories[])
{
  (void)instance;
  (void)on;
  (void)count;
  (void)categories;
  return OK;
}

static void *instantiate(const char *token, void *environment, Log log)
{
  Instance *instance;
  if (!token || strcmp(token, TOKEN) != 0) {
    if (log) log(environment, ERROR, "logStatusError", "The instantiation token is that of another model.");
    return NULL;
  }
  instance = (Instance *)calloc(1, sizeof(Instance));
  if (!instance) return NULL;
  instance->environment = environment;
  instance->log = log;
  start(&instance->state);
  return instance;
}

EXPORT void *fmi3InstantiateModelExchange(const char *name, const char *token, const char *path, bool visible, bool logging,
                                          void *environment, Log log)
{
  (void)name;
  (void)path;
  (void)visible;
  (void)logging;
  return instantiate(token, environment, log);
}

EXPORT void *fmi3InstantiateCoSimulation(const char *name, const char *token, const char *path, bool visible, bool logging,
                                         bool event_mode, bool early_return, const Reference variables[], size_t count,
                                         void *environment, Log log, void (*update)(void))
{
  Instance *instance;
  (void)name;
  (void)path;
  (void)visible;
  (void)logging;
  (void)event_mode;
  (void)variables;
  (void)count;
  (void)update;
  instance = (Instance *)instantiate(token, environment, log);
  if (instance) instance->may_return_early = early_return;
  return instance;
}

EXPORT void *fmi3InstantiateScheduledExecution(const char *name, const char *token, const char *path, bool visible,
                                               bool logging, void *environment, Log log, void (*clock)(void),
                                               void (*lock)(void), void (*unlock)(void))
{
  (void)name;
  (void)token;
  (void)path;
  (void)visible;
  (void)logging;
  (void)clock;
  (void)lock;
  (void)unlock;
  if (log) log(environment, ERROR, "logStatusError", "Scheduled execution is not provided.");
  return NULL;
}

EXPORT void fmi3FreeInstance(void *instance)
{
  free(instance);
}

EXPORT Status fmi3EnterInitializationMode(void *instance, bool has_tolerance, double tolerance, double start_time,
                                          bool has_stop, double stop)
{
  State *s = &((Instance *)instance)->state;
  s->time = start_time;
  if (has_tolerance && tolerance > 0) s->tolerance = tolerance;
  s->has_stop = has_stop;
  s->stop = stop;
  return OK;
}

EXPORT Status fmi3ExitInitializationMode(void *instance)
{
  State *s = &((Instance *)instance)->state;
  if (!project(s)) return fail((Instance *)instance, "The start does not fulfil the constraints of the mechanism.");
  note_signs(s);
  return OK;
}

EXPORT Status fmi3EnterEventMode(void *instance)
{
  (void)instance;
  return OK;
}

EXPORT Status fmi3Terminate(void *instance)
{
  (void)instance;
  return OK;
}

EXPORT Status fmi3Reset(void *instance)
{
  start(&((Instance *)instance)->state);
  return OK;
}

EXPORT Status fmi3GetFloat64(void *instance, const Reference references[], size_t count, double values[], size_t length)
{
  size_t k;
  if (length != count) return fail((Instance *)instance, "Every variable has one value.");
  for (k = 0; k < count; k++) {
    if (!get(&((Instance *)instance)->state, references[k], &values[k])) {
      return fail((Instance *)instance, "There is no variable with this value reference.");
    }
  }
  return OK;
}

EXPORT Status fmi3SetFloat64(void *instance, const Reference references[], size_t count, const double values[],
                             size_t length)
{
  size_t k;
  if (length != count) return fail((Instance *)instance, "Every variable has one value.");
  for (k = 0; k < count; k++) {
    if (!set(&((Instance *)instance)->state, references[k], values[k])) {
      return fail((Instance *)instance, "Only parameters, inputs and states can be set.");
    }
  }
  return OK;
}

// No variable has another type than Float64.
#define OTHER_TYPE(name, type)                                                                                        \
  EXPORT Status fmi3Get##name(void *instance, const Reference r[], size_t count, type values[], size_t length)         \
  {                                                                                                                    \
    (void)r;                                                                                                           \
    (void)values;                                                                                                      \
    (void)length;                                                                                                      \
    return count == 0 ? OK : fail((Instance *)instance, "All variables are of the type Float64.");                     \
  }                                                                                                                    \
  EXPORT Status fmi3Set##name(void *instance, const Reference r[], size_t count, const type values[], size_t length)   \
  {                                                                                                                    \
    (void)r;                                                                                                           \
    (void)values;                                                                                                      \
    (void)length;                                                                                                      \
    return count == 0 ? OK : fail((Instance *)instance, "All variables are of the type Float64.");                     \
  }

typedef const char *Text;
OTHER_TYPE(Float32, float)
OTHER_TYPE(Int8, int8_t)
OTHER_TYPE(UInt8, uint8_t)
OTHER_TYPE(Int16, int16_t)
OTHER_TYPE(UInt16, uint16_t)
OTHER_TYPE(Int32, int32_t)
OTHER_TYPE(UInt32, uint32_t)
OTHER_TYPE(Int64, int64_t)
OTHER_TYPE(UInt64, uint64_t)
OTHER_TYPE(Boolean, bool)
OTHER_TYPE(String, Text)

// Functions for what the model does not have.
#define ABSENT(name, arguments)                                                                                       \
  EXPORT Status fmi3##name arguments                                                                                   \
  {                                                                                                                    \
    return fail((Instance *)instance, "The model has no binaries, clocks and partitions.");                            \
  }

#if defined(__GNUC__)
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wunused-parameter"
#endif
ABSENT(GetBinary, (void *instance, const Reference r[], size_t n, size_t sizes[], const uint8_t *values[], size_t m))
ABSENT(SetBinary, (void *instance, const Reference r[], size_t n, const size_t sizes[], const uint8_t *const values[], size_t m))
ABSENT(GetClock, (void *instance, const Reference r[], size_t n, bool values[]))
ABSENT(SetClock, (void *instance, const Reference r[], size_t n, const bool values[]))
ABSENT(GetIntervalDecimal, (void *instance, const Reference r[], size_t n, double intervals[], int qualifiers[]))
ABSENT(GetIntervalFraction, (void *instance, const Reference r[], size_t n, uint64_t c[], uint64_t d[], int qualifiers[]))
ABSENT(GetShiftDecimal, (void *instance, const Reference r[], size_t n, double shifts[]))
ABSENT(GetShiftFraction, (void *instance, const Reference r[], size_t n, uint64_t c[], uint64_t d[]))
ABSENT(SetIntervalDecimal, (void *instance, const Reference r[], size_t n, const double intervals[]))
ABSENT(SetIntervalFraction, (void *instance, const Reference r[], size_t n, const uint64_t c[], const uint64_t d[]))
ABSENT(SetShiftDecimal, (void *instance, const Reference r[], size_t n, const double shifts[]))
ABSENT(SetShiftFraction, (void *instance, const Reference r[], size_t n, const uint64_t c[], const uint64_t d[]))
ABSENT(ActivateModelPartition, (void *instance, Reference clock, double time))
ABSENT(GetNumberOfVariableDependencies, (void *instance, Reference r, size_t *count))
ABSENT(GetVariableDependencies, (void *instance, Reference r, size_t a[], Reference b[], size_t c[], int kinds[], size_t n))
ABSENT(GetOutputDerivatives, (void *instance, const Reference r[], size_t n, const int32_t orders[], double values[], size_t m))
#if defined(__GNUC__)
#pragma GCC diagnostic pop
#endif

EXPORT Status fmi3GetFMUState(void *instance, void **state)
{
  if (!*state) *state = malloc(sizeof(State));
  if (!*state) return fail((Instance *)instance, "There is no memory for a state.");
  memcpy(*state, &((Instance *)instance)->state, sizeof(State));
  return OK;
}

EXPORT Status fmi3SetFMUState(void *instance, void *state)
{
  memcpy(&((Instance *)instance)->state, state, sizeof(State));
  return OK;
}

EXPORT Status fmi3FreeFMUState(void *instance, void **state)
{
  (void)instance;
  if (state) {
    free(*state);
    *state = NULL;
  }
  return OK;
}

EXPORT Status fmi3SerializedFMUStateSize(void *instance, void *state, size_t *size)
{
  (void)instance;
  (void)state;
  *size = sizeof(State);
  return OK;
}

EXPORT Status fmi3SerializeFMUState(void *instance, void *state, uint8_t bytes[], size_t size)
{
  if (size < sizeof(State)) return fail((Instance *)instance, "The state needs more bytes.");
  memcpy(bytes, state, sizeof(State));
  return OK;
}

EXPORT Status fmi3DeserializeFMUState(void *instance, const uint8_t bytes[], size_t size, void **state)
{
  if (size != sizeof(State)) return fail((Instance *)instance, "The bytes are not a state of this model.");
  if (!*state) *state = malloc(sizeof(State));
  if (!*state) return fail((Instance *)instance, "There is no memory for a state.");
  memcpy(*state, bytes, sizeof(State));
  return OK;
}

// Products of the slopes with a seed: `unknowns` by `knowns`, or transposed.
static Status products(void *instance, const Reference unknowns[], size_t rows, const Reference knowns[], size_t columns,
                       const double seed[], double result[], bool transposed)
{
#if HAS_SLOPES
  Slopes *slopes = (Slopes *)malloc(sizeof(Slopes));
  size_t i, j;
  bool is_known = true;
  if (!slopes) return fail((Instance *)instance, "There is no memory for the slopes.");
  find_slopes(&((Instance *)instance)->state, slopes);
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
  return is_known ? OK : fail((Instance *)instance, "These variables have no slopes.");
#else
  (void)unknowns;
  (void)rows;
  (void)knowns;
  (void)columns;
  (void)seed;
  (void)result;
  (void)transposed;
  return fail((Instance *)instance, "The model has no slopes.");
#endif
}

EXPORT Status fmi3GetDirectionalDerivative(void *instance, const Reference unknowns[], size_t rows,
                                           const Reference knowns[], size_t columns, const double seed[], size_t n_seed,
                                           double sensitivity[], size_t n_sensitivity)
{
  if (n_seed != columns || n_sensitivity != rows) return fail((Instance *)instance, "Lengths do not fit.");
  return products(instance, unknowns, rows, knowns, columns, seed, sensitivity, false);
}

EXPORT Status fmi3GetAdjointDerivative(void *instance, const Reference unknowns[], size_t rows, const Reference knowns[],
                                       size_t columns, const double seed[], size_t n_seed, double sensitivity[],
                                       size_t n_sensitivity)
{
  if (n_seed != rows || n_sensitivity != columns) return fail((Instance *)instance, "Lengths do not fit.");
  return products(instance, unknowns, rows, knowns, columns, seed, sensitivity, true);
}

EXPORT Status fmi3EnterConfigurationMode(void *instance)
{
  (void)instance;
  return OK;
}

EXPORT Status fmi3ExitConfigurationMode(void *instance)
{
  (void)instance;
  return OK;
}

EXPORT Status fmi3EvaluateDiscreteStates(void *instance)
{
  (void)instance;
  return OK;
}

EXPORT Status fmi3UpdateDiscreteStates(void *instance, bool *need_update, bool *terminate, bool *nominals_changed,
                                       bool *values_changed, bool *next_defined, double *next)
{
  State *s = &((Instance *)instance)->state;
  *need_update = false;
  *nominals_changed = false;
  *values_changed = false;
  *next_defined = false;
  *next = 0;
  if (NCON > 0 && drift(s) > 0) {
    if (!project(s)) return fail((Instance *)instance, "The mechanism has left its constraints.");
    *values_changed = true;
  }
  *terminate = s->has_signs && crossed(s, s->x, true);
  return OK;
}

EXPORT Status fmi3EnterContinuousTimeMode(void *instance)
{
  (void)instance;
  return OK;
}

EXPORT Status fmi3CompletedIntegratorStep(void *instance, bool no_set_before, bool *enter_event_mode, bool *terminate)
{
  const State *s = &((Instance *)instance)->state;
  (void)no_set_before;
  *enter_event_mode = drift(s) > DRIFT;
  *terminate = false;
  return OK;
}

EXPORT Status fmi3SetTime(void *instance, double time)
{
  ((Instance *)instance)->state.time = time;
  return OK;
}

EXPORT Status fmi3SetContinuousStates(void *instance, const double states[], size_t count)
{
  if (count != NX) return fail((Instance *)instance, "The number of states is another.");
  memcpy(((Instance *)instance)->state.x, states, sizeof(double) * NX);
  return OK;
}

EXPORT Status fmi3GetContinuousStateDerivatives(void *instance, double out[], size_t count)
{
  const State *s = &((Instance *)instance)->state;
  size_t k;
  if (count != NX) return fail((Instance *)instance, "The number of states is another.");
  derivatives(s, s->x, out);
  for (k = 0; k < NX; k++) {
    if (!is_finite(out[k])) return DISCARD;
  }
  return OK;
}

EXPORT Status fmi3GetEventIndicators(void *instance, double out[], size_t count)
{
  const State *s = &((Instance *)instance)->state;
  if (count != NIND) return fail((Instance *)instance, "The number of event indicators is another.");
  indicators(s, s->x, out);
  return OK;
}

EXPORT Status fmi3GetContinuousStates(void *instance, double out[], size_t count)
{
  if (count != NX) return fail((Instance *)instance, "The number of states is another.");
  memcpy(out, ((Instance *)instance)->state.x, sizeof(double) * NX);
  return OK;
}

EXPORT Status fmi3GetNominalsOfContinuousStates(void *instance, double out[], size_t count)
{
  size_t k;
  (void)instance;
  for (k = 0; k < count; k++) out[k] = 1;
  return OK;
}

EXPORT Status fmi3GetNumberOfEventIndicators(void *instance, size_t *count)
{
  (void)instance;
  *count = NIND;
  return OK;
}

EXPORT Status fmi3GetNumberOfContinuousStates(void *instance, size_t *count)
{
  (void)instance;
  *count = NX;
  return OK;
}

EXPORT Status fmi3EnterStepMode(void *instance)
{
  (void)instance;
  return OK;
}

EXPORT Status fmi3DoStep(void *instance, double now, double size, bool no_set_before, bool *event_needed, bool *terminate,
                         bool *early_return, double *last)
{
  State *s = &((Instance *)instance)->state;
  bool advanced;
  (void)no_set_before;
  *event_needed = false;
  s->time = now;
  advanced = advance(s, now + size);
  *last = s->time;
  // A step that an event ends is shorter, which tools that allow no early return learn from the other two values.
  *terminate = s->has_ended;
  *early_return = ((Instance *)instance)->may_return_early && s->time < now + size;
  if (!advanced) return fail((Instance *)instance, "No step is short enough: the equations are singular, or the constraints open.");
  return OK;
}
