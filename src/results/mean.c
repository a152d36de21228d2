/* SPDX-License-Identifier: GPL-3.0-or-later
**
** mean.c - integrals along the motion: mean and root mean square of a column, the turning moment.
*/
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include <gsl/gsl_math.h>

#include "base/scale.h"
#include "base/solve.h"
#include "mean.h"
#include "pole.h"

/* ------------------------------------------------------------------------------------------------- mean */

/* The mean and the root mean square of a column over the crank angles of a motion:
**
**    mean = (integral of y dtheta) / c,   rms = sqrt((integral of y^2 dtheta) / c)
**
** with c the angle of that part of the motion in which the column has a value.  Both are found together,
** and kept.  Each piece of the motion (samples.h) is integrated over the parameter s of follow.h, in which
** a root at its end is smooth, in wide parts.  A part in which the rule is not exact is halved, as beside a
** corner that the size of a vector has where it passes through zero.
**
** At a pole (pole.h) the column grows as distance^-m, y^k as distance^-km: its integral is infinite where
** k m >= 1.  At a dead position a velocity grows as distance^-1/2: it has a mean, but no finite rms.
*/

#define STEP (M_PI / 4) /* rad, of a part at first */
#define MOST_PARTS 2e4  /* of the whole motion, at first */
#define HALVINGS 2000   /* at most */
#define EXACT 1e-10     /* error of a part, relative to itself or to the whole */
#define ROUNDING 1e-6   /* relative error that rows can have near a pole, and a part of the whole */
#define SHORTEST 1e-10  /* part of a piece that is not halved any more, */
#define SHORTEST_OF_ANGLE \
    1e-9          /* ... of a direction, which is rounding where its vector vanishes, */
#define TO_END 15 /* parts of which each is half of the last, towards a pole of any order */
#define SHORTEST_AT_END 1e-4 /* at an end without a row */

#define NODES 15       /* of the rule, */
#define END_NODES 8    /* ... those on one side of a part */
#define END_GAP 0.0022 /* of the part: half of what lies between an end and its first node */

/* The integrals of 1, y, y^2. */
typedef struct moments {
    double of[3];
} moments;

typedef struct means {
    flk_samples x;
    const flk_sampled *c; /* the column, with its limits */
    flk_followed t;       /* t.last: value from which an angle continues; NaN: it starts anew */
    int is_rough;         /* 1: in the present part an angle jumps, or the rule is not exact */
    int signs
        [3]; /* FLK_POLE_UP, FLK_POLE_DOWN: by such poles the integral of this power is infinite */
    int halvings;
    flk_sample node[NODES]; /* the column at the nodes of the rule in the present part */
    int n_nodes;
    moments total, here; /* before, and since an angle started anew */
    double size[3];      /* integrals of magnitudes so far */
} means;

static double value_at(const means *m, double s)
{
    return flk_samples_smooth(&m->x, m->c, s);
}

/* Take a pole of an order, by which integrals are infinite. */
static void take_sign(means *m, double order, int sign)
{
    int k;

    for (k = 1; k <= 2; k++)
        if (k * order >= 1)
            m->signs[k] |= sign;
}

/* 1 if an angle jumps to a value, by whole turns next to the last one. */
static int jumps(const means *m, double value)
{
    return m->t.turn > 0 && !gsl_isnan(m->t.last) &&
           fabs(flk_followed_nearest(&m->t, value, m->t.last) - m->t.last) > m->t.turn / 6;
}

/* 1, y, y^2; 0 where there is no value. */
static void powers(double s, void *data, double *power)
{
    means *m = data;
    double value = value_at(m, s), rate = flk_follow_rate(&m->x.f, s);

    if (m->n_nodes < NODES) {
        m->node[m->n_nodes].x = s;
        m->node[m->n_nodes++].value = value;
    }
    if (gsl_isnan(value)) {
        value = rate = 0;
    } else if (fabs(value) >= m->t.bound) {
        take_sign(m, GSL_POSINF, value > 0 ? FLK_POLE_UP : FLK_POLE_DOWN);
        value = 0;
    } else {
        m->is_rough |= jumps(m, value);
        value = flk_followed_nearest(&m->t, value, m->t.last);
    }
    power[0] = rate;
    power[1] = value * power[0];
    power[2] = value * power[1];
}

static void take_pole(void *data, const flk_pole *pole)
{
    take_sign(data, pole->order, pole->signs);
}

static void add_moments(moments *sum, const moments *more, double times)
{
    int k;

    for (k = 0; k < 3; k++)
        sum->of[k] += times * more->of[k];
}

/* The moments of y + by. */
static void shift(moments *m, double by)
{
    m->of[2] += by * (2 * m->of[1] + by * m->of[0]);
    m->of[1] += by * m->of[0];
}

static void start_anew(means *m, double value)
{
    add_moments(&m->total, &m->here, 1);
    memset(&m->here, 0, sizeof m->here);
    m->t.last = value;
}

/* An angle at a parameter, or at an end without a row at one beside it; NaN of another column. */
static double angle_at(const means *m, double s)
{
    if (!(m->t.turn > 0))
        return GSL_NAN;
    if (s <= 0 && flk_follow_has_limit(m->x.f.piece.begin))
        s = 1e-3;
    else if (s >= 1 && flk_follow_has_limit(m->x.f.piece.end))
        s = 1 - 1e-3;
    return value_at(m, s);
}

/* Follow an angle to a parameter. */
static void follow_angle(means *m, double s)
{
    double value = angle_at(m, s);

    if (gsl_isnan(value))
        return;
    if (gsl_isnan(m->t.last) || flk_followed_turns_over(&m->t, m->t.last, value))
        start_anew(m, value);
    else
        m->t.last = flk_followed_nearest(&m->t, value, m->t.last);
}

/* 1 if a part must not be halved. */
static int is_shortest(const means *m, double from, double to)
{
    int at_end = (from <= 0 && flk_follow_has_limit(m->x.f.piece.begin)) ||
                 (to >= 1 && flk_follow_has_limit(m->x.f.piece.end));

    return to - from < (at_end ? SHORTEST_AT_END : m->t.turn > 0 ? SHORTEST_OF_ANGLE : SHORTEST);
}

/* The rounding error of y^power in a part: near its ends and in its middle, values beside one another are so
** far from a straight line. */
#define NOISE_STEP 1e-7 /* of the part */

static double noise_in_part(means *m, int power, double from, double to)
{
    static const double places[3] = {0.005, 0.5, 0.995};
    double step = NOISE_STEP * (to - from), noise = 0;
    int i, k;

    for (i = 0; i < 3; i++) {
        double y[3][3];

        for (k = 0; k < 3; k++)
            powers(from + places[i] * (to - from) + step * k, m, y[k]);
        flk_scale_take(&noise, y[0][power] - 2 * y[1][power] + y[2][power]);
    }
    return noise;
}

/* 1 if the error of a part is rounding error of the rows, which halving does not reduce.  It can be as
** large as the part's own integral, where a difference of large terms passes through 0.  That of a
** corner can be as small, and is reduced to about a quarter. */
static int is_rounding(means *m, int power, double from, double to, const flk_integral *part,
                       const flk_integral *both)
{
    return part->error <= ROUNDING * GSL_MAX_DBL(part->size, m->size[power]) &&
           part->error > both->error / 8 &&
           part->error <= (to - from) * noise_in_part(m, power, from, to);
}

/* 1 if the rule is exact for a part of a column, to rounding. */
static int is_exact(const flk_integral *part, double whole)
{
    return part->error <= EXACT * part->size || part->error <= EXACT * whole;
}

/* The rule does not see a corner between an end of a part and its first node: there the column is not
** what the nodes say.  Adds the integral of the difference to the errors. */
static void add_error_at_end(const means *m, double from, double to, int at_end, flk_integral *part)
{
    double end = at_end ? to : from, gap = END_GAP * (to - from) * flk_follow_rate(&m->x.f, end);
    double value, expected;
    flk_polynomial p;

    if (end <= 0 || end >= 1 || m->t.turn > 0)
        return;
    for (p.n = 0; p.n < END_NODES;) {
        const flk_sample *node = &m->node[at_end ? NODES - 1 - p.n : p.n];

        flk_polynomial_add(&p, node->x, node->value);
    }
    value = value_at(m, end);
    expected = flk_polynomial_value(&p, end);
    if (!gsl_finite(value) || !gsl_finite(expected))
        return;
    part[1].error += gap * fabs(value - expected);
    part[2].error += gap * fabs(value - expected) * fabs(value + expected);
}

/* Integrate a piece between two parameters.  `both` is null, or the integrals of the part of which this is
** one half. */
static void integrate(means *m, double from, double to, const flk_integral *both)
{
    double middle = 0.5 * (from + to);
    int shortest = is_shortest(m, from, to), k;
    flk_integral i[3];

    m->is_rough = jumps(m, angle_at(m, to));
    m->n_nodes = 0;
    flk_integrate(powers, m, 3, from, to, i);
    add_error_at_end(m, from, to, 0, i);
    add_error_at_end(m, from, to, 1, i);
    for (k = 1; k <= 2; k++) {
        m->size[k] += i[k].size - (both ? both[k].size / 2 : 0);
        m->is_rough |= !m->signs[k] && !is_exact(&i[k], m->size[k]) &&
                       !(both && is_rounding(m, k, from, to, &i[k], &both[k]));
    }
    if (m->is_rough && !shortest && !m->t.is_noise && m->halvings < HALVINGS &&
        !flk_follow_is_over(&m->x.f)) {
        m->halvings++;
        integrate(m, from, middle, i);
        integrate(m, middle, to, i);
        return;
    }
    for (k = 0; k < 3; k++)
        m->here.of[k] += i[k].value;
    follow_angle(m, to);
}

/* 1 if the column grows towards an end as no power of the root of the distance: by a load with an
** exponent. */
static int has_broken_power(const means *m, int at_end)
{
    const flk_limit *l = &m->c->limit[at_end];

    return gsl_isinf(l->value) && l->is_root &&
           fabs(2 * l->growth - floor(2 * l->growth + 0.5)) > 0;
}

/* The limit of a sequence, by three numbers of its members: one of them may be off by a denominator that
** is small by chance. */
static double median_limit(const double *of)
{
    double copy[TO_END], limit[3];
    int k;

    for (k = 0; k < 3; k++) {
        memcpy(copy, of, sizeof copy);
        limit[k] = flk_limit_of_sequence(copy, TO_END - 2 * k);
    }
    return GSL_MAX_DBL(GSL_MIN_DBL(limit[0], limit[1]),
                       GSL_MIN_DBL(GSL_MAX_DBL(limit[0], limit[1]), limit[2]));
}

/* Integrate such a part of a piece at its end, by parts of which each is half as wide as the one before.  The
** integrals up to them approach that of the whole by powers of the width, each in a geometric sequence. */
static void integrate_to_end(means *m, double from, double to, int at_end)
{
    double sums[3][TO_END], before[3], width = to - from;
    int j, k;

    memcpy(before, m->here.of, sizeof before);
    for (j = 0; j < TO_END; j++) {
        width /= 2;
        integrate(m, at_end ? to - 2 * width : from + width, at_end ? to - width : from + 2 * width,
                  NULL);
        for (k = 0; k < 3; k++)
            sums[k][j] = m->here.of[k] - before[k];
    }
    for (k = 0; k < 3; k++)
        m->here.of[k] = before[k] + median_limit(sums[k]);
}

/* 1 if the results are known: no mean, an infinite root mean square. */
static int is_done(const means *m)
{
    return m->signs[1] == (FLK_POLE_UP | FLK_POLE_DOWN) || flk_follow_is_over(&m->x.f);
}

static void integrate_piece(means *m)
{
    const flk_piece *p = &m->x.f.piece;
    double n = 2 + floor((p->to - p->from) / GSL_MAX_DBL(STEP, m->x.f.motion.length / MOST_PARTS)),
           i;

    m->x.f.a->is_fast = !m->t.is_noise;
    follow_angle(m, 0);
    for (i = 0; i < n && !m->signs[1] && !flk_follow_is_over(&m->x.f); i++) {
        int is_first = i == 0 && has_broken_power(m, 0),
            is_last = i == n - 1 && has_broken_power(m, 1);

        if (is_first || is_last)
            integrate_to_end(m, i / n, (i + 1) / n, is_last);
        else
            integrate(m, i / n, (i + 1) / n, NULL);
    }
}

/* Of a motion that repeats, the first period counts for all that are skipped. */
static void integrate_motion(means *m)
{
    double periods;
    int has_gap = 0, is_first = 1;

    for (; !is_done(m) && flk_samples_next(&m->x); is_first = 0) {
        if (m->x.is_reached) {
            flk_poles_find(&m->x, m->c, take_pole, m);
            if (is_first) {
                follow_angle(m, 0);
                m->t.first = m->t.last;
            }
            integrate_piece(m);
        } else {
            start_anew(m, GSL_NAN);
            has_gap = 1;
        }
        periods = m->x.is_whole ? flk_follow_skips(&m->x.f) : 0;
        if (periods > 0) {
            add_moments(&m->total, &m->total, periods);
            add_moments(&m->here, &m->here, periods);
        }
    }
    if (has_gap)
        shift(&m->here, flk_followed_behind_gap(&m->t, &m->x.f));
    add_moments(&m->total, &m->here, 1);
}

static void begin_mean(means *m, const flk_samples_room *room, flk_analysis *a, const flk_column *c,
                       fourlink_branch branch)
{
    int flags = flk_column_flags(c);

    memset(m, 0, sizeof *m);
    flk_samples_begin(&m->x, room, a, branch);
    flk_samples_add(&m->x, c);
    m->c = &m->x.columns[0];
    m->t = m->c->of;
    if (flags & FOURLINK_OF_CRANK)
        m->t.turn = 0; /* it goes on by itself */
    if (m->t.turn > 0 || (flags & FOURLINK_OF_CRANK))
        flk_follow_all(&m->x.f); /* it does not repeat */
}

static void take_instant(means *m, flk_mean *found)
{
    double value;
    flk_row row;

    flk_follow_row(&m->x.f, flk_column_need(m->t.c), 0, &row);
    value = flk_column_value(m->t.c, &row);
    if (row.at.status != FOURLINK_OK && gsl_isnan(value))
        found->status[0] = found->status[1] = row.at.status;
    found->value[0] = value;
    found->value[1] = fabs(value);
}

/* What the integrals say. */
static void take_moments(const means *m, flk_mean *found)
{
    const double *total = m->total.of;
    int k;

    if (m->signs[1] == (FLK_POLE_UP | FLK_POLE_DOWN))
        found->status[0] = FOURLINK_NO_MEAN;
    for (k = 0; k < 2; k++)
        if (!m->signs[k + 1] && !(total[0] > 0))
            found->status[k] = FOURLINK_NOT_REACHED;
    found->value[0] = m->signs[1] == FLK_POLE_DOWN ? GSL_NEGINF
                      : m->signs[1]                ? GSL_POSINF
                                                   : total[1] / total[0];
    found->value[1] = m->signs[2] ? GSL_POSINF : sqrt(total[2] / total[0]);
}

static void find_means(flk_analysis *a, const flk_samples_room *room, const flk_column *c,
                       fourlink_branch branch, flk_mean *found)
{
    means m;

    begin_mean(&m, room, a, c, branch);
    if (m.x.f.motion.length > 0)
        integrate_motion(&m);
    a->is_fast = 0;
    if (!(m.x.f.motion.length > 0))
        take_instant(&m, found);
    else if (flk_follow_is_over(&m.x.f))
        found->status[0] = found->status[1] = FOURLINK_LONG_SEARCH;
    else
        take_moments(&m, found);
}

int flk_means_open(flk_analysis *a, size_t most)
{
    a->means = calloc(2 * most, sizeof *a->means);
    return a->means != NULL;
}

int flk_mean_find(flk_analysis *a, const flk_samples_room *room, const flk_column *c,
                  fourlink_branch branch, flk_statistic statistic, double *mean)
{
    flk_mean *found = &a->means[2 * c->number + (branch == FOURLINK_OPEN ? 0 : 1)];
    int k = statistic == FLK_MEAN ? 0 : 1;

    if (!found->is_known && flk_course_stops(&a->course, branch))
        found->status[0] = found->status[1] = FOURLINK_TOO_LONG;
    else if (!found->is_known)
        find_means(a, room, c, branch, found);
    found->is_known = 1;
    if (found->status[k] == FOURLINK_OK)
        *mean = found->value[k];
    return found->status[k];
}

/* --------------------------------------------------------------------------------------- turning moment */

/* With T = -Ts the turning moment, Tm its mean over the cycle of angle c, and the load torque equal to Tm,
** the flywheel takes up the difference:
**
**    E(theta) = integral of (T - Tm) dtheta,    dE = max E - min E
**
** along the motion: for a clockwise crank from greater angles to smaller ones.
**
**    coefficient of fluctuation of energy dE / (Tm c),   of speed Cs = dE / (I omega^2)
**
** For an actual motion omega is its mean speed, and I is that of the flywheel and of the motor's rotor.
**
** The cycle is cut every 30 degrees and wherever a load's curve or window has a corner; in such a piece the
** moment is smooth, and Gauss and Kronrod's rule is exact to rounding or the piece is halved.  E has its
** extremes at the corners and where T crosses Tm, which is sought from degree to degree.
*/

#define DEGREE (M_PI / 180)
#define MOST_DEGREES 100000
#define PIECE 30                /* degrees */
#define INSIDE 1e-10            /* rad, from a corner into the piece beside it */
#define HALVINGS_OF_MOMENT 1000 /* of pieces, at most */
#define SHORTEST_OF_MOMENT 1e-9 /* rad: no piece is halved below it */
#define ROUGH 1e-8              /* a smooth piece is exact to 1e-13 if its rules agree to this */
#define FINE 1e-13  /* of the largest moment over the cycle: less need not be found in a piece */
#define FINEST 1e-6 /* rad: a kink, where friction turns round, is not cut more finely */

typedef struct moment {
    flk_analysis *a;
    fourlink_branch branch;
    fourlink_crank crank;
    double mean, without; /* of T, and of the moment without friction */
    double *cuts;         /* rad, rising: the ends of the pieces */
    double *work;         /* N m rad, of T in each piece */
    size_t n_cuts;
} moment;

/* At a crank angle, rad, T, and that of the machine without friction; NaN where the links do not reach. */
static void moment_at(double angle, void *data, double *T)
{
    moment *m = data;
    flk_row row;

    m->crank.theta2 = angle - m->a->d->motion.x_at;
    flk_analysis_at(m->a, NEED_FORCES, m->branch, &m->crank, &row);
    T[0] = row.at.status == FOURLINK_OK ? -row.at.forces.Ts : GSL_NAN;
    T[1] =
        row.at.status == FOURLINK_OK && m->a->d->machine.has_friction ? -row.at.losses.Ts0 : T[0];
}

/* T - Tm */
static double excess(double angle, void *data)
{
    double T[FLK_INTEGRALS];

    moment_at(angle, data, T);
    return T[0] - ((const moment *)data)->mean;
}

/* 1 if the crank turns at one speed, or its steady motion has a mean speed. */
static int has_speed(const deck *d)
{
    if (d->mode.kind != MODE_GIVEN)
        return d->mode.kind == MODE_STEADY;
    return d->motion.speed != 0 && d->motion.acceleration == 0;
}

/* Pieces of the cycle, without corners; 0 if there is no turning moment. */
static size_t turning_pieces(const deck *d)
{
    double degrees = floor(d->machine.cycle / DEGREE + 0.5);

    return !d->has_forces || d->machine.mechanism.drive || !has_speed(d) || degrees < 1 ||
                   degrees > MOST_DEGREES
               ? 0
               : (size_t)ceil(degrees / PIECE);
}

/* The most pieces that there can be. */
static size_t most_cuts(const flk_analysis *a)
{
    return turning_pieces(a->d) + 1 + HALVINGS_OF_MOMENT +
           flk_corners_most(a->course.corners, a->d->machine.cycle);
}

int flk_turning_open(flk_analysis *a)
{
    if (!turning_pieces(a->d))
        return 1;
    a->turning_memory = malloc(2 * most_cuts(a) * sizeof *a->turning_memory);
    return a->turning_memory != NULL;
}

/* The pieces of the cycle: equal ones, and the corners between them. */
static void cut(moment *m)
{
    double cycle = m->a->d->machine.cycle, corner, end, at = 0;
    size_t n = turning_pieces(m->a->d), i;
    flk_direction direction;
    flk_piece_end what;

    direction.corners = m->a->course.corners;
    direction.branch = m->branch;
    direction.from = 0 - m->a->d->motion.x_at;
    direction.sense = direction.has_loads = 1;
    m->cuts[m->n_cuts++] = 0;
    for (i = 1; i <= n; i++, at = end) {
        end = i < n ? cycle * (double)i / (double)n : cycle;
        while ((corner = flk_corners_next(&direction, at, NULL, 0, &what)) <
               end - FLK_CORNERS_CLOSE(end))
            m->cuts[m->n_cuts++] = at = corner;
        m->cuts[m->n_cuts++] = end;
    }
}

/* Halve piece i. */
static void halve(moment *m, size_t i)
{
    size_t n = m->n_cuts - i - 1;

    memmove(m->cuts + i + 2, m->cuts + i + 1, n * sizeof *m->cuts);
    m->cuts[i + 1] = 0.5 * (m->cuts[i] + m->cuts[i + 2]);
    m->n_cuts++;
}

/* The mean over the cycle; NaN if the moment is not defined all round.  A piece in which the rule is not
** exact is halved: near a change point the moment has a peak far narrower than a degree, and where friction
** turns round a kink.  Where that does
** not end, the moment is unbounded. */
static double mean_of(moment *m, double *scale)
{
    size_t most = most_cuts(m->a), i = 0;
    double sum = 0;
    int is_rough;

    *scale = 0;
    while (i + 1 < m->n_cuts) {
        double T = excess(m->cuts[i] + INSIDE, m), length = m->cuts[i + 1] - m->cuts[i];
        flk_integral work[2];

        flk_integrate(moment_at, m, 2, m->cuts[i], m->cuts[i + 1], work);
        if (gsl_isnan(T) || gsl_isnan(work[0].value))
            return GSL_NAN;
        *scale = GSL_MAX_DBL(*scale, fabs(T));
        is_rough = work[0].error > ROUGH * (work[0].size + *scale * length);
        if (is_rough && (m->n_cuts == most || length < SHORTEST_OF_MOMENT))
            return GSL_NAN;
        if (is_rough || (work[0].error > FINE * *scale * m->a->d->machine.cycle &&
                         m->n_cuts < most && length > FINEST)) {
            halve(m, i);
            continue;
        }
        m->work[i++] = work[0].value;
        sum += work[0].value;
        m->without += work[1].value / m->a->d->machine.cycle;
    }
    return sum / m->a->d->machine.cycle;
}

/* The energy that the flywheel has taken up, at a corner or a crossing. */
typedef struct energy {
    double E, least, greatest;
    double from, E_from; /* where the present area began */
} energy;

static void take_up(energy *e, double dE)
{
    e->E += dE;
    e->least = e->E < e->least ? e->E : e->least;
    e->greatest = e->E > e->greatest ? e->E : e->greatest;
}

static void end_area(const moment *m, energy *e, double at, fourlink_turning *t)
{
    if (t->n_areas < FOURLINK_AREAS) {
        fourlink_area *new = &t->area[t->n_areas++];

        new->from = e->from;
        new->to = at;
        new->energy = m->crank.omega2 < 0 ? e->E_from - e->E : e->E - e->E_from;
    }
    e->from = at;
    e->E_from = e->E;
}

/* Take up the energy of a piece; an area ends at each crossing in it. */
static void take_up_piece(moment *m, size_t i, energy *e, int *is_below, fourlink_turning *t)
{
    double from = m->cuts[i], to = m->cuts[i + 1], taken = 0;
    int n = (int)ceil((to - from) / DEGREE - INSIDE), k;
    flk_sample low, high;

    low.x = from + INSIDE;
    low.value = excess(low.x, m);
    if ((low.value < 0) != *is_below) /* a jump */
        end_area(m, e, from, t);
    *is_below = low.value < 0;
    for (k = 1; k <= n; k++, low = high) {
        high.x = k < n ? from + (to - from) * k / n : to - INSIDE;
        high.value = excess(high.x, m);
        if ((high.value < 0) != *is_below) {
            flk_bracket b = flk_bracket_of(low.x, high.x, low.value, high.value);
            double at = flk_find_zero(excess, m, &b, 0);
            flk_integral work;

            flk_integrate(moment_at, m, 1, from, at, &work);
            work.value -= m->mean * (at - from);
            take_up(e, work.value - taken);
            end_area(m, e, at, t);
            taken = work.value;
            *is_below = high.value < 0;
        }
    }
    take_up(e, m->work[i] - m->mean * (to - from) - taken);
}

static double fluctuation_of_energy(moment *m, fourlink_turning *t)
{
    energy e = {0, 0, 0, 0, 0};
    int is_below = excess(m->cuts[0] + INSIDE, m) < 0;
    size_t i;

    for (i = 0; i + 1 < m->n_cuts; i++)
        take_up_piece(m, i, &e, &is_below, t);
    end_area(m, &e, m->a->d->machine.cycle, t);
    return e.greatest - e.least;
}

static void find_turning(moment *m, double scale, fourlink_turning *t)
{
    const deck *d = m->a->d;
    const flk_actual_facts *actual = flk_actual_facts_of(m->a->course.actual, m->branch);
    double omega = m->crank.omega2, inertia = actual ? actual->inertia : d->machine.flywheel;

    if (fabs(m->mean) <= 1e-12 * scale)
        m->mean = 0;
    t->n_areas = 0;
    t->mean_torque = m->mean;
    t->mean_power = m->mean * omega;
    t->energy_fluctuation = fluctuation_of_energy(m, t);
    t->has_coefficient = m->mean != 0;
    t->energy_coefficient =
        m->mean != 0 ? t->energy_fluctuation / fabs(m->mean * d->machine.cycle) : 0;
    t->inertia = actual ? actual->flywheel : d->machine.flywheel;
    t->fluctuation = actual ? 0 : d->flywheel_fluctuation;
    if (inertia > 0)
        t->fluctuation = t->energy_fluctuation / (inertia * omega * omega);
    else if (t->fluctuation > 0)
        t->inertia = t->energy_fluctuation / (t->fluctuation * omega * omega);
}

/* Work without friction over work with it, if the crank drives; if it is driven, the reverse.  Undefined if
** there is no work. */
static double efficiency_of(const moment *m)
{
    double sense = m->crank.omega2 < 0 ? 1 : -1;
    double with = sense * m->mean, without = sense * m->without;

    if (with > 0)
        return without > 0 ? without / with : 0;
    return without < 0 ? with / without : with == without ? FLK_UNDEFINED : 0;
}

const fourlink_turning *flk_turning_find(flk_analysis *a, fourlink_branch branch)
{
    flk_turning *t = &a->turning[branch == FOURLINK_OPEN ? 0 : 1];
    int was_fast = a->is_fast;
    double scale;
    moment m;

    if (t->is_known || !a->turning_memory)
        return t->is_there ? &t->t : NULL;
    m.a = a;
    m.branch = branch;
    m.crank.theta2 = 0;
    m.crank.omega2 = flk_analysis_mean_speed(a, branch);
    m.crank.alpha2 = 0;
    m.mean = m.without = 0;
    m.cuts = a->turning_memory;
    m.work = m.cuts + most_cuts(a);
    m.n_cuts = 0;
    t->is_known = 1;
    if (!gsl_finite(m.crank.omega2))
        return NULL;
    a->is_fast = 1;
    cut(&m);
    m.mean = mean_of(&m, &scale);
    t->is_there = !gsl_isnan(m.mean);
    if (t->is_there)
        find_turning(&m, scale, &t->t);
    if (t->is_there && a->d->machine.has_friction)
        t->efficiency = efficiency_of(&m);
    a->is_fast = was_fast;
    return t->is_there ? &t->t : NULL;
}
