/* Many heavy tops with their attitudes by a splitting of order 2, with compensated sums: what a C programmer would write.
   State of a top: quaternion wxyz, momentum, upward direction. One step is half a kick by the weight, five exact turns
   about the body's axes, half a kick. */
#include <math.h>

static void turn(double *y, double *total, int at, int j, int k, double less, double s) {
    double dj = less * y[at + j] + s * y[at + k], dk = less * y[at + k] - s * y[at + j];
    y[at + j] += dj; y[at + k] += dk;
    total[at + j] += dj; total[at + k] += dk;
}

static void axis(double time, int i, const double *inertia, double *y, double *total) {
    int j = (i + 1) % 3, k = (i + 2) % 3;
    double half = 0.5 * time * y[4 + i] / inertia[i];
    double sine = sin(half), cosine = cos(half);
    double s = 2.0 * sine * cosine, less = -2.0 * sine * sine;
    turn(y, total, 4, j, k, less, s);
    turn(y, total, 7, j, k, less, s);
    double c1 = -sine * sine / (1.0 + cosine);
    double w = y[0], a = y[1 + i], b = y[1 + j], c = y[1 + k];
    double dw = c1 * w - sine * a, da = c1 * a + sine * w, db = c1 * b + sine * c, dc = c1 * c - sine * b;
    y[0] += dw; y[1 + i] += da; y[1 + j] += db; y[1 + k] += dc;
    total[0] += dw; total[1 + i] += da; total[1 + j] += db; total[1 + k] += dc;
}

static void kick(double time, const double *weight, double *y, double *total) {
    for (int i = 0; i < 3; i++) {
        int j = (i + 1) % 3, k = (i + 2) % 3;
        double d = time * (y[7 + j] * weight[k] - y[7 + k] * weight[j]);
        y[4 + i] += d; total[4 + i] += d;
    }
}

void run(long tops, long steps, double h, const double *inertia, const double *weight, double *states) {
    for (long n = 0; n < tops; n++) {
        double *y = states + 10 * n, lost[10] = {0}, total[10], before[10];
        for (long step = 0; step < steps; step++) {
            for (int i = 0; i < 10; i++) { total[i] = 0.0; before[i] = y[i]; }
            kick(0.5 * h, weight, y, total);
            axis(0.5 * h, 0, inertia, y, total);
            axis(0.5 * h, 1, inertia, y, total);
            axis(h, 2, inertia, y, total);
            axis(0.5 * h, 1, inertia, y, total);
            axis(0.5 * h, 0, inertia, y, total);
            kick(0.5 * h, weight, y, total);
            for (int i = 0; i < 10; i++) {
                double wanted = total[i] + lost[i];
                y[i] = before[i] + wanted;
                lost[i] = (before[i] - y[i]) + wanted;
            }
        }
    }
}
