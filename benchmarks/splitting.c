/* The splitting of polhode.integrators.Splitting, order 2, for the free rigid body with its attitude: what a C programmer
   would write. State: quaternion wxyz, L. One step is five exact rotations; sums are compensated if COMPENSATED. */
#include <math.h>

static void axis(double time, int i, const double *inertia, double *y, double *total) {
    int j = (i + 1) % 3, k = (i + 2) % 3;
    double half = 0.5 * time * y[4 + i] / inertia[i];
    double sine = sin(half), cosine = cos(half);
    double s = 2.0 * sine * cosine, less = -2.0 * sine * sine;
    double dj = less * y[4 + j] + s * y[4 + k], dk = less * y[4 + k] - s * y[4 + j];
    double c1 = -sine * sine / (1.0 + cosine);
    double w = y[0], a = y[1 + i], b = y[1 + j], c = y[1 + k];
    double dw = c1 * w - sine * a, da = c1 * a + sine * w, db = c1 * b + sine * c, dc = c1 * c - sine * b;
    y[4 + j] += dj; y[4 + k] += dk;
    y[0] += dw; y[1 + i] += da; y[1 + j] += db; y[1 + k] += dc;
#ifdef COMPENSATED
    total[4 + j] += dj; total[4 + k] += dk;
    total[0] += dw; total[1 + i] += da; total[1 + j] += db; total[1 + k] += dc;
#endif
}

void run(long steps, double h, const double *inertia, double *state) {
    double y[7], lost[7] = {0}, total[7], before[7];
    for (int n = 0; n < 7; n++) y[n] = state[n];
    for (long step = 0; step < steps; step++) {
#ifdef COMPENSATED
        for (int n = 0; n < 7; n++) { total[n] = 0.0; before[n] = y[n]; }
#endif
        axis(0.5 * h, 0, inertia, y, total);
        axis(0.5 * h, 1, inertia, y, total);
        axis(h, 2, inertia, y, total);
        axis(0.5 * h, 1, inertia, y, total);
        axis(0.5 * h, 0, inertia, y, total);
#ifdef COMPENSATED
        for (int n = 0; n < 7; n++) {
            double wanted = total[n] + lost[n];
            y[n] = before[n] + wanted;
            lost[n] = (before[n] - y[n]) + wanted;
        }
#endif
    }
    for (int n = 0; n < 7; n++) state[n] = y[n];
}
