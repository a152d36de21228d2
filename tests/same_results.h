/* SPDX-License-Identifier: GPL-3.0-or-later
**
** same_results.h - compares the results of a deck with those of the deck as a law changed it.
**
** A law holds to the byte, or to the one tolerance of the trials: a part of the scale of a column.  In a row the scale of
** a quantity is its largest value there, and at least what the motion and the forces give it; it is multiplied by the square
** of 1 / sin(mu), by which rounding grows near a dead position, and, if less of a value is determined, as of a direction of
** a small force, by that.  Along a motion it is the column's largest value.
*/
#ifndef SAME_RESULTS_H
#define SAME_RESULTS_H

#include <ctype.h>
#include <float.h>

#include "fourlink.h"
#include "fourlink/structures.h"
#include "random_schema.h"
#include "deck_lines.h"

#define MOST_COLUMNS 300
#define MOST_ROWS 200  /* that are compared of a branch */
#define SOME_COLUMNS 5 /* whose extremes and means are compared */
#define TEXT_SIZE 100000
#define UNCERTAIN 1e9 /* a value that is so many times less certain than others is not compared */
#define NEAR_DEAD 20  /* 1 / sin(mu) */

enum {
    ROW,
    COMPUTED_ROW,
    FITTED,
    EXTREME,
    NEAR_EXTREME,
    MEAN,
    RUBBING_MEAN,
    FACT,
    COMPUTED_FACT,
    N_SORTS
};
static const char *const sorts[N_SORTS] = {"row",  "computed", "fitted", "extreme", "near dead",
                                           "mean", "rubbing",  "fact",   "its fact"};
static const double tolerances[N_SORTS] = {2e-12, 1e-9, 1e-6, 1e-9, 1e-6, 1e-9, 1e-7, 1e-9, 1e-8};

/* A law: how it changes the deck, and what that makes of a column. */
typedef struct law {
    const char *name;
    int (*change)(deck_lines *d); /* 0: the law does not speak of this deck */
    double (*factor)(const fourlink_value *of);
    int is_exact, rows_backward, has_own_time;
    void (*check)(void); /* in place of comparing two decks */
    long cases, values, undecided, of_kind[4];
    double worst[N_SORTS];
} law;

static law *present; /* what is tried */
static long number, n_failed;
static int has_failed, kind; /* the case; the mechanism */
static deck_lines base, changed;
static char base_text[TEXT_SIZE], changed_text[TEXT_SIZE];
static char number_set[100]; /* of the base, after it was read; "": none */
static fourlink_value value_set;

static void leave(const char *words, const char *ending)
{
    char name[200];
    FILE *out;

    snprintf(name, sizeof name, "laws-%ld%s%s.deck", number, *ending ? "-" : "", ending);
    out = fopen(name, "w");
    if (out) {
        fputs(words, out);
        fclose(out);
    }
}

static void fail(const char *format, ...)
{
    va_list arguments;

    if (has_failed)
        return;
    has_failed = 1;
    n_failed++;
    va_start(arguments, format);
    printf("FAILED: %s, deck %ld: ", present->name, number);
    vprintf(format, arguments);
    printf("\n");
    va_end(arguments);
    leave(base_text, "");
    leave(changed_text, present->name);
}

/* Compare two numbers; what is expected first. */
static void compare(int sort, double expected, double value, double scale, const char *format, ...)
{
    va_list arguments;
    char where[300];
    double error;

    present->values++;
    if (present->is_exact) {
        if (memcmp(&expected, &value, sizeof value) == 0 || (isnan(expected) && isnan(value)))
            return;
        error = INFINITY;
    } else if (expected == value || (isnan(expected) && isnan(value)))
        return;
    else
        error = fabs(expected - value) / scale;
    if (error <= tolerances[sort]) {
        present->worst[sort] = fmax(present->worst[sort], error);
        return;
    }
    va_start(arguments, format);
    vsnprintf(where, sizeof where, format, arguments);
    va_end(arguments);
    fail("%s: %.17g, expected %.17g, %.2g of the scale", where, value, expected, error);
}

/* --------------------------------------------------------------------------------------------- columns */

enum { PLAIN, OF_ROUNDING, OF_POLE, OF_DIRECTION, OF_ARM, OF_EFFICIENCY };

typedef struct column {
    const fourlink_value *told;
    quantity q;
    int sort, of; /* OF_DIRECTION, OF_ARM: the column of the force */
} column;

typedef struct columns {
    int n;
    column list[MOST_COLUMNS];
} columns;

static int ends_in(const char *name, const char *ending)
{
    size_t n = strlen(name), k = strlen(ending);

    return n >= k && strcmp(name + n - k, ending) == 0;
}

/* 1 if a name is one of a list, whose words have blanks around. */
static int is_one_of(const char *name, const char *list)
{
    char with_blanks[100];

    snprintf(with_blanks, sizeof with_blanks, " %s ", name);
    return strstr(list, with_blanks) != NULL;
}

static int find_column(const columns *c, const char *name)
{
    int j;

    for (j = 0; j < c->n; j++)
        if (strcmp(c->list[j].told->name, name) == 0)
            return j;
    return -1;
}

static void list_columns(fourlink_results *r, columns *c)
{
    const fourlink_value *list;
    unsigned long n, j;
    char force[64];

    fourlink_results_list(r, FOURLINK_COLUMNS, &list, &n);
    if (n > MOST_COLUMNS)
        abort();
    c->n = 0;
    for (j = 0; j < n; j++) {
        column *k = &c->list[c->n++];
        const char *name = list[j].name;

        k->told = &list[j];
        k->q = flk_quantity_find(list[j].quantity);
        k->of = -1;
        k->sort = list[j].flags & FOURLINK_OF_ROUNDING ? OF_ROUNDING
                  : is_one_of(name, " I13x I13y I24x I24y klein_IX klein_IY mechanical_advantage ")
                      ? OF_POLE
                  : ends_in(name, "_dir")           ? OF_DIRECTION
                  : is_one_of(name, " h2 h3 h4 ")   ? OF_ARM
                  : strcmp(name, "efficiency") == 0 ? OF_EFFICIENCY
                                                    : PLAIN;
        snprintf(force, sizeof force, "%s%s", k->sort == OF_ARM ? "Fi" : "",
                 k->sort == OF_ARM ? name + 1 : name);
        if (k->sort == OF_DIRECTION)
            force[strlen(force) - 4] = '\0';
        if (k->sort == OF_DIRECTION || k->sort == OF_ARM)
            k->of = find_column(c, force);
    }
}

/* The value of a column in SI units; 0 if there is none. */
static double named(const columns *c, const double *row, const char *name)
{
    int j = find_column(c, name);

    return j < 0 || !isfinite(row[j]) ? 0 : row[j];
}

/* kg m2, of the crank, if its acceleration has an error as large as omega2^2 has: the torque has that of its inertia. */
static double inertia_in_doubt;

/* Of a row in SI units, the scale of each quantity, and 1 / sin(mu); `w` is the speed of the crank, or what counts as it. */
static double find_scales(const columns *c, const double *row, double crank, double w,
                          double *scale)
{
    double a = fabs(named(c, row, "alpha2")), condition, arm, x;
    int j;

    for (j = 0; j < QUANTITY_COUNT; j++)
        scale[j] = DBL_MIN;
    for (j = 0; j < c->n; j++)
        if (c->list[j].sort == PLAIN && isfinite(row[j]))
            scale[c->list[j].q] = fmax(scale[c->list[j].q], fabs(row[j]));
    scale[QUANTITY_ANGLE] = scale[QUANTITY_NUMBER] = 1;
#define AT_LEAST(q, size) scale[QUANTITY_##q] = fmax(scale[QUANTITY_##q], size)
    AT_LEAST(LENGTH, crank);
    arm = scale[QUANTITY_LENGTH];
    AT_LEAST(AREA, crank * crank);
    x = fabs(named(c, row, "x"));
    AT_LEAST(VOLUME, /* by the piston's area, or more */
             x > 0 ? fabs(named(c, row, "volume")) / x * arm : INFINITY);
    AT_LEAST(ANGULAR_SPEED, w);
    AT_LEAST(ANGULAR_ACCELERATION, pow(scale[QUANTITY_ANGULAR_SPEED], 2) + a);
    AT_LEAST(SPEED, crank * w);
    AT_LEAST(ACCELERATION, crank * (w * w + a));
    AT_LEAST(TORQUE, scale[QUANTITY_FORCE] * arm);
    AT_LEAST(FORCE, scale[QUANTITY_TORQUE] / arm);
    AT_LEAST(TORQUE, inertia_in_doubt * w * w);
    AT_LEAST(POWER, scale[QUANTITY_TORQUE] * w);
    AT_LEAST(ENERGY, scale[QUANTITY_TORQUE]);
#undef AT_LEAST
    condition = named(c, row, "condition");
    return condition > 1 ? condition : 1;
}

/* The larger component of a place that may be far away: in axes that are turned each has the error of both. */
static double size_of_place(const columns *c, int j, const double *row)
{
    char name[100];
    char *last = name + strlen(c->list[j].told->name) - 1;
    int other;

    snprintf(name, sizeof name, "%s", c->list[j].told->name);
    *last = (char)(*last == 'x' ? 'y' : *last == 'y' ? 'x' : *last == 'X' ? 'Y' : 'X');
    other = find_column(c, name);
    return other < 0 || !isfinite(row[other]) ? fabs(row[j]) : hypot(row[j], row[other]);
}

/* The scale of a value; infinite if it is not determined. */
static double scale_of(const columns *c, int j, const double *row, const double *scale,
                       double condition)
{
    const column *k = &c->list[j];
    double size = scale[k->q], doubt = 1, x = fabs(row[j]);

    switch (k->sort) {
    case OF_ROUNDING:
        return 1e3 * condition * condition / tolerances[ROW] * 1e-12;
    case OF_POLE: /* n / d is uncertain by its square / n */
        doubt = fmax(1, size_of_place(c, j, row) / size);
        size *= doubt;
        break;
    case OF_DIRECTION:
        doubt = k->of < 0 ? 1 : scale[QUANTITY_FORCE] / fabs(row[k->of]);
        break;
    case OF_ARM:
        doubt = k->of < 0 ? 1 : pow(scale[QUANTITY_FORCE] / fabs(row[k->of]), 2);
        break;
    case OF_EFFICIENCY:
        doubt =
            scale[QUANTITY_TORQUE] / fmin(fabs(named(c, row, "Ts")), fabs(named(c, row, "Ts0")));
        break;
    default:
        break;
    }
    if (is_one_of(k->told->name, " theta2 omega2 alpha2 time "))
        condition = 1;
    if (k->told->flags & FOURLINK_CRANK_ANGLE)
        size = fmax(size, x); /* of many turns */
    return doubt < UNCERTAIN ? size * doubt * condition * condition : INFINITY;
}

/* ------------------------------------------------------------------------------------------- two decks */

/* Open a deck; a mistake fails unless it is in a deck of which a sweep was left out, or in which a drawn angle is now one
** from the ground. */
/* Null, and the first mistake, if a deck is refused. */
static fourlink_results *open_deck(const char *words, const char *units, fourlink_mistake *mistake)
{
    fourlink_source source;
    fourlink_results *r = NULL;

    memset(mistake, 0, sizeof *mistake);
    memset(&source, 0, sizeof source);
    source.text = words;
    source.length = (unsigned long)strlen(words);
    source.units = units;
    source.synthesis = strstr(words, "[synthesis]") != NULL;
    fourlink_results_open(&source, 1, &r, mistake, NULL);
    return r;
}

static fourlink_results *opened(const char *words, const char *units)
{
    fourlink_mistake mistake;
    fourlink_results *r = open_deck(words, units, &mistake);

    if (r)
        return r;
    if (words != base_text || !(strstr(deck_text, "[sweep]") || strstr(deck_text, "= drawn") ||
                                strstr(mistake.message, "in the drawn position")))
        fail("line %ld: %s", mistake.line, mistake.message);
    return NULL;
}

static fourlink_problem problem_of(fourlink_results *r)
{
    fourlink_problem problem;

    fourlink_deck_problem(fourlink_results_deck(r), &problem);
    return problem;
}

static void to_si(const columns *c, double *row)
{
    int j;

    for (j = 0; j < c->n; j++)
        row[j] *= c->list[j].told->to_si;
}

static double within_turn(double angle)
{
    return remainder(angle, 2 * PI);
}

static double difference_of_angles(double expected, double value)
{
    return expected + within_turn(value - expected);
}

/* One side of a comparison. */
typedef struct side {
    fourlink_results *r;
    columns c;
    unsigned long rows;
} side;

/* 1 for a linkage that makes an error least, where its square root of rounding is flat. */
static int makes_error_least(fourlink_results *r)
{
    fourlink_value value;

    return strstr(base_text, "[synthesis]") &&
           (strstr(base_text, "\nfit = ") || strstr(base_text, "\nchoose = ") ||
            fourlink_results_find(r, "path_error", &value) == FOURLINK_OK);
}

static int is_fitted; /* by the side that was prepared last */

static void prepare(side *s, fourlink_results *r)
{
    s->r = r;
    if (!r)
        return;
    is_fitted = makes_error_least(r);
    list_columns(r, &s->c);
    s->rows = problem_of(r).n_rows;
}

static int is_computed(const char *words)
{
    return strstr(words, "mode = ") && !strstr(words, "mode = given");
}

static double factor_mirrored(const fourlink_value *of);

/* The largest values of the columns, and of each quantity, in the rows of a branch. */
static double sizes[MOST_COLUMNS], size_of_quantity[QUANTITY_COUNT];
static double quickest;                   /* rad/s, of the crank in those so far */
static double doubt = 1;                  /* of rows: by how much more the law may be wrong, */
static double doubt_of_accelerations = 1; /* ... and these and what follows from them */
static int was_locked;
static fourlink_branch compared; /* of the rows */

/* By how much more a row may be wrong than the integration of a turn: that errs in each one, and a steady motion gathers
** what a cycle leaves of a difference. */
static double doubt_of_motion(fourlink_results *r, double theta2)
{
    fourlink_value rate;
    double turns = 1 + fabs(theta2) / (2 * PI);

    if (strstr(base_text, "mode = steady") &&
        fourlink_results_value(r, "steady_rate", compared, 0, &rate) == FOURLINK_OK)
        turns /= fmax(1e-4, 1 - fabs(rate.value));
    return turns;
}

/* The same of a program: its times are rounded, so that the length of a segment is known to eps t / length, and forces follow
** it some hundreds of times as much, of the tolerance of 1e4 eps. */
static double doubt_of_program(void)
{
    const char *at = strstr(base_text, "\nprogram = ");
    double time, last = NAN, shortest = INFINITY;
    char word[20];

    for (at = at ? at + 11 : NULL; at && sscanf(at, "%lf %19[a-z]", &time, word) == 2;) {
        if (strcmp(word, "s") != 0)
            return 1;
        shortest = isnan(last) ? shortest : fmin(shortest, time - last);
        last = time;
        at += strcspn(at, ",\n");
        at = *at == ',' ? at + 1 : NULL;
    }
    return isnan(last) ? 1 : fmax(1, 0.1 * fabs(last) / shortest);
}

static int follows_from_accelerations(const column *k)
{
    return k->sort != PLAIN || k->q == QUANTITY_ANGULAR_ACCELERATION ||
           k->q == QUANTITY_ACCELERATION || k->q == QUANTITY_FORCE || k->q == QUANTITY_TORQUE ||
           k->q == QUANTITY_POWER;
}

/* Compare two rows, the expected one first, in the units of their columns.  Returns 1 / sin(mu). */
static double compare_rows(const side *a, const side *b, double *expected, double *row,
                           const char *where)
{
    double scale[QUANTITY_COUNT], condition, turns;
    int j, sort = is_fitted ? FITTED : is_computed(base_text) ? COMPUTED_ROW : ROW;

    for (j = 0; j < a->c.n; j++)
        expected[j] *= present->factor(a->c.list[j].told);
    if (!present->is_exact) {
        to_si(&a->c, expected);
        to_si(&b->c, row);
    }
    quickest = fmax(sort == COMPUTED_ROW || strstr(base_text, "\nprogram = ") ? quickest : 0,
                    fabs(named(&a->c, expected, "omega2")));
    condition = find_scales(&a->c, expected, problem_of(b->r).mechanism.design.link[2].length,
                            quickest, scale);
    for (j = 0; j < QUANTITY_COUNT && sort == COMPUTED_ROW && strstr(base_text, "[motor]"); j++)
        scale[j] = fmax(scale[j], size_of_quantity[j]); /* a steep motor has the speed's error */
    turns = sort == COMPUTED_ROW ? doubt_of_motion(a->r, named(&a->c, expected, "theta2"))
                                 : doubt_of_program();
    for (j = 0; j < a->c.n; j++) {
        double size = doubt *
                      (follows_from_accelerations(&a->c.list[j]) ? doubt_of_accelerations : 1) *
                      turns * scale_of(&a->c, j, expected, scale, condition);

        if (!present->is_exact && (!isfinite(size) || a->c.list[j].sort == OF_ROUNDING ||
                                   (present->has_own_time && a->c.list[j].q == QUANTITY_TIME))) {
            present->undecided++;
            continue;
        }
        if (isfinite(expected[j]))
            sizes[j] = fmax(sizes[j], fabs(expected[j]));
        if (a->c.list[j].sort == PLAIN)
            size_of_quantity[a->c.list[j].q] = fmax(size_of_quantity[a->c.list[j].q], sizes[j]);
        if (present->factor == factor_mirrored && kind == FOURLINK_SCOTCH_YOKE &&
            strcmp(a->c.list[j].told->name, "theta3") == 0)
            expected[j] += PI; /* the other direction of the slot */
        if (!present->is_exact && a->c.list[j].q == QUANTITY_ANGLE)
            row[j] = difference_of_angles(expected[j], row[j]);
        compare(sort, expected[j], row[j], size, "%s, %s", where, a->c.list[j].told->name);
    }
    return condition;
}

/* 1 in a row where a position turns back that a load follows: rounding decides which way it goes. */
static int turns_back(const columns *c, const double *row)
{
    static const char *const rates[] = {"omega4", "v", "slide_v"};
    int j, k;

    for (k = 0; k < 3 && strstr(base_text, "\nback = "); k++) {
        j = find_column(c, rates[k]);
        if (j >= 0 && fabs(row[j] * c->list[j].told->to_si) < 1e-9 * fabs(named(c, row, "omega2")))
            return 1;
    }
    return 0;
}

/* rad/s, of the crank in all rows of a program, which can begin at rest; 0 for other motions. */
static double quickest_of_program(const side *a, fourlink_branch branch)
{
    static double row[MOST_COLUMNS];
    int j = find_column(&a->c, "omega2");
    double most = 0;
    unsigned long i;

    for (i = 0; j >= 0 && i < a->rows && strstr(base_text, "\nprogram = "); i++) {
        fourlink_results_row(a->r, branch, i, row, NULL, NULL);
        most = fmax(most, fabs(row[j] * present->factor(a->c.list[j].told) *
                               (present->is_exact ? 1 : a->c.list[j].told->to_si)));
    }
    return most;
}

/* 1 in a row of a program at rest, with friction: rounding decides which way it is about to go. */
static int is_at_rest(const columns *c, const double *row)
{
    return strstr(base_text, "\nprogram = ") && strstr(base_text, "[friction]") &&
           fabs(named(c, row, "omega2")) * c->list[find_column(c, "omega2")].told->to_si <=
               1e-12 * quickest;
}

/* 1 where a torsional spring that acts one way is at its free angle: rounding decides whether its damping acts. */
static int is_at_free_angle(const columns *c, const double *row)
{
    char name[100];
    int i, j;

    for (i = 0; i < base.n; i++) {
        deck_block *b = &base.block[i];

        if (!line_of(b, KEY_SPRING_ONLY) || !line_of(b, KEY_SPRING_DAMPING) ||
            line_of(b, KEY_SPRING_FREE_ANGLE) || sscanf(b->header, "[spring %80[^]]", name) != 1)
            continue;
        strcat(name, ".angle");
        j = find_column(c, name);
        if (j >= 0 && fabs(row[j]) * c->list[j].told->to_si < 1e-12)
            return 1;
    }
    return 0;
}

/* Rows whose statuses differ: near a dead position rounding decides, and so does where the steps of a motion that takes
** too many end. */
static void compare_statuses(const side *a, const double *expected, int status, const side *b,
                             const double *row, int told, const char *where)
{
    double condition = fmax(named(&a->c, expected, "condition"), named(&b->c, row, "condition"));

    if (present->is_exact || (condition > 0 && condition < 1e4 && status != FOURLINK_TOO_LONG &&
                              told != FOURLINK_TOO_LONG))
        fail("%s: status %d, expected %d", where, told, status);
    present->undecided++;
}

/* Compare the rows of b with those of a, from the one with this number; those from its end, where time is
** reversed.  1 if a row is
** near a dead position or at rest. */
static int compare_branch_rows(const side *a, const side *b, fourlink_branch branch,
                               fourlink_branch other, unsigned long first)
{
    static double expected[MOST_COLUMNS], row[MOST_COLUMNS];
    unsigned long step = b->rows / MOST_ROWS + 1, i;
    int is_near = 0;

    was_locked = 0;
    compared = branch;
    quickest = quickest_of_program(a, branch);
    memset(sizes, 0, sizeof sizes);
    memset(size_of_quantity, 0, sizeof size_of_quantity);
    for (i = 0; i < b->rows && !has_failed; i += step) {
        unsigned long k = present->rows_backward ? a->rows - 1 - i : first + i;
        int status = fourlink_results_row(a->r, branch, k, expected, NULL, NULL);
        int told = fourlink_results_row(b->r, other, i, row, NULL, NULL);
        char where[100];
        double condition;

        snprintf(where, sizeof where, "%s, row %lu", fourlink_branch_text(branch), k);
        was_locked |= status == FOURLINK_LOCKED;
        if (status != told) {
            compare_statuses(a, expected, status, b, row, told, where);
            is_near = 1;
            continue;
        }
        if ((present->factor == factor_mirrored && turns_back(&a->c, expected)) ||
            (!present->is_exact &&
             (is_at_rest(&a->c, expected) || is_at_free_angle(&a->c, expected) ||
              is_at_free_angle(&b->c, row)))) {
            present->undecided++;
            continue;
        }
        condition = compare_rows(a, b, expected, row, where);
        is_near |=
            status != FOURLINK_OK || condition > NEAR_DEAD || named(&a->c, expected, "omega2") == 0;
    }
    return is_near;
}

/* The sort of a statistic: with friction |N| is not smooth where N changes its sign. */
static int sort_of_statistic(int which, int is_near)
{
    return is_fitted                         ? FITTED
           : is_near                         ? NEAR_EXTREME
           : which < FOURLINK_MEAN           ? EXTREME
           : strstr(base_text, "[friction]") ? RUBBING_MEAN
                                             : MEAN;
}

/* 1 if statistics of a branch are determined: where friction locks a machine its forces are not, and a
** computed motion that
** runs into a dead position has the extremes of the last place that it reached. */
static int is_determined(fourlink_results *r, fourlink_branch branch, int is_near)
{
    double end;

    return !was_locked && !(is_near && strstr(base_text, "[friction]")) &&
           fourlink_results_end(r, branch, &end) == FOURLINK_OK;
}

static double statistic(const side *s, int j, fourlink_branch branch, int which, int *status)
{
    fourlink_value value;

    *status = fourlink_results_get(s->r, s->c.list[j].told->handle + which, branch, 0, &value);
    return *status == FOURLINK_OK ? value.value * (present->is_exact ? 1 : value.to_si) : NAN;
}

/* 1 if extremes and means of a column are compared. */
static int has_statistics(const column *k, int which)
{
    if (present->is_exact)
        return 1;
    /* Ts_static grows without bound where friction would lock the machine at a crawl, which no limit
    ** knows. */
    if (strstr(base_text, "[friction]") && is_one_of(k->told->name, " Ts_static Ts_inertia "))
        return 0;
    if (strcmp(k->told->name, "structural_error") == 0)
        return 0; /* the ends of its range within the motion are not sought */
    return k->sort == PLAIN && !(k->told->flags & FOURLINK_CRANK_ANGLE) &&
           (k->q != QUANTITY_ANGLE || is_one_of(k->told->name, " mu gamma ")) &&
           !(present->has_own_time && k->q == QUANTITY_TIME) && which;
}

static int comes_to_rest(const side *s, fourlink_branch branch)
{
    int j = find_column(&s->c, "omega2"), status;
    double high = statistic(s, j, branch, FOURLINK_MAX, &status),
           low = statistic(s, j, branch, FOURLINK_MIN, &status);

    return high * low <= 0 || fmin(fabs(high), fabs(low)) < 1e-6 * fmax(fabs(high), fabs(low));
}

/* 1 if a column of a quantity is unbounded: then those that cancel have its rounding error. */
static int is_unbounded(const side *s, quantity q, fourlink_branch branch)
{
    int j, status;

    for (j = 0; j < s->c.n; j++)
        if (s->c.list[j].q == q && (isinf(statistic(s, j, branch, FOURLINK_MAX, &status)) ||
                                    isinf(statistic(s, j, branch, FOURLINK_MIN, &status))))
            return 1;
    return 0;
}

static void compare_statistics(const side *a, const side *b, fourlink_branch branch,
                               fourlink_branch other, int is_near)
{
    static const char *const names[] = {"", "max", "min", "mean", "rms"};
    int some, which, status, told;

    is_near |= comes_to_rest(a, branch);
    if (!present->is_exact && !is_determined(a->r, branch, is_near)) {
        present->undecided++;
        return;
    }
    for (some = 0; some < SOME_COLUMNS && !has_failed; some++) {
        int j = one_of(a->c.n);
        double factor = present->factor(a->c.list[j].told);

        for (which = FOURLINK_MAX; which <= FOURLINK_RMS && has_statistics(&a->c.list[j], which);
             which++) {
            int turned =
                which < FOURLINK_MEAN && factor < 0 ? FOURLINK_MAX + FOURLINK_MIN - which : which;
            double value = statistic(b, j, other, turned, &told),
                   expected = statistic(a, j, branch, which, &status) * factor;
            double size =
                fmax(sizes[j], which < FOURLINK_MEAN && isfinite(expected) ? fabs(expected) : 0);

            if (which < FOURLINK_MEAN) /* its rows are no better */
                size = fmax(size, tolerances[ROW] / tolerances[EXTREME] *
                                      size_of_quantity[a->c.list[j].q]);
            size *= doubt_of_motion(a->r, 0);
            expected = which == FOURLINK_RMS ? fabs(expected) : expected;
            if (!present->is_exact && (!(size > 1e-9 * size_of_quantity[a->c.list[j].q]) ||
                                       (isinf(value) && isinf(expected)))) {
                present->undecided++;
                continue;
            }
            if (!present->is_exact && is_near &&
                fabs(value - expected) > tolerances[NEAR_EXTREME] * size &&
                is_unbounded(a, a->c.list[j].q, branch)) {
                present->undecided++;
                continue;
            }
            if (status != told)
                fail("%s(%s) on %d: status %d, expected %d", names[which], a->c.list[j].told->name,
                     (int)branch, told, status);
            compare(sort_of_statistic(which, is_near), expected, value, size, "%s(%s) on %d",
                    names[which], a->c.list[j].told->name, (int)branch);
        }
    }
}

/* Energies over a cycle are differences of works: where they are small beside the mean torque's they have its rounding
** error.  By how much more they may be wrong. */
static double doubt_of_energies(const fourlink_value *facts, unsigned long n)
{
    unsigned long i;

    for (i = 0; i < n; i++)
        if (strcmp(facts[i].name, "energy_coefficient") == 0)
            return fmax(1, 1e-6 / fabs(facts[i].value));
    return 1;
}

/* Facts of a motion that takes too many steps depend on where its budget ended. */
static int takes_too_many_steps(fourlink_results *r, fourlink_branch branch)
{
    double end;

    return fourlink_results_end(r, branch, &end) == FOURLINK_TOO_LONG;
}

/* Facts, where the law leaves what they mean as it is. */
static void compare_facts(const side *a, const side *b, fourlink_branch branch)
{
    const fourlink_value *facts, *told;
    unsigned long n, m, i;
    double masses = DBL_MIN; /* the largest so far: m_b is the rest of the rod's */
    const int groups = FOURLINK_FACTS_LIMITS | FOURLINK_FACTS_TURNING | FOURLINK_FACTS_MOTION;
    const double d = problem_of(a->r).mechanism.design.link[FOURLINK_GROUND].length;

    if (takes_too_many_steps(a->r, branch) || takes_too_many_steps(b->r, branch)) {
        present->undecided++;
        return;
    }
    fourlink_results_facts(a->r, branch, groups, &facts, &n);
    fourlink_results_facts(b->r, branch, groups, &told, &m);
    if (n != m)
        fail("%lu facts on %d, expected %lu", m, (int)branch, n);
    for (i = 0; i < n && !has_failed; i++) {
        double expected = facts[i].value * present->factor(&facts[i]), value = told[i].value, scale;

        if (strcmp(facts[i].name, told[i].name) != 0)
            fail("the fact %s, expected %s", told[i].name, facts[i].name);
        if (strcmp(facts[i].quantity, "mass") == 0)
            masses = fmax(masses, fabs(expected) * facts[i].to_si);
        if (facts[i].words) {
            present->values++;
            if (!told[i].words || strcmp(facts[i].words, told[i].words) != 0)
                fail("%s: %s, expected %s", facts[i].name,
                     told[i].words ? told[i].words : "a number", facts[i].words);
            continue;
        }
        if (!present->is_exact) {
            expected *= facts[i].to_si;
            value *= told[i].to_si;
        }
        scale = strcmp(facts[i].quantity, "mass") == 0 ? masses
                : strncmp(facts[i].name, "path_error", 10) == 0
                    ? fmax(expected, d) /* of many points: a distance */
                : strcmp(facts[i].name, "efficiency_cycle") == 0 ? 1
                : is_one_of(facts[i].name, " mu_min mu_max gamma_min gamma_max ")
                    ? 1 / fmax(fabs(sin(expected)), 1e-9) /* an arc cosine */
                : strcmp(facts[i].name, "motor_torque") == 0
                    ? fmax(fabs(expected), 1e-3) /* of a cycle without work it is rounding error */
                : is_one_of(facts[i].name, " energy_fluctuation energy_coefficient "
                                           "flywheel_inertia flywheel_fluctuation ")
                    ? fabs(expected) * doubt_of_energies(facts, n)
                : strcmp(facts[i].name, "steady_rate") == 0 ? 100 /* of differences, over a cycle */
                : strcmp(facts[i].name, "K") == 0                 /* a difference of squares */
                    ? fmax(fabs(expected), d * d)
                    : fabs(expected);
        if (!present->is_exact && strcmp(facts[i].quantity, "angle") == 0) {
            value = difference_of_angles(expected, value);
            scale = is_one_of(facts[i].name, " mu_min mu_max gamma_min gamma_max ") ? scale
                    : ends_in(facts[i].name, "_from") || ends_in(facts[i].name, "_to") ||
                            ends_in(facts[i].name, "dead_centre")
                        ? 1e3
                        : 1;
        }
        scale *= doubt_of_motion(a->r, 0);
        compare(is_fitted                ? FITTED
                : is_computed(base_text) ? COMPUTED_FACT
                                         : FACT,
                expected, value, scale, "%s on %d", facts[i].name, (int)branch);
    }
}

#endif
