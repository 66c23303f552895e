/* Eq. (5) for eight basis functions at a time, one after the other those that are left. */
#include "lane_math.h"
#include <string.h>

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
