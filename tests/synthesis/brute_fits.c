/* SPDX-License-Identifier: GPL-3.0-or-later
**
** brute_fits.c - fits of the angle of random function generators against searches by the simplex method.
**
**    brute_fits TASKS [SEED [STARTS]]
**
** Each task has 4 to 12 points, near the output of a linkage or anywhere, and weights or none.  From
** random linkages, whose links are at most 100 times as long as others, the simplex method of Nelder and
** Mead makes the sum of w error^2 small; the errors are those of fourlink_position.  A fit is missed if
** a search finds a sum that is 0.1 % less: at most 3 of 100 are.  None has longer links.
*/
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "fourlink.h"

#define PI 3.14159265358979323846
#define MOST 12
#define RATIO 100

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

static double unit(void)
{
    double most = 0;
    unsigned long i;

    for (i = 0; i < task.n; i++)
        most = fmax(most, fabs(output[i]));
    return task.kind == FOURLINK_FOUR_BAR ? task.ground : most;
}

/* x: logarithms of crank and coupler, that of the rocker or the offset, all relative to unit(). */
typedef struct linkage {
    double x[3];
    int crank_turn, rocker_turn;
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

static double sum_of(const fourlink_design *d, double crank_turn, double rocker_turn,
                     fourlink_branch branch)
{
    fourlink_mechanism m;
    fourlink_state s;
    double sum = 0;
    unsigned long i;

    if (fourlink_prepare(d, &m) != FOURLINK_OK)
        return INFINITY;
    for (i = 0; i < task.n; i++) {
        double error;

        if (fourlink_position(&m, branch, theta2[i] + crank_turn, &s) != FOURLINK_OK)
            return INFINITY;
        error = task.kind == FOURLINK_FOUR_BAR
                    ? remainder(s.link[4].theta - output[i] - rocker_turn, 2 * PI)
                    : s.link[4].origin.x - output[i];
        sum += (task.weight ? weight[i] : 1) * error * error;
    }
    return sum;
}

static void design_of(const linkage *l, fourlink_design *d)
{
    memset(d, 0, sizeof *d);
    d->kind = task.kind;
    d->link[2].length = unit() * exp(l->x[0]);
    d->link[3].length = unit() * exp(l->x[1]);
    if (task.kind == FOURLINK_FOUR_BAR) {
        d->link[1].length = task.ground;
        d->link[4].length = unit() * exp(l->x[2]);
    } else {
        d->offset = unit() * l->x[2];
    }
}

static double value(const linkage *l)
{
    fourlink_design d;

    design_of(l, &d);
    return growth(&d) <= RATIO
               ? sum_of(&d, l->crank_turn ? PI : 0, l->rocker_turn ? PI : 0, l->branch)
               : INFINITY;
}

/* The simplex method: reflection, expansion, contraction, shrinking. */
static double simplex(linkage *best)
{
    linkage p[4], try;
    double f[4], g;
    int i, j, n;

    for (i = 0; i < 4; i++) {
        p[i] = *best;
        if (i > 0)
            p[i].x[i - 1] += 0.05;
        f[i] = value(&p[i]);
    }
    for (n = 0; n < 3000; n++) {
        int low = 0, high = 0;
        double middle[3], far[3];

        for (i = 1; i < 4; i++) {
            low = f[i] < f[low] ? i : low;
            high = f[i] >= f[high] ? i : high;
        }
        if (f[high] - f[low] <= 1e-13 * f[low])
            break;
        for (j = 0; j < 3; j++) {
            for (middle[j] = 0, i = 0; i < 4; i++)
                middle[j] += i == high ? 0 : p[i].x[j] / 3;
            far[j] = p[high].x[j] - middle[j];
        }
        try = p[high];
        for (j = 0; j < 3; j++)
            try.x[j] = middle[j] - far[j];
        g = value(&try);
        if (g < f[low]) {
            linkage further = try;
            double h;

            for (j = 0; j < 3; j++)
                further.x[j] = middle[j] - 2 * far[j];
            h = value(&further);
            if (h < g) {
                try = further;
                g = h;
            }
        } else if (g >= f[high] || n % 2) {
            for (j = 0; j < 3; j++)
                try.x[j] = middle[j] + 0.5 * (g < f[high] ? -1 : 1) * far[j];
            g = value(&try);
        }
        if (g < f[high]) {
            p[high] = try;
            f[high] = g;
            continue;
        }
        for (i = 0; i < 4; i++)
            if (i != low) {
                for (j = 0; j < 3; j++)
                    p[i].x[j] = 0.5 * (p[i].x[j] + p[low].x[j]);
                f[i] = value(&p[i]);
            }
    }
    for (i = 0; i < 4; i++)
        if (f[i] <= value(best))
            *best = p[i];
    return value(best);
}

static void random_linkage(linkage *l)
{
    int i;

    for (i = 0; i < 3; i++)
        l->x[i] = between(-2, 2);
    if (task.kind == FOURLINK_SLIDER_CRANK)
        l->x[2] = between(-2, 2);
    l->crank_turn = chance() < 0.5;
    l->rocker_turn = task.kind == FOURLINK_FOUR_BAR && chance() < 0.5;
    l->branch = chance() < 0.5 ? FOURLINK_OPEN : FOURLINK_CROSSED;
}

static void make_task(void)
{
    double from = between(-PI, PI), to = from + between(0.5, 2.5), scale = pow(10, between(-2, 1));
    fourlink_mechanism m;
    fourlink_design d;
    fourlink_state s;
    linkage l;
    unsigned long i;
    int is_near = chance() < 0.6, tries = 0;

    memset(&task, 0, sizeof task);
    task.kind = chance() < 0.5 ? FOURLINK_FOUR_BAR : FOURLINK_SLIDER_CRANK;
    task.n = 4 + (unsigned long)(9 * chance());
    task.fit = FOURLINK_FIT_ANGLE;
    task.theta2 = theta2;
    task.output = output;
    task.weight = chance() < 0.5 ? weight : NULL;
    task.ground = task.kind == FOURLINK_FOUR_BAR ? scale : 0;
    for (i = 0; i < task.n; i++) {
        theta2[i] = from + (to - from) * ((double)i + between(0, 0.5)) / (double)task.n;
        weight[i] = between(0.5, 5);
        output[i] = scale * (1 + (double)i / (double)task.n + between(-0.2, 0.2));
    }
    if (task.kind == FOURLINK_FOUR_BAR)
        for (i = 0; i < task.n; i++)
            output[i] = output[i] / scale + from;
    while (is_near && tries++ < 200) {
        random_linkage(&l);
        design_of(&l, &d);
        if (fourlink_prepare(&d, &m) != FOURLINK_OK)
            continue;
        for (i = 0; i < task.n; i++) {
            if (fourlink_position(&m, l.branch, theta2[i], &s) != FOURLINK_OK)
                break;
            weight[i] = task.kind == FOURLINK_FOUR_BAR ? s.link[4].theta : s.link[4].origin.x;
        }
        if (i < task.n)
            continue;
        for (i = 0; i < task.n; i++)
            output[i] = weight[i] + between(-0.05, 0.05) * (task.ground > 0 ? 1 : scale);
        is_near = 0;
    }
    for (i = 0; i < task.n; i++)
        weight[i] = between(0.5, 5);
}

int main(int argc, char **argv)
{
    long tasks = argc > 1 ? atol(argv[1]) : 100, seed = argc > 2 ? atol(argv[2]) : 1, i;
    long starts = argc > 3 ? atol(argv[3]) : 100;
    long found = 0, none = 0, missed = 0, longer = 0, unbounded = 0, better = 0;
    double worst = 0;

    for (i = 0; i < tasks; i++) {
        fourlink_solution *s = malloc(sizeof *s);
        double sum = INFINITY, least = INFINITY;
        unsigned long n;
        long k;
        int status;

        state = 0x9E3779B97F4A7C15ULL * (unsigned long long)(seed * 1000003 + i + 1);
        for (k = 0; k < 10; k++)
            chance();
        make_task();
        if (!s)
            return 2;
        status = fourlink_synthesis_function(&task, 1, s, &n);
        if (status == FOURLINK_OK)
            sum = sum_of(&s->design, s->crank_turn, s->rocker_turn, s->branch);
        for (k = 0; k < starts; k++) {
            linkage l;
            double here;
            int tries = 0;

            do
                random_linkage(&l);
            while (!(value(&l) < INFINITY) && tries++ < 200);
            here = simplex(&l);
            least = fmin(least, here);
        }
        found += sum < INFINITY;
        none += !(sum < INFINITY);
        if (status == FOURLINK_OK) {
            unbounded += sum < INFINITY && growth(&s->design) > RATIO * (1 + 1e-9);
            longer += s->is_better_longer;
        }
        better += sum < least * (1 - 1e-3);
        if (least < sum * (1 - 1e-3)) {
            missed++;
            worst = fmax(worst, 1 - least / sum);
            if (getenv("BRUTE_VERBOSE"))
                printf("task %ld: kind %d, %lu points: %g, by search %g; %s\n", i, (int)task.kind,
                       task.n, sum, least,
                       status == FOURLINK_OK && s->is_better_longer ? "better the longer" : "");
        }
        free(s);
    }
    printf("%ld tasks: %ld fits, %ld without; %ld better the longer, %ld beyond the bound; %ld "
           "better than the "
           "search, %ld missed, by up to %.3g of the sum\n",
           tasks, found, none, longer, unbounded, better, missed, worst);
    return unbounded > 0 || none > 0 || 100 * missed > 3 * tasks;
}
