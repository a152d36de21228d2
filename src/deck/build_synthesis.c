/* SPDX-License-Identifier: GPL-3.0-or-later
**
** build_synthesis.c - builds the task of [synthesis] from values.
*/
#include <math.h>
#include <string.h>

#include <gsl/gsl_math.h>

#include "base/number.h"
#include "mechanics/kind.h"
#include "reader.h"
#include "synthesis.h"

#define POSITIONS 3 /* of motion and path */

static setting *find(parser *p, key_code key)
{
    return flk_setting_of(flk_section_find(p, SECTION_SYNTHESIS, NULL), key);
}

static deck_synthesis *task_of(const parser *p)
{
    return p->d->synthesis;
}

static const char *const task_names[] = {"",     "function",     "motion",
                                         "path", "quick-return", "cognate"};

/* ----------------------------------------------------------------------------------------- keys */

/* The tasks that have a key, in the order of the schema: 1 << TASK_FUNCTION ... */
enum {
    F = 1 << TASK_FUNCTION,
    M = 1 << TASK_MOTION,
    P = 1 << TASK_PATH,
    Q = 1 << TASK_QUICK_RETURN,
    C = 1 << TASK_COGNATE,
    EVERY = F | M | P | Q | C
};
static const int tasks_with[] = {EVERY, F, F,     F, F, F, F, F, F, F, M | P,
                                 P,     M, M | P, Q, Q, Q, Q, Q, Q, C, EVERY};

static void refuse_others(parser *p)
{
    key_code first = flk_first_key(SECTION_SYNTHESIS), k;

    for (k = first; k < flk_first_key(SECTION_SYNTHESIS + 1); k++)
        if (IS_SET(find(p, k)) && !(tasks_with[k - first] & 1 << task_of(p)->task))
            flk_mistake(p->mistakes, find(p, k)->place, "'%s' does not belong to task = %s",
                        flk_key_table[k].name, task_names[task_of(p)->task]);
}

/* 1 if a key is given; otherwise 0 and a mistake. */
static int require(parser *p, key_code key, const char *example)
{
    return IS_SET(find(p, key)) ||
           flk_mistake(p->mistakes, task_of(p)->place, "task = %s needs '%s', such as %s = %s",
                       task_names[task_of(p)->task], flk_key_table[key].name,
                       flk_key_table[key].name, example);
}

/* The first unit of length that is written is that of the lengths found. */
static void take_unit(parser *p, text name)
{
    deck_unit *u = &task_of(p)->length;
    unit read;
    text bad;

    name = flk_text_trim(name);
    if (u->name[0] || !name.length || name.length >= DECK_NAME_SIZE ||
        !flk_unit_read(name, &read, &bad) ||
        !flk_dimension_equal(read.dim, flk_quantities[QUANTITY_LENGTH].dim))
        return;
    flk_text_copy(name, u->name, sizeof u->name);
    u->unit = read;
}

/* Report a mistake in a list unless one of its items has been reported; returns 0. */
static int refuse(parser *p, key_code key, const char *expected)
{
    return flk_mistakes_count(p->mistakes) == 0 &&
           flk_mistake(p->mistakes, find(p, key)->place, "expected %s", expected);
}

/* ------------------------------------------------------------------------------ pieces of values */

/* A quantity, or a range of it: 30 deg to 120 deg, 100 to 30 mm. */
static int read_quantity(parser *p, setting *s, text t, quantity q, double *si)
{
    if (q == QUANTITY_LENGTH)
        take_unit(p, flk_quantity_unit_text(t));
    return flk_values_piece(p, s, t, q, si);
}

static int read_range(parser *p, key_code key, quantity q, double range[2])
{
    setting *s = find(p, key);
    text first, last;
    double number;
    unit u;

    if (!flk_text_cut(s->value, " to ", &first, &last))
        return flk_mistake(p->mistakes, s->place, "expected a range, such as %s, not '%t'",
                           q == QUANTITY_ANGLE    ? "30 deg to 120 deg"
                           : q == QUANTITY_LENGTH ? "100 mm to 30 mm"
                                                  : "1 to 4",
                           s->value);
    if (!read_quantity(p, s, last, q, &range[1]))
        return 0;
    u = s->unit;
    if (flk_quantity_unit_text(first).length || !flk_quantity_unit_text(last).length) {
        if (!read_quantity(p, s, first, q, &range[0]))
            return 0;
    } else {
        text rest = first;

        if (!flk_values_number(p, s, &rest, q, &number))
            return 0;
        range[0] = flk_unit_to_si(number, u);
    }
    return range[0] != range[1] ||
           flk_mistake(p->mistakes, s->place, "the range begins and ends at the same value");
}

/* A list of numbers, at most `most`; returns how many, 0 after a mistake. */
static unsigned long read_list(parser *p, key_code key, quantity q, unsigned long most,
                               double *list)
{
    setting *s = find(p, key);
    text rest = s->value, item;
    unsigned long n = 0;

    while (flk_curve_text_item(&rest, &item)) {
        if (n == most) {
            flk_mistake(p->mistakes, s->place, "more than %ld values", (long)most);
            return 0;
        }
        if (!read_quantity(p, s, item, q, &list[n++]))
            return 0;
    }
    return n;
}

/* (24, 10) mm -30 deg: a point, and the text after its unit. */
static int read_point(parser *p, setting *s, text t, fourlink_vector *at, text *rest)
{
    text after = t, numbers;
    point result;
    size_t i;

    memset(&result, 0, sizeof result);
    if (!t.length || t.start[0] != '(' || !flk_text_split(&after, ')', &numbers) || !after.start)
        return flk_mistake(p->mistakes, s->place, "expected a point, such as (24, 10) mm, not '%t'",
                           t);
    i = flk_curve_point_value(after);
    *rest = flk_text_trim(flk_text_from(after, i));
    after.length = i;
    take_unit(p, after);
    t.length = (size_t)(after.start + i - t.start);
    if (!flk_vector_read_piece(p, s, flk_text_trim(t), QUANTITY_LENGTH, &result))
        return 0;
    at->x = result.y[0];
    at->y = result.y[1];
    return 1;
}

/* Positions of the coupler; `n_angles` is how many have an angle. */
static int read_positions(parser *p, fourlink_vector at[POSITIONS], double angle[POSITIONS],
                          int *n_angles)
{
    setting *s = find(p, KEY_SYNTHESIS_POSITIONS);
    text rest = s->value, item, after;
    int n = 0;

    *n_angles = 0;
    while (flk_curve_text_item(&rest, &item)) {
        if (n == POSITIONS || !read_point(p, s, item, &at[n], &after))
            break;
        if (after.length && !flk_values_piece(p, s, after, QUANTITY_ANGLE, &angle[n]))
            return 0;
        *n_angles += after.length > 0;
        n++;
    }
    return (n == POSITIONS && !rest.start) ||
           refuse(p, KEY_SYNTHESIS_POSITIONS,
                  "three positions, such as (0, 0) mm 0 deg, (24, 10) mm -30 deg, (40, 5) mm -50 "
                  "deg");
}

/* fixed (0.5, 3.5) mm; moving (4, 1) mm; rotations 20 deg 50 deg */
static int read_dyad(parser *p, key_code key, fourlink_dyad *dyad)
{
    static const char *const words[] = {"fixed", "moving", "rotations", NULL};
    setting *s = find(p, key);
    text word = s->value, rest;
    point pair;
    int i;

    flk_section_split(&word, &rest);
    for (i = 0; words[i] && !flk_text_equal(word, words[i]); i++)
        ;
    dyad->choice = (fourlink_choice)(FOURLINK_FIXED_PIVOT + i);
    if (!words[i])
        return flk_mistake(p->mistakes, s->place,
                           "expected fixed (x, y) mm, moving (x, y) mm or rotations 20 deg 50 deg, "
                           "not '%t'%h",
                           s->value, flk_text_nearest(word, words));
    if (dyad->choice != FOURLINK_ROTATIONS)
        return read_point(p, s, rest, &dyad->pivot, &word) &&
               (!word.length ||
                flk_mistake(p->mistakes, s->place,
                            "expected one point, such as (24, 10) mm, not '%t'", rest));
    memset(&pair, 0, sizeof pair);
    p->argument = QUANTITY_ANGLE;
    if (!flk_curve_point_read(p, s, rest, QUANTITY_ANGLE, 0, &pair))
        return 0;
    dyad->rotation[0] = pair.x;
    dyad->rotation[1] = pair.y[0];
    return 1;
}

/* --------------------------------------------------------------------------------------- lengths */

static const setting *length_of(parser *p, int link)
{
    const flk_kind *kind = flk_kind_of(p->d->design.kind);

    return flk_setting_by_name(p, flk_find_section(flk_text_of(kind->link[link])), "length");
}

/* The lengths that are given, by link number; returns their number. */
static int read_lengths(parser *p, double length[5])
{
    int i, n = 0;

    for (i = FOURLINK_GROUND; i <= FOURLINK_FOLLOWER; i++) {
        const setting *s = length_of(p, i);

        length[i] = s->si[0];
        n += IS_SET(s);
        if (IS_SET(s))
            take_unit(p, flk_quantity_unit_text(s->value));
    }
    return n;
}

/* Refuse lengths beside those that a task takes: they would not be those of the linkage found. */
static void refuse_lengths(parser *p, int most, const char *takes)
{
    static const key_code others[] = {KEY_CRANK_STROKE, KEY_LEVER_ANGLE, KEY_GROUND_OFFSET,
                                      KEY_LEVER_OFFSET};
    int n_others = task_of(p)->task == TASK_QUICK_RETURN ? 2 : 4, i;

    for (i = FOURLINK_GROUND; i <= FOURLINK_FOLLOWER + n_others; i++) {
        const setting *s = i <= FOURLINK_FOLLOWER
                               ? length_of(p, i)
                               : flk_setting_find(p, others[i - FOURLINK_FOLLOWER - 1]);

        if (!IS_SET(s) || (i <= FOURLINK_FOLLOWER && most-- > 0))
            continue;
        flk_mistake(p->mistakes, s->place,
                    "task = %s finds this: remove it, or comment it out; the task takes %s",
                    task_names[task_of(p)->task], takes);
    }
}

/* -------------------------------------------------------------------------------------- function */

/* The functions; those of an angle, whose x needs a unit, come last. */
enum { LINEAR, SQUARE, SQRT, POWER, LOG10, LN, EXP, SIN, COS, TAN, N_FUNCTIONS };
static const char *const functions[] = {"linear", "square", "sqrt", "power", "log10", "ln",
                                        "exp",    "sin",    "cos",  "tan",   NULL};

static double value_of(const deck_wanted *w, double x)
{
    switch (w->f) {
    case LOG10:
        return log10(x);
    case LN:
        return log(x);
    case EXP:
        return exp(x);
    case SIN:
        return sin(x);
    case COS:
        return cos(x);
    case TAN:
        return tan(x);
    default:
        return pow(x, w->exponent);
    }
}

/* The exponent of "power 1.5", "x^1.5", "1/x" or "x"; 0 if there is none. */
static int read_exponent(text t, double *exponent)
{
    text rest = t;

    *exponent = flk_text_equal(t, "1/x") ? -1 : 1;
    if (flk_text_equal(t, "x") || *exponent < 0)
        return 1;
    if (t.length > 2 && (t.start[0] == 'x' || t.start[0] == 'X') && t.start[1] == '^')
        rest = flk_text_from(t, 2);
    else if (t.length > 6 && flk_text_blank(flk_text_from(t, 5)))
        rest = flk_text_trim(flk_text_from(t, 6));
    return flk_number_read(&rest, exponent) == NUMBER_OK && !rest.length && *exponent != 0 &&
           fabs(*exponent) <= 100;
}

/* The name of a function, with or without x: log10, log10(x), y = x^1.5. */
static int read_name(parser *p, const setting *s, deck_wanted *w)
{
    static const double exponents[] = {1, 2, 0.5};
    text whole = s->value, word, rest, before, after;

    if (flk_text_cut(whole, "=", &before, &after) && flk_text_equal(before, "y"))
        whole = after;
    word = whole;
    flk_section_split(&word, &rest);
    for (w->f = 0; w->f < N_FUNCTIONS && !flk_text_equal(word, functions[w->f]); w->f++)
        ;
    if (w->f < POWER)
        w->exponent = exponents[w->f];
    if (w->f != POWER && w->f < N_FUNCTIONS &&
        (!rest.length || flk_text_equal(rest, "x") || flk_text_equal(rest, "(x)")))
        return 1;
    if ((w->f == POWER || w->f == N_FUNCTIONS) && read_exponent(whole, &w->exponent)) {
        w->f = POWER;
        return 1;
    }
    return flk_mistake(p->mistakes, s->place,
                       "expected a function: power 1.5, linear, square, sqrt, log10, ln, exp, sin, "
                       "cos or tan, not '%t'%h",
                       s->value, w->f == N_FUNCTIONS ? flk_text_nearest(word, functions) : NULL);
}

/* The output that is wanted at a crank angle; NaN outside the range. */
static double wanted(void *host, double theta2)
{
    const deck_wanted *w = host;
    double share = (theta2 - w->crank[0]) / (w->crank[1] - w->crank[0]);
    double x = w->x[0] + share * (w->x[1] - w->x[0]);

    if (!(share > -1e-9 && share < 1 + 1e-9))
        return GSL_NAN;
    return w->output[0] +
           (value_of(w, x) - w->y[0]) / (w->y[1] - w->y[0]) * (w->output[1] - w->output[0]);
}

/* The points of a function with Chebyshev's spacing. */
static int space_points(parser *p, setting *s)
{
    deck_synthesis *t = task_of(p);
    const setting *precision = find(p, KEY_SYNTHESIS_PRECISION);
    deck_wanted *w = &t->wanted;
    unsigned long i;
    int k;

    if (IS_SET(precision) && !(precision->si[0] >= 3 && precision->si[0] <= FOURLINK_PRECISION_MAX))
        return flk_mistake(p->mistakes, precision->place, "give 3 to 100 precision points");
    t->function.n = IS_SET(precision) ? (unsigned long)precision->si[0] : 3;
    for (k = 0; k < 2; k++)
        w->y[k] = value_of(w, w->x[k]);
    fourlink_chebyshev(w->crank[0], w->crank[1], t->function.n, t->theta2);
    for (i = 0; i < t->function.n; i++)
        t->output[i] = wanted(w, t->theta2[i]);
    for (i = 0; i < t->function.n && gsl_finite(t->output[i]); i++)
        ;
    if (i < t->function.n || !gsl_finite(w->y[0]) || !gsl_finite(w->y[1]))
        return flk_mistake(p->mistakes, s->place,
                           "the function is not defined, or has the same value at both ends, in "
                           "x = %g to %g",
                           w->x[0], w->x[1]);
    t->function.from = w->crank[0];
    t->function.to = w->crank[1];
    t->function.wanted = wanted;
    t->function.host = w;
    return 1;
}

static int read_function(parser *p, setting *s)
{
    int is_four_bar = p->d->design.kind == FOURLINK_FOUR_BAR, is_angle;
    key_code out = is_four_bar ? KEY_SYNTHESIS_ROCKER : KEY_SYNTHESIS_PISTON;
    deck_wanted *w = &task_of(p)->wanted;
    text first, last;

    if (IS_SET(find(p, KEY_SYNTHESIS_POINTS)))
        return flk_mistake(p->mistakes, s->place, "give either 'points' or a 'function', not both");
    if (!read_name(p, s, w) || !require(p, KEY_SYNTHESIS_ARGUMENT, "1 to 4") ||
        !require(p, KEY_SYNTHESIS_CRANK, "30 deg to 120 deg") ||
        !require(p, out, is_four_bar ? "60 deg to 150 deg" : "100 mm to 30 mm"))
        return 0;
    is_angle = w->f >= SIN;
    if (is_angle && (!flk_text_cut(find(p, KEY_SYNTHESIS_ARGUMENT)->value, " to ", &first, &last) ||
                     !flk_quantity_unit_text(last).length))
        return flk_mistake(p->mistakes, find(p, KEY_SYNTHESIS_ARGUMENT)->place,
                           "the x of %s is an angle and needs a unit, such as 0 deg to 90 deg",
                           functions[w->f]);
    return read_range(p, KEY_SYNTHESIS_ARGUMENT, is_angle ? QUANTITY_ANGLE : QUANTITY_NUMBER,
                      w->x) &&
           read_range(p, KEY_SYNTHESIS_CRANK, QUANTITY_ANGLE, w->crank) &&
           read_range(p, out, is_four_bar ? QUANTITY_ANGLE : QUANTITY_LENGTH, w->output) &&
           space_points(p, s);
}

/* Pairs of crank angle and output. */
static int read_points(parser *p, setting *s)
{
    deck_synthesis *t = task_of(p);
    quantity q = p->d->design.kind == FOURLINK_FOUR_BAR ? QUANTITY_ANGLE : QUANTITY_LENGTH;
    static const key_code others[] = {KEY_SYNTHESIS_ARGUMENT, KEY_SYNTHESIS_ROCKER,
                                      KEY_SYNTHESIS_PISTON, KEY_SYNTHESIS_PRECISION};
    text rest = s->value, item, before, unit_text;
    point pair;
    size_t i;

    for (i = 0; i < sizeof others / sizeof others[0]; i++)
        if (IS_SET(find(p, others[i])))
            return flk_mistake(p->mistakes, find(p, others[i])->place, "'%s' needs a 'function'",
                               flk_key_table[others[i]].name);
    while (flk_curve_text_item(&rest, &item)) {
        if (t->function.n == FOURLINK_PRECISION_MAX)
            return flk_mistake(p->mistakes, s->place, "more than %ld values",
                               (long)FOURLINK_PRECISION_MAX);
        memset(&pair, 0, sizeof pair);
        p->argument = QUANTITY_ANGLE;
        if (!flk_curve_point_read(p, s, item, q, 0, &pair))
            return 0;
        if (flk_text_cut_last(item, " ", &before, &unit_text))
            take_unit(p, unit_text);
        t->theta2[t->function.n] = pair.x;
        t->output[t->function.n++] = pair.y[0];
    }
    if (t->function.n < 3)
        return flk_mistake(p->mistakes, s->place, "give three or more points, such as %s",
                           flk_curve_point_example(q));
    if (IS_SET(find(p, KEY_SYNTHESIS_CRANK))) {
        double range[2];

        if (!read_range(p, KEY_SYNTHESIS_CRANK, QUANTITY_ANGLE, range))
            return 0;
        t->function.from = range[0];
        t->function.to = range[1];
    }
    return 1;
}

static int build_function(parser *p)
{
    deck_synthesis *t = task_of(p);
    setting *points = find(p, KEY_SYNTHESIS_POINTS), *function = find(p, KEY_SYNTHESIS_FUNCTION);
    const setting *weights = find(p, KEY_SYNTHESIS_WEIGHTS);
    double length[5];
    unsigned long i;
    int n, is_four_bar = p->d->design.kind == FOURLINK_FOUR_BAR;

    n = read_lengths(p, length);
    refuse_lengths(p, is_four_bar, is_four_bar ? "the length of one link" : "no lengths");
    if (is_four_bar && !n)
        flk_mistake(p->mistakes, t->place,
                    "task = function needs the length of one link, such as that of the [ground]");
    if (!IS_SET(points) && !IS_SET(function))
        return flk_mistake(p->mistakes, t->place, "task = function needs 'points' or a 'function'");
    if (!(IS_SET(function) ? read_function : read_points)(p, IS_SET(function) ? function : points))
        return 0;
    t->function.kind = p->d->design.kind;
    t->function.theta2 = t->theta2;
    t->function.output = t->output;
    t->function.fit = (fourlink_fit)find(p, KEY_SYNTHESIS_FIT)->word;
    t->function.ground = length[FOURLINK_GROUND];
    for (i = FOURLINK_CRANK; i <= FOURLINK_FOLLOWER && is_four_bar; i++)
        if (length[i] > 0) {
            t->scaled_link = (int)i;
            t->scaled_length = length[i];
            t->function.ground = 1;
        }
    if (!IS_SET(weights))
        return 1;
    if (read_list(p, KEY_SYNTHESIS_WEIGHTS, QUANTITY_NUMBER, FOURLINK_PRECISION_MAX, t->weight) !=
        t->function.n)
        return refuse(p, KEY_SYNTHESIS_WEIGHTS, "a weight for each of the points");
    for (i = 0; i < t->function.n; i++)
        if (!(t->weight[i] > 0))
            return flk_mistake(p->mistakes, weights->place, "a weight must be positive");
    t->function.weight = t->weight;
    return 1;
}

/* -------------------------------------------------------------------------------- motion and path */

static const char dyad_example[] = "fixed (50, 0) mm";
static const char positions_example[] = "(0, 0) mm 0 deg, (24, 10) mm -30 deg, (40, 5) mm -50 deg";

static int build_motion(parser *p)
{
    fourlink_motion_task *m = &task_of(p)->motion;
    int n_angles;

    refuse_lengths(p, 0, "no lengths");
    if (!require(p, KEY_SYNTHESIS_POSITIONS, positions_example) ||
        !require(p, KEY_SYNTHESIS_LEFT, dyad_example) ||
        !require(p, KEY_SYNTHESIS_RIGHT, dyad_example) ||
        !read_positions(p, m->point, m->angle, &n_angles))
        return 0;
    if (n_angles < POSITIONS)
        return flk_mistake(p->mistakes, find(p, KEY_SYNTHESIS_POSITIONS)->place,
                           "each position needs an angle of the coupler, such as (24, 10) mm -30 "
                           "deg");
    return read_dyad(p, KEY_SYNTHESIS_LEFT, &m->left) &
           read_dyad(p, KEY_SYNTHESIS_RIGHT, &m->right);
}

static int build_path(parser *p)
{
    fourlink_path_task *t = &task_of(p)->path;
    double angle[POSITIONS] = {0, 0, 0};
    int n_angles;

    refuse_lengths(p, 0, "no lengths");
    if (!require(p, KEY_SYNTHESIS_POSITIONS, positions_example) ||
        !require(p, KEY_SYNTHESIS_TIMING, "40 deg, 85 deg") ||
        !require(p, KEY_SYNTHESIS_RIGHT, dyad_example) ||
        !read_positions(p, t->point, angle, &n_angles))
        return 0;
    if (n_angles != 0 && n_angles != POSITIONS)
        return flk_mistake(p->mistakes, find(p, KEY_SYNTHESIS_POSITIONS)->place,
                           "give the angle of the coupler at all positions, or at none: then they "
                           "are searched for");
    t->search = n_angles == 0;
    t->rotation[0] = angle[1] - angle[0];
    t->rotation[1] = angle[2] - angle[0];
    if (read_list(p, KEY_SYNTHESIS_TIMING, QUANTITY_ANGLE, POSITIONS - 1, t->timing) !=
        POSITIONS - 1)
        return refuse(p, KEY_SYNTHESIS_TIMING,
                      "the crank's rotations from the first position to the second and third, such "
                      "as 40 deg, 85 deg");
    return read_dyad(p, KEY_SYNTHESIS_RIGHT, &t->right);
}

/* ---------------------------------------------------------------------------------- quick return */

static int build_quick_return(parser *p)
{
    fourlink_quick_return_task *t = &task_of(p)->quick_return;
    const setting *swing = find(p, KEY_SYNTHESIS_SWING), *stroke = find(p, KEY_SYNTHESIS_STROKE),
                  *type = find(p, KEY_SYNTHESIS_TYPE), *choose = find(p, KEY_SYNTHESIS_CHOOSE),
                  *ratio = find(p, KEY_SYNTHESIS_TIME_RATIO),
                  *offset = flk_setting_find(p, KEY_GROUND_OFFSET);
    fourlink_kind kind = p->d->design.kind;
    int n = read_lengths(p, t->length), is_lever = kind == FOURLINK_INVERTED_SLIDER_CRANK;
    int most = kind == FOURLINK_SLIDER_CRANK ? 1 : 2;

    t->type = kind == FOURLINK_FOUR_BAR       ? FOURLINK_CRANK_ROCKER
              : kind == FOURLINK_SLIDER_CRANK ? FOURLINK_ENGINE
              : type->word                    ? (fourlink_type)type->word
                                              : FOURLINK_SLOTTED_LEVER;
    if (is_lever && !IS_SET(offset))
        offset = flk_setting_find(p, KEY_LEVER_OFFSET);
    if (IS_SET(offset) && offset->si[0] == 0 && !is_lever)
        return flk_mistake(p->mistakes, offset->place,
                           "an offset of 0 has a time ratio of 1: remove it, it is found");
    n += IS_SET(offset) && !is_lever;
    refuse_lengths(p, most,
                   kind == FOURLINK_FOUR_BAR       ? "two lengths, or one and choose = best"
                   : kind == FOURLINK_SLIDER_CRANK ? "the crank, the rod or the offset, or none"
                                                   : "the ground or the crank, and the lever");
    if (IS_SET(choose) && n > most - 1)
        flk_mistake(p->mistakes, choose->place, "with choose = best, %s: give fewer lengths",
                    kind == FOURLINK_FOUR_BAR ? "one length is given" : "no length is given");
    if (kind == FOURLINK_FOUR_BAR && !n)
        flk_mistake(p->mistakes, task_of(p)->place,
                    "the crank-rocker needs two lengths, or one for the best transmission angle");
    if (t->type == FOURLINK_CRANK_ROCKER && !require(p, KEY_SYNTHESIS_SWING, "50 deg"))
        return 0;
    if (t->type == FOURLINK_ENGINE && !require(p, KEY_SYNTHESIS_STROKE, "100 mm"))
        return 0;
    if (t->type == FOURLINK_WHITWORTH && (IS_SET(swing) || IS_SET(stroke)))
        return flk_mistake(p->mistakes, (IS_SET(swing) ? swing : stroke)->place,
                           "the lever of a Whitworth mechanism turns fully: give the time_ratio");
    if ((t->type != FOURLINK_SLOTTED_LEVER || !IS_SET(swing)) &&
        !require(p, KEY_SYNTHESIS_TIME_RATIO, "1.2"))
        return 0;
    if (t->type == FOURLINK_SLOTTED_LEVER && IS_SET(swing) && IS_SET(ratio))
        return flk_mistake(p->mistakes, swing->place,
                           "the swing of a slotted lever follows from the time_ratio: give one of "
                           "them");
    if (IS_SET(ratio) && ratio->si[0] < 1)
        return flk_mistake(p->mistakes, ratio->place,
                           "a time ratio is at least 1: slow stroke / quick stroke, in time; which "
                           "is slow is said by 'slow'");
    if (IS_SET(stroke))
        take_unit(p, flk_quantity_unit_text(stroke->value));
    if (IS_SET(offset))
        take_unit(p, flk_quantity_unit_text(offset->value));
    t->time_ratio = ratio->si[0];
    t->swing = swing->si[0];
    t->stroke = stroke->si[0];
    t->offset = offset->si[0];
    t->slow = find(p, KEY_SYNTHESIS_SLOW)->word;
    return 1;
}

/* --------------------------------------------------------------------------------------- cognate */

/* The first point of the coupler. */
static const section_use *coupler_point(const parser *p)
{
    size_t i;

    for (i = 0; i < p->n_uses; i++)
        if (p->uses[i].section == SECTION_POINT &&
            flk_setting_of(&p->uses[i], KEY_POINT_LINK)->word == FOURLINK_COUPLER)
            return &p->uses[i];
    return NULL;
}

static int build_cognate(parser *p)
{
    fourlink_cognate_task *t = &task_of(p)->cognate;
    const section_use *at = coupler_point(p);
    double length[5];
    int i;

    if (!require(p, KEY_SYNTHESIS_WHICH, "left"))
        return 0;
    if (read_lengths(p, length) < 4)
        return flk_mistake(p->mistakes, task_of(p)->place,
                           "task = cognate needs the lengths of all four links");
    if (!at)
        return flk_mistake(p->mistakes, task_of(p)->place,
                           "task = cognate needs a [point] of the coupler, which it traces");
    t->design.kind = p->d->design.kind;
    for (i = FOURLINK_GROUND; i <= FOURLINK_FOLLOWER; i++)
        t->design.link[i].length = p->d->design.link[i].length = length[i];
    flk_build_place(p, flk_setting_of(at, KEY_POINT_AT), FOURLINK_COUPLER, &t->point);
    t->branch = flk_setting_find(p, KEY_TABLE_BRANCH)->word == BRANCH_CROSSED ? FOURLINK_CROSSED
                                                                              : FOURLINK_OPEN;
    t->side = (fourlink_side)find(p, KEY_SYNTHESIS_WHICH)->word;
    t->from = flk_setting_or(p, KEY_MOTION_FROM, 0);
    t->to = flk_setting_or(p, KEY_MOTION_TO, t->from);
    return 1;
}

/* ------------------------------------------------------------------------------------------- all */

static int build_task(parser *p)
{
    switch (task_of(p)->task) {
    case TASK_FUNCTION:
        return build_function(p);
    case TASK_MOTION:
        return build_motion(p);
    case TASK_PATH:
        return build_path(p);
    case TASK_QUICK_RETURN:
        return build_quick_return(p);
    case TASK_COGNATE:
    default:
        return build_cognate(p);
    }
}

/* 1 if this kind of mechanism has the task; 0 and a mistake. */
static int has_task(parser *p, const setting *task)
{
    static const int kinds[] = {0,
                                FOURLINK_FOUR_BAR | FOURLINK_SLIDER_CRANK,
                                FOURLINK_FOUR_BAR,
                                FOURLINK_FOUR_BAR,
                                FLK_EVERY_KIND,
                                FOURLINK_FOUR_BAR};
    const char *words = fourlink_kind_text((int)p->d->design.kind);

    return (kinds[task->word] & (int)p->d->design.kind) != 0 ||
           flk_mistake(p->mistakes, task->place, "task = %s does not exist for %s %s",
                       task_names[task->word], flk_text_article(words), words);
}

int flk_synthesis_read(parser *p)
{
    section_use *use = flk_section_find(p, SECTION_SYNTHESIS, NULL);
    size_t before = flk_mistakes_count(p->mistakes);
    const setting *task;
    deck_synthesis *t;

    if (!p->d->solution)
        return flk_mistake(p->mistakes, use->place,
                           "[synthesis] describes a linkage that is to be found: fourlink "
                           "--synthesis finds it and prints its deck");
    if (use->is_mistaken || !flk_section_unshare(p, use))
        return 0;
    task = find(p, KEY_SYNTHESIS_TASK);
    if (!IS_SET(task))
        return flk_mistake(p->mistakes, use->place,
                           "[synthesis] needs 'task = function', 'motion', 'path', 'quick-return' "
                           "or 'cognate'");
    t = p->d->synthesis = flk_reader_keep(p, sizeof *t);
    if (!t || !has_task(p, task))
        return 0;
    t->task = (deck_task)task->word;
    t->place = use->place;
    t->mu_min = flk_setting_or(p, KEY_SYNTHESIS_MU_MIN, MU_MIN_USUAL * (M_PI / 180));
    if (IS_SET(flk_setting_find(p, KEY_UNITS_LENGTH)))
        t->length = p->d->bare[QUANTITY_LENGTH];
    refuse_others(p);
    if (!build_task(p) || flk_mistakes_count(p->mistakes) > before)
        return 0;
    if (!t->length.name[0])
        t->length = p->d->bare[QUANTITY_LENGTH];
    return 1;
}
