/* SPDX-License-Identifier: GPL-3.0-or-later
**
** build_function.c - builds the task of a function generator from values.
*/
#include <math.h>

#include <gsl/gsl_math.h>

#include "base/number.h"
#include "base/steffen.h"
#include "card.h"
#include "curve_point.h"
#include "curve_text.h"
#include "parser.h"
#include "pieces.h"
#include "settings.h"
#include "synthesis.h"
#include "task.h"

/* The functions: powers, and then others; those of an angle, whose x needs a unit, come last.  A table is
** smooth between its rows. */
enum { LINEAR, SQUARE, SQRT, POWER, LOG10, LN, EXP, SIN, COS, TAN, N_FUNCTIONS, TABLE = -1 };
static const char *const functions[] = {"linear", "square", "sqrt", "power", "log10", "ln",
                                        "exp",    "sin",    "cos",  "tan",   NULL};
static double (*const formulas[])(double) = {NULL, NULL, NULL, NULL, log10,
                                             log,  exp,  sin,  cos,  tan};
static const double exponents[] = {1, 2, 0.5, 1, 1, 1, 1, 1, 1, 1};

static double value_of(const deck_wanted *w, double x)
{
    if (w->f == TABLE)
        return flk_steffen_on(w->table_x, w->table_y, w->n_rows, x, x);
    return formulas[w->f] ? formulas[w->f](x) : pow(x, w->exponent);
}

/* The exponent of x, 1/x and x^1.5; 0 if a text is none of them. */
static int read_power(text t, double *exponent)
{
    text x, number;

    *exponent = flk_text_equal(t, "1/x") ? -1 : 1;
    return flk_text_equal(t, "x") || *exponent < 0 ||
           (flk_text_cut(t, "^", &x, &number) && flk_text_equal(x, "x") &&
            flk_number_read(&number, exponent) == NUMBER_OK && !number.length);
}

/* The name of a function, with or without x: log10, log10(x), y = x^1.5. */
static int read_name(parser *p, const setting *s, deck_wanted *w)
{
    text whole = s->value, word, rest, before, after;
    int is_read;

    if (flk_text_cut(whole, "=", &before, &after) && flk_text_equal(before, "y"))
        whole = after;
    word = whole;
    flk_section_split(&word, &rest);
    for (w->f = 0; w->f < N_FUNCTIONS && !flk_text_equal(word, functions[w->f]); w->f++)
        ;
    if (w->f == N_FUNCTIONS) {
        is_read = read_power(whole, &w->exponent);
    } else if (w->f == POWER) {
        is_read = flk_number_read(&rest, &w->exponent) == NUMBER_OK && !rest.length;
    } else {
        is_read = !rest.length || flk_text_equal(rest, "x") || flk_text_equal(rest, "(x)");
        w->exponent = exponents[w->f];
    }
    if (!is_read || w->exponent == 0 || fabs(w->exponent) > 100)
        return flk_mistake(
            p->mistakes, s->place,
            "expected a function: power 1.5, linear, square, sqrt, log10, ln, exp, sin, "
            "cos, tan or file NAME, not '%t'%h",
            s->value, w->f == N_FUNCTIONS ? flk_text_nearest(word, functions) : NULL);
    if (w->f == N_FUNCTIONS)
        w->f = POWER;
    return 1;
}

/* Read the table of `file NAME`: rows of x, which rises, and y. */
static int read_table(parser *p, const setting *s, text name, deck_wanted *w)
{
    setting read = *s;
    double *x;
    size_t i;

    read.n_points = 0;
    read.argument = QUANTITY_NUMBER;
    if (!flk_card_read(p, &read, QUANTITY_NUMBER, name) || !read.curve)
        return 0;
    x = flk_reader_keep(p, 2 * (read.n_points + 1) * sizeof *x);
    if (!x)
        return 0;
    for (i = 0; i < read.n_points; i++) {
        x[i] = read.curve[i].x;
        x[read.n_points + i] = read.curve[i].y[0];
        if (i > 0 && !(x[i] > x[i - 1]))
            return flk_mistake(p->mistakes, read.curve[i].place,
                               "x must rise from row to row: %g stands below %g", x[i], x[i - 1]);
    }
    if (read.n_points < 3)
        return flk_mistake(p->mistakes, s->place, "a table needs three or more rows of x and y");
    w->f = TABLE;
    w->table_x = x;
    w->table_y = x + read.n_points;
    w->n_rows = read.n_points;
    w->x[0] = x[0];
    w->x[1] = x[read.n_points - 1];
    return 1;
}

/* The crank angle of x. */
static double angle_of(const deck_wanted *w, double x)
{
    return w->crank[0] + (x - w->x[0]) / (w->x[1] - w->x[0]) * (w->crank[1] - w->crank[0]);
}

/* The x of a crank angle; NaN outside the range. */
static double x_of_angle(const deck_wanted *w, double theta2)
{
    double share = (theta2 - w->crank[0]) / (w->crank[1] - w->crank[0]);

    return share > -1e-9 && share < 1 + 1e-9 ? w->x[0] + share * (w->x[1] - w->x[0]) : GSL_NAN;
}

/* The output that is wanted at a crank angle; NaN outside the range. */
static double wanted(void *host, double theta2)
{
    const deck_wanted *w = host;
    double x = x_of_angle(w, theta2);

    if (gsl_isnan(x))
        return GSL_NAN;
    return w->output[0] +
           (value_of(w, x) - w->y[0]) / (w->y[1] - w->y[0]) * (w->output[1] - w->output[0]);
}

/* The crank angles of the points: with Chebyshev's spacing, or of all rows of a table. */
static int space_points(parser *p)
{
    const setting *precision = flk_task_find(p, KEY_SYNTHESIS_PRECISION);
    deck_synthesis *t = p->d->synthesis;
    const deck_wanted *w = &t->wanted;
    double n = IS_SET(precision) ? precision->si[0] : 3;
    unsigned long i, n_rows = 0;

    if (w->f == TABLE && !IS_SET(precision)) {
        for (i = 0; i < w->n_rows; i++)
            if ((w->table_x[i] - w->x[0]) * (w->table_x[i] - w->x[1]) <= 0 &&
                n_rows++ < FOURLINK_PRECISION_MAX)
                t->theta2[n_rows - 1] = angle_of(w, w->table_x[i]);
        t->function.n = n_rows;
        return (n_rows >= 3 && n_rows <= FOURLINK_PRECISION_MAX) ||
               flk_mistake(p->mistakes, flk_task_find(p, KEY_SYNTHESIS_FUNCTION)->place,
                           "%ld rows of the table lie in x = %g to %g: give 'precision', the "
                           "number of points, 3 to 100",
                           (long)n_rows, w->x[0], w->x[1]);
    }
    if (!(n >= 3 && n <= FOURLINK_PRECISION_MAX))
        return flk_mistake(p->mistakes, precision->place, "give 3 to 100 precision points");
    t->function.n = (unsigned long)n;
    fourlink_chebyshev(w->crank[0], w->crank[1], t->function.n, t->theta2);
    return 1;
}

/* The points of a function in its range. */
static int set_points(parser *p, const setting *s)
{
    deck_synthesis *t = p->d->synthesis;
    fourlink_function_task *task = &t->function;
    deck_wanted *w = &t->wanted;
    double largest = 0;
    int is_defined;
    unsigned long i;

    if (!space_points(p))
        return 0;
    w->y[0] = value_of(w, w->x[0]);
    w->y[1] = value_of(w, w->x[1]);
    is_defined = gsl_finite(w->y[0]) && gsl_finite(w->y[1]);
    for (i = 0; i < task->n; i++) {
        t->output[i] = wanted(w, t->theta2[i]);
        is_defined &= gsl_finite(t->output[i]);
        largest = GSL_MAX(largest, fabs(value_of(w, x_of_angle(w, t->theta2[i]))));
    }
    is_defined &= fabs(w->y[1] - w->y[0]) > 1e-12 * largest; /* sin 180 deg is not 0 */
    if (!is_defined)
        return flk_mistake(p->mistakes, s->place,
                           "the function is not defined, or has the same value at both ends, in "
                           "x = %g to %g",
                           w->x[0], w->x[1]);
    task->from = w->crank[0];
    task->to = w->crank[1];
    task->wanted = wanted;
    task->host = w;
    return 1;
}

/* The range of x; without one, all of a table. */
static int read_argument(parser *p)
{
    deck_wanted *w = &p->d->synthesis->wanted;
    setting *x = flk_task_find(p, KEY_SYNTHESIS_ARGUMENT);
    double least = w->x[0], most = w->x[1];
    text first, last;
    int is_angle = w->f >= SIN;

    if (w->f == TABLE && !IS_SET(x))
        return 1;
    if (!flk_task_require(p, KEY_SYNTHESIS_ARGUMENT, "1 to 4"))
        return 0;
    if (is_angle &&
        (!flk_text_range(x->value, &first, &last) || !flk_quantity_unit_text(last).length))
        return flk_mistake(p->mistakes, x->place,
                           "the x of %s is an angle and needs a unit, such as 0 deg to 90 deg",
                           functions[w->f]);
    if (!flk_task_range(p, KEY_SYNTHESIS_ARGUMENT, is_angle ? QUANTITY_ANGLE : QUANTITY_NUMBER,
                        w->x))
        return 0;
    return w->f != TABLE ||
           (GSL_MIN(w->x[0], w->x[1]) >= least && GSL_MAX(w->x[0], w->x[1]) <= most) ||
           flk_mistake(p->mistakes, x->place, "the table goes from x = %g to %g", least, most);
}

static int read_function(parser *p, setting *s)
{
    deck_synthesis *t = p->d->synthesis;
    deck_wanted *w = &t->wanted;
    text name;
    int is_read;

    if (IS_SET(flk_task_find(p, KEY_SYNTHESIS_POINTS)))
        return flk_mistake(p->mistakes, s->place, "give either 'points' or a 'function', not both");
    is_read = flk_curve_text_file(s->value, &name) ? read_table(p, s, name, w) : read_name(p, s, w);
    is_read = is_read && read_argument(p);
    is_read &= flk_task_require(p, KEY_SYNTHESIS_CRANK, "30 deg to 120 deg") &&
               flk_task_range(p, KEY_SYNTHESIS_CRANK, QUANTITY_ANGLE, w->crank);
    is_read &= flk_task_require(p, t->kind->range, t->kind->example) &&
               flk_task_range(p, t->kind->range, t->kind->output, w->output);
    return is_read && set_points(p, s);
}

/* Pairs of crank angle and output. */
static int read_points(parser *p, setting *s)
{
    static const key_code others[] = {KEY_SYNTHESIS_ARGUMENT, KEY_SYNTHESIS_ROCKER,
                                      KEY_SYNTHESIS_PISTON, KEY_SYNTHESIS_PRECISION};
    deck_synthesis *t = p->d->synthesis;
    fourlink_function_task *task = &t->function;
    double range[2] = {0, 0};
    text rest = s->value, item, last;
    setting read = *s;
    size_t i;

    for (i = 0; i < sizeof others / sizeof others[0]; i++)
        if (IS_SET(flk_task_find(p, others[i])))
            return flk_mistake(p->mistakes, flk_task_find(p, others[i])->place,
                               "'%s' needs a 'function'", flk_key_table[others[i]].name);
    read.n_points = 0;
    read.argument = QUANTITY_ANGLE;
    if (!flk_curve_text_read(p, &read, t->kind->output))
        return 0;
    if (read.n_points < 3 || read.n_points > FOURLINK_PRECISION_MAX)
        return flk_mistake(p->mistakes, s->place,
                           "give three or more points, at most 100, such as %s",
                           flk_curve_point_example(t->kind->output));
    task->n = (unsigned long)read.n_points;
    for (i = 0; i < task->n && read.curve; i++) {
        t->theta2[i] = read.curve[i].x;
        t->output[i] = read.curve[i].y[0];
    }
    if (flk_piece_item(&rest, &item) && flk_text_cut_last(item, " ", &item, &last))
        flk_task_unit(p, last); /* 45 deg 95 mm; file points.csv deg mm */
    if (IS_SET(flk_task_find(p, KEY_SYNTHESIS_CRANK)) &&
        !flk_task_range(p, KEY_SYNTHESIS_CRANK, QUANTITY_ANGLE, range))
        return 0;
    task->from = range[0];
    task->to = range[1];
    return 1;
}

static int read_weights(parser *p, const setting *s)
{
    deck_synthesis *t = p->d->synthesis;
    unsigned long i;

    if (flk_task_list(p, KEY_SYNTHESIS_WEIGHTS, QUANTITY_NUMBER, FOURLINK_PRECISION_MAX,
                      t->weight) != t->function.n)
        return flk_task_refuse(p, KEY_SYNTHESIS_WEIGHTS, "a weight for each of the points");
    for (i = 0; i < t->function.n; i++)
        if (!(t->weight[i] > 0))
            return flk_mistake(p->mistakes, s->place, "a weight must be positive");
    t->function.weight = t->weight;
    return 1;
}

int flk_task_function(parser *p)
{
    deck_synthesis *t = p->d->synthesis;
    setting *points = flk_task_find(p, KEY_SYNTHESIS_POINTS),
            *function = flk_task_find(p, KEY_SYNTHESIS_FUNCTION);
    const setting *weights = flk_task_find(p, KEY_SYNTHESIS_WEIGHTS);
    double length[5];
    int i, needs_length = t->kind->output == QUANTITY_ANGLE;

    flk_task_check_lengths(p, needs_length, needs_length ? "the length of one link" : "no lengths");
    if (flk_task_lengths(p, length) < needs_length)
        flk_mistake(p->mistakes, t->place,
                    "task = function needs the length of one link, such as that of the [ground]");
    if (!IS_SET(points) && !IS_SET(function))
        return flk_mistake(p->mistakes, t->place, "task = function needs 'points' or a 'function'");
    if (!(IS_SET(function) ? read_function(p, function) : read_points(p, points)))
        return 0;
    t->function.kind = t->kind->kind;
    t->function.theta2 = t->theta2;
    t->function.output = t->output;
    t->function.fit = (fourlink_fit)flk_task_find(p, KEY_SYNTHESIS_FIT)->word;
    t->function.ground = length[FOURLINK_GROUND];
    for (i = FOURLINK_CRANK; i <= FOURLINK_FOLLOWER; i++)
        if (length[i] > 0) {
            t->scaled_link = i;
            t->scaled_length = length[i];
            t->function.ground = 1;
        }
    return !IS_SET(weights) || read_weights(p, weights);
}
