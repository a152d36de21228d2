/* SPDX-License-Identifier: GPL-3.0-or-later
**
** at.c - where --at points to: '30 deg, theta4 = 120 deg'.
*/
#include <stdlib.h>
#include <string.h>

#include "at.h"
#include "base/message.h"
#include "system/memory.h"

/* Find the column of this name; 0 and a message if there is none. */
static int find_column(fourlink_results *results, text name, fourlink_value *column,
                       char message[400])
{
    const fourlink_value *columns;
    const char **names, *nearest;
    char written[80];
    unsigned long n, i;

    fourlink_results_list(results, FOURLINK_ALL_COLUMNS, &columns, &n);
    for (i = 0; i < n; i++)
        if (flk_text_equal(name, columns[i].name)) {
            *column = columns[i];
            return 1;
        }
    flk_text_copy(name, written, sizeof written);
    if (fourlink_results_find(results, written, column) == FOURLINK_OK && column->has_angle)
        return 1; /* one that no list has */
    names = memory_get(n + 1, sizeof *names);
    for (i = 0; names && i < n; i++)
        names[i] = columns[i].name;
    nearest = fourlink_results_meant(results, written);
    if (!nearest && names)
        nearest = flk_text_nearest(name, names);
    free(names);
    flk_message(message, 400,
                nearest ? "no column '%t'; did you mean '%s'?" : "no column '%t'; see --list", name,
                nearest);
    return 0;
}

/* The only instant of a motion: '[motion] at = 30 deg', or of another input 'C.x = 700 mm'. */
#define INSTANT 120

static const char *tell_instant(const view *v, char out[INSTANT])
{
    fourlink_instant now;
    double place = v->problem.motion.from;

    if (v->problem.is_prescribed) {
        if (fourlink_results_row(v->results, v->branches[0], 0, NULL, &now, NULL) != FOURLINK_OK)
            return "";
        place = view_shown_place(v, &now.row);
    }
    return flk_message(out, INSTANT, ", %s = %g %s",
                       v->problem.is_prescribed ? v->problem.over.name : "[motion] at", place,
                       v->units[v->problem.is_prescribed ? v->over : QUANTITY_ANGLE].name);
}

static int take_column(const view *v, text name, text value, at_item *item, char message[400])
{
    fourlink_value column;
    char instant[INSTANT];

    if (!find_column(v->results, name, &column, message))
        return -1;
    if (!v->problem.over.is_crank_angle && !v->problem.is_prescribed) {
        flk_message(message, 400, "'%t' needs rows by angle; these are rows by %s", item->words,
                    v->problem.over.rows);
        return -1;
    }
    if (v->problem.one_instant) {
        flk_message(message, 400, "'%t' is sought along a motion; this one is one instant%s",
                    item->words, tell_instant(v, instant));
        return -1;
    }
    item->column = column.name;
    return view_read(v, flk_quantity_find(column.quantity), value, item->words, &item->value,
                     message)
               ? 1
               : -1;
}

int at_next(const view *v, const char **list, at_item *item, char message[400])
{
    text rest, name;
    char instant[INSTANT];
    int i;

    if (!*list)
        return 0;
    rest = flk_text_of(*list);
    flk_text_split(&rest, ',', &item->words);
    *list = rest.start;
    item->words = flk_text_trim(item->words);
    item->column = NULL;
    item->spot.is_place = item->spot.side = 0;
    rest = item->words;
    flk_text_split(&rest, '=', &name);
    if (rest.start && !flk_text_equal(flk_text_trim(name), "theta2") &&
        (v->problem.over.is_crank_angle ||
         !flk_text_equal(flk_text_trim(name), v->problem.over.name)))
        return take_column(v, flk_text_trim(name), flk_text_trim(rest), item, message);
    if (!view_read_spot(v, item->words, &item->spot, message))
        return -1;
    for (i = 0; i < v->n_branches; i++)
        if (view_find_spot(v, v->branches[i], &item->spot, NULL, NULL, NULL) !=
            FOURLINK_NO_SUCH_ANGLE)
            return 1;
    name = view_value_of_spot(item->words);
    flk_message(message, 400, "the motion does not reach %s = %t%s%s",
                item->spot.is_place ? v->problem.over.name : "theta2", name,
                v->problem.one_instant ? ": it is one instant" : "",
                v->problem.one_instant ? tell_instant(v, instant) : "");
    return -1;
}

/* Find the crank angles of a value of a column. */
static int find_angles(fourlink_results *results, const at_item *item, fourlink_branch branch,
                       double **angles, unsigned long *n)
{
    unsigned long room = 16; /* of most */
    int status = FOURLINK_OK;

    *angles = memory_get(room, sizeof **angles);
    while (*angles && status == FOURLINK_OK) {
        status = fourlink_results_crossings(results, item->column, branch, item->value, room,
                                            *angles, n);
        if (status != FOURLINK_OK || *n <= room)
            return status;
        room = *n;
        free(*angles);
        *angles = memory_get(room, sizeof **angles);
    }
    return FOURLINK_NO_MEMORY;
}

static int has_both_sides(fourlink_results *results)
{
    fourlink_problem problem;

    fourlink_deck_problem(fourlink_results_deck(results), &problem);
    return problem.has_both_sides;
}

int at_find(fourlink_results *results, const at_item *item, fourlink_branch branch,
            view_spot **spots, unsigned long *n)
{
    int has_both = item->spot.is_place && has_both_sides(results);
    double *angles = NULL;
    unsigned long i;
    int status = FOURLINK_OK;

    *spots = NULL;
    *n = item->column ? 0 : has_both ? 2 : 1;
    if (item->column)
        status = find_angles(results, item, branch, &angles, n);
    if (status == FOURLINK_OK) {
        *spots = memory_get(*n + 1, sizeof **spots);
        status = *spots ? FOURLINK_OK : FOURLINK_NO_MEMORY;
    }
    for (i = 0; status == FOURLINK_OK && i < *n; i++) {
        (*spots)[i] = item->spot;
        if (has_both)
            (*spots)[i].side = i ? FOURLINK_FALLING : FOURLINK_RISING;
        if (item->column)
            (*spots)[i].at = angles[i];
    }
    free(angles);
    return status;
}
