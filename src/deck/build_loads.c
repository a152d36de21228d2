/* SPDX-License-Identifier: GPL-3.0-or-later
**
** build_loads.c - builds loads, gas, curves over the crank angle and points from values.
*/
#include <math.h>
#include <string.h>

#include <gsl/gsl_math.h>

#include "mechanics/kind.h"
#include "reader.h"

/* rad; angles closer than this are equal */
#define LEAST_STEP 1e-9

/* 1 if a point repeats another, in all components. */
static int repeats(const point *c, const point *first)
{
    return gsl_hypot(c->y[0] - first->y[0], c->y[1] - first->y[1]) <=
           1e-9 * gsl_hypot(first->y[0], first->y[1]);
}

/* The period of a curve: the cycle for theta2, a turn for theta4; 0 for other arguments, which are not
** periodic. */
static double period_of(const parser *p, int over)
{
    return over == FLK_THETA2 ? p->d->machine.cycle : over == FLK_THETA4 ? 2 * M_PI : 0;
}

int flk_build_is_rising(parser *p, const setting *s, double least, const char *message)
{
    size_t i;

    for (i = 1; i < s->n_points; i++)
        if (!(s->curve[i].x > s->curve[i - 1].x) || s->curve[i].x - s->curve[i - 1].x < least)
            return flk_mistake(p->mistakes, s->curve[i].place, message);
    return 1;
}

/* Check the points of a curve.  Its arguments must increase; angles cover at most one period.  A last point
** at the end of the period must repeat the first.  Returns the number of points without that one; 0 if they
** do not form a curve. */
static size_t check_curve(parser *p, const setting *s, int over, double period)
{
    const point *c = s->curve;
    size_t n = s->n_points;

    if (!c || !(p->d->machine.cycle > 0))
        return 0;
    if (!flk_build_is_rising(p, s, period > 0 ? LEAST_STEP : 0,
                             period > 0 ? "the angles of a curve must increase"
                                        : "the arguments of a curve must increase"))
        return 0;
    if (period > 0 && n > 1 && fabs(c[n - 1].x - c[0].x - period) < LEAST_STEP) {
        n--;
        if (!repeats(&c[n], &c[0])) {
            flk_mistake(p->mistakes, c[n].place,
                        "the curve is not periodic: one %s after its first point it has another "
                        "value",
                        over == FLK_THETA2 ? "cycle" : "turn");
            return 0;
        }
    }
    if (n < 2)
        flk_mistake(p->mistakes, s->place, "a curve needs at least two points");
    else if (period > 0 && c[n - 1].x - c[0].x > period - LEAST_STEP)
        flk_mistake(p->mistakes, c[n - 1].place,
                    over == FLK_THETA2
                        ? "the curve is longer than the cycle; give [motion] a cycle of 720 deg if "
                          "it is one of four strokes"
                        : "the curve is longer than a turn of theta4, 360 deg");
    else
        return n;
    return 0;
}

/* Build one curve for each component of a setting. */
static void build_curves(parser *p, const setting *s, int n_components, int over, curve *results)
{
    double period = period_of(p, over), *memory;
    size_t n = check_curve(p, s, over, period), i;
    int k;

    for (k = 0; n && k < n_components; k++) {
        memory = flk_reader_keep(p, FLK_CURVE_MEMORY(n) * sizeof *memory);
        if (!memory)
            return;
        flk_curve_place(memory, n, &results[k]);
        for (i = 0; i < n; i++) {
            results[k].x[i] = s->curve[i].x;
            results[k].y[i] = s->curve[i].y[k];
        }
        flk_curve_finish(period, &results[k]);
    }
}

flk_element *flk_build_element(parser *p)
{
    flk_machine *machine = &p->d->machine;

    if (!machine->element) /* a section makes one, at most */
        machine->element = flk_reader_keep(p, p->n_uses * sizeof *machine->element);
    return machine->element ? &machine->element[machine->n_elements++] : NULL;
}

void flk_build_gas(parser *p)
{
    const section_use *use = flk_section_find(p, SECTION_GAS, NULL);
    const setting *bore = flk_setting_find(p, KEY_GAS_BORE),
                  *rod = flk_setting_find(p, KEY_GAS_PISTON_ROD);
    const setting *pressure = flk_setting_find(p, KEY_GAS_PRESSURE),
                  *card = flk_setting_find(p, KEY_GAS_INDICATOR);
    double d_rod = rod->si[0];
    flk_element *element;
    flk_gas *gas;

    if (!use || !flk_build_has(p, KEY_GAS_BORE))
        return;
    p->d->has_forces = 1;
    if (!IS_SET(bore)) {
        if (!use->is_mistaken)
            flk_mistake(p->mistakes, use->place, "[gas] has no bore");
        return;
    }
    if (!use->is_mistaken && !IS_SET(pressure) && !IS_SET(card) &&
        !IS_SET(flk_setting_find(p, KEY_GAS_BACK_PRESSURE)))
        flk_mistake(p->mistakes, use->place, "[gas] has neither a pressure nor an indicator");
    if (IS_SET(pressure) && IS_SET(card))
        flk_mistake(p->mistakes, pressure->place,
                    "give either the pressure or the indicator, not both");
    if (d_rod >= bore->si[0] && bore->si[0] > 0)
        flk_mistake(p->mistakes, rod->place, "the piston_rod, %t, is not thinner than the bore",
                    rod->value);
    gas = flk_reader_keep(p, sizeof *gas);
    element = flk_build_element(p);
    if (!gas || !element)
        return;
    gas->area = M_PI / 4 * bore->si[0] * bore->si[0];
    gas->back_area = gas->area - M_PI / 4 * d_rod * d_rod;
    gas->pressure = pressure->si[0];
    gas->back_pressure = flk_setting_or(p, KEY_GAS_BACK_PRESSURE, 0);
    build_curves(p, card, 1, FLK_THETA2, &gas->indicator);
    flk_element_of_gas(gas, p->d->design.kind, element);
}

int flk_build_check_link(parser *p, const section_use *use, const setting *link)
{
    const flk_kind *kind = flk_kind_of(p->d->design.kind);
    const char *const *own = kind->link;

    if (!IS_SET(link) && !use->is_mistaken)
        flk_mistake(p->mistakes, use->place, "[%s] has no link: %s, %s or %s",
                    flk_section_table[use->section].name, own[2], own[3], own[4]);
    else if (link->word && !flk_text_equal(link->value, own[link->word]))
        return flk_mistake(p->mistakes, link->place, "%s %s has no %t: its links are %s, %s and %s",
                           flk_text_article(kind->words), kind->words, link->value, own[2], own[3],
                           own[4]);
    return 1;
}

/* Build the range of crank angles in which a load acts. */
static void build_window(parser *p, const section_use *use, flk_own_load *own)
{
    const setting *from = flk_setting_of(use, KEY_LOAD_FROM),
                  *to = flk_setting_of(use, KEY_LOAD_TO);

    if (!IS_SET(from) && !IS_SET(to))
        return;
    own->is_windowed = 1;
    own->window[0] = from->si[0]; /* 0 if not given */
    own->window[1] = IS_SET(to) ? to->si[0] : p->d->machine.cycle;
    if (use->is_mistaken)
        return;
    if (own->window[1] <= own->window[0])
        flk_mistake(p->mistakes, (IS_SET(from) ? from : to)->place,
                    "the load's 'from' must be less than its 'to', not %t and %t",
                    IS_SET(from) ? from->value : flk_text_of("0"),
                    IS_SET(to) ? to->value : flk_text_of("the end of the cycle"));
    else if (own->window[1] - own->window[0] > p->d->machine.cycle * (1 + 1e-12))
        flk_mistake(p->mistakes, (IS_SET(to) ? to : from)->place,
                    "the load acts for more than a cycle");
}

/* max(NAME.vx) must fit wherever names are stored. */
#define LONGEST_NAME 32

void flk_build_check_name(parser *p, const section_use *use, const char *columns)
{
    const char *what = flk_section_table[use->section].name;
    size_t i;

    if (!use->name.length)
        flk_mistake(p->mistakes, use->place, "a %s needs a name: [%s %s]", what, what,
                    use->section == SECTION_POINT ? "P" : "S");
    if (use->name.length > LONGEST_NAME)
        flk_mistake(p->mistakes, use->place, "the name of a %s is too long", what);
    for (i = 0; i < use->name.length; i++)
        if (!flk_text_is_word(use->name.start[i])) {
            flk_mistake(p->mistakes, use->place,
                        "the name of a %s must be one word: its columns are %s", what, columns);
            break;
        }
}

/* [point NAME] */
static void build_point(parser *p, const section_use *use, deck_point *new)
{
    static const char *const endings[DECK_POINT_COLUMNS] = {".x",  ".y",  ".vx", ".vy",
                                                            ".ax", ".ay", ".v",  ".a"};
    const setting *link = flk_setting_of(use, KEY_POINT_LINK),
                  *at = flk_setting_of(use, KEY_POINT_AT);
    size_t i;

    new->link = flk_build_check_link(p, use, link) ? link->word : 0;
    flk_build_check_name(p, use, "NAME.x, NAME.y ...");
    flk_build_place(p, at, new->link, &new->at);
    new->name = flk_reader_copy(p, use->name, "");
    for (i = 0; i < DECK_POINT_COLUMNS; i++)
        new->column_names[i] = flk_reader_copy(p, use->name, endings[i]);
}

void flk_build_points(parser *p)
{
    const section_use *use = NULL;

    if (!flk_section_find(p, SECTION_POINT, NULL))
        return;
    p->d->points = flk_reader_keep(p, p->n_uses * sizeof *p->d->points);
    while (!p->out_of_memory && (use = flk_section_next(p, SECTION_POINT, use)) != NULL)
        build_point(p, use, &p->d->points[p->d->n_points++]);
}

/* 1 if a link slides along the line of stroke: forces on it need neither a point nor a direction. */
static int is_piston(const parser *p, int link)
{
    return fourlink_slides((int)p->d->design.kind, link) == FOURLINK_GROUND;
}

/* The argument of the curves of a load. */
static int over_of(const section_use *use)
{
    return flk_setting_of(use, KEY_LOAD_OVER)->word;
}

/* Build the force of a load, and check its point. */
static void build_force(parser *p, const section_use *use, flk_own_load *own)
{
    const setting *force = flk_setting_of(use, KEY_LOAD_FORCE),
                  *at = flk_setting_of(use, KEY_LOAD_AT);
    int link = own->load.link;

    if (force->is_bare && link && !is_piston(p, link))
        flk_mistake(p->mistakes, force->place,
                    "expected a force with its direction, such as 50 N at 30 deg or (43, 25) N, "
                    "not '%t'",
                    force->value);
    else if ((force->si[0] != 0 || force->si[1] != 0 || force->curve) && !IS_SET(at) && link &&
             !use->is_mistaken && flk_kind_of(p->d->design.kind)->has_length[link] != FLK_NO_LENGTH)
        flk_mistake(p->mistakes, use->place,
                    "the force needs 'at', the point of the link where it acts");
    if (IS_SET(at) && !IS_SET(force) && !use->is_mistaken)
        flk_mistake(p->mistakes, at->place, "'at' needs a force");
    own->values.force.x = force->si[0];
    own->values.force.y = force->si[1];
    build_curves(p, force, 2, over_of(use), own->values.force_curve);
}

/* Refuse an argument that the mechanism does not have. */
static void check_over(parser *p, const setting *over)
{
    static const int kinds[] = {
        ANY_KIND, FOURLINK_FOUR_BAR | INVERTED, FOURLINK_SLIDER_CRANK, INVERTED,
        ANY_KIND, FOURLINK_FOUR_BAR | INVERTED, FOURLINK_SLIDER_CRANK, INVERTED};
    int kind = (int)p->d->design.kind;

    if (IS_SET(over) && !(kinds[over->word] & kind))
        flk_mistake(p->mistakes, over->place, "%s %s has no %t",
                    flk_text_article(fourlink_kind_text(kind)), fourlink_kind_text(kind),
                    over->value);
}

/* Build the values on the way back: a curve or a constant, like torque or force. */
static void build_back(parser *p, const section_use *use, flk_own_load *own)
{
    const setting *back = flk_setting_of(use, KEY_LOAD_BACK);

    if (!IS_SET(back))
        return;
    own->has_back = 1;
    if (FLK_IS_SPEED(own->over))
        flk_mistake(p->mistakes, back->place,
                    "'back' is for loads over a position, not over a speed");
    if (IS_SET(flk_setting_of(use, KEY_LOAD_FORCE)) && IS_SET(flk_setting_of(use, KEY_LOAD_TORQUE)))
        flk_mistake(p->mistakes, back->place,
                    "'back' of a force or of a torque? give them in two loads");
    if (IS_SET(flk_setting_of(use, KEY_LOAD_FORCE))) {
        own->back.force.x = back->si[0];
        own->back.force.y = back->si[1];
        build_curves(p, back, 2, over_of(use), own->back.force_curve);
    } else {
        own->back.torque = back->si[0];
        build_curves(p, back, 1, over_of(use), &own->back.torque_curve);
    }
}

/* Build a value that follows a speed, which needs the speed at which it is reached. */
static void build_power_law(parser *p, const section_use *use, int is_clear, int has_curve,
                            flk_own_load *own)
{
    const setting *over = flk_setting_of(use, KEY_LOAD_OVER),
                  *exponent = flk_setting_of(use, KEY_LOAD_EXPONENT),
                  *speed = flk_setting_of(use, KEY_LOAD_AT_SPEED);
    const setting *first = IS_SET(speed) ? speed : exponent;

    own->exponent = IS_SET(exponent) ? exponent->si[0] : 1;
    own->at_speed = speed->si[0];
    if (!is_clear)
        return;
    if (IS_SET(first) && !FLK_IS_SPEED(own->over))
        flk_mistake(p->mistakes, first->place, "'%s' needs 'over', the speed that the load follows",
                    IS_SET(speed) ? "at_speed" : "exponent");
    else if (IS_SET(first) && has_curve)
        flk_mistake(p->mistakes, first->place, "'%s' is for a value; this load has a curve",
                    IS_SET(speed) ? "at_speed" : "exponent");
    else if (FLK_IS_SPEED(own->over) && !has_curve && !IS_SET(speed))
        flk_mistake(p->mistakes, over->place,
                    "a load over a speed needs 'at_speed', the speed at which it has its value, or "
                    "a curve");
}

static void build_law(parser *p, const section_use *use, flk_own_load *own)
{
    const setting *over = flk_setting_of(use, KEY_LOAD_OVER),
                  *force = flk_setting_of(use, KEY_LOAD_FORCE),
                  *torque = flk_setting_of(use, KEY_LOAD_TORQUE),
                  *from = flk_setting_of(use, KEY_LOAD_FROM),
                  *to = flk_setting_of(use, KEY_LOAD_TO);
    int has_curve = force->curve || torque->curve;
    int is_clear = !use->is_mistaken && (IS_SET(force) || IS_SET(torque));

    own->over = (flk_variable)over->word;
    check_over(p, over);
    build_back(p, use, own);
    build_power_law(p, use, is_clear, has_curve, own);
    if (!own->over && !own->has_back)
        return;
    if (IS_SET(over) && !FLK_IS_SPEED(own->over) && !has_curve && !own->has_back && is_clear)
        flk_mistake(p->mistakes, over->place,
                    "'over' needs a curve: a force or torque that varies");
    if (IS_SET(from) || IS_SET(to))
        flk_mistake(p->mistakes, (IS_SET(from) ? from : to)->place,
                    "'%s' is a crank angle: a load with 'over' or 'back' has none",
                    IS_SET(from) ? "from" : "to");
}

static void build_load(parser *p, const section_use *use, flk_own_load *own)
{
    const setting *link = flk_setting_of(use, KEY_LOAD_LINK),
                  *torque = flk_setting_of(use, KEY_LOAD_TORQUE),
                  *frame = flk_setting_of(use, KEY_LOAD_FRAME);

    own->load.link = flk_build_check_link(p, use, link) ? link->word : 0;
    if (!IS_SET(flk_setting_of(use, KEY_LOAD_FORCE)) && !IS_SET(torque) && !use->is_mistaken)
        flk_mistake(p->mistakes, use->place, "[load] has neither a force nor a torque");
    own->load.frame = (fourlink_frame)frame->word;
    build_force(p, use, own);
    flk_build_place(p, flk_setting_of(use, KEY_LOAD_AT), own->load.link, &own->load.at);
    own->values.torque = torque->si[0];
    build_curves(p, torque, 1, over_of(use), &own->values.torque_curve);
    build_window(p, use, own);
    build_law(p, use, own);
}

void flk_build_loads(parser *p)
{
    const section_use *use = NULL;
    flk_element *element;
    flk_own_load *own;

    while (!p->out_of_memory && (use = flk_section_next(p, SECTION_LOAD, use)) != NULL) {
        own = flk_reader_keep(p, sizeof *own);
        element = flk_build_element(p);
        if (!own || !element)
            return;
        build_load(p, use, own);
        element->name = flk_reader_copy(p, use->name, "");
        flk_element_of_own(own, element);
        p->d->has_forces = 1;
    }
}

/* ------------------------------------------------------------------------------------- ends of curves */

#define PLACES 180    /* of the motion, that are checked */
#define ROUNDING 1e-9 /* of the curve */

/* The smallest and the largest argument of a load over the motion.  If the motion is not given, speeds are
** unknown. */
static void find_range(const deck *d, flk_variable over, double *low, double *high)
{
    double end = d->one_instant ? d->motion.from : d->motion.to;
    fourlink_state state;
    fourlink_row row;
    int i, branch;

    *low = GSL_POSINF;
    *high = GSL_NEGINF;
    for (i = 0; i <= PLACES; i++)
        for (branch = FOURLINK_CROSSED; branch <= FOURLINK_OPEN; branch += 2) {
            double angle = d->motion.from + (end - d->motion.from) * i / PLACES;

            if (!(branch == FOURLINK_OPEN ? d->open : d->crossed) ||
                fourlink_motion_at(&d->motion, angle, &row) != FOURLINK_OK ||
                flk_mechanism_move(&d->machine.mechanism, (fourlink_branch)branch, &row.crank, 0,
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
    size_t n = 0;

    if (p->mistakes->count || p->out_of_memory)
        return;
    for (; (use = flk_section_next(p, SECTION_LOAD, use)) != NULL; n++) {
        const setting *over = flk_setting_of(use, KEY_LOAD_OVER),
                      *back = flk_setting_of(use, KEY_LOAD_BACK);
        const flk_own_load *own = flk_machine_find(&p->d->machine, &flk_own_sort, n)->data;

        if (over->word <= FLK_THETA4 ||
            (p->d->drive.mode != DRIVE_GIVEN && FLK_IS_SPEED(over->word)))
            continue;
        check_ends(p, flk_setting_of(use, KEY_LOAD_FORCE), over, &own->values.force_curve[0]);
        check_ends(p, flk_setting_of(use, KEY_LOAD_TORQUE), over, &own->values.torque_curve);
        check_ends(p, back, over, &own->back.force_curve[0]);
        check_ends(p, back, over, &own->back.torque_curve);
    }
}
