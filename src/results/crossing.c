/* SPDX-License-Identifier: GPL-3.0-or-later
**
** crossing.c - the crank angles at which a column has a value.
**
** The column is sampled piece by piece (samples.c), closer beside the ends of a piece, poles and samples
** without a value.  Between two samples on different sides of the value, base/solve finds the zero of
** the difference.  Where three samples approach the value and turn back, their extreme may touch it.  At
** whatever place that leads to, the row itself must have the value: a jump across it is no crossing,
** neither of a load, nor through infinity, nor of an angle by half a turn.
*/
#include <float.h>
#include <math.h>
#include <string.h>

#include <gsl/gsl_math.h>

#include "base/solve.h"
#include "mechanics/mechanics.h"
#include "crossing.h"
#include "pole.h"

#define EXACT 1e-9      /* of the scale of the row: closer, it has the value */
#define CONTINUOUS 1e-6 /* ... a smaller step from piece to piece is no jump */
#define SAME 1e-7       /* rad: closer crank angles are the same */
#define LEVEL 1e-11 /* of the size of its quantity in a row: so much a constant column may vary */

/* Samples here are of the column minus the value sought; NaN: it is undefined. */
typedef struct crossings {
    flk_samples x;
    flk_sampled *c;
    double value;
    double side; /* 1 or -1: the side of the present samples */
    double first,
        last; /* rad passed at the first and the last crossing found; of another input, crank angles */
    double last_passed;
    int was_level; /* 1: the column has the value throughout the last piece */
    unsigned long max, n;
    double *angles;
} crossings;

/* A value of the column minus the value sought; for an angle, to the nearest turn. */
static double off_of(const crossings *k, double value)
{
    double off = value - k->value;

    if (!(fabs(off) < k->c->of.bound))
        return GSL_NAN;
    return flk_followed_nearest(&k->c->of, off, 0);
}

static double off_at(double s, void *data)
{
    const crossings *k = data;

    return off_of(k, flk_samples_value(&k->x, k->c, s, GSL_NAN));
}

/* The same of the row as it is printed, and the row; by the limit of the column where there is none. */
static double off_of_row(double s, crossings *k, flk_row *row)
{
    double off;

    k->x.f.a->is_fast = 0;
    flk_follow_row(&k->x.f, flk_column_need(k->c->of.c), flk_follow_corner(&k->x.f, s), row);
    k->x.f.a->is_fast = 1;
    off = off_of(k, flk_column_value(k->c->of.c, row));
    return gsl_isnan(off) && flk_samples_is_at_limit(&k->x, s) ? off_at(s, k) : off;
}

static double off_at_row(double s, void *data)
{
    flk_row row;

    return off_of_row(s, data, &row);
}

/* The scale of a row: the largest magnitude of the column's quantity in it, of what is computed for the
** column. A column can be alone of its quantity, or the others 0: for the value 0 it counts too how far
** the column is from it around the row. */
static double scale_of(const crossings *k, const flk_row *row, double around)
{
    const flk_column *c = k->c->of.c;
    flk_column other;
    double scale = k->value != 0 ? fabs(k->value) : around;
    size_t i;

    if (k->c->of.turn > 0)
        return k->c->of.turn;
    for (i = 0; i < flk_column_limit(k->x.f.a->d); i++)
        if (flk_column_number(k->x.f.a, i, &other) &&
            flk_column_quantity(&other) == flk_column_quantity(c) &&
            !(flk_column_need(&other) & ~flk_column_need(c))) {
            double size = fabs(flk_column_value(&other, row));

            scale = size > scale && gsl_finite(size) ? size : scale;
        }
    return scale;
}

/* The column minus the value in the row at a crank angle, as it is printed; the row's status. */
static int find_at_angle(double angle, crossings *k, double *off, flk_row *row)
{
    int is_there;

    k->x.f.a->is_fast = 0;
    is_there =
        flk_analysis_at_angle(k->x.f.a, flk_column_need(k->c->of.c), k->x.f.branch, angle, row);
    k->x.f.a->is_fast = 1;
    *off = GSL_NAN;
    if (!is_there)
        return FOURLINK_NO_SUCH_ANGLE;
    if (row->at.status == FOURLINK_OK)
        *off = off_of(k, flk_column_value(k->c->of.c, row));
    return row->at.status;
}

static double off_at_angle(double angle, void *data)
{
    flk_row row;
    double off;

    find_at_angle(angle, data, &off, &row);
    return off;
}

/* The crank angle of a crossing at a place of another input.  Near a dead centre of that the column
** changes much from one value of the input to the next that there is, over which crank angles have many. */
#define NEXT (16 * DBL_EPSILON) /* of the largest value */

static double crank_angle(crossings *k, double place)
{
    double least, most, next, from, to, before, behind;
    flk_bracket b;

    flk_follow_ends(&k->x.f, place, &least, &most);
    next = NEXT * GSL_MAX(fabs(least), fabs(most));
    from = flk_follow_crank(&k->x.f, GSL_MAX(place - next, least));
    to = flk_follow_crank(&k->x.f, GSL_MIN(place + next, most));
    before = off_at_angle(from, k);
    behind = off_at_angle(to, k);
    if (!(before * behind < 0)) /* or one is NaN */
        return flk_follow_crank(&k->x.f, place);
    b = from < to ? flk_bracket_of(from, to, before, behind)
                  : flk_bracket_of(to, from, behind, before);
    return flk_find_zero(off_at_angle, k, &b, 0);
}

/* Keep the crossing at a parameter, if the row as it is printed has the value and it is not the last crossing
** found. */
static void keep_crossing(crossings *k, double s, double around)
{
    double passed = flk_follow_corner(&k->x.f, s), off;
    double angle = flk_follow_place(&k->x.f, passed), at = passed;
    int is_prescribed = k->x.f.a->d->prescribed != NULL;
    flk_row row;

    if (is_prescribed) {
        angle = crank_angle(k, angle);
        at = angle * k->x.f.a->d->motion.angle_unit;
    }
    if (fabs(at - k->last) < SAME)
        return;
    if (!is_prescribed || find_at_angle(angle, k, &off, &row) != FOURLINK_OK)
        off = off_of_row(s, k, &row);
    if (FLK_SINE(&row.at.state) < FLK_SAMPLES_NEAR_LINE || flk_sampled_is_rounded(k->c, passed))
        around = 0; /* the values around the row are no smoother than it is */
    if (!(fabs(off) <= EXACT * scale_of(k, &row, around)))
        return;
    if (k->n < k->max)
        k->angles[k->n] = angle;
    k->first = k->n == 0 ? at : k->first;
    k->last = at;
    k->last_passed = passed;
    k->n++;
}

/* 1 if between two samples an angle passes the point half a turn from the value. */
static int turns_over(const crossings *k, const flk_sample *a, const flk_sample *b)
{
    return k->c->of.turn > 0 && fabs(a->value - b->value) > 0.5 * k->c->of.turn;
}

static void search_step(crossings *k, const flk_sample *a, const flk_sample *b, double around)
{
    flk_bracket bracket;

    if (gsl_isnan(a->value) || gsl_isnan(b->value) || turns_over(k, a, b) ||
        (a->value < 0) == (b->value < 0))
        return;
    bracket = flk_bracket_of(a->x, b->x, a->value, b->value);
    keep_crossing(k, flk_find_zero(off_at_row, k, &bracket, 0), around);
}

/* How far the column is beyond the value, seen from the side of the samples. */
static double beyond(double s, void *data)
{
    crossings *k = data;

    return -k->side * off_at(s, k);
}

/* Three samples on one side of the value approach it and turn back: between them the column may touch the
** value, or cross it twice. */
static void search_turn(crossings *k, const flk_sample *a, const flk_sample *b, const flk_sample *c)
{
    double sign = b->value < 0 ? -1 : 1;
    flk_sample p[3], near;
    double around;
    int i;

    if (sign * a->value < 0 || sign * c->value < 0 || !(fabs(b->value) < fabs(a->value)) ||
        !(fabs(b->value) <= fabs(c->value))) /* or one of them is NaN */
        return;
    k->side = sign;
    p[0] = *a;
    p[1] = *b;
    p[2] = *c;
    for (i = 0; i < 3; i++)
        p[i].value *= -sign;
    near = flk_find_peak(beyond, k, p, 0);
    near.value *= -sign;
    around = GSL_MIN_DBL(fabs(a->value), fabs(c->value));
    if (fabs(near.value) <= EXACT * GSL_MAX_DBL(around, fabs(k->value)))
        keep_crossing(k, near.x, around);
    else {
        search_step(k, a, &near, around);
        search_step(k, &near, c, around);
    }
}

/* How far the column is from the value on one side of sample i: at the first sample from there that is not
** too close to the angle `passed`, or at the one beyond it.  Infinite if the piece ends before. */
#define DISTANCE 0.005 /* rad */

static double off_beyond(const crossings *k, double passed, size_t i, int direction)
{
    const flk_piece *p = &k->x.f.piece;
    double distance = GSL_MIN_DBL(DISTANCE, (p->to - p->from) / 4), off = 0;
    int n;

    while (i < k->x.n && fabs(flk_follow_corner(&k->x.f, k->x.s[i]) - passed) < distance)
        i += (size_t)direction;
    if (i >= k->x.n)
        return GSL_POSINF;
    for (n = 0; n < 2 && i < k->x.n; n++, i += (size_t)direction) {
        double here = fabs(off_of(k, k->c->v[i]));

        off = here > off ? here : off;
    }
    return off;
}

/* How far the column is from the value around samples i and i + 1: the smaller distance of both sides,
** since one can lead to a pole; around an end of the piece. */
static double around_step(const crossings *k, size_t i)
{
    double from = flk_follow_corner(&k->x.f, k->x.s[i]);
    double to = flk_follow_corner(&k->x.f, k->x.s[i + 1]);
    double off = GSL_MIN_DBL(off_beyond(k, to, i, -1), off_beyond(k, from, i + 1, 1));

    return gsl_finite(off) ? off : 0;
}

static double around_end(const crossings *k, int at_end)
{
    double off = at_end ? off_beyond(k, k->x.f.piece.to, k->x.n - 1, -1)
                        : off_beyond(k, k->x.f.piece.from, 0, 1);

    return gsl_finite(off) ? off : 0;
}

/* Where samples have no value, since rows are close to rounding error, take that of the row. */
static void take_row(crossings *k, size_t i)
{
    double s = k->x.s[i], off;

    if (!gsl_isnan(k->c->v[i]) || s <= 0 || s >= 1)
        return;
    off = off_at_row(s, k);
    k->c->v[i] = off + k->value;
}

/* Insert a sample, or its row, before sample i; 0 if there is no room. */
static int insert_row(crossings *k, size_t i, double s)
{
    if (!flk_samples_insert(&k->x, i, s))
        return 0;
    take_row(k, i);
    return 1;
}

/* Insert samples from sample i towards its neighbour on one side, up to the last place with a value: the
** neighbour has none.  Returns how many were inserted. */
#define HALVINGS 25

static size_t close_gap(crossings *k, size_t i, int before)
{
    double with = k->x.s[i], without = k->x.s[before ? i - 1 : i + 1];
    size_t n = 0, at = before ? i : i + 1;
    int h;

    for (h = 0; h < HALVINGS; h++) {
        double s = 0.5 * (with + without);

        if (gsl_isnan(off_at_row(s, k))) {
            without = s;
            continue;
        }
        if (!insert_row(k, at, s))
            break;
        with = s;
        n++;
        at += !before;
    }
    return n;
}

typedef struct pole {
    crossings *k;
    double sign;
} pole;

static double side_of_pole(double s, void *data)
{
    const pole *p = data;
    double value = flk_samples_value(&p->k->x, p->k->c, s, GSL_NAN);

    return p->sign * value < 0 ? GSL_NEGINF : GSL_POSINF;
}

/* Insert samples on both sides of a pole between samples i and i + 1, over which the column changes its
** sign. */
static void bound_pole(crossings *k, size_t i)
{
    const double *s = k->x.s, *v = k->c->v;
    flk_bracket b;
    double size = fabs(v[i]) + fabs(v[i + 1]);
    pole p;

    if (!gsl_finite(k->c->of.bound) || !(v[i] * v[i + 1] < 0))
        return;
    p.k = k;
    p.sign = v[i] < 0 ? 1 : -1;
    b = flk_bracket_of(s[i], s[i + 1], GSL_NEGINF, GSL_POSINF);
    flk_find_zero(side_of_pole, &p, &b, 0);
    if (fabs(flk_samples_value(&k->x, k->c, b.low, GSL_NAN)) > size && insert_row(k, i + 1, b.low))
        insert_row(k, i + 2, b.high);
}

/* Poles between samples, by what they divide by: beside some the column is 0 before the next sample, and
** its samples have one sign. */
#define POLES 100     /* of a piece, at most */
#define BESIDE_POLE 8 /* halvings of the distance to the samples beside it */

typedef struct poles {
    double s[POLES];
    size_t n;
} poles;

static void keep_pole(void *data, const flk_pole *found)
{
    poles *p = data;

    if (p->n < POLES && found->s > 0 && found->s < 1)
        p->s[p->n++] = found->s;
}

/* Insert samples on both sides of each. */
static void insert_beside_poles(crossings *k)
{
    const double *s = k->x.s;
    size_t i = 0, j;
    double low, high;
    poles p;

    p.n = 0;
    if (gsl_finite(k->c->of.bound))
        flk_poles_find(&k->x, k->c, keep_pole, &p);
    for (j = 0; j < p.n; j++) {
        while (i + 2 < k->x.n && s[i + 1] <= p.s[j])
            i++;
        low = p.s[j] - ldexp(p.s[j] - s[i], -BESIDE_POLE);
        high = p.s[j] + ldexp(s[i + 1] - p.s[j], -BESIDE_POLE);
        if (s[i] < low && low < high && high < s[i + 1] && insert_row(k, i + 1, low))
            insert_row(k, i + 2, high);
    }
}

/* 1 if between samples i and i + 1 the column may turn unseen: its slope changes much. */
#define MUCH 4

static int is_bent(const crossings *k, size_t i)
{
    const double *v = k->c->v;
    double least = GSL_POSINF, most = 0;
    size_t j;

    for (j = i > 0 ? i - 1 : 0; j < i + 2 && j + 1 < k->x.n; j++) {
        double d = fabs(v[j + 1] - v[j]);

        least = GSL_MIN_DBL(least, d);
        most = GSL_MAX_DBL(most, d);
    }
    return most > MUCH * least;
}

/* Insert a sample where a vector has its least size between samples i and i + 1, which show only that it
** turns. */
static void insert_least_size(crossings *k, size_t i)
{
    double s;

    if (flk_samples_find_least_size(&k->x, k->c, i, &s))
        insert_row(k, i + 1, s);
}

static int has_value(const crossings *k, size_t i)
{
    return fabs(k->c->v[i]) < k->c->of.bound;
}

/* Insert samples where the column may approach the value unseen: close to the ends of the piece, where
** no sample shows that it turns, where its slope changes much, up to samples without a value, and beside
** poles. */
#define PARTS 4
#define BESIDE_END (1.0 / 16) /* of the step */

static void insert_samples(crossings *k)
{
    flk_samples *x = &k->x;
    const double *s = x->s;
    size_t i;

    for (i = 0; i < x->n; i++)
        take_row(k, i);
    if (x->n < 2)
        return;
    insert_beside_poles(k);
    for (i = x->n - 1; i-- > 0;) {
        double from = s[i], to = s[i + 1];
        int part = is_bent(k, i) ? PARTS : 1;

        while (--part > 0)
            insert_row(k, i + 1, from + (to - from) * part / PARTS);
    }
    insert_row(k, 1, s[0] + BESIDE_END * (s[1] - s[0]));
    insert_row(k, x->n - 1, s[x->n - 1] - BESIDE_END * (s[x->n - 1] - s[x->n - 2]));
    for (i = x->n - 1; i-- > 0 && k->c->vector[0] && !(k->c->of.turn > 0);)
        insert_least_size(k, i);
    for (i = 0; i + 1 < x->n; i++) {
        if (has_value(k, i) && has_value(k, i + 1))
            bound_pole(k, i);
        if (has_value(k, i) != has_value(k, i + 1))
            i += close_gap(k, has_value(k, i) ? i : i + 1, !has_value(k, i));
    }
}

/* How large the column's quantity is in the row of a sample or, if there is none, in the middle of the
** piece: a column that is 0 by symmetry is only rounding error of that. */
static double size_at(const crossings *k, double s)
{
    flk_row row;

    flk_follow_row(&k->x.f, flk_column_need(k->c->of.c), flk_follow_inside(&k->x.f, s), &row);
    return row.at.status == FOURLINK_OK ? flk_samples_scale(&k->x, k->c, &row) : k->c->scale;
}

/* 1 if the column is constant in the piece.  Takes its value there in place of NaN, which stays if there is
** none. */
static int is_level(const crossings *k, double *value)
{
    size_t i;

    for (i = 0; i < k->x.n; i++) {
        double v = k->c->v[i], size;

        if (!has_value(k, i))
            continue;
        if (gsl_isnan(*value))
            *value = v;
        v = flk_followed_nearest(&k->c->of, v - *value, 0);
        size = GSL_MAX_DBL(fabs(*value), fabs(k->c->v[i]));
        if (!(fabs(v) <= EXACT * size) && !(fabs(v) <= LEVEL * size_at(k, k->x.s[i])))
            return 0;
    }
    return 1;
}

/* Keep the row at an end of the piece, if it has the value; or if the column passes it from the piece
** before. */
static void search_end(crossings *k, const flk_sample *end, const flk_sample *before)
{
    double around = around_end(k, before == NULL);
    double scale = GSL_MAX_DBL(around, fabs(k->value));
    int passes = before && (end->value < 0) != (before->value < 0) &&
                 fabs(end->value - before->value) <= CONTINUOUS * scale;

    if (passes || fabs(end->value) <= CONTINUOUS * scale)
        keep_crossing(k, end->x, around);
}

/* Of a stretch in which the column has the value, keep the ends: of a piece where it has, its end, and its
** beginning unless the stretch began before. */
#define BESIDE 1e-5 /* s, from an end at which a load jumps */

static void keep_level(crossings *k)
{
    unsigned long n;
    int end;

    if (k->was_level && k->last_passed == k->x.f.piece.from)
        k->n--;
    for (end = k->was_level; end < 2; end++) {
        n = k->n;
        k->last = GSL_NAN;
        keep_crossing(k, end, 0);
        if (k->n == n)
            keep_crossing(k, end ? 1 - BESIDE : BESIDE, 0);
    }
    k->was_level = 1;
}

static int has_level(const crossings *k)
{
    double any = GSL_NAN, value = k->value;

    return is_level(k, &any) && !gsl_isnan(any) && is_level(k, &value);
}

static void search_piece(crossings *k, flk_sample *before)
{
    flk_sample a, b, c;
    size_t i;

    a.x = b.x = c.x = 0;
    a.value = b.value = c.value = GSL_NAN;
    if (has_level(k)) {
        keep_level(k);
        *before = c;
        return;
    }
    k->was_level = 0;
    insert_samples(k);
    for (i = 0; i < k->x.n && !flk_follow_is_over(&k->x.f); i++) {
        a = b;
        b = c;
        c.x = k->x.s[i];
        c.value = off_of(k, k->c->v[i]);
        if (i == 0) {
            search_end(k, &c, before);
            continue;
        }
        search_turn(k, &a, &b, &c);
        search_step(k, &b, &c, around_step(k, i - 1));
    }
    search_end(k, &c, NULL);
    *before = c;
}

static void begin(crossings *k, const flk_samples_room *room, flk_analysis *a, const flk_column *c,
                  fourlink_branch branch)
{
    flk_samples_begin(&k->x, room, a, branch);
    flk_samples_add(&k->x, c);
    flk_follow_all(&k->x.f);
    k->c = &k->x.columns[0];
}

/* 1 if the column is not constant. */
static int varies(crossings *k)
{
    double value = GSL_NAN;

    while (flk_samples_next(&k->x))
        if (!is_level(k, &value))
            return 1;
    return 0;
}

static void search_crossings(crossings *k)
{
    flk_sample before = {0, 0};

    before.value = k->last = k->last_passed = GSL_NAN;
    while (flk_samples_next(&k->x))
        search_piece(k, &before);
    /* a revolution ends with its first row */
    if (k->n > 1 && k->first < SAME && k->last > k->x.f.motion.length - SAME &&
        flk_course_is_periodic(&k->x.f.a->course))
        k->n--;
}

int flk_crossings_find(const flk_samples_room *room, flk_analysis *a, const flk_column *c,
                       fourlink_branch branch, double value, unsigned long max, double *angles,
                       unsigned long *n)
{
    crossings k;
    int is_constant;

    if (flk_course_stops(&a->course, branch))
        return FOURLINK_TOO_LONG;
    memset(&k, 0, sizeof k);
    k.value = value;
    k.max = max;
    k.angles = angles;
    a->is_fast = 1;
    begin(&k, room, a, c, branch);
    is_constant = !varies(&k);
    begin(&k, room, a, c, branch);
    if (!is_constant)
        search_crossings(&k);
    a->is_fast = 0;
    if (flk_follow_is_over(&k.x.f))
        return FOURLINK_LONG_SEARCH;
    if (is_constant)
        return FOURLINK_CONSTANT;
    *n = k.n;
    return FOURLINK_OK;
}
