/* SPDX-License-Identifier: GPL-3.0-or-later
**
** view.c - what of a deck is to be shown.
*/
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include <gsl/gsl_math.h>

#include "system/format.h"
#include "base/cycle.h"
#include "base/text.h"
#include "system/memory.h"
#include "view.h"
#include "results.h"

#define BEFORE 1e-9 /* of the motion, by which a position is before its end */

int view_find_motion(view *v)
{
    double from = v->problem.motion.from, farthest = from, angle;
    int goes_on = !v->problem.over.is_crank_angle, i, status;

    for (i = 0; i < v->n_branches; i++) {
        status = results_end(v->results, v->branches[i], &angle);
        if (status == FOURLINK_NO_MEMORY)
            return 0;
        goes_on |= status == FOURLINK_OK;
        if (fabs(angle - from) > fabs(farthest - from))
            farthest = angle;
    }
    if (!goes_on && farthest != from && fabs(farthest - from) < fabs(v->end - from))
        v->end = farthest - BEFORE * (farthest - from);
    return 1;
}

static void stretch(view *v, const fourlink_vector *at)
{
    if (at->y != 0 && v->kind.shape[FOURLINK_FOLLOWER] == FOURLINK_SHAPE_LEVER)
        return;
    v->lever_low = GSL_MIN_DBL(v->lever_low, at->x);
    v->lever_high = GSL_MAX_DBL(v->lever_high, at->x);
}

/* Find how far a slotted lever reaches: to its points, loads and centre of mass on its axis; a yoke, to all
** along its guide. */
static void find_reach(view *v)
{
    const fourlink_link *lever = &v->design->link[FOURLINK_FOLLOWER];
    fourlink_load loads[VIEW_LOADS];
    fourlink_load_info info;
    fourlink_vector at;
    unsigned long i;
    int link;

    if (lever->mass > 0)
        stretch(v, &lever->cg);
    for (i = 0; i < v->problem.n_points; i++) {
        fourlink_deck_point(v->deck, i, NULL, &link, &at);
        if (link == FOURLINK_FOLLOWER)
            stretch(v, &at);
    }
    for (link = 0; link < v->design->n_groups; link++) {
        if (v->design->group[link].link == FOURLINK_FOLLOWER)
            stretch(v, &v->design->group[link].at);
        if (v->design->group[link].to == FOURLINK_FOLLOWER)
            stretch(v, &v->design->group[link].pivot);
    }
    if (v->problem.n_loads <= VIEW_LOADS &&
        fourlink_deck_loads(v->deck, FOURLINK_OPEN, 0, loads, NULL) == FOURLINK_OK)
        for (i = 0; fourlink_deck_load(v->deck, i, &info) == FOURLINK_OK; i++)
            if (info.sort == FOURLINK_LOAD_OWN && info.link == FOURLINK_FOLLOWER)
                stretch(v, &loads[i].at);
}

void view_take_design(view *v, fourlink_results *results)
{
    v->results = results;
    v->deck = fourlink_results_deck(results);
    fourlink_deck_problem(v->deck, &v->problem);
    v->mechanism = &v->problem.mechanism;
    v->design = &v->mechanism->design;
    fourlink_kind_of((int)v->design->kind, &v->kind);
    v->n_branches = 0;
    if (v->problem.open)
        v->branches[v->n_branches++] = FOURLINK_OPEN;
    if (v->problem.crossed)
        v->branches[v->n_branches++] = FOURLINK_CROSSED;
    fourlink_motion_range(v->problem.is_prescribed ? &v->problem.prescribed : &v->problem.motion,
                          &v->range);
    v->over = flk_quantity_find(v->problem.over.quantity);
    v->end = v->problem.over.last;
    v->range.n_rows = v->problem.n_rows;
    v->lever_low = v->lever_high = 0;
    if (v->kind.slotted)
        find_reach(v);
    fourlink_results_list(results, FOURLINK_COLUMNS, &v->columns, &v->n_columns);
}

void view_take(view *v, fourlink_results *results)
{
    int q;

    memset(v, 0, sizeof *v);
    for (q = 0; q < QUANTITY_COUNT; q++)
        fourlink_deck_unit(fourlink_results_deck(results), flk_quantities[q].name, &v->units[q]);
    view_take_design(v, results);
}

const char *view_input(const view *v)
{
    const fourlink_value *list;
    unsigned long n, i;

    fourlink_results_list(v->results, FOURLINK_INPUTS, &list, &n);
    for (i = 0; i < n; i++)
        if (strcmp(list[i].name, "motion.input") == 0 && strcmp(list[i].words, "theta2") != 0)
            return list[i].words;
    return NULL;
}

int view_find_solution(const fourlink_deck *deck, fourlink_solution **found)
{
    unsigned long chosen, n;

    *found = NULL;
    if (fourlink_deck_solutions(deck, 0, NULL, &chosen, &n) != FOURLINK_OK)
        return 1;
    *found = memory_get(chosen + 1, sizeof **found);
    if (!*found)
        return 0;
    fourlink_deck_solutions(deck, chosen + 1, *found, &chosen, &n);
    (*found)[0] = (*found)[chosen];
    return 1;
}

/* If the search for all is too long, the list is empty, though that for one column may end. */
int view_find_extremes(const view *v, fourlink_branch branch, view_extremes *found)
{
    fourlink_value one;
    unsigned long i;
    int status =
        results_facts(v->results, (int)branch, FOURLINK_FACTS_EXTREMES, &found->list, &found->n);

    if (status != FOURLINK_OK)
        return status;
    for (i = 0; i < v->n_columns && (v->columns[i].flags & FOURLINK_CRANK_ANGLE); i++)
        ;
    if (found->n || i == v->n_columns)
        return FOURLINK_OK;
    status = results_get(v->results, v->columns[i].handle + FOURLINK_MAX, branch, 0, &one);
    return status == FOURLINK_OK ? FOURLINK_LONG_SEARCH : status;
}

const fourlink_value *view_extreme(const view_extremes *x, int handle)
{
    unsigned long i;

    for (i = 0; i < x->n; i++)
        if (x->list[i].handle == handle)
            return &x->list[i];
    return NULL;
}

int view_reopen(const fourlink_source *source, fourlink_results *opened, const char *origin,
                const char *const *further, int n, fourlink_results **results,
                fourlink_mistake *mistake)
{
    fourlink_change *changes = memory_get(source->n_changes + 2, sizeof *changes);
    fourlink_source other = *source;
    int status, i;

    if (!changes)
        return FOURLINK_NO_MEMORY;
    if (source->n_changes)
        memcpy(changes, source->changes, source->n_changes * sizeof *changes);
    for (i = 0; i < n; i++) {
        changes[other.n_changes].origin = origin;
        changes[other.n_changes++].assignment = further[i];
    }
    other.changes = changes;
    other.whole_cycle = 1;
    status = results_open_like(&other, opened, 1, results, mistake, NULL);
    free(changes);
    return status;
}

int view_read(const view *v, quantity q, text value, text words, double *number,
              char message[MESSAGE_SIZE])
{
    quantity_value read;
    unit bare;

    if (v->units[q].is_given) {
        bare.up = v->units[q].up;
        bare.down = v->units[q].down;
        bare.dim = flk_quantities[q].dim;
    } else {
        bare = flk_unit_of_quantity(q);
    }
    if (!flk_quantity_read(value, words, q, bare, &read, message))
        return 0;
    *number = view_value(v, q, read.si);
    return 1;
}

int view_read_crank(const view *v, text value, text words, double *angle,
                    char message[MESSAGE_SIZE])
{
    if (!flk_text_equal(value, "drawn"))
        return view_read(v, QUANTITY_ANGLE, value, words, angle, message);
    *angle = v->problem.drawn;
    if (!v->problem.has_drawn)
        flk_message(message, MESSAGE_SIZE, "'%t' needs [pins], the places of the pins as drawn",
                    words);
    return v->problem.has_drawn;
}

int view_group_system(const view *v, const fourlink_instant *now, const fourlink_load *loads, int i,
                      double A[6][6], double b[6], double x[6])
{
    fourlink_load all[VIEW_LOADS + 2];
    unsigned long n = v->problem.n_loads;
    int more = 0;

    if (n > VIEW_LOADS)
        return fourlink_group_system(v->mechanism, &now->state, loads, n, i, A, b, x);
    memcpy(all, loads, n * sizeof *all);
    fourlink_drive_loads(v->mechanism, &now->state, now->forces.drive, all + n, &more);
    return fourlink_group_system(v->mechanism, &now->state, all, n + (unsigned long)more, i, A, b,
                                 x);
}

double view_direction(const view *v, double angle)
{
    return v->problem.axes_on_page ? flk_cycle_beside(angle + v->problem.x_angle, 2 * M_PI) : angle;
}

fourlink_vector view_place(const view *v, fourlink_vector place)
{
    double c = cos(v->problem.x_angle), s = sin(v->problem.x_angle);
    fourlink_vector on_page;

    if (!v->problem.axes_on_page)
        return place;
    on_page.x = v->problem.A.x + c * place.x - s * place.y;
    on_page.y = v->problem.A.y + s * place.x + c * place.y;
    return on_page;
}

double view_turn_of_range(const view *v, double from, double to)
{
    return to - from < 2 * M_PI - 1e-9 ? view_direction(v, from) - from : 0;
}

text view_value_of_spot(text words)
{
    text rest = words, name;

    flk_text_split(&rest, '=', &name);
    return rest.start ? flk_text_trim(rest) : words;
}

/* 1 if a value is one of what the rows go over, and that is no crank angle: by its unit; a bare one is
** one of the input, as in a deck. */
static int is_of_place(const view *v, text value)
{
    text name = flk_quantity_unit_text(value), bad;
    unit u;

    if (!name.length)
        return v->problem.is_prescribed;
    return flk_unit_read(name, &u, &bad) && flk_dimension_equal(u.dim, flk_quantities[v->over].dim);
}

int view_read_spot(const view *v, text words, view_spot *spot, char message[MESSAGE_SIZE])
{
    text value = view_value_of_spot(words), rest = words, name;

    flk_text_split(&rest, '=', &name);
    name = flk_text_trim(name);
    spot->side = 0;
    spot->is_place =
        !v->problem.over.is_crank_angle &&
        (rest.start && flk_text_equal(name, "theta2")               ? 0
         : rest.start && flk_text_equal(name, v->problem.over.name) ? 1
                                                                    : is_of_place(v, value));
    return spot->is_place ? view_read(v, v->over, value, words, &spot->at, message)
                          : view_read_crank(v, value, words, &spot->at, message);
}

int view_find_along(const view *v, fourlink_branch branch, int side, double place, double *values,
                    fourlink_instant *now, fourlink_load *loads)
{
    return side ? fourlink_results_on_side(v->results, branch, side, place, values, now, loads)
                : fourlink_results_along(v->results, branch, place, values, now, loads);
}

int view_find_spot(const view *v, fourlink_branch branch, const view_spot *spot, double *values,
                   fourlink_instant *now, fourlink_load *loads)
{
    if (!spot->is_place)
        return fourlink_results_at(v->results, branch, spot->at, values, now, loads);
    return view_find_along(v, branch, spot->side, view_si(v, v->over, spot->at), values, now,
                           loads);
}

/* rad: a position is clear if it is farther from a dead one. */
#define CLEAR (20 * M_PI / 180)

/* The transmission angle is large, and at a piston crank and rod are not in line. */
static int is_clear(const view *v, const fourlink_state *state)
{
    const fourlink_vector *crank = &state->link[FOURLINK_CRANK].axis,
                          *rod = &state->link[FOURLINK_COUPLER].axis;

    return state->mu > CLEAR &&
           (!v->kind.guided || fabs(crank->x * rod->y - crank->y * rod->x) > sin(CLEAR));
}

/* The number of the deck's own loads, and gas, that act; how many there are, and one that acts. */
static int count_acting(const view *v, const fourlink_load *loads, int *of, const char **name)
{
    fourlink_load_info info;
    unsigned long i;
    int n = 0;

    *of = 0;
    for (i = 0; fourlink_deck_load(v->deck, i, &info) == FOURLINK_OK; i++) {
        if (info.sort != FOURLINK_LOAD_OWN && info.sort != FOURLINK_LOAD_GAS)
            continue;
        ++*of;
        if (loads[i].force.x != 0 || loads[i].force.y != 0 || loads[i].torque != 0) {
            *name = info.name;
            n++;
        }
    }
    return n;
}

/* The place a sixth of the way through the motion: over time, that of a row. */
static double sixth_of(const view *v)
{
    const fourlink_abscissa *over = &v->problem.over;

    return over->is_crank_angle ? over->first + (v->end - over->first) / 6
                                : view_place_of_row(v, v->range.n_rows / 6);
}

static int find_sixth(const view *v, fourlink_branch branch, fourlink_instant *now,
                      fourlink_load *loads)
{
    return fourlink_results_along(v->results, branch, sixth_of(v), NULL, now, loads);
}

/* The row that is clear, with the largest number of acting loads, and of these nearest to a sixth of the way;
** `most` is that number, at least.  -1 if there is none. */
static long find_busiest(const view *v, fourlink_branch branch, int *most, fourlink_load *loads)
{
    double nearest = GSL_POSINF, off;
    const char *name;
    fourlink_instant now;
    unsigned long i;
    long found = -1;
    int n, of;

    for (i = 0; i < v->range.n_rows; i++) {
        if (fourlink_results_row(v->results, branch, i, NULL, &now, loads) != FOURLINK_OK)
            continue;
        n = count_acting(v, loads, &of, &name);
        off = fabs(now.row.place - sixth_of(v));
        if (n < *most || !is_clear(v, &now.state) || (n == *most && off >= nearest))
            continue;
        *most = n;
        nearest = off;
        found = (long)i;
    }
    return found;
}

/* 1 if the position of the drawing is shown, unless the deck has one of its own. */
static int is_drawn(const view *v)
{
    return v->problem.has_drawn && !v->problem.one_instant;
}

int view_find_position(const view *v, fourlink_branch branch, const view_spot *spot,
                       fourlink_instant *now, fourlink_load *loads)
{
    int first, status, most = 0, acting, of;
    const char *name;
    unsigned long i;
    long row;

    if (spot)
        return view_find_spot(v, branch, spot, NULL, now, loads);
    if (is_drawn(v) &&
        fourlink_results_at(v->results, branch, v->problem.drawn, NULL, now, loads) == FOURLINK_OK)
        return FOURLINK_OK;
    status = first = find_sixth(v, branch, now, loads);
    if (first == FOURLINK_OK) {
        acting = count_acting(v, loads, &of, &name);
        most = acting + is_clear(v, &now->state); /* then only a row with more of them */
        if (most > of)
            return FOURLINK_OK;
    }
    row = find_busiest(v, branch, &most, loads);
    if (row >= 0)
        return fourlink_results_row(v->results, branch, (unsigned long)row, NULL, now, loads);
    if (first == FOURLINK_OK)
        return find_sixth(v, branch, now, loads);
    for (i = 0; status != FOURLINK_OK && i < v->range.n_rows; i++)
        status = fourlink_results_row(v->results, branch, i, NULL, now, loads);
    return status == FOURLINK_OK ? FOURLINK_OK : first;
}

const char *view_tell_position(const view *v, const fourlink_instant *now,
                               const fourlink_load *loads, char out[VIEW_WHY])
{
    const char *name = "";
    char first[FORMAT_SIZE], last[FORMAT_SIZE];
    int of, n = count_acting(v, loads, &of, &name);
    double off;

    if (v->problem.one_instant || v->range.n_rows == 1)
        return "the deck's instant";
    if (is_drawn(v) &&
        fabs(now->row.angle - v->problem.drawn) <= 1e-9 * (1 + fabs(v->problem.drawn)))
        return "as drawn";
    off = now->row.place - sixth_of(v);
    if (fabs(off) <= 1e-9 * fabs(v->end))
        return "";
    if (n == 0)
        return "clear of dead positions";
    if (n == 1)
        return flk_text_join(out, VIEW_WHY, "where ", name, " acts", (char *)NULL);
    return flk_text_join(out, VIEW_WHY, "where ", format_general(n, 9, first), " of ",
                         format_general(of, 9, last), " loads act", (char *)NULL);
}

double view_shown_place(const view *v, const fourlink_row *row)
{
    return v->problem.is_prescribed ? view_over(v, row->place) : row->angle;
}

int view_goes_to(const view *v, int status)
{
    return status == FOURLINK_INPUT_DEAD_CENTRE && v->problem.is_prescribed &&
           !v->problem.one_instant;
}

unsigned long view_count_missing(const view *v, unsigned long *of, const char **why)
{
    unsigned long missing = 0, k;
    fourlink_instant now;
    int i, status;

    *why = "";
    for (i = 0; i < v->n_branches; i++)
        for (k = 0; k < v->range.n_rows; k++) {
            status = fourlink_results_row(v->results, v->branches[i], k, NULL, &now, NULL);
            if (view_goes_to(v, status))
                continue;
            missing += status != FOURLINK_OK;
            *why = status != FOURLINK_OK && !**why ? fourlink_status_text(status) : *why;
        }
    *of = (unsigned long)v->n_branches * v->range.n_rows;
    return missing;
}

const char *view_file_of(const char *path)
{
    const char *name = path;

    for (; *path; path++)
        if (*path == '/' || *path == '\\')
            name = path + 1;
    return name;
}

int view_refuse(fourlink_mistake *mistake, const char *place, const char *why, const char *word)
{
    memset(mistake, 0, sizeof *mistake);
    flk_text_join(mistake->file, sizeof mistake->file, place, (char *)NULL);
    flk_text_join(mistake->message, sizeof mistake->message, why, word, (char *)NULL);
    return 0;
}

/* The rows on the first side of an input. */
static unsigned long rows_of_side(const view *v)
{
    return v->problem.has_both_sides ? v->problem.n_rows / 2 : v->problem.n_rows;
}

int view_side_of_row(const view *v, unsigned long row)
{
    return !v->problem.has_both_sides ? 0
           : row < rows_of_side(v)    ? FOURLINK_RISING
                                      : FOURLINK_FALLING;
}

double view_place_of_row(const view *v, unsigned long row)
{
    const fourlink_abscissa *over = &v->problem.over;
    unsigned long i = row < rows_of_side(v) ? row : row - rows_of_side(v);
    double sense = over->last < over->first ? -1 : 1;
    double place = over->first + sense * ((double)i * over->step);

    return sense * place < sense * over->last ? place : over->last;
}

double view_over(const view *v, double place)
{
    return v->problem.over.is_crank_angle ? place : view_value(v, v->over, place);
}

const char *view_set_step(const view *v, double step, char out[VIEW_STEP])
{
    const fourlink_abscissa *over = &v->problem.over;
    char number[FORMAT_SIZE];

    return flk_text_join(out, VIEW_STEP, "motion.", over->step_key, "=",
                         format_general(step, 17, number), " ", over->unit, (char *)NULL);
}

double view_value(const view *v, quantity q, double si)
{
    return si * v->units[q].down / v->units[q].up;
}

double view_si(const view *v, quantity q, double value)
{
    return value * v->units[q].up / v->units[q].down;
}

int view_is_still(const view *v)
{
    const fourlink_motion *motion = &v->problem.motion;

    return v->problem.mode == FOURLINK_MODE_GIVEN && v->problem.over.is_crank_angle &&
           motion->speed == 0 && motion->acceleration == 0;
}

int view_repeats(const view *v)
{
    const fourlink_motion *motion = &v->problem.motion;

    return v->problem.one_revolution && v->problem.mode == FOURLINK_MODE_GIVEN && !v->range.stops &&
           motion->run_up <= 0 && (motion->acceleration == 0 || motion->hold);
}
