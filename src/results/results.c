/* SPDX-License-Identifier: GPL-3.0-or-later
**
** results.c - the functions of fourlink.h: the columns, facts, extremes, turning moment of an opened deck,
** its other designs, the comparison with expected values.
*/
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include <gsl/gsl_math.h>

#include "mechanics/kind.h"
#include "mechanics/mechanics.h"
#include "deck/numbers.h"
#include "deck/sweep.h"
#include "deck/synthesis.h"
#include "crossing.h"
#include "expected.h"
#include "hint.h"
#include "fact.h"
#include "mean.h"

/* ------------------------------------------------------------------------------------------ opening */

/* Give an opened deck to the host; its status. */
static int return_results(int status, flk_opened *opened, fourlink_results **results)
{
    fourlink_results *r;

    if (status != FOURLINK_OK)
        return status;
    r = calloc(1, sizeof *r);
    if (!r) {
        flk_opened_free(opened);
        return FOURLINK_NO_MEMORY;
    }
    r->now = r->first = opened;
    *results = r;
    return FOURLINK_OK;
}

static flk_mistake_list list_of(unsigned long max, fourlink_mistake *first, unsigned long *n)
{
    flk_mistake_list list;

    list.max = max;
    list.mistakes = first;
    list.n = n;
    return list;
}

int fourlink_results_open_like(const fourlink_source *source, fourlink_results *like,
                               unsigned long max_mistakes, fourlink_results **results,
                               fourlink_mistake *first, unsigned long *n_mistakes)
{
    flk_mistake_list list = list_of(max_mistakes, first, n_mistakes);
    flk_opened *o = NULL;
    int status;

    if (!source || !source->text || !results || (!first && max_mistakes))
        return FOURLINK_NULL;
    status = flk_opened_read(source, like ? like->now : NULL, &list, &o);
    return return_results(status, o, results);
}

int fourlink_results_open(const fourlink_source *source, unsigned long max_mistakes,
                          fourlink_results **results, fourlink_mistake *first,
                          unsigned long *n_mistakes)
{
    return fourlink_results_open_like(source, NULL, max_mistakes, results, first, n_mistakes);
}

int fourlink_results_design(const fourlink_results *from, unsigned long design,
                            unsigned long max_mistakes, fourlink_results **results,
                            fourlink_mistake *first, unsigned long *n_mistakes)
{
    flk_mistake_list list = list_of(max_mistakes, first, n_mistakes);
    const deck *d = from ? &from->first->d : NULL;
    flk_opened *o = NULL;
    int status = FOURLINK_BAD_NUMBER;

    if (!d || !results || (!first && max_mistakes))
        return FOURLINK_NULL;
    if (design < d->sweep.n_designs)
        status = flk_opened_design(from->first, design, NULL, 0, &list, &o);
    else if (!d->sweep.n_designs && d->found && design < d->synthesis->n_kept)
        status = flk_opened_solution(from->first, design, &list, &o);
    return return_results(status, o, results);
}

int fourlink_results_variables(const fourlink_results *from, unsigned long design,
                               unsigned long max, double *values, double *low, double *high)
{
    if (!from || (!values && max))
        return FOURLINK_NULL;
    if (design >= from->first->d.sweep.n_designs)
        return FOURLINK_BAD_NUMBER;
    flk_deck_variables(&from->first->d, design, max, values, low, high);
    return FOURLINK_OK;
}

/* Open the first design again with these numbers, which belong to the results if that succeeds. */
static int open_with(fourlink_results *r, deck_number *set, size_t n, fourlink_mistake *mistake)
{
    flk_mistake_list list = list_of(mistake != NULL, mistake, NULL);
    flk_opened *o = NULL;
    int status = flk_opened_design(r->first, r->first->d.sweep.design, set, n, &list, &o);

    if (status != FOURLINK_OK)
        return status;
    if (r->now != r->first)
        flk_opened_free(r->now);
    free(r->set);
    r->now = o;
    r->set = set;
    r->n_set = n;
    return FOURLINK_OK;
}

/* Add a number to those set, or change it; its status. */
static int add_number(deck_number *set, size_t *n, const deck_number *number)
{
    size_t i;

    if (!gsl_finite(number->value))
        return FOURLINK_BAD_NUMBER;
    for (i = 0; i < *n && set[i].id != number->id; i++)
        ;
    *n += i == *n;
    set[i] = *number;
    return FOURLINK_OK;
}

/* A number in the unit of its line; a status. */
static int in_its_unit(const deck *d, unsigned long id, double value, deck_number *number)
{
    number->id = id;
    number->value = value;
    if (!id)
        return FOURLINK_NO_SUCH_NAME;
    return flk_number_unit(d, id, &number->unit) ? FOURLINK_OK : FOURLINK_NOT_A_NUMBER;
}

/* Set numbers by their handles or, if these are null, the one given. */
static int set_numbers(fourlink_results *r, unsigned long n, const int *handles,
                       const double *values, const deck_number *one, fourlink_mistake *mistake)
{
    size_t n_set = r->n_set;
    deck_number *set = malloc((n_set + n + 1) * sizeof *set), number;
    int status = set ? FOURLINK_OK : FOURLINK_NO_MEMORY;
    unsigned long i;

    if (set && n_set)
        memcpy(set, r->set, n_set * sizeof *set);
    for (i = 0; i < n && status == FOURLINK_OK; i++) {
        if (handles)
            status = in_its_unit(&r->first->d, flk_list_number(handles[i]), values[i], &number);
        if (status == FOURLINK_OK)
            status = add_number(set, &n_set, handles ? &number : one);
    }
    if (status == FOURLINK_OK)
        status = open_with(r, set, n_set, mistake);
    if (status != FOURLINK_OK)
        free(set);
    return status;
}

int fourlink_results_put(fourlink_results *r, unsigned long n, const int *handles,
                         const double *values, fourlink_mistake *mistake)
{
    return r && ((handles && values) || !n) ? set_numbers(r, n, handles, values, NULL, mistake)
                                            : FOURLINK_NULL;
}

int fourlink_results_set(fourlink_results *r, const char *name, double value,
                         fourlink_mistake *mistake)
{
    deck_number number;
    int status;

    if (!r || !name)
        return FOURLINK_NULL;
    status =
        in_its_unit(&r->first->d, flk_number_find(&r->first->d, flk_text_of(name)), value, &number);
    return status == FOURLINK_OK ? set_numbers(r, 1, NULL, NULL, &number, mistake) : status;
}

int fourlink_results_set_text(fourlink_results *r, const char *words, fourlink_mistake *mistake)
{
    char message[MESSAGE_SIZE];
    deck_number number;
    int status;

    if (!r || !words)
        return FOURLINK_NULL;
    status = flk_number_read_text(&r->first->d, flk_text_of(words), &number, message);
    if (status == FOURLINK_OK)
        return set_numbers(r, 1, NULL, NULL, &number, mistake);
    if (mistake) {
        mistake->file[0] = '\0';
        mistake->line = 0;
        strcpy(mistake->message, message);
    }
    return status;
}

int fourlink_results_input(fourlink_results *r, const char *name, fourlink_value *input)
{
    const char *key;
    unsigned long id;
    flk_opened *o;
    deck_unit u;
    quantity q;
    double si;

    if (!r || !name || !input)
        return FOURLINK_NULL;
    o = r->now;
    id = flk_number_find(&o->d, flk_text_of(name));
    if (!id)
        return FOURLINK_NO_SUCH_NAME;
    if (!flk_number_unit(&o->d, id, &u) || !flk_number_describe(&o->d, id, &q, &key, &si))
        return FOURLINK_NOT_A_NUMBER;
    flk_list_describe(&o->d, q, "", input);
    input->name = key;
    input->handle = FLK_NUMBER_HANDLE(id);
    input->value = flk_number_written(si, u.unit, u.unit);
    input->unit = input->line_unit = flk_line_unit_text(&o->line_units, u.name);
    input->to_si = u.unit.up / u.unit.down;
    return FOURLINK_OK;
}

void fourlink_results_free(fourlink_results *r)
{
    if (!r)
        return;
    if (r->now != r->first)
        flk_opened_free(r->now);
    flk_opened_free(r->first);
    free(r->set);
    free(r);
}

/* -------------------------------------------------------------------------------------------- lists */

const fourlink_deck *fourlink_results_deck(const fourlink_results *r)
{
    return r ? &r->now->d : NULL;
}

const char *fourlink_results_meant(const fourlink_results *r, const char *name)
{
    return r && name ? flk_column_meant(&r->now->a, flk_text_of(name)) : NULL;
}

int fourlink_results_slips(const fourlink_results *r, unsigned long max_slips,
                           fourlink_mistake *slips, unsigned long *n_slips)
{
    if (!r || (!slips && max_slips))
        return FOURLINK_NULL;
    flk_deck_give_mistakes(&r->now->d.slips, max_slips, slips, n_slips);
    return FOURLINK_OK;
}

int fourlink_results_notes(const fourlink_results *r, unsigned long max_notes,
                           fourlink_mistake *notes, unsigned long *n_notes)
{
    if (!r || (!notes && max_notes))
        return FOURLINK_NULL;
    flk_deck_give_mistakes(&r->now->d.notes, max_notes, notes, n_notes);
    return FOURLINK_OK;
}

int fourlink_results_list(fourlink_results *r, int which, const fourlink_value **list,
                          unsigned long *n)
{
    flk_list *columns;

    if (!r || !list || !n)
        return FOURLINK_NULL;
    if (which < FOURLINK_COLUMNS || which > FOURLINK_CONDITIONS)
        return FOURLINK_NO_SUCH_LIST;
    columns = &r->now->lists[FOURLINK_COLUMNS];
    while (which == FOURLINK_COLUMNS && columns->n < r->now->n_columns) {
        flk_list_column(&r->now->d, &r->now->columns[columns->n], &columns->list[columns->n]);
        columns->n++;
    }
    if (which == FOURLINK_ALL_COLUMNS)
        flk_list_columns(&r->now->a, &r->now->lists[which]);
    else if (which == FOURLINK_INPUTS)
        flk_list_inputs(&r->now->d, &r->now->line_units, &r->now->lists[which]);
    *list = r->now->lists[which].list;
    *n = r->now->lists[which].n;
    return FOURLINK_OK;
}

/* Check what a function on a branch is given, that nothing is null, and the branch. */
static int check_branch(const fourlink_results *r, int is_given, int branch)
{
    if (!r || !is_given)
        return FOURLINK_NULL;
    return flk_kind_has_branch(flk_kind_of(r->now->d.machine.mechanism.design.kind),
                               (fourlink_branch)branch)
               ? FOURLINK_OK
               : FOURLINK_BAD_BRANCH;
}

/* The same; then prepare its motion, so that no row after this needs memory. */
static int check_motion(fourlink_results *r, int is_given, int branch)
{
    int status = check_branch(r, is_given, branch);

    return status == FOURLINK_OK ? flk_opened_prepare(r->now, branch, FLK_ROWS) : status;
}

int fourlink_results_facts(fourlink_results *r, int branch, int groups,
                           const fourlink_value **facts, unsigned long *n)
{
    int status = branch            ? check_branch(r, facts && n, branch)
                 : r && facts && n ? FOURLINK_OK /* the branches of the deck */
                                   : FOURLINK_NULL;

    if (status == FOURLINK_OK)
        status = flk_opened_prepare(r->now, branch, groups);
    if (status != FOURLINK_OK)
        return status;
    *n = flk_fact_list(&r->now->a, &r->now->extremes, branch, groups, 0, r->now->columns,
                       r->now->n_columns, &r->now->facts);
    *facts = r->now->facts.list;
    return FOURLINK_OK;
}

/* --------------------------------------------------------------------------------------------- rows */

/* Return what the caller asks for from a row. */
static int copy_row(const flk_opened *o, const flk_row *row, double *values,
                    fourlink_instant *instant, fourlink_load *loads)
{
    if (values)
        flk_column_values(o->columns, o->n_columns, row, values);
    if (instant) {
        memcpy(instant, &row->at,
               offsetof(fourlink_instant, state) + FLK_STATE_SIZE(&o->d.machine.mechanism));
        if (!(o->a.possible & NEED_FORCES)) {
            memset(&instant->forces, 0, sizeof instant->forces);
            instant->gas_force = 0;
        }
    }
    if (loads && o->d.machine.needs_motion && row->at.status == FOURLINK_OK)
        memcpy(loads, o->a.acting.load, o->d.machine.n_loads * sizeof *loads);
    else if (loads)
        fourlink_deck_loads(&o->d, row->at.branch, row->at.row.crank.theta2, loads, NULL);
    return row->at.status;
}

/* What a row needs: forces only for their columns, or for an instant. */
static int needs_of(const flk_opened *o, const double *values, const fourlink_instant *instant,
                    const fourlink_load *loads)
{
    return (values ? o->needs : 0) |
           (instant || (loads && o->d.machine.needs_motion) ? o->a.possible & NEED_FORCES : 0) |
           (instant ? NEED_ANGLES : 0);
}

/* Check the number of a row, too. */
static int check_row(fourlink_results *r, int branch, unsigned long i)
{
    int status = check_motion(r, 1, branch);

    return status == FOURLINK_OK && i >= r->now->a.course.range.n_rows ? FOURLINK_NO_SUCH_ROW
                                                                       : status;
}

int fourlink_results_row(fourlink_results *r, fourlink_branch branch, unsigned long i,
                         double *values, fourlink_instant *instant, fourlink_load *loads)
{
    int status = check_row(r, (int)branch, i);
    flk_row row;

    if (status != FOURLINK_OK)
        return status;
    flk_analysis_row(&r->now->a, needs_of(r->now, values, instant, loads), branch, i, &row);
    return copy_row(r->now, &row, values, instant, loads);
}

/* What a row needs without the forces that no column has: with friction they decide whether it moves. */
static int needs_of_motion(const flk_opened *o, const double *values)
{
    return (values ? o->needs : 0) | NEED_ANGLES |
           (o->d.machine.has_friction ? o->a.possible & NEED_FORCES : 0);
}

static int copy_motion(const flk_opened *o, const flk_row *row, double *values,
                       fourlink_instant *instant)
{
    copy_row(o, row, values, instant, NULL);
    if (instant) {
        memset(&instant->forces, 0, sizeof instant->forces);
        memset(&instant->losses, 0, sizeof instant->losses);
        instant->gas_force = 0;
    }
    return row->at.status;
}

int fourlink_results_motion(fourlink_results *r, fourlink_branch branch, unsigned long i,
                            double *values, fourlink_instant *instant)
{
    int status = check_row(r, (int)branch, i);
    flk_row row;

    if (status != FOURLINK_OK)
        return status;
    flk_analysis_row(&r->now->a, needs_of_motion(r->now, values), branch, i, &row);
    return copy_motion(r->now, &row, values, instant);
}

int fourlink_results_brief(fourlink_results *r, fourlink_branch branch, unsigned long i,
                           double *values, fourlink_instant *instant)
{
    int status = check_row(r, (int)branch, i);
    flk_row row;

    if (status != FOURLINK_OK)
        return status;
    flk_analysis_row(&r->now->a,
                     needs_of_motion(r->now, values) | (r->now->is_of_places ? PLACES_ALONE : 0),
                     branch, i, &row);
    if (values)
        flk_column_values(r->now->columns, r->now->n_columns, &row, values);
    if (instant) {
        instant->branch = row.at.branch;
        instant->status = row.at.status;
        instant->row = row.at.row;
        instant->state.mu = row.at.state.mu;
        instant->state.sine = row.at.state.sine;
        instant->state.group_sine = row.at.state.group_sine;
    }
    return row.at.status;
}

#define COLUMNS 64 /* whose rows are computed together */

/* The columns of handles, and what they need; 0 if one is not that of a column. */
static int find_columns(const flk_opened *o, unsigned long n, const int *handles,
                        flk_column *columns, int *needs)
{
    flk_statistic statistic;
    unsigned long k;

    for (*needs = 0, k = 0; k < n; k++) {
        if (!flk_column_of_handle(&o->a, handles[k], &columns[k], &statistic) || statistic)
            return 0;
        *needs |= flk_column_need(&columns[k]);
    }
    return 1;
}

int fourlink_results_rows(fourlink_results *r, fourlink_branch branch, unsigned long first,
                          unsigned long n, unsigned long n_columns, const int *handles,
                          double *values)
{
    int status = check_motion(r, (handles && values) || !n || !n_columns, (int)branch), needs;
    unsigned long rows = r ? r->now->a.course.range.n_rows : 0, i, k, some;
    flk_column columns[COLUMNS];
    flk_row row;

    if (status != FOURLINK_OK)
        return status;
    if (first > rows || n > rows - first)
        return FOURLINK_NO_SUCH_ROW;
    for (k = 0; k < n_columns; k += some) {
        some = n_columns - k < COLUMNS ? n_columns - k : COLUMNS;
        if (!find_columns(r->now, some, handles + k, columns, &needs))
            return FOURLINK_NO_SUCH_NAME;
    }
    for (k = 0; k < n_columns; k += some) {
        some = n_columns - k < COLUMNS ? n_columns - k : COLUMNS;
        find_columns(r->now, some, handles + k, columns, &needs);
        for (i = 0; i < n; i++) {
            flk_analysis_row(&r->now->a, needs, branch, first + i, &row);
            flk_column_values(columns, some, &row, values + i * n_columns + k);
        }
    }
    return FOURLINK_OK;
}

int fourlink_results_at(fourlink_results *r, fourlink_branch branch, double angle, double *values,
                        fourlink_instant *instant, fourlink_load *loads)
{
    int status = check_motion(r, 1, (int)branch);
    flk_row row;

    if (status != FOURLINK_OK)
        return status;
    if (!flk_analysis_at_angle(&r->now->a, needs_of(r->now, values, instant, loads), branch, angle,
                               &row))
        return FOURLINK_NO_SUCH_ANGLE;
    return copy_row(r->now, &row, values, instant, loads);
}

/* Find a place of the course; a status. */
static int check_place(fourlink_results *r, int branch, double place, double *at)
{
    int status = check_motion(r, 1, branch);

    return status != FOURLINK_OK || r->now->a.course.type->find(&r->now->a.course, place, at)
               ? status
               : FOURLINK_NO_SUCH_ANGLE;
}

/* A row at a place of the course, on a side of it that it has. */
static int row_on_side(fourlink_results *r, fourlink_branch branch, int side, double at,
                       double *values, fourlink_instant *instant, fourlink_load *loads)
{
    flk_row row;

    flk_analysis_along(&r->now->a, needs_of(r->now, values, instant, loads), branch, side, at,
                       &row);
    return copy_row(r->now, &row, values, instant, loads);
}

int fourlink_results_along(fourlink_results *r, fourlink_branch branch, double place,
                           double *values, fourlink_instant *instant, fourlink_load *loads)
{
    double at;
    int status = check_place(r, (int)branch, place, &at);

    return status != FOURLINK_OK ? status
                                 : row_on_side(r, branch, flk_course_first_side(&r->now->a.course),
                                               at, values, instant, loads);
}

int fourlink_results_on_side(fourlink_results *r, fourlink_branch branch, int side, double place,
                             double *values, fourlink_instant *instant, fourlink_load *loads)
{
    double at;
    int status = check_place(r, (int)branch, place, &at);

    if (status == FOURLINK_OK && !flk_course_has_side(&r->now->a.course, side))
        status = FOURLINK_NO_SUCH_ANGLE;
    return status != FOURLINK_OK ? status
                                 : row_on_side(r, branch, side, at, values, instant, loads);
}

int fourlink_results_motion_along(fourlink_results *r, fourlink_branch branch, double place,
                                  double *values, fourlink_instant *instant)
{
    double at;
    int status = check_place(r, (int)branch, place, &at);
    flk_row row;

    if (status != FOURLINK_OK)
        return status;
    flk_analysis_along(&r->now->a, needs_of_motion(r->now, values), branch,
                       flk_course_first_side(&r->now->a.course), at, &row);
    return copy_motion(r->now, &row, values, instant);
}

int fourlink_results_crossings(fourlink_results *r, const char *name, fourlink_branch branch,
                               double value, unsigned long max, double *angles, unsigned long *n)
{
    int status = check_branch(r, name && n && (angles || !max), (int)branch);
    flk_column c;

    if (status == FOURLINK_OK)
        status = flk_opened_prepare(r->now, (int)branch, FLK_SEARCHES);
    if (status != FOURLINK_OK)
        return status;
    if (!FLK_WITHIN(value, FOURLINK_NUMBER_MAX))
        return FOURLINK_BAD_NUMBER;
    if (!flk_column_find(&r->now->a, flk_text_of(name), &c))
        return FOURLINK_NO_SUCH_NAME;
    if (!r->now->a.course.over.is_crank_angle && !DECK_GOES_OVER_INPUT(&r->now->d))
        return FOURLINK_NO_SUCH_ANGLE;
    return flk_crossings_find(&r->now->extremes.room, &r->now->a, &c, branch, value, max, angles,
                              n);
}

/* ------------------------------------------------------------------------------------------ by name */

int fourlink_results_find(fourlink_results *r, const char *name, fourlink_value *found)
{
    flk_name n;

    if (!r || !name || !found)
        return FOURLINK_NULL;
    flk_name_find(r->now, flk_text_of(name), &n);
    if (n.kind == FLK_NAME_UNKNOWN || !flk_name_keep(r->now, flk_text_of(name), &n))
        return FOURLINK_NO_SUCH_NAME;
    if (r->first != r->now) /* which gives its names to designs that are opened later */
        flk_names_take(r->first, r->now);
    flk_name_describe(r->now, &n, found);
    return FOURLINK_OK;
}

int fourlink_results_get(fourlink_results *r, int handle, fourlink_branch branch, double angle,
                         fourlink_value *value)
{
    int status = check_branch(r, value != NULL, (int)branch);
    flk_name n;

    if (status != FOURLINK_OK)
        return status;
    flk_name_of_handle(r->now, handle, &n);
    return flk_name_value(r->now, &n, branch, angle, value);
}

int fourlink_results_size(fourlink_results *r, int handle, const fourlink_instant *now,
                          double *size)
{
    flk_statistic statistic;
    flk_column c;
    flk_row row;
    double own;

    if (!r || !now || !size)
        return FOURLINK_NULL;
    if (now->status != FOURLINK_OK || !flk_column_of_handle(&r->now->a, handle, &c, &statistic))
        return FOURLINK_NO_SUCH_NAME;
    row.at = *now;
    own = flk_column_size(&c, &row);
    if (gsl_isnan(own))
        return FOURLINK_NO_SUCH_NAME;
    *size = own;
    return FOURLINK_OK;
}

int fourlink_results_value(fourlink_results *r, const char *name, fourlink_branch branch,
                           double angle, fourlink_value *value)
{
    int status = check_branch(r, name && value, (int)branch);
    flk_name n;

    if (status != FOURLINK_OK)
        return status;
    flk_name_find(r->now, flk_text_of(name), &n);
    return flk_name_value(r->now, &n, branch, angle, value);
}

int fourlink_results_end(fourlink_results *r, fourlink_branch branch, double *angle)
{
    int status = check_motion(r, angle != NULL, (int)branch);
    const flk_actual_facts *actual;

    if (status != FOURLINK_OK)
        return status;
    actual = flk_actual_facts_of(r->now->a.course.actual, branch);
    *angle = actual && actual->status != FOURLINK_OK ? actual->end_angle : r->now->a.course.end;
    return actual ? actual->status : FOURLINK_OK;
}

int fourlink_results_turning(fourlink_results *r, fourlink_branch branch, fourlink_turning *turning)
{
    int status = check_branch(r, turning != NULL, (int)branch);
    const fourlink_turning *found;

    if (status == FOURLINK_OK && r->now->a.turning_memory)
        status = flk_opened_prepare(r->now, (int)branch, FOURLINK_FACTS_TURNING);
    if (status != FOURLINK_OK)
        return status;
    found = flk_turning_find(&r->now->a, branch);
    if (!found)
        return FOURLINK_NO_TURNING_MOMENT;
    *turning = *found;
    return FOURLINK_OK;
}

int fourlink_results_check(fourlink_results *r, unsigned long i, fourlink_check *check)
{
    flk_kept_check *kept;
    fourlink_check found;
    flk_name n;
    int status;

    if (!r || !check)
        return FOURLINK_NULL;
    if (i >= r->now->d.n_expectations)
        return FOURLINK_NO_SUCH_ROW;
    kept = i < FLK_CHECKS_KEPT ? &r->now->checks[i] : NULL;
    if (kept && kept->is_known) {
        *check = kept->check;
        return FOURLINK_OK;
    }
    status = flk_expected_compare(r->now, &r->now->d.expectations[i], &n, &found);
    if (status == FOURLINK_OK && found.verdict == FOURLINK_DIFFERS && !found.words[0])
        status = flk_hint_find(r->now, &r->now->d.expectations[i], &n, &found);
    if (found.verdict == FOURLINK_AGREES || found.verdict == FOURLINK_MISPRINT)
        found.part = 1;
    else if (found.verdict == FOURLINK_DIFFERS && found.hint[0] && !found.is_short)
        found.part *= r->now->d.is_half_for_hint;
    else
        found.part = 0;
    if (status == FOURLINK_OK)
        *check = found;
    if (status == FOURLINK_OK && kept) {
        kept->check = found;
        kept->is_known = 1;
    }
    return status;
}
