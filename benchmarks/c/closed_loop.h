/* The closed loop with the learned-flow law, Eqs. (1)-(7), (10), (20)-(23).
 *
 * Included once for numbers (REAL is double) and once for SIMD lanes (REAL is a vector of
 * doubles, one run per lane).  The includer defines REAL, FN(name), EXP, COS and SQRT.
 *
 * State: x[2], z[2], alpha[2][N], K[2], Gamma[2].
 * Parameters of one run, in this order:
 *     c1[N] c2[N] sigma[N] omega[N] phase[N] theta[2][N] alpha_M[2][N] KD[2] GammaD[2] gamma
 */

#ifndef BASIS_LANES /* else they stand in scalar.c */
/* phi_k = exp(-|x - c_k| / (2 sigma_k)) cos(omega_k t + phase_k), Eq. (5); the cosines given. */
static inline void FN(basis)(int n, const REAL *restrict p, REAL x1, REAL x2,
                             const REAL *restrict tide, REAL *restrict phi) {
    for (int k = 0; k < n; k++) {
        REAL d1 = x1 - p[k], d2 = x2 - p[n + k];
        phi[k] = EXP(SQRT(d1 * d1 + d2 * d2) / (-2.0 * p[2 * n + k])) * tide[k];
    }
}

/* The temporal factor of Eq. (5). */
static inline void FN(tides)(int n, const REAL *restrict p, REAL t, REAL *restrict tide) {
    for (int k = 0; k < n; k++) tide[k] = COS(p[3 * n + k] * t + p[4 * n + k]);
}
#endif

/* phi(z) leaves Eq. (2): alpha_M - alpha - (alpha_M - alpha) = 0, so it is not computed. */
static inline void FN(derivative)(int n, REAL t, const REAL *restrict y, const REAL *restrict p,
                                  const REAL *restrict zc, REAL *restrict dy) {
    const REAL *x = y, *z = y + 2, *alpha = y + 4, *K = y + 4 + 2 * n, *G = y + 6 + 2 * n;
    const REAL *theta = p + 5 * n, *alpha_M = p + 7 * n, *KD = p + 9 * n, *GD = p + 9 * n + 2;
    REAL gamma = p[9 * n + 4], phi_x[n], tide[n];
    FN(tides)(n, p, t, tide);
    FN(basis)(n, p, x[0], x[1], tide, phi_x);
    for (int i = 0; i < 2; i++) {
        const REAL *a = alpha + i * n, *m = alpha_M + i * n, *th = theta + i * n;
        REAL gain_e = gamma * (x[i] - z[i]); /* e = x - z, Eq. (10) */
        REAL flow = {0}, injected = {0};
        for (int k = 0; k < n; k++) {
            flow += (th[k] - m[k]) * phi_x[k];              /* Eqs. (3), (7) */
            injected += (m[k] + a[k]) * phi_x[k];           /* Eqs. (4), (6), (20) */
            dy[4 + i * n + k] = -gain_e * phi_x[k];         /* Eq. (21) */
        }
        dy[i] = flow - KD[i] * x[i] + GD[i] * zc[i];        /* Eq. (1) */
        dy[2 + i] = -injected - K[i] * z[i] + G[i] * zc[i]; /* Eq. (2) */
        dy[4 + 2 * n + i] = -gain_e * z[i];                 /* Eq. (22) */
        dy[6 + 2 * n + i] = gain_e * zc[i];                 /* Eq. (23) */
    }
}
