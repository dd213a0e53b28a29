/* Answers cases of reference/polhode.h. Each line in: kind, count of times, moments, momentum, attitude, epoch, then mgl of a
   top, then times, all but the first two in hexadecimal floats. Each line out: error code, then seven numbers a time. */
#include <stdio.h>

#include "polhode.h"

int main(void)
{
    int kind, count, k, j;
    while (scanf("%d %d", &kind, &count) == 2) {
        double given[11], mgl = 0.0;
        polhode_free_body body;
        polhode_top top;
        int error;
        for (k = 0; k < 11; k++) if (scanf("%lf", given + k) != 1) return 1;
        if (scanf("%lf", &mgl) != 1) return 1;
        error = kind ? polhode_top_init(&top, given, mgl, given + 3, given + 6, given[10])
                     : polhode_free_body_init(&body, given, given + 3, given + 6, given[10]);
        printf("%d", error);
        for (k = 0; k < count; k++) {
            double t, q[4] = {0}, L[3] = {0};
            int late = 0;
            if (scanf("%lf", &t) != 1) return 1;
            if (!error) late = kind ? polhode_top_state(&top, t, q, L) : polhode_free_body_state(&body, t, q, L);
            printf(" %d", late);
            for (j = 0; j < 4; j++) printf(" %a", q[j]);
            for (j = 0; j < 3; j++) printf(" %a", L[j]);
        }
        printf("\n");
    }
    return 0;
}
