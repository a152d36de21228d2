/* SPDX-License-Identifier: GPL-3.0-or-later
**
** brute_fits.c - fits of the angle of random function generators against a dense search for link lengths.
**
**    brute_fits TASKS [SEED [LINKAGES [TASK]]]
**
** Each task has 4 to 12 points, near the output of a linkage, along a curve or anywhere, and weights or none.
** The search tries so many random linkages (200,000) of all proportions up to 1 : 100, both branches and both
** senses of crank and rocker, with a transmission angle of at least 0.001 deg at the points.  From the best
** ones the simplex method of Nelder and Mead makes the sum of w error^2 small.  The errors are those of
** fourlink_position, so that nothing of the fit is used.  A fit is missed if the search finds a sum that is
** 1 % less.  None may be, and none may have longer links or smaller angles.
** With TASK, only that one is tried and told.
*/
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>

#include "fourlink.h"

#define PI 3.14159265358979323846
#define MOST 12
#define RATIO 100
#define MU_LEAST (0.001 * PI / 180)
#define MISSED 0.01
#define NO_FIT 1e-12 /* sums below it, of errors relative to unit(), are rounding error */

static unsigned long long state;

static double chance(void)
{
    state ^= state << 13;
    state ^= state >> 7;
    state ^= state << 17;
    return (double)(state >> 11) / 9007199254740992.0;
}

static double between(double low, double high)
{
    return low + (high - low) * chance();
}

static fourlink_function_task task;
static double theta2[MOST], output[MOST], weight[MOST];

static int is_four_bar(void)
{
    return task.kind == FOURLINK_FOUR_BAR;
}

static double unit(void)
{
    double most = 0;
    unsigned long i;

    for (i = 0; i < task.n; i++)
        most = fmax(most, fabs(output[i]));
    return is_four_bar() ? task.ground : most;
}

/* A linkage by three numbers, all relative to unit(): the logarithm of the crank; that of the rocker, or the
** offset; the logarithm of the coupler or, for long links, coupler minus rocker (slider-crank: minus the
** offset), which then counts. */
typedef struct linkage {
    double x[3], sum;
    int by_difference, crank_turn, rocker_turn;
    fourlink_branch branch;
} linkage;

static double growth(const fourlink_design *d)
{
    double longest = fabs(d->offset), shortest = unit();
    int i;

    for (i = 1; i <= 4; i++)
        if (d->link[i].length > 0) {
            longest = fmax(longest, d->link[i].length);
            shortest = fmin(shortest, d->link[i].length);
        }
    return longest / shortest;
}

/* The sum; infinite if a point is not reached or nearly dead, or once it is more than `most`. */
static double sum_of(const fourlink_design *d, double crank_turn, double rocker_turn,
                     fourlink_branch branch, double most)
{
    fourlink_mechanism m;
    fourlink_state s;
    double sum = 0;
    unsigned long i;

    if (fourlink_prepare(d, &m) != FOURLINK_OK)
        return INFINITY;
    for (i = 0; i < task.n && sum <= most; i++) {
        double error;

        if (fourlink_position(&m, branch, theta2[i] + crank_turn, &s) != FOURLINK_OK ||
            s.mu < MU_LEAST)
            return INFINITY;
        error = is_four_bar() ? remainder(s.link[4].theta - output[i] - rocker_turn, 2 * PI)
                              : s.link[4].origin.x - output[i];
        sum += (task.weight ? weight[i] : 1) * error * error;
    }
    return sum <= most ? sum : INFINITY;
}

static int design_of(const linkage *l, fourlink_design *d)
{
    double along = is_four_bar() ? exp(l->x[1]) : fabs(l->x[1]);
    double coupler = l->by_difference ? along + l->x[2] : exp(l->x[2]);

    memset(d, 0, sizeof *d);
    d->kind = task.kind;
    d->link[2].length = unit() * exp(l->x[0]);
    d->link[3].length = unit() * coupler;
    if (is_four_bar()) {
        d->link[1].length = task.ground;
        d->link[4].length = unit() * along;
    } else {
        d->offset = unit() * l->x[1];
    }
    return coupler > 0;
}

static double value(const linkage *l, double most)
{
    fourlink_design d;

    return design_of(l, &d) && growth(&d) <= RATIO
               ? sum_of(&d, l->crank_turn ? PI : 0, l->rocker_turn ? PI : 0, l->branch, most)
               : INFINITY;
}

/* The simplex method, from a linkage and three beside it: reflection, expansion, contraction, shrinking. */
static void simplex(linkage *best, double beside)
{
    linkage p[4], try;
    int i, j, n;

    for (i = 0; i < 4; i++) {
        p[i] = *best;
        if (i > 0) {
            p[i].x[i - 1] += beside;
            p[i].sum = value(&p[i], INFINITY);
        }
    }
    for (n = 0; n < 3000; n++) {
        int low = 0, high = 0;
        double middle[3], far[3];

        for (i = 1; i < 4; i++) {
            low = p[i].sum < p[low].sum ? i : low;
            high = p[i].sum >= p[high].sum ? i : high;
        }
        if (p[high].sum - p[low].sum <= 1e-10 * p[low].sum)
            break;
        for (j = 0; j < 3; j++) {
            for (middle[j] = 0, i = 0; i < 4; i++)
                middle[j] += i == high ? 0 : p[i].x[j] / 3;
            far[j] = p[high].x[j] - middle[j];
        }
        try = p[high];
        for (j = 0; j < 3; j++)
            try.x[j] = middle[j] - far[j];
        try.sum = value(&try, INFINITY);
        if (try.sum < p[low].sum) {
            linkage further = try;

            for (j = 0; j < 3; j++)
                further.x[j] = middle[j] - 2 * far[j];
            further.sum = value(&further, INFINITY);
            if (further.sum < try.sum)
                try = further;
        } else if (try.sum >= p[high].sum || n % 2) {
            for (j = 0; j < 3; j++)
                try.x[j] = middle[j] + 0.5 * (try.sum < p[high].sum ? -1 : 1) * far[j];
            try.sum = value(&try, INFINITY);
        }
        if (try.sum < p[high].sum) {
            p[high] = try;
            continue;
        }
        for (i = 0; i < 4; i++)
            if (i != low) {
                for (j = 0; j < 3; j++)
                    p[i].x[j] = 0.5 * (p[i].x[j] + p[low].x[j]);
                p[i].sum = value(&p[i], INFINITY);
            }
    }
    for (i = 0; i < 4; i++)
        if (p[i].sum < best->sum)
            *best = p[i];
}

/* Again and again, until that helps no more: a simplex goes flat at a bound. */
static void descend(linkage *l)
{
    double before, beside = 0.1;
    int n = 0;

    do {
        before = l->sum;
        simplex(l, beside);
        beside *= -0.6;
    } while (l->sum > 0 && (l->sum < before * (1 - 1e-4) || n < 3) && n++ < 30);
}

static void random_linkage(linkage *l, double span)
{
    l->x[0] = between(-span, span);
    l->x[1] = between(-span, span);
    l->x[2] = between(-span, span);
    l->by_difference = span > 2 && chance() < 0.6;
    l->crank_turn = chance() < 0.5;
    l->rocker_turn = is_four_bar() && chance() < 0.5;
    l->branch = chance() < 0.5 ? FOURLINK_OPEN : FOURLINK_CROSSED;
    if (!is_four_bar())
        l->x[1] = (chance() < 0.5 ? -1 : 1) * exp(l->x[1]);
    if (l->by_difference)
        l->x[2] = between(-1.2, 1.2) * (1 + exp(l->x[0]));
}

/* The best of so many random linkages, the first one the best, with some distance from each other. */
#define KEPT 60
#define NEAR 0.3

static int are_near(const linkage *a, const linkage *b)
{
    int i;

    for (i = 0; i < 3; i++)
        if (fabs(a->x[i] - b->x[i]) > NEAR)
            return 0;
    return a->by_difference == b->by_difference && a->crank_turn == b->crank_turn &&
           a->rocker_turn == b->rocker_turn && a->branch == b->branch;
}

static int keep(linkage *kept, int n, const linkage *l)
{
    int i, place;

    for (i = 0; i < n && !are_near(&kept[i], l); i++)
        ;
    if (i < n) {
        if (l->sum >= kept[i].sum)
            return n;
    } else if (n < KEPT) {
        n++;
    } else {
        i = n - 1;
    }
    for (place = i; place > 0 && l->sum < kept[place - 1].sum; place--)
        kept[place] = kept[place - 1];
    kept[place] = *l;
    return n;
}

static linkage dense_search(long linkages)
{
    linkage kept[KEPT], best;
    int n = 0, i;
    long k;

    for (k = 0; k < linkages; k++) {
        linkage l;

        random_linkage(&l, log(RATIO));
        l.sum = value(&l, n < KEPT ? 1e300 : kept[n - 1].sum);
        if (l.sum < INFINITY)
            n = keep(kept, n, &l);
    }
    for (i = 0, best.sum = INFINITY; i < n; i++) {
        descend(&kept[i]);
        if (kept[i].sum < best.sum)
            best = kept[i];
    }
    return best;
}

/* ---------------------------------------------------------------------------------------- the tasks */

static int points_near_a_linkage(double scale)
{
    double at[MOST];
    int tries;

    for (tries = 0; tries < 200; tries++) {
        fourlink_mechanism m;
        fourlink_design d;
        fourlink_state s;
        linkage l;
        unsigned long i;

        random_linkage(&l, 2);
        if (!design_of(&l, &d) || fourlink_prepare(&d, &m) != FOURLINK_OK)
            continue;
        for (i = 0; i < task.n; i++) {
            if (fourlink_position(&m, l.branch, theta2[i], &s) != FOURLINK_OK)
                break;
            at[i] = is_four_bar() ? s.link[4].theta : s.link[4].origin.x;
        }
        if (i < task.n)
            continue;
        for (i = 0; i < task.n; i++)
            output[i] = at[i] + between(-0.05, 0.05) * (is_four_bar() ? 1 : scale);
        return 1;
    }
    return 0;
}

static int by_size(const void *x, const void *y)
{
    double a = *(const double *)x, b = *(const double *)y;

    return (a > b) - (a < b);
}

/* Angles at random places of a range, or at multiples of 15 deg; outputs that rise, or anywhere. */
static void make_task(void)
{
    double from = between(-PI, PI), range = chance() < 0.8 ? between(0.5, 2.5) : between(2, 6);
    double scale = pow(10, between(-2, 1)), first = between(-PI, PI), over = between(-3, 3);
    double power = between(0.3, 3), sort = chance();
    int is_even = chance() < 0.3;
    unsigned long i;

    memset(&task, 0, sizeof task);
    task.kind = chance() < 0.6 ? FOURLINK_FOUR_BAR : FOURLINK_SLIDER_CRANK;
    task.n = 4 + (unsigned long)((chance() < 0.5 ? 3 : 9) * chance());
    task.fit = FOURLINK_FIT_ANGLE;
    task.theta2 = theta2;
    task.output = output;
    task.weight = chance() < 0.5 ? weight : NULL;
    task.ground = is_four_bar() ? scale : 0;
    for (i = 0; i < task.n; i++) {
        theta2[i] = from + range * chance();
        output[i] = chance();
        weight[i] = between(0.5, 5);
    }
    qsort(theta2, task.n, sizeof *theta2, by_size);
    if (is_even)
        for (i = 0; i < task.n; i++)
            theta2[i] = PI / 12 * (floor(from) + (double)i * floor(1 + 4 * range / 2.5));
    if (sort < 0.3 && points_near_a_linkage(scale))
        return;
    if (sort < 0.6)
        for (i = 0; i < task.n; i++)
            output[i] = pow((double)i / (double)task.n, power) + between(-0.02, 0.02);
    else if (sort < 0.9)
        qsort(output, task.n, sizeof *output, by_size);
    for (i = 0; i < task.n; i++)
        output[i] = (first + over * output[i]) * (is_four_bar() ? 1 : scale);
}

static void tell_linkage(const char *who, double sum, const fourlink_design *d)
{
    printf("    %s: %.9g with links %g %g %g %g, offset %g\n", who, sum, d->link[1].length,
           d->link[2].length, d->link[3].length, d->link[4].length, d->offset);
}

static void tell(long number, const fourlink_solution *s, double sum, const linkage *best)
{
    const char *unit_of_output = is_four_bar() ? "rad" : "m";
    fourlink_design d;
    unsigned long k;

    printf("task %ld:\n    weights ", number);
    for (k = 0; task.weight && k < task.n; k++)
        printf("%s%.17g", k ? ", " : "", weight[k]);
    for (k = 0; k < task.n; k++)
        printf("%s%.17g rad %.17g %s", k ? ", " : "\n    points ", theta2[k], output[k],
               unit_of_output);
    printf("\n");
    tell_linkage("fit", sum, &s->design);
    if (design_of(best, &d))
        tell_linkage("search", best->sum, &d);
}

int main(int argc, char **argv)
{
    long tasks = argc > 1 ? atol(argv[1]) : 100, seed = argc > 2 ? atol(argv[2]) : 1;
    long linkages = argc > 3 ? atol(argv[3]) : 200000, only = argc > 4 ? atol(argv[4]) : -1, i;
    long none = 0, missed = 0, longer = 0, unbounded = 0, better = 0;
    double worst = 0, slowest = 0, all = 0;
    static fourlink_solution s;

    for (i = only >= 0 ? only : 0; i < (only >= 0 ? only + 1 : tasks); i++) {
        double sum = INFINITY, took;
        linkage best;
        clock_t start;
        unsigned long n;
        int status, k;

        state = 0x9E3779B97F4A7C15ULL * (unsigned long long)(seed * 1000003 + i + 1);
        for (k = 0; k < 10; k++)
            chance();
        make_task();
        start = clock();
        status = fourlink_synthesis_function(&task, 1, &s, &n);
        took = (double)(clock() - start) / CLOCKS_PER_SEC;
        all += took;
        slowest = fmax(slowest, took);
        if (status == FOURLINK_OK) {
            sum = sum_of(&s.design, s.crank_turn, s.rocker_turn, s.branch, 1e300);
            unbounded += growth(&s.design) > RATIO * (1 + 1e-9);
            longer += s.is_better_longer;
        }
        none += !(sum < INFINITY);
        best = dense_search(linkages);
        better += sum < best.sum * (1 - MISSED);
        if (best.sum < sum * (1 - MISSED) && sum > NO_FIT * unit() * unit()) {
            missed++;
            worst = fmax(worst, 1 - best.sum / sum);
            tell(i, &s, sum, &best);
        } else if (only >= 0) {
            tell(i, &s, sum, &best);
        }
    }
    printf("%ld tasks: %ld without a fit, %ld better the longer, %ld beyond the bound; %ld better "
           "than the "
           "search, %ld missed, by up to %.3g of the sum; %.3f s a task, at most %.3f s\n",
           tasks, none, longer, unbounded, better, missed, worst, all / (double)tasks, slowest);
    return unbounded > 0 || none > 0 || missed > 0;
}
