
/* FMI 3.0.1 for model exchange: what an importer calls. Value references count time, states, their
 * derivatives, inputs, outputs and parameters, one after the other. */
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

#ifdef _WIN32
#define API __declspec(dllexport)
#else
#define API __attribute__((visibility("default")))
#endif

enum { OK = 0, ERROR = 3, NX = ${name}_nx, NU = ${name}_nu, NY = ${name}_ny, NP = ${name}_np };
enum { AT_DX = 1 + NX, AT_U = AT_DX + NX, AT_Y = AT_U + NU, AT_P = AT_Y + NY, AT_END = AT_P + NP };

typedef struct {
    double t, x[NX + 1], u[NU + 1], p[NP + 1], kept[${count}];
} Model;

static void start_(Model *m) {
    memset(m, 0, sizeof *m);
    memcpy(m->x, ${name}_x0, NX * sizeof(double));
    memcpy(m->p, ${name}_p0, NP * sizeof(double));
    kept_(m->t, m->p, m->kept);
}

static void outputs_(const Model *m, double *y) {
    const double *u = m->u;
    double w[${room}];
    signals_(m->t, m->x, u, m->p, m->kept, w);
${outputs}}

/* Let blocks jump whose times have come; return whether any did. */
static bool jumped_(Model *m) {
    bool some = false;
#if ${jumps}
    const double *kept = m->kept;
    double after[${count}], z[NX];
    kept_(m->t, m->p, after);
${asked}    if (some) {
        jump_(m->t, m->x, m->u, m->p, after, z);
        memcpy(m->x, z, sizeof z);
    }
#endif
    kept_(m->t, m->p, m->kept);
    return some;
}

static double next_(const Model *m) {
    const double *p = m->p, *kept = m->kept;
    double next = INFINITY, at = 0.0;
${next}    (void)p; (void)kept; (void)at;
    return next;
}

API const char *fmi3GetVersion(void) { return "3.0"; }

API void *fmi3InstantiateModelExchange(const char *name, const char *token, const char *resources,
                                       bool visible, bool logging, void *environment, void *log) {
    Model *m = token && strcmp(token, "${token}") == 0 ? malloc(sizeof(Model)) : NULL;
    (void)name; (void)resources; (void)visible; (void)logging; (void)environment; (void)log;
    if (m) start_(m);
    return m;
}

API void fmi3FreeInstance(void *m) { free(m); }

API int fmi3Reset(void *m) { start_(m); return OK; }

API int fmi3EnterInitializationMode(void *instance, bool known, double tolerance, double begin,
                                    bool ends, double end) {
    Model *m = instance;
    (void)known; (void)tolerance; (void)ends; (void)end;
    m->t = begin;
    return OK;
}

API int fmi3ExitInitializationMode(void *instance) {
    Model *m = instance;
    kept_(m->t, m->p, m->kept);
#if ${jumps}
    ${name}_begin(m->t, m->x, m->u, m->p);
#endif
    return OK;
}

API int fmi3UpdateDiscreteStates(void *instance, bool *again, bool *ends, bool *nominals,
                                 bool *states, bool *defined, double *next) {
    Model *m = instance;
    *again = *ends = *nominals = false;
    *states = jumped_(m);
    *next = next_(m);
    *defined = *next < INFINITY;
    return OK;
}

API int fmi3SetTime(void *m, double t) { ((Model *)m)->t = t; return OK; }

API int fmi3SetContinuousStates(void *m, const double *x, size_t n) {
    if (n != NX) return ERROR;
    memcpy(((Model *)m)->x, x, NX * sizeof(double));
    return OK;
}

API int fmi3GetContinuousStates(void *m, double *x, size_t n) {
    if (n != NX) return ERROR;
    memcpy(x, ((Model *)m)->x, NX * sizeof(double));
    return OK;
}

API int fmi3GetContinuousStateDerivatives(void *instance, double *dx, size_t n) {
    const Model *m = instance;
    if (n != NX) return ERROR;
    if (NX) rates_(m->t, m->x, m->u, m->p, m->kept, dx);
    return OK;
}

API int fmi3GetNominalsOfContinuousStates(void *m, double *x, size_t n) {
    (void)m;
    for (size_t i = 0; i < n; i++) x[i] = 1.0;
    return OK;
}

API int fmi3GetNumberOfContinuousStates(void *m, size_t *n) { (void)m; *n = NX; return OK; }

API int fmi3GetNumberOfEventIndicators(void *m, size_t *n) { (void)m; *n = 0; return OK; }

API int fmi3GetEventIndicators(void *m, double *z, size_t n) {
    (void)m; (void)z;
    return n ? ERROR : OK;
}

API int fmi3CompletedIntegratorStep(void *m, bool last, bool *event, bool *ends) {
    (void)m; (void)last;
    *event = *ends = false;
    return OK;
}

API int fmi3GetFloat64(void *instance, const uint32_t *at, size_t n, double *values, size_t count) {
    const Model *m = instance;
    double dx[NX + 1] = {0}, y[NY + 1] = {0};
    bool rates = false, outputs = false;
    if (n != count) return ERROR;
    for (size_t i = 0; i < n; i++) {
        const uint32_t k = at[i];
        if (k >= AT_END) return ERROR;
        if (k >= AT_DX && k < AT_U && !rates) {
            rates_(m->t, m->x, m->u, m->p, m->kept, dx);
            rates = true;
        }
        if (k >= AT_Y && k < AT_P && !outputs) {
            outputs_(m, y);
            outputs = true;
        }
        values[i] = k == 0 ? m->t : k < AT_DX ? m->x[k - 1] : k < AT_U ? dx[k - AT_DX]
            : k < AT_Y ? m->u[k - AT_U] : k < AT_P ? y[k - AT_Y] : m->p[k - AT_P];
    }
    return OK;
}

API int fmi3SetFloat64(void *instance, const uint32_t *at, size_t n, const double *values,
                       size_t count) {
    Model *m = instance;
    if (n != count) return ERROR;
    for (size_t i = 0; i < n; i++) {
        const uint32_t k = at[i];
        if (k >= 1 && k < AT_DX) m->x[k - 1] = values[i];
        else if (k >= AT_U && k < AT_Y) m->u[k - AT_U] = values[i];
        else if (k >= AT_P && k < AT_END) m->p[k - AT_P] = values[i];
        else return ERROR;
    }
    return OK;
}

/* What has nothing to do here, and what is not offered. */
#define DONE(name) API int fmi3##name(void *m) { (void)m; return OK; }
#define NONE(name) API int fmi3##name(void *m) { (void)m; return ERROR; }
#define EACH(name) NONE(Get##name) NONE(Set##name)
DONE(SetDebugLogging) DONE(Terminate) DONE(EnterEventMode) DONE(EnterContinuousTimeMode)
NONE(EnterConfigurationMode) NONE(ExitConfigurationMode) NONE(EvaluateDiscreteStates)
EACH(Float32) EACH(Int8) EACH(UInt8) EACH(Int16) EACH(UInt16) EACH(Int32) EACH(UInt32) EACH(Int64)
EACH(UInt64) EACH(Boolean) EACH(String) EACH(Binary) EACH(Clock) EACH(FMUState)
EACH(IntervalDecimal) EACH(IntervalFraction) EACH(ShiftDecimal) EACH(ShiftFraction)
NONE(FreeFMUState) NONE(SerializedFMUStateSize) NONE(SerializeFMUState) NONE(DeserializeFMUState)
NONE(GetNumberOfVariableDependencies) NONE(GetVariableDependencies)
NONE(GetDirectionalDerivative) NONE(GetAdjointDerivative) NONE(ActivateModelPartition)
NONE(EnterStepMode) NONE(GetOutputDerivatives) NONE(DoStep)
API void *fmi3InstantiateCoSimulation(void *m) { (void)m; return NULL; }
API void *fmi3InstantiateScheduledExecution(void *m) { (void)m; return NULL; }
