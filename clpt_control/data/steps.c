    double k[4][${n}], z[${n}];
    rates_(t, x, u, p, kept, k[0]);
    for (int i = 0; i < ${count}; i++) z[i] = x[i] + 0.5 * dt * k[0][i];
    rates_(t + 0.5 * dt, z, u, p, kept, k[1]);
    for (int i = 0; i < ${count}; i++) z[i] = x[i] + 0.5 * dt * k[1][i];
    rates_(t + 0.5 * dt, z, u, p, kept, k[2]);
    for (int i = 0; i < ${count}; i++) z[i] = x[i] + dt * k[2][i];
    rates_(t + dt, z, u, p, kept, k[3]);
    for (int i = 0; i < ${count}; i++)
        x[i] += dt / 6.0 * (k[0][i] + 2.0 * k[1][i] + 2.0 * k[2][i] + k[3][i]);
//
    double z[${n}];
    (void)dt;
    rates_(t, x, u, p, kept, z);
    for (int i = 0; i < ${count}; i++) x[i] = z[i];
//
    double after[${count}];
    kept_(t + 1.5 * dt, p, after);
${asked}    if (${some} > 0.0) {
        jump_(t + dt, x, u, p, after, z);
        for (int i = 0; i < ${states}; i++) x[i] = z[i];
    }
}

void ${name}_begin(double t, double *x, const double *u, const double *p) {
    double kept[${count}], z[${n}];
    kept_(t, p, kept);
${begin}    jump_(t, x, u, p, kept, z);
    for (int i = 0; i < ${states}; i++) x[i] = z[i];
