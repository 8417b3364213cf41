// A mechanism as a Functional Mock-up Unit by FMI 3.0: model exchange and co-simulation. Source of the interface:
// Modelica Association, Functional Mock-up Interface Specification 3.0 (2022).
#include "fmu_core.h"

typedef void (*Log)(void *environment, Status status, const char *category, const char *message);

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

// Fails if there is a reason.
static Status unless(const Instance *instance, const char *reason)
{
  return reason ? fail(instance, reason) : OK;
}

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
  if (length != count) return fail((Instance *)instance, "Every variable has one value.");
  return unless((Instance *)instance, get_values(&((Instance *)instance)->state, references, count, values));
}

EXPORT Status fmi3SetFloat64(void *instance, const Reference references[], size_t count, const double values[],
                             size_t length)
{
  if (length != count) return fail((Instance *)instance, "Every variable has one value.");
  return unless((Instance *)instance, set_values(&((Instance *)instance)->state, references, count, values));
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
  return unless((Instance *)instance, store(&((Instance *)instance)->state, state));
}

EXPORT Status fmi3SetFMUState(void *instance, void *state)
{
  memcpy(&((Instance *)instance)->state, state, sizeof(State));
  return OK;
}

EXPORT Status fmi3FreeFMUState(void *instance, void **state)
{
  (void)instance;
  discard(state);
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
  return unless((Instance *)instance, write_bytes(state, bytes, size));
}

EXPORT Status fmi3DeserializeFMUState(void *instance, const uint8_t bytes[], size_t size, void **state)
{
  return unless((Instance *)instance, read_bytes(bytes, size, state));
}

EXPORT Status fmi3GetDirectionalDerivative(void *instance, const Reference unknowns[], size_t rows,
                                           const Reference knowns[], size_t columns, const double seed[], size_t n_seed,
                                           double sensitivity[], size_t n_sensitivity)
{
  if (n_seed != columns || n_sensitivity != rows) return fail((Instance *)instance, "Lengths do not fit.");
  if (!products(&((Instance *)instance)->state, unknowns, rows, knowns, columns, seed, sensitivity, false)) {
    return fail((Instance *)instance, NO_SLOPES);
  }
  return OK;
}

EXPORT Status fmi3GetAdjointDerivative(void *instance, const Reference unknowns[], size_t rows, const Reference knowns[],
                                       size_t columns, const double seed[], size_t n_seed, double sensitivity[],
                                       size_t n_sensitivity)
{
  if (n_seed != rows || n_sensitivity != columns) return fail((Instance *)instance, "Lengths do not fit.");
  if (!products(&((Instance *)instance)->state, unknowns, rows, knowns, columns, seed, sensitivity, true)) {
    return fail((Instance *)instance, NO_SLOPES);
  }
  return OK;
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
