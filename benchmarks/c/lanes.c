/* Eight runs at once: each lane has its own time, step and run; a finished lane takes the next. */
#include <math.h>
#include <string.h>
#include <time.h>

#include "lane_math.h"
#include "problem.h"

#define REAL v8
#define FN(name) lane_##name##_of
#define EXP lane_exp
#define COS lane_cos
#define SQRT lane_sqrt
#define ABSOLUTE lane_abs
#define MAXIMUM lane_max
#include "closed_loop.h"
#include "dop853.h"

static inline v8 eighth_root(v8 a) { return lane_sqrt(lane_sqrt(lane_sqrt(a))); }

static inline int any(m8 mask) {
    int64_t found = 0;
    for (int l = 0; l < LANES; l++) found |= mask[l];
    return found != 0;
}

static v8 first_step(int n, v8 t, v8 edge, const v8 *y, const v8 *f, const v8 *p, const v8 *zc,
                     double rtol, double atol) {
    v8 d0, d1, span = edge - t, zero = {0};
    lane_norms_of(n, y, f, rtol, atol, &d0, &d1);
    v8 h0 = lane_where((d0 < 1e-5) | (d1 < 1e-5), zero + 1e-6, 0.01 * d0 / d1);
    h0 = lane_min(h0, span);
    v8 d2 = lane_curvature_of(n, t, h0, y, f, p, zc, rtol, atol);
    v8 h1 = lane_where((d1 <= 1e-15) & (d2 <= 1e-15), lane_max(zero + 1e-6, h0 * 1e-3),
                       eighth_root(0.01 / lane_max(d1, d2)));
    return lane_min(lane_min(100.0 * h0, h1), span);
}

/* See scalar_members; nothing is recorded on the way. */
double lanes_members(const Problem *problem, int64_t members, const double *parameters,
                     double *states, double *record, Counts *counts) {
    const int n = N, m = STATES(n), np = PARAMETERS(n);
    const double rtol = problem->rtol, atol = problem->atol;
    v8 p[np], y[m], k[12][m], new[m], zc[2], f[m], zero = {0};
    v8 t = {0}, h = {0}, edge = {0}, norm5, norm3;
    m8 active = {0}, fresh = {0}, rejected = {0};
    int64_t member[LANES], interval[LANES], taken = 0;
    struct timespec start, stop;
    clock_gettime(CLOCK_MONOTONIC, &start);
    (void)record;
    memset(y, 0, sizeof y);
    memset(k, 0, sizeof k);
    memset(zc, 0, sizeof zc);
    for (int i = 0; i < np; i++) p[i] = zero + 1.0;
    m8 ended = ~active;
    for (;;) {
        /* Lanes at the end of an interval go on to the next, or take the next run. */
        for (int l = 0; any(ended) && l < LANES; l++) {
            if (!ended[l]) continue;
            if (active[l] && t[l] < problem->end) {
                interval[l]++;
            } else {
                if (active[l])
                    for (int i = 0; i < m; i++) states[member[l] * m + i] = y[i][l];
                active[l] = taken < members ? -1 : 0;
                if (!active[l]) continue;
                member[l] = taken++;
                interval[l] = 0;
                t[l] = 0;
                for (int i = 0; i < np; i++) p[i][l] = parameters[member[l] * np + i];
                for (int i = 0; i < m; i++) y[i][l] = states[member[l] * m + i];
            }
            double until = (double)(interval[l] + 1) * problem->dwell;
            edge[l] = until < problem->end ? until : problem->end;
            zc[0][l] = problem->w1[interval[l] % problem->waypoints];
            zc[1][l] = problem->w2[interval[l] % problem->waypoints];
            fresh[l] = -1;
            rejected[l] = 0;
        }
        if (!any(active)) break;
        if (any(fresh)) {
            lane_derivative_of(n, t, y, p, zc, f);
            v8 first = first_step(n, t, edge, y, f, p, zc, rtol, atol);
            for (int i = 0; i < m; i++) k[0][i] = lane_where(fresh, f[i], k[0][i]);
            h = lane_where(fresh, first, h);
            fresh ^= fresh;
        }
        v8 least = lane_max(lane_abs(t) * 0x1p-49, zero + 1e-300);
        h = lane_where(~rejected, lane_max(h, least), h);
        v8 next = lane_min(t + h, edge);
        m8 stuck = active & ~(h >= least);
        h = next - t;
        lane_attempt_of(n, t, h, y, p, zc, k, new, rtol, atol, &norm5, &norm3);
        v8 error = h * norm5 / lane_sqrt((norm5 + 0.01 * norm3) * (double)m);
        error = lane_where(norm5 == 0.0, zero, error);
        m8 accepted = active & (error < 1.0);
        v8 factor = SAFETY / eighth_root(error);
        v8 grown = lane_min(factor, zero + (double)MAX_FACTOR);
        grown = lane_where(rejected, lane_min(grown, zero + 1.0), grown);
        h = h * lane_where(accepted, grown, lane_max(factor, zero + MIN_FACTOR));
        t = lane_where(accepted, next, t);
        for (int i = 0; i < m; i++) y[i] = lane_where(accepted, new[i], y[i]);
        rejected = active & ~accepted;
        ended = (accepted & (t >= edge)) | stuck;
        if (any(stuck)) {
            counts->status = 1;
            t = lane_where(stuck, zero + problem->end, t);
        }
        if (any(accepted & ~ended)) {
            lane_derivative_of(n, t, y, p, zc, f);
            for (int i = 0; i < m; i++) k[0][i] = lane_where(accepted, f[i], k[0][i]);
        }
        for (int l = 0; l < LANES; l++) counts->steps -= accepted[l];
    }
    clock_gettime(CLOCK_MONOTONIC, &stop);
    return (double)(stop.tv_sec - start.tv_sec) + 1e-9 * (double)(stop.tv_nsec - start.tv_nsec);
}
