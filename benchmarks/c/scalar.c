/* Runs one after the other: DOP853 with scipy's control, started again at each waypoint. */
#include <math.h>
#include <string.h>
#include <time.h>

#include "problem.h"

#ifdef BASIS_LANES
/* Eq. (5) for eight basis functions at a time, one after the other those that are left. */
#include "lane_math.h"

static inline v8 eight(const double *from) {
    v8 a;
    memcpy(&a, from, sizeof a);
    return a;
}

static inline void scalar_tides(int n, const double *restrict p, double t, double *restrict tide) {
    int k = 0;
    for (; k + LANES <= n; k += LANES) {
        v8 c = lane_cos(eight(p + 3 * n + k) * t + eight(p + 4 * n + k));
        memcpy(tide + k, &c, sizeof c);
    }
    for (; k < n; k++) tide[k] = cos(p[3 * n + k] * t + p[4 * n + k]);
}

static inline void scalar_basis(int n, const double *restrict p, double x1, double x2,
                                const double *restrict tide, double *restrict phi) {
    int k = 0;
    for (; k + LANES <= n; k += LANES) {
        v8 d1 = x1 - eight(p + k), d2 = x2 - eight(p + n + k);
        v8 d = lane_sqrt(d1 * d1 + d2 * d2);
        v8 e = lane_exp(d / (-2.0 * eight(p + 2 * n + k))) * eight(tide + k);
        memcpy(phi + k, &e, sizeof e);
    }
    for (; k < n; k++) {
        double d1 = x1 - p[k], d2 = x2 - p[n + k];
        phi[k] = exp(sqrt(d1 * d1 + d2 * d2) / (-2.0 * p[2 * n + k])) * tide[k];
    }
}
#endif
#define REAL double
#define FN(name) scalar_##name
#define EXP exp
#define COS cos
#define SQRT sqrt
#define ABSOLUTE fabs
#define MAXIMUM(a, b) ((a) > (b) ? (a) : (b))
#define MINIMUM(a, b) ((a) < (b) ? (a) : (b))
#include "closed_loop.h"
#include "dop853.h"

static double first_step(int n, double t, double edge, const double *y, const double *f,
                         const double *p, const double *zc, double rtol, double atol) {
    double d0, d1, span = edge - t;
    scalar_norms(n, y, f, rtol, atol, &d0, &d1);
    double h0 = d0 < 1e-5 || d1 < 1e-5 ? 1e-6 : 0.01 * d0 / d1;
    h0 = MINIMUM(h0, span);
    double d2 = scalar_curvature(n, t, h0, y, f, p, zc, rtol, atol);
    double h1 = d1 <= 1e-15 && d2 <= 1e-15 ? MAXIMUM(1e-6, h0 * 1e-3)
                                           : sqrt(sqrt(sqrt(0.01 / MAXIMUM(d1, d2))));
    return MINIMUM(MINIMUM(100 * h0, h1), span);
}

/* Integrate one run; `record` (may be null) receives the states at the first waypoint ends. */
static void run(const Problem *problem, const double *p, double *y, double *record, Counts *c) {
    const int n = N, m = STATES(n);
    const double rtol = problem->rtol, atol = problem->atol;
    double k[12][m], new[m], norm5, norm3, t = 0;
    for (int64_t interval = 0; t < problem->end; interval++) {
        int64_t at = interval % problem->waypoints;
        double zc[2] = {problem->w1[at], problem->w2[at]};
        double edge = MINIMUM((double)(interval + 1) * problem->dwell, problem->end);
        scalar_derivative(n, t, y, p, zc, k[0]);
        double h = first_step(n, t, edge, y, k[0], p, zc, rtol, atol);
        c->evaluations += 2;
        int rejected = 0;
        while (t < edge) {
            double least = 10 * (nextafter(t, INFINITY) - t);
            if (!rejected) h = MAXIMUM(h, least);
            if (!(h >= least)) {
                c->status = 1;
                return;
            }
            double next = MINIMUM(t + h, edge);
            h = next - t;
            scalar_attempt(n, t, h, y, p, zc, k, new, rtol, atol, &norm5, &norm3);
            c->evaluations += 11;
            double error = norm5 == 0 ? 0 : h * norm5 / sqrt((norm5 + 0.01 * norm3) * m);
            double factor = SAFETY / sqrt(sqrt(sqrt(error))); /* error^(-1/8) */
            if (error < 1) {
                factor = factor < MAX_FACTOR ? factor : MAX_FACTOR;
                h *= rejected ? MINIMUM(1, factor) : factor;
                t = next;
                memcpy(y, new, sizeof new);
                rejected = 0;
                c->steps++;
                if (t < edge) {
                    scalar_derivative(n, t, y, p, zc, k[0]);
                    c->evaluations++;
                }
            } else {
                h *= factor > MIN_FACTOR ? factor : MIN_FACTOR;
                rejected = 1;
                c->rejected++;
            }
        }
        if (record && interval < problem->recorded) memcpy(record + interval * m, y, sizeof new);
    }
}

/* Run every member; returns the seconds spent.  parameters (members, 9 n + 5) and states
 * (members, 2 n + 8) row by row; states are overwritten with the final ones; `record` holds
 * the states of member 0 at the first waypoint ends. */
double scalar_members(const Problem *problem, int64_t members, const double *parameters,
                      double *states, double *record, Counts *counts) {
    struct timespec start, stop;
    int n = N;
    clock_gettime(CLOCK_MONOTONIC, &start);
    for (int64_t j = 0; j < members; j++)
        run(problem, parameters + j * PARAMETERS(n), states + j * STATES(n), j ? 0 : record,
            counts);
    clock_gettime(CLOCK_MONOTONIC, &stop);
    return (double)(stop.tv_sec - start.tv_sec) + 1e-9 * (double)(stop.tv_nsec - start.tv_nsec);
}
