/* SPDX-License-Identifier: GPL-3.0-or-later
**
** opened.c - a deck or a design opened for results.
*/
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include <gsl/gsl_math.h>

#include "base/cycle.h"
#include "base/quantity.h"
#include "deck/at_angle.h"
#include "deck/reader.h"
#include "deck/settings.h"
#include "deck/synthesis.h"
#include "fact.h"
#include "mean.h"
#include "opened.h"

int flk_opened_prepare(flk_opened *o, int branch, int groups)
{
    int has_facts = (groups & (FOURLINK_FACTS_TURNING | FOURLINK_FACTS_MOTION)) != 0;
    int of_motion = groups & ~(FOURLINK_FACTS_LIMITS | FOURLINK_FACTS_NAMES);
    int status = FOURLINK_OK, i;

    for (i = 0; i < 2 && status == FOURLINK_OK && of_motion; i++) {
        int each = i == 0 ? FOURLINK_OPEN : FOURLINK_CROSSED;

        if (branch ? branch == each : i == 0 ? o->d.open : o->d.crossed)
            status = flk_actual_prepare(o->a.course.actual, (fourlink_branch)each, has_facts);
    }
    return status == FOURLINK_OK && (groups & FLK_SEARCHES) && !flk_extremes_prepare(&o->extremes)
               ? FOURLINK_NO_MEMORY
               : status;
}

/* ---------------------------------------------------------------------------------------------- opening */

/* Report a NAME at ANGLE that has no value, or no handle. */
static void refuse_at(flk_opened *o, text name, const flk_name *n, text_place place)
{
    mistakes *m = &o->d.mistakes;
    char message[MESSAGE_SIZE];
    double angle;
    flk_name other;

    flk_name_find(o, n->of, &other);
    if (name.length >= DECK_NAME_SIZE)
        flk_mistake(m, place, "the name '%t' is too long: more than %g letters", name,
                    DECK_NAME_SIZE - 1.0);
    else if (other.kind == FLK_NAME_UNKNOWN)
        flk_mistake(m, place, "no column '%t'%h%s", n->of, flk_column_nearest(&o->a, n->of),
                    flk_column_nearest(&o->a, n->of) ? "" : "; see --list");
    else if (other.kind != FLK_NAME_COLUMN)
        flk_mistake(m, place, "'%t' is one value of the deck: it has none at an angle", n->of);
    else if (!flk_at_angle_read(&o->d, n->at, &angle, message))
        flk_mistake(m, place, "%s", message);
}

/* Check a name in the [sweep] output: a fact, a statistic of a column, a column at an angle, or an input; a
** column only if the deck has one instant. */
static void check_output(flk_opened *o, text name, const flk_name *n, text_place place)
{
    mistakes *m = &o->d.mistakes;
    char statistic[DECK_NAME_SIZE];
    const char *nearest, *meant;

    if (n->at.start) {
        if (!n->handle)
            refuse_at(o, name, n, place);
        return;
    }
    if (!o->d.over->is_crank_angle && flk_fact_group(n->handle) > FOURLINK_FACTS_LIMITS)
        flk_mistake(m, place, "'%t' needs rows by angle; these are rows by %s", name,
                    o->d.over->rows);
    else if (o->d.machine.mechanism.drive && flk_fact_group(n->handle) == FOURLINK_FACTS_TURNING)
        flk_mistake(m, place, "'%t' is of a torque on the crank, which does not drive", name);
    if (n->kind == FLK_NAME_STATISTIC || n->kind == FLK_NAME_FACT || n->kind == FLK_NAME_GIVEN ||
        (n->kind == FLK_NAME_COLUMN && o->d.one_instant))
        return;
    meant = flk_column_meant(&o->a, n->of); /* torque: max(Ts) */
    nearest = n->statistic ? flk_column_nearest(&o->a, n->of)
              : meant      ? meant
                           : flk_fact_nearest(&o->d, name);
    if ((n->statistic || meant) && nearest)
        nearest =
            flk_column_statistic_text(n->statistic ? n->statistic : FLK_MAX, nearest, statistic);
    flk_mistake(m, place,
                n->kind == FLK_NAME_COLUMN
                    ? "'%t' has a value in each row: use its max(), min(), mean() or rms()%h"
                    : "'%t' is neither a fact nor the max(), min(), mean() or rms() of a column of "
                      "this deck%h",
                name, nearest);
}

/* Ask for the extreme that a name stands for, if it is one. */
static void ask_extreme(flk_opened *o, const flk_name *n)
{
    if (n->kind == FLK_NAME_STATISTIC && (n->statistic == FLK_MAX || n->statistic == FLK_MIN))
        flk_extremes_ask(&o->extremes, &n->c);
}

/* Ask for the extremes that are found in one search with those of a sweep's outputs: those of the columns
** of a deck without a sweep, and those that are expected. */
static void ask_extremes(flk_opened *o)
{
    flk_name n;
    text of;
    size_t i;

    o->extremes.is_together = o->d.sweep.n_variables > 0;
    for (i = 0; i < o->n_columns && !o->d.sweep.n_variables; i++)
        if (!(flk_column_flags(&o->columns[i]) & FOURLINK_CRANK_ANGLE))
            flk_extremes_ask(&o->extremes, &o->columns[i]);
    for (i = 0; i < o->d.n_expectations; i++)
        if (flk_column_statistic_of(o->d.expectations[i].name, &of)) {
            flk_name_find(o, o->d.expectations[i].name, &n);
            ask_extreme(o, &n);
        }
}

#define MOST_OUTPUTS 64

/* Add an output, or find it; null and a mistake if there are too many. */
static const fourlink_value *add_output(flk_opened *o, text name, text_place place, int is_new)
{
    flk_list *outputs = &o->lists[FOURLINK_OUTPUTS];
    fourlink_value *output = &outputs->list[outputs->n];
    unsigned long i;
    flk_name n;

    for (i = 0; i < outputs->n && !is_new; i++)
        if (flk_text_same(name, outputs->list[i].name))
            return &outputs->list[i];
    if (outputs->n == MOST_OUTPUTS) {
        flk_mistake(&o->d.mistakes, place, "more than 64 outputs");
        return NULL;
    }
    flk_name_find(o, name, &n);
    if (!flk_name_keep(o, name, &n))
        n.kind = FLK_NAME_UNKNOWN;
    flk_name_describe(o, &n, output);
    output->line_unit = NULL;
    check_output(o, name, &n, place);
    ask_extreme(o, &n);
    output->name =
        flk_text_copy(name, outputs->names + DECK_NAME_SIZE * outputs->n++, DECK_NAME_SIZE);
    return output;
}

/* The outputs and conditions of another design, without looking up their names. */
static int copy_outputs(flk_opened *o, const flk_opened *from)
{
    const flk_list *outputs = &from->lists[FOURLINK_OUTPUTS],
                   *conditions = &from->lists[FOURLINK_CONDITIONS];
    unsigned long i;
    flk_name n;

    for (i = 0; i < outputs->n; i++) {
        flk_name_of_handle(o, outputs->list[i].handle, &n);
        if (n.kind != FLK_NAME_STATISTIC && n.kind != FLK_NAME_FACT && n.kind != FLK_NAME_AT)
            return 0;
        ask_extreme(o, &n);
    }
    memcpy(o->lists[FOURLINK_OUTPUTS].list, outputs->list, outputs->n * sizeof *outputs->list);
    memcpy(o->lists[FOURLINK_CONDITIONS].list, conditions->list,
           conditions->n * sizeof *conditions->list);
    o->lists[FOURLINK_OUTPUTS].n = outputs->n;
    o->lists[FOURLINK_CONDITIONS].n = conditions->n;
    return 1;
}

/* Find, of the columns that the deck names, the first that has a value in each row, and the first that has
** one for the deck, such as a fact; null: there is none.  Where there is neither, a name like that of a fact
** is taken for a fact. */
static void sort_columns(flk_opened *o, text *of_rows, text *of_deck)
{
    text rest = o->d.columns.names, name, similar;
    flk_name n;

    similar.start = NULL;
    of_rows->start = of_deck->start = NULL;
    while (rest.start && flk_column_next_name(&rest, &name)) {
        flk_name_find(o, name, &n);
        if (!of_rows->start && (n.kind == FLK_NAME_COLUMN || flk_text_equal(name, "all")))
            *of_rows = name;
        else if (!of_deck->start && (n.statistic || n.at.start || n.kind > FLK_NAME_COLUMN))
            *of_deck = name;
        else if (!similar.start && !flk_column_is_known(name) && !flk_column_nearest(&o->a, name) &&
                 flk_fact_nearest(&o->d, name))
            similar = name;
    }
    if (!of_rows->start && !of_deck->start)
        *of_deck = similar;
}

/* Columns of which each is one value of the deck are its outputs; then its table has the usual columns. */
static void take_values(flk_opened *o)
{
    text of_rows, of_deck;

    sort_columns(o, &of_rows, &of_deck);
    if (!of_deck.start)
        return;
    if (of_rows.start)
        flk_mistake(&o->d.mistakes, o->d.columns.place,
                    "'%t' is one value of the deck, '%t' has one in each row: ask for them apart",
                    of_deck, of_rows);
    else
        o->d.sweep.output = o->d.columns;
    o->d.has_values = !of_rows.start;
    o->d.columns.names.start = NULL;
}

static void list_outputs(flk_opened *o)
{
    text_place place = o->d.sweep.output.place;
    text rest = o->d.sweep.output.names, name;

    while (rest.start && flk_column_next_name(&rest, &name))
        if (!add_output(o, name, place, 1))
            return;
    if (o->d.sweep.output.names.start && !o->lists[FOURLINK_OUTPUTS].n)
        flk_mistake(&o->d.mistakes, place, "'output' names nothing");
}

/* NAME > QUANTITY */
typedef struct condition {
    text whole, name, limit;
    int flags; /* FOURLINK_ABOVE ... */
} condition;

static const struct {
    const char *sign;
    int flags;
} sign_table[] = {{">=", FOURLINK_ABOVE | FOURLINK_OR_EQUAL},
                  {"<=", FOURLINK_BELOW | FOURLINK_OR_EQUAL},
                  {">", FOURLINK_ABOVE},
                  {"<", FOURLINK_BELOW}};

#define SIGNS (sizeof sign_table / sizeof sign_table[0])

/* Take the next condition from a list separated by commas.  Returns 1; 0 at the end; -1 if `whole`, its
** text, is not a condition. */
static int next_condition(text *rest, condition *c)
{
    size_t i;

    if (!flk_text_split(rest, ',', &c->whole))
        return 0;
    c->whole = flk_text_trim(c->whole);
    if (!c->whole.length && !rest->start)
        return 0; /* a comma at the very end */
    for (i = 0; i < SIGNS; i++)
        if (flk_text_cut(c->whole, sign_table[i].sign, &c->name, &c->limit))
            break;
    if (i == SIGNS || !c->name.length || !c->limit.length)
        return -1;
    c->flags = sign_table[i].flags;
    return 1;
}

/* Add a condition of the yield; its name is an output too.  Returns 0 if there are too many. */
static int add_condition(flk_opened *o, const condition *c)
{
    flk_list *list = &o->lists[FOURLINK_CONDITIONS];
    text_place place = o->d.sweep.yield.place;
    const fourlink_value *output = add_output(o, c->name, place, 0);
    char message[MESSAGE_SIZE];
    quantity_value limit;
    fourlink_value *v;
    quantity q;

    if (!output || list->n == MOST_OUTPUTS)
        return 0;
    if (!output->quantity)
        return 1; /* not known: already reported */
    q = flk_quantity_find(output->quantity);
    if (!flk_quantity_read(c->limit, c->limit, q, o->d.bare[q].unit, &limit, message))
        return flk_mistake(&o->d.mistakes, place, "%s", message) + 1;
    v = &list->list[list->n];
    *v = *output;
    v->value = flk_unit_from_si(limit.si, o->d.units[q].unit);
    v->flags = c->flags;
    v->meaning = flk_text_copy(c->whole, list->names + DECK_NAME_SIZE * list->n++, DECK_NAME_SIZE);
    return 1;
}

static void list_conditions(flk_opened *o)
{
    text rest = o->d.sweep.yield.names;
    condition c;
    int status = 0;

    while (rest.start && (status = next_condition(&rest, &c)) != 0) {
        if (status < 0)
            flk_mistake(&o->d.mistakes, o->d.sweep.yield.place,
                        "expected a condition, such as mu_min > 40 deg, not '%t'", c.whole);
        else if (!add_condition(o, &c))
            return;
    }
}

/* Allocate the facts and all lists in one piece, with as many names; 0 if out of memory.  A piece that
** is the largest part of a design stays with the C library's heap: smaller ones went back to the system
** with each design of a sweep. */
static int allocate(flk_opened *o)
{
    size_t columns = flk_column_limit(&o->d), size[FOURLINK_CONDITIONS + 1], total = FLK_FACT_LIMIT;
    size_t n = size[0] = FLK_FACT_LIMIT + FLK_STATISTICS * columns, n_names;
    int i;

    size[FOURLINK_COLUMNS] = size[FOURLINK_ALL_COLUMNS] = columns;
    size[FOURLINK_INPUTS] = flk_list_input_limit(&o->d);
    size[FOURLINK_VARIABLES] = o->d.sweep.n_variables;
    size[FOURLINK_OUTPUTS] = size[FOURLINK_CONDITIONS] = MOST_OUTPUTS;
    for (i = 0; i <= FOURLINK_CONDITIONS; i++)
        total += size[i];
    n_names = total + flk_line_unit_limit(&o->d) + FLK_AT_NAMES;
    o->columns = malloc(columns * sizeof *o->columns);
    o->facts.list = malloc(total * sizeof *o->facts.list + n_names * DECK_NAME_SIZE);
    o->checks = calloc(GSL_MIN(o->d.n_expectations, FLK_CHECKS_KEPT) + 1, sizeof *o->checks);
    if (!o->columns || !o->facts.list || !o->checks)
        return 0;
    o->facts.names = (char *)(o->facts.list + total);
    for (i = 1; i <= FOURLINK_CONDITIONS; n += size[i++]) {
        o->lists[i].list = o->facts.list + n;
        o->lists[i].names = o->facts.names + n * DECK_NAME_SIZE;
    }
    o->found.list = o->facts.list + n;
    o->at_names = o->facts.names + total * DECK_NAME_SIZE;
    o->line_units.texts = o->at_names + FLK_AT_NAMES * DECK_NAME_SIZE;
    return flk_turning_open(&o->a) && flk_means_open(&o->a, columns) &&
           flk_extremes_open(&o->extremes, columns);
}

/* Open a deck without mistakes, which may be a design of another, or `like` another; 0 if out of memory. */
static int open_deck(flk_opened *o, const flk_opened *from, const flk_opened *like)
{
    size_t i;

    if (o->d.sweep.n_variables && !o->d.solver)
        o->d.solver = SOLVER_DYAD;
    if (like && !flk_settings_move_alike(&o->d, &like->d))
        like = NULL;
    if (!flk_analysis_open(&o->a, &o->d, like ? &like->a : NULL) || !allocate(o))
        return 0;
    if (from) {
        flk_names_take(o, from);
        o->n_columns = flk_column_copy(&o->a, &from->a, from->columns, from->n_columns, o->columns);
    }
    if (!o->n_columns) {
        take_values(o);
        o->n_columns = flk_column_choose(&o->a, &o->d.mistakes, o->columns);
    }
    o->is_of_places =
        !o->d.machine.has_friction && !o->d.prescribed && !o->d.machine.mechanism.design.n_groups;
    for (i = 0; i < o->n_columns; i++) {
        o->needs |= flk_column_need(&o->columns[i]);
        o->is_of_places &= flk_column_is_of_places(&o->columns[i]);
    }
    if (!from || !copy_outputs(o, from)) {
        list_outputs(o);
        list_conditions(o);
    }
    ask_extremes(o);
    flk_list_variables(&o->d, &o->line_units, &o->lists[FOURLINK_VARIABLES]);
    return 1;
}

#define TRIES 1000
#define LONG_DECK 100000 /* bytes: too long to be read so often */

/* Read a deck.  FOURLINK_ANY_DESIGN reads the first design without mistakes, or the first design if all those
** tried have mistakes. */
static int read_deck(const fourlink_source *source, deck *d)
{
    fourlink_source one = *source;
    unsigned long n, i;
    deck other;
    int status;

    if (source->design != FOURLINK_ANY_DESIGN)
        return flk_deck_read(source, d);
    one.design = 0;
    status = flk_deck_read(&one, d);
    n = d->sweep.n_designs;
    if (source->length > LONG_DECK)
        n = 1;
    for (i = 1; status == 0 && i < n && i < 2 * TRIES; i++) {
        one.design = i < TRIES || n < 2 * TRIES ? i : n / TRIES * (i - TRIES);
        status = flk_deck_design(d, one.design, NULL, 0, &other);
        flk_deck_free(&other);
        if (status == 1) {
            flk_deck_free(d);
            return flk_deck_read(&one, d);
        }
    }
    return status;
}

/* Keep what a stretch has of a range; 0 if that is nothing. */
static int cut_range(const flk_stretch *s, double *low, double *high)
{
    double lowest = GSL_MAX(*low, GSL_MIN(s->from, s->to)),
           highest = GSL_MIN(*high, GSL_MAX(s->from, s->to));

    if (!(lowest < highest))
        return 0;
    *low = lowest;
    *high = highest;
    return 1;
}

/* The same of what is prescribed: the range that all branches and sides have, else that of the open one. */
static void hold_prescribed(deck *d)
{
    deck_prescribed *x = d->prescribed;
    fourlink_motion *motion = &x->motion;
    fourlink_branch branch = d->open ? FOURLINK_OPEN : FOURLINK_CROSSED;
    const flk_stretch *s = DECK_STRETCH(x, branch, x->side),
                      *other = DECK_STRETCH(x, FOURLINK_CROSSED, x->side);
    double low = GSL_MIN(s->from, s->to), high = GSL_MAX(s->from, s->to);
    double turn = motion->speed != 0 ? motion->speed : motion->acceleration;

    if (d->open && d->crossed)
        d->crossed = s->side == other->side && cut_range(other, &low, &high);
    x->has_both = x->has_both &&
                  cut_range(DECK_STRETCH(x, branch, FOURLINK_FALLING), &low, &high) &&
                  (!d->crossed ||
                   cut_range(DECK_STRETCH(x, FOURLINK_CROSSED, FOURLINK_FALLING), &low, &high));
    motion->from = (turn < 0 ? high : low) + motion->x_at;
    motion->to = (turn < 0 ? low : high) + motion->x_at;
    motion->interval = (high - low) / 72;
    motion->hold = 1;
    x->is_at_crank = 0;
}

/* Replace one instant by the cycle that it is in, with its speed and acceleration. */
static void hold_instant(deck *d)
{
    fourlink_motion *motion = &d->motion;
    double turn = motion->speed != 0 ? motion->speed : motion->acceleration;
    double cycle = flk_unit_from_si(d->machine.cycle, d->units[QUANTITY_ANGLE].unit);

    motion->interval = cycle / 72;
    cycle = turn < 0 ? -cycle : cycle;
    motion->from = cycle * flk_cycle_count(motion->from, cycle) + 0.0;
    motion->to = motion->from + cycle;
    motion->hold = 1;
    d->one_instant = 0;
    if (d->prescribed)
        hold_prescribed(d);
}

static int is_fact(text name)
{
    return flk_fact_find(NULL, name) != 0;
}

/* Open results of their deck, with the status of flk_deck_read; `from` and `like` as in open_deck. */
static int open_results(flk_opened *o, const flk_opened *from, const flk_opened *like, int status,
                        const flk_mistake_list *list, flk_opened **opened)
{
    if (status > 0 && o->whole_cycle && o->d.one_instant)
        hold_instant(&o->d);
    if (status > 0 && !open_deck(o, from, like))
        status = -1;
    else if (status == 0)
        flk_column_check(&o->d, is_fact);
    if (status < 0 || o->d.mistakes.out_of_memory) {
        flk_opened_free(o);
        return FOURLINK_NO_MEMORY;
    }
    if (!o->d.mistakes.count) {
        *opened = o;
        return FOURLINK_OK;
    }
    flk_mistakes_sort(&o->d.mistakes);
    flk_deck_give_mistakes(&o->d.mistakes, list->max, list->mistakes, list->n);
    status = !from && o->d.synthesis && FLK_IS_NO_LINKAGE(o->d.synthesis->status)
                 ? o->d.synthesis->status
                 : FOURLINK_BAD_DECK;
    flk_opened_free(o);
    return status;
}

int flk_opened_read(const fourlink_source *source, const flk_opened *like,
                    const flk_mistake_list *list, flk_opened **opened)
{
    flk_opened *o = calloc(1, sizeof *o);

    if (!o)
        return FOURLINK_NO_MEMORY;
    o->whole_cycle = source->whole_cycle;
    return open_results(o, NULL, like, read_deck(source, &o->d), list, opened);
}

/* Room for another deck of the same source. */
static flk_opened *beside(const flk_opened *from)
{
    flk_opened *o = calloc(1, sizeof *o);

    if (o)
        o->whole_cycle = from->whole_cycle;
    return o;
}

int flk_opened_design(const flk_opened *from, unsigned long design, const deck_number *set,
                      size_t n_set, const flk_mistake_list *list, flk_opened **opened)
{
    flk_opened *o = beside(from);

    return o ? open_results(o, from, NULL, flk_deck_design(&from->d, design, set, n_set, &o->d),
                            list, opened)
             : FOURLINK_NO_MEMORY;
}

int flk_opened_solution(const flk_opened *from, unsigned long number, const flk_mistake_list *list,
                        flk_opened **opened)
{
    flk_opened *o = beside(from);

    return o ? open_results(o, from, NULL, flk_deck_solution(&from->d, number, &o->d), list, opened)
             : FOURLINK_NO_MEMORY;
}

int flk_opened_changed(const flk_opened *from, const fourlink_change *change,
                       const flk_mistake_list *list, flk_opened **opened)
{
    flk_opened *o = beside(from);

    return o ? open_results(o, from, NULL, flk_deck_changed(&from->d, change, &o->d), list, opened)
             : FOURLINK_NO_MEMORY;
}

int flk_opened_keep_rows(flk_opened *o)
{
    if (!o->rows)
        o->rows = malloc(FLK_ROWS_KEPT * sizeof *o->rows);
    return o->rows ? FOURLINK_OK : FOURLINK_NO_MEMORY;
}

void flk_opened_free(flk_opened *o)
{
    int i;

    if (!o)
        return;
    for (i = 0; i < FLK_SLIPS; i++) /* which share its settings */
        flk_opened_free(o->slips[i]);
    flk_extremes_close(&o->extremes);
    flk_analysis_close(&o->a);
    flk_deck_free(&o->d);
    free(o->columns);
    free(o->checks);
    free(o->rows);
    free(o->facts.list);
    free(o);
}
