/* SPDX-License-Identifier: GPL-3.0-or-later
**
** pins.c - [pins]: a mechanism by the places of its pins on a page, in one drawn position.
**
** The page has x to the right and y up.  From the places follow the lengths, the offset, the direction of x
** of link 1 on the page, the crank angle as drawn and the branch.
*/
#include <math.h>
#include <string.h>

#include <gsl/gsl_math.h>

#include "base/cycle.h"
#include "base/quantity.h"
#include "base/trig.h"
#include "mechanics/group.h"
#include "mechanics/kind.h"
#include "mechanics/mechanics.h"
#include "mechanics/mechanism.h"
#include "pins.h"
#include "settings.h"

#define SAME 1e-12   /* of the largest coordinate: two places are one */
#define IN_LINE 1e-7 /* sine of the angle between links that are in line */
#define BESIDE 0.01  /* of the rod's length: C is on its guide */

static fourlink_vector minus(fourlink_vector x, fourlink_vector y)
{
    x.x -= y.x;
    x.y -= y.y;
    return x;
}

static double length_of(fourlink_vector x)
{
    return flk_length(x.x, x.y);
}

static double direction_of(fourlink_vector x)
{
    return flk_angle(x.y, x.x);
}

/* A length for a message. */
static const char *in_words(const parser *p, double length, char out[MESSAGE_SIZE])
{
    const deck_unit *u = &p->d->units[QUANTITY_LENGTH];

    return flk_message(out, MESSAGE_SIZE, "%.6g %s", flk_unit_from_si(length, u->unit), u->name);
}

/* An angle in (-pi, pi]. */
static double reduced(double angle)
{
    double x = flk_cycle_beside(angle, 2 * M_PI);

    return x > -M_PI ? x : M_PI;
}

/* ------------------------------------------------------------------------------------------ the places */

enum { PIN_A, PIN_B, PIN_C, PIN_D, PINS };

/* The places of a drawing; those that are not given are 0. */
typedef struct drawing {
    const setting *pin[PINS], *guide;
    fourlink_vector at[PINS];
    fourlink_vector on_guide[2];
    double size; /* m, of the largest coordinate */
} drawing;

static void take_places(parser *p, drawing *x)
{
    int i;

    memset(x, 0, sizeof *x);
    x->guide = flk_setting_find(p, KEY_PINS_GUIDE);
    for (i = 0; i < 2 && x->guide->curve; i++) {
        x->on_guide[i].x = x->guide->curve[i].y[0];
        x->on_guide[i].y = x->guide->curve[i].y[1];
        x->size = GSL_MAX(x->size, length_of(x->on_guide[i]));
    }
    for (i = 0; i < PINS; i++) {
        x->pin[i] = flk_setting_find(p, (key_code)(KEY_PINS_A + i));
        x->at[i].x = x->pin[i]->si[0];
        x->at[i].y = x->pin[i]->si[1];
        x->size = GSL_MAX(x->size, length_of(x->at[i]));
    }
}

/* 1 if the kind of mechanism needs this pin. */
static int needs_pin(const parser *p, int pin)
{
    fourlink_kind kind = p->d->machine.mechanism.design.kind;

    return pin < PIN_C || (pin == PIN_C && (WITH_PIN_C & (int)kind)) ||
           (pin == PIN_D && (WITH_PIN_D & (int)kind));
}

/* 1 if all places are there that the mechanism needs. */
static int has_places(parser *p, const section_use *use, const drawing *x)
{
    const char *words = fourlink_kind_text((int)p->d->machine.mechanism.design.kind);
    int i, n = 0;

    for (i = 0; i < PINS && !use->is_mistaken; i++)
        if (needs_pin(p, i) && !IS_SET(x->pin[i])) {
            flk_mistake(p->mistakes, use->place, "[pins] of %s %s needs %s, the place of that pin",
                        flk_text_article(words), words, flk_key_table[KEY_PINS_A + i].name);
            n++;
        }
    if (flk_kind_of(p->d->machine.mechanism.design.kind)->has_one_branch && !IS_SET(x->guide) &&
        !use->is_mistaken) {
        flk_mistake(p->mistakes, use->place,
                    "[pins] of %s %s needs guide, two points of the line on which link 4 slides",
                    flk_text_article(words), words);
        n++;
    }
    return !use->is_mistaken && !n;
}

/* 1 if two pins that a link or the ground joins are at two places. */
static int are_apart(parser *p, const drawing *x, int i, int k)
{
    if (!IS_SET(x->pin[i]) || !IS_SET(x->pin[k]) ||
        length_of(minus(x->at[i], x->at[k])) > SAME * x->size)
        return 1;
    return flk_mistake(p->mistakes, x->pin[k]->place, "the pins %s and %s are at the same place",
                       flk_key_table[KEY_PINS_A + i].name, flk_key_table[KEY_PINS_A + k].name);
}

static int check_places(parser *p, const drawing *x)
{
    fourlink_kind kind = p->d->machine.mechanism.design.kind;
    int is_right = are_apart(p, x, PIN_A, PIN_B) & are_apart(p, x, PIN_A, PIN_D);

    if (kind == FOURLINK_INVERTED_SLIDER_CRANK)
        return is_right;
    is_right &= are_apart(p, x, PIN_B, PIN_C) & are_apart(p, x, PIN_C, PIN_D);
    if (x->guide->curve && !(length_of(minus(x->on_guide[1], x->on_guide[0])) > SAME * x->size))
        is_right = flk_mistake(p->mistakes, x->guide->place,
                               "the two points of the guide are the same: it has no direction");
    return is_right;
}

/* ------------------------------------------------------------------------------- what follows from them */

/* Place a link on the page: its origin, and its axis along a vector. */
static void place_link(deck_pins *pins, int link, fourlink_vector origin, fourlink_vector along)
{
    double length = length_of(along);

    pins->origin[link] = origin;
    pins->axis[link].x = along.x / length;
    pins->axis[link].y = along.y / length;
}

/* A direction in the frame with an x axis. */
static fourlink_vector in_frame(fourlink_vector u, fourlink_vector axis)
{
    fourlink_vector v;

    v.x = FLK_DOT(u, axis);
    v.y = FLK_CROSS(axis, u);
    return v;
}

/* A place or a direction of the ground's frame on the page. */
static fourlink_vector on_page(const deck_pins *pins, fourlink_vector u, int is_place)
{
    fourlink_vector axis, v;

    flk_sine_cosine(pins->angle, &axis.y, &axis.x);
    v.x = axis.x * u.x - axis.y * u.y + (is_place ? pins->A.x : 0);
    v.y = axis.y * u.x + axis.x * u.y + (is_place ? pins->A.y : 0);
    return v;
}

/* A place or a direction of the page in the ground's frame. */
static fourlink_vector on_ground(const deck_pins *pins, fourlink_vector u, int is_place)
{
    fourlink_vector axis;

    flk_sine_cosine(pins->angle, &axis.y, &axis.x);
    return in_frame(is_place ? minus(u, pins->A) : u, axis);
}

static void place_assembled(deck_pins *pins, int link, const fourlink_state *state)
{
    place_link(pins, link, on_page(pins, state->link[link].origin, 1),
               on_page(pins, state->link[link].axis, 0));
}

/* Four-bar:
**
**    d = AD, a = AB, b = BC, c = DC;  x of link 1 is from A to D
**
** The side of the coupler on which D lies is the sine of the angle from BC to DC: it has the sign of
** (D - B) x (C - B), and is 0 in a dead position. */
static void find_four_bar(deck_pins *pins, const drawing *x)
{
    fourlink_vector ground = minus(x->at[PIN_D], x->at[PIN_A]),
                    coupler = minus(x->at[PIN_C], x->at[PIN_B]),
                    rocker = minus(x->at[PIN_C], x->at[PIN_D]);

    pins->length[FOURLINK_GROUND] = length_of(ground);
    pins->length[FOURLINK_COUPLER] = length_of(coupler);
    pins->length[FOURLINK_FOLLOWER] = length_of(rocker);
    pins->angle = direction_of(ground);
    pins->side = FLK_CROSS(coupler, rocker) / length_of(coupler) / length_of(rocker);
    place_link(pins, FOURLINK_COUPLER, x->at[PIN_B], coupler);
    place_link(pins, FOURLINK_FOLLOWER, x->at[PIN_D], rocker);
}

static void set_offset(deck_pins *pins, const drawing *x, double offset)
{
    pins->offset = fabs(offset) > SAME * x->size ? offset : 0;
}

/* The line of a slide on the ground: a point of it, and its direction u.  With F the foot of A on it, x runs
** from F to C, along the given direction if C is at F, or if there is no C. */
static void find_line(deck_pins *pins, const drawing *x, double along, const fourlink_vector *C)
{
    fourlink_vector u, from_A = minus(C ? *C : x->on_guide[0], x->at[PIN_A]);
    double reach;

    flk_sine_cosine(along, &u.y, &u.x);
    reach = FLK_DOT(from_A, u);
    pins->angle = C && reach < -SAME * x->size ? reduced(along + M_PI) : along;
    set_offset(pins, x, pins->angle == along ? FLK_CROSS(u, from_A) : -FLK_CROSS(u, from_A));
}

/* Slider-crank: a = AB, l = BC.  The side is the cosine of the angle from x to the rod. */
static int find_slider_crank(parser *p, deck_pins *pins, const drawing *x)
{
    fourlink_vector rod = minus(x->at[PIN_C], x->at[PIN_B]), guide, from_guide, u;
    double along = flk_setting_or(p, KEY_GROUND_ANGLE, 0), beside;
    char far[MESSAGE_SIZE];

    pins->length[FOURLINK_COUPLER] = length_of(rod);
    if (x->guide->curve) {
        guide = minus(x->on_guide[1], x->on_guide[0]);
        from_guide = minus(x->at[PIN_C], x->on_guide[0]);
        beside = fabs(FLK_CROSS(guide, from_guide)) / length_of(guide);
        if (beside > BESIDE * length_of(rod))
            return flk_mistake(p->mistakes, x->guide->place,
                               "C is %s beside this guide: give C, or two points of the line on "
                               "which it moves",
                               in_words(p, beside, far));
        along = direction_of(guide);
    }
    find_line(pins, x, along, &x->at[PIN_C]);
    flk_sine_cosine(pins->angle, &u.y, &u.x);
    pins->side = FLK_DOT(rod, u) / length_of(rod);
    place_link(pins, FOURLINK_COUPLER, x->at[PIN_B], rod);
    place_link(pins, FOURLINK_FOLLOWER, x->at[PIN_C], u);
    return 1;
}

/* Inverted slider-crank: d = AD, a = AB.  With C, the slide has the direction u from C to B, and is at the
** angle gamma from the line D-C, of the length c; B is at s = (B - D) . u from the foot of D.  Without C the
** lever's own keys say where the slide passes D, at the distance h, and the open branch is meant:
**
**    s = sqrt(BD^2 - h^2),   u = (s r - h J r) / BD^2,   r = B - D, J turns a vector left by 90 deg
**
** The side is s / BD. */
static int find_inverted(parser *p, deck_pins *pins, const drawing *x)
{
    const setting *offset = flk_setting_find(p, KEY_LEVER_OFFSET);
    double h = flk_setting_find(p, KEY_LEVER_LENGTH)->si[0] *
                   -flk_sine(flk_setting_find(p, KEY_LEVER_ANGLE)->si[0]) +
               offset->si[0];
    char far[MESSAGE_SIZE], near[MESSAGE_SIZE];
    double s;
    fourlink_vector turn;
    fourlink_vector ground = minus(x->at[PIN_D], x->at[PIN_A]),
                    r = minus(x->at[PIN_B], x->at[PIN_D]), u = minus(x->at[PIN_B], x->at[PIN_C]),
                    lever = minus(x->at[PIN_C], x->at[PIN_D]);

    pins->length[FOURLINK_GROUND] = length_of(ground);
    pins->angle = direction_of(ground);
    if (!IS_SET(x->pin[PIN_C])) {
        pins->branch = FOURLINK_OPEN;
        if (length_of(r) <= SAME * x->size)
            return flk_mistake(p->mistakes, x->pin[PIN_B]->place,
                               "B is at D, so that the slide has no direction: give C, a point of "
                               "the slide");
        if (fabs(h) > length_of(r) * (1 + SAME))
            return flk_mistake(p->mistakes, IS_SET(offset) ? offset->place : x->pin[PIN_B]->place,
                               "the slide passes D at %s, and B is nearer, at %s: the slide cannot "
                               "reach it",
                               in_words(p, fabs(h), far), in_words(p, length_of(r), near));
        s = sqrt(GSL_MAX(FLK_DOT(r, r) - h * h, 0));
        u.x = s * r.x + h * r.y;
        u.y = s * r.y - h * r.x;
        flk_sine_cosine(-flk_setting_find(p, KEY_LEVER_ANGLE)->si[0], &turn.y, &turn.x);
        lever.x = turn.x * u.x - turn.y * u.y;
        lever.y = turn.x * u.y + turn.y * u.x;
        place_link(pins, FOURLINK_COUPLER, x->at[PIN_B], u);
        place_link(pins, FOURLINK_FOLLOWER, x->at[PIN_D], lever);
        return 1;
    }
    if (length_of(u) <= SAME * x->size)
        return flk_mistake(p->mistakes, x->pin[PIN_C]->place,
                           "C is at B, so that the slide has no direction: give another point of "
                           "the slide");
    if (IS_SET(offset) && offset->source == GIVEN_BY_TEXT)
        return flk_mistake(p->mistakes, offset->place,
                           "give either the pin C, a point of the slide, or the offset, not both");
    pins->has_slide = 1;
    pins->length[FOURLINK_FOLLOWER] = length_of(lever) > SAME * x->size ? length_of(lever) : 0;
    pins->slide =
        pins->length[FOURLINK_FOLLOWER] > 0 ? reduced(direction_of(u) - direction_of(lever)) : 0;
    pins->side = length_of(r) > 0 ? FLK_DOT(r, u) / length_of(r) / length_of(u) : 0;
    place_link(pins, FOURLINK_COUPLER, x->at[PIN_B], u);
    place_link(pins, FOURLINK_FOLLOWER, x->at[PIN_D],
               pins->length[FOURLINK_FOLLOWER] > 0 ? lever : u);
    return 1;
}

/* Scotch yoke: the slot passes B, at its angle beta from the guide; with v the direction of the slot and
** n the left normal of the guide, the origin C of the yoke is at B - v ((B - A) . n - e) / sin(beta). */
static void find_yoke(parser *p, deck_pins *pins, const drawing *x)
{
    double beta = flk_setting_or(p, KEY_YOKE_ANGLE, M_PI_2), sine = flk_sine(beta), above;
    fourlink_vector u, v, C = x->at[PIN_B], crank = minus(x->at[PIN_B], x->at[PIN_A]);

    find_line(pins, x, direction_of(minus(x->on_guide[1], x->on_guide[0])), NULL);
    pins->branch = FOURLINK_OPEN;
    flk_sine_cosine(pins->angle, &u.y, &u.x);
    flk_sine_cosine(pins->angle + beta, &v.y, &v.x);
    above = sine != 0 ? (FLK_CROSS(u, crank) - pins->offset) / sine : 0;
    C.x -= above * v.x;
    C.y -= above * v.y;
    place_link(pins, FOURLINK_COUPLER, x->at[PIN_B], v);
    place_link(pins, FOURLINK_FOLLOWER, C, u);
}

static int find_lengths(parser *p, deck_pins *pins, const drawing *x)
{
    fourlink_vector crank = minus(x->at[PIN_B], x->at[PIN_A]);
    int found = 1;

    pins->length[FOURLINK_CRANK] = length_of(crank);
    switch (p->d->machine.mechanism.design.kind) {
    case FOURLINK_FOUR_BAR:
        find_four_bar(pins, x);
        break;
    case FOURLINK_SLIDER_CRANK:
        found = find_slider_crank(p, pins, x);
        break;
    case FOURLINK_INVERTED_SLIDER_CRANK:
        found = find_inverted(p, pins, x);
        break;
    default: /* of a yoke, which has one branch */
        find_yoke(p, pins, x);
    }
    place_link(pins, FOURLINK_CRANK, x->at[PIN_A], crank);
    pins->theta2 = reduced(direction_of(crank) - pins->angle);
    return found;
}

int flk_pins_place(parser *p, const setting *s, int link, fourlink_vector *at)
{
    const deck_pins *pins = &p->d->pins;
    fourlink_vector origin = pins->origin[link], axis = pins->axis[link], place;

    if (!pins->is_there)
        return flk_mistake(p->mistakes, s->place,
                           "'%t' is a place as drawn, which needs [pins]: without them give the "
                           "point of the link with 'at', or 'cg'",
                           s->value);
    if (link > FOURLINK_FOLLOWER && axis.x == 0 && axis.y == 0)
        return !p->mistakes->count &&
               flk_mistake(
                   p->mistakes, s->place,
                   "%s cannot be assembled in the drawn position, in which '%t' is a point of it",
                   fourlink_deck_link_text(p->d, link), s->value);
    if (link == FOURLINK_GROUND) {
        origin = pins->A;
        flk_sine_cosine(pins->angle, &axis.y, &axis.x);
    }
    place.x = s->si[0];
    place.y = s->si[1];
    *at = in_frame(minus(place, origin), axis);
    return 1;
}

/* ------------------------------------------------------------------------------------------ outputs */

void flk_pins_draw_outputs(parser *p)
{
    deck_pins *pins = &p->d->pins;
    const fourlink_mechanism *mechanism = &p->d->machine.mechanism;
    int number = mechanism->design.n_groups - 1, i;
    fourlink_state state;

    if (!pins->is_there || p->mistakes->count)
        return;
    memset(&state, 0, sizeof state);
    for (i = FOURLINK_CRANK; i < FOURLINK_ROD_OF(number); i++) {
        state.link[i].origin = on_ground(pins, pins->origin[i], 1);
        state.link[i].axis = on_ground(pins, pins->axis[i], 0);
    }
    if (flk_groups_margin(mechanism, &state) < -FLK_DEAD)
        return;
    place_assembled(pins, FOURLINK_ROD_OF(number), &state);
    place_assembled(pins, FOURLINK_END_OF(number), &state);
}

/* ----------------------------------------------------------------------------------------- rough places */

#define FAR 0.1 /* of the crank: a pin that is moved so far gets a note */

/* The lengths that a deck gives; 0 if it lacks one, which is reported elsewhere. */
static int take_lengths(parser *p, deck_pins *pins, const drawing *x, fourlink_design *design)
{
    const flk_kind *kind = flk_kind_of(design->kind);
    int i;

    for (i = FOURLINK_GROUND; i <= FOURLINK_FOLLOWER; i++)
        design->link[i].length =
            flk_setting_by_name(p, flk_section_of_link(design->kind, i), "length")->si[0];
    if (!(design->link[FOURLINK_CRANK].length > 0))
        design->link[FOURLINK_CRANK].length =
            flk_slider_crank_of_stroke(flk_setting_or(p, KEY_CRANK_STROKE, 0),
                                       design->link[FOURLINK_COUPLER].length, pins->offset);
    for (i = FOURLINK_GROUND; i <= FOURLINK_FOLLOWER; i++) {
        if (i == FOURLINK_GROUND && kind->has_length[i] == FLK_LENGTH &&
            !(design->link[i].length > 0))
            design->link[i].length = pins->length[i] = length_of(minus(x->at[PIN_D], x->at[PIN_A]));
        if (kind->has_length[i] == FLK_LENGTH && !(design->link[i].length > 0))
            return 0;
    }
    design->angle = design->kind == FOURLINK_SCOTCH_YOKE
                        ? flk_setting_or(p, KEY_YOKE_ANGLE, M_PI_2)
                        : flk_setting_find(p, KEY_LEVER_ANGLE)->si[0];
    design->offset = design->kind == FOURLINK_INVERTED_SLIDER_CRANK
                         ? flk_setting_find(p, KEY_LEVER_OFFSET)->si[0]
                         : pins->offset;
    return 1;
}

/* The end of link 3 at C, or C on a lever, as assembled. */
static fourlink_vector assembled_C(const deck_pins *pins, const fourlink_design *design,
                                   const fourlink_state *state)
{
    const fourlink_link_state *link = &state->link[FOURLINK_FOLLOWER];
    fourlink_vector C = link->origin;

    C.x += design->link[FOURLINK_FOLLOWER].length * link->axis.x;
    C.y += design->link[FOURLINK_FOLLOWER].length * link->axis.y;
    return on_page(pins, C, 1);
}

static void note_moved(parser *p, const drawing *x, int pin, fourlink_vector to, double crank)
{
    double by = length_of(minus(to, x->at[pin]));
    char far[MESSAGE_SIZE];

    if (IS_SET(x->pin[pin]) && by > FAR * crank)
        flk_mistake(NOTES(p), x->pin[pin]->place,
                    "with the lengths that are given %s is %s from this place",
                    flk_key_table[KEY_PINS_A + pin].name, in_words(p, by, far));
}

/* The direction of x of link 1, and the line of a slide on the ground: at the offset that is given, or
** along the guide, or through C. */
static void find_rough_ground(parser *p, deck_pins *pins, const drawing *x)
{
    const setting *offset = flk_setting_find(p, KEY_GROUND_OFFSET);
    double along = pins->has_guide ? direction_of(minus(x->on_guide[1], x->on_guide[0]))
                                   : flk_setting_or(p, KEY_GROUND_ANGLE, 0);
    fourlink_kind kind = p->d->machine.mechanism.design.kind;
    fourlink_vector u;

    if (WITH_PIN_D & (int)kind) {
        pins->angle = direction_of(minus(x->at[PIN_D], x->at[PIN_A]));
        return;
    }
    find_line(pins, x, along, kind == FOURLINK_SLIDER_CRANK ? &x->at[PIN_C] : NULL);
    flk_sine_cosine(pins->angle, &u.y, &u.x);
    if (IS_SET(offset))
        pins->offset = offset->si[0];
    else if (pins->has_guide)
        set_offset(pins, x, FLK_CROSS(u, minus(x->on_guide[0], x->at[PIN_A])));
}

/* A stays, B lies in the drawn direction, D too; of the two assemblies that is meant whose C is nearer
** to the drawn one, or the open one where there is none. */
static void find_rough(parser *p, deck_pins *pins, const drawing *x)
{
    fourlink_vector crank = minus(x->at[PIN_B], x->at[PIN_A]), C;
    fourlink_mechanism mechanism;
    fourlink_design design;
    fourlink_state state, best;
    int branch, status, why = FOURLINK_OK, i;
    double nearest = GSL_POSINF, away;

    find_rough_ground(p, pins, x);
    pins->theta2 = reduced(direction_of(crank) - pins->angle);
    memset(&design, 0, sizeof design);
    design.kind = p->d->machine.mechanism.design.kind;
    if (!take_lengths(p, pins, x, &design) || fourlink_prepare(&design, &mechanism) != FOURLINK_OK)
        return;
    for (branch = FOURLINK_OPEN; branch >= FOURLINK_CROSSED; branch -= 2) {
        if (branch != FOURLINK_OPEN && flk_kind_of(design.kind)->has_one_branch)
            continue;
        status = fourlink_position(&mechanism, (fourlink_branch)branch, pins->theta2, &state);
        if (status != FOURLINK_OK) {
            why = status;
            continue;
        }
        C = assembled_C(pins, &design, &state);
        away = IS_SET(x->pin[PIN_C]) ? length_of(minus(C, x->at[PIN_C])) : branch < 0;
        if (away < nearest) {
            nearest = away;
            best = state;
            pins->branch = branch;
        }
    }
    if (!pins->branch) {
        flk_mistake(p->mistakes, flk_setting_find(p, KEY_PINS_ROUGH)->place,
                    "as drawn, the lengths that are given do not fit: %s",
                    fourlink_status_text(why));
        return;
    }
    for (i = FOURLINK_CRANK; i <= FOURLINK_FOLLOWER; i++)
        place_assembled(pins, i, &best);
    note_moved(p, x, PIN_B, pins->origin[FOURLINK_COUPLER], design.link[2].length);
    note_moved(p, x, PIN_C, assembled_C(pins, &design, &best), design.link[2].length);
    note_moved(p, x, PIN_D, pins->origin[FOURLINK_FOLLOWER], design.link[2].length);
}

/* -------------------------------------------------------------------------------- what is given besides */

/* A key whose value follows from the pins, and that value; 0 if it does not. */
static int value_by_pins(const deck *d, key_code key, double *value)
{
    const deck_pins *pins = &d->pins;
    fourlink_kind kind = d->machine.mechanism.design.kind;
    const key_info *info = &flk_key_table[key];
    int i;

    if (!pins->is_there)
        return 0;
    *value = pins->angle;
    if (pins->is_rough)
        return key == KEY_GROUND_ANGLE && ((WITH_PIN_D & (int)kind) || pins->has_guide);
    *value = 0;
    for (i = FOURLINK_GROUND; i <= FOURLINK_FOLLOWER; i++)
        if (info->section == flk_section_of_link(kind, i) && strcmp(info->name, "length") == 0) {
            *value = pins->length[i];
            return *value > 0;
        }
    switch (key) {
    case KEY_GROUND_ANGLE:
        *value = pins->angle;
        return (WITH_PIN_D & (int)kind) || pins->has_guide;
    case KEY_GROUND_OFFSET:
        *value = pins->offset;
        return 1;
    case KEY_LEVER_OFFSET:
        return pins->has_slide;
    case KEY_LEVER_ANGLE:
        *value = pins->slide;
        return pins->has_slide;
    default:
        return key == KEY_CRANK_STROKE;
    }
}

int flk_pins_give(const deck *d, key_code key)
{
    double value;

    return value_by_pins(d, key, &value);
}

/* Two angles differ as directions do, of a guide as lines do. */
static double difference(const parser *p, key_code key, double x, double y)
{
    fourlink_kind kind = p->d->machine.mechanism.design.kind;
    double turn = key == KEY_GROUND_ANGLE && !(WITH_PIN_D & (int)kind) ? M_PI : 2 * M_PI;

    return flk_key_table[key].q == QUANTITY_ANGLE ? flk_cycle_beside(x - y, turn) : x - y;
}

/* A value that is given too differs from that by the pins in its last digit at most. */
static void check_given(parser *p, key_code key, double by_pins)
{
    const setting *s = flk_setting_find(p, key);
    const key_info *info = &flk_key_table[key];
    const unit *own = &p->d->bare[info->q].unit;
    text written = flk_quantity_unit_text(s->value);
    char why[MESSAGE_SIZE];
    quantity_value read;

    if (!IS_SET(s))
        return;
    if (s->source != GIVEN_BY_TEXT)
        flk_mistake(p->mistakes, s->place,
                    "%s.%s follows from [pins]: set the place of a pin, such as pins.B.x",
                    flk_section_table[info->section].name, info->name);
    else if (key == KEY_CRANK_STROKE)
        flk_mistake(p->mistakes, s->place,
                    "the length of the crank follows from [pins]: give no stroke");
    else if (flk_quantity_read(s->value, s->value, info->q, *own, &read, why) &&
             !(fabs(difference(p, key, read.si, by_pins)) <= 0.5 * read.digit * (1 + 1e-9)))
        flk_mistake(p->mistakes, s->place,
                    "by [pins] the %s of the %s is %.6g %t, not %t: give one of them", info->name,
                    flk_section_table[info->section].name, flk_unit_from_si(by_pins, read.unit),
                    written.length ? written : flk_text_of(p->d->bare[info->q].name), s->value);
}

void flk_pins_read(parser *p)
{
    const section_use *use = flk_section_find(p, SECTION_PINS, NULL);
    deck_pins *pins = &p->d->pins;
    double value;
    drawing x;
    key_code k;

    memset(pins, 0, sizeof *pins);
    if (!use)
        return;
    pins->is_there = 1;
    take_places(p, &x);
    pins->has_guide = x.guide->curve != NULL;
    pins->A = x.at[PIN_A];
    pins->is_rough = flk_setting_find(p, KEY_PINS_ROUGH)->word;
    if (!has_places(p, use, &x) || !check_places(p, &x))
        return;
    if (pins->is_rough)
        find_rough(p, pins, &x);
    else if (!find_lengths(p, pins, &x))
        return;
    for (k = flk_first_key(SECTION_GROUND); k < flk_first_key(SECTION_GAS); k++)
        if ((flk_section_table[flk_key_table[k].section].kinds & flk_key_table[k].kinds &
             (int)p->d->machine.mechanism.design.kind) &&
            value_by_pins(p->d, k, &value))
            check_given(p, k, value);
}

/* ------------------------------------------------------------------------------------------- the branch */

/* The open branch is drawn, but beyond a change point it is there a turn later. */
static void find_turn(const deck *d, deck_pins *pins)
{
    fourlink_crank crank = {0, 0, 0};
    fourlink_state state;

    crank.theta2 = pins->theta2;
    if (flk_mechanism_move(&d->machine.mechanism, FOURLINK_OPEN, &crank, 0, &state) ==
            FOURLINK_OK &&
        state.sine < 0)
        pins->theta2 += 2 * M_PI;
}

/* The branch is the one on which `sine`, the side of the drawing, has its sign: beyond a change point
** the open branch has the other one (fourlink_branch). */
void flk_pins_find_branch(parser *p)
{
    deck_pins *pins = &p->d->pins;
    fourlink_kind kind = p->d->machine.mechanism.design.kind;
    const setting *C = flk_setting_find(p, KEY_PINS_C);
    fourlink_crank crank = {0, 0, 0};
    fourlink_state state;
    int side = pins->side < 0 ? -1 : 1;

    if (pins->is_there && pins->branch)
        find_turn(p->d, pins);
    if (!pins->is_there || pins->branch)
        return;
    if (fabs(pins->side) < IN_LINE) {
        if (!flk_setting_find(p, KEY_TABLE_BRANCH)->word)
            flk_mistake(p->mistakes, (IS_SET(C) ? C : flk_setting_find(p, KEY_PINS_B))->place,
                        "%s, so that the drawing does not tell the branch: give [table] branch",
                        kind == FOURLINK_FOUR_BAR       ? "B, C and D are in line"
                        : kind == FOURLINK_SLIDER_CRANK ? "the rod is square to the line of stroke"
                                                        : "the slide is square to the line D-B");
        return;
    }
    crank.theta2 = pins->theta2;
    if (flk_mechanism_move(&p->d->machine.mechanism, FOURLINK_OPEN, &crank, 0, &state) ==
            FOURLINK_OK &&
        state.sine < 0)
        side = -side;
    pins->branch = side > 0 ? FOURLINK_OPEN : FOURLINK_CROSSED;
}
