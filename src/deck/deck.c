/* SPDX-License-Identifier: GPL-3.0-or-later
**
** deck.c - a deck for programs that embed the library: its memory, problem, loads at a crank angle, points.
*/
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include <gsl/gsl_math.h>

#include "deck.h"
#include "mechanics/kind.h"

void flk_deck_start(deck *d)
{
    text bad;
    int q;

    memset(d, 0, sizeof *d);
    for (q = 0; q < QUANTITY_COUNT; q++) {
        strcpy(d->units[q].name, flk_quantities[q].unit);
        flk_unit_read(flk_text_of(flk_quantities[q].unit), &d->units[q].unit, &bad);
    }
}

/* The head of a piece of the deck's memory, before its contents. */
typedef struct kept {
    struct kept *next;
    double contents[1]; /* aligned for all contents */
} kept;

void *flk_deck_keep(deck *d, size_t size)
{
    kept *k = calloc(1, sizeof *k + size);

    if (!k)
        return NULL;
    k->next = d->storage;
    d->storage = k;
    return k->contents;
}

static void free_curves(deck_load *variation)
{
    flk_curve_free(&variation->torque);
    flk_curve_free(&variation->force[0]);
    flk_curve_free(&variation->force[1]);
    flk_curve_free(&variation->law.back_torque);
    flk_curve_free(&variation->law.back_force[0]);
    flk_curve_free(&variation->law.back_force[1]);
}

void flk_deck_free(deck *d)
{
    kept *k, *next;
    unsigned long i;

    flk_mistakes_free(&d->mistakes);
    flk_mistakes_free(&d->notes);
    for (i = 0; d->variations && i < d->n_loads; i++)
        free_curves(&d->variations[i]);
    flk_curve_free(&d->gas.indicator);
    free(d->expectations);
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
        *n_mistakes = (unsigned long)(from->count + from->left_out);
}

int fourlink_deck_read(const char *contents, unsigned long length, fourlink_loader *load,
                       void *host, unsigned long max_mistakes, fourlink_deck **result,
                       fourlink_mistake *list, unsigned long *n_mistakes)
{
    fourlink_source source;
    deck *d;
    int status;

    if (!contents || !result || (!list && max_mistakes))
        return FOURLINK_NULL;
    d = malloc(sizeof *d);
    if (!d)
        return FOURLINK_NO_MEMORY;
    memset(&source, 0, sizeof source);
    source.text = contents;
    source.length = length;
    source.load = load;
    source.host = host;
    status = flk_deck_read(&source, d);
    if (status > 0) {
        *result = d;
        return FOURLINK_OK;
    }
    if (status == 0)
        flk_deck_give_mistakes(&d->mistakes, max_mistakes, list, n_mistakes);
    fourlink_deck_free(d);
    return status == 0 ? FOURLINK_BAD_DECK : FOURLINK_NO_MEMORY;
}

void fourlink_deck_free(fourlink_deck *d)
{
    if (d)
        flk_deck_free(d);
    free(d);
}

int flk_deck_range(const deck *d, fourlink_range *range)
{
    double n = d->drive.by_time ? ceil(d->drive.duration / d->drive.time_step - 1e-9) : 0;
    int status = fourlink_motion_range(&d->motion, range);

    if (status == FOURLINK_OK && d->drive.by_time)
        range->n_rows = (unsigned long)n + 1;
    return status;
}

double flk_deck_time(const deck *d, unsigned long row)
{
    return GSL_MIN((double)row * d->drive.time_step, d->drive.duration);
}

int fourlink_deck_problem(const fourlink_deck *d, fourlink_problem *problem)
{
    fourlink_range range;

    if (!d || !problem)
        return FOURLINK_NULL;
    memset(problem, 0, sizeof *problem);
    memcpy(problem->title, d->title, sizeof problem->title);
    problem->mechanism = d->mechanism;
    problem->motion = d->motion;
    problem->cycle = d->cycle;
    problem->open = d->open;
    problem->crossed = d->crossed;
    problem->asks_for_both = d->asks_for_both;
    problem->has_forces = d->has_forces;
    problem->approximation = d->approximation;
    problem->has_friction = d->has_friction;
    problem->has_gas = d->gas.area > 0;
    problem->n_loads = flk_deck_all_loads(d);
    problem->n_springs = d->n_springs;
    problem->n_points = (unsigned long)d->n_points;
    problem->flywheel_fluctuation = d->flywheel_fluctuation;
    problem->flywheel_inertia = d->flywheel_inertia;
    if (flk_deck_range(d, &range) == FOURLINK_OK)
        problem->n_rows = range.n_rows;
    problem->one_instant = d->one_instant;
    problem->one_revolution = d->one_revolution;
    problem->digits = d->digits;
    problem->n_expected = (unsigned long)d->n_expectations;
    problem->n_designs = d->sweep.n_designs;
    problem->design = d->sweep.design;
    problem->has_outputs = d->sweep.output.names.length > 0 || d->sweep.yield.names.length > 0;
    problem->has_statistics = d->sweep.has_statistics;
    problem->mode = d->drive.mode;
    problem->by_time = d->drive.by_time;
    problem->time_step = d->drive.by_time ? d->drive.time_step : 0;
    problem->duration = d->drive.by_time ? d->drive.duration : 0;
    return FOURLINK_OK;
}

int fourlink_deck_unit(const fourlink_deck *d, const char *name, fourlink_unit *u)
{
    int q;

    if (!d || !name || !u)
        return FOURLINK_NULL;
    q = (int)flk_quantity_find(name);
    if (q == QUANTITY_COUNT)
        return FOURLINK_NO_SUCH_NAME;
    u->name = d->units[q].name;
    u->up = d->units[q].unit.up;
    u->down = d->units[q].unit.down;
    return FOURLINK_OK;
}

/* The force of the gas on the piston, towards the crank positive: p1 A1 - p2 A2 (ME3491). */
static double gas_force(const deck_gas *gas, double theta2)
{
    double p1 = gas->indicator.n ? flk_curve_value(&gas->indicator, theta2) : gas->pressure;

    return p1 * gas->area - gas->back_pressure * gas->back_area;
}

/* 1 if a load acts at a crank angle. */
static int is_on(const deck_load *variation, double cycle, double theta2)
{
    double after = theta2 - variation->from;

    if (!variation->is_windowed)
        return 1;
    after -= cycle * floor(after / cycle + 1e-12);
    return !(after > variation->to - variation->from + 1e-12 * cycle);
}

/* A load at a crank angle: the values of its curves, and 0 outside its range of crank angles. */
static void set_load(const fourlink_load *load, const deck_load *variation, double cycle,
                     double theta2, fourlink_load *now)
{
    *now = *load;
    if (FLK_DECK_FOLLOWS(&variation->law) /* forces.c */ || !is_on(variation, cycle, theta2)) {
        now->force.x = now->force.y = now->torque = 0;
        return;
    }
    if (variation->torque.n)
        now->torque = flk_curve_value(&variation->torque, theta2);
    if (variation->force[0].n) {
        now->force.x = flk_curve_value(&variation->force[0], theta2);
        now->force.y = flk_curve_value(&variation->force[1], theta2);
    }
}

unsigned long flk_deck_gas_loads(const deck *d)
{
    if (d->gas.area <= 0)
        return 0;
    return fourlink_slides((int)d->design.kind, FOURLINK_FOLLOWER) == FOURLINK_GROUND ? 1 : 2;
}

static void set_gas_on_piston(double force, fourlink_load *load)
{
    memset(load, 0, sizeof *load);
    load->link = FOURLINK_FOLLOWER;
    load->force.x = force;
}

/* p A u on the rod, -p A u on the cylinder, both along the slide: on the rod at B, on the cylinder at the
** point of the slide beside D, or at C. */
static void set_gas_in_cylinder(const fourlink_design *design, double force, fourlink_load loads[2])
{
    double length = design->link[FOURLINK_FOLLOWER].length;

    memset(loads, 0, 2 * sizeof loads[0]);
    loads[0].link = FOURLINK_COUPLER;
    loads[0].frame = FOURLINK_FRAME_LINK;
    loads[0].force.x = force;
    loads[1].link = FOURLINK_FOLLOWER;
    loads[1].frame = FOURLINK_FRAME_LINK;
    loads[1].force.x = -force * cos(design->angle);
    loads[1].force.y = -force * sin(design->angle);
    loads[1].at.x = length;
    loads[1].at.y = design->offset;
}

/* Only one end can be on the ground. */
static unsigned long loads_of_spring(const deck_spring *s)
{
    return s->spring.link == FOURLINK_GROUND || s->spring.to == FOURLINK_GROUND ? 1 : 2;
}

unsigned long flk_deck_spring_loads(const deck *d)
{
    unsigned long n = 0, i;

    for (i = 0; i < d->n_springs; i++)
        n += loads_of_spring(&d->springs[i]);
    return n;
}

static unsigned long loads_of_friction(const deck *d)
{
    return d->has_friction ? FOURLINK_FRICTION_LOADS : 0;
}

unsigned long flk_deck_all_loads(const deck *d)
{
    return d->n_loads + flk_deck_spring_loads(d) + loads_of_friction(d) + flk_deck_gas_loads(d);
}

/* Places for loads that are set with the motion. */
static unsigned long leave_room(const deck *d, fourlink_load *loads)
{
    unsigned long n = flk_deck_spring_loads(d) + loads_of_friction(d), i, j = 0;

    for (i = 0; i < n; i++) {
        memset(&loads[i], 0, sizeof loads[i]);
        loads[i].link = FOURLINK_CRANK;
    }
    for (i = 0; i < d->n_springs; i++) {
        if (d->springs[i].spring.link != FOURLINK_GROUND)
            loads[j++].link = d->springs[i].spring.link;
        if (d->springs[i].spring.to != FOURLINK_GROUND)
            loads[j++].link = d->springs[i].spring.to;
    }
    return n;
}

void flk_deck_set_loads(const deck *d, fourlink_branch branch, double theta2, fourlink_load *loads,
                        double *gas)
{
    double force = 0;
    unsigned long i;

    for (i = 0; i < d->n_loads; i++)
        set_load(&d->loads[i], &d->variations[i], d->cycle, theta2, &loads[i]);
    if (d->n_springs || d->has_friction)
        i += leave_room(d, &loads[i]);
    if (d->gas.area > 0)
        force = gas_force(&d->gas, theta2);
    if (flk_deck_gas_loads(d) == 1)
        set_gas_on_piston(-(double)branch * force, &loads[i]);
    if (flk_deck_gas_loads(d) == 2)
        set_gas_in_cylinder(&d->design, force, &loads[i]);
    if (gas)
        *gas = force;
}

int fourlink_deck_loads(const fourlink_deck *d, fourlink_branch branch, double theta2,
                        fourlink_load *loads, double *gas)
{
    if (!d || (!loads && flk_deck_all_loads(d)))
        return FOURLINK_NULL;
    if (branch != FOURLINK_OPEN && branch != FOURLINK_CROSSED)
        return FOURLINK_BAD_BRANCH;
    if (!FLK_WITHIN(theta2, FOURLINK_NUMBER_MAX))
        return FOURLINK_BAD_NUMBER;
    flk_deck_set_loads(d, branch, theta2, loads, gas);
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

static void set_info(fourlink_load_info *info, const char *name, int sort, unsigned long element,
                     int link, int has_torque)
{
    info->name = name;
    info->sort = sort;
    info->element = element;
    info->link = link;
    info->has_torque = has_torque;
}

/* Of load i among those of springs. */
static void set_info_of_spring(const deck *d, unsigned long i, fourlink_load_info *info)
{
    const deck_spring *s = d->springs;
    int is_second;

    for (; i >= loads_of_spring(s); s++)
        i -= loads_of_spring(s);
    is_second = i > 0 || s->spring.link == FOURLINK_GROUND;
    set_info(info, s->name, FOURLINK_LOAD_SPRING, (unsigned long)(s - d->springs),
             is_second ? s->spring.to : s->spring.link, s->spring.is_torsional);
}

/* Of load i among those of friction. */
static void set_info_of_friction(const deck *d, unsigned long i, fourlink_load_info *info)
{
    int joint = flk_friction_joint[i];

    set_info(info, "friction", FOURLINK_LOAD_FRICTION, (unsigned long)joint,
             flk_friction_link(flk_kind_of(d->design.kind), i), d->friction.circle[joint] > 0);
}

int fourlink_deck_load(const fourlink_deck *d, unsigned long i, fourlink_load_info *info)
{
    unsigned long springs, friction;
    const deck_load *own;

    if (!d || !info)
        return FOURLINK_NULL;
    if (i >= flk_deck_all_loads(d))
        return FOURLINK_BAD_LINK;
    springs = d->n_loads + flk_deck_spring_loads(d);
    friction = springs + loads_of_friction(d);
    if (i < d->n_loads) {
        own = &d->variations[i];
        set_info(info, own->name[0] ? own->name : "load", FOURLINK_LOAD_OWN, i, d->loads[i].link,
                 d->loads[i].torque != 0 || own->torque.n > 0);
    } else if (i < springs) {
        set_info_of_spring(d, i - d->n_loads, info);
    } else if (i < friction) {
        set_info_of_friction(d, i - springs, info);
    } else { /* in a cylinder on the rod, then on the cylinder */
        set_info(info, "gas", FOURLINK_LOAD_GAS, 0,
                 i + 1 < flk_deck_all_loads(d) ? FOURLINK_COUPLER : FOURLINK_FOLLOWER, 0);
    }
    return FOURLINK_OK;
}

int fourlink_deck_spring(const fourlink_deck *d, unsigned long i, const char **name,
                         fourlink_spring *spring)
{
    if (!d || !spring)
        return FOURLINK_NULL;
    if (i >= d->n_springs)
        return FOURLINK_NO_SUCH_POINT;
    if (name)
        *name = d->springs[i].name;
    *spring = d->springs[i].spring;
    return FOURLINK_OK;
}

int fourlink_deck_friction(const fourlink_deck *d, fourlink_friction *friction)
{
    if (!d || !friction)
        return FOURLINK_NULL;
    *friction = d->friction;
    return FOURLINK_OK;
}
