/*
 * ${title}: made by clpt.export. C99, math.h alone.
 *
 * double x[${name}_nx];  copy ${name}_x0 into it; p: ${name}_p0, or your own copy.
 * ${name}_outputs(t, x, u, p, y): all outputs; call it before the step from t.
 * ${name}_rates(t, x, u, p, dx): ${rates}.
 * ${name}_step(t, dt, x, u, p): ${step}.
${begins}${levels}${divides} * A parameter marked fixed sets a size, an index or a branch: it is a constant of the code.
 * Where there are none of these, pass any array. Guards that end a run are not in this file.
 */
//
#include <math.h>

${enums}const double ${name}_p0[] = {${p0}};
const double ${name}_x0[] = {${x0}};

${functions}
${counted}static void kept_(double t, const double *p, double *kept) {
${intervals}    (void)t; (void)p; (void)kept;
}

void ${name}_outputs(double t, const double *x, const double *u, const double *p, double *y) {
    double kept[${kept}], w[${room}];
    kept_(t, p, kept);
    signals_(t, x, u, p, kept, w);
${outputs}}

void ${name}_rates(double t, const double *x, const double *u, const double *p, double *dx) {
    double kept[${kept}];
    kept_(t, p, kept);
    rates_(t, x, u, p, kept, dx);
}

void ${name}_step(double t, double dt, double *x, const double *u, ${next}const double *p) {
    double kept[${kept}];
${samples}    kept_(${within}, p, kept);
${count}${ending}}
//
    double k[4][${n}], z[${n}];
    rates_(t, x, u, p, kept, k[0]);
    for (int i = 0; i < ${states}; i++) z[i] = x[i] + 0.5 * dt * k[0][i];
    rates_(t + 0.5 * dt, z, ${u_middle}, p, kept, k[1]);
    for (int i = 0; i < ${states}; i++) z[i] = x[i] + 0.5 * dt * k[1][i];
    rates_(t + 0.5 * dt, z, ${u_middle}, p, kept, k[2]);
    for (int i = 0; i < ${states}; i++) z[i] = x[i] + dt * k[2][i];
    rates_(t + dt, z, ${u_end}, p, kept, k[3]);
    for (int i = 0; i < ${states}; i++)
        x[i] += dt / 6.0 * (k[0][i] + 2.0 * k[1][i] + 2.0 * k[2][i] + k[3][i]);
//
    double z[${n}];
    (void)dt;
    rates_(t, x, u, p, kept, z);
    for (int i = 0; i < ${states}; i++) x[i] = z[i];
//
    double after[${kept}];
    kept_(t + 1.5 * dt, p, after);
${count_again}${asked}    if (${some} > 0.0) {
        jump_(t + dt, x, u, p, after, z);
        for (int i = 0; i < ${states}; i++) x[i] = z[i];
    }
}

void ${name}_begin(double t, double *x, const double *u, const double *p) {
    double kept[${kept}], z[${n}];
    kept_(t, p, kept);
${begin}    jump_(t, x, u, p, kept, z);
    for (int i = 0; i < ${states}; i++) x[i] = z[i];
//
 * ${name}_begin(t, x, u, p): call it before the first step, and where u is new:
 * what samples at that time takes u; a step ends with its own u.
//
static void counted_(double n, double steps, double *kept) {
${intervals}}

//
    const double steps = fmax(1.0, floor(1.0 / (${rate} * dt) + 0.5));
    const double n = floor(t * (${rate} * steps) + 0.5);
    counted_(n, steps, kept);
