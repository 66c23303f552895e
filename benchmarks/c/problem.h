/* What a run shares with every other run, and what it leaves. */
#ifndef PROBLEM_H
#define PROBLEM_H
#include <stdint.h>

typedef struct {
    int64_t waypoints, recorded; /* waypoints; states to record */
    double dwell, end, rtol, atol;
    const double *w1, *w2; /* waypoints */
} Problem;

typedef struct {
    int64_t steps, rejected, evaluations, status; /* status 1: a step became too small */
} Counts;

enum { MAX_FACTOR = 10 };
#define SAFETY 0.9
#define MIN_FACTOR 0.2

#define PARAMETERS(n) (9 * (n) + 5)

#endif
