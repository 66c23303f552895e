/* One step of Dormand and Prince's method of order 8(5,3), for numbers or SIMD lanes.
 *
 * The coefficients are scipy's, written at build time to coefficients.h: DP_STAGE_s(i) is the
 * sum of row s of A over the stages k[.][i]; DP_B, DP_E3 and DP_E5 are the weighted sums.
 */
#include "coefficients.h"

#define STATES(n) (2 * (n) + 8)
#define STAGE(s)                                                        \
    for (int i = 0; i < m; i++) work[i] = y[i] + h * (DP_STAGE_##s(i)); \
    FN(derivative)(n, t + DP_C_##s * h, work, p, zc, k[s]);

/* From (t, y) with k[0] = f(t, y): write the new state; return the squared norms of the
 * estimates of order 5 and 3, weighted by atol + rtol max(|y|, |new|). */
static inline void FN(attempt)(int n, REAL t, REAL h, const REAL *restrict y,
                               const REAL *restrict p, const REAL *restrict zc,
                               REAL (*restrict k)[STATES(n)], REAL *restrict new, double rtol,
                               double atol, REAL *norm5, REAL *norm3) {
    int m = STATES(n);
    REAL work[m];
    STAGE(1) STAGE(2) STAGE(3) STAGE(4) STAGE(5) STAGE(6)
    STAGE(7) STAGE(8) STAGE(9) STAGE(10) STAGE(11)
    REAL sum5 = {0}, sum3 = {0};
    for (int i = 0; i < m; i++) {
        new[i] = y[i] + h * (DP_B(i));
        REAL scale = 1.0 / (atol + rtol * MAXIMUM(ABSOLUTE(y[i]), ABSOLUTE(new[i])));
        REAL e5 = (DP_E5(i)) * scale, e3 = (DP_E3(i)) * scale;
        sum5 += e5 * e5;
        sum3 += e3 * e3;
    }
    *norm5 = sum5;
    *norm3 = sum3;
}

/* The two weighted root mean squares |y| and |f| of the initial step. */
static inline void FN(norms)(int n, const REAL *restrict y, const REAL *restrict f, double rtol,
                             double atol, REAL *d0, REAL *d1) {
    int m = STATES(n);
    REAL s0 = {0}, s1 = {0};
    for (int i = 0; i < m; i++) {
        REAL scale = 1.0 / (atol + rtol * ABSOLUTE(y[i]));
        s0 += (y[i] * scale) * (y[i] * scale);
        s1 += (f[i] * scale) * (f[i] * scale);
    }
    *d0 = SQRT(s0 / (double)m);
    *d1 = SQRT(s1 / (double)m);
}

/* A trial Euler step of size h0 from (t, y): the weighted change of the derivative over h0. */
static inline REAL FN(curvature)(int n, REAL t, REAL h0, const REAL *restrict y,
                                 const REAL *restrict f, const REAL *restrict p,
                                 const REAL *restrict zc, double rtol, double atol) {
    int m = STATES(n);
    REAL ahead[m], there[m], sum = {0};
    for (int i = 0; i < m; i++) ahead[i] = y[i] + h0 * f[i];
    FN(derivative)(n, t + h0, ahead, p, zc, there);
    for (int i = 0; i < m; i++) {
        REAL change = (there[i] - f[i]) / (atol + rtol * ABSOLUTE(y[i]));
        sum += change * change;
    }
    return SQRT(sum / (double)m) / h0;
}
