/* SPDX-License-Identifier: GPL-3.0-or-later
**
** build_function.c - builds the task of a function generator from values.
*/
#include <math.h>
#include <string.h>

#include <gsl/gsl_math.h>

#include "base/number.h"
#include "task.h"

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
    deck_synthesis *t = flk_task_of(p);
    const setting *precision = flk_task_find(p, KEY_SYNTHESIS_PRECISION);
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
    deck_wanted *w = &flk_task_of(p)->wanted;
    text first, last;

    if (IS_SET(flk_task_find(p, KEY_SYNTHESIS_POINTS)))
        return flk_mistake(p->mistakes, s->place, "give either 'points' or a 'function', not both");
    if (!read_name(p, s, w) || !flk_task_require(p, KEY_SYNTHESIS_ARGUMENT, "1 to 4") ||
        !flk_task_require(p, KEY_SYNTHESIS_CRANK, "30 deg to 120 deg") ||
        !flk_task_require(p, out, is_four_bar ? "60 deg to 150 deg" : "100 mm to 30 mm"))
        return 0;
    is_angle = w->f >= SIN;
    if (is_angle &&
        (!flk_text_cut(flk_task_find(p, KEY_SYNTHESIS_ARGUMENT)->value, " to ", &first, &last) ||
         !flk_quantity_unit_text(last).length))
        return flk_mistake(p->mistakes, flk_task_find(p, KEY_SYNTHESIS_ARGUMENT)->place,
                           "the x of %s is an angle and needs a unit, such as 0 deg to 90 deg",
                           functions[w->f]);
    return flk_task_range(p, KEY_SYNTHESIS_ARGUMENT, is_angle ? QUANTITY_ANGLE : QUANTITY_NUMBER,
                          w->x) &&
           flk_task_range(p, KEY_SYNTHESIS_CRANK, QUANTITY_ANGLE, w->crank) &&
           flk_task_range(p, out, is_four_bar ? QUANTITY_ANGLE : QUANTITY_LENGTH, w->output) &&
           space_points(p, s);
}

/* Pairs of crank angle and output. */
static int read_points(parser *p, setting *s)
{
    deck_synthesis *t = flk_task_of(p);
    quantity q = p->d->design.kind == FOURLINK_FOUR_BAR ? QUANTITY_ANGLE : QUANTITY_LENGTH;
    static const key_code others[] = {KEY_SYNTHESIS_ARGUMENT, KEY_SYNTHESIS_ROCKER,
                                      KEY_SYNTHESIS_PISTON, KEY_SYNTHESIS_PRECISION};
    text rest = s->value, item, before, unit_text;
    point pair;
    size_t i;

    for (i = 0; i < sizeof others / sizeof others[0]; i++)
        if (IS_SET(flk_task_find(p, others[i])))
            return flk_mistake(p->mistakes, flk_task_find(p, others[i])->place,
                               "'%s' needs a 'function'", flk_key_table[others[i]].name);
    while (flk_curve_text_item(&rest, &item)) {
        if (t->function.n == FOURLINK_PRECISION_MAX)
            return flk_mistake(p->mistakes, s->place, "more than %ld values",
                               (long)FOURLINK_PRECISION_MAX);
        memset(&pair, 0, sizeof pair);
        p->argument = QUANTITY_ANGLE;
        if (!flk_curve_point_read(p, s, item, q, 0, &pair))
            return 0;
        if (flk_text_cut_last(item, " ", &before, &unit_text))
            flk_task_unit(p, unit_text);
        t->theta2[t->function.n] = pair.x;
        t->output[t->function.n++] = pair.y[0];
    }
    if (t->function.n < 3)
        return flk_mistake(p->mistakes, s->place, "give three or more points, such as %s",
                           flk_curve_point_example(q));
    if (IS_SET(flk_task_find(p, KEY_SYNTHESIS_CRANK))) {
        double range[2];

        if (!flk_task_range(p, KEY_SYNTHESIS_CRANK, QUANTITY_ANGLE, range))
            return 0;
        t->function.from = range[0];
        t->function.to = range[1];
    }
    return 1;
}

int flk_task_function(parser *p)
{
    deck_synthesis *t = flk_task_of(p);
    setting *points = flk_task_find(p, KEY_SYNTHESIS_POINTS),
            *function = flk_task_find(p, KEY_SYNTHESIS_FUNCTION);
    const setting *weights = flk_task_find(p, KEY_SYNTHESIS_WEIGHTS);
    double length[5];
    unsigned long i;
    int n, is_four_bar = p->d->design.kind == FOURLINK_FOUR_BAR;

    n = flk_task_lengths(p, length);
    flk_task_refuse_lengths(p, is_four_bar, is_four_bar ? "the length of one link" : "no lengths");
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
    t->function.fit = (fourlink_fit)flk_task_find(p, KEY_SYNTHESIS_FIT)->word;
    t->function.ground = length[FOURLINK_GROUND];
    for (i = FOURLINK_CRANK; i <= FOURLINK_FOLLOWER && is_four_bar; i++)
        if (length[i] > 0) {
            t->scaled_link = (int)i;
            t->scaled_length = length[i];
            t->function.ground = 1;
        }
    if (!IS_SET(weights))
        return 1;
    if (flk_task_list(p, KEY_SYNTHESIS_WEIGHTS, QUANTITY_NUMBER, FOURLINK_PRECISION_MAX,
                      t->weight) != t->function.n)
        return flk_task_refuse(p, KEY_SYNTHESIS_WEIGHTS, "a weight for each of the points");
    for (i = 0; i < t->function.n; i++)
        if (!(t->weight[i] > 0))
            return flk_mistake(p->mistakes, weights->place, "a weight must be positive");
    t->function.weight = t->weight;
    return 1;
}
