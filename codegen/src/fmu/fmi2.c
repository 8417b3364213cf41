// A mechanism as a Functional Mock-up Unit by FMI 2.0: model exchange and co-simulation. Source of the interface:
// Modelica Association, Functional Mock-up Interface for Model Exchange and Co-Simulation 2.0 (2014).
#include "fmu_core.h"

enum { LAST_SUCCESSFUL_TIME = 2, TERMINATED = 3 };

typedef struct {
  void (*logger)(void *environment, const char *name, Status status, const char *category, const char *message, ...);
  void *(*allocate)(size_t count, size_t size);
  void (*release)(void *memory);
  void (*step_finished)(void *environment, Status status);
  void *environment;
} Callbacks;

typedef struct {
  int need_update, terminate, nominals_changed, values_changed, next_defined;
  double next;
} EventInfo;

typedef struct {
  State state;
  Callbacks callbacks;
} Instance;

static Status fail(const Instance *instance, const char *message)
{
  if (instance && instance->callbacks.logger) {
    instance->callbacks.logger(instance->callbacks.environment, "unit", ERROR, "logStatusError", "%s", message);
  }
  return ERROR;
}

// Fails if there is a reason.
static Status unless(const Instance *instance, const char *reason)
{
  return reason ? fail(instance, reason) : OK;
}

EXPORT const char *fmi2GetTypesPlatform(void)
{
  return "default";
}

EXPORT const char *fmi2GetVersion(void)
{
  return "2.0";
}

EXPORT Status fmi2SetDebugLogging(void *instance, int on, size_t count, const char *const categories[])
{
  (void)instance;
  (void)on;
  (void)count;
  (void)categories;
  return OK;
}

EXPORT void *fmi2Instantiate(const char *name, int type, const char *token, const char *place, const Callbacks *callbacks,
                             int visible, int logging)
{
  Instance *instance;
  (void)type;
  (void)place;
  (void)visible;
  (void)logging;
  if (!token || strcmp(token, TOKEN) != 0) {
    if (callbacks && callbacks->logger) {
      callbacks->logger(callbacks->environment, name, ERROR, "logStatusError", "The GUID is that of another model.");
    }
    return NULL;
  }
  instance = (Instance *)calloc(1, sizeof(Instance));
  if (!instance) return NULL;
  if (callbacks) instance->callbacks = *callbacks;
  start(&instance->state);
  return instance;
}

EXPORT void fmi2FreeInstance(void *instance)
{
  free(instance);
}

EXPORT Status fmi2SetupExperiment(void *instance, int has_tolerance, double tolerance, double start_time, int has_stop,
                                  double stop)
{
  State *s = &((Instance *)instance)->state;
  s->time = start_time;
  if (has_tolerance && tolerance > 0) s->tolerance = tolerance;
  s->has_stop = has_stop != 0;
  s->stop = stop;
  return OK;
}

EXPORT Status fmi2EnterInitializationMode(void *instance)
{
  (void)instance;
  return OK;
}

EXPORT Status fmi2ExitInitializationMode(void *instance)
{
  State *s = &((Instance *)instance)->state;
  if (!project(s)) return fail((Instance *)instance, "The start does not fulfil the constraints of the mechanism.");
  note_signs(s);
  return OK;
}

EXPORT Status fmi2Terminate(void *instance)
{
  (void)instance;
  return OK;
}

EXPORT Status fmi2Reset(void *instance)
{
  start(&((Instance *)instance)->state);
  return OK;
}

EXPORT Status fmi2GetReal(void *instance, const Reference references[], size_t count, double values[])
{
  return unless((Instance *)instance, get_values(&((Instance *)instance)->state, references, count, values));
}

EXPORT Status fmi2SetReal(void *instance, const Reference references[], size_t count, const double values[])
{
  return unless((Instance *)instance, set_values(&((Instance *)instance)->state, references, count, values));
}

// No variable has another type than Real.
#define OTHER_TYPE(name, type)                                                                                        \
  EXPORT Status fmi2Get##name(void *instance, const Reference r[], size_t count, type values[])                        \
  {                                                                                                                    \
    (void)r;                                                                                                           \
    (void)values;                                                                                                      \
    return count == 0 ? OK : fail((Instance *)instance, "All variables are of the type Real.");                        \
  }                                                                                                                    \
  EXPORT Status fmi2Set##name(void *instance, const Reference r[], size_t count, const type values[])                  \
  {                                                                                                                    \
    (void)r;                                                                                                           \
    (void)values;                                                                                                      \
    return count == 0 ? OK : fail((Instance *)instance, "All variables are of the type Real.");                        \
  }

typedef const char *Text;
OTHER_TYPE(Integer, int)
OTHER_TYPE(Boolean, int)
OTHER_TYPE(String, Text)

EXPORT Status fmi2GetFMUstate(void *instance, void **state)
{
  return unless((Instance *)instance, store(&((Instance *)instance)->state, state));
}

EXPORT Status fmi2SetFMUstate(void *instance, void *state)
{
  memcpy(&((Instance *)instance)->state, state, sizeof(State));
  return OK;
}

EXPORT Status fmi2FreeFMUstate(void *instance, void **state)
{
  (void)instance;
  discard(state);
  return OK;
}

EXPORT Status fmi2SerializedFMUstateSize(void *instance, void *state, size_t *size)
{
  (void)instance;
  (void)state;
  *size = sizeof(State);
  return OK;
}

EXPORT Status fmi2SerializeFMUstate(void *instance, void *state, char bytes[], size_t size)
{
  return unless((Instance *)instance, write_bytes(state, bytes, size));
}

EXPORT Status fmi2DeSerializeFMUstate(void *instance, const char bytes[], size_t size, void **state)
{
  return unless((Instance *)instance, read_bytes(bytes, size, state));
}

EXPORT Status fmi2GetDirectionalDerivative(void *instance, const Reference unknowns[], size_t rows,
                                           const Reference knowns[], size_t columns, const double seed[],
                                           double sensitivity[])
{
  if (!products(&((Instance *)instance)->state, unknowns, rows, knowns, columns, seed, sensitivity, false)) {
    return fail((Instance *)instance, NO_SLOPES);
  }
  return OK;
}

EXPORT Status fmi2EnterEventMode(void *instance)
{
  (void)instance;
  return OK;
}

EXPORT Status fmi2NewDiscreteStates(void *instance, EventInfo *info)
{
  State *s = &((Instance *)instance)->state;
  memset(info, 0, sizeof *info);
  if (NCON > 0 && drift(s) > 0) {
    if (!project(s)) return fail((Instance *)instance, "The mechanism has left its constraints.");
    info->values_changed = 1;
  }
  info->terminate = s->has_signs && crossed(s, s->x, true);
  return OK;
}

EXPORT Status fmi2EnterContinuousTimeMode(void *instance)
{
  (void)instance;
  return OK;
}

EXPORT Status fmi2CompletedIntegratorStep(void *instance, int no_set_before, int *enter_event_mode, int *terminate)
{
  (void)no_set_before;
  *enter_event_mode = drift(&((Instance *)instance)->state) > DRIFT;
  *terminate = 0;
  return OK;
}

EXPORT Status fmi2SetTime(void *instance, double time)
{
  ((Instance *)instance)->state.time = time;
  return OK;
}

EXPORT Status fmi2SetContinuousStates(void *instance, const double states[], size_t count)
{
  if (count != NX) return fail((Instance *)instance, "The number of states is another.");
  memcpy(((Instance *)instance)->state.x, states, sizeof(double) * NX);
  return OK;
}

EXPORT Status fmi2GetDerivatives(void *instance, double out[], size_t count)
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

EXPORT Status fmi2GetEventIndicators(void *instance, double out[], size_t count)
{
  const State *s = &((Instance *)instance)->state;
  if (count != NIND) return fail((Instance *)instance, "The number of event indicators is another.");
  indicators(s, s->x, out);
  return OK;
}

EXPORT Status fmi2GetContinuousStates(void *instance, double out[], size_t count)
{
  if (count != NX) return fail((Instance *)instance, "The number of states is another.");
  memcpy(out, ((Instance *)instance)->state.x, sizeof(double) * NX);
  return OK;
}

EXPORT Status fmi2GetNominalsOfContinuousStates(void *instance, double out[], size_t count)
{
  size_t k;
  (void)instance;
  for (k = 0; k < count; k++) out[k] = 1;
  return OK;
}

EXPORT Status fmi2SetRealInputDerivatives(void *instance, const Reference r[], size_t count, const int orders[],
                                          const double values[])
{
  (void)r;
  (void)orders;
  (void)values;
  return count == 0 ? OK : fail((Instance *)instance, "Inputs have no derivatives.");
}

EXPORT Status fmi2GetRealOutputDerivatives(void *instance, const Reference r[], size_t count, const int orders[],
                                           double values[])
{
  (void)r;
  (void)orders;
  (void)values;
  return count == 0 ? OK : fail((Instance *)instance, "Outputs have no derivatives by the time.");
}

EXPORT Status fmi2DoStep(void *instance, double now, double size, int no_set_before)
{
  State *s = &((Instance *)instance)->state;
  (void)no_set_before;
  s->time = now;
  if (!advance(s, now + size)) {
    return fail((Instance *)instance, "No step is short enough: the equations are singular, or the constraints open.");
  }
  return s->has_ended ? DISCARD : OK;
}

EXPORT Status fmi2CancelStep(void *instance)
{
  return fail((Instance *)instance, "A step ends before it can be cancelled.");
}

EXPORT Status fmi2GetStatus(void *instance, int kind, Status *status)
{
  (void)instance;
  (void)kind;
  *status = OK;
  return DISCARD;
}

EXPORT Status fmi2GetRealStatus(void *instance, int kind, double *value)
{
  *value = ((Instance *)instance)->state.time;
  return kind == LAST_SUCCESSFUL_TIME ? OK : DISCARD;
}

EXPORT Status fmi2GetIntegerStatus(void *instance, int kind, int *value)
{
  (void)instance;
  (void)kind;
  *value = 0;
  return DISCARD;
}

EXPORT Status fmi2GetBooleanStatus(void *instance, int kind, int *value)
{
  *value = ((Instance *)instance)->state.has_ended;
  return kind == TERMINATED ? OK : DISCARD;
}

EXPORT Status fmi2GetStringStatus(void *instance, int kind, const char **value)
{
  (void)instance;
  (void)kind;
  *value = "";
  return DISCARD;
}
