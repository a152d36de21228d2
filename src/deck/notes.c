/* SPDX-License-Identifier: GPL-3.0-or-later
**
** notes.c - notes on values that are allowed but probably not meant.
*/
#include <math.h>
#include <string.h>

#include <gsl/gsl_math.h>

#include "base/trig.h"
#include "mechanics/kind.h"
#include "mechanics/mechanism.h"
#include "build.h"
#include "build_motor.h"
#include "parser.h"
#include "settings.h"
#include "values.h"

/* ------------------------------------------------------------------------------------------- units */

static size_t count_digits(text t)
{
    size_t n;

    for (n = 0; n < t.length && strchr("0123456789", t.start[n]); n++)
        ;
    return n;
}

/* 1 if a number has three decimals and at most three digits before them: 1.200 rpm. */
static int is_like_thousands(text t)
{
    size_t n;

    if (t.length && strchr("+-", t.start[0]))
        t = flk_text_from(t, 1);
    n = count_digits(t);
    return n >= 1 && n <= 3 && n < t.length && t.start[n] == '.' &&
           count_digits(flk_text_from(t, n + 1)) == 3;
}

#define SLOW 20 /* rpm; a thousand times as much is the speed of a fast machine */

/* Note 1.200 rpm, where a point probably separates thousands. */
static void check_thousands(parser *p, key_code key)
{
    const setting *s = flk_setting_find(p, key);
    double rpm = s->si[0] * 60 / (2 * M_PI);

    if (s->si[0] != 0 && fabs(rpm) < SLOW && fabs(s->number) < SLOW && fabs(s->number) >= 1 &&
        fabs(rpm - s->number) < 1e-9 && is_like_thousands(s->value))
        flk_mistake(NOTES(p), s->place,
                    "'%t' is read as %g rpm, with a decimal point: if thousands are meant, write "
                    "%g rpm",
                    s->value, s->number, 1000 * s->number);
}

/* 1 if a setting is a bare number, and the deck does not give the unit of such numbers. */
static int is_bare(parser *p, const setting *s, quantity q)
{
    text name;
    unit u;

    return IS_SET(s) && !s->curve && !s->of_length && !s->of_centre && !s->of_pins &&
           !p->d->bare[q].is_given && flk_unit_of_value(p->d, s->value, q, &name, &u) &&
           !name.length;
}

/* Note the first bare number of a quantity that is too large for its SI unit: a crank of 40 m. */
static void check_bare(parser *p, quantity q, double most, const char *other)
{
    const char *own = flk_quantities[q].unit;
    size_t i;
    key_code k;

    for (i = 0; i < p->n_uses; i++)
        for (k = flk_first_key(p->uses[i].section); k < flk_first_key(p->uses[i].section + 1);
             k++) {
            const setting *s = flk_setting_of(&p->uses[i], k);

            if (flk_quantity_of_key(&p->uses[i], k) != q || flk_key_table[k].form == FORM_UNIT ||
                !is_bare(p, s, q) || flk_length(s->si[0], s->si[1]) <= most)
                continue;
            flk_mistake(NOTES(p), s->place, "'%t' is read as %s: write %t %s or %t %s", s->value,
                        own, s->value, own, s->value, other);
            return;
        }
}

/* Note bare numbers that are probably not in SI units, as the lengths are in mm, or as results are in in and
** lb. */
static void check_all_bare(parser *p)
{
    const deck_unit *units = p->d->units;
    int is_mass_checked = 0;
    quantity q;
    size_t i;

    check_bare(p, QUANTITY_LENGTH, 10, "mm");
    for (i = 0; flk_values_are_customary(p->d, i, &q); i++) {
        is_mass_checked |= q == QUANTITY_MASS;
        if (!units[q].is_given)
            check_bare(p, q, 0, units[q].name);
    }
    if (!is_mass_checked)
        check_bare(p, QUANTITY_MASS, 500, "g");
    check_bare(p, QUANTITY_ANGULAR_SPEED, 0, "rpm"); /* most speeds are in rpm */
}

/* -------------------------------------------------------------------------------------- mass and size */

#define FAR 10 /* times the longest link */

static double longest_link(const fourlink_design *design)
{
    double longest = 0;
    int i;

    for (i = FOURLINK_GROUND; i <= FOURLINK_FOLLOWER; i++)
        longest = GSL_MAX(longest, design->link[i].length);
    return longest;
}

/* Note a radius of gyration or a centre of mass that is far outside the mechanism. */
static void check_body(parser *p, int number)
{
    const fourlink_link *link = &p->d->machine.mechanism.design.link[number];
    section_code section = flk_section_of_link(p->d->machine.mechanism.design.kind, number);
    const char *name = flk_section_table[section].name;
    const setting *inertia = flk_setting_by_name(p, section, "inertia"),
                  *gyration = flk_setting_by_name(p, section, "gyration"),
                  *cg = flk_setting_by_name(p, section, "cg");
    double longest = longest_link(&p->d->machine.mechanism.design);
    double k = link->mass > 0 ? sqrt(fabs(link->inertia) / link->mass) : 0;

    if ((IS_SET(inertia) || IS_SET(gyration)) && k > FAR * longest)
        flk_mistake(
            NOTES(p), (IS_SET(inertia) ? inertia : gyration)->place,
            "the radius of gyration of the %s is %.4g m, the longest link has %.4g m: is the "
            "unit right%s?",
            name, k, longest, IS_SET(inertia) ? ", kg m2 or kg mm2" : "");
    if (IS_SET(cg) && link->mass > 0 && flk_length(link->cg.x, link->cg.y) > FAR * longest)
        flk_mistake(NOTES(p), cg->place,
                    "the centre of mass of the %s is %.4g m from its origin, the longest link has "
                    "%.4g m: is the unit right?",
                    name, flk_length(link->cg.x, link->cg.y), longest);
}

/* -------------------------------------------------------------------------------------------- numbers */

/* Note a number above 1 that is usually far below, such as 15 for 15 %. */
static int check_above_one(parser *p, const setting *s, const char *words)
{
    int is_percent = s->value.length && s->value.start[s->value.length - 1] == '%';

    if (!IS_SET(s) || !(s->si[0] > 1))
        return 0;
    flk_mistake(NOTES(p), s->place,
                is_percent ? "%s of %t is above 100 %%"
                           : "%s of %t is above 1: write %t %% if per cent are meant",
                words, s->value, s->value);
    return 1;
}

static void check_friction(parser *p)
{
    static const char words[] = "a coefficient of friction";
    const setting *all = flk_setting_find(p, KEY_FRICTION_RADIUS);
    double crank = p->d->machine.mechanism.design.link[FOURLINK_CRANK].length, circle;
    int i, is_large = check_above_one(p, flk_setting_find(p, KEY_FRICTION_MU), words);

    for (i = 0; i < 4; i++) {
        const key_code *keys = flk_friction_keys[i];
        const setting *radius = flk_setting_find(p, keys[1]);

        circle = p->d->machine.friction.circle[i];
        if (check_above_one(p, flk_setting_find(p, keys[0]), words) || is_large ||
            !(circle > crank))
            continue;
        flk_mistake(
            NOTES(p), (IS_SET(radius) ? radius : all)->place,
            "the friction circle of %s has a radius of %.4g m, the crank a length of %.4g m",
            flk_key_table[keys[0]].name, circle, crank);
        is_large = !IS_SET(radius); /* of all pins: once */
    }
    check_above_one(p, flk_setting_find(p, KEY_FRICTION_GUIDE), words);
}

/* ---------------------------------------------------------------------------------------------- loads */

static void check_spring(parser *p, const section_use *use)
{
    const setting *stiffness = flk_setting_of(use, KEY_SPRING_STIFFNESS);

    if (stiffness->si[0] < 0)
        flk_mistake(NOTES(p), stiffness->place,
                    "a negative stiffness: the spring drives its ends away from where it is free");
}

#define VACUUM -101325 /* Pa, against the atmosphere */
#define FAINT 1000     /* Pa; a bare pressure below it was meant in bar or MPa */

static void check_pressure(parser *p, key_code key)
{
    const setting *s = flk_setting_find(p, key);

    if (s->si[0] < 1.001 * VACUUM)
        flk_mistake(NOTES(p), s->place,
                    "%t is less than a vacuum, which is -1.01325 bar against the atmosphere",
                    s->value);
    if (s->si[0] != 0 && fabs(s->si[0]) < FAINT && is_bare(p, s, QUANTITY_PRESSURE))
        flk_mistake(NOTES(p), s->place, "'%t' is read as Pa: write %t Pa or %t MPa", s->value,
                    s->value, s->value);
}

/* 1 if a torque over a speed always has the sign of that speed. */
static int drives(const flk_given_load *given)
{
    const curve *c = &given->values.torque_curve;
    int n = 0;
    size_t i;

    if (given->at_speed > 0)
        return given->values.torque > 0;
    for (i = 0; i < c->n; i++) {
        if (c->x[i] * c->y[i] < 0)
            return 0;
        n += c->x[i] * c->y[i] > 0;
    }
    return n > 0;
}

/* Note a load over the speed of its own link that drives it: a fan with a positive torque. */
static void check_load(parser *p, const section_use *use, const flk_given_load *given)
{
    const setting *over = flk_setting_of(use, KEY_LOAD_OVER);

    if ((given->over == FLK_OMEGA2 && given->load.link == FOURLINK_CRANK) ||
        (given->over == FLK_OMEGA4 && given->load.link == FOURLINK_FOLLOWER))
        if (drives(given))
            flk_mistake(
                NOTES(p), flk_setting_of(use, KEY_LOAD_TORQUE)->place,
                "this torque has the sign of %t, so it drives the %s: that of a fan or a "
                "brake has the opposite sign",
                over->value,
                fourlink_link_text((int)p->d->machine.mechanism.design.kind, given->load.link));
}

/* Note a curve at whose fast end the motor still drives: beyond it, it keeps this torque. */
static void check_motor(parser *p)
{
    const fourlink_motor *motor = &p->d->machine.motor;
    const setting *s = flk_setting_find(p, KEY_MOTOR_CURVE);
    const deck_unit *speed = &p->d->units[QUANTITY_ANGULAR_SPEED],
                    *torque = &p->d->units[QUANTITY_TORQUE];
    int sense = flk_build_sense(p) * (motor->ratio < 0 ? -1 : 1);
    unsigned long end = sense > 0 && motor->n_curve ? motor->n_curve - 1 : 0;

    if (!motor->n_curve || !(motor->curve_torque[end] * sense > 0))
        return;
    flk_mistake(
        NOTES(p), s->place,
        "the curve ends at %.4g %s with %.4g %s, which the motor keeps at higher speeds: end "
        "it with the speed at which the torque is 0",
        flk_unit_from_si(motor->curve_speed[end], speed->unit), speed->name,
        flk_unit_from_si(motor->curve_torque[end], torque->unit), torque->name);
}

/* Note a program that jumps in speed. */
static void check_program(parser *p)
{
    const flk_program *program = p->d->program;
    unsigned long i;

    for (i = 0; program && !program->is_of_speed && i < program->n; i++)
        if (program->segment[i].law == FLK_LAW_LINEAR && program->segment[i].rise != 0) {
            flk_mistake(
                NOTES(p), flk_setting_find(p, KEY_MOTION_PROGRAM)->place,
                "a linear law jumps in speed at its points: the rows have no force of these "
                "jumps");
            return;
        }
}

#define MANY_TURNS 100

/* Note a long run-up by a constant torque that nothing opposes. */
static void check_run_up(parser *p)
{
    const flk_machine *machine = &p->d->machine;
    const fourlink_motor *motor = &machine->motor;
    double turns = flk_setting_or(p, KEY_MOTION_TO, 0) / (2 * M_PI);

    if (p->d->mode.kind != MODE_GIVEN && p->d->over->is_crank_angle && !machine->n_elements &&
        !machine->has_friction && motor->kind == FOURLINK_MOTOR_TORQUE && motor->torque != 0 &&
        fabs(flk_setting_or(p, KEY_MOTION_TURNS, turns)) > MANY_TURNS)
        flk_mistake(NOTES(p), flk_setting_find(p, KEY_MOTOR_TORQUE)->place,
                    "nothing opposes this torque, so the crank turns faster and faster: give a "
                    "load, or a motor whose torque falls with the speed");
}

/* Note an instant with an acceleration, whose row in a table has another speed than it:
** omega2^2 = speed^2 + 2 acceleration (theta2 - from). */
static void check_instant(parser *p)
{
    const fourlink_motion *motion = &p->d->motion;
    const deck_unit *angle = &p->d->units[QUANTITY_ANGLE],
                    *speed = &p->d->units[QUANTITY_ANGULAR_SPEED];
    double from = flk_setting_or(p, KEY_MOTION_FROM, 0), sense = flk_build_sense(p);
    double there = motion->from * motion->angle_unit, turned = sense * (there - from), square;
    char row[MESSAGE_SIZE] = "there is none here, as the crank comes to rest before";

    turned -= 2 * M_PI * floor(turned / (2 * M_PI));
    if (!p->d->one_instant || p->d->prescribed || motion->acceleration == 0 || motion->hold ||
        turned == 0)
        return;
    square = motion->speed * motion->speed + 2 * motion->acceleration * sense * turned;
    if (square >= 0)
        flk_message(row, sizeof row, "the one here has %g %s",
                    flk_unit_from_si(sense * sqrt(square), speed->unit), speed->name);
    flk_mistake(
        NOTES(p), flk_setting_find(p, KEY_MOTION_AT)->place,
        "the speed is that at %g %s; in the rows of an interval it is that of the first, at "
        "%g %s, and %s: write hold = yes if this instant is meant",
        motion->from, angle->name, flk_unit_from_si(from, angle->unit), angle->name, row);
}

/* Note what is of the four links alone in a deck with outputs. */
static void check_outputs(parser *p)
{
    const section_use *friction = flk_section_find(p, SECTION_FRICTION, NULL),
                      *balance = flk_section_find(p, SECTION_BALANCE, NULL);

    if (!p->d->machine.mechanism.design.n_groups)
        return;
    if (friction)
        flk_mistake(NOTES(p), friction->place, "the joints of outputs have no friction");
    if (balance)
        flk_mistake(NOTES(p), balance->place,
                    "the counterweights are for the four links, without the outputs");
}

void flk_build_notes(parser *p)
{
    const section_use *use = NULL;
    int k;

    if (p->mistakes->count || p->out_of_memory)
        return;
    check_all_bare(p);
    check_thousands(p, KEY_MOTION_SPEED);
    check_thousands(p, KEY_MOTION_MEAN_SPEED);
    check_thousands(p, KEY_MOTOR_NO_LOAD_SPEED);
    for (k = FOURLINK_CRANK; k <= FOURLINK_FOLLOWER; k++)
        check_body(p, k);
    while ((use = flk_section_next(p, SECTION_SPRING, use)) != NULL)
        check_spring(p, use);
    while ((use = flk_section_next(p, SECTION_LOAD, use)) != NULL)
        check_load(p, use, use->element->data);
    check_outputs(p);
    check_friction(p);
    check_pressure(p, KEY_GAS_PRESSURE);
    check_pressure(p, KEY_GAS_BACK_PRESSURE);
    check_above_one(p, flk_setting_find(p, KEY_FLYWHEEL_FLUCTUATION), "a fluctuation");
    check_motor(p);
    check_program(p);
    check_run_up(p);
    check_instant(p);
}

/* ------------------------------------------------------------------------------------- ends of curves */

#define PLACES 180    /* of the motion, that are checked */
#define ROUNDING 1e-9 /* of the curve */

/* The crank at a share of the motion; 0 if it is not known. */
static int crank_at(const deck *d, double share, fourlink_crank *crank)
{
    double end = d->one_instant ? d->motion.from : d->motion.to, begin, x[3];
    fourlink_row row;
    int status;

    if (d->prescribed)
        return 0;
    if (d->program) {
        begin = d->program->segment[0].begin;
        flk_program_at(d->program, begin + share * (flk_program_end(d->program) - begin), x);
        crank->theta2 = x[0];
        crank->omega2 = x[1];
        crank->alpha2 = x[2];
        return 1;
    }
    status = fourlink_motion_at(&d->motion, d->motion.from + (end - d->motion.from) * share, &row);
    if (status == FOURLINK_OK)
        *crank = row.crank;
    return status == FOURLINK_OK;
}

/* The smallest and the largest argument of a load over the motion.  If the motion is not given, speeds are
** unknown. */
static void find_range(const deck *d, flk_variable over, double *low, double *high)
{
    fourlink_state state;
    fourlink_crank crank;
    int i, branch;

    *low = GSL_POSINF;
    *high = GSL_NEGINF;
    for (i = 0; i <= PLACES; i++)
        for (branch = FOURLINK_CROSSED; branch <= FOURLINK_OPEN; branch += 2) {
            if (!(branch == FOURLINK_OPEN ? d->open : d->crossed) ||
                !crank_at(d, (double)i / PLACES, &crank) ||
                flk_mechanism_move(&d->machine.mechanism, (fourlink_branch)branch, &crank, 0,
                                   &state) != FOURLINK_OK)
                continue;
            *low = GSL_MIN(*low, flk_variable_value(&state, over));
            *high = GSL_MAX(*high, flk_variable_value(&state, over));
        }
}

/* Note that the motion goes beyond a curve. */
static void check_ends(parser *p, const setting *s, const setting *over, const curve *c)
{
    const deck_unit *u = &p->d->units[flk_values_quantity_over(over->word)];
    double low, high, first, last;

    if (!c->n || c->period > 0)
        return;
    find_range(p->d, (flk_variable)over->word, &low, &high);
    first = c->x[0];
    last = c->x[c->n - 1];
    if (low >= first - ROUNDING * (last - first) && high <= last + ROUNDING * (last - first))
        return;
    flk_mistake(NOTES(p), s->place,
                "%t goes from %.6g to %.6g %s: before %.6g and after %.6g %s the value of the "
                "nearest point holds",
                over->value, flk_unit_from_si(low, u->unit), flk_unit_from_si(high, u->unit),
                u->name, flk_unit_from_si(first, u->unit), flk_unit_from_si(last, u->unit),
                u->name);
}

void flk_build_curve_ends(parser *p)
{
    const section_use *use = NULL;

    if (p->mistakes->count || p->out_of_memory)
        return;
    while ((use = flk_section_next(p, SECTION_LOAD, use)) != NULL) {
        const setting *over = flk_setting_of(use, KEY_LOAD_OVER),
                      *back = flk_setting_of(use, KEY_LOAD_BACK);
        const flk_given_load *given = use->element->data;

        if (over->word <= FLK_THETA4 || (p->d->mode.kind != MODE_GIVEN && FLK_IS_SPEED(over->word)))
            continue;
        check_ends(p, flk_setting_of(use, KEY_LOAD_FORCE), over, &given->values.force_curve[0]);
        check_ends(p, flk_setting_of(use, KEY_LOAD_TORQUE), over, &given->values.torque_curve);
        check_ends(p, back, over, &given->back.force_curve[0]);
        check_ends(p, back, over, &given->back.torque_curve);
    }
}
