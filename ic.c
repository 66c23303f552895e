/*
 * ic: made by clpt.export. C99, math.h alone.
 *
 * double x[ic_nx];  copy ic_x0 into it; p: ic_p0, or your own copy.
 * ic_outputs(t, x, u, p, y): all outputs; call it before the step from t.
 * ic_rates(t, x, u, p, dx): dx/dt.
 * ic_step(t, dt, x, u, p): one step of Runge and Kutta's method of order 4, inputs held.
 * A parameter marked fixed sets a size, an index or a branch: it is a constant of the code.
 * Where there are none of these, pass any array. Guards that end a run are not in this file.
 */
#include <math.h>

enum {
    ic_x_lag_x,  /* lag_x */
    ic_nx = 1
};
enum {
    ic_u_r,  /* r */
    ic_nu = 1
};
enum {
    ic_y_y,  /* y */
    ic_ny = 1
};
enum {
    ic_p_lag_A_0_0,  /* lag.A[0,0] */
    ic_p_lag_B_0_0,  /* lag.B[0,0] */
    ic_p_lag_C_0_0,  /* lag.C[0,0] */
    ic_p_valve_at_0,  /* valve.at[0] */
    ic_p_valve_at_1,  /* valve.at[1] */
    ic_p_valve_at_2,  /* valve.at[2] */
    ic_p_valve_values_0,  /* valve.values[0] */
    ic_p_valve_values_1,  /* valve.values[1] */
    ic_p_valve_values_2,  /* valve.values[2] */
    ic_p_g_D_0_0,  /* g.D[0,0] */
    ic_np = 10
};
const double ic_p0[] = {(-1.0), 1.0, 1.0, (-1.0), 0.0, 1.0, (-2.0), 0.0, 2.0, 1.0};
const double ic_x0[] = {0.0};

static double search_(const double *row, int stride, int count, double value, double right) {
    int low = 0, high = count;
    while (low < high) {
        const int middle = (low + high) / 2;
        const double number = row[stride * middle];
        if (number < value || (right > 0.5 && number == value)) low = middle + 1;
        else high = middle;
    }
    return low;
}
static double pick_(const double *row, int stride, int count, double place) {
    double whole = trunc(place);
    if (whole < 0.0) whole += count;
    return whole >= 0.0 && whole < count ? row[stride * (int)whole] : NAN;
}

static void rates_(double t, const double *x, const double *u, const double *p, const double *kept, double *out) {
    (void)t; (void)x; (void)u; (void)p; (void)kept; (void)out;
    const double v2 = p[0] * x[0];
    const double v3 = 0.0 + v2;
    const double v5 = p[1] * 0.0;
    const double v6 = 0.0 + v5;
    const double v7 = v3 + v6;
    out[0] = v7;
}

static void signals_(double t, const double *x, const double *u, const double *p, const double *kept, double *w) {
    (void)t; (void)x; (void)u; (void)p; (void)kept; (void)w;
    const double v9 = p[2] * x[0];
    const double v10 = 0.0 + v9;
    const double v40 = p[9] * u[0];
    const double v41 = 0.0 + v40;
    const double v19 = p[7] - p[6];
    const double v20 = p[4] - p[3];
    const double v21 = v19 / v20;
    const double v23 = p[8] - p[7];
    const double v24 = p[5] - p[4];
    const double v25 = v23 / v24;
    w[0] = v10;
    w[2] = v41;
    w[12] = p[6];
    w[13] = p[6];
    w[14] = p[7];
    w[15] = p[8];
    w[3] = p[3];
    w[4] = p[3];
    w[5] = p[4];
    w[6] = p[5];
    w[7] = p[5];
    w[8] = 0.0;
    w[9] = v21;
    w[10] = v25;
    w[11] = 0.0;
    const double v16 = search_(w + 4, 1, 3, 0.0, 1.0);
    const double v28 = pick_(w + 8, 1, 4, v16);
    const double v31 = pick_(w + 3, 1, 5, v16);
    const double v32 = 0.0 - v31;
    const double v33 = v28 * v32;
    const double v36 = pick_(w + 12, 1, 4, v16);
    const double v37 = v33 + v36;
    w[1] = v37;
}

static void kept_(double t, const double *p, double *kept) {
    (void)t; (void)p; (void)kept;
}

void ic_outputs(double t, const double *x, const double *u, const double *p, double *y) {
    double kept[1], w[16];
    kept_(t, p, kept);
    signals_(t, x, u, p, kept, w);
    y[0] = w[0];
    (void)u; (void)y;
}

void ic_rates(double t, const double *x, const double *u, const double *p, double *dx) {
    double kept[1];
    kept_(t, p, kept);
    rates_(t, x, u, p, kept, dx);
}

void ic_step(double t, double dt, double *x, const double *u, const double *p) {
    double kept[1];
    kept_(t + 0.5 * dt, p, kept);
    double k[4][1], z[1];
    rates_(t, x, u, p, kept, k[0]);
    for (int i = 0; i < 1; i++) z[i] = x[i] + 0.5 * dt * k[0][i];
    rates_(t + 0.5 * dt, z, u, p, kept, k[1]);
    for (int i = 0; i < 1; i++) z[i] = x[i] + 0.5 * dt * k[1][i];
    rates_(t + 0.5 * dt, z, u, p, kept, k[2]);
    for (int i = 0; i < 1; i++) z[i] = x[i] + dt * k[2][i];
    rates_(t + dt, z, u, p, kept, k[3]);
    for (int i = 0; i < 1; i++)
        x[i] += dt / 6.0 * (k[0][i] + 2.0 * k[1][i] + 2.0 * k[2][i] + k[3][i]);
}
