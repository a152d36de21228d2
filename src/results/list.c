/* SPDX-License-Identifier: GPL-3.0-or-later
**
** list.c - the lists of a deck: columns, inputs, variables of a sweep.
*/
#include <math.h>
#include <string.h>

#include "deck/inputs.h"
#include "deck/numbers.h"
#include "deck/schema.h"
#include "list.h"

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
    v->flags = flk_column_flags(c) | (flk_column_is_direction(c) ? FOURLINK_DIRECTION : 0);
    v->handle = flk_column_handle(c, FLK_NONE);
}

unsigned long flk_list_number(int handle)
{
    return handle <= FLK_NUMBER_HANDLE(1) && handle % 2 ? (unsigned long)((-1001 - handle) / 2) : 0;
}

const char *flk_line_unit_text(flk_line_units *units, const char *name)
{
    size_t i;

    for (i = 0; i < units->n; i++)
        if (strcmp(units->texts + DECK_NAME_SIZE * i, name) == 0)
            return units->texts + DECK_NAME_SIZE * i;
    units->n++;
    return strcpy(units->texts + DECK_NAME_SIZE * i, name);
}

/* Tell the unit of the line that gives a number. */
static void tell_line_unit(const deck *d, unsigned long id, flk_line_units *units,
                           fourlink_value *v)
{
    deck_unit u;

    if (!flk_number_follows(d, id) && flk_number_unit(d, id, &u))
        v->line_unit = flk_line_unit_text(units, u.name);
}

int flk_list_number_value(const deck *d, unsigned long id, flk_line_units *units, fourlink_value *v)
{
    const char *key;
    deck_unit own;
    double si;
    quantity q;

    if (!flk_number_describe(d, id, &q, &key, &si))
        return 0;
    flk_list_describe(d, q, "", v);
    v->name = key;
    v->handle = FLK_NUMBER_HANDLE(id);
    v->value = flk_number_unit(d, id, &own) ? flk_number_written(si, own.unit, d->units[q].unit)
                                            : flk_unit_from_si(si, d->units[q].unit);
    tell_line_unit(d, id, units, v);
    return 1;
}

void flk_list_columns(const flk_analysis *a, flk_list *columns)
{
    flk_column c;
    size_t i;

    if (columns->n)
        return;
    for (i = 0; i < flk_column_limit(a->d); i++)
        if (flk_column_number(a, i, &c) && !c.source->is_apart)
            flk_list_column(a->d, &c, &columns->list[columns->n++]);
}

void flk_list_variables(const deck *d, flk_line_units *units, flk_list *variables)
{
    size_t i;

    for (i = 0; i < d->sweep.n_variables; i++) {
        const deck_variable *x = &d->sweep.variables[i];
        fourlink_value *v = &variables->list[variables->n++];

        flk_list_describe(d, x->q, "varied by [sweep]", v);
        v->handle = FLK_NUMBER_HANDLE(x->number);
        v->name = flk_text_copy(x->name, variables->names + DECK_NAME_SIZE * i, DECK_NAME_SIZE);
        v->value = x->value;
        tell_line_unit(d, x->number, units, v);
    }
}

/* ------------------------------------------------------------------------------------------ inputs */

/* The inputs listed so far. */
typedef struct listing {
    const deck *d;
    flk_list *to;
    flk_line_units *units;
    unsigned long section; /* number of the first of the present section */
} listing;

/* Add an input without its number; it has the next handle, if it needs one. */
static fourlink_value *add_input(listing *t, const char *name, quantity q, const char *meaning)
{
    char *copy = t->to->names + DECK_NAME_SIZE * t->to->n;
    fourlink_value *v = &t->to->list[t->to->n++];

    flk_list_describe(t->d, q, meaning, v);
    v->name = strcpy(copy, name);
    v->handle = FLK_LIST_HANDLE(t->to->n);
    return v;
}

/* Add an input that the deck gives; takes a listing. */
static void add_given(void *host, const deck_input *input)
{
    listing *t = host;
    fourlink_value *v = add_input(t, input->name, QUANTITY_NUMBER, input->meaning), number;

    if (input->words) {
        v->words = input->words;
        v->unit = "";
        return;
    }
    if (!flk_list_number_value(t->d, input->number, t->units, &number)) {
        flk_list_describe(t->d, QUANTITY_LENGTH, input->meaning, &number);
        number.handle = FLK_NUMBER_HANDLE(input->number);
        number.value = flk_unit_from_si(input->place, t->d->units[QUANTITY_LENGTH].unit);
    }
    number.name = v->name;
    number.meaning = input->meaning;
    *v = number;
}

/* The input of this name in the present section; null if it is not listed. */
static fourlink_value *find_input(const listing *t, const char *name)
{
    unsigned long i;

    for (i = t->section; i < t->to->n; i++)
        if (strcmp(t->to->list[i].name, name) == 0)
            return &t->to->list[i];
    return NULL;
}

/* Add what the deck does not give but the results depend on, unless the section has it; `value` is in
** the deck's unit.  Returns the input. */
static fourlink_value *add_default(listing *t, const char *section, const char *key, quantity q,
                                   double value, const char *meaning)
{
    char name[DECK_NAME_SIZE];
    unsigned long number;
    fourlink_value *v;

    flk_text_join(name, sizeof name, section, ".", key, (char *)NULL);
    v = find_input(t, name);
    if (v)
        return v;
    v = add_input(t, name, q, meaning);
    v->value = value;
    number = flk_number_find(t->d, flk_text_of(name));
    if (number) {
        v->handle = FLK_NUMBER_HANDLE(number);
        tell_line_unit(t->d, number, t->units, v);
    }
    return v;
}

#define ROUNDING 1e-15 /* of a value: it is as the deck gives it */

/* Add what follows from other values, in SI units, unless it is 0.  It takes the place of a value that the
** deck gives: the mass of a crank includes its counterweight. */
static void add_derived(listing *t, const char *section, const char *key, quantity q, double si,
                        const char *meaning)
{
    double value = flk_unit_from_si(si, t->d->units[q].unit);
    fourlink_value *v;

    if (si == 0)
        return;
    v = add_default(t, section, key, q, value, meaning);
    if (fabs(v->value - value) > ROUNDING * fabs(value))
        v->value = value;
}

/* What the section of a link leaves to the length, the stroke, the uniform bar, the pendulum, synthesis. */
static void derive_link(listing *t, int i)
{
    const fourlink_link *link = &t->d->machine.mechanism.design.link[i];
    const char *name = fourlink_link_text((int)t->d->machine.mechanism.design.kind, i);

    add_derived(t, name, "length", QUANTITY_LENGTH, link->length, "length");
    add_derived(t, name, "mass", QUANTITY_MASS, link->mass, "mass");
    add_derived(t, name, "inertia", QUANTITY_INERTIA, link->inertia,
                "inertia about the centre of mass");
    add_derived(t, name, "cg.x", QUANTITY_LENGTH, link->cg.x, "centre of mass, along the link");
    add_derived(t, name, "cg.y", QUANTITY_LENGTH, link->cg.y,
                "centre of mass, to the left of the link");
}

/* The offset that synthesis found. */
static void derive_offset(listing *t)
{
    if (!fourlink_slides((int)t->d->machine.mechanism.design.kind, FOURLINK_COUPLER))
        add_derived(t, "ground", "offset", QUANTITY_LENGTH, t->d->machine.mechanism.design.offset,
                    "offset of the line of stroke");
}

/* The angle of a ground that is given by the place of D. */
static void derive_angle(listing *t)
{
    if (find_input(t, "ground.to.x"))
        add_default(t, "ground", "angle", QUANTITY_ANGLE,
                    flk_unit_from_si(t->d->inclination, t->d->units[QUANTITY_ANGLE].unit),
                    "direction of the ground link");
}

/* What the pins give besides lengths. */
static void derive_from_pins(listing *t, section_code section)
{
    const deck_pins *pins = &t->d->pins;

    if (!pins->is_there)
        return;
    if (section == SECTION_PINS)
        add_default(t, "pins", "drawn", QUANTITY_ANGLE,
                    flk_unit_from_si(flk_deck_drawn(t->d), t->d->units[QUANTITY_ANGLE].unit),
                    "crank angle as drawn");
    if (section == SECTION_GROUND) {
        add_derived(t, "ground", "offset", QUANTITY_LENGTH, pins->offset,
                    "offset of the line of stroke or guide");
        add_default(t, "ground", "angle", QUANTITY_ANGLE, 0, "direction of the ground link")
            ->value = flk_unit_from_si(pins->angle, t->d->units[QUANTITY_ANGLE].unit);
    }
    if (section == SECTION_LEVER)
        add_derived(t, "lever", "angle", QUANTITY_ANGLE, pins->slide,
                    "angle of the slide from the line D-C");
}

static void add_words(listing *t, const char *name, const char *words, const char *meaning)
{
    fourlink_value *v = add_input(t, name, QUANTITY_NUMBER, meaning);

    v->words = words;
    v->unit = "";
}

/* The law of a program, and how it ends where it is a spline there. */
static void derive_program(listing *t, const flk_program *program)
{
    static const char *const ends[] = {"natural", "speeds", "periodic"};
    flk_law first = program->segment[0].law, last = program->segment[program->n - 1].law;
    unsigned long i = 0;

    while (i < program->n && program->segment[i].law == first)
        i++;
    add_words(t, "motion.law", i < program->n ? "several" : flk_law_names[first],
              "the law between the points of a program");
    if (first == FLK_LAW_SPLINE || last == FLK_LAW_SPLINE)
        add_words(t, "motion.ends", ends[program->ends], "how the spline of a program ends");
}

/* The range of a prescribed coordinate. */
static void derive_prescribed(listing *t, const deck_prescribed *x)
{
    quantity q = flk_deck_over(t->d);
    const unit *u = &t->d->units[q].unit;

    add_default(t, "motion", "from", q, flk_unit_from_si(x->motion.from, *u),
                "first value of the input");
    add_default(t, "motion", "to", q, flk_unit_from_si(x->motion.to, *u),
                "last value of the input");
    add_default(t, "motion", "interval", q, flk_unit_from_si(x->motion.interval, *u),
                "interval of the input");
}

static void derive_side(listing *t, const deck_prescribed *x)
{
    if (!find_input(t, "motion.side"))
        add_words(t, "motion.side", fourlink_input_side_text(x->side),
                  "whether the input rises or falls as the crank turns counter-clockwise");
}

/* What motion and rows have without being told. */
static void derive_motion(listing *t)
{
    const fourlink_motion *motion = &t->d->motion;

    if (t->d->one_instant)
        return;
    if (t->d->prescribed && !t->d->program) {
        derive_prescribed(t, t->d->prescribed);
        derive_side(t, t->d->prescribed);
        return;
    }
    if (t->d->prescribed)
        derive_side(t, t->d->prescribed);
    else
        add_default(t, "motion", "from", QUANTITY_ANGLE, motion->from, "first crank angle");
    if (t->d->program) {
        derive_program(t, t->d->program);
        add_default(t, "motion", "time_step", QUANTITY_TIME,
                    flk_unit_from_si(t->d->mode.time_step, t->d->units[QUANTITY_TIME].unit),
                    "interval of rows by time");
    }
    if (motion->run_up <= 0 && t->d->over->is_crank_angle)
        add_default(t, "motion", "to", QUANTITY_ANGLE, motion->to, "last crank angle");
    if (t->d->over->is_crank_angle)
        add_default(t, "motion", "interval", QUANTITY_ANGLE, motion->interval,
                    "interval of the crank angle");
    add_derived(t, "motion", "cycle", QUANTITY_ANGLE, t->d->machine.cycle,
                "period of curves and loads");
}

static void derive_friction(listing *t)
{
    static const char *const circles[4] = {"circle_A", "circle_B", "circle_C", "circle_D"};
    int i;

    for (i = 0; i < 4; i++)
        add_derived(t, "friction", circles[i], QUANTITY_LENGTH, t->d->machine.friction.circle[i],
                    "radius of the friction circle");
}

static void derive_gas(listing *t)
{
    const flk_element *element = flk_machine_find(&t->d->machine, &flk_gas_type, 0);
    const flk_gas *gas = element ? element->data : NULL;

    if (!gas)
        return;
    add_derived(t, "gas", "area", QUANTITY_AREA, gas->area, "area of the piston on the cover side");
    if (gas->back_area != gas->area)
        add_derived(t, "gas", "back_area", QUANTITY_AREA, gas->back_area,
                    "area of the piston on the crank side");
    if (gas->clearance > 0)
        add_derived(t, "gas", "clearance_volume", QUANTITY_VOLUME, gas->clearance,
                    "volume at the inner dead centre");
}

static void derive_gravity(listing *t)
{
    fourlink_vector g = t->d->axes.gravity;
    quantity q = QUANTITY_ACCELERATION;

    add_default(t, "gravity", "x", q, flk_unit_from_si(g.x, t->d->units[q].unit), "gravity, x");
    add_default(t, "gravity", "y", q, flk_unit_from_si(g.y, t->d->units[q].unit), "gravity, y");
}

static void derive_flywheel(listing *t)
{
    add_derived(t, "flywheel", "inertia", QUANTITY_INERTIA, t->d->machine.flywheel,
                "moment of inertia of the flywheel");
}

/* Add what a section leaves to defaults and to other keys. */
static void add_what_follows(listing *t, section_code section)
{
    static const struct {
        section_code section;
        void (*derive)(listing *t);
    } sections[] = {{SECTION_MOTION, derive_motion},
                    {SECTION_GRAVITY, derive_gravity},
                    {SECTION_FRICTION, derive_friction},
                    {SECTION_GAS, derive_gas},
                    {SECTION_FLYWHEEL, derive_flywheel}};
    size_t i;
    int link;

    for (link = FOURLINK_GROUND; link <= FOURLINK_FOLLOWER; link++)
        if (flk_section_of_link(t->d->machine.mechanism.design.kind, link) == section)
            derive_link(t, link);
    derive_from_pins(t, section);
    if (section == SECTION_GROUND) {
        derive_offset(t);
        derive_angle(t);
    }
    for (i = 0; i < sizeof sections / sizeof *sections; i++)
        if (sections[i].section == section)
            sections[i].derive(t);
}

/* 1 if a section has inputs: not names, units and what has lists of its own. */
static int has_inputs(section_code section)
{
    return section != SECTION_TOP && section != SECTION_UNITS && section != SECTION_TABLE &&
           section != SECTION_SYNTHESIS && !TAKES_NAMES(section);
}

#define MOST_DERIVED \
    48 /* links 20, pins 4, offset 1, gas 3, motion 7, gravity 2, friction 4, flywheel 1 */

size_t flk_list_input_limit(const deck *d)
{
    return MOST_DERIVED + flk_inputs_limit(d);
}

size_t flk_line_unit_limit(const deck *d)
{
    return flk_list_input_limit(d) + d->sweep.n_variables + QUANTITY_COUNT;
}

void flk_list_inputs(const deck *d, flk_line_units *units, flk_list *inputs)
{
    listing t;
    int section;

    if (inputs->n)
        return;
    t.d = d;
    t.to = inputs;
    t.units = units;
    for (section = 0; section < SECTION_COUNT; section++) {
        t.section = inputs->n;
        if (!has_inputs((section_code)section))
            continue;
        flk_inputs_walk(d, (section_code)section, add_given, &t);
        add_what_follows(&t, (section_code)section);
    }
}
