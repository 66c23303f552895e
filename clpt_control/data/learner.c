/*
 * ${title}: the learner alone, made by clpt.export. C99, math.h alone, no allocation.
 *
 * double x[${name}_nx], u[${name}_nu], u_next[${name}_nu], y[${name}_ny]:
 * state, inputs at t and t + dt, outputs; places in the enums.
 * Copy ${name}_x0 into x and begin at t = 0. Then in each period dt:
 *     write into u_next the inputs at t + dt;
 *     ${name}_step(t, dt, x, u, u_next, ${name}_p0);
 *     t = t + dt, and copy u_next into u;
 *     ${name}_outputs(t, x, u, ${name}_p0, y), where y is needed.
${fixes} * Units: length ${length}, time ${time}. Inputs:
${inputs} * Step: Runge and Kutta's method of order 4, inputs on a straight line from u to u_next; pass u twice
 * if inputs are held. If an input jumps at t + dt, u_next has its value before the jump, u after it.
 * Begin with dt = ${advice} ${time} and halve it until the states no longer change.
 * dt must divide dwell, samples and windows.
 * Parameters: ${name}_p0, or a copy that you may change; ${name}_rates returns dx/dt.
 *
${proved} */
//
 * When a fix arrives at t: write it into u, and call ${name}_fix(t, x, u, ${name}_p0).
 * It returns 1 if the fix was learned; 0, with x as it was, if the result is not finite, or if the
 * fix lies further than the gate from the prediction (-D${name}_gate=LENGTH; none by default).
 * Limit: the flow must turn by less than about 1 radian between fixes. In an eddy that turns
 * further the estimate may leave the true parameters, without a sign.
 * A late fix: see docs/on_board.md.
//
    double middle[${inputs_count}];
    for (int i = 0; i < ${inputs_count}; i++) middle[i] = 0.5 * (u[i] + u_next[i]);
//
    kept_(t - 0.5 * dt, p, kept);
    {
        double after[${kept}], z[${n}];
        kept_(t + 0.5 * dt, p, after);
    ${asked}    ${begin}        if (${some} != 0.0) {
            jump_(t, x, u, p, after, z);
            for (int i = 0; i < ${states}; i++) x[i] = z[i];
        }
    }
//
}

#ifndef ${name}_gate
#define ${name}_gate 0.0 /* ${length}; 0: none */
#endif

int ${name}_fix(double t, double *x, const double *u, const double *p) {
    double kept[${kept}], z[${n}];
    double off_0 = u[${name}_u_fix_0] - x[${name}_x_adaptation_z_0];
    double off_1 = u[${name}_u_fix_1] - x[${name}_x_adaptation_z_1];
    if (${name}_gate > 0.0 && !(sqrt(off_0 * off_0 + off_1 * off_1) <= ${name}_gate)) return 0;
    kept_(t, p, kept);
    kept[${jump}] = 1.0;
    jump_(t, x, u, p, kept, z);
    for (int i = 0; i < ${states}; i++) {
        if (!isfinite(z[i])) return 0;
    }
    for (int i = 0; i < ${states}; i++) x[i] = z[i];
    return 1;
