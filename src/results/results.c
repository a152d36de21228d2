/* SPDX-License-Identifier: GPL-3.0-or-later
**
** results.c - results by name: from the text of a deck to its columns, facts, extremes, turning moment and
** the comparison with expected values.
*/
#include <stdlib.h>
#include <string.h>

#include <gsl/gsl_math.h>

#include "base/quantity.h"
#include "condition.h"
#include "crossing.h"
#include "expected.h"
#include "fact.h"
#include "hint.h"
#include "name.h"
#include "turning.h"

/* ------------------------------------------------------------------------------------------ opening */

/* Check a name in the [sweep] output: a fact or a statistic of a column; a column only if the deck has one
** instant. */
static void check_output(fourlink_results *r, text name, const flk_name *n, text_place place)
{
    mistakes *m = &r->d.mistakes;
    char statistic[DECK_NAME_SIZE];
    const char *nearest;

    if (r->d.drive.by_time && flk_fact_group(n->handle) > FOURLINK_FACTS_LIMITS)
        flk_mistake(m, place, "'%t' needs rows by angle; [motion] has rows = time", name);
    if (n->kind == FLK_NAME_STATISTIC || n->kind == FLK_NAME_FACT ||
        (n->kind == FLK_NAME_COLUMN && r->d.one_instant))
        return;
    nearest = n->statistic ? flk_column_nearest(&r->a, n->of) : flk_fact_nearest(name);
    if (n->statistic && nearest)
        nearest = flk_column_statistic_text(n->statistic, nearest, statistic);
    flk_mistake(m, place,
                n->kind == FLK_NAME_COLUMN
                    ? "'%t' has a value in each row: use its max(), min(), mean() or rms()%h"
                    : "'%t' is neither a fact nor the max(), min(), mean() or rms() of a column of "
                      "this deck%h",
                name, nearest);
}

/* Ask for the extreme that a name stands for, if it is one. */
static void ask_extreme(fourlink_results *r, const flk_name *n)
{
    if (n->kind == FLK_NAME_STATISTIC && (n->statistic == FLK_MAX || n->statistic == FLK_MIN))
        flk_extremes_ask(&r->extremes, &n->c);
}

/* Ask for the extremes that are found in one search with those of a sweep's outputs: those of the columns of a deck
** without a sweep, and those that are expected. */
static void ask_extremes(fourlink_results *r)
{
    flk_name n;
    text of;
    size_t i;

    r->extremes.is_together = r->d.sweep.n_variables > 0;
    for (i = 0; i < r->n_columns && !r->d.sweep.n_variables; i++)
        if (!(flk_column_flags(&r->columns[i]) & FOURLINK_CRANK_ANGLE))
            flk_extremes_ask(&r->extremes, &r->columns[i]);
    for (i = 0; i < r->d.n_expectations; i++)
        if (flk_column_statistic_of(r->d.expectations[i].name, &of)) {
            flk_name_find(r, r->d.expectations[i].name, &n);
            ask_extreme(r, &n);
        }
}

#define MOST_OUTPUTS 64

/* Add an output, or find it; null and a mistake if there are too many. */
static const fourlink_value *add_output(fourlink_results *r, text name, text_place place,
                                        int is_new)
{
    flk_list *outputs = &r->lists[FOURLINK_OUTPUTS];
    fourlink_value *output = &outputs->list[outputs->n];
    unsigned long i;
    flk_name n;

    for (i = 0; i < outputs->n && !is_new; i++)
        if (flk_text_same(name, outputs->list[i].name))
            return &outputs->list[i];
    if (outputs->n == MOST_OUTPUTS) {
        flk_mistake(&r->d.mistakes, place, "more than 64 outputs");
        return NULL;
    }
    flk_name_find(r, name, &n);
    flk_name_describe(r, &n, output);
    check_output(r, name, &n, place);
    ask_extreme(r, &n);
    output->name =
        flk_text_copy(name, r->output_names + DECK_NAME_SIZE * outputs->n++, DECK_NAME_SIZE);
    return output;
}

static void list_outputs(fourlink_results *r)
{
    text_place place = r->d.sweep.output.place;
    text rest = r->d.sweep.output.names, name;

    while (rest.start && flk_column_next_name(&rest, &name))
        if (!add_output(r, name, place, 1))
            return;
    if (r->d.sweep.output.names.start && !r->lists[FOURLINK_OUTPUTS].n)
        flk_mistake(&r->d.mistakes, place, "'output' names nothing");
}

/* Add a condition of the yield; its name is an output too.  Returns 0 if there are too many. */
static int add_condition(fourlink_results *r, const flk_condition *c)
{
    flk_list *list = &r->lists[FOURLINK_CONDITIONS];
    text_place place = r->d.sweep.yield.place;
    const fourlink_value *output = add_output(r, c->name, place, 0);
    char message[MESSAGE_SIZE];
    quantity_value limit;
    fourlink_value *v;
    quantity q;

    if (!output || list->n == MOST_OUTPUTS)
        return 0;
    if (!output->quantity)
        return 1; /* not known: already reported */
    q = flk_quantity_find(output->quantity);
    if (!flk_quantity_read(c->limit, c->limit, q, r->d.units[q].unit, &limit, message))
        return flk_mistake(&r->d.mistakes, place, "%s", message) + 1;
    v = &list->list[list->n];
    *v = *output;
    v->value = flk_unit_from_si(limit.si, r->d.units[q].unit);
    v->flags = c->flags;
    v->meaning = flk_text_copy(
        c->whole, r->output_names + DECK_NAME_SIZE * (MOST_OUTPUTS + list->n++), DECK_NAME_SIZE);
    return 1;
}

static void list_conditions(fourlink_results *r)
{
    text rest = r->d.sweep.yield.names;
    flk_condition c;
    int status = 0;

    while (rest.start && (status = flk_condition_next(&rest, &c)) != 0) {
        if (status < 0)
            flk_mistake(&r->d.mistakes, r->d.sweep.yield.place,
                        "expected a condition, such as mu_min > 40 deg, not '%t'", c.whole);
        else if (!add_condition(r, &c))
            return;
    }
}

/* Allocate all lists in one piece, after the facts; 0 if out of memory. */
static int take_memory(fourlink_results *r)
{
    size_t columns = flk_column_limit(&r->d), inputs = flk_list_input_limit(&r->d);
    size_t variables = r->d.sweep.n_variables, size[FOURLINK_CONDITIONS + 1], total = 0;
    fourlink_value *next;
    int i;

    size[0] = FLK_FACT_LIMIT + 4 * columns;
    size[FOURLINK_COLUMNS] = size[FOURLINK_ALL_COLUMNS] = columns;
    size[FOURLINK_INPUTS] = inputs;
    size[FOURLINK_VARIABLES] = variables;
    size[FOURLINK_OUTPUTS] = size[FOURLINK_CONDITIONS] = MOST_OUTPUTS;
    for (i = 0; i <= FOURLINK_CONDITIONS; i++)
        total += size[i];
    r->columns = malloc(columns * sizeof *r->columns);
    r->output_names =
        malloc((2 * MOST_OUTPUTS + variables + inputs + FLK_STATISTICS * columns) * DECK_NAME_SIZE);
    r->facts = next = malloc(total * sizeof *next);
    for (i = 0; next && i <= FOURLINK_CONDITIONS; next += size[i++])
        r->lists[i].list = next;
    if (!r->columns || !r->output_names || !r->facts)
        return 0;
    r->variable_names = r->output_names + 2 * MOST_OUTPUTS * DECK_NAME_SIZE;
    r->input_names = r->variable_names + variables * DECK_NAME_SIZE;
    r->statistic_names = r->input_names + inputs * DECK_NAME_SIZE;
    return flk_turning_open(&r->a) && flk_extremes_open(&r->extremes, columns);
}

/* Open a deck without mistakes; 0 if out of memory. */
static int open_deck(fourlink_results *r)
{
    flk_list *list = &r->lists[FOURLINK_COLUMNS];
    size_t i;

    if (r->d.sweep.n_variables && !r->d.solver)
        r->d.solver = SOLVER_DYAD;
    if (!flk_analysis_open(&r->a, &r->d) || !take_memory(r))
        return 0;
    r->n_columns = flk_column_choose(&r->a, &r->d.mistakes, r->columns);
    for (i = 0; i < r->n_columns; i++) {
        flk_list_column(&r->d, &r->columns[i], &list->list[list->n++]);
        r->needs |= flk_column_need(&r->columns[i]);
    }
    list_outputs(r);
    list_conditions(r);
    ask_extremes(r);
    flk_list_variables(&r->d, &r->lists[FOURLINK_VARIABLES], r->variable_names);
    return 1;
}

#define TRIES 1000
#define LONG_DECK 100000 /* bytes: too long to be read so often */

/* Read a deck.  FOURLINK_ANY_DESIGN reads the first design without mistakes, or the first design if all those
** tried have mistakes. */
static int read_deck(const fourlink_source *source, fourlink_results *r)
{
    fourlink_source one = *source;
    unsigned long n, i;
    deck other;
    int status;

    if (source->design != FOURLINK_ANY_DESIGN)
        return flk_deck_read(source, &r->d);
    one.design = 0;
    status = flk_deck_read(&one, &r->d);
    n = r->d.sweep.n_designs;
    if (source->length > LONG_DECK)
        n = 1;
    for (i = 1; status == 0 && i < n && i < 2 * TRIES; i++) {
        one.design = i < TRIES || n < 2 * TRIES ? i : n / TRIES * (i - TRIES);
        status = flk_deck_design(&r->d, one.design, &other);
        flk_deck_free(&other);
        if (status == 1) {
            flk_deck_free(&r->d);
            return flk_deck_read(&one, &r->d);
        }
    }
    return status;
}

/* Replace one instant by a cycle with its speed and acceleration. */
static void hold_instant(deck *d)
{
    fourlink_motion *motion = &d->motion;
    double turn = motion->speed != 0 ? motion->speed : motion->acceleration;
    double cycle = flk_unit_from_si(d->machine.cycle, d->units[QUANTITY_ANGLE].unit);

    motion->from = 0;
    motion->to = turn < 0 ? -cycle : cycle;
    motion->interval = cycle / 72;
    motion->hold = 1;
    d->one_instant = 0;
}

/* Open results of their deck, with the status of flk_deck_read. */
static int open_results(fourlink_results *r, int status, unsigned long max_mistakes,
                        fourlink_results **results, fourlink_mistake *list,
                        unsigned long *n_mistakes)
{
    if (status > 0 && r->whole_cycle && r->d.one_instant)
        hold_instant(&r->d);
    if (status > 0 && !open_deck(r))
        status = -1;
    else if (status == 0)
        flk_column_check(&r->d);
    if (status < 0 || r->d.mistakes.out_of_memory) {
        fourlink_results_free(r);
        return FOURLINK_NO_MEMORY;
    }
    if (!r->d.mistakes.count) {
        *results = r;
        return FOURLINK_OK;
    }
    flk_mistakes_sort(&r->d.mistakes);
    flk_deck_give_mistakes(&r->d.mistakes, max_mistakes, list, n_mistakes);
    fourlink_results_free(r);
    return FOURLINK_BAD_DECK;
}

int fourlink_results_open(const fourlink_source *source, unsigned long max_mistakes,
                          fourlink_results **results, fourlink_mistake *list,
                          unsigned long *n_mistakes)
{
    fourlink_results *r;

    if (!source || !source->text || !results || (!list && max_mistakes))
        return FOURLINK_NULL;
    r = calloc(1, sizeof *r);
    if (!r)
        return FOURLINK_NO_MEMORY;
    r->whole_cycle = source->whole_cycle;
    return open_results(r, read_deck(source, r), max_mistakes, results, list, n_mistakes);
}

int fourlink_results_design(const fourlink_results *from, unsigned long design,
                            unsigned long max_mistakes, fourlink_results **results,
                            fourlink_mistake *list, unsigned long *n_mistakes)
{
    fourlink_results *r;

    if (!from || !results || (!list && max_mistakes))
        return FOURLINK_NULL;
    if (design >= from->d.sweep.n_designs)
        return FOURLINK_BAD_NUMBER;
    r = calloc(1, sizeof *r);
    if (!r)
        return FOURLINK_NO_MEMORY;
    r->whole_cycle = from->whole_cycle;
    return open_results(r, flk_deck_design(&from->d, design, &r->d), max_mistakes, results, list,
                        n_mistakes);
}

int fourlink_source_design(const fourlink_source *source, unsigned long max, double *values)
{
    deck d;
    size_t i;
    int status;

    if (!source || !source->text || !values)
        return FOURLINK_NULL;
    status = flk_deck_read(source, &d);
    for (i = 0; status >= 0 && i < d.sweep.n_variables && i < max; i++)
        values[i] = d.sweep.variables[i].value;
    flk_deck_free(&d);
    return status < 0 ? FOURLINK_NO_MEMORY : FOURLINK_OK;
}

int fourlink_source_neighbours(const fourlink_source *source, unsigned long max, double *low,
                               double *high)
{
    deck d;
    size_t i;
    int status;

    if (!source || !source->text || !low || !high)
        return FOURLINK_NULL;
    status = flk_deck_read(source, &d);
    for (i = 0; status >= 0 && i < d.sweep.n_variables && i < max; i++)
        flk_deck_neighbours(&d, i, &low[i], &high[i]);
    flk_deck_free(&d);
    return status < 0 ? FOURLINK_NO_MEMORY : FOURLINK_OK;
}

void fourlink_results_free(fourlink_results *r)
{
    if (!r)
        return;
    flk_extremes_close(&r->extremes);
    flk_analysis_close(&r->a);
    flk_deck_free(&r->d);
    free(r->columns);
    free(r->output_names);
    free(r->facts);
    free(r);
}

/* -------------------------------------------------------------------------------------------- lists */

const fourlink_deck *fourlink_results_deck(const fourlink_results *r)
{
    return r ? &r->d : NULL;
}

int fourlink_results_notes(const fourlink_results *r, unsigned long max_notes,
                           fourlink_mistake *notes, unsigned long *n_notes)
{
    if (!r || (!notes && max_notes))
        return FOURLINK_NULL;
    flk_deck_give_mistakes(&r->d.notes, max_notes, notes, n_notes);
    return FOURLINK_OK;
}

int fourlink_results_list(fourlink_results *r, int which, const fourlink_value **list,
                          unsigned long *n)
{
    if (!r || !list || !n)
        return FOURLINK_NULL;
    if (which < FOURLINK_COLUMNS || which > FOURLINK_CONDITIONS)
        return FOURLINK_NO_SUCH_LIST;
    if (which == FOURLINK_ALL_COLUMNS)
        flk_list_columns(&r->a, &r->lists[which]);
    else if (which == FOURLINK_INPUTS)
        flk_list_inputs(&r->d, &r->lists[which], r->input_names);
    *list = r->lists[which].list;
    *n = r->lists[which].n;
    return FOURLINK_OK;
}

static int is_branch(int branch)
{
    return branch == FOURLINK_OPEN || branch == FOURLINK_CROSSED;
}

int fourlink_results_facts(fourlink_results *r, int branch, int groups,
                           const fourlink_value **facts, unsigned long *n)
{
    if (!r || !facts || !n)
        return FOURLINK_NULL;
    if (branch && !is_branch(branch))
        return FOURLINK_BAD_BRANCH;
    *n = flk_fact_list(&r->a, &r->extremes, branch, groups, r->columns, r->n_columns, r->facts,
                       r->statistic_names);
    *facts = r->facts;
    return FOURLINK_OK;
}

/* --------------------------------------------------------------------------------------------- rows */

/* Return what the caller asks for from a row. */
static int give_row(const fourlink_results *r, const flk_row *row, double *values,
                    fourlink_instant *instant, fourlink_load *loads)
{
    size_t i;

    for (i = 0; values && i < r->n_columns; i++)
        values[i] = flk_column_value(&r->columns[i], row);
    if (instant) {
        *instant = row->at;
        if (!(r->a.possible & NEED_FORCES)) {
            memset(&instant->forces, 0, sizeof instant->forces);
            instant->gas_force = 0;
        }
    }
    if (loads && r->d.machine.needs_motion && row->at.status == FOURLINK_OK)
        memcpy(loads, r->a.acting.load, r->d.machine.n_loads * sizeof *loads);
    else if (loads)
        fourlink_deck_loads(&r->d, row->at.branch, row->at.row.crank.theta2, loads, NULL);
    return row->at.status;
}

/* What a row needs: forces only for their columns, or for an instant. */
static int needs_of(const fourlink_results *r, const double *values,
                    const fourlink_instant *instant, const fourlink_load *loads)
{
    return (values ? r->needs : 0) |
           (instant || (loads && r->d.machine.needs_motion) ? r->a.possible & NEED_FORCES : 0);
}

int fourlink_results_row(fourlink_results *r, fourlink_branch branch, unsigned long i,
                         double *values, fourlink_instant *instant, fourlink_load *loads)
{
    flk_row row;

    if (!r)
        return FOURLINK_NULL;
    if (!is_branch((int)branch))
        return FOURLINK_BAD_BRANCH;
    if (i >= r->a.crank_motion.range.n_rows)
        return FOURLINK_NO_SUCH_ROW;
    flk_analysis_row(&r->a, needs_of(r, values, instant, loads), branch, i, &row);
    return give_row(r, &row, values, instant, loads);
}

int fourlink_results_at(fourlink_results *r, fourlink_branch branch, double angle, double *values,
                        fourlink_instant *instant, fourlink_load *loads)
{
    double at;
    flk_row row;

    if (!r)
        return FOURLINK_NULL;
    if (!is_branch((int)branch))
        return FOURLINK_BAD_BRANCH;
    if (!flk_crank_motion_find_angle(&r->a.crank_motion, angle, &at))
        return FOURLINK_NO_SUCH_ANGLE;
    flk_analysis_at_angle(&r->a, needs_of(r, values, instant, loads), branch, at, &row);
    return give_row(r, &row, values, instant, loads);
}

int fourlink_results_crossings(fourlink_results *r, const char *name, fourlink_branch branch,
                               double value, unsigned long max, double *angles, unsigned long *n)
{
    flk_column c;

    if (!r || !name || !n || (!angles && max))
        return FOURLINK_NULL;
    if (!is_branch((int)branch))
        return FOURLINK_BAD_BRANCH;
    if (!FLK_WITHIN(value, FOURLINK_NUMBER_MAX))
        return FOURLINK_BAD_NUMBER;
    if (!flk_column_find(&r->a, flk_text_of(name), &c))
        return FOURLINK_NO_SUCH_NAME;
    if (r->d.drive.by_time)
        return FOURLINK_NO_SUCH_ANGLE;
    return flk_crossings_find(&r->extremes.room, &r->a, &c, branch, value, max, angles, n);
}

/* ------------------------------------------------------------------------------------------ by name */

int fourlink_results_find(fourlink_results *r, const char *name, fourlink_value *found)
{
    flk_name n;

    if (!r || !name || !found)
        return FOURLINK_NULL;
    flk_name_find(r, flk_text_of(name), &n);
    if (n.kind == FLK_NAME_UNKNOWN)
        return FOURLINK_NO_SUCH_NAME;
    flk_name_describe(r, &n, found);
    return FOURLINK_OK;
}

int fourlink_results_get(fourlink_results *r, int handle, fourlink_branch branch, double angle,
                         fourlink_value *value)
{
    flk_name n;

    if (!r || !value)
        return FOURLINK_NULL;
    if (!is_branch((int)branch))
        return FOURLINK_BAD_BRANCH;
    flk_name_of_handle(r, handle, &n);
    return flk_name_value(r, &n, branch, angle, value);
}

int fourlink_results_value(fourlink_results *r, const char *name, fourlink_branch branch,
                           double angle, fourlink_value *value)
{
    flk_name n;

    if (!r || !name || !value)
        return FOURLINK_NULL;
    if (!is_branch((int)branch))
        return FOURLINK_BAD_BRANCH;
    flk_name_find(r, flk_text_of(name), &n);
    return flk_name_value(r, &n, branch, angle, value);
}

int fourlink_results_end(fourlink_results *r, fourlink_branch branch, double *angle)
{
    const flk_actual_facts *actual;

    if (!r || !angle)
        return FOURLINK_NULL;
    if (!is_branch((int)branch))
        return FOURLINK_BAD_BRANCH;
    actual = flk_actual_facts_of(r->a.crank_motion.actual, branch);
    *angle = actual && actual->status != FOURLINK_OK ? actual->end_angle : r->a.crank_motion.end;
    return actual ? actual->status : FOURLINK_OK;
}

int fourlink_results_turning(fourlink_results *r, fourlink_branch branch, fourlink_turning *turning)
{
    const fourlink_turning *found;

    if (!r || !turning)
        return FOURLINK_NULL;
    if (!is_branch((int)branch))
        return FOURLINK_BAD_BRANCH;
    found = flk_turning_find(&r->a, branch);
    if (!found)
        return FOURLINK_NO_TURNING_MOMENT;
    *turning = *found;
    return FOURLINK_OK;
}

int fourlink_results_check(fourlink_results *r, unsigned long i, fourlink_check *check)
{
    flk_name n;

    if (!r || !check)
        return FOURLINK_NULL;
    if (i >= r->d.n_expectations)
        return FOURLINK_NO_SUCH_ROW;
    flk_expected_compare(r, &r->d.expectations[i], &n, check);
    if (check->verdict == FOURLINK_DIFFERS && !check->words[0])
        flk_hint_find(r, &n, check);
    return FOURLINK_OK;
}
