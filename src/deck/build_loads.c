/* SPDX-License-Identifier: GPL-3.0-or-later
**
** build_loads.c - builds loads, gas, curves over the crank angle and points from values.
*/
#include <math.h>
#include <string.h>

#include <gsl/gsl_math.h>

#include "mechanics/kind.h"
#include "reader.h"

/* rad; angles closer than this are the same. */
#define LEAST_STEP 1e-9

/* 1 if a point repeats another, in all components. */
static int repeats(const point *c, const point *first)
{
    return gsl_hypot(c->y[0] - first->y[0], c->y[1] - first->y[1]) <=
           1e-9 * gsl_hypot(first->y[0], first->y[1]);
}

/* Check the points of a curve over the crank angle.  Its angles increase, over at most one cycle.  A last
** point at the end of the cycle repeats the first.  The number of points without that one; 0 if they make no
** curve. */
static size_t check_curve(parser *p, const setting *s)
{
    const point *c = s->curve;
    size_t n = s->n_points, i;
    double period = p->d->cycle;

    if (!c || !(period > 0))
        return 0;
    for (i = 1; i < n; i++)
        if (c[i].x - c[i - 1].x < LEAST_STEP) {
            flk_mistake(p->mistakes, c[i].place, "the angles of a curve must increase");
            return 0;
        }
    if (n > 1 && fabs(c[n - 1].x - c[0].x - period) < LEAST_STEP) {
        n--;
        if (!repeats(&c[n], &c[0])) {
            flk_mistake(
                p->mistakes, c[n].place,
                "the curve is not periodic: one cycle after its first point it has another value");
            return 0;
        }
    }
    if (n < 2)
        flk_mistake(p->mistakes, s->place, "a curve needs at least two points");
    else if (c[n - 1].x - c[0].x > period - LEAST_STEP)
        flk_mistake(p->mistakes, c[n - 1].place,
                    "the curve is longer than the cycle; give [motion] a cycle of 720 deg if it is "
                    "one of four strokes");
    else
        return n;
    return 0;
}

/* Build the curves of a setting's components. */
static void build_curves(parser *p, const setting *s, int n_components, curve *results)
{
    size_t n = check_curve(p, s), i;
    double *x = n ? flk_reader_keep(p, 2 * n * sizeof *x) : NULL, *y;
    int k;

    for (k = 0; x && k < n_components; k++) {
        y = x + n;
        for (i = 0; i < n; i++) {
            x[i] = s->curve[i].x;
            y[i] = s->curve[i].y[k];
        }
        if (!flk_curve_make(x, y, n, p->d->cycle, &results[k]))
            p->out_of_memory = 1;
    }
}

void flk_build_gas(parser *p)
{
    const section_use *use = flk_section_find(p, SECTION_GAS, NULL);
    const setting *bore = flk_setting_find(p, KEY_GAS_BORE),
                  *rod = flk_setting_find(p, KEY_GAS_PISTON_ROD);
    const setting *pressure = flk_setting_find(p, KEY_GAS_PRESSURE),
                  *card = flk_setting_find(p, KEY_GAS_INDICATOR);
    deck_gas *gas = &p->d->gas;
    double d_rod = rod->si[0];

    if (!use || !(flk_section_table[SECTION_GAS].kinds & (int)p->d->design.kind))
        return;
    p->d->has_forces = 1;
    if (!IS_SET(bore)) {
        if (!use->has_unknown)
            flk_mistake(p->mistakes, use->place, "[gas] has no bore");
        return;
    }
    if (!use->has_unknown && !IS_SET(pressure) && !IS_SET(card) &&
        !IS_SET(flk_setting_find(p, KEY_GAS_BACK_PRESSURE)))
        flk_mistake(p->mistakes, use->place, "[gas] has neither a pressure nor an indicator");
    if (IS_SET(pressure) && IS_SET(card))
        flk_mistake(p->mistakes, pressure->place,
                    "give either the pressure or the indicator, not both");
    if (d_rod >= bore->si[0] && bore->si[0] > 0)
        flk_mistake(p->mistakes, rod->place, "the piston_rod, %t, is not thinner than the bore",
                    rod->value);
    gas->area = M_PI / 4 * bore->si[0] * bore->si[0];
    gas->back_area = gas->area - M_PI / 4 * d_rod * d_rod;
    gas->pressure = pressure->si[0];
    gas->back_pressure = flk_setting_or(p, KEY_GAS_BACK_PRESSURE, 0);
    build_curves(p, card, 1, &gas->indicator);
}

void flk_build_check_link(parser *p, const section_use *use, const setting *link)
{
    const flk_kind *kind = flk_kind_of(p->d->design.kind);
    const char *const *own = kind->link;

    if (!IS_SET(link) && !use->has_unknown)
        flk_mistake(p->mistakes, use->place, "[%s] has no link: %s, %s or %s",
                    flk_section_table[use->section].name, own[2], own[3], own[4]);
    else if (link->word && !flk_text_equal(link->value, own[link->word]))
        flk_mistake(p->mistakes, link->place, "%s %s has no %t: its links are %s, %s and %s",
                    flk_text_article(kind->words), kind->words, link->value, own[2], own[3],
                    own[4]);
}

/* Build the range of crank angles in which a load acts. */
static void build_window(parser *p, const section_use *use, deck_load *variation)
{
    const setting *from = flk_setting_of(use, KEY_LOAD_FROM),
                  *to = flk_setting_of(use, KEY_LOAD_TO);

    if (!IS_SET(from) && !IS_SET(to))
        return;
    variation->is_windowed = 1;
    variation->from = from->si[0]; /* 0 if not given */
    variation->to = IS_SET(to) ? to->si[0] : p->d->cycle;
    if (variation->to <= variation->from)
        flk_mistake(p->mistakes, (IS_SET(from) ? from : to)->place,
                    "the load's 'from' must be less than its 'to', not  %t and %t",
                    IS_SET(from) ? from->value : flk_text_of("0"),
                    IS_SET(to) ? to->value : flk_text_of("the end of the cycle"));
    else if (variation->to - variation->from > p->d->cycle * (1 + 1e-12))
        flk_mistake(p->mistakes, (IS_SET(to) ? to : from)->place,
                    "the load acts for more than a cycle");
}

/* max(NAME.vx) must fit wherever names are kept. */
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

    flk_build_check_link(p, use, link);
    flk_build_check_name(p, use, "NAME.x, NAME.y ...");
    new->link = link->word;
    flk_build_place(p, at, link->word, &new->at);
    new->name = flk_reader_copy(p, use->name, "");
    for (i = 0; i < DECK_POINT_COLUMNS; i++)
        new->column_names[i] = flk_reader_copy(p, use->name, endings[i]);
}

void *flk_build_keep_each(parser *p, section_code section, size_t size)
{
    size_t i, n = 0;

    for (i = 0; i < p->n_uses; i++)
        n += p->uses[i].section == section;
    return flk_reader_keep(p, n * size);
}

void flk_build_points(parser *p)
{
    size_t i;

    p->d->points = flk_build_keep_each(p, SECTION_POINT, sizeof *p->d->points);
    for (i = 0; i < p->n_uses && !p->out_of_memory; i++)
        if (p->uses[i].section == SECTION_POINT)
            build_point(p, &p->uses[i], &p->d->points[p->d->n_points++]);
}

/* 1 if a link slides along the line of stroke: forces on it need neither a point nor a direction. */
static int is_piston(const parser *p, int link)
{
    return fourlink_slides((int)p->d->design.kind, link) == FOURLINK_GROUND;
}

/* Build the force of a load, and check its point. */
static void build_force(parser *p, const section_use *use, fourlink_load *load,
                        deck_load *variation)
{
    const setting *force = flk_setting_of(use, KEY_LOAD_FORCE),
                  *at = flk_setting_of(use, KEY_LOAD_AT);

    if (force->is_bare && load->link && !is_piston(p, load->link))
        flk_mistake(p->mistakes, force->place,
                    "expected a force with its direction, such as 50 N at 30 deg or (43, 25) N, "
                    "not '%t'",
                    force->value);
    else if ((force->si[0] != 0 || force->si[1] != 0 || force->curve) && !IS_SET(at) &&
             load->link && !use->has_unknown &&
             flk_kind_of(p->d->design.kind)->has_length[load->link] != FLK_NO_LENGTH)
        flk_mistake(p->mistakes, use->place,
                    "the force needs 'at', the point of the link where it acts");
    if (IS_SET(at) && !IS_SET(force) && !use->has_unknown)
        flk_mistake(p->mistakes, at->place, "'at' needs a force");
    load->force.x = force->si[0];
    load->force.y = force->si[1];
    build_curves(p, force, 2, variation->force);
}

/* A load over a speed: value sign(w) (|w| / at_speed)^exponent. */
static void build_power_law(parser *p, const section_use *use, const deck_load *variation,
                            deck_power_law *law)
{
    const setting *over = flk_setting_of(use, KEY_LOAD_OVER),
                  *exponent = flk_setting_of(use, KEY_LOAD_EXPONENT),
                  *speed = flk_setting_of(use, KEY_LOAD_AT_SPEED);
    int slides = over->word == OVER_V || over->word == OVER_SLIDE_V;
    int kind = (int)p->d->design.kind;

    law->over = over->word;
    law->exponent = IS_SET(exponent) ? exponent->si[0] : 1;
    law->at_speed = speed->si[0];
    if (!IS_SET(over)) {
        if (IS_SET(exponent) || IS_SET(speed))
            flk_mistake(p->mistakes, (IS_SET(exponent) ? exponent : speed)->place,
                        "'%s' needs 'over', the speed that the load follows",
                        IS_SET(exponent) ? "exponent" : "at_speed");
        return;
    }
    p->d->has_power_law = 1;
    if ((over->word == OVER_V && kind != FOURLINK_SLIDER_CRANK) ||
        (over->word == OVER_SLIDE_V && kind != FOURLINK_INVERTED_SLIDER_CRANK) ||
        (over->word == OVER_OMEGA4 && kind == FOURLINK_SLIDER_CRANK))
        flk_mistake(p->mistakes, over->place, "%s %s has no %t",
                    flk_text_article(fourlink_kind_text(kind)), fourlink_kind_text(kind),
                    over->value);
    if (variation->torque.n || variation->force[0].n)
        flk_mistake(p->mistakes, over->place,
                    "a load over a speed has a value, not a curve over the crank angle");
    if (!IS_SET(speed) && !use->has_unknown)
        flk_mistake(p->mistakes, over->place,
                    "a load over a speed needs 'at_speed', the speed at which it has its value, "
                    "such as %s",
                    slides ? "2 m/s" : "1000 rpm");
}

static void build_load(parser *p, const section_use *use, fourlink_load *load, deck_load *variation)
{
    const setting *link = flk_setting_of(use, KEY_LOAD_LINK),
                  *torque = flk_setting_of(use, KEY_LOAD_TORQUE),
                  *frame = flk_setting_of(use, KEY_LOAD_FRAME);

    flk_build_check_link(p, use, link);
    if (!IS_SET(flk_setting_of(use, KEY_LOAD_FORCE)) && !IS_SET(torque) && !use->has_unknown)
        flk_mistake(p->mistakes, use->place, "[load] has neither a force nor a torque");
    load->link = link->word;
    load->frame = (fourlink_frame)frame->word;
    build_force(p, use, load, variation);
    flk_build_place(p, flk_setting_of(use, KEY_LOAD_AT), link->word, &load->at);
    load->torque = torque->si[0];
    variation->name = flk_reader_copy(p, use->name, "");
    build_curves(p, torque, 1, &variation->torque);
    build_window(p, use, variation);
    build_power_law(p, use, variation, &variation->law);
}

void flk_build_loads(parser *p)
{
    deck *d = p->d;
    size_t i;

    d->loads = flk_build_keep_each(p, SECTION_LOAD, sizeof *d->loads);
    d->variations = flk_build_keep_each(p, SECTION_LOAD, sizeof *d->variations);
    for (i = 0; i < p->n_uses && !p->out_of_memory; i++)
        if (p->uses[i].section == SECTION_LOAD) {
            build_load(p, &p->uses[i], &d->loads[d->n_loads], &d->variations[d->n_loads]);
            d->n_loads++;
            d->has_forces = 1;
        }
}
