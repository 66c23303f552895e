/* Eight doubles at once, with polynomials for exp and cos (relative error of exp 2e-16). */
#ifndef LANE_MATH_H
#define LANE_MATH_H
#include <stdint.h>
#ifdef __AVX512F__
#include <immintrin.h>
#endif

typedef double v8 __attribute__((vector_size(64)));
typedef int64_t m8 __attribute__((vector_size(64))); /* a mask: all bits or none */

#define LANES 8
#define WHOLE 6755399441055744.0 /* 1.5 2^52: adding it rounds to a whole number */

static inline v8 lane_where(m8 mask, v8 a, v8 b) { return (v8)((mask & (m8)a) | (~mask & (m8)b)); }

static inline v8 lane_max(v8 a, v8 b) { return lane_where(a > b, a, b); }

static inline v8 lane_min(v8 a, v8 b) { return lane_where(a < b, a, b); }

static inline v8 lane_abs(v8 a) { return (v8)((m8)a & INT64_MAX); }

static inline v8 lane_sqrt(v8 a) {
#ifdef __AVX512F__
    return (v8)_mm512_sqrt_pd((__m512d)a);
#else
    for (int i = 0; i < LANES; i++) a[i] = __builtin_sqrt(a[i]);
    return a;
#endif
}

/* exp(x) = 2^n exp(r), |r| <= ln(2)/2, for x in [-700, 700]; below it is exp(-700). */
static inline v8 lane_exp(v8 x) {
    x = lane_max(x, x * 0.0 - 700.0);
    v8 shifted = x * 0x1.71547652b82fep+0 + WHOLE, n = shifted - WHOLE;
    v8 r = x - n * 0x1.62e42fefa3800p-1;
    r = r - n * 0x1.ef35793c76730p-45;
    v8 r2 = r * r, r4 = r2 * r2;
    v8 low = (1.0 + r) + r2 * (1.0 / 2 + r * (1.0 / 6));
    v8 middle = (1.0 / 24 + r * (1.0 / 120)) + r2 * (1.0 / 720 + r * (1.0 / 5040));
    v8 high = (1.0 / 40320 + r * (1.0 / 362880)) + r2 * (1.0 / 3628800 + r * (1.0 / 39916800));
    v8 sum = low + r4 * (middle + r4 * (high + r4 * (1.0 / 479001600)));
    return (v8)((m8)sum + ((m8)shifted << 52));
}

/* cos(x) = (-1)^n cos(r), |r| <= pi/2, for |x| < 1e6. */
static inline v8 lane_cos(v8 x) {
    v8 shifted = x * 0x1.45f306dc9c883p-2 + WHOLE, n = shifted - WHOLE;
    v8 r = x - n * 0x1.921fb54400000p+1;
    r = r - n * 0x1.0b4611a600000p-33;
    r = r - n * 0x1.3198a2e037073p-68;
    v8 s = r * r, s2 = s * s, s4 = s2 * s2;
    v8 low = (1.0 - s * 0.5) + s2 * (1.0 / 24 - s * (1.0 / 720));
    v8 middle = (1.0 / 40320 - s * (1.0 / 3628800)) +
                s2 * (1.0 / 479001600 - s * (1.0 / 87178291200.0));
    v8 high = (1.0 / 20922789888000.0 - s * (1.0 / 6402373705728000.0)) +
              s2 * (1.0 / 2432902008176640000.0 - s * (1.0 / 1124000727777607680000.0));
    v8 sum = low + s4 * (middle + s4 * high);
    return (v8)((m8)sum ^ ((m8)shifted << 63));
}

#endif
