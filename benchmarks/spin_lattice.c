/* Heisenberg spins on a periodic cubic lattice of even size: bonds in six classes, forth and back, each an exact turn
   of both ends about their sum by -h/2 |sum|. */
#include <math.h>

static void bond(double *a, double *b, double time)
{
    double p[3], square = 0.0;
    for (int k = 0; k < 3; k++) {
        p[k] = -time * (a[k] + b[k]);
        square += p[k] * p[k];
    }
    double angle = sqrt(square), first = 1.0 - square / 6.0, second = 0.5 - square / 24.0;
    if (square > 1e-8) {
        double half = sin(0.5 * angle);
        first = sin(angle) / angle;
        second = 2.0 * half * half / square;
    }
    double x = p[1] * a[2] - p[2] * a[1], y = p[2] * a[0] - p[0] * a[2], z = p[0] * a[1] - p[1] * a[0];
    double d[3] = {first * x + second * (p[1] * z - p[2] * y), first * y + second * (p[2] * x - p[0] * z),
                   first * z + second * (p[0] * y - p[1] * x)};
    for (int k = 0; k < 3; k++) {
        a[k] += d[k];
        b[k] -= d[k];
    }
}

static void class_of(long n, int axis, int odd, double time, double *s)
{
    long stride[3] = {n * n, n, 1};
    for (long i = 0; i < n; i++)
        for (long j = 0; j < n; j++)
            for (long k = 0; k < n; k++) {
                long place[3] = {i, j, k};
                if (place[axis] % 2 != odd)
                    continue;
                long here = i * n * n + j * n + k;
                long there = here + stride[axis] * (place[axis] == n - 1 ? 1 - n : 1);
                bond(s + 3 * here, s + 3 * there, time);
            }
}

void run(long n, long steps, double h, double *s)
{
    for (long step = 0; step < steps; step++) {
        for (int c = 0; c < 6; c++)
            class_of(n, c / 2, c % 2, c < 5 ? 0.5 * h : h, s);
        for (int c = 4; c >= 0; c--)
            class_of(n, c / 2, c % 2, 0.5 * h, s);
    }
}
