/* SPDX-License-Identifier: GPL-3.0-or-later
**
** carried.c - a value as it follows from the values above it as they were written: rounding, or a mistake,
** carried on.
*/
#include <string.h>

#include "base/text.h"
#include "base/trig.h"
#include "mechanics/kind.h"
#include "carried.h"
#include "expected.h"

/* What is carried on, of links 3 and 4. */
static const struct {
    const char *name;
    int link;
    int is_angle; /* 1: theta, 0: omega */
} carried_table[] = {{"theta3", 3, 1}, {"theta4", 4, 1}, {"omega3", 3, 0}, {"omega4", 4, 0}};

#define CARRIED (sizeof carried_table / sizeof *carried_table)

/* Values further up are of other questions. */
#define MOST_ABOVE 20

/* The values above a value, in SI units, in the axes of link 1. */
typedef struct above {
    int is_there[CARRIED];
    double value[CARRIED];
} above;

static int is_of_same_row(const deck_expectation *x, const deck_expectation *e)
{
    return x->has_at && x->at == e->at && x->at_is_place == e->at_is_place &&
           x->branch == e->branch && x->is_answer == e->is_answer;
}

static void tell_above(const fourlink_check *c, char words[FLK_CARRIED_WORDS])
{
    size_t n = strlen(words);

    flk_text_join(words + n, FLK_CARRIED_WORDS - n, n ? ", " : "", c->name, " = ", c->printed_text,
                  (char *)NULL);
}

/* Find those above a value of this column. */
static int find_above(flk_opened *o, const deck_expectation *e, const char *own, above *list,
                      char words[FLK_CARRIED_WORDS])
{
    const deck_expectation *x =
        e - o->d.expectations > MOST_ABOVE ? e - MOST_ABOVE : o->d.expectations;
    fourlink_check c;
    flk_name n;
    quantity q;
    size_t i;
    int status;

    memset(list, 0, sizeof *list);
    words[0] = '\0';
    for (; x < e; x++) {
        if (!is_of_same_row(x, e))
            continue;
        status = flk_expected_compare(o, x, &n, &c);
        if (status != FOURLINK_OK)
            return status;
        for (i = 0; i < CARRIED && strcmp(c.name, carried_table[i].name) != 0; i++)
            ;
        if (i == CARRIED || n.kind != FLK_NAME_COLUMN || c.verdict == FOURLINK_NO_VALUE ||
            strcmp(c.name, own) == 0) /* another answer to the same question */
            continue;
        q = flk_column_quantity(&n.c);
        list->is_there[i] = 1;
        list->value[i] = flk_unit_to_si(c.printed, o->d.units[q].unit) -
                         (carried_table[i].is_angle ? o->d.axes.angle : 0);
        tell_above(&c, words);
    }
    return FOURLINK_OK;
}

/* Put the angles, or the angular velocities, into a state. */
static void put_above(const above *list, int are_angles, double omega2, fourlink_state *state)
{
    size_t i;

    for (i = 0; i < CARRIED; i++) {
        fourlink_link_state *link = &state->link[carried_table[i].link];

        if (!list->is_there[i] || carried_table[i].is_angle != are_angles)
            continue;
        if (are_angles) {
            link->theta = list->value[i];
            flk_sine_cosine(link->theta, &link->axis.y, &link->axis.x);
        } else {
            link->omega = list->value[i];
            link->k = omega2 != 0 ? link->omega / omega2 : link->k;
        }
    }
}

/* Velocities and accelerations of a state with these values; returns a status. */
static int follow(const fourlink_mechanism *mechanism, const fourlink_crank *crank,
                  const above *list, fourlink_state *state)
{
    const flk_kind *kind = flk_kind_of(mechanism->design.kind);
    int status;

    put_above(list, 1, crank->omega2, state);
    if (mechanism->design.kind == FOURLINK_FOUR_BAR)
        state->sine = FLK_CROSS(state->link[3].axis, state->link[4].axis);
    kind->angles(mechanism, state);
    status = fourlink_velocity(mechanism, crank->omega2, state);
    if (status != FOURLINK_OK)
        return status;
    put_above(list, 0, crank->omega2, state);
    return fourlink_acceleration(mechanism, crank->alpha2, state);
}

int flk_carried_value(flk_opened *o, const deck_expectation *e, const flk_name *n, double *value,
                      char words[FLK_CARRIED_WORDS])
{
    const fourlink_mechanism *mechanism = &o->d.machine.mechanism;
    above list;
    flk_row row;
    int status;

    if (n->kind != FLK_NAME_COLUMN || !e->has_at || e->at_is_place || mechanism->design.n_groups ||
        (mechanism->design.kind != FOURLINK_FOUR_BAR &&
         mechanism->design.kind != FOURLINK_SLIDER_CRANK) ||
        (flk_column_need(&n->c) & ~NEED_ANGLES))
        return FOURLINK_NO_SUCH_ROW;
    status = find_above(o, e, n->c.name, &list, words);
    if (status != FOURLINK_OK)
        return status;
    if (!words[0] ||
        !flk_analysis_at_angle(&o->a, flk_column_need(&n->c) | NEED_ANGLES, e->branch, e->at,
                               &row) ||
        row.at.status != FOURLINK_OK || row.at.state.sine == 0 ||
        follow(mechanism, &row.at.row.crank, &list, &row.at.state) != FOURLINK_OK)
        return FOURLINK_NO_SUCH_ROW;
    *value = flk_column_value(&n->c, &row);
    return FOURLINK_OK;
}
