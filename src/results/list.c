/* SPDX-License-Identifier: GPL-3.0-or-later
**
** list.c - the lists of a deck: columns, inputs, variables of a sweep.
*/
#include <string.h>

#include "deck/schema.h"
#include "list.h"
#include "deck/numbers.h"

void flk_list_describe(const deck *d, quantity q, const char *meaning, fourlink_value *v)
{
    const deck_unit *u = &d->units[q];

    memset(v, 0, sizeof *v);
    v->unit = u->name;
    v->quantity = flk_quantities[q].name;
    v->meaning = meaning;
    v->source = "";
    v->to_si = u->unit.up / u->unit.down;
}

void flk_list_column(const deck *d, const flk_column *c, fourlink_value *v)
{
    flk_list_describe(d, flk_column_quantity(c), flk_column_meaning(c), v);
    v->name = c->name;
    v->source = flk_column_source_name(c);
    v->flags = flk_column_flags(c);
    v->handle = flk_column_handle(c, FLK_NONE);
}

unsigned long flk_list_number(int handle)
{
    return handle <= FLK_NUMBER_HANDLE(1) && handle % 2 ? (unsigned long)((-1001 - handle) / 2) : 0;
}

int flk_list_number_value(const deck *d, unsigned long id, fourlink_value *v)
{
    const char *key;
    double value;
    quantity q;

    if (!flk_number_describe(d, id, &q, &key, &value))
        return 0;
    flk_list_describe(d, q, "", v);
    v->name = key;
    v->handle = FLK_NUMBER_HANDLE(id);
    v->value = value;
    return 1;
}

void flk_list_columns(const flk_analysis *a, flk_list *columns)
{
    flk_column c;
    size_t i;

    if (columns->n)
        return;
    for (i = 0; i < flk_column_limit(a->d); i++)
        if (flk_column_number(a, i, &c))
            flk_list_column(a->d, &c, &columns->list[columns->n++]);
}

void flk_list_variables(const deck *d, flk_list *variables)
{
    size_t i;

    for (i = 0; i < d->sweep.n_variables; i++) {
        const deck_variable *x = &d->sweep.variables[i];
        fourlink_value *v = &variables->list[variables->n++];

        flk_list_describe(d, x->q, "varied by [sweep]", v);
        v->handle = FLK_NUMBER_HANDLE(x->number);
        v->name = flk_text_copy(x->name, variables->names + DECK_NAME_SIZE * i, DECK_NAME_SIZE);
        v->value = x->value;
    }
}

/* The inputs listed so far. */
typedef struct listing {
    const deck *d;
    flk_list *to;
    const char *section; /* the present one */
} listing;

/* Add SECTION.KEY; `si` is its value in SI units. */
static fourlink_value *add_input(listing *t, const char *key, quantity q, double si,
                                 const char *meaning)
{
    char *name = t->to->names + DECK_NAME_SIZE * t->to->n;
    fourlink_value *v = &t->to->list[t->to->n++];
    unsigned long number;

    flk_list_describe(t->d, q, meaning, v);
    v->name = flk_text_join(name, DECK_NAME_SIZE, t->section, ".", key, (char *)NULL);
    number = flk_number_find(t->d, flk_text_of(name));
    v->handle = number ? FLK_NUMBER_HANDLE(number) : FLK_LIST_HANDLE(t->to->n);
    v->value = flk_unit_from_si(si, t->d->units[q].unit);
    return v;
}

/* The same, unless it is 0. */
static void add_input_unless_0(listing *t, const char *key, quantity q, double si,
                               const char *meaning)
{
    if (si != 0)
        add_input(t, key, q, si, meaning);
}

/* Add an input whose value is words. */
static void add_words(listing *t, const char *key, const char *words, const char *meaning)
{
    fourlink_value *v = add_input(t, key, QUANTITY_NUMBER, 0, meaning);

    v->words = words;
    v->unit = "";
}

static void add_link(listing *t, int i)
{
    const fourlink_link *link = &t->d->design.link[i];

    t->section = fourlink_link_text((int)t->d->design.kind, i);
    add_input_unless_0(t, "length", QUANTITY_LENGTH, link->length, "length");
    add_input_unless_0(t, "mass", QUANTITY_MASS, link->mass, "mass");
    add_input_unless_0(t, "inertia", QUANTITY_INERTIA, link->inertia,
                       "moment of inertia about the centre of mass");
    add_input_unless_0(t, "cg.x", QUANTITY_LENGTH, link->cg.x, "centre of mass, along the link");
    add_input_unless_0(t, "cg.y", QUANTITY_LENGTH, link->cg.y,
                       "centre of mass, to the left of the link");
}

/* Add an angle of the motion, already in the deck's unit. */
static void add_angle(listing *t, const char *key, double angle, const char *meaning)
{
    add_input(t, key, QUANTITY_ANGLE, 0, meaning)->value = angle;
}

/* A motion that is not given. */
static void add_drive(listing *t)
{
    static const char *const modes[] = {"given", "free", "run-up", "steady"};
    const deck_drive *drive = &t->d->drive;

    if (drive->mode == DRIVE_GIVEN)
        return;
    add_words(t, "mode", modes[drive->mode], "the motion follows from torques and inertia");
    if (drive->mode == DRIVE_FREE)
        add_input(t, "speed", QUANTITY_ANGULAR_SPEED, t->d->motion.speed, "speed at the first row");
    add_input_unless_0(t, "mean_speed", QUANTITY_ANGULAR_SPEED, drive->mean_speed,
                       "mean over time");
    add_input_unless_0(t, "time_step", QUANTITY_TIME, drive->time_step, "interval of rows by time");
    add_input_unless_0(t, "duration", QUANTITY_TIME, drive->duration, "time of the last row");
}

static void add_motor(listing *t)
{
    const fourlink_motor *motor = &t->d->machine.motor;

    t->section = "motor";
    if (motor->kind == FOURLINK_NO_MOTOR)
        return;
    if (motor->kind == FOURLINK_MOTOR_BALANCE)
        add_words(t, "torque", "constant", "balances the loads over a cycle");
    else if (motor->kind == FOURLINK_MOTOR_TORQUE)
        add_input(t, "torque", QUANTITY_TORQUE, motor->torque, "torque of the motor");
    if (motor->kind == FOURLINK_MOTOR_CURVE)
        add_words(t, "curve", "a curve", "torque over the motor's speed");
    add_input_unless_0(t, "stall_torque", QUANTITY_TORQUE, motor->stall_torque, "torque at rest");
    add_input_unless_0(t, "no_load_speed", QUANTITY_ANGULAR_SPEED, motor->no_load_speed,
                       "speed without torque");
    add_input_unless_0(t, "power", QUANTITY_POWER, motor->power, "power of the motor");
    add_input_unless_0(t, "max_torque", QUANTITY_TORQUE, motor->max_torque, "largest torque");
    add_input_unless_0(t, "inertia", QUANTITY_INERTIA, motor->inertia,
                       "moment of inertia of the rotor");
    if (motor->ratio != 1)
        add_input(t, "ratio", QUANTITY_NUMBER, motor->ratio,
                  "speed of the motor / speed of the crank");
}

static void add_motion(listing *t)
{
    const fourlink_motion *motion = &t->d->motion;

    t->section = "motion";
    add_drive(t);
    if (t->d->drive.mode == DRIVE_GIVEN)
        add_input(t, "speed", QUANTITY_ANGULAR_SPEED, motion->speed, "speed of the crank");
    add_input_unless_0(t, "acceleration", QUANTITY_ANGULAR_ACCELERATION, motion->acceleration,
                       "acceleration of the crank");
    if (t->d->one_instant) {
        add_angle(t, "at", motion->from, "crank angle");
        return;
    }
    add_angle(t, "from", motion->from, "first crank angle");
    if (motion->run_up > 0)
        add_angle(t, "run_up", motion->run_up, "angle of the run-up from rest");
    else if (!t->d->drive.by_time)
        add_angle(t, "to", motion->to, "last crank angle");
    if (!t->d->drive.by_time)
        add_angle(t, "interval", motion->interval, "interval of the crank angle");
    add_input(t, "cycle", QUANTITY_ANGLE, t->d->machine.cycle, "period of curves and loads");
    if (motion->hold)
        add_words(t, "hold", "yes", "every row has this speed and acceleration");
}

/* What a load follows. */
static void add_law(listing *t, const flk_given_load *law)
{
    static const char *const names[] = {"theta2", "theta4", "x", "slide",
                                        "omega2", "omega4", "v", "slide_v"};
    int is_angular = law->over != FLK_V && law->over != FLK_SLIDE_V;

    if (law->over)
        add_words(t, "over", names[law->over], "what the load follows");
    if (law->has_back)
        add_words(t, "back", "other values", "where that falls");
    if (law->at_speed <= 0)
        return;
    add_input(t, "at_speed", is_angular ? QUANTITY_ANGULAR_SPEED : QUANTITY_SPEED, law->at_speed,
              "the speed at which it has its value");
    add_input(t, "exponent", QUANTITY_NUMBER, law->exponent, "of the speed");
}

static void list_load(listing *t, const flk_element *element)
{
    const flk_given_load *given = element->data;
    const flk_load_values *values = &given->values;
    const fourlink_load *load = &given->load;
    char section[DECK_NAME_SIZE];

    t->section = flk_text_join(section, sizeof section - 10, "load ", element->name, (char *)NULL);
    add_words(t, "link", fourlink_link_text((int)t->d->design.kind, load->link),
              "the link it acts on");
    if (values->force_curve[0].n)
        add_words(t, "force", "a curve", "force");
    add_input_unless_0(t, "force.x", QUANTITY_FORCE, values->force.x, "force, x");
    add_input_unless_0(t, "force.y", QUANTITY_FORCE, values->force.y, "force, y");
    add_input_unless_0(t, "at.x", QUANTITY_LENGTH, load->at.x, "where it acts, along the link");
    add_input_unless_0(t, "at.y", QUANTITY_LENGTH, load->at.y, "where it acts, to the left of it");
    if (load->frame == FOURLINK_FRAME_LINK)
        add_words(t, "frame", "link", "the force turns with the link");
    if (values->torque_curve.n)
        add_words(t, "torque", "a curve", "torque, counter-clockwise positive");
    else
        add_input_unless_0(t, "torque", QUANTITY_TORQUE, values->torque,
                           "torque, counter-clockwise positive");
    add_law(t, given);
    if (given->is_windowed) {
        add_input(t, "from", QUANTITY_ANGLE, given->window[0],
                  "first crank angle at which it acts");
        add_input(t, "to", QUANTITY_ANGLE, given->window[1], "last crank angle at which it acts");
    }
}

/* An end of a spring: its link and, for a linear spring, its point. */
static void add_end(listing *t, const fourlink_spring *s, int is_second)
{
    const fourlink_vector *at = is_second ? &s->to_at : &s->at;

    add_words(t, is_second ? "to" : "link",
              fourlink_link_text((int)t->d->design.kind, is_second ? s->to : s->link),
              is_second ? "the other link, or the ground" : "the link it acts on");
    if (s->is_torsional)
        return;
    add_input_unless_0(t, is_second ? "to_at.x" : "at.x", QUANTITY_LENGTH, at->x,
                       "its end there, x");
    add_input_unless_0(t, is_second ? "to_at.y" : "at.y", QUANTITY_LENGTH, at->y,
                       "its end there, y");
}

static void add_spring(listing *t, const flk_element *element)
{
    const fourlink_spring *s = element->data;
    int is_torsional = s->is_torsional;
    char section[DECK_NAME_SIZE];

    t->section =
        flk_text_join(section, sizeof section - 14, "spring ", element->name, (char *)NULL);
    add_end(t, s, 0);
    add_end(t, s, 1);
    add_input_unless_0(t, "stiffness",
                       is_torsional ? QUANTITY_TORSIONAL_STIFFNESS : QUANTITY_STIFFNESS,
                       s->stiffness, "stiffness");
    if (is_torsional)
        add_input_unless_0(t, "free_angle", QUANTITY_ANGLE, s->free_length, "angle without load");
    else
        add_input_unless_0(t, "free_length", QUANTITY_LENGTH, s->free_length,
                           "length without load");
    add_input_unless_0(t, "preload", is_torsional ? QUANTITY_TORQUE : QUANTITY_FORCE, s->preload,
                       "at the free length or angle");
    add_input_unless_0(t, "damping", is_torsional ? QUANTITY_TORSIONAL_DAMPING : QUANTITY_DAMPING,
                       s->damping, "damping");
    if (s->only)
        add_words(t, "only", s->only == FOURLINK_PUSHES ? "pushes" : "pulls",
                  "when it acts: below its free length or angle, or above it");
}

static void add_friction(listing *t)
{
    static const char *const circles[4] = {"circle_A", "circle_B", "circle_C", "circle_D"};
    const fourlink_friction *f = &t->d->machine.friction;
    int i;

    t->section = "friction";
    for (i = 0; i < 4; i++)
        add_input_unless_0(t, circles[i], QUANTITY_LENGTH, f->circle[i],
                           "radius of the friction circle");
    add_input_unless_0(t, "guide", QUANTITY_NUMBER, f->guide,
                       "coefficient of friction of the guide");
    add_input_unless_0(t, "guide_length", QUANTITY_LENGTH, f->guide_length,
                       "length of the guided block");
}

static void add_gas(listing *t)
{
    const flk_element *element = flk_machine_find(&t->d->machine, &flk_gas_type, 0);
    const flk_gas *gas;

    if (!element)
        return;
    gas = element->data;
    t->section = "gas";
    add_input(t, "area", QUANTITY_AREA, gas->area, "area of the piston on the cover side");
    if (gas->back_area != gas->area)
        add_input(t, "back_area", QUANTITY_AREA, gas->back_area,
                  "area of the piston on the crank side");
    if (gas->indicator.n)
        add_words(t, "indicator", "a curve", "pressure on the cover side");
    else
        add_input(t, "pressure", QUANTITY_PRESSURE, gas->pressure, "pressure on the cover side");
    add_input_unless_0(t, "back_pressure", QUANTITY_PRESSURE, gas->back_pressure,
                       "pressure on the crank side");
}

#define MOST_OF_DECK 60 /* links 20, slide 2, gravity 2, motion 13, motor 8, gas 5, flywheel 3 */
#define MOST_OF_ELEMENT 12
#define MOST_OF_FRICTION 6

size_t flk_list_input_limit(const deck *d)
{
    return MOST_OF_DECK + MOST_OF_ELEMENT * d->machine.n_elements + MOST_OF_FRICTION;
}

void flk_list_inputs(const deck *d, flk_list *inputs)
{
    int kind = (int)d->design.kind, slides_on_lever = fourlink_slides(kind, FOURLINK_COUPLER) != 0;
    const flk_element *e;
    listing t;
    size_t i;
    int link;

    if (inputs->n)
        return;
    t.d = d;
    t.to = inputs;
    for (link = FOURLINK_GROUND; link <= FOURLINK_FOLLOWER; link++)
        add_link(&t, link);
    t.section = fourlink_link_text(kind, slides_on_lever ? FOURLINK_FOLLOWER : FOURLINK_GROUND);
    add_input_unless_0(&t, "offset", QUANTITY_LENGTH, d->design.offset,
                       slides_on_lever ? "distance at which the slide passes D"
                                       : "offset of the line of stroke");
    add_input_unless_0(&t, "angle", QUANTITY_ANGLE, d->design.angle,
                       "angle of the slide from the line D-C");
    t.section = "gravity";
    add_input(&t, "x", QUANTITY_ACCELERATION, d->design.gravity.x, "gravity, x");
    add_input(&t, "y", QUANTITY_ACCELERATION, d->design.gravity.y, "gravity, y");
    add_motion(&t);
    add_motor(&t);
    for (i = 0; (e = flk_machine_find(&d->machine, &flk_given_load_type, i)) != NULL; i++)
        list_load(&t, e);
    for (i = 0; (e = flk_machine_find(&d->machine, &flk_spring_type, i)) != NULL; i++)
        add_spring(&t, e);
    add_friction(&t);
    add_gas(&t);
    t.section = "flywheel";
    add_input_unless_0(&t, "inertia", QUANTITY_INERTIA, d->machine.flywheel,
                       "moment of inertia of the flywheel");
    add_input_unless_0(&t, "fluctuation", QUANTITY_NUMBER, d->flywheel_fluctuation,
                       "coefficient of fluctuation of speed");
    if (d->drive.fluctuation > 0)
        add_words(&t, "exact", "yes", "the flywheel has this fluctuation in the actual motion");
}
