/* SPDX-License-Identifier: GPL-3.0-or-later
**
** flywheel.c - the flywheel that gives the steady motion a required fluctuation of speed.
**
** The fluctuation Cs is a function of x = 1 / I.  It is 0 for x = 0, the infinite flywheel, and
** dE x / omega^2 for small x, as in textbooks, so the secant method converges quickly.  If the flywheel is
** too small there may be no steady motion; such x are an upper bound.
*/
#include <math.h>

#include <gsl/gsl_math.h>

#include "motion_facts.h"
#include "flywheel.h"
#include "steady.h"

#define TRIES 200
#define CLOSE 1e-10      /* of the required fluctuation */
#define ROUNDED 1e-7     /* ... if it does not get closer */
#define NO_FLYWHEEL 1e12 /* 1/(kg m2) */

typedef struct search {
    flk_path *path;
    double cycle, mean_speed;
} search;

/* The fluctuation with a flywheel of 1 / x; infinite if there is no steady motion. */
static double fluctuation_at(const search *s, double x)
{
    flk_actual_facts f;

    flk_facts_forget(&f);
    s->path->equation.machine.flywheel = x < NO_FLYWHEEL ? 1 / x : 0;
    if (!flk_steady_find(s->path, s->cycle, s->mean_speed))
        return GSL_POSINF;
    flk_facts_of_cycle(s->path, s->cycle, &f);
    return gsl_finite(f.fluctuation_exact) ? f.fluctuation_exact : GSL_POSINF;
}

static int is_found(double y, double y_last, double wanted)
{
    double off = fabs(y - wanted);

    return off <= CLOSE * wanted || (off <= ROUNDED * wanted && off > 0.5 * fabs(y_last - wanted));
}

/* The next x, from the secant through this point and the last; 0 if there is none. */
static double secant(double x, double y, double *last, double *y_last, double wanted)
{
    double next = x + (wanted - y) * (x - *last) / (y - *y_last);

    if (!gsl_finite(y) || x >= NO_FLYWHEEL)
        return 0;
    *last = x;
    *y_last = y;
    return next;
}

int flk_flywheel_find(flk_path *p, double cycle, double mean_speed, double fluctuation)
{
    search s;
    double x = 1, y, last = 0, y_last = 0, low = 0, high = GSL_POSINF, next;
    int k;

    s.path = p;
    s.cycle = cycle;
    s.mean_speed = mean_speed;
    for (k = 0; k < TRIES && p->budget > 0 && !p->no_memory; k++) {
        y = fluctuation_at(&s, x);
        if (is_found(y, y_last, fluctuation) || (x >= NO_FLYWHEEL && y < fluctuation))
            return 1;
        if (y < fluctuation)
            low = x;
        else
            high = x;
        if (gsl_finite(high) && high - low <= 1e-15 * high)
            break;
        next = secant(x, y, &last, &y_last, fluctuation);
        if (!gsl_finite(high) && k >= 10)
            next = NO_FLYWHEEL; /* is one needed at all? */
        else if (!(next > low && next < high))
            next = !gsl_finite(high) ? 16 * x : low > 0 ? sqrt(low * high) : high / 16;
        x = GSL_MIN(next, NO_FLYWHEEL);
    }
    if (p->budget == 0)
        p->status = FOURLINK_TOO_LONG;
    else if (p->status == FOURLINK_OK)
        p->status = FOURLINK_NO_STEADY;
    return 0;
}
