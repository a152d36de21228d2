/* SPDX-License-Identifier: GPL-3.0-or-later
**
** build_mechanism.c - builds the mechanism from values: its kind; of each link its length, mass, centre of
** mass, moment of inertia; whether it can be assembled.
*/
#include <math.h>
#include <string.h>

#include <gsl/gsl_math.h>

#include "base/number.h"
#include "base/trig.h"
#include "mechanics/kind.h"
#include "mechanics/mechanism.h"
#include "build.h"
#include "build_mechanism.h"
#include "build_place.h"
#include "parser.h"
#include "pieces.h"
#include "pins.h"
#include "settings.h"
#include "vector.h"

/* Refuse a key that the kind of mechanism does not have. */
static void refuse_key_of_kind(parser *p, const section_use *use, const setting *s,
                               const char *words, const key_info *key)
{
    int is_plain = use->section == SECTION_TOP || use->section == SECTION_PINS;

    flk_mistake(p->mistakes, s->place, "%s%s%s%s %s has no %s%s", is_plain ? "" : "the ",
                is_plain ? "" : flk_section_table[use->section].name, is_plain ? "" : " of ",
                flk_text_article(words), words,
                use->section == SECTION_PINS && key->form == FORM_PLACE ? "pin " : "", key->name);
}

/* Find the kind of the mechanism, and refuse sections and keys that it does not have. */
int flk_build_kind(parser *p)
{
    const setting *s = flk_setting_find(p, KEY_TOP_MECHANISM);
    size_t i;
    fourlink_kind kind;
    const char *words;
    key_code k;

    if (!IS_SET(s)) {
        text_place place = flk_reader_end(p);
        const char *kinds[MOST_WORDS];
        char list[MESSAGE_SIZE];

        place.line = 1;
        flk_key_words(KEY_TOP_MECHANISM, NULL, kinds);
        flk_text_list(kinds, "', 'mechanism = ", "' or 'mechanism = ", list, sizeof list);
        return flk_mistake(p->mistakes, place, "expected 'mechanism = %s' before the first section",
                           list);
    }
    if (!s->word)
        return 0;
    kind = (fourlink_kind)s->word;
    p->d->machine.mechanism.design.kind = kind;
    p->d->has_cylinder = kind == FOURLINK_INVERTED_SLIDER_CRANK && flk_word_has_cylinder(s->value);
    words = fourlink_kind_text((int)kind);
    for (i = 0; i < p->n_uses; i++) {
        const section_use *use = &p->uses[i];

        if (!(flk_section_table[use->section].kinds & (int)kind)) {
            flk_mistake(p->mistakes, use->place,
                        use->section == SECTION_COUPLER || use->section == SECTION_ROD ||
                                use->section == SECTION_SLIDER
                            ? "%s %s has no [%s]; its link 3 is the [%s]"
                            : "%s %s has no [%s]",
                        flk_text_article(words), words, flk_section_table[use->section].name,
                        fourlink_link_text((int)kind, FOURLINK_COUPLER));
            continue;
        }
        for (k = flk_first_key(use->section); k < flk_first_key(use->section + 1); k++) {
            s = flk_setting_of(use, k);
            if (IS_SET(s) && !(flk_key_table[k].kinds & (int)kind))
                refuse_key_of_kind(p, use, s, words, &flk_key_table[k]);
        }
    }
    return 1;
}

/* -------------------------------------------------------------------------------------------- links */

int flk_build_has(const parser *p, key_code key)
{
    const key_info *k = &flk_key_table[key];

    return (k->kinds & flk_section_table[k->section].kinds &
            (int)p->d->machine.mechanism.design.kind) != 0;
}

/* Report a missing length. */
static void require_length(parser *p, section_code section)
{
    const section_use *use = flk_section_find(p, section, NULL);
    const char *link = flk_section_table[section].name;

    if ((p->d->pins.is_there && (!p->d->pins.is_rough || section == SECTION_GROUND)) ||
        (use ? use->is_mistaken : p->has_unknown_section))
        return;
    if (use)
        flk_mistake(p->mistakes, use->place, "[%s] has no length%s", link,
                    use->section == SECTION_CRANK && flk_build_has(p, KEY_CRANK_STROKE)
                        ? ", and no stroke"
                        : "");
    else
        flk_mistake(p->mistakes, flk_reader_end(p), "there is no [%s] with a length", link);
}

/* The moment of inertia from the time of small swings about a pin at distance h from the centre of mass
** (ME3491, example 2): L = g (T / 2 pi)^2 is the length of the equivalent simple pendulum, and
**
**    k^2 = h (L - h)
*/
static void build_swing(parser *p, const setting *period, const setting *pin, int number)
{
    fourlink_link *link = &p->d->machine.mechanism.design.link[number];
    double g = flk_setting_or(p, KEY_GRAVITY_ACCELERATION, STANDARD_GRAVITY),
           turns = period->si[0] / (2 * M_PI);
    double h, L;
    fourlink_vector at = {0, 0};

    if (!IS_SET(pin)) {
        flk_mistake(p->mistakes, period->place,
                    "a swing_period needs a swing_pin: origin, end or a point of the link");
        return;
    }
    flk_build_place(p, pin, number, &at);
    if (g <= 0)
        g = STANDARD_GRAVITY; /* gravity may be off in the machine, but not in the test */
    h = flk_length(at.x - link->cg.x, at.y - link->cg.y);
    L = g * turns * turns;
    if (h == 0)
        flk_mistake(p->mistakes, pin->place,
                    "the swing_pin is at the centre of mass: the link does not swing there");
    else if (L < h)
        flk_mistake(p->mistakes, period->place,
                    "a swing_period of %t is too short: a point mass %.4g m from the pin swings "
                    "more slowly",
                    period->value, h);
    else
        link->inertia = link->mass * h * (L - h);
}

/* The crank of an engine or of a yoke from its stroke. */
static void build_stroke(parser *p)
{
    fourlink_design *design = &p->d->machine.mechanism.design;
    fourlink_link *link = design->link;
    const setting *s = flk_setting_find(p, KEY_CRANK_STROKE);
    double S, l = link[3].length, e = fabs(design->offset);

    if (!flk_build_has(p, KEY_CRANK_STROKE))
        return;
    if (IS_SET(flk_setting_find(p, KEY_CRANK_LENGTH)))
        flk_mistake(p->mistakes, s->place, "give either the length or the stroke, not both");
    S = s->si[0];
    link[2].length = flk_slider_crank_of_stroke(S, l, e);
    if (flk_build_has(p, KEY_YOKE_ANGLE) && fabs(design->angle - M_PI_2) > 1e-12)
        flk_mistake(p->mistakes, s->place,
                    "a stroke is for a slot at 90 deg; with this angle give the crank's length");
    if (l > 0 && S * S > 4 * l * (l - e))
        flk_mistake(p->mistakes, s->place, "%s",
                    e > 0 ? "this stroke is impossible with this rod and offset"
                          : "this stroke is impossible: the crank would be longer than the rod");
}

/* The mass data in the section of a link. */
typedef struct body {
    const setting *mass, *cg, *cg_place, *gyration, *inertia, *period, *pin, *uniform;
} body;

static body find_body(parser *p, section_code section)
{
    body b;

    b.mass = flk_setting_by_name(p, section, "mass");
    b.cg = flk_setting_by_name(p, section, "cg");
    b.cg_place = flk_setting_by_name(p, section, "cg_place");
    b.gyration = flk_setting_by_name(p, section, "gyration");
    b.inertia = flk_setting_by_name(p, section, "inertia");
    b.period = flk_setting_by_name(p, section, "swing_period");
    b.pin = flk_setting_by_name(p, section, "swing_pin");
    b.uniform = flk_setting_by_name(p, section, "uniform");
    return b;
}

static void check_inertia(parser *p, const setting *s, const fourlink_link *link)
{
    if (link->inertia > FOURLINK_NUMBER_MAX)
        flk_mistake(p->mistakes, s->place, "the resulting moment of inertia is out of range");
}

static void build_bar(parser *p, const flk_kind *kind, const body *b, int number)
{
    fourlink_link *link = &p->d->machine.mechanism.design.link[number];
    const setting *others[6];
    int i;

    others[0] = b->cg;
    others[1] = b->gyration;
    others[2] = b->inertia;
    others[3] = b->period;
    others[4] = b->pin;
    others[5] = b->cg_place;
    for (i = 0; i < 6; i++)
        if (IS_SET(others[i]))
            flk_mistake(p->mistakes, others[i]->place,
                        "a uniform link has its centre of mass at mid-length and the inertia of a "
                        "bar: give either 'uniform' or the others");
    fourlink_uniform_bar(link->length, link->mass, link);
    check_inertia(p, b->uniform, link);
    if (flk_build_is_without_length(p, kind, number))
        flk_mistake(p->mistakes, b->uniform->place, "a uniform %s needs a length",
                    kind->link[number]);
}

/* Note a mass with neither moment of inertia nor centre of mass. */
static void check_point_mass(parser *p, const flk_kind *kind, const body *b, int number)
{
    const fourlink_link *link = &p->d->machine.mechanism.design.link[number];

    if (!(link->mass > 0) || kind->has_length[number] == FLK_NO_LENGTH || IS_SET(b->cg) ||
        IS_SET(b->cg_place) || IS_SET(b->gyration) || IS_SET(b->inertia) || IS_SET(b->period))
        return;
    flk_mistake(NOTES(p), b->mass->place,
                "[%s] is a point mass at %s: write %scg = 0 mm if this is meant",
                kind->link[number],
                number == FOURLINK_CRANK     ? "A"
                : number == FOURLINK_COUPLER ? "B"
                                             : "D",
                link->length > 0 ? "uniform = yes for a uniform bar, " : "");
}

/* The moment of inertia, given in one of several ways. */
static void build_inertia(parser *p, const body *b, int number, int is_mistaken)
{
    fourlink_link *link = &p->d->machine.mechanism.design.link[number];
    const setting *other = IS_SET(b->gyration) ? b->gyration : b->period;

    link->inertia = b->inertia->si[0];
    if (IS_SET(b->gyration) + IS_SET(b->inertia) + IS_SET(b->period) > 1)
        flk_mistake(p->mistakes, other->place,
                    "give only one of gyration, inertia and swing_period");
    if (IS_SET(b->gyration))
        link->inertia = link->mass * b->gyration->si[0] * b->gyration->si[0]; /* I = m k^2 */
    if (b->period->si[0] > 0 && !is_mistaken)
        build_swing(p, b->period, b->pin, number);
    if (IS_SET(other))
        check_inertia(p, other, link);
    if (!IS_SET(b->period) && IS_SET(b->pin) && !is_mistaken)
        flk_mistake(p->mistakes, b->pin->place, "a swing_pin needs a swing_period");
}

static void build_body(parser *p, const flk_kind *kind, int number, section_code section)
{
    fourlink_link *link = &p->d->machine.mechanism.design.link[number];
    const section_use *use = flk_section_find(p, section, NULL);
    const body b = find_body(p, section);
    const setting *other = IS_SET(b.gyration) ? b.gyration
                           : IS_SET(b.period) ? b.period
                           : b.uniform->word  ? b.uniform
                                              : NULL;

    link->mass = b.mass->si[0];
    flk_build_point(p, b.cg, b.cg_place, number, &link->cg);
    if (b.cg->of_centre)
        flk_mistake(p->mistakes, b.cg->place, "'%t': G is the centre of mass itself", b.cg->value);
    if (other && !IS_SET(b.mass) && !use->is_mistaken)
        flk_mistake(p->mistakes, other->place, "%s needs a mass",
                    other == b.gyration ? "the radius of gyration"
                    : other == b.period ? "the swing_period"
                                        : "a uniform link");
    if (b.uniform->word) {
        build_bar(p, kind, &b, number);
        return;
    }
    build_inertia(p, &b, number, use && use->is_mistaken);
    check_point_mass(p, kind, &b, number);
}

/* The ground by the place of D from A, which gives its length and angle; 0 if it is given otherwise. */
static int build_ground(parser *p)
{
    const setting *to = flk_setting_find(p, KEY_GROUND_TO),
                  *length = flk_setting_find(p, KEY_GROUND_LENGTH),
                  *angle = flk_setting_find(p, KEY_GROUND_ANGLE);
    double size = flk_length(to->si[0], to->si[1]);

    if (!IS_SET(to))
        return 0;
    if (p->d->pins.is_there)
        return flk_mistake(p->mistakes, to->place, "[pins] gives the place of D: remove 'to'");
    if (IS_SET(length) || IS_SET(angle))
        flk_mistake(p->mistakes, (IS_SET(length) ? length : angle)->place,
                    "'to' gives the length and the angle of the ground: remove '%s'",
                    IS_SET(length) ? "length" : "angle");
    if (!(size >= FOURLINK_LENGTH_MIN) && !flk_section_is_mistaken(p, SECTION_GROUND))
        flk_mistake(p->mistakes, to->place, "D is at A: the ground has no length");
    p->d->machine.mechanism.design.link[FOURLINK_GROUND].length = size;
    return 1;
}

double flk_build_inclination(parser *p)
{
    const setting *to = flk_setting_find(p, KEY_GROUND_TO);

    return p->d->pins.is_there ? p->d->pins.angle
           : IS_SET(to)        ? flk_angle(to->si[1], to->si[0])
                               : flk_setting_or(p, KEY_GROUND_ANGLE, 0);
}

static void build_link(parser *p, const flk_kind *kind, int number)
{
    section_code section = flk_section_of_link(kind->kind, number);
    const setting *length = flk_setting_by_name(p, section, "length");

    if (number == FOURLINK_GROUND && build_ground(p))
        return;
    if (p->d->pins.length[number] > 0)
        p->d->machine.mechanism.design.link[number].length = p->d->pins.length[number];
    else if (number == FOURLINK_CRANK && IS_SET(flk_setting_find(p, KEY_CRANK_STROKE)))
        build_stroke(p);
    else if (IS_SET(length))
        p->d->machine.mechanism.design.link[number].length = length->si[0];
    else if (kind->has_length[number] == FLK_LENGTH)
        require_length(p, section);
    build_body(p, kind, number, section);
}

/* ---------------------------------------------------------------------------------------- assembly */

/* A setting as it is written, with its unit. */
static const char *as_written(parser *p, const setting *s, char out[MESSAGE_SIZE])
{
    int is_bare = !flk_quantity_unit_text(s->value).length;

    return flk_message(out, MESSAGE_SIZE, "%t%s%s", s->value, is_bare ? " " : "",
                       is_bare ? p->d->bare[QUANTITY_LENGTH].name : "");
}

/* The slide of a lever: its offset, or its angle at the end of the lever. */
static void build_slide(parser *p)
{
    const setting *offset = flk_setting_find(p, KEY_LEVER_OFFSET),
                  *length = flk_setting_find(p, KEY_LEVER_LENGTH),
                  *angle = flk_setting_find(p, KEY_LEVER_ANGLE);

    p->d->machine.mechanism.design.offset =
        IS_SET(offset) ? offset->si[0]
        : p->d->pins.is_there && !flk_build_has(p, KEY_GROUND_LENGTH)
            ? p->d->pins.offset
            : flk_setting_or(p, KEY_GROUND_OFFSET, 0);
    p->d->machine.mechanism.design.angle = p->d->pins.has_slide ? p->d->pins.slide : angle->si[0];
    if (flk_build_has(p, KEY_YOKE_ANGLE))
        p->d->machine.mechanism.design.angle = flk_setting_or(p, KEY_YOKE_ANGLE, M_PI_2);
    if (IS_SET(offset) && (IS_SET(length) || IS_SET(angle)))
        flk_mistake(p->mistakes, offset->place,
                    "give the lever either an offset, or a length and an angle, not both");
    else if (flk_section_is_mistaken(p, SECTION_LEVER) || p->d->pins.has_slide)
        return;
    else if (IS_SET(length) && !IS_SET(angle))
        flk_mistake(p->mistakes, length->place,
                    "a lever with a length needs an angle, that of the slide from the line D-C");
    else if (IS_SET(angle) && !IS_SET(length))
        flk_mistake(p->mistakes, angle->place,
                    "a lever with an angle needs a length, from D to C on the slide");
}

/* A slide can be reached at some angle if its distance is at most the sum of the two links that have a
** length. */
static void check_slide(parser *p, const flk_kind *kind, double sum)
{
    const fourlink_design *design = &p->d->machine.mechanism.design;
    const setting *angle = flk_setting_find(p, KEY_LEVER_ANGLE),
                  *length = flk_setting_find(p, KEY_LEVER_LENGTH),
                  *offset = flk_setting_find(p, KEY_LEVER_OFFSET);
    double distance = fabs(design->link[FOURLINK_FOLLOWER].length * flk_sine(design->angle));
    int first = kind->has_length[FOURLINK_GROUND] ? FOURLINK_GROUND : FOURLINK_CRANK;
    char at[MESSAGE_SIZE], most[MESSAGE_SIZE];

    if (!IS_SET(offset))
        offset = flk_setting_find(p, KEY_GROUND_OFFSET);
    if (IS_SET(angle) && distance > sum)
        flk_mistake(p->mistakes, angle->place,
                    "the slide passes D at %s, farther than %s and %s together, %s: the linkage "
                    "cannot be assembled",
                    flk_build_length_in(p, length, distance, at), kind->link[first],
                    kind->link[first + 1], flk_build_length_in(p, length, sum, most));
    else if (!IS_SET(angle) && fabs(design->offset) > sum)
        flk_mistake(p->mistakes, offset->place,
                    "the offset, %s, is larger than %s and %s together, %s: the linkage cannot be "
                    "assembled",
                    as_written(p, offset, at), kind->link[first], kind->link[first + 1],
                    flk_build_length_in(p, offset, sum, most));
}

/* A slot and one turned by half a turn are the same. */
static void check_slot(parser *p)
{
    const setting *angle = flk_setting_find(p, KEY_YOKE_ANGLE);

    if (IS_SET(angle) && !(angle->si[0] > 1e-7 && angle->si[0] < M_PI - 1e-7))
        flk_mistake(p->mistakes, angle->place,
                    "the slot's angle from the guide must be between 0 and 180 deg, not %t",
                    angle->value);
}

/* A linkage can be assembled at some angle if no link is longer than the sum of the other three.  A linkage
** with a slide can be assembled if the other links reach it. */
static void check_reach(parser *p, const flk_kind *kind)
{
    const fourlink_link *link = p->d->machine.mechanism.design.link;
    const setting *s;
    int i, longest = FOURLINK_GROUND;
    char own[MESSAGE_SIZE], most[MESSAGE_SIZE];
    double sum = 0;

    for (i = FOURLINK_GROUND; i <= FOURLINK_FOLLOWER; i++) {
        if (kind->has_length[i] != FLK_LENGTH)
            continue;
        if (!(link[i].length > 0))
            return; /* already reported */
        sum += link[i].length;
        if (link[i].length > link[longest].length)
            longest = i;
    }
    if (flk_build_has(p, KEY_YOKE_ANGLE)) {
        check_slot(p);
        return;
    }
    if (p->d->pins.is_there)
        return; /* it is assembled as drawn */
    if (flk_kind_has_slide(kind->kind)) {
        check_slide(p, kind, sum);
        return;
    }
    sum -= link[longest].length;
    if (link[longest].length > sum * (1 + 1e-14)) {
        s = flk_setting_by_name(p, flk_section_of_link(kind->kind, longest), "length");
        if (!IS_SET(s)) /* the ground, by its other end */
            s = flk_setting_find(p, KEY_GROUND_TO);
        flk_mistake(
            p->mistakes, s->place,
            "the %s, %s, is longer than the other three together, %s: the linkage cannot be "
            "assembled",
            kind->link[longest], as_written(p, s, own), flk_build_length_in(p, s, sum, most));
    }
}

/* The axes of directions and places: those of the page by default where the pins have places there. */
static void build_axes(parser *p, double inclination)
{
    deck_axes *axes = &p->d->axes;
    int word = flk_setting_find(p, KEY_TOP_AXES)->word;

    memset(axes, 0, sizeof *axes);
    axes->cosine = 1;
    axes->is_page = word ? word == AXES_PAGE : p->d->pins.is_there;
    if (!axes->is_page)
        return;
    axes->A = p->d->pins.A;
    axes->angle = inclination;
    flk_vector_direction(inclination, &axes->cosine, &axes->sine);
}

void flk_build_mechanism(parser *p)
{
    fourlink_design *design = &p->d->machine.mechanism.design;
    const flk_kind *kind = flk_kind_of(design->kind);
    const section_use *use;
    double direction, inclination, g;
    int i;

    flk_pins_read(p);
    build_slide(p);
    build_link(p, kind, FOURLINK_GROUND);
    for (i = 0; i < 2; i++) /* the rod before a crank that is computed from the stroke */
        build_link(p, kind,
                   i == flk_build_has(p, KEY_CRANK_STROKE) ? FOURLINK_CRANK : FOURLINK_COUPLER);
    build_link(p, kind, FOURLINK_FOLLOWER);
    g = flk_setting_or(p, KEY_GRAVITY_ACCELERATION, STANDARD_GRAVITY);
    inclination = flk_build_inclination(p);
    p->d->inclination = inclination;
    build_axes(p, inclination);
    direction = flk_setting_or(p, KEY_GRAVITY_DIRECTION, -M_PI_2) - inclination;
    flk_vector_direction(direction, &design->gravity.x, &design->gravity.y);
    design->gravity.x *= g;
    design->gravity.y *= g;
    p->d->axes.gravity = design->gravity;
    if (p->d->axes.is_page) {
        direction = flk_setting_or(p, KEY_GRAVITY_DIRECTION, -M_PI_2);
        flk_vector_direction(direction, &p->d->axes.gravity.x, &p->d->axes.gravity.y);
        p->d->axes.gravity.x *= g;
        p->d->axes.gravity.y *= g;
    }
    for (i = FOURLINK_CRANK; i <= FOURLINK_FOLLOWER; i++)
        if (design->link[i].mass > 0 || design->link[i].inertia > 0)
            p->d->has_forces = 1;
    check_reach(p, kind);
    if (p->mistakes->count)
        return;
    i = fourlink_prepare(design, &p->d->machine.mechanism);
    use = flk_section_find(p, p->d->pins.is_there ? SECTION_PINS : SECTION_CRANK, NULL);
    if (i != FOURLINK_OK)
        flk_mistake(p->mistakes, use->place, "%s", fourlink_status_text(i));
    else
        flk_pins_find_branch(p);
}

/* The approximations of the engine method, which exist only for the kind of engine in the sources. */
void flk_build_series(parser *p)
{
    const setting *s = flk_setting_find(p, KEY_TOP_SERIES);

    p->d->approximation = (fourlink_approximation)s->word;
    if (p->d->approximation != FOURLINK_EXACT && p->d->machine.mechanism.design.offset != 0)
        flk_mistake(p->mistakes, s->place, "%s", fourlink_status_text(FOURLINK_NO_SERIES));
}

flk_element *flk_build_element(parser *p, section_use *use)
{
    flk_machine *machine = &p->d->machine;

    if (!machine->element) /* a section makes one, at most */
        machine->element = flk_reader_keep(p, p->n_uses * sizeof *machine->element);
    use->element = machine->element ? &machine->element[machine->n_elements++] : NULL;
    return use->element;
}

int flk_build_check_link(parser *p, const section_use *use, const setting *link)
{
    const flk_kind *kind = flk_kind_of(p->d->machine.mechanism.design.kind);
    const char *const *own = kind->link;

    if (!IS_SET(link) && !use->is_mistaken)
        flk_mistake(p->mistakes, use->place, "[%s] has no link: %s, %s or %s",
                    flk_section_table[use->section].name, own[2], own[3], own[4]);
    else if (link->word && link->word <= FOURLINK_FOLLOWER &&
             !flk_text_equal(flk_link_meant((int)kind->kind, link->value), own[link->word]))
        return flk_mistake(p->mistakes, link->place, "%s %s has no %t: its links are %s, %s and %s",
                           flk_text_article(kind->words), kind->words, link->value, own[2], own[3],
                           own[4]);
    else if (flk_output_has_slot(p, link->word))
        return flk_mistake(
            p->mistakes, link->place,
            "there is no %t: this output hangs by a slot, and its block takes nothing",
            link->value);
    return 1;
}
