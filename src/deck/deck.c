/* SPDX-License-Identifier: GPL-3.0-or-later
**
** deck.c - the input deck: text in, a problem to solve out, or its mistakes.
**
** In three passes: the lines give settings, each a text and its place (lines.c); the texts
** give values, by the forms of schema.h and in the deck's units (values.c); the values give the
** problem, here.  A mistake does not end the reading, so that one run tells all of them.
*/
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include <gsl/gsl_math.h>

#include "base/number.h"
#include "reader.h"

#define STANDARD_GRAVITY 9.81 /* m/s2, as the sources have it */

/* A value in SI units, or what it is when the deck does not set it. */
static double value_or(parser *p, key_code key, double otherwise)
{
    const setting *s = flk_find(p, key);

    return s ? s->si[0] : otherwise;
}

double flk_in_deck_unit(parser *p, const setting *s, quantity q)
{
    const unit *u = &p->d->units[q].unit;

    if (s->unit.up == u->up && s->unit.down == u->down)
        return s->number;
    return flk_unit_from_si(s->si[0], *u);
}

static double angle_or(parser *p, key_code key, double otherwise)
{
    const setting *s = flk_find(p, key);

    return s ? flk_in_deck_unit(p, s, QUANTITY_ANGLE) : otherwise;
}

static text_place end_of_deck(parser *p)
{
    text_place place;

    place.source = p->name;
    place.line = p->last_line;
    return place;
}

/* The length a mechanism cannot do without. */
static void require(parser *p, key_code key)
{
    const key_info *k = &flk_key_table[key];
    const section_use *use = flk_find_use(p, k->section);

    if (flk_find(p, key))
        return;
    if (use)
        flk_mistake_note(&p->d->mistakes, use->place, "[", flk_section_table[k->section].name,
                         "] has no ", k->name,
                         key == KEY_CRANK_LENGTH && p->d->design.kind == FOURLINK_SLIDER_CRANK
                             ? ", and no stroke"
                             : "",
                         (char *)NULL);
    else
        flk_mistake_note(&p->d->mistakes, end_of_deck(p), "there is no [",
                         flk_section_table[k->section].name, "] with a ", k->name, " in it",
                         (char *)NULL);
}

/* The moment of inertia from the time of small swings about a pin at distance h from the centre of mass
** (ME3491, example 2): L = g (T / 2 pi)^2 is the length of the equivalent simple pendulum, and
**
**    k^2 = h (L - h)
*/
static void build_swing(parser *p, const setting *period, const setting *pin, fourlink_link *link)
{
    double g = value_or(p, KEY_GRAVITY_ACCELERATION, STANDARD_GRAVITY),
           turns = period->si[0] / (2 * M_PI);
    double x = 0, y = 0, h, L;
    char number[NUMBER_SIZE], word[WORD_SIZE];

    if (!pin) {
        flk_mistake_note(&p->d->mistakes, period->place,
                         "a swing_period needs a swing_pin: origin, end or a point of the link",
                         (char *)NULL);
        return;
    }
    if (pin->word == PIN_END)
        x = link->length;
    if (pin->word == PIN_POINT) {
        x = pin->si[0];
        y = pin->si[1];
    }
    if (g <= 0)
        g = STANDARD_GRAVITY; /* switched off in the machine, not in the test */
    h = gsl_hypot(x - link->cg.x, y - link->cg.y);
    L = g * turns * turns;
    if (h == 0)
        flk_mistake_note(&p->d->mistakes, pin->place,
                         "the swing_pin is at the centre of mass, where nothing swings",
                         (char *)NULL);
    else if (L < h)
        flk_mistake_note(
            &p->d->mistakes, period->place, "a swing_period of ", flk_word_of(period->value, word),
            " is too short: even all mass in one point, ", flk_number_write(h, 4, number),
            " m from the pin, swings more slowly", (char *)NULL);
    else
        link->inertia = link->mass * h * (L - h);
}

static void build_link(parser *p, key_code length, int number)
{
    fourlink_link *link = &p->d->design.link[number];
    key_code mass = length + 1, gyration = length + 2, inertia = length + 3, cg = length + 4,
             swing_period = length + 5, swing_pin = length + 6;
    const setting *period = flk_find(p, swing_period), *s;

    if (length != KEY_CRANK_LENGTH || !flk_find(p, KEY_CRANK_STROKE)) {
        require(p, length);
        link->length = value_or(p, length, 0);
    }
    link->mass = value_or(p, mass, 0);
    link->inertia = value_or(p, inertia, 0);
    if ((s = flk_find(p, cg)) != NULL) {
        link->cg.x = s->si[0];
        link->cg.y = s->si[1];
    }
    s = flk_find(p, gyration);
    if ((s != NULL) + (flk_find(p, inertia) != NULL) + (period != NULL) > 1)
        flk_mistake_note(&p->d->mistakes, s ? s->place : period->place,
                         "give one of gyration, inertia and swing_period, not several",
                         (char *)NULL);
    if ((s || period) && !flk_find(p, mass))
        flk_mistake_note(&p->d->mistakes, s ? s->place : period->place, "the ",
                         s ? "radius of gyration" : "swing_period", " needs a mass", (char *)NULL);
    if (s)
        link->inertia = link->mass * s->si[0] * s->si[0]; /* I = m k^2 */
    if (period && period->si[0] > 0)
        build_swing(p, period, flk_find(p, swing_pin), link);
    if ((s || period) && link->inertia > FOURLINK_NUMBER_MAX)
        flk_mistake_note(&p->d->mistakes, s ? s->place : period->place,
                         "the moment of inertia that follows is beyond what the program computes "
                         "with",
                         (char *)NULL);
    if (!period && (s = flk_find(p, swing_pin)) != NULL)
        flk_mistake_note(&p->d->mistakes, s->place, "a swing_pin needs a swing_period",
                         (char *)NULL);
}

/* 1 if quantities have no value because their [sweep] has a mistake: nothing can be said of them. */
static int lacks_values(parser *p)
{
    return flk_find_use(p, SECTION_SWEEP) && !p->d->sweep.n_designs;
}

/* The crank of an engine from its stroke S, the distance between the dead centres, where crank and rod are
** in line (two right triangles with the cathetus e):
**
**    S = sqrt((l + r)^2 - e^2) - sqrt((l - r)^2 - e^2),  r^2 = S^2/4 (4 l^2 - 4 e^2 - S^2) / (4 l^2 - S^2)
**
** which for e = 0 is r = S/2.  The longest stroke is that of r = l - |e|, the longest crank that turns
** fully: S^2 = (l + r)^2 - e^2 = 4 l (l - |e|).  Beyond it the second root would be the first's sum. */
static void build_stroke(parser *p)
{
    fourlink_link *link = p->d->design.link;
    const setting *s = flk_find(p, KEY_CRANK_STROKE);
    double S, l = link[3].length, e = fabs(p->d->design.offset), rest;

    if (!s || l <= 0 || lacks_values(p))
        return;
    if (flk_find(p, KEY_CRANK_LENGTH))
        flk_mistake_note(&p->d->mistakes, s->place,
                         "give either the length or the stroke, not both", (char *)NULL);
    S = s->si[0];
    link[2].length = S / 2;
    rest = 4 * l * l - S * S;
    if (S * S > 4 * l * (l - e))
        flk_mistake_note(&p->d->mistakes, s->place,
                         e > 0 ? "this rod and offset have no such stroke"
                               : "this rod has no such stroke: the crank would be longer",
                         (char *)NULL);
    else if (e > 0)
        link[2].length = S / 2 * sqrt((rest - 4 * e * e) / rest);
}

/* The mechanism's kind, and that each section and key is one that it has. */
static int build_kind(parser *p)
{
    const setting *s = flk_find(p, KEY_TOP_MECHANISM);
    size_t i;
    fourlink_kind kind;
    int k;

    if (!s) {
        text_place place = end_of_deck(p);

        place.line = 1;
        flk_mistake_note(&p->d->mistakes, place, "expected 'mechanism = four-bar' or 'mechanism = ",
                         "slider-crank' before the first section", (char *)NULL);
        return 0;
    }
    if (!s->word)
        return 0;
    kind = (fourlink_kind)s->word;
    p->d->design.kind = kind;
    for (i = 0; i < p->n_uses; i++) {
        const section_use *use = &p->uses[i];
        int first = flk_first_key(use->section), n = flk_key_count(use->section);

        if (!(flk_section_table[use->section].kinds & (int)kind)) {
            flk_mistake_note(&p->d->mistakes, use->place, "a ", flk_kind_words(kind), " has no [",
                             flk_section_table[use->section].name, "]",
                             use->section == SECTION_COUPLER ? "; its link 3 is the [rod]"
                             : use->section == SECTION_ROD   ? "; its link 3 is the [coupler]"
                                                             : "",
                             (char *)NULL);
            continue;
        }
        for (k = first; k < first + n; k++) {
            s = flk_setting_of(p, use, (key_code)k);
            if (s->place.source && !(flk_key_table[k].kinds & (int)kind))
                flk_mistake_note(
                    &p->d->mistakes, s->place, use->section == SECTION_TOP ? "" : "the ",
                    flk_section_table[use->section].name,
                    use->section == SECTION_TOP ? "a " : " of a ", flk_kind_words(kind), " has no ",
                    flk_key_table[k].name, (char *)NULL);
        }
    }
    return 1;
}

/* A length in the unit in which another is written. */
static const char *in_unit_of(parser *p, const setting *s, double length, char out[NUMBER_SIZE])
{
    text t = s->value;
    double number;
    char name[WORD_SIZE];

    flk_number_write(flk_unit_from_si(length, s->unit), 6, out);
    flk_number_read(&t, &number);
    t = flk_text_trim(t);
    strcat(out, " ");
    strcat(out, t.length ? flk_word_of(t, name) : p->d->units[QUANTITY_LENGTH].name);
    return out;
}

/* 1 if a mistake about a key of the section has been noted: no other is to follow from it. */
static int is_mistaken(parser *p, section_code section)
{
    const section_use *use = flk_find_use(p, section);
    int first = flk_first_key(section), n = flk_key_count(section), k;
    size_t i;

    for (k = first; use && k < first + n; k++) {
        text_place place = flk_setting_of(p, use, (key_code)k)->place;

        for (i = 0; place.source && i < p->d->mistakes.count; i++)
            if (p->d->mistakes.list[i].place.source == place.source &&
                p->d->mistakes.list[i].place.line == place.line)
                return 1;
    }
    return 0;
}

/* The links reach at some angle if no link is longer than the other three together; of a
** slider-crank, if crank and rod together reach the line of stroke. */
static void check_reach(parser *p)
{
    static const key_code keys[4] = {KEY_GROUND_LENGTH, KEY_CRANK_LENGTH, KEY_COUPLER_LENGTH,
                                     KEY_ROCKER_LENGTH};
    const fourlink_design *design = &p->d->design;
    char rest[NUMBER_SIZE], word[WORD_SIZE];
    int i, longest = 0;
    double sum = 0;

    for (i = FOURLINK_GROUND; i <= FOURLINK_FOLLOWER; i++)
        if (!(design->link[i].length > 0) &&
            (design->kind == FOURLINK_FOUR_BAR || i == FOURLINK_CRANK || i == FOURLINK_COUPLER))
            return; /* told already */
    if (design->kind == FOURLINK_SLIDER_CRANK) {
        const setting *s = flk_find(p, KEY_GROUND_OFFSET);

        sum = design->link[2].length + design->link[3].length;
        if (s && fabs(design->offset) > sum)
            flk_mistake_note(&p->d->mistakes, s->place, "the offset, ", flk_value_of(s, word),
                             ", is more than crank and rod together, ", in_unit_of(p, s, sum, rest),
                             ": the rod never reaches", (char *)NULL);
        return;
    }
    for (i = 0; i < 4; i++) {
        sum += design->link[i + 1].length;
        if (design->link[i + 1].length > design->link[longest + 1].length)
            longest = i;
    }
    sum -= design->link[longest + 1].length;
    if (design->link[longest + 1].length > sum * (1 + 1e-14)) {
        const setting *s = flk_find(p, keys[longest]);

        flk_mistake_note(&p->d->mistakes, s->place, "the ",
                         flk_section_table[flk_key_table[keys[longest]].section].name, ", ",
                         flk_value_of(s, word), ", is longer than the other three together, ",
                         in_unit_of(p, s, sum, rest), ": they cannot be assembled", (char *)NULL);
    }
}

static void build_mechanism(parser *p)
{
    fourlink_design *design = &p->d->design;
    double direction, g;
    int i;

    if (design->kind == FOURLINK_FOUR_BAR) {
        require(p, KEY_GROUND_LENGTH);
        design->link[FOURLINK_GROUND].length = value_or(p, KEY_GROUND_LENGTH, 0);
        build_link(p, KEY_CRANK_LENGTH, FOURLINK_CRANK);
        build_link(p, KEY_COUPLER_LENGTH, FOURLINK_COUPLER);
        build_link(p, KEY_ROCKER_LENGTH, FOURLINK_FOLLOWER);
    } else {
        design->offset = value_or(p, KEY_GROUND_OFFSET, 0);
        build_link(p, KEY_ROD_LENGTH, FOURLINK_COUPLER);
        build_stroke(p);
        build_link(p, KEY_CRANK_LENGTH, FOURLINK_CRANK);
        design->link[FOURLINK_FOLLOWER].mass = value_or(p, KEY_PISTON_MASS, 0);
    }
    g = value_or(p, KEY_GRAVITY_ACCELERATION, STANDARD_GRAVITY);
    direction = value_or(p, KEY_GRAVITY_DIRECTION, -M_PI_2) - value_or(p, KEY_GROUND_ANGLE, 0);
    flk_direction_of(direction, &design->gravity.x, &design->gravity.y);
    design->gravity.x *= g;
    design->gravity.y *= g;
    for (i = FOURLINK_CRANK; i <= FOURLINK_FOLLOWER; i++)
        if (design->link[i].mass > 0 || design->link[i].inertia > 0)
            p->d->has_forces = 1;
    if (!lacks_values(p))
        check_reach(p);
    if (p->d->mistakes.count)
        return;
    i = fourlink_prepare(design, &p->d->mechanism);
    if (i != FOURLINK_OK)
        flk_mistake_note(&p->d->mistakes, flk_find_use(p, SECTION_CRANK)->place,
                         fourlink_status_text(i), (char *)NULL);
}

/* Angles that are closer, in rad, are the same. */
#define LEAST_STEP 1e-9

/* A curve over the crank angle: its angles rise, and it is no longer than a cycle.  A last point that
** closes the cycle is the first again. */
static void build_curve(parser *p, const setting *s, curve *result)
{
    const point *c = s->curve;
    size_t n = s->n_points, i;
    double period = p->d->cycle, *x, *y;

    if (!c || !(period > 0))
        return;
    for (i = 1; i < n; i++)
        if (c[i].x - c[i - 1].x < LEAST_STEP) {
            flk_mistake_note(&p->d->mistakes, c[i].place, "the angles of a curve must rise",
                             (char *)NULL);
            return;
        }
    if (n > 1 && fabs(c[n - 1].x - c[0].x - period) < LEAST_STEP) {
        n--;
        if (fabs(c[n].y - c[0].y) > 1e-9 * fabs(c[0].y)) {
            flk_mistake_note(&p->d->mistakes, c[n].place,
                             "the curve does not close: its last point is the first, one cycle on",
                             (char *)NULL);
            return;
        }
    }
    if (n < 2) {
        flk_mistake_note(&p->d->mistakes, s->place, "a curve needs at least two points",
                         (char *)NULL);
        return;
    }
    if (c[n - 1].x - c[0].x > period - LEAST_STEP) {
        flk_mistake_note(
            &p->d->mistakes, c[n - 1].place,
            "the curve is longer than the cycle; give [motion] a cycle of 720 deg if it is "
            "one of four strokes",
            (char *)NULL);
        return;
    }
    x = flk_keep(p, 2 * n * sizeof *x);
    if (!x)
        return;
    y = x + n;
    for (i = 0; i < n; i++) {
        x[i] = c[i].x;
        y[i] = c[i].y;
    }
    if (!flk_curve_make(x, y, n, period, result))
        p->out_of_memory = 1;
}

static void build_gas(parser *p)
{
    const section_use *use = flk_find_use(p, SECTION_GAS);
    const setting *bore = flk_find(p, KEY_GAS_BORE), *rod = flk_find(p, KEY_GAS_PISTON_ROD);
    const setting *pressure = flk_find(p, KEY_GAS_PRESSURE), *card = flk_find(p, KEY_GAS_INDICATOR);
    deck_gas *gas = &p->d->gas;
    double d_rod = rod ? rod->si[0] : 0;
    char word[WORD_SIZE];

    if (!use || p->d->design.kind != FOURLINK_SLIDER_CRANK)
        return;
    p->d->has_forces = 1;
    if (!bore) {
        flk_mistake_note(&p->d->mistakes, use->place, "[gas] has no bore", (char *)NULL);
        return;
    }
    if (!pressure && !card && !flk_find(p, KEY_GAS_BACK_PRESSURE))
        flk_mistake_note(&p->d->mistakes, use->place,
                         "[gas] has neither a pressure nor an indicator", (char *)NULL);
    if (pressure && card)
        flk_mistake_note(&p->d->mistakes, pressure->place,
                         "give either the pressure or the indicator, not both", (char *)NULL);
    if (d_rod >= bore->si[0] && bore->si[0] > 0)
        flk_mistake_note(&p->d->mistakes, rod->place, "the piston_rod, ",
                         flk_word_of(rod->value, word), ", is not thinner than the bore",
                         (char *)NULL);
    gas->area = M_PI / 4 * bore->si[0] * bore->si[0];
    gas->back_area = gas->area - M_PI / 4 * d_rod * d_rod;
    gas->pressure = value_or(p, KEY_GAS_PRESSURE, 0);
    gas->back_pressure = value_or(p, KEY_GAS_BACK_PRESSURE, 0);
    if (card)
        build_curve(p, card, &gas->indicator);
}

/* The engine method's approximations, which the sources have for engines of their kind alone. */
static void build_series(parser *p)
{
    const setting *s = flk_find(p, KEY_TOP_SERIES);

    if (!s)
        return;
    p->d->approximation = (fourlink_approximation)s->word;
    if (p->d->approximation != FOURLINK_EXACT && p->d->design.offset != 0)
        flk_mistake_note(&p->d->mistakes, s->place, fourlink_status_text(FOURLINK_NO_SERIES),
                         (char *)NULL);
}

static void build_flywheel(parser *p)
{
    const setting *s = flk_find(p, KEY_FLYWHEEL_INERTIA);

    p->d->flywheel_fluctuation = value_or(p, KEY_FLYWHEEL_FLUCTUATION, 0);
    p->d->flywheel_inertia = value_or(p, KEY_FLYWHEEL_INERTIA, 0);
    if (s && flk_find(p, KEY_FLYWHEEL_FLUCTUATION))
        flk_mistake_note(&p->d->mistakes, s->place,
                         "give either the fluctuation or the inertia: the other follows",
                         (char *)NULL);
}

/* The link that a load or a point is on. */
static void check_link(parser *p, const section_use *use, const setting *link)
{
    int four_bar = p->d->design.kind == FOURLINK_FOUR_BAR;
    char word[WORD_SIZE];

    if (!link->place.source)
        flk_mistake_note(
            &p->d->mistakes, use->place, "[", flk_section_table[use->section].name,
            "] has no link: ", four_bar ? "crank, coupler or rocker" : "crank, rod or piston",
            (char *)NULL);
    else if (four_bar
                 ? flk_text_equal(link->value, "rod") || flk_text_equal(link->value, "piston")
                 : flk_text_equal(link->value, "coupler") || flk_text_equal(link->value, "rocker"))
        flk_mistake_note(&p->d->mistakes, link->place, "a ", flk_kind_words(p->d->design.kind),
                         " has no ", flk_word_of(link->value, word), ": its links are ",
                         four_bar ? "crank, coupler and rocker" : "crank, rod and piston",
                         (char *)NULL);
}

static char *joined(parser *p, text name, const char *ending)
{
    char *result = flk_keep(p, name.length + strlen(ending) + 1);

    if (result) {
        memcpy(result, name.start, name.length);
        strcpy(result + name.length, ending);
    }
    return result;
}

/* The crank angles between which a load acts. */
static void build_window(parser *p, const section_use *use, deck_load *variation)
{
    const setting *from = flk_setting_of(p, use, KEY_LOAD_FROM),
                  *to = flk_setting_of(p, use, KEY_LOAD_TO);
    char a[WORD_SIZE], b[WORD_SIZE];

    if (!from->place.source && !to->place.source)
        return;
    variation->is_windowed = 1;
    variation->from = from->si[0]; /* 0 if it is not given */
    variation->to = to->place.source ? to->si[0] : p->d->cycle;
    if (variation->to <= variation->from)
        flk_mistake_note(&p->d->mistakes, (from->place.source ? from : to)->place,
                         "the load's 'from' must be before its 'to', not ",
                         from->place.source ? flk_word_of(from->value, a) : "0", " and ",
                         to->place.source ? flk_word_of(to->value, b) : "the end of the cycle",
                         (char *)NULL);
    else if (variation->to - variation->from > p->d->cycle * (1 + 1e-12))
        flk_mistake_note(&p->d->mistakes, (to->place.source ? to : from)->place,
                         "the load acts for longer than a cycle", (char *)NULL);
}

/* So that max(NAME.vx) fits wherever names are kept. */
#define LONGEST_NAME 32

/* [point NAME] */
static void build_point(parser *p, const section_use *use, deck_point *new)
{
    static const char *const endings[DECK_POINT_COLUMNS] = {".x",  ".y",  ".vx", ".vy",
                                                            ".ax", ".ay", ".v",  ".a"};
    const setting *link = flk_setting_of(p, use, KEY_POINT_LINK),
                  *at = flk_setting_of(p, use, KEY_POINT_AT);
    size_t i;

    check_link(p, use, link);
    if (!use->name.length)
        flk_mistake_note(&p->d->mistakes, use->place, "a point needs a name: [point P]",
                         (char *)NULL);
    if (use->name.length > LONGEST_NAME)
        flk_mistake_note(&p->d->mistakes, use->place, "the name of a point is too long",
                         (char *)NULL);
    for (i = 0; i < use->name.length; i++)
        if (!flk_text_is_word(use->name.start[i])) {
            flk_mistake_note(&p->d->mistakes, use->place,
                             "the name of a point is one word: its columns are NAME.x, NAME.y ...",
                             (char *)NULL);
            break;
        }
    new->link = link->word;
    new->at.x = at->si[0];
    new->at.y = at->si[1];
    new->name = joined(p, use->name, "");
    for (i = 0; i < DECK_POINT_COLUMNS; i++)
        new->column_names[i] = joined(p, use->name, endings[i]);
}

static void build_points(parser *p)
{
    size_t i, n = 0;

    for (i = 0; i < p->n_uses; i++)
        n += p->uses[i].section == SECTION_POINT;
    if (!n)
        return;
    p->d->points = calloc(n, sizeof *p->d->points);
    if (!p->d->points) {
        p->out_of_memory = 1;
        return;
    }
    for (i = 0; i < p->n_uses; i++)
        if (p->uses[i].section == SECTION_POINT)
            build_point(p, &p->uses[i], &p->d->points[p->d->n_points++]);
}

static void build_load(parser *p, const section_use *use, fourlink_load *load, deck_load *variation)
{
    const setting *link = flk_setting_of(p, use, KEY_LOAD_LINK);
    const setting *force = flk_setting_of(p, use, KEY_LOAD_FORCE),
                  *at = flk_setting_of(p, use, KEY_LOAD_AT);
    const setting *torque = flk_setting_of(p, use, KEY_LOAD_TORQUE);
    const setting *frame = flk_setting_of(p, use, KEY_LOAD_FRAME);

    check_link(p, use, link);
    if (!force->place.source && !torque->place.source)
        flk_mistake_note(&p->d->mistakes, use->place, "[load] has neither a force nor a torque",
                         (char *)NULL);
    if ((force->si[0] != 0 || force->si[1] != 0) && !at->place.source && link->word &&
        !(link->word == FOURLINK_FOLLOWER && p->d->design.kind == FOURLINK_SLIDER_CRANK))
        flk_mistake_note(&p->d->mistakes, use->place,
                         "the force needs 'at', the point of the link where it acts", (char *)NULL);
    if (at->place.source && !force->place.source)
        flk_mistake_note(&p->d->mistakes, at->place, "'at' is for a force", (char *)NULL);
    load->link = link->word;
    load->frame = (fourlink_frame)frame->word;
    load->force.x = force->si[0];
    load->force.y = force->si[1];
    load->at.x = at->si[0];
    load->at.y = at->si[1];
    load->torque = torque->si[0];
    variation->name = joined(p, use->name, "");
    build_curve(p, torque, &variation->torque);
    build_window(p, use, variation);
}

static void build_loads(parser *p)
{
    size_t i, n = 0;

    for (i = 0; i < p->n_uses; i++)
        n += p->uses[i].section == SECTION_LOAD;
    if (!n)
        return;
    p->d->loads = calloc(n, sizeof *p->d->loads);
    p->d->variations = calloc(n, sizeof *p->d->variations);
    if (!p->d->loads || !p->d->variations) {
        p->out_of_memory = 1;
        return;
    }
    for (i = 0; i < p->n_uses; i++)
        if (p->uses[i].section == SECTION_LOAD) {
            build_load(p, &p->uses[i], &p->d->loads[p->d->n_loads],
                       &p->d->variations[p->d->n_loads]);
            p->d->n_loads++;
        }
    p->d->has_forces = 1;
}

/* One instant has no range.  But `at` from the command line takes the place of the deck's range. */
static void check_alone(parser *p, const setting *at)
{
    static const key_code others[] = {KEY_MOTION_FROM, KEY_MOTION_TO, KEY_MOTION_RUN_UP};
    size_t i;

    for (i = 0; i < sizeof others / sizeof others[0]; i++) {
        const setting *s = flk_find(p, others[i]);

        if (s && (s->place.line == 0) == (at->place.line == 0))
            flk_mistake_note(&p->d->mistakes, s->place, "'", flk_key_table[others[i]].name,
                             "' has no place beside 'at', one instant", (char *)NULL);
    }
}

/* 360 and not 360.00000000000006 */
static double whole(double x)
{
    double nearest = floor(x + 0.5);

    return fabs(x - nearest) < 1e-12 * x ? nearest : x;
}

/* From rest through an angle, then one revolution (Alvi's program, vela = 0). */
static void build_run_up(parser *p, const setting *run_up)
{
    const setting *s;

    p->d->motion.run_up = angle_or(p, KEY_MOTION_RUN_UP, 0);
    p->d->one_revolution = 1;
    if ((s = flk_find(p, KEY_MOTION_SPEED)) != NULL && s->si[0] != 0)
        flk_mistake_note(&p->d->mistakes, s->place,
                         "a run-up starts from rest: it takes an acceleration and no speed",
                         (char *)NULL);
    if ((s = flk_find(p, KEY_MOTION_TO)) != NULL)
        flk_mistake_note(&p->d->mistakes, s->place,
                         "a run-up ends one revolution after its angle: it takes no 'to'",
                         (char *)NULL);
    if (p->d->motion.hold)
        flk_mistake_note(&p->d->mistakes, run_up->place, "a run-up cannot hold its speed",
                         (char *)NULL);
}

static void build_motion(parser *p)
{
    fourlink_motion *motion = &p->d->motion;
    const unit *u = &p->d->units[QUANTITY_ANGLE].unit;
    const setting *run_up = flk_find(p, KEY_MOTION_RUN_UP), *s;
    double cycle, turning;
    fourlink_range range;
    int status;

    motion->angle_unit = u->up / u->down;
    motion->speed = value_or(p, KEY_MOTION_SPEED, 0);
    motion->acceleration = value_or(p, KEY_MOTION_ACCELERATION, 0);
    s = flk_find(p, KEY_MOTION_HOLD);
    motion->hold = s ? s->word : 0;
    motion->interval = angle_or(p, KEY_MOTION_INTERVAL, whole(flk_unit_from_si(M_PI / 18, *u)));
    if ((s = flk_find(p, KEY_MOTION_AT)) != NULL) {
        check_alone(p, s);
        motion->from = angle_or(p, KEY_MOTION_AT, 0);
        motion->to = motion->from;
        motion->interval = 1; /* any */
        p->d->one_instant = 1;
        return;
    }
    cycle = angle_or(p, KEY_MOTION_CYCLE, whole(flk_unit_from_si(2 * M_PI, *u)));
    turning = motion->speed != 0 ? motion->speed : motion->acceleration;
    motion->from = angle_or(p, KEY_MOTION_FROM, 0);
    motion->to = angle_or(p, KEY_MOTION_TO, motion->from + (turning < 0 ? -cycle : cycle));
    p->d->one_revolution =
        fabs(fabs(motion->to - motion->from) * motion->angle_unit - 2 * M_PI) < 1e-9;
    if (run_up)
        build_run_up(p, run_up);
    if (is_mistaken(p, SECTION_MOTION) || lacks_values(p))
        return;
    status = fourlink_motion_range(motion, &range);
    if (status == FOURLINK_BAD_RANGE) {
        s = flk_find(p, KEY_MOTION_TO);
        flk_mistake_note(
            &p->d->mistakes, s ? s->place : end_of_deck(p),
            "the range runs against the rotation of the accelerated crank; turn it round, "
            "or give 'hold = yes'",
            (char *)NULL);
    } else if (status == FOURLINK_NO_RUN_UP) {
        flk_mistake_note(&p->d->mistakes, run_up->place, "a run-up from rest needs an acceleration",
                         (char *)NULL);
    } else if (status != FOURLINK_OK) {
        s = flk_find(p, KEY_MOTION_INTERVAL);
        flk_mistake_note(&p->d->mistakes, s ? s->place : end_of_deck(p),
                         fourlink_status_text(status), (char *)NULL);
    }
}

static void build_table(parser *p)
{
    const setting *s = flk_find(p, KEY_TABLE_BRANCH);
    int branches = s ? s->word : BRANCH_BOTH;
    char word[WORD_SIZE];

    p->d->open = (branches & BRANCH_OPEN) != 0;
    p->d->crossed = (branches & BRANCH_CROSSED) != 0;
    if ((s = flk_find(p, KEY_TABLE_COLUMNS)) != NULL) {
        p->d->columns.names = s->value;
        p->d->columns.place = s->place;
    }
    s = flk_find(p, KEY_TOP_SOLVER);
    p->d->solver = s ? s->word : 0;
    p->d->digits = 6;
    if ((s = flk_find(p, KEY_TABLE_DIGITS)) != NULL) {
        if (s->si[0] > 17)
            flk_mistake_note(&p->d->mistakes, s->place, "digits must be 1 to 17, not ",
                             flk_word_of(s->value, word), (char *)NULL);
        else
            p->d->digits = (int)s->si[0];
    }
}

/* The printed values of the deck, in the order of its lines, after those it has already. */
static void build_expectations(parser *p)
{
    deck *d = p->d;
    deck_expectation *list;
    size_t i;

    if (!p->n_named)
        return;
    list = realloc(d->expectations, (d->n_expectations + p->n_named) * sizeof *list);
    if (!list) {
        p->out_of_memory = 1;
        return;
    }
    d->expectations = list;
    for (i = 0; i < p->n_named; i++) {
        const named_value *named = &p->named[i];
        const section_use *use = &p->uses[named->use];
        int misprint = use->section == SECTION_MISPRINT;
        const setting *at, *branch, *tolerance;
        deck_expectation *e;

        if (use->section == SECTION_SWEEP)
            continue;
        at = flk_setting_of(p, use, misprint ? KEY_MISPRINT_AT : KEY_EXPECT_AT);
        branch = flk_setting_of(p, use, misprint ? KEY_MISPRINT_BRANCH : KEY_EXPECT_BRANCH);
        tolerance =
            flk_setting_of(p, use, misprint ? KEY_MISPRINT_TOLERANCE : KEY_EXPECT_TOLERANCE);
        e = &list[d->n_expectations++];
        memset(e, 0, sizeof *e);
        e->place = named->s.place;
        e->name = named->name;
        e->value = named->s.value;
        e->tolerance = tolerance->value;
        e->tolerance_place = tolerance->place;
        e->misprint = misprint;
        e->has_at = at->place.source != NULL || d->one_instant;
        e->at = at->place.source ? flk_in_deck_unit(p, at, QUANTITY_ANGLE) : d->motion.from;
        e->branch = branch->word ? (branch->word == BRANCH_OPEN ? FOURLINK_OPEN : FOURLINK_CROSSED)
                    : d->open    ? FOURLINK_OPEN
                                 : FOURLINK_CROSSED;
    }
}

static void build(parser *p)
{
    const setting *title = flk_find(p, KEY_TOP_TITLE);

    if (title)
        flk_text_copy(title->value, p->d->title, sizeof p->d->title);
    if (!build_kind(p))
        return;
    p->d->cycle = value_or(p, KEY_MOTION_CYCLE, 2 * M_PI);
    build_mechanism(p);
    build_gas(p);
    build_loads(p);
    build_points(p);
    build_series(p);
    build_motion(p);
    build_flywheel(p);
    build_table(p);
    build_expectations(p);
    flk_build_sweep(p);
}

static void set_default_units(deck *d)
{
    text bad;
    int q;

    for (q = 0; q < QUANTITY_COUNT; q++) {
        strcpy(d->units[q].name, flk_quantities[q].unit);
        flk_unit_read(flk_text_of(flk_quantities[q].unit), &d->units[q].unit, &bad);
    }
}

/* A piece of memory of the deck's, in front of what it holds. */
typedef struct kept {
    struct kept *next;
    double contents[1]; /* aligned for all that is kept */
} kept;

void *flk_keep(parser *p, size_t size)
{
    kept *k = malloc(sizeof *k + size);

    if (!k) {
        p->out_of_memory = 1;
        return NULL;
    }
    k->next = p->d->storage;
    p->d->storage = k;
    return k->contents;
}

static char *keep_string(parser *p, const char *string)
{
    char *copy = flk_keep(p, strlen(string) + 1);

    return copy ? strcpy(copy, string) : NULL;
}

/* A copy of the text that lasts as long as the deck, read as lines. */
static void read_copy(parser *p, text contents)
{
    char *copy = flk_keep(p, contents.length + 1);

    if (!copy)
        return;
    if (contents.length)
        memcpy(copy, contents.start, contents.length);
    contents.start = copy;
    flk_read_lines(p, contents, copy);
}

static void finish(parser *p)
{
    flk_mistakes_sort(&p->d->mistakes);
    free(p->uses);
    free(p->settings);
    free(p->named);
    free(p->parts);
}

static void start(parser *p, const fourlink_source *source, const char *name, deck *d)
{
    memset(p, 0, sizeof *p);
    p->d = d;
    p->load = source->load;
    p->host = source->host;
    p->name = keep_string(p, name ? name : "");
}

static void read_deck(parser *p, const fourlink_source *source)
{
    unsigned long i;
    text contents;

    contents.start = source->text;
    contents.length = source->length;
    read_copy(p, contents);
    for (i = 0; i < source->n_changes && !p->out_of_memory; i++) {
        const char *origin = keep_string(p, source->changes[i].origin),
                   *assignment = keep_string(p, source->changes[i].assignment);

        if (origin && assignment)
            flk_apply_change(p, origin, flk_text_of(assignment));
    }
    if (!p->out_of_memory)
        flk_read_units(p);
    if (!p->out_of_memory && !p->not_text)
        flk_read_sweep(p, source->design);
    if (!p->out_of_memory)
        flk_read_values(p);
    if (!p->out_of_memory)
        flk_set_parts(p);
    if (!p->out_of_memory && !p->not_text)
        build(p);
}

/* The [expect] and [misprint] sections of another text, in place of the deck's. */
static void read_answers(parser *p, const fourlink_source *source)
{
    text contents;

    contents.start = source->answers;
    contents.length = source->answers_length;
    p->expectations_only = 1;
    p->d->n_expectations = 0;
    read_copy(p, contents);
    if (!p->out_of_memory)
        flk_read_values(p);
    if (!p->out_of_memory)
        build_expectations(p);
}

int flk_deck_read(const fourlink_source *source, deck *d)
{
    parser p;

    memset(d, 0, sizeof *d);
    set_default_units(d);
    start(&p, source, source->name, d);
    if (!p.out_of_memory)
        read_deck(&p, source);
    finish(&p);
    if (source->answers && !p.out_of_memory && !d->mistakes.count) {
        start(&p, source, source->answers_name, d);
        if (!p.out_of_memory)
            read_answers(&p, source);
        finish(&p);
    }
    if (p.out_of_memory || d->mistakes.out_of_memory)
        return -1;
    return d->mistakes.count == 0;
}

/* What one of the last digit of a number is worth: 0.01 for 2.50, 10 for 1.2e2. */
static double last_digit(text t)
{
    double digit = 1, value = 0;
    int decimals = 0, after = 0, exponent = 0;
    size_t i;

    for (i = 0; i < t.length; i++) {
        char c = t.start[i];

        if (c == '.')
            after = 1;
        else if ('0' <= c && c <= '9')
            decimals += after;
        else if ((c == 'e' || c == 'E') && i + 1 < t.length) {
            text rest = t;

            rest.start += i + 1;
            rest.length -= i + 1;
            if (flk_number_read(&rest, &value) == NUMBER_OK)
                exponent = value < -400 ? -400 : value > 400 ? 400 : (int)value;
            break;
        } else if (i > 0 || (c != '+' && c != '-')) {
            break;
        }
    }
    for (exponent -= decimals; exponent < 0; exponent++)
        digit /= 10;
    for (; exponent > 0; exponent--)
        digit *= 10;
    return digit;
}

int flk_deck_read_quantity(deck *d, text_place place, text value, quantity q, double *si,
                           double *digit)
{
    parser p;
    setting s;

    memset(&p, 0, sizeof p);
    memset(&s, 0, sizeof s);
    p.d = d;
    s.place = place;
    s.value = value;
    if (!flk_read_quantity(&p, &s, value, q, si))
        return 0;
    *digit = flk_unit_to_si(last_digit(value), s.unit);
    return 1;
}

void flk_deck_free(deck *d)
{
    kept *k, *next;
    unsigned long i;

    flk_mistakes_free(&d->mistakes);
    for (i = 0; d->variations && i < d->n_loads; i++)
        flk_curve_free(&d->variations[i].torque);
    flk_curve_free(&d->gas.indicator);
    free(d->variations);
    free(d->points);
    free(d->loads);
    free(d->expectations);
    free(d->sweep.variables);
    for (k = d->storage; k; k = next) {
        next = k->next;
        free(k);
    }
    memset(d, 0, sizeof *d);
}
