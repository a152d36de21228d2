/* SPDX-License-Identifier: GPL-3.0-or-later
**
** points.c - linkages whose coupler point passes many points: descents from many starts.
**
** A start has the ratios of the links, and a crank angle for each position: equal shares of the path belong
** to equal rotations.  Then the pivots and the coupler point follow from a linear problem, and a descent
** changes all of them.  The numbers of the starts are Halton's: they fill their box evenly, and are the
** same on each run.  (J. H. Halton, Numer. Math. 2 (1960) 84-90.)
*/
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include <gsl/gsl_math.h>

#include "points.h"

#define STARTS 8000 /* of a search */
#define KEPT 100    /* linkages */
#define FEW 20      /* points for the first descent of a start */

/* Bounds in units of the size of the path, and of the shape: what lies near a change point is no linkage. */
#define FAR 50.0
#define LEAST 1e-5
#define TINY 1e-12 /* a share of the path that is none */
#define SHORTEST 0.02
#define LONGEST 20.0

/* Steps and last relative decrease of a descent: of each start, of those whose sum is then below the best
** ones times PROMISING, and of those that are kept. */
#define STEPS 50
#define ROUGHLY 1e-2
#define PROMISING 4.0
#define BEST_ONES 10 /* so many are to be good */
#define CLOSE_STEPS 60
#define CLOSELY 1e-4
#define FULL_STEPS 1000
#define FULLY 1e-11

/* The transmission angle is aimed at by so much more, rad, bounds of lengths by this part of them; what
** is beyond counts more and more until it holds. */
#define CLOSE_TO_MU 1e-6
#define DEAD (0.1 * M_PI / 180) /* a linkage with less is as good as dead, whatever is asked for */
#define STIFFEST 1e5

#define SAME 5e-3        /* linkages whose unknowns differ by less are the same */
#define EXACT 1e-20      /* a sum below it is rounding, for each position */
#define LONGEST_LINK 100 /* times the shortest */

/* A linkage that is kept, with what decides its place. */
typedef struct candidate {
    flk_trial trial;
    int is_swapped, defects;
    double mu_min;
} candidate;

typedef struct search {
    const fourlink_points_task *task;
    flk_points points, few;               /* of many points, few stand for all in a first descent */
    unsigned long pick[FEW];              /* which ones */
    flk_trial first;                      /* its linkage */
    double share[FOURLINK_POSITIONS_MAX]; /* of the path, 0 to 1 */
    double closed;                        /* the share of a turn that a closed path has */
    flk_trial trial;
    fourlink_solution checked, near;
    candidate kept[KEPT], rough[KEPT]; /* at last, and before they descend fully */
    unsigned long n_kept, n_starts;
    int is_swapped;
} search;

/* -------------------------------------------------------------------------------------- the task */

static int check_task(const fourlink_points_task *task)
{
    unsigned long i, j;

    if (task->kind != FOURLINK_FOUR_BAR && task->kind != FOURLINK_SLIDER_CRANK)
        return FOURLINK_BAD_KIND;
    if (task->n < 3 || task->n > FOURLINK_POSITIONS_MAX)
        return FOURLINK_BAD_POINTS;
    if (!task->point)
        return FOURLINK_NULL;
    if (!flk_points_within(task->point, task->n) ||
        (task->angle && !flk_are_within(task->angle, task->n, FOURLINK_NUMBER_MAX)) ||
        (task->timing && !flk_are_within(task->timing, task->n - 1, FOURLINK_NUMBER_MAX)) ||
        !(task->mu_min >= 0 && task->mu_min < M_PI_2) ||
        !(task->shortest >= 0 && task->shortest <= FOURLINK_LENGTH_MAX) ||
        !(task->longest >= 0 && task->longest <= FOURLINK_LENGTH_MAX) ||
        !(task->length_ratio >= 0 && task->length_ratio <= FOURLINK_NUMBER_MAX))
        return FOURLINK_BAD_NUMBER;
    if ((task->longest > 0 && !(task->shortest < task->longest)) ||
        (task->length_ratio > 0 && !(task->length_ratio > 1)))
        return FOURLINK_BAD_CHOICE;
    for (i = 0; i < task->n; i++) {
        if (task->weight && !(task->weight[i] > 0 && task->weight[i] <= FOURLINK_NUMBER_MAX))
            return FOURLINK_BAD_NUMBER;
        for (j = 0; j < i; j++)
            if (task->point[i].x == task->point[j].x && task->point[i].y == task->point[j].y &&
                (!task->angle || task->angle[i] == task->angle[j]))
                return FOURLINK_DEPENDENT;
    }
    return FOURLINK_OK;
}

static int check_ground(const fourlink_ground *ground)
{
    if (!ground->is_given)
        return FOURLINK_OK;
    if (!flk_points_within(&ground->low, 1) || !flk_points_within(&ground->high, 1))
        return FOURLINK_BAD_NUMBER;
    return ground->low.x <= ground->high.x && ground->low.y <= ground->high.y ? FOURLINK_OK
                                                                              : FOURLINK_BAD_CHOICE;
}

/* The points in units of their size, their weights with a mean of 1. */
static int set_positions(search *s)
{
    const fourlink_points_task *task = s->task;
    flk_points *p = &s->points;
    double n = (double)task->n, length = 0, squares = 0, weight = 0;
    unsigned long j;

    p->kind = task->kind;
    p->n = task->n;
    p->has_timing = task->timing != NULL;
    p->has_angle = task->angle != NULL;
    p->most_cosine = task->mu_min > 0 ? cos(task->mu_min + CLOSE_TO_MU) : 1;
    p->stiffness = 1;
    p->is_bounded =
        p->most_cosine < 1 || task->shortest > 0 || task->longest > 0 || task->length_ratio > 0;
    for (j = 0; j < p->n; j++) {
        p->centre.x += task->point[j].x / n;
        p->centre.y += task->point[j].y / n;
        weight += task->weight ? task->weight[j] : 0;
    }
    for (j = 0; j < p->n; j++)
        squares +=
            gsl_pow_2(task->point[j].x - p->centre.x) + gsl_pow_2(task->point[j].y - p->centre.y);
    p->size = sqrt(squares / n);
    if (!(p->size > 0))
        return FOURLINK_DEPENDENT;
    p->shortest = task->shortest / p->size * (1 + CLOSE_TO_MU);
    p->longest = task->longest > 0 ? task->longest / p->size * (1 - CLOSE_TO_MU) : GSL_POSINF;
    p->length_ratio =
        task->length_ratio > 0 ? 1 + (task->length_ratio - 1) * (1 - CLOSE_TO_MU) : GSL_POSINF;
    for (j = 0; j < p->n; j++) {
        p->point[j].x = (task->point[j].x - p->centre.x) / p->size;
        p->point[j].y = (task->point[j].y - p->centre.y) / p->size;
        p->root[j] = task->weight ? sqrt(task->weight[j] / weight * n) : 1;
        p->timing[j] = task->timing && j > 0 ? task->timing[j - 1] : 0;
        p->angle[j] = task->angle ? task->angle[j] : 0;
        if (j > 0)
            length +=
                gsl_hypot(p->point[j].x - p->point[j - 1].x, p->point[j].y - p->point[j - 1].y);
        s->share[j] = length;
    }
    for (j = 0; j < p->n; j++)
        s->share[j] = length > 0 ? s->share[j] / length : (double)j / n;
    s->closed = length / (length + gsl_hypot(p->point[p->n - 1].x - p->point[0].x,
                                             p->point[p->n - 1].y - p->point[0].y));
    return FOURLINK_OK;
}

static void set_bounds(flk_points *p, int first, int n, double low, double high)
{
    for (; n > 0; n--, first++) {
        p->low[first] = low;
        p->high[first] = high;
    }
}

/* Where the pivots may be; the crank stands on the right one if they are swapped. */
static void set_pivots(search *s, int is_swapped)
{
    const fourlink_ground *at[2];
    flk_points *p = &s->points;
    int i;

    s->is_swapped = is_swapped;
    at[0] = is_swapped ? &s->task->right : &s->task->left;
    at[1] = is_swapped ? &s->task->left : &s->task->right;
    for (i = 0; i < 2; i++)
        if (at[i]->is_given) {
            set_bounds(p, FLK_AX + 2 * i, 1, (at[i]->low.x - p->centre.x) / p->size,
                       (at[i]->high.x - p->centre.x) / p->size);
            set_bounds(p, FLK_AY + 2 * i, 1, (at[i]->low.y - p->centre.y) / p->size,
                       (at[i]->high.y - p->centre.y) / p->size);
        } else {
            set_bounds(p, FLK_AX + 2 * i, 2, -FAR, FAR);
        }
}

/* The bounds of the shape, of crank-rockers or double cranks, or of all linkages. */
static void set_shape_bounds(flk_points *p, int turns_fully, int is_double_crank)
{
    int slides = p->kind == FOURLINK_SLIDER_CRANK;

    set_bounds(p, FLK_QX, 2, -FAR, FAR);
    set_bounds(p, FLK_SHAPE, 3, 0, 0);
    if (turns_fully) {
        set_bounds(p, FLK_SHAPE, 1, is_double_crank ? 1 + LEAST : SHORTEST,
                   is_double_crank ? LONGEST : 1 - LEAST);
        set_bounds(p, FLK_SHAPE + 1, 1, -1 + LEAST, 1 - LEAST);
        if (!slides)
            set_bounds(p, FLK_SHAPE + 2, 1, LEAST, LONGEST);
    } else {
        set_bounds(p, FLK_SHAPE, 1, SHORTEST, LONGEST);
        set_bounds(p, FLK_SHAPE + 1, slides ? 1 : 2, slides ? -LONGEST : SHORTEST, LONGEST);
    }
    set_bounds(p, FLK_START, 2, 0, 0);
    if (p->has_timing)
        set_bounds(p, FLK_START, 1, -FAR, FAR);
    if (p->has_angle)
        set_bounds(p, FLK_ATTITUDE, 1, -FAR, FAR);
}

/* Pick the few points, evenly from all. */
static void pick_few(search *s)
{
    unsigned long n = s->points.n, few = n < FEW ? n : FEW, k, j;

    s->few = s->points;
    s->few.n = few;
    for (k = 0; k < few; k++) {
        j = s->pick[k] = (k * (n - 1) + (few - 1) / 2) / (few - 1);
        s->few.point[k] = s->points.point[j];
        s->few.angle[k] = s->points.angle[j];
        s->few.timing[k] = s->points.timing[j];
        s->few.root[k] = s->points.root[j];
    }
}

/* The first descent of a start: few points stand for all, and the crank angles between follow from their
** shares of the path.  The sum is then somewhat that of all. */
static void descend_roughly(search *s)
{
    unsigned long j, k = 0;
    double part;

    if (s->points.n <= FEW) {
        flk_descend(&s->points, &s->trial, STEPS, ROUGHLY);
        return;
    }
    memcpy(s->few.low, s->points.low, sizeof s->few.low);
    memcpy(s->few.high, s->points.high, sizeof s->few.high);
    s->first = s->trial;
    for (j = 0; j < FEW; j++)
        s->first.theta2[j] = s->trial.theta2[s->pick[j]];
    flk_descend(&s->few, &s->first, STEPS, ROUGHLY);
    memcpy(s->trial.x, s->first.x, sizeof s->first.x);
    s->trial.sum = s->first.sum * (double)s->points.n / FEW;
    for (j = 0; j < s->points.n; j++) {
        k += k + 2 < FEW && j > s->pick[k + 1];
        part = (s->share[j] - s->share[s->pick[k]]) /
               GSL_MAX_DBL(s->share[s->pick[k + 1]] - s->share[s->pick[k]], TINY);
        s->trial.theta2[j] =
            s->points.has_timing
                ? s->trial.x[FLK_START] + s->trial.sense * s->points.timing[j]
                : s->first.theta2[k] + part * (s->first.theta2[k + 1] - s->first.theta2[k]);
    }
}

/* -------------------------------------------------------------------------------------- the starts */

/* Halton's number i of a base: the digits of i behind the point, in reverse. */
double flk_halton(unsigned long i, unsigned long base)
{
    double digit = 1, number = 0;

    for (; i > 0; i /= base) {
        digit /= (double)base;
        number += digit * (double)(i % base);
    }
    return number;
}

/* The shape of start i. */
static void set_shape(search *s, unsigned long i)
{
    double u = flk_halton(i, 2), v = flk_halton(i, 3), w = flk_halton(i, 5),
           *shape = &s->trial.x[FLK_SHAPE];
    int slides = s->points.kind == FOURLINK_SLIDER_CRANK, fully = s->trial.turns_fully;
    int is_double_crank = fully && !slides && u > 0.75;

    set_shape_bounds(&s->points, fully, is_double_crank);
    if (is_double_crank)
        u = 1 / (4 * (u - 0.75));
    else if (fully)
        u /= slides ? 1 : 0.75;
    else
        u = 0.1 + 2 * u;
    shape[0] = u;
    shape[1] = fully || slides ? 2 * v - 1 : 0.1 + 2 * v;
    shape[2] = fully ? 3 * w * w : 0.1 + 2 * w;
}

/* The pivots of start i: in the middle of a box they are given, else they are free for the linear fit. */
static void place_pivots(search *s, unsigned long i)
{
    static const unsigned long bases[] = {13, 17, 19, 23};
    flk_points *p = &s->points;
    int k;

    for (k = 0; k < 4; k++)
        if (p->low[k] > -FAR)
            p->low[k] = p->high[k] = p->low[k] + flk_halton(i, bases[k]) * (p->high[k] - p->low[k]);
}

/* Crank angles of the positions: with timing given ones; else as the path goes on, over a part of a turn, or
** over as much as a closed path leaves. */
static void set_angles(search *s, unsigned long i, int sense)
{
    double first = 2 * M_PI * flk_halton(i, 7), u = flk_halton(i, 11), turn;
    unsigned long j;

    turn = 2 * M_PI * sense * (u < 0.4 ? s->closed : 0.1 + 0.9 * (u - 0.4) / 0.6);
    s->trial.x[FLK_START] = s->points.has_timing ? first : 0;
    for (j = 0; j < s->points.n; j++)
        s->trial.theta2[j] =
            first + (s->points.has_timing ? sense * s->points.timing[j] : turn * s->share[j]);
}

static int set_start(search *s, unsigned long number)
{
    unsigned long i = number / 4 + 1;
    int ok;

    s->trial.turns_fully = !(s->task->may_rock && i / 2 % 2);
    memset(s->trial.x, 0, sizeof s->trial.x);
    s->trial.sign = number % 2 ? -1 : 1;
    set_pivots(s, s->task->left.is_given && s->task->right.is_given && i % 2);
    set_shape(s, i);
    s->trial.sense = number / 2 % 2 && (!s->points.has_timing || s->task->either_way) ? -1 : 1;
    set_angles(s, i, s->trial.sense);
    place_pivots(s, i);
    ok = flk_fit_pivots(&s->points, &s->trial);
    set_pivots(s, s->is_swapped);
    return ok;
}

/* Start from a linkage that was found before; 0 if it is none of this task. */
static int set_near(search *s, const fourlink_solution *near)
{
    flk_trial_from(&s->points, near, &s->trial);
    set_pivots(s, near->is_swapped);
    set_shape_bounds(&s->points, s->trial.turns_fully, s->trial.x[FLK_SHAPE] > 1);
    return s->trial.turns_fully || s->task->may_rock;
}

/* 1 if the pivots of the trial are where the task allows them. */
static int is_inside(const search *s)
{
    int k;

    for (k = FLK_AX; k <= FLK_DY; k++)
        if (!(s->trial.x[k] >= s->points.low[k] && s->trial.x[k] <= s->points.high[k]))
            return 0;
    return 1;
}

/* ----------------------------------------------------------------------------------- the linkages */

/* The linkage of a trial, with its checks.  FOURLINK_OK, or there is none. */
static int check_trial(search *s, const flk_trial *at, int is_swapped, fourlink_solution *found)
{
    const flk_points *p = &s->points;
    fourlink_link *link = found->design.link;
    double zx = at->x[FLK_DX] - at->x[FLK_AX], zy = at->x[FLK_DY] - at->x[FLK_AY];
    double unit = p->size * gsl_hypot(zx, zy), cosine, sine;
    int slides = p->kind == FOURLINK_SLIDER_CRANK, status, i;
    flk_shape shape;
    flk_pose pose;
    unsigned long j;

    memset(found, 0, sizeof *found);
    flk_shape_of(p, at, &shape);
    found->design.kind = p->kind;
    link[FOURLINK_GROUND].length = slides ? 0 : unit;
    link[FOURLINK_CRANK].length = unit * shape.ratio[0];
    link[FOURLINK_COUPLER].length = slides ? unit : unit * shape.ratio[1];
    link[FOURLINK_FOLLOWER].length = slides ? 0 : unit * shape.ratio[2];
    found->design.offset = slides ? unit * shape.ratio[1] : 0;
    for (i = FOURLINK_GROUND; i <= FOURLINK_FOLLOWER; i++)
        if (!(link[i].length <= FOURLINK_LENGTH_MAX) ||
            (link[i].length > 0 && !(link[i].length >= FOURLINK_LENGTH_MIN)))
            return FOURLINK_INFINITE_LINK;
    found->branch = at->sign > 0 ? FOURLINK_OPEN : FOURLINK_CROSSED;
    found->origin.x = p->centre.x + p->size * at->x[FLK_AX];
    found->origin.y = p->centre.y + p->size * at->x[FLK_AY];
    found->direction = atan2(zy, zx);
    found->has_point = 1;
    found->point.x = unit * at->x[FLK_QX];
    found->point.y = unit * at->x[FLK_QY];
    found->n_positions = (int)p->n;
    found->is_swapped = is_swapped;
    cosine = cos(found->direction);
    sine = sin(found->direction);
    for (j = 0; j < p->n; j++) {
        fourlink_precision *to = &found->position[j];
        double x = s->task->point[j].x - found->origin.x, y = s->task->point[j].y - found->origin.y;

        if (!flk_pose_at(&shape, at->theta2[j], &pose))
            return FOURLINK_NOT_REACHED;
        to->theta2 = at->theta2[j];
        to->theta3 = atan2(pose.coupler.y, pose.coupler.x);
        to->point.x = x * cosine + y * sine;
        to->point.y = y * cosine - x * sine;
        x = unit * (shape.ratio[0] * pose.crank.x - !slides);
        y = unit * shape.ratio[0] * pose.crank.y;
        x += link[FOURLINK_COUPLER].length * pose.coupler.x;
        y += link[FOURLINK_COUPLER].length * pose.coupler.y;
        to->output = slides ? x : atan2(y, x);
        if (p->has_angle) {
            double wanted = flk_reduced(p->angle[j] + at->x[FLK_ATTITUDE] - found->direction);

            to->residual = flk_reduced(to->theta3 - wanted);
            to->theta3 = wanted;
        }
    }
    status = flk_check_solution(found, p->has_timing  ? FLK_AS_GIVEN
                                       : p->has_angle ? FLK_EITHER_WAY
                                                      : FLK_ABOUT);
    if (s->task->any_order)
        found->defects &= ~FOURLINK_DEFECT_ORDER;
    if (status == FOURLINK_OK && found->ratio > LONGEST_LINK)
        return FOURLINK_INFINITE_LINK;
    if (found->type == FOURLINK_CHANGE_POINT_SLIDER ||
        (found->type >= FOURLINK_PARALLELOGRAM && found->type <= FOURLINK_CHANGE_POINT_LINKAGE))
        return FOURLINK_NO_LINKAGE;
    for (i = 0; i < found->n_positions && status == FOURLINK_OK; i++)
        status = found->position[i].status;
    return status;
}

/* 1 if a is the better one: without defect; met within rounding, then with the larger mu_min; else with the
** smaller sum. */
static int is_better(const search *s, const candidate *a, const candidate *b)
{
    double exact = EXACT * (double)s->points.n;

    if (!a->defects != !b->defects)
        return !a->defects;
    if (a->trial.sum <= exact && b->trial.sum <= exact)
        return a->mu_min > b->mu_min;
    return a->trial.sum < b->trial.sum;
}

static int is_same(const search *s, const candidate *a, const candidate *b)
{
    int k;

    if (a->trial.sign != b->trial.sign ||
        (s->points.has_timing && a->trial.sense != b->trial.sense) ||
        a->trial.turns_fully != b->trial.turns_fully || a->is_swapped != b->is_swapped)
        return 0;
    for (k = 0; k < FLK_START; k++)
        if (!(fabs(a->trial.x[k] - b->trial.x[k]) <= SAME * (1 + fabs(a->trial.x[k]))))
            return 0;
    return 1;
}

/* Keep the trial in its place, if it is new, or better than one that is the same. */
static void keep(search *s, const candidate *c)
{
    unsigned long i;

    for (i = 0; i < s->n_kept && !is_same(s, &s->kept[i], c); i++)
        ;
    if (i < s->n_kept && !is_better(s, c, &s->kept[i]))
        return;
    if (i == s->n_kept && i == KEPT && !is_better(s, c, &s->kept[--i]))
        return;
    if (i == s->n_kept)
        s->n_kept++;
    for (; i > 0 && is_better(s, c, &s->kept[i - 1]); i--)
        s->kept[i] = s->kept[i - 1];
    s->kept[i] = *c;
}

/* 1 if all links have lengths within the bounds of the task. */
static int has_lengths(const fourlink_points_task *task, const fourlink_solution *found)
{
    const fourlink_link *link = found->design.link;
    int i;

    for (i = FOURLINK_GROUND; i <= FOURLINK_FOLLOWER; i++)
        if (link[i].length > 0 && (link[i].length < task->shortest ||
                                   (task->longest > 0 && link[i].length > task->longest)))
            return 0;
    return !(task->length_ratio > 0 && found->ratio > task->length_ratio);
}

/* Keep a linkage if it passes the checks, at last also those of the task's bounds; 0 if it does not. */
static int take_trial(search *s, const flk_trial *at, int is_swapped, int is_last)
{
    double least_mu = is_last ? s->task->mu_min : 0;
    candidate c;

    if (!(at->sum < GSL_POSINF) || check_trial(s, at, is_swapped, &s->checked) != FOURLINK_OK)
        return 0;
    c.trial = *at;
    c.is_swapped = is_swapped;
    c.defects = s->checked.defects;
    c.mu_min = s->checked.mu_min;
    if (!(c.mu_min >= GSL_MAX_DBL(least_mu, c.defects ? 0 : DEAD)) ||
        (is_last && !has_lengths(s->task, &s->checked)))
        return 0;
    keep(s, &c);
    return 1;
}

/* The sum that a start has to approach. */
static double promising(const search *s)
{
    unsigned long last = s->n_kept < BEST_ONES ? s->n_kept : BEST_ONES;

    if (s->n_kept < BEST_ONES || s->kept[last - 1].defects)
        return GSL_POSINF;
    return PROMISING * GSL_MAX_DBL(s->kept[last - 1].trial.sum, EXACT * (double)s->points.n);
}

/* Five poses: keep the linkages that meet them exactly. */
static void keep_exact(search *s)
{
    static const fourlink_branch branches[] = {FOURLINK_OPEN, FOURLINK_CROSSED};
    double links[FLK_LINKS][4];
    int n = flk_burmester(&s->points, links), i, j, k, both;

    both = s->task->left.is_given && s->task->right.is_given;
    for (i = 0; i < n; i++)
        for (j = 0; j < n; j++)
            for (k = 0; k < 2 * (1 + both) && i != j; k++) {
                flk_burmester_linkage(&s->points, links[i], links[j], &s->near);
                s->near.branch = branches[k % 2];
                s->near.is_swapped = k > 1;
                if (!set_near(s, &s->near) || !is_inside(s))
                    continue;
                flk_descend(&s->points, &s->trial, CLOSE_STEPS, CLOSELY);
                take_trial(s, &s->trial, s->is_swapped, 0);
            }
}

/* Descend with stiffer bounds of the transmission angle and the lengths until they hold. */
static void stiffen(search *s, flk_trial *at)
{
    flk_points *p = &s->points;

    for (p->stiffness = 10; p->is_bounded && p->stiffness < STIFFEST; p->stiffness *= 10)
        flk_descend(p, at, CLOSE_STEPS, CLOSELY);
    p->stiffness = 1;
}

static void run(search *s)
{
    unsigned long number, n;
    flk_trial *at;
    int is_near;

    pick_few(s);
    is_near = s->task->near && s->task->near->design.kind == s->points.kind &&
              (unsigned long)s->task->near->n_positions == s->points.n;
    s->n_starts = is_near ? 1 : STARTS * (s->task->effort ? s->task->effort : 1);
    if (!is_near && s->points.has_angle && !s->points.has_timing && s->points.n == FLK_POSES &&
        s->points.kind == FOURLINK_FOUR_BAR)
        keep_exact(s);
    for (number = 0; number < s->n_starts; number++) {
        if (!(is_near ? set_near(s, s->task->near) : set_start(s, number)))
            continue;
        if (!is_near)
            descend_roughly(s);
        if (!(s->trial.sum < promising(s)))
            continue;
        flk_descend(&s->points, &s->trial, CLOSE_STEPS, CLOSELY);
        take_trial(s, &s->trial, s->is_swapped, 0);
    }
    n = s->n_kept;
    memcpy(s->rough, s->kept, n * sizeof *s->kept);
    for (number = s->n_kept = 0; number < n; number++) {
        at = &s->rough[number].trial;
        set_pivots(s, s->rough[number].is_swapped);
        set_shape_bounds(&s->points, at->turns_fully, at->x[FLK_SHAPE] > 1);
        s->trial = *at;
        flk_descend(&s->points, at, FULL_STEPS, FULLY);
        stiffen(s, at);
        flk_settle(&s->points, at);
        flk_settle(&s->points, &s->trial);
        if (!take_trial(s, at, s->is_swapped, 1)) /* a link has become too long */
            take_trial(s, &s->trial, s->is_swapped, 1);
    }
}

/* Sum, root mean square and largest distance, m; largest error of the coupler's angle. */
static void measure_sizes(const search *s, fourlink_solution *found)
{
    double squares = 0, square;
    int i;

    for (i = 0; i < found->n_positions; i++) {
        const fourlink_precision *p = &found->position[i];

        square = gsl_pow_2(p->error);
        squares += square;
        square += gsl_pow_2(s->points.size * p->residual);
        found->sum += (s->task->weight ? s->task->weight[i] : 1) * square;
        found->largest = GSL_MAX_DBL(found->largest, p->error);
        if (fabs(p->residual) > fabs(found->max_error)) {
            found->max_error = p->residual;
            found->max_error_at = p->theta2;
        }
    }
    found->rms = sqrt(squares / found->n_positions);
}

int fourlink_synthesis_points(const fourlink_points_task *task, unsigned long max,
                              fourlink_solution *solutions, unsigned long *n)
{
    unsigned long i;
    search *s;
    int status;

    if (!task || !n || (max && !solutions))
        return FOURLINK_NULL;
    status = check_task(task);
    if (status == FOURLINK_OK)
        status = check_ground(&task->left);
    if (status == FOURLINK_OK)
        status = check_ground(&task->right);
    if (status != FOURLINK_OK)
        return status;
    s = calloc(1, sizeof *s);
    if (!s)
        return FOURLINK_NO_MEMORY;
    s->task = task;
    status = set_positions(s);
    if (status == FOURLINK_OK)
        run(s);
    if (status == FOURLINK_OK && s->n_kept == 0)
        status = FOURLINK_NONE_FOUND;
    for (i = 0; status == FOURLINK_OK && i < s->n_kept && i < max; i++) {
        check_trial(s, &s->kept[i].trial, s->kept[i].is_swapped, &solutions[i]);
        measure_sizes(s, &solutions[i]);
        solutions[i].starts = s->n_starts;
    }
    if (status == FOURLINK_OK)
        *n = s->n_kept;
    free(s);
    return status;
}
