/* SPDX-License-Identifier: GPL-3.0-or-later
**
** analysis.c - a row: all results of a deck at one crank position on one branch, and what textbooks derive
** from the nine unknowns and the motion.
*/
#include <math.h>
#include <stddef.h>
#include <stdlib.h>
#include <string.h>

#include <gsl/gsl_math.h>

#include "base/trig.h"
#include "mechanics/drive.h"
#include "mechanics/friction.h"
#include "mechanics/kind.h"
#include "mechanics/mechanism.h"
#include "deck/found.h"
#include "deck/synthesis.h"
#include "analysis.h"

/* ---------------------------------------------------------------------------------------------- derived */

#define ROUNDING 1e-13 /* of the parts of the shaking force: less is rounding error */

/* x / y, or infinite where y is 0 within rounding. */
static double ratio(double x, double y)
{
    if (fabs(x) < 1e15 * fabs(y))
        return x / y;
    return (x < 0) == (y < 0) ? GSL_POSINF : GSL_NEGINF;
}

/* x / y, with y of the order of 1, or undefined where y is 0 within rounding. */
static double quotient(double x, double y)
{
    return fabs(y) < 1e-12 ? FLK_UNDEFINED : x / y;
}

double flk_derive_freudenstein(const fourlink_design *design)
{
    const fourlink_link *link = design->link;
    double a = link[2].length, b = link[3].length, c = link[4].length, d = link[1].length;

    return (a * a - b * b + c * c + d * d) / 2;
}

/* Freudenstein's equation A t^2 + B t + C = 0 for t = tan(theta4 / 2) (Alvi eq. 2, section 4.1):
**
**    A = K - a (d - c) cos(theta2) - c d,   B = -2 a c sin(theta2)
**    C = K - a (d + c) cos(theta2) + c d
*/
static void derive_freudenstein(const fourlink_design *design, const fourlink_vector *crank_axis,
                                flk_derived *e)
{
    const fourlink_link *link = design->link;
    double a = link[2].length, c = link[4].length, d = link[1].length;
    double K = flk_derive_freudenstein(design);

    e->A = K - a * (d - c) * crank_axis->x - c * d;
    e->B = -2 * a * c * crank_axis->y;
    e->C = K - a * (d + c) * crank_axis->x + c * d;
}

/* The angle BCD between coupler and rocker, whose axes point from B to C and from D to C. */
static double angle_at_C(const fourlink_vector *coupler, const fourlink_vector *rocker)
{
    return flk_angle(fabs(coupler->x * rocker->y - coupler->y * rocker->x),
                     coupler->x * rocker->x + coupler->y * rocker->y);
}

/* Instantaneous centres, by definition and by Kennedy's theorem.  I13, of link 3 against the ground: its
** velocity there is 0,
**
**    I13 = B + (-v_By, v_Bx) / omega3
**
** I24, of link 4 against the crank: on the x axis through A where link 4 is pinned to the ground, and both
** have the same velocity,
**
**    omega2 x = omega4 (x - d),   or, for a piston, on the y axis:  -omega2 y = dX/dt
**
** Mechanical advantage, from the power of a machine without losses: torque on the load over torque on the
** crank, omega2 / omega4; slider-crank, force on the piston over force at the crank pin,
** r omega2 / v.
*/
void flk_derive_from_motion(const fourlink_mechanism *mechanism, const fourlink_state *state,
                            flk_derived *e)
{
    const fourlink_link *link = mechanism->design.link;
    const fourlink_link_state *coupler = &state->link[3], *follower = &state->link[4];
    double crank = state->link[2].k; /* 1, but 0 in a dead position */

    e->condition = 1 / fabs(state->sine);
    e->I13.x = coupler->origin.x - quotient(coupler->k_origin.y, coupler->k);
    e->I13.y = coupler->origin.y + quotient(coupler->k_origin.x, coupler->k);
    if (!fourlink_slides((int)mechanism->design.kind, FOURLINK_FOLLOWER)) {
        e->mechanical_advantage = ratio(crank, follower->k);
        e->I24.x = quotient(-link[1].length * follower->k, crank - follower->k);
        e->I24.y = 0;
        if (!flk_kind_has_slide(mechanism->design.kind)) {
            e->gamma = angle_at_C(&coupler->axis, &follower->axis);
            derive_freudenstein(&mechanism->design, &state->link[2].axis, e);
        }
    } else {
        e->mechanical_advantage =
            ratio(-(double)state->branch * link[2].length * crank, follower->k_origin.x);
        e->I24.x = 0;
        e->I24.y = quotient(-follower->k_origin.x, crank);
    }
}

/* Radius times relative angular speed (Khurmi, Theory of Machines, chapter 7): positive if the link with
** the higher number turns counter-clockwise relative to the other. */
void flk_derive_rubbing(const fourlink_mechanism *mechanism, const fourlink_state *state,
                        const double radius[4], flk_derived *e)
{
    const flk_kind *kind = flk_kind_of(mechanism->design.kind);
    int i;

    for (i = 0; i < 4; i++) {
        const fourlink_joint *j = &kind->joint[i];
        int high = GSL_MAX_INT(j->from, j->on), low = GSL_MIN_INT(j->from, j->on);
        int pin = j->letter[0] - 'A';

        if (!j->slider)
            e->rubbing[pin] = radius[pin] * (state->link[high].omega -
                                             (low == FOURLINK_GROUND ? 0 : state->link[low].omega));
    }
}

/* With X = r cos(theta2) +- l cos(phi), the first terms of -m_rec d2X/dt2 at constant speed (Bevan, Khurmi;
** "Balancing of Reciprocating Masses"):
**
**    m_rec r omega^2 cos(theta2),   +- m_rec r omega^2 cos(2 theta2) / n
*/
void flk_derive_primary(const fourlink_mechanism *mechanism, const fourlink_state *state,
                        double reciprocating, flk_derived *e)
{
    const fourlink_vector *axis = &state->link[2].axis;
    double r = mechanism->design.link[2].length, l = mechanism->design.link[3].length;
    double omega = state->link[2].omega, force = reciprocating * r * omega * omega;

    e->primary = force * axis->x;
    e->secondary = (double)state->branch * force * (axis->x * axis->x - axis->y * axis->y) * r / l;
}

static flk_axial in_axes(double Fx, double Fy, const fourlink_link_state *link)
{
    flk_axial F;

    F.along = Fx * link->axis.x + Fy * link->axis.y;
    F.across = -Fx * link->axis.y + Fy * link->axis.x;
    return F;
}

/* Inertia force and couple (ME3491 eqs. 1 and 2), and the offset force equivalent to both (fig. 2):
**
**    F = -m a_G,   C = -I alpha,   h = I alpha / (m a_G)
**
** F at the distance h from G has the moment C about it if it passes on the left, looking along F.  There
** is no h where a_G = a_O + alpha x r - omega^2 r is only rounding error. */
static flk_offset_force inertia_of(const fourlink_link *link, const fourlink_link_state *at,
                                   const fourlink_vector *a)
{
    double r = flk_length(link->cg.x, link->cg.y), a_G = flk_length(a->x, a->y), terms;
    flk_offset_force F;

    terms = flk_length(at->acceleration.x, at->acceleration.y) +
            (fabs(at->alpha) + at->omega * at->omega) * r;
    F.size = link->mass * a_G;
    F.direction = F.size > 0 ? flk_angle(-a->y + 0.0, -a->x + 0.0) : FLK_UNDEFINED;
    F.couple = 0 - link->inertia * at->alpha;
    F.h = F.size > 0 && a_G > 1e-13 * terms ? link->inertia * at->alpha / F.size : FLK_UNDEFINED;
    return F;
}

/* Add a force and a moment that act on a link, the force at the place r from its origin. */
static void add_to_shaking(const fourlink_link_state *link, fourlink_vector r, fourlink_vector F,
                           double moment, flk_derived *e)
{
    r.x += link->origin.x;
    r.y += link->origin.y;
    e->Fsx += F.x;
    e->Fsy += F.y;
    e->Ms += FLK_CROSS(r, F) + moment;
}

/* Add a load of the deck, with a factor; returns its size. */
static double add_load_to_shaking(const fourlink_state *state, const fourlink_load *load,
                                  double factor, flk_derived *e)
{
    const fourlink_link_state *link = &state->link[load->link];
    fourlink_vector r, F, k;

    FLK_PLACE_LOAD(load, link, r, F, k);
    (void)k;
    F.x *= factor;
    F.y *= factor;
    add_to_shaking(link, r, F, factor * load->torque, e);
    return flk_length(F.x, F.y);
}

/* Shaking force and moment about A: all that the machine exerts on the frame, at the pins and at the guide
** by Newton's third law, and through its elements, such as the gas on the cylinder head.  By d'Alembert's
** principle it is what acts on the moving links from outside, weights W and loads F_P of the deck, less
** what their momentum takes up,
**
**    Fs = sum (W - m a_G) + sum F_P
**    Ms = sum (AG x (W - m a_G) - I alpha) + sum (AP x F_P + T)
**
** Forces of pins, springs, gas, friction and drives are between links, or a link and the frame, and
** cancel: beside a dead position they grow beyond all bounds, and the sum of F21, F41 and the others
** would have their rounding error.  An Fs that is only the rounding error of its parts becomes 0. */
static void find_shaking(const flk_machine *machine, const fourlink_state *state,
                         const fourlink_forces *f, const flk_acting *acting,
                         const fourlink_body *body, flk_derived *e)
{
    const fourlink_mechanism *mechanism = &machine->mechanism;
    const flk_drive *drive = mechanism->drive;
    double parts = 0;
    size_t k;
    int i;

    e->Fsx = e->Fsy = e->Ms = 0;
    for (i = FOURLINK_CRANK; i <= FLK_LAST_LINK(mechanism); i++) {
        const fourlink_link *data = FLK_LINK(mechanism, i);
        fourlink_vector F;

        F.x = body[i].weight.x - data->mass * body[i].acceleration.x;
        F.y = body[i].weight.y - data->mass * body[i].acceleration.y;
        add_to_shaking(&state->link[i], body[i].arm, F, -data->inertia * state->link[i].alpha, e);
        parts += flk_length(F.x, F.y);
    }
    for (k = 0; k < machine->n_elements; k++)
        if (machine->element[k].type == &flk_given_load_type)
            parts += add_load_to_shaking(state, &acting->load[machine->element[k].first], 1, e);
    if (drive && drive->sort == FLK_DRIVE_LOAD)
        parts += add_load_to_shaking(state, &drive->load, f->drive, e);
    if (flk_length(e->Fsx, e->Fsy) <= ROUNDING * parts)
        e->Fsx = e->Fsy = 0;
}

void flk_derive_from_forces(const flk_machine *machine, const fourlink_state *state,
                            const fourlink_forces *f, const flk_acting *acting, flk_derived *e)
{
    const fourlink_mechanism *mechanism = &machine->mechanism;
    fourlink_body body[FOURLINK_LINKS];
    int i;

    fourlink_bodies(mechanism, state, NULL, 0, body);
    find_shaking(machine, state, f, acting, body, e);
    e->F12 = in_axes(f->F12x, f->F12y, &state->link[2]);
    e->F32 = in_axes(-f->F23x, -f->F23y, &state->link[2]);
    e->F23 = in_axes(f->F23x, f->F23y, &state->link[3]);
    e->F43 = in_axes(-f->F34x, -f->F34y, &state->link[3]);
    e->F34 = in_axes(f->F34x, f->F34y, &state->link[4]);
    e->F14 = in_axes(f->F14x, f->F14y, &state->link[4]);
    for (i = FOURLINK_CRANK; i <= FOURLINK_FOLLOWER; i++)
        e->inertia[i] =
            inertia_of(&mechanism->design.link[i], &state->link[i], &body[i].acceleration);
}

/* The unknowns as forces: couples are divided by a length.  The friction of a guide is one of the loads
** and is left out. */
static void list_forces(const fourlink_mechanism *mechanism, const fourlink_state *state,
                        const fourlink_forces *forces, double list[FLK_FORCES])
{
    const fourlink_vector *u = &state->link[FOURLINK_COUPLER].axis;
    double length = mechanism->design.link[FOURLINK_CRANK].length;

    flk_list_forces(forces, list);
    if (fourlink_slides((int)mechanism->design.kind, FOURLINK_COUPLER)) {
        list[4] = -forces->N34 * u->y;
        list[5] = forces->N34 * u->x;
    }
    if (fourlink_slides((int)mechanism->design.kind, FOURLINK_FOLLOWER))
        list[6] = 0;
    list[8] /= length;
    list[9] /= length;
    list[10] /= length;
}

/* The loads of the whole minus those of a part, at the same points. */
static void subtract_loads(const fourlink_load *whole, const fourlink_load *part, unsigned long n,
                           fourlink_load *rest)
{
    unsigned long i;

    for (i = 0; i < n; i++) {
        rest[i] = whole[i];
        rest[i].force.x -= part[i].force.x;
        rest[i].force.y -= part[i].force.y;
        rest[i].torque -= part[i].torque;
    }
}

/* The forces of loads and weights at a standstill, with the friction that these cause in the sense of the
** motion. */
static int solve_at_standstill(const fourlink_mechanism *mechanism, const fourlink_state *state,
                               const fourlink_load *loads, unsigned long n_loads,
                               const fourlink_friction *friction, fourlink_forces *forces,
                               fourlink_losses *losses)
{
    fourlink_state rest;
    int status;

    FLK_COPY_STATE(mechanism, &rest, state);
    status = fourlink_velocity(mechanism, 0, &rest);
    if (status == FOURLINK_OK)
        status = fourlink_acceleration(mechanism, 0, &rest);
    if (status != FOURLINK_OK)
        return status;
    return friction ? flk_friction_solve(mechanism, &rest, state, loads, n_loads, friction, 0,
                                         forces, losses)
                    : fourlink_solve(mechanism, &rest, loads, n_loads, forces);
}

/* Forces are linear in the loads, so that two parts make the whole: that at a standstill, and the rest, which
** is the inertia forces, and the friction of the whole minus that of the first part.  Friction grows with the
** sizes of the pin forces, so that the rest is not what inertia alone would cause.  Where friction locks the
** first part there are no parts. */
int flk_derive_superposition(const fourlink_mechanism *mechanism, const fourlink_state *state,
                             const fourlink_load *loads, unsigned long n_loads,
                             const fourlink_friction *friction, const fourlink_forces *forces,
                             flk_derived *e)
{
    fourlink_mechanism weightless = *mechanism;
    fourlink_forces of_loads, of_inertia;
    fourlink_losses losses;
    fourlink_load added[FOURLINK_FRICTION_LOADS];
    unsigned long n_friction = friction ? FOURLINK_FRICTION_LOADS : 0;
    double largest = 0, difference = 0;
    double whole[FLK_FORCES], part[FLK_FORCES], other[FLK_FORCES];
    int status, i;

    if (state->sine == 0) { /* no standstill is solved where the crank is dead */
        e->Ts_static = e->Ts_inertia = e->superposition = FLK_UNDEFINED;
        return FOURLINK_OK;
    }
    weightless.design.gravity.x = 0;
    weightless.design.gravity.y = 0;
    n_loads -= n_friction;
    status = solve_at_standstill(mechanism, state, loads, n_loads, friction, &of_loads, &losses);
    if (status == FOURLINK_LOCKED) {
        e->Ts_static = e->Ts_inertia = e->superposition = FLK_UNDEFINED;
        return FOURLINK_OK;
    }
    if (status == FOURLINK_OK) {
        subtract_loads(loads + n_loads, losses.load, n_friction, added);
        status = fourlink_solve(&weightless, state, added, n_friction, &of_inertia);
    }
    if (status != FOURLINK_OK)
        return status;
    list_forces(mechanism, state, forces, whole);
    list_forces(mechanism, state, &of_loads, part);
    list_forces(mechanism, state, &of_inertia, other);
    for (i = 0; i < FLK_FORCES; i++) {
        difference = GSL_MAX(difference, fabs(part[i] + other[i] - whole[i]));
        largest = GSL_MAX(largest, GSL_MAX(fabs(part[i]), fabs(other[i])));
    }
    e->Ts_static = of_loads.Ts;
    e->Ts_inertia = of_inertia.Ts;
    e->superposition = largest > 0 ? difference / largest : 0;
    return FOURLINK_OK;
}

/* ------------------------------------------------------------------------------------------------ a row */

/* There is no time for a crank at rest, or for one held at a speed and an acceleration. */
static int has_time(const deck *d)
{
    const fourlink_motion *motion = d->prescribed ? &d->prescribed->motion : &d->motion;

    if (d->mode.kind != MODE_GIVEN || d->program)
        return 1;
    return motion->acceleration != 0 ? !motion->hold : motion->speed != 0;
}

/* What can be computed for a deck. */
static int possible(const deck *d)
{
    int needs = NEED_DERIVED | NEED_ANGLES | (has_time(d) ? NEED_TIME : 0) |
                (flk_gas_on_piston(&d->machine) ? NEED_CYLINDER : 0) |
                (d->has_forces ? NEED_FORCES | NEED_SUPERPOSITION : 0) |
                (flk_machine_count(&d->machine, &flk_gas_type) ? NEED_GAS : 0) |
                (d->machine.has_friction ? NEED_LOSSES | NEED_RUBBING : 0) |
                (d->mode.kind != MODE_GIVEN ? NEED_ACTUAL : 0) |
                (d->synthesis && d->synthesis->function.wanted ? NEED_WANTED : 0);
    fourlink_rod rod;
    int status = fourlink_rod_masses(&d->machine.mechanism, &rod);

    if (status == FOURLINK_NOT_AN_ENGINE)
        return needs;
    needs |= d->balance.is_there ? NEED_BALANCE : 0;
    return needs | NEED_KLEIN | (d->machine.mechanism.design.offset == 0 ? NEED_SERIES : 0) |
           (d->has_forces && status != FOURLINK_ROD_OFF_LINE ? NEED_ENGINE | NEED_GAS : 0);
}

int flk_analysis_open(flk_analysis *a, const deck *d, const flk_analysis *like)
{
    memset(a, 0, sizeof *a);
    a->d = d;
    a->possible = possible(d);
    a->acting.load = calloc(d->machine.n_loads + 1, sizeof *a->acting.load);
    return a->acting.load &&
           flk_course_open(&a->course, d, &a->acting, like ? like->course.actual : NULL);
}

void flk_analysis_close(flk_analysis *a)
{
    flk_course_close(&a->course);
    free(a->acting.load);
    free(a->turning_memory);
    free(a->means);
    memset(a, 0, sizeof *a);
}

double flk_analysis_mean_speed(const flk_analysis *a, fourlink_branch branch)
{
    const flk_actual_facts *actual = flk_actual_facts_of(a->course.actual, branch);

    return actual ? actual->mean_speed : a->d->motion.speed;
}

/* The forces in the outputs. */
static void find_group_forces(flk_analysis *a, int closed_form, flk_row *row)
{
    const fourlink_mechanism *mechanism = &a->d->machine.mechanism;

    flk_groups_forces(mechanism, &row->at.state, a->acting.load, a->d->machine.n_loads,
                      mechanism->drive ? row->at.forces.drive : 0, closed_form, row->group);
}

/* In a dead position of the crank, what is prescribed gives the motion.  What is derived from an
** engine's motion follows from the crank's. */
static int leave_dead_position(const flk_analysis *a, int needs, int forces,
                               const fourlink_crank *crank, double place, int angles,
                               fourlink_instant *at)
{
    if ((forces && !flk_machine_leaves_dead(&a->d->machine)) ||
        needs & (NEED_ENGINE | NEED_SERIES | NEED_KLEIN))
        return FOURLINK_DEAD_POSITION;
    return flk_course_swing(&a->course, at->branch, place, crank->theta2, angles, &at->state);
}

/* Compute the motion, and with `forces` the loads and forces; returns a status.  At a place of the
** course, which may be null, what is prescribed has its own values in them all: where it moves at
** constant speed, an acceleration of rounding error would have an inertia force with a direction. */
static int compute(flk_analysis *a, int needs, int forces, const fourlink_crank *crank,
                   const double *place, int is_placed, flk_row *row)
{
    fourlink_instant *at = &row->at;
    const flk_machine *machine = &a->d->machine;
    int closed_form = a->is_fast || a->d->solver == SOLVER_DYAD;
    int angles = machine->needs_angles || (needs & NEED_ANGLES);
    int status =
        needs & PLACES_ALONE
            ? flk_mechanism_stand(&machine->mechanism, at->branch, crank, &at->state)
        : is_placed
            ? flk_mechanism_move_from(&machine->mechanism, crank, angles, &at->state)
            : flk_mechanism_move(&machine->mechanism, at->branch, crank, angles, &at->state);

    if (status == FOURLINK_DEAD_POSITION && place && a->d->prescribed)
        status = leave_dead_position(a, needs, forces, crank, *place, angles, at);
    if (status != FOURLINK_OK)
        return status;
    if (place && a->d->prescribed)
        flk_course_set_prescribed(&a->course, *place, &at->state);
    if (forces)
        status = flk_machine_forces(machine, &at->state, closed_form, &a->acting, &at->forces,
                                    &at->losses);
    else if (needs & (NEED_ENGINE | NEED_GAS))
        flk_machine_loads_at(machine, at->branch, crank->theta2, crank->omega2, &a->acting);
    at->gas_force = a->acting.gas_force;
    row->speed = crank->omega2;
    if (at->state.sine == 0) {
        row->speed = at->state.link[FOURLINK_COUPLER].omega;
        at->forces.Ts_work = FLK_UNDEFINED;
    }
    if (forces && status == FOURLINK_OK && machine->mechanism.design.n_groups)
        find_group_forces(a, closed_form, row);
    return status;
}

/* Compute what textbooks derive. */
static int derive(flk_analysis *a, int needs, int forces, const fourlink_crank *crank,
                  const fourlink_instant *at, flk_derived *derived)
{
    const fourlink_mechanism *mechanism = &a->d->machine.mechanism;

    if (needs & NEED_DERIVED)
        flk_derive_from_motion(mechanism, &at->state, derived);
    if (needs & NEED_RUBBING)
        flk_derive_rubbing(mechanism, &at->state, a->d->pin_radius, derived);
    if (needs & NEED_WANTED)
        derived->structural_error = at->branch == a->d->synthesis->chosen->branch
                                        ? flk_synthesis_error(a->d->synthesis, crank->theta2)
                                        : FLK_UNDEFINED;
    if (needs & NEED_BALANCE)
        flk_derive_primary(mechanism, &at->state, a->d->balance.reciprocating, derived);
    if ((needs & NEED_DERIVED) && forces)
        flk_derive_from_forces(&a->d->machine, &at->state, &at->forces, &a->acting, derived);
    if (needs & NEED_SUPERPOSITION)
        return flk_derive_superposition(
            mechanism, &at->state, a->acting.load, a->d->machine.n_loads,
            a->d->machine.has_friction ? &a->d->machine.friction : NULL, &at->forces, derived);
    return FOURLINK_OK;
}

static void analyse(flk_analysis *a, int needs, fourlink_branch branch, const fourlink_crank *crank,
                    const double *place, int is_placed, flk_row *row)
{
    const flk_machine *machine = &a->d->machine;
    const fourlink_mechanism *mechanism = &machine->mechanism;
    int forces = (needs & (NEED_FORCES | NEED_SUPERPOSITION)) != 0 ||
                 (machine->needs_motion && (needs & NEED_ENGINE));
    fourlink_instant *at = &row->at;

    at->branch = branch;
    at->status = compute(a, needs, forces, crank, place, is_placed, row);
    if (at->status == FOURLINK_OK && (needs & NEED_ENGINE)) {
        at->status = fourlink_engine_method(mechanism, &at->state, 0, a->acting.load,
                                            machine->n_loads, a->d->approximation, &row->engine);
        row->engine.gas_force = at->gas_force; /* which is among the loads */
    }
    if (at->status == FOURLINK_OK && (needs & NEED_SERIES))
        at->status = fourlink_textbook_series(mechanism, &at->state, &row->series);
    if (at->status == FOURLINK_OK && (needs & NEED_CYLINDER))
        flk_gas_in_cylinder(flk_gas_on_piston(machine), &at->state, crank->theta2, &row->gas);
    if (at->status == FOURLINK_OK && (needs & NEED_KLEIN))
        at->status = fourlink_klein_construction(mechanism, &at->state, &row->klein);
    if (at->status == FOURLINK_OK)
        at->status = derive(a, needs, forces, crank, at, &row->derived);
}

void flk_analysis_at(flk_analysis *a, int needs, fourlink_branch branch,
                     const fourlink_crank *crank, flk_row *row)
{
    analyse(a, needs, branch, crank, NULL, 0, row);
}

/* Complete a row, unless the machine does not get there. */
static void complete(flk_analysis *a, int needs, fourlink_branch branch, int status, int is_placed,
                     flk_row *row)
{
    row->at.branch = branch;
    row->at.status = status;
    if (status == FOURLINK_OK)
        analyse(a, needs, branch, &row->at.row.crank, &row->at.row.place, is_placed, row);
}

void flk_analysis_row(flk_analysis *a, int needs, fourlink_branch branch, unsigned long i,
                      flk_row *row)
{
    flk_analysis_along(a, needs, branch, flk_course_side(&a->course, i),
                       a->course.type->place(&a->course, i), row);
}

void flk_analysis_along(flk_analysis *a, int needs, fourlink_branch branch, int side, double place,
                        flk_row *row)
{
    const flk_course *c = &a->course;
    const deck *d = a->d;
    int by_input = DECK_GOES_OVER_INPUT(d) && !d->prescribed->is_at_crank &&
                   !d->machine.mechanism.design.n_groups;
    int status = by_input
                     ? flk_course_at_input(c, branch, side, place, &row->at.row, &row->at.state)
                     : c->type->at(c, branch, side, place, &row->at.row, &row->actual);

    complete(a, needs, branch, status, by_input && row->at.state.sine != 0, row);
}

int flk_analysis_at_angle(flk_analysis *a, int needs, fourlink_branch branch, double angle,
                          flk_row *row)
{
    int status;

    if (!flk_course_pass(&a->course, branch, angle, &status, &row->at.row, &row->actual))
        return 0;
    complete(a, needs, branch, status, 0, row);
    return 1;
}
