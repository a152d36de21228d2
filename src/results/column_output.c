/* SPDX-License-Identifier: GPL-3.0-or-later
**
** column_output.c - the columns of outputs: motion of slider or rocker and rod, forces at their joints.
*/
#include <math.h>

#include <gsl/gsl_math.h>

#include "base/trig.h"
#include "column.h"
#include "column_list.h"
#include "mechanics/group.h"

/* The joints of outputs have no friction, and what drives is not on them. */
#define TRAITS(need) ((need)&NEED_FORCES ? FOURLINK_FRICTIONLESS : 0)

#define INFO(code, ending, whose, q, need, form, usual, meaning) \
    {"", QUANTITY_##q, ALL, need, TRAITS(need), NULL, form, 0, 0, meaning, ""},
static const flk_column_info table[OUTPUT_COLUMNS] = {OUTPUT_COLUMN_LIST(INFO)};

#define WHOSE(code, ending, whose, q, need, form, usual, meaning) {whose, usual},
static const struct {
    int whose, is_usual;
} owners[OUTPUT_COLUMNS] = {OUTPUT_COLUMN_LIST(WHOSE)};

static size_t count_outputs(const deck *d)
{
    return OUTPUT_COLUMNS * (size_t)d->machine.mechanism.design.n_groups;
}

/* 1 if such outputs have a column. */
static int owns(int whose, const fourlink_group *g)
{
    return (whose & 1 << g->end) != 0 &&
           !(whose & (g->hang == FOURLINK_HANGS_BY_ROD ? BY_SLOT : WITH_ROD));
}

static int make_of_output(const flk_analysis *a, size_t i, flk_column *c)
{
    int number = (int)(i / OUTPUT_COLUMNS), code = (int)(i % OUTPUT_COLUMNS);

    flk_column_start(a->d, &table[code], c);
    c->name = a->d->outputs[number].column_names[code];
    c->of.output = number;
    c->component = code;
    c->is_usual = owners[code].is_usual;
    return owns(owners[code].whose, &a->d->groups[number]) &&
           (table[code].need & ~a->possible) == 0;
}

/* The angle between two vectors as lines, 0 to 90 deg. */
static double acute_angle(const fourlink_vector *u, const fourlink_vector *v)
{
    return flk_angle(fabs(FLK_CROSS(*u, *v)), fabs(FLK_DOT(*u, *v)));
}

/* The transmission angle: of the rod and the rocker, or the rod and what is square to the line.  By a
** slot, of its normal and the way of the block on slider or rocker: of the slot and the line, or of the
** arm of the block and the slot's normal. */
static double transmission_angle(const fourlink_group *g, const fourlink_link_state *rod)
{
    const fourlink_link_state *end = rod + 1;
    fourlink_vector n, arm;

    if (g->hang != FOURLINK_HANGS_BY_ROD) {
        if (g->end == FOURLINK_GROUP_SLIDES)
            return acute_angle(&rod->axis, &end->axis);
        n.x = -rod->axis.y;
        n.y = rod->axis.x;
        arm.x = rod->origin.x - end->origin.x;
        arm.y = rod->origin.y - end->origin.y;
        return acute_angle(&n, &arm);
    }
    n.x = -end->axis.y;
    n.y = end->axis.x;
    return acute_angle(&rod->axis, g->end == FOURLINK_GROUP_SLIDES ? &n : &end->axis);
}

/* Along the line of a slider, from its point `line`. */
static double along(const fourlink_group *g, double x, double y)
{
    return g->direction.x * x + g->direction.y * y;
}

static void vector_of_output(const flk_column *c, const flk_row *row, double *x, double *y)
{
    const flk_group_forces *f = &row->group[c->of.output];
    const fourlink_vector *F = &f->FD;

    switch (c->component) {
    case OUTPUT_FPX:
    case OUTPUT_FPY:
    case OUTPUT_FP:
    case OUTPUT_FP_DIR:
        F = &f->FP;
        break;
    case OUTPUT_FQX:
    case OUTPUT_FQY:
    case OUTPUT_FQ:
    case OUTPUT_FQ_DIR:
        F = &f->FQ;
        break;
    }
    *x = F->x;
    *y = F->y;
}

static double value_of_force(const flk_column *c, const flk_row *row)
{
    fourlink_vector F;

    vector_of_output(c, row, &F.x, &F.y);
    if (c->info->form == SIZE)
        return flk_length(F.x, F.y);
    flk_column_turn(c->d, &F);
    if (c->info->form == DIRECTION)
        return F.x == 0 && F.y == 0 ? FLK_UNDEFINED : flk_angle(F.y, F.x);
    return c->info->form == VECTOR_X ? F.x : F.y;
}

static double value_of_output(const flk_column *c, const flk_row *row)
{
    const fourlink_group *g = &c->d->groups[c->of.output];
    const fourlink_link_state *rod = &row->at.state.link[FOURLINK_ROD_OF(c->of.output)],
                              *end = rod + 1;
    const flk_group_forces *f = &row->group[c->of.output];
    double slide, rate;

    switch (c->component) {
    case OUTPUT_ALONG:
        return along(g, end->origin.x - g->pivot.x, end->origin.y - g->pivot.y);
    case OUTPUT_V:
        return along(g, end->velocity.x, end->velocity.y);
    case OUTPUT_A:
        return along(g, end->acceleration.x, end->acceleration.y);
    case OUTPUT_THETA:
        return flk_deck_direction(c->d, end->theta);
    case OUTPUT_OMEGA:
        return end->omega;
    case OUTPUT_ALPHA:
        return end->alpha;
    case OUTPUT_ROD_THETA:
        return flk_deck_direction(c->d, rod->theta);
    case OUTPUT_ROD_OMEGA:
        return rod->omega;
    case OUTPUT_ROD_ALPHA:
        return rod->alpha;
    case OUTPUT_SLIDE:
    case OUTPUT_SLIDE_V:
        flk_group_slide(&c->d->machine.mechanism, &row->at.state, c->of.output, &slide, &rate);
        return c->component == OUTPUT_SLIDE ? slide : rate;
    case OUTPUT_MU:
        return transmission_angle(g, rod);
    case OUTPUT_N:
        return -g->direction.y * f->FD.x + g->direction.x * f->FD.y;
    case OUTPUT_M:
        return f->M;
    default:
        return value_of_force(c, row);
    }
}

const flk_column_source flk_output_columns = {
    NULL, 0, count_outputs, make_of_output, NULL, value_of_output, vector_of_output, NULL, 0};
