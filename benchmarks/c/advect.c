/* Passive particles in a gridded current: dx/dt = F_R(x, t), linear in time, x2 and x1; RK4. */
#include <math.h>
#include <stdint.h>
#include <time.h>

typedef struct {
    int64_t shape[3];          /* grid points in time, x2 and x1 */
    double start[3], scale[3]; /* first grid point and 1 / spacing */
    const double *u, *v;       /* time slowest */
} Grid;

/* Cell and place within it, held at the edges. */
static inline int64_t locate(const Grid *g, int axis, double value, double *share) {
    double position = (value - g->start[axis]) * g->scale[axis];
    double last = (double)(g->shape[axis] - 1);
    position = position < 0 ? 0 : (position > last ? last : position);
    int64_t cell = (int64_t)position;
    cell = cell > g->shape[axis] - 2 ? g->shape[axis] - 2 : cell;
    *share = position - (double)cell;
    return cell;
}

static inline double mix(double a, double b, double share) { return a + share * (b - a); }

static inline double plane(const double *f, int64_t at, int64_t row, double s2, double s1) {
    return mix(mix(f[at], f[at + 1], s1), mix(f[at + row], f[at + row + 1], s1), s2);
}

static inline void flow(const Grid *g, double t, double x1, double x2, double *u, double *v) {
    double st, s2, s1;
    int64_t m = locate(g, 0, t, &st), j = locate(g, 1, x2, &s2), i = locate(g, 2, x1, &s1);
    int64_t row = g->shape[2], sheet = g->shape[1] * row, at = m * sheet + j * row + i;
    *u = mix(plane(g->u, at, row, s2, s1), plane(g->u, at + sheet, row, s2, s1), st);
    *v = mix(plane(g->v, at, row, s2, s1), plane(g->v, at + sheet, row, s2, s1), st);
}

/* Move particles (x1, x2) by `steps` steps of h from t = 0; returns the seconds spent. */
double advect_particles(const Grid *grid, int64_t particles, int64_t steps, double h, double *x1,
                        double *x2) {
    struct timespec start, stop;
    const Grid g = *grid;
    clock_gettime(CLOCK_MONOTONIC, &start);
    for (int64_t j = 0; j < particles; j++) {
        double a = x1[j], b = x2[j], u1, v1, u2, v2, u3, v3, u4, v4;
        for (int64_t s = 0; s < steps; s++) {
            double t = (double)s * h;
            flow(&g, t, a, b, &u1, &v1);
            flow(&g, t + 0.5 * h, a + 0.5 * h * u1, b + 0.5 * h * v1, &u2, &v2);
            flow(&g, t + 0.5 * h, a + 0.5 * h * u2, b + 0.5 * h * v2, &u3, &v3);
            flow(&g, t + h, a + h * u3, b + h * v3, &u4, &v4);
            a += h / 6 * (u1 + 2 * u2 + 2 * u3 + u4);
            b += h / 6 * (v1 + 2 * v2 + 2 * v3 + v4);
        }
        x1[j] = a;
        x2[j] = b;
    }
    clock_gettime(CLOCK_MONOTONIC, &stop);
    return (double)(stop.tv_sec - start.tv_sec) + 1e-9 * (double)(stop.tv_nsec - start.tv_nsec);
}
