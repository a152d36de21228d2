/* SPDX-License-Identifier: GPL-3.0-or-later
**
** deck.c - a deck for programs that embed the library: its memory, problem, loads at a crank angle, points.
*/
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include <gsl/gsl_math.h>

#include "base/quantity.h"
#include "deck.h"
#include "mechanics/group.h"
#include "mechanics/kind.h"

void flk_deck_set_si(deck_unit *units)
{
    int q;

    for (q = 0; q < QUANTITY_COUNT; q++) {
        strcpy(units[q].name, flk_quantities[q].unit);
        units[q].unit = flk_unit_of_quantity((quantity)q);
        units[q].is_given = 0;
    }
}

void flk_deck_start(deck *d)
{
    memset(d, 0, sizeof *d);
    flk_deck_set_si(d->units);
    memcpy(d->bare, d->units, sizeof d->bare);
    d->over = &flk_abscissas[0];
}

/* The header of a block of the deck's memory, before its contents. */
typedef struct kept {
    struct kept *next;
    double contents[1]; /* aligned for any contents */
} kept;

const char *fourlink_deck_status_text(const fourlink_deck *d, const fourlink_instant *at)
{
    int i = at && at->status == FOURLINK_GROUP_APART
                ? flk_groups_apart(&d->machine.mechanism, at->branch, at->row.crank.theta2)
                : -1;

    return !at ? "unknown status" : i < 0 ? fourlink_status_text(at->status) : d->outputs[i].apart;
}

const char *fourlink_deck_link_text(const deck *d, int link)
{
    int i = link - FOURLINK_ROD_OF(0);

    return i >= 0 && i < 2 * d->machine.mechanism.design.n_groups
               ? d->outputs[i / 2].name[i % 2]
               : fourlink_link_text((int)d->machine.mechanism.design.kind, link);
}

int flk_deck_output(const deck *d, text name)
{
    int i = d->machine.mechanism.design.n_groups;

    while (i-- > 0 && !flk_text_same(name, d->outputs[i].name[1]))
        ;
    return i;
}

int flk_deck_actuator(const deck *d, text name)
{
    int i = (int)d->n_actuators;

    while (i-- > 0 && !flk_text_same(name, d->actuators[i].name))
        ;
    return i;
}

void *flk_deck_keep(deck *d, size_t size)
{
    kept *k = calloc(1, sizeof *k + size);

    if (!k)
        return NULL;
    k->next = d->storage;
    d->storage = k;
    return k->contents;
}

void flk_deck_free(deck *d)
{
    kept *k, *next;

    flk_mistakes_free(&d->mistakes);
    flk_mistakes_free(&d->defects);
    flk_mistakes_free(&d->slips);
    flk_mistakes_free(&d->notes);
    for (k = d->storage; k; k = next) {
        next = k->next;
        free(k);
    }
    memset(d, 0, sizeof *d);
}

void flk_deck_give_mistakes(const mistakes *from, unsigned long max, fourlink_mistake *list,
                            unsigned long *n_mistakes)
{
    unsigned long i;

    for (i = 0; i < max && i < from->count; i++) {
        const struct mistake *m = &from->list[i];

        flk_text_copy(flk_text_of(m->place.source), list[i].file, sizeof list[i].file);
        list[i].line = m->place.line;
        memcpy(list[i].message, m->message, sizeof list[i].message);
    }
    if (n_mistakes)
        *n_mistakes = (unsigned long)flk_mistakes_count(from);
}

void fourlink_deck_free(fourlink_deck *d)
{
    if (d)
        flk_deck_free(d);
    free(d);
}

double flk_deck_direction(const deck *d, double angle)
{
    double x = angle + d->axes.angle;

    return x > M_PI ? x - 2 * M_PI : x > -M_PI ? x : x + 2 * M_PI;
}

double flk_deck_drawn(const deck *d)
{
    return flk_deck_direction(d, d->pins.theta2);
}

const fourlink_abscissa flk_abscissas[2 + FLK_COORDINATES] = {
    {"theta2", "\316\270\342\202\202", "angle", "angle", "the crank angle", "interval", 1, "rad", 0,
     0, 0},
    {"time", "t", "time", "time", "time", "time_step", 0, "s", 0, 0, 0},
    {"theta4", "\316\270\342\202\204", "angle", "theta4", "theta4", "interval", 0, "rad", 0, 0, 0},
    {"x", "x", "length", "x", "x", "interval", 0, "m", 0, 0, 0},
    {"C.x", "C.x", "length", "C.x", "C.x", "interval", 0, "m", 0, 0, 0},
    {"slide", "slide", "length", "slide", "the slide", "interval", 0, "m", 0, 0, 0}};

quantity flk_deck_over(const deck *d)
{
    if (DECK_GOES_OVER_INPUT(d))
        return d->prescribed->q->is_angle ? QUANTITY_ANGLE : QUANTITY_LENGTH;
    return d->over->is_crank_angle ? QUANTITY_ANGLE : QUANTITY_TIME;
}

int flk_deck_rows(const deck *d, fourlink_range *range, fourlink_abscissa *over)
{
    const fourlink_motion *motion = DECK_GOES_OVER_INPUT(d) ? &d->prescribed->motion : &d->motion;
    int status = fourlink_motion_range(motion, range);

    *over = *d->over;
    if (status == FOURLINK_OK && (over->is_crank_angle || DECK_GOES_OVER_INPUT(d))) {
        if (over->is_crank_angle)
            over->unit = d->units[QUANTITY_ANGLE].name;
        over->first = motion->from;
        over->step = motion->interval;
        over->last =
            range->stops ? range->stop_angle : flk_motion_angle(motion, range, range->n_rows - 1);
        range->n_rows *= DECK_HAS_BOTH_SIDES(d) ? 2 : 1;
    } else if (status == FOURLINK_OK) {
        over->step = d->mode.time_step;
        over->first = d->program ? d->program->segment[0].begin : 0;
        over->last = d->program ? flk_program_end(d->program) : d->mode.duration;
        range->n_rows = (unsigned long)ceil((over->last - over->first) / over->step - 1e-9) + 1;
    }
    return status;
}

int fourlink_deck_problem(const fourlink_deck *d, fourlink_problem *problem)
{
    fourlink_range range;

    if (!d || !problem)
        return FOURLINK_NULL;
    memset(problem, 0, sizeof *problem);
    memcpy(problem->title, d->title, sizeof problem->title);
    problem->mechanism = d->machine.mechanism;
    problem->motion = d->motion;
    problem->cycle = d->machine.cycle;
    problem->open = d->open;
    problem->crossed = d->crossed;
    problem->asks_for_both = d->asks_for_both;
    problem->has_forces = d->has_forces;
    problem->approximation = d->approximation;
    problem->has_friction = d->machine.has_friction;
    problem->has_gas = flk_machine_count(&d->machine, &flk_gas_type) > 0;
    problem->n_loads = d->machine.n_loads;
    problem->n_springs = (unsigned long)flk_machine_count(&d->machine, &flk_spring_type);
    problem->n_points = (unsigned long)d->n_points;
    problem->flywheel_fluctuation = d->flywheel_fluctuation;
    problem->flywheel_inertia = d->machine.flywheel;
    if (flk_deck_rows(d, &range, &problem->over) == FOURLINK_OK)
        problem->n_rows = range.n_rows;
    problem->one_instant = d->one_instant;
    problem->one_revolution = d->one_revolution;
    problem->digits = d->digits;
    problem->n_expected = (unsigned long)d->n_expectations;
    problem->is_graded = d->n_rules > 0 && !d->rules[d->n_rules - 1].name.length;
    problem->late = d->late;
    problem->shows_answers = d->shows_answers;
    problem->is_half_for_hint = d->is_half_for_hint;
    memcpy(problem->task, d->task, sizeof problem->task);
    problem->n_designs = d->sweep.n_designs;
    problem->design = d->sweep.design;
    problem->has_values = d->has_values;
    problem->has_outputs = d->sweep.output.names.length > 0 || d->sweep.yield.names.length > 0;
    problem->mode = d->mode.kind;
    problem->is_prescribed = DECK_GOES_OVER_INPUT(d);
    problem->has_both_sides = DECK_HAS_BOTH_SIDES(d);
    if (problem->is_prescribed)
        problem->prescribed = d->prescribed->motion;
    problem->axes_on_page = d->axes.is_page;
    problem->A = d->axes.A;
    problem->x_angle = d->axes.angle;
    problem->has_drawn = d->pins.is_there;
    problem->drawn_branch = d->pins.branch;
    problem->drawn_A = d->pins.A;
    problem->drawn_x = d->pins.angle;
    if (problem->has_drawn)
        problem->drawn = flk_unit_from_si(flk_deck_drawn(d), d->units[QUANTITY_ANGLE].unit);
    return FOURLINK_OK;
}

int fourlink_deck_unit(const fourlink_deck *d, const char *name, fourlink_unit *u)
{
    const deck_unit *own;
    int q;

    if (!d || !name || !u)
        return FOURLINK_NULL;
    q = (int)flk_quantity_find(name);
    if (q == QUANTITY_COUNT)
        return FOURLINK_NO_SUCH_NAME;
    own = &d->units[q];
    u->name = own->name;
    u->up = own->unit.up;
    u->down = own->unit.down;
    u->is_given = own->is_given;
    return FOURLINK_OK;
}

int fourlink_deck_quantity(const fourlink_deck *d, const char *name, const char *words,
                           double *value, fourlink_mistake *mistake)
{
    char message[MESSAGE_SIZE];
    quantity_value read;
    text t;
    int q;

    if (!d || !name || !words || !value)
        return FOURLINK_NULL;
    q = (int)flk_quantity_find(name);
    if (q == QUANTITY_COUNT)
        return FOURLINK_NO_SUCH_NAME;
    t = flk_text_trim(flk_text_of(words));
    if (!flk_quantity_read(t, t, (quantity)q, d->units[q].unit, &read, message)) {
        if (mistake) {
            memset(mistake, 0, sizeof *mistake);
            strcpy(mistake->message, message);
        }
        return FOURLINK_BAD_DECK;
    }
    *value = flk_unit_in(read.number, read.unit, d->units[q].unit);
    return FOURLINK_OK;
}

int fourlink_deck_loads(const fourlink_deck *d, fourlink_branch branch, double theta2,
                        fourlink_load *loads, double *gas)
{
    flk_acting acting;
    double sense;

    if (!d || (!loads && d->machine.n_loads))
        return FOURLINK_NULL;
    if (branch != FOURLINK_OPEN && branch != FOURLINK_CROSSED)
        return FOURLINK_BAD_BRANCH;
    if (!FLK_WITHIN(theta2, FOURLINK_NUMBER_MAX))
        return FOURLINK_BAD_NUMBER;
    acting.load = loads;
    acting.held = NULL;
    sense = d->motion.speed != 0 ? d->motion.speed : d->machine.friction.direction;
    flk_machine_loads_at(&d->machine, branch, theta2, sense, &acting);
    if (gas)
        *gas = acting.gas_force;
    return FOURLINK_OK;
}

int fourlink_deck_analyse(const fourlink_deck *d, fourlink_branch branch,
                          const fourlink_crank *crank, int closed_form, fourlink_load *loads,
                          fourlink_state *state, fourlink_forces *forces, fourlink_losses *losses,
                          double *gas)
{
    fourlink_state motion;
    fourlink_forces found;
    fourlink_losses lost;
    flk_acting acting;
    int status;

    if (!d || !crank || !loads || !state || !forces || !losses || !gas)
        return FOURLINK_NULL;
    acting.load = loads;
    acting.held = NULL;
    status = fourlink_analyse(&d->machine.mechanism, branch, crank, NULL, 0, &motion, NULL);
    if (status == FOURLINK_OK)
        status = flk_machine_forces(&d->machine, &motion, closed_form, &acting, &found, &lost);
    if (status != FOURLINK_OK)
        return status;
    *state = motion;
    *forces = found;
    *losses = lost;
    *gas = acting.gas_force;
    return FOURLINK_OK;
}

int fourlink_deck_point(const fourlink_deck *d, unsigned long i, const char **name, int *link,
                        fourlink_vector *at)
{
    if (!d || !link || !at)
        return FOURLINK_NULL;
    if (i >= d->n_points)
        return FOURLINK_NO_SUCH_POINT;
    if (name)
        *name = d->points[i].name;
    *link = d->points[i].link;
    *at = d->points[i].at;
    return FOURLINK_OK;
}

int fourlink_deck_program(const fourlink_deck *d, double time, fourlink_program_part *part)
{
    const flk_program_segment *g;

    if (!d || !part)
        return FOURLINK_NULL;
    if (!d->program)
        return FOURLINK_NO_SUCH_POINT;
    g = flk_program_segment_at(d->program, time);
    part->law = flk_law_names[g->law];
    part->begin = g->begin;
    part->end = g->begin + g->length;
    part->value = g->value;
    part->rise = g->rise;
    part->coordinate = d->program->is_of_speed ? g->coordinate : g->value;
    memcpy(part->bend, g->bend, sizeof part->bend);
    memcpy(part->ramp, g->ramp, sizeof part->ramp);
    part->is_angle = d->program->is_angle;
    part->is_of_speed = d->program->is_of_speed;
    return FOURLINK_OK;
}

int fourlink_deck_load(const fourlink_deck *d, unsigned long i, fourlink_load_info *info)
{
    const flk_machine *machine;
    const flk_element *e;

    if (!d || !info)
        return FOURLINK_NULL;
    machine = &d->machine;
    if (i >= machine->n_loads)
        return FOURLINK_BAD_LINK;
    info->element = 0;
    if (i >= machine->first_friction) {
        int joint = flk_friction_joint[i -= machine->first_friction];

        info->name = "friction";
        info->sort = FOURLINK_LOAD_FRICTION;
        info->element = (unsigned long)joint;
        info->link = flk_friction_link(flk_kind_of(machine->mechanism.design.kind), i);
        info->has_torque = machine->friction.circle[joint] > 0;
        return FOURLINK_OK;
    }
    for (e = machine->element; i - e->first >= (unsigned long)e->n_loads; e++)
        info->element = e[1].type == e->type ? info->element + 1 : 0;
    info->name = e->name[0] ? e->name : "load";
    info->sort = e->type->code;
    info->link = e->link[i - e->first];
    info->has_torque = e->has_torque;
    return FOURLINK_OK;
}

int fourlink_deck_spring(const fourlink_deck *d, unsigned long i, const char **name,
                         fourlink_spring *spring)
{
    const flk_element *e;

    if (!d || !spring)
        return FOURLINK_NULL;
    e = flk_machine_find(&d->machine, &flk_spring_type, i);
    if (!e)
        return FOURLINK_NO_SUCH_POINT;
    if (name)
        *name = e->name;
    *spring = *(const fourlink_spring *)e->data;
    return FOURLINK_OK;
}

int fourlink_deck_actuator(const fourlink_deck *d, unsigned long i, fourlink_actuator *actuator)
{
    const flk_actuator *x;

    if (!d || !actuator)
        return FOURLINK_NULL;
    if (i >= d->n_actuators)
        return FOURLINK_NO_SUCH_POINT;
    x = &d->actuators[i];
    actuator->name = x->name;
    actuator->link = x->link;
    actuator->to = x->to;
    actuator->at = x->at;
    actuator->to_at = x->to_at;
    actuator->bore = x->bore;
    actuator->rod_diameter = x->rod_diameter;
    actuator->drives = d->machine.mechanism.drive && d->machine.mechanism.drive->actuator == x;
    return FOURLINK_OK;
}

int fourlink_deck_drive(const fourlink_deck *d, unsigned long i, fourlink_load_info *info)
{
    const flk_drive *drive;
    int link;

    if (!d || !info)
        return FOURLINK_NULL;
    drive = d->machine.mechanism.drive;
    link = drive ? flk_drive_link(drive, i) : 0;
    if (!link)
        return FOURLINK_BAD_LINK;
    info->name =
        drive->sort == FLK_DRIVE_ENDS || drive->sort == FLK_DRIVE_LOAD ? drive->name : "drive";
    info->sort = FOURLINK_LOAD_DRIVE;
    info->element = i;
    info->link = link;
    info->has_torque = flk_drive_is_torque(drive);
    return FOURLINK_OK;
}

int fourlink_deck_friction(const fourlink_deck *d, fourlink_friction *friction)
{
    if (!d || !friction)
        return FOURLINK_NULL;
    *friction = d->machine.friction;
    return FOURLINK_OK;
}
