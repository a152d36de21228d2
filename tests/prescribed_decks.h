/* SPDX-License-Identifier: GPL-3.0-or-later
**
** prescribed_decks.h - a deck at one instant of its crank, and the same with another coordinate prescribed.
**
** A row in which a coordinate has a value, a rate and a second rate is the row of the crank that has the angle, speed and
** acceleration from which these came.  The range of the coordinate is that of a dense walk of the crank, which shares only
** the positions with the program; extremes over it are values of rows, and no dense row is beyond them.
*/
#ifndef PRESCRIBED_DECKS_H
#define PRESCRIBED_DECKS_H

#include "drawn_decks.h"

typedef struct coordinate {
    const char *name, *value, *rate, *second; /* columns */
    int is_angle, is_pin, kinds;
    int group; /* from 1, of an output; 0: it is none */
    int is_strut;
} coordinate;

static const coordinate coordinates[] = {
    {"theta4", "theta4", "omega4", "alpha4", 1, 0,
     FOURLINK_FOUR_BAR | FOURLINK_INVERTED_SLIDER_CRANK, 0, 0},
    {"x", "x", "v", "a", 0, 0, FOURLINK_SLIDER_CRANK | FOURLINK_SCOTCH_YOKE, 0, 0},
    {"C.x", "x", "v", "a", 0, 1, FOURLINK_SLIDER_CRANK | FOURLINK_SCOTCH_YOKE, 0, 0},
    {"slide", "slide", "slide_v", "slide_a", 0, 0, FOURLINK_INVERTED_SLIDER_CRANK, 0, 0}};

#define N_COORDINATES (int)(sizeof coordinates / sizeof coordinates[0])

static double instant; /* deg, of the crank */

/* One instant of a moving crank; wild ones are close to where the coordinate or the crank is dead. */
static int move_at_an_instant(deck_lines *d)
{
    char value[100];

    write_lines(d, changed_text, sizeof changed_text);
    if (is_task(d) || find_line(d, KEY_MOTION_CYCLE) || strstr(changed_text, "= drawn\n"))
        return 0;
    drop_what_knows_time();
    drop_sections(&base, SECTION_MOTION);
    drop_sections(&base, SECTION_FLYWHEEL);
    instant = seldom(0.3) ? 90.0 * one_of(8) + (seldom(0.5) ? -1 : 1) * power_of_ten(-4, 0.5)
                          : between(0, 720);
    snprintf(value, sizeof value, "%.17g deg", instant);
    set_line(&base, KEY_MOTION_AT, value);
    snprintf(value, sizeof value, "%.17g rad/s", (seldom(0.5) ? -1 : 1) * power_of_ten(-0.5, 2));
    set_line(&base, KEY_MOTION_SPEED, value);
    snprintf(value, sizeof value, "%.17g rad/s2", seldom(0.3) ? 0 : between(-1e3, 1e3));
    set_line(&base, KEY_MOTION_ACCELERATION, value);
    *d = base;
    return 1;
}

/* X of the pin C along the line of stroke, where x is 0. */
static double dead_centre_of(const fourlink_design *design)
{
    double r = design->link[2].length, e = design->offset, beta = design->angle;

    if (kind == FOURLINK_SCOTCH_YOKE)
        return r / fabs(sin(beta)) + e * cos(beta) / sin(beta);
    return sqrt(pow(r + design->link[3].length, 2) - e * e);
}

/* ---------------------------------------------------------------------------------------- an actuator between any links */

static const char *const link_names[][3] = {{"crank", "coupler", "rocker"},
                                            {"crank", "rod", "piston"},
                                            {"crank", "slider", "lever"},
                                            {"crank", "slider", "yoke"}};

static const char *link_of(int i)
{
    int k = kind == FOURLINK_FOUR_BAR                ? 0
            : kind == FOURLINK_SLIDER_CRANK          ? 1
            : kind == FOURLINK_INVERTED_SLIDER_CRANK ? 2
                                                     : 3;

    return i == 1 ? "ground" : link_names[k][i - 2];
}

static int strut_ends[2];
static fourlink_vector strut_points[2];

/* The name of an end, of an output too; its number is that of the link. */
static void draw_end(const fourlink_design *design, int i, char name[60])
{
    int last = FOURLINK_LAST_LINK(design), k, groups = 0;

    do
        strut_ends[i] = 1 + one_of(last);
    while ((i && strut_ends[1] == strut_ends[0]) ||
           (strut_ends[i] > 4 && strut_ends[i] % 2 == 1 &&
            design->group[(strut_ends[i] - 5) / 2].hang != FOURLINK_HANGS_BY_ROD));
    strut_points[i].x = design->link[2].length * between(-3, 3);
    strut_points[i].y = design->link[2].length * between(-3, 3);
    if (strut_ends[i] <= 4)
        snprintf(name, 60, "%s", link_of(strut_ends[i]));
    for (k = 0; k < base.n && strut_ends[i] > 4; k++) {
        const char *header = base.block[k].header, *of = strchr(header, ' ');

        if (base.block[k].section == SECTION_OUTPUT && groups++ == (strut_ends[i] - 5) / 2)
            snprintf(name, 60, "%.*s%s", (int)strcspn(of + 1, "]"), of + 1,
                     strut_ends[i] % 2 ? ".rod" : "");
    }
}

/* Add an actuator that does not drive to the deck. */
static void add_strut(const fourlink_problem *p)
{
    char names[2][60], text_of[500];
    deck_block *b;
    int i;

    for (i = 0; i < 2; i++)
        draw_end(&p->mechanism.design, i, names[i]);
    set_line(&base, KEY_MOTION_DRIVE, "crank");
    b = add_block(&base, "[actuator Strut]");
    add_line(b, "link", names[0]);
    add_line(b, "to", names[1]);
    for (i = 0; i < 2; i++) {
        snprintf(text_of, sizeof text_of, "(%.17g, %.17g) m", strut_points[i].x, strut_points[i].y);
        add_line(b, i ? "to_at" : "at", text_of);
    }
    write_lines(&base, base_text, sizeof base_text);
}

/* The outputs that move it, and those before them. */
static int groups_of_strut(void)
{
    int last = strut_ends[0] > strut_ends[1] ? strut_ends[0] : strut_ends[1];

    return last > 4 ? (last - 5) / 2 + 1 : 0;
}

/* An end of it, and its velocity. */
static void strut_end(const fourlink_state *at, int i, fourlink_vector *place, fourlink_vector *v)
{
    memset(v, 0, sizeof *v);
    *place = strut_points[i];
    if (strut_ends[i] > 1)
        fourlink_point(at, strut_ends[i], &strut_points[i], place, v, NULL);
}

/* ------------------------------------------------------------------------------------- a walk of the crank */

/* The coordinate at a crank angle, and its rate at unit speed; 0 where there is no position. */
static int walk_at(const coordinate *q, const fourlink_problem *p, fourlink_branch branch,
                   double theta2, double *x, double *K)
{
    fourlink_crank crank = {0, 1, 0};
    fourlink_state at;

    crank.theta2 = theta2;
    if (fourlink_analyse_dyad(&p->mechanism, branch, &crank, NULL, 0, &at, NULL) != FOURLINK_OK)
        return 0;
    if (q->is_strut) {
        fourlink_vector P[2], v[2];

        strut_end(&at, 0, &P[0], &v[0]);
        strut_end(&at, 1, &P[1], &v[1]);
        *x = hypot(P[0].x - P[1].x, P[0].y - P[1].y);
        *K = ((P[0].x - P[1].x) * (v[0].x - v[1].x) + (P[0].y - P[1].y) * (v[0].y - v[1].y)) / *x;
        return 1;
    }
    if (q->group) {
        const fourlink_group *g = &p->mechanism.design.group[q->group - 1];
        const fourlink_link_state *end = &at.link[FOURLINK_END_OF(q->group - 1)];

        *x = q->is_angle ? end->theta + p->x_angle
                         : g->direction.x * (end->origin.x - g->pivot.x) +
                               g->direction.y * (end->origin.y - g->pivot.y);
        *K = q->is_angle ? end->omega
                         : g->direction.x * end->velocity.x + g->direction.y * end->velocity.y;
        return 1;
    }
    *x = q->is_angle                              ? at.link[4].theta + p->x_angle
         : q->is_pin                              ? at.link[4].origin.x
         : kind == FOURLINK_INVERTED_SLIDER_CRANK ? at.slide
                                                  : at.x;
    *K = q->is_angle                              ? at.link[4].omega
         : q->is_pin                              ? at.link[4].velocity.x
         : kind == FOURLINK_INVERTED_SLIDER_CRANK ? at.slide_v
                                                  : at.v;
    return 1;
}

/* theta4 where positions repeat after two turns: each angle of link 4 is met in both. */
static double angle_in_turn(const coordinate *q, const fourlink_problem *p, fourlink_branch branch,
                            double x, double K)
{
    const double beside = 1e-4; /* rad */
    double theta2 = fmod(instant * PI / 180 - p->x_angle, 4 * PI), first, rate;

    theta2 += theta2 < 0 ? 4 * PI : 0;
    if (kind != FOURLINK_FOUR_BAR || p->mechanism.change_folded == p->mechanism.change_stretched ||
        !walk_at(q, p, branch, beside, &first, &rate))
        return x;
    first -= beside * rate;
    x -= 2 * PI * floor((x - first) / (2 * PI)); /* from the first angle on, rising */
    return (K > 0 ? x : x - 2 * PI) + (theta2 < 2 * PI ? 0 : K > 0 ? 2 * PI : -2 * PI);
}

/* The deck with the coordinate at the values of a row, in the deck's axes. */
static void prescribe(const coordinate *q, const fourlink_problem *problem, const columns *c,
                      const double *row, fourlink_branch branch, double *K)
{
    double x = named(c, row, q->value), v = named(c, row, q->rate), a = named(c, row, q->second);
    double way = q->is_pin ? -(double)branch : 1, w = named(c, row, "omega2");
    const char *units[3] = {"m", "m/s", "m/s2"};
    char value[100];

    if (q->is_pin)
        x = (double)branch * (dead_centre_of(&problem->mechanism.design) - x);
    if (q->is_angle) {
        units[0] = "rad";
        units[1] = "rad/s";
        units[2] = "rad/s2";
    }
    *K = way * v / w;
    if (strcmp(q->name, "theta4") == 0)
        x = angle_in_turn(q, problem, branch, x, *K);
    read_lines(&changed, base_text);
    drop_sections(&changed, SECTION_MOTION);
    set_line(&changed, KEY_MOTION_INPUT, q->name);
    set_line(&changed, KEY_MOTION_DRIVE, "crank");
    set_line(&changed, KEY_MOTION_SIDE, *K > 0 ? "rising" : "falling");
    snprintf(value, sizeof value, "%.17g %s", x, units[0]);
    set_line(&changed, KEY_MOTION_AT, value);
    snprintf(value, sizeof value, "%.17g %s", way * v, units[1]);
    set_line(&changed, KEY_MOTION_SPEED, value);
    snprintf(value, sizeof value, "%.17g %s", way * a, units[2]);
    set_line(&changed, KEY_MOTION_ACCELERATION, value);
    set_line(&changed, KEY_TABLE_BRANCH, branch == FOURLINK_OPEN ? "open" : "crossed");
    snprintf(value, sizeof value, "%.17g deg", instant);
    if (strchr(q->name, '.') && !q->is_pin)
        set_line(&changed, KEY_MOTION_NEAR, value); /* it may be there at several angles */
    write_lines(&changed, changed_text, sizeof changed_text);
}

#define STEP 1e-3   /* rad, of the walk */
#define FAR_AWAY 50 /* of the crank */

/* The last value before K changes its sign or the position ends, walking from a crank angle; the walk ends with ever
** smaller steps. */
static double walk(const coordinate *q, const fourlink_problem *p, fourlink_branch branch,
                   double theta2, int way, double *travel)
{
    double x, K, before, first, step = STEP, last;

    if (!walk_at(q, p, branch, theta2, &x, &first))
        return NAN;
    last = x;
    for (*travel = 0; step > 1e-14 && fabs(*travel) < 4 * PI;) {
        before = x;
        if (walk_at(q, p, branch, theta2 + *travel + way * step, &x, &K) && K * first > 0 &&
            (q->is_angle || (x - before) * first * way > 0)) { /* not beyond all bounds */
            *travel += way * step;
            last += q->is_angle ? difference_of_angles(before, x) - before : x - before;
        } else {
            x = before;
            step /= 2;
        }
    }
    return last;
}

/* ------------------------------------------------------------------------------------------------- compare */

static void compare_prescribed_row(side *a, const coordinate *q, fourlink_branch branch,
                                   const double *crank_row)
{
    static side b;
    static double expected[MOST_COLUMNS], row[MOST_COLUMNS];
    fourlink_problem problem = problem_of(a->r);
    double K, size = q->is_angle ? 1 : problem.mechanism.design.link[2].length, near;
    char where[100];
    int status;

    memcpy(expected, crank_row, sizeof expected);
    to_si(&a->c, expected);
    prescribe(q, &problem, &a->c, expected, branch, &K);
    near = size / fabs(K);
    if (!(near < 1e4))
        return;
    prepare(&b, opened(changed_text, NULL));
    if (!b.r) {
        fail("%s is refused", q->name);
        return;
    }
    present->cases++;
    status = fourlink_results_row(b.r, branch, 0, row, NULL, NULL);
    snprintf(where, sizeof where, "%s by %s", fourlink_branch_text((int)branch), q->name);
    if (status != FOURLINK_OK)
        fail("%s: status %d", where, status);
    /* the crank angle is known to eps near, omega2 to its near, and alpha2 = (a - L omega2^2) / K to near more */
    doubt = 20 * (near > 1 ? near * near : 1);
    doubt_of_accelerations = near > 1 ? near : 1;
    inertia_in_doubt = problem.mechanism.design.link[2].inertia;
    memcpy(expected, crank_row, sizeof expected);
    if (!has_failed && strstr(base_text, "[spring") &&
        fabs(named(&b.c, row, "theta2") - named(&a->c, expected, "theta2")) > 1e-3)
        present->undecided++; /* the other turn of a spring that winds up */
    else if (!has_failed)
        compare_rows(a, &b, expected, row, where);
    doubt = doubt_of_accelerations = 1;
    inertia_in_doubt = 0;
    fourlink_results_free(b.r);
}

/* ------------------------------------------------------------------------------------------- on both sides */

/* The deck over a part of the range on a side; null if it is refused. */
static fourlink_results *open_on(const char *on)
{
    fourlink_mistake mistake;

    set_line(&changed, KEY_MOTION_SIDE, on);
    write_lines(&changed, changed_text, sizeof changed_text);
    return open_deck(changed_text, NULL, &mistake);
}

/* The rows of both sides are those of the rising one and then those of the falling one.  Extremes are the larger and the
** smaller ones, means the average of the two where both sides have all of their rows.  Returns 1 if they do. */
static int compare_rows_of_sides(const side *one, const side *other, const side *both,
                                 fourlink_branch branch)
{
    static double expected[MOST_COLUMNS], row[MOST_COLUMNS];
    char where[100];
    unsigned long i;
    int is_whole = 1;

    memset(sizes, 0, sizeof sizes);
    memset(size_of_quantity, 0, sizeof size_of_quantity);
    if (both->rows != 2 * one->rows || one->rows != other->rows)
        fail("%lu rows on both sides, %lu and %lu on one", both->rows, one->rows, other->rows);
    for (i = 0; i < both->rows && !has_failed; i++) {
        const side *s = i < one->rows ? one : other;
        int status = fourlink_results_row(s->r, branch, i % one->rows, expected, NULL, NULL);
        int told = fourlink_results_row(both->r, branch, i, row, NULL, NULL);

        if (status != told)
            fail("row %lu of both sides: status %d, expected %d", i, told, status);
        snprintf(where, sizeof where, "row %lu of both sides", i);
        if (status == FOURLINK_OK && !has_failed)
            compare_rows(s, both, expected, row, where);
        is_whole &= status == FOURLINK_OK;
    }
    return is_whole;
}

static void compare_statistics_of_sides(const side *one, const side *other, const side *both,
                                        fourlink_branch branch, int last)
{
    int some, which, status[3];

    for (some = 0; some < SOME_COLUMNS && !has_failed; some++) {
        int j = one_of(both->c.n);

        if (!has_statistics(&both->c.list[j], FOURLINK_MEAN) || both->c.list[j].sort == OF_ROUNDING)
            continue;
        for (which = FOURLINK_MAX; which <= last; which++) {
            double x = statistic(one, j, branch, which, &status[0]),
                   y = statistic(other, j, branch, which, &status[1]),
                   z = statistic(both, j, branch, which, &status[2]), expected, size;

            if (status[0] != FOURLINK_OK || status[1] != FOURLINK_OK || !isfinite(x + y)) {
                present->undecided++;
                continue;
            }
            if (status[2] != FOURLINK_OK)
                fail("statistic %d of %s on both sides: status %d", which,
                     both->c.list[j].told->name, status[2]);
            expected = which == FOURLINK_MAX   ? fmax(x, y)
                       : which == FOURLINK_MIN ? fmin(x, y)
                                               : 0.5 * (x + y);
            size = fabs(statistic(both, j, branch, FOURLINK_MAX, &status[0])) +
                   fabs(statistic(both, j, branch, FOURLINK_MIN, &status[1]));
            if (!(size > 1e-9 * size_of_quantity[both->c.list[j].q])) {
                present->undecided++;
                continue;
            }
            compare(which == FOURLINK_MEAN ? MEAN : EXTREME, expected, z, size,
                    "statistic %d of %s on both sides", which, both->c.list[j].told->name);
        }
    }
}

/* Over a part of the range that the walk has found, from `low` to `high`. */
static void compare_both_sides(const coordinate *q, fourlink_branch branch, double low, double high)
{
    static side one, other, both;
    const char *in = q->is_angle ? "rad" : "m";
    char value[100];
    int is_whole;

    drop_key(find_block(&changed, SECTION_MOTION), KEY_MOTION_NEAR);
    snprintf(value, sizeof value, "%.17g %s", low + between(0.02, 0.3) * (high - low), in);
    set_line(&changed, KEY_MOTION_FROM, value);
    snprintf(value, sizeof value, "%.17g %s", high - between(0.02, 0.3) * (high - low), in);
    set_line(&changed, KEY_MOTION_TO, value);
    snprintf(value, sizeof value, "%.17g %s", (high - low) / between(3, 20), in);
    set_line(&changed, KEY_MOTION_INTERVAL, value);
    snprintf(value, sizeof value, "%.17g %s/s", between(0.1, 10) * (high - low), in);
    set_line(&changed, KEY_MOTION_SPEED, value);
    prepare(&one, open_on("rising"));
    prepare(&other, open_on("falling"));
    prepare(&both, open_on("both"));
    if (!both.r != !(one.r && other.r))
        fail("%s on both sides is %s, on one they are %s", q->name, both.r ? "read" : "refused",
             one.r && other.r ? "read" : "refused");
    if (both.r && !has_failed) {
        present->cases++;
        is_whole = compare_rows_of_sides(&one, &other, &both, branch);
        compare_statistics_of_sides(&one, &other, &both, branch,
                                    is_whole ? FOURLINK_MEAN : FOURLINK_MIN);
    }
    fourlink_results_free(one.r);
    fourlink_results_free(other.r);
    fourlink_results_free(both.r);
}

/* ------------------------------------------------------------------------------------------------ the range */

/* The rows without from and to go over the stretch in which the instant is. */
static void compare_range(const coordinate *q, const fourlink_problem *problem,
                          fourlink_branch branch, double theta2)
{
    double x, K, low, high, before, after, size, scale, told[2], turn;
    fourlink_problem of;
    fourlink_results *r;
    char value[100];

    if (!walk_at(q, problem, branch, theta2, &x, &K))
        return;
    low = walk(q, problem, branch, theta2, -1, &before);
    high = walk(q, problem, branch, theta2, 1, &after);
    size = q->is_angle ? 1 : problem->mechanism.design.link[2].length;
    if (fabs(after - before) >= 2 * PI || fabs(high - low) < 1e-3 * size ||
        (!q->is_angle && fabs(high) + fabs(low) > FAR_AWAY * size))
        return; /* no end within a turn, or hardly any way, or on the way beyond all bounds */
    drop_key(find_block(&changed, SECTION_MOTION), KEY_MOTION_AT);
    set_line(&changed, KEY_MOTION_ACCELERATION, "0 rad/s2");
    drop_key(find_block(&changed, SECTION_MOTION), KEY_MOTION_ACCELERATION);
    snprintf(value, sizeof value, "%.17g rad", theta2 + problem->x_angle);
    set_line(&changed, KEY_MOTION_NEAR, value);
    write_lines(&changed, changed_text, sizeof changed_text);
    r = opened(changed_text, NULL);
    if (!r) {
        fail("the range of %s is refused", q->name);
        return;
    }
    of = problem_of(r);
    told[0] = fmin(of.over.first, of.over.last);
    told[1] = fmax(of.over.first, of.over.last);
    /* where the crank is at its dead position, rounding of a rod's square leaves x its root */
    scale = 10 * size + (q->is_angle ? 0
                                     : problem->mechanism.design.link[3].length *
                                           sqrt(100 * DBL_EPSILON) / tolerances[NEAR_EXTREME]);
    x = fmin(low, high);
    turn = q->is_angle ? 2 * PI * floor((told[0] - x) / (2 * PI) + 0.5) : 0;
    compare(NEAR_EXTREME, x + turn, told[0], scale, "%s from, %s", q->name,
            fourlink_branch_text((int)branch));
    compare(NEAR_EXTREME, fmax(low, high) + turn, told[1], scale, "%s to, %s", q->name,
            fourlink_branch_text((int)branch));
    fourlink_results_free(r);
    if (!has_failed)
        compare_both_sides(q, branch, told[0], told[1]);
}

/* ------------------------------------------------------------------------------ outputs and lengths of actuators */

#define MOST_NAMED 12

/* List the outputs and the actuators of the deck, and return their number. */
static int list_named(coordinate list[MOST_NAMED], fourlink_problem *problem)
{
    static char words[MOST_NAMED][3][40];
    static const char *const endings[3][3] = {
        {"x", "v", "a"}, {"theta", "omega", "alpha"}, {"length", "speed", "acceleration"}};
    int groups = 0, n = 0, i, k;

    for (i = 0; i < base.n && n < MOST_NAMED; i++) {
        const deck_block *b = &base.block[i];
        const char *name = strchr(b->header, ' ');
        coordinate *q = &list[n];
        int of;

        if (b->section != SECTION_OUTPUT && b->section != SECTION_ACTUATOR)
            continue;
        memset(q, 0, sizeof *q);
        q->kinds = kind;
        q->group = b->section == SECTION_OUTPUT ? ++groups : 0;
        q->is_angle =
            q->group && problem->mechanism.design.group[q->group - 1].end == FOURLINK_GROUP_TURNS;
        of = !q->group ? 2 : q->is_angle;
        q->is_strut = strcmp(b->header, "[actuator Strut]") == 0;
        for (k = 0; k < 3; k++)
            snprintf(words[n][k], sizeof words[n][k], "%.*s.%s", (int)strcspn(name + 1, "]"),
                     name + 1, endings[of][k]);
        q->name = q->value = words[n][0];
        q->rate = words[n][1];
        q->second = words[n][2];
        n++;
    }
    return n;
}

/* -------------------------------------------------------------------------------------------------- the law */

static void compare_prescribed(void)
{
    static side a;
    static double row[MOST_COLUMNS];
    fourlink_problem problem, four;
    coordinate named_ones[MOST_NAMED];
    int i, k, n_named;

    prepare(&a, opened(base_text, NULL));
    if (a.r && seldom(0.7)) {
        problem = problem_of(a.r);
        add_strut(&problem);
        fourlink_results_free(a.r);
        prepare(&a, opened(base_text, NULL));
    }
    if (!a.r)
        return;
    problem = four = problem_of(a.r);
    four.mechanism.design.n_groups = 0; /* the walk is that of the four links */
    n_named = list_named(named_ones, &problem);
    for (k = 0; k < (kind == FOURLINK_SCOTCH_YOKE ? 1 : 2); k++) {
        fourlink_branch branch = k == 0 ? FOURLINK_OPEN : FOURLINK_CROSSED;

        if (fourlink_results_row(a.r, branch, 0, row, NULL, NULL) != FOURLINK_OK)
            continue;
        for (i = 0; i < N_COORDINATES && !has_failed; i++)
            if (coordinates[i].kinds & kind) {
                compare_prescribed_row(&a, &coordinates[i], branch, row);
                if (!has_failed)
                    compare_range(&coordinates[i], &four, branch,
                                  instant * PI / 180 - problem.x_angle);
            }
        for (i = 0; i < n_named && !has_failed; i++) {
            fourlink_problem some = problem;

            some.mechanism.design.n_groups =
                named_ones[i].is_strut ? groups_of_strut() : named_ones[i].group;
            compare_prescribed_row(&a, &named_ones[i], branch, row);
            if (!has_failed && (named_ones[i].group || named_ones[i].is_strut))
                compare_range(&named_ones[i], &some, branch, instant * PI / 180 - problem.x_angle);
        }
    }
    fourlink_results_free(a.r);
}

#endif
