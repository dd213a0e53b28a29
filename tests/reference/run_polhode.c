/* Answers cases of reference/polhode.h. Each line in: kind (1 for a top), count of times, moments, momentum, attitude, epoch, mgl
   of a top, times, all but the first two in hexadecimal floats. Each line out: error code, regime, eight numbers of the motion,
   then error code and seven numbers a time. */
#include <stdio.h>

#include "polhode.h"

static void print_numbers(int top_wanted, const polhode_free_body *body, const polhode_top *top)
{
    const double of_body[8] = {body->energy, body->momentum_norm, (double)body->encircled_axis, body->modulus,
                               body->period, body->precession_rate, body->precession_per_period, body->flip_interval};
    const double of_top[8] = {top->energy, top->lowest, top->highest, top->nutation_period, top->precession_per_period,
                              top->spin_per_period, 0.0, 0.0};
    int k;
    printf(" %d", top_wanted ? (int)top->regime : (int)body->regime);
    for (k = 0; k < 8; k++) printf(" %a", top_wanted ? of_top[k] : of_body[k]);
}

int main(void)
{
    int kind, count, k, j;
    while (scanf("%d %d", &kind, &count) == 2) {
        static polhode_free_body body;
        static polhode_top top;
        double given[12];
        int error;
        for (k = 0; k < 12; k++) if (scanf("%lf", given + k) != 1) return 1;
        error = kind ? polhode_top_init(&top, given, given[11], given + 3, given + 6, given[10])
                     : polhode_free_body_init(&body, given, given + 3, given + 6, given[10]);
        printf("%d", error);
        print_numbers(kind, &body, &top);
        for (k = 0; k < count; k++) {
            double t, q[4] = {0}, L[3] = {0};
            int late = 0;
            if (scanf("%lf", &t) != 1) return 1;
            if (!error) late = kind ? polhode_top_state(&top, t, q, L) : polhode_free_body_state(&body, t, q, L);
            printf(" %a", (double)late);
            for (j = 0; j < 4; j++) printf(" %a", q[j]);
            for (j = 0; j < 3; j++) printf(" %a", L[j]);
        }
        printf("\n");
    }
    return 0;
}
