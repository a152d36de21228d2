/* SPDX-License-Identifier: GPL-3.0-or-later
**
** build_output.c - builds [output] from values: a slider or a rocker, with its rod or slot, on a point of a
** link.
*/
#include <string.h>

#include "mechanics/group.h"
#include "build.h"
#include "build_mechanism.h"
#include "build_place.h"
#include "build_point.h"
#include "parser.h"
#include "pins.h"
#include "settings.h"
#include "vector.h"

/* The names of links and of the points that every deck has: an output does not take them. */
static int is_taken(text name)
{
    static const char *const taken[] = {"A",      "B",      "C",     "D",       "G2",  "G3",
                                        "G4",     "ground", "crank", "coupler", "rod", "slider",
                                        "rocker", "piston", "lever", "yoke"};
    size_t i;

    for (i = 0; i < sizeof taken / sizeof taken[0]; i++)
        if (flk_text_equal(name, taken[i]))
            return 1;
    return 0;
}

static void check_name(parser *p, const section_use *use)
{
    static const section_code others[] = {SECTION_POINT, SECTION_SPRING};
    const section_use *other;
    size_t i;

    flk_build_check_name(p, use, "NAME.x or NAME.theta ...");
    if (is_taken(use->name))
        flk_mistake(p->mistakes, use->place,
                    "'%t' is the name of a link or a pin: give the output another one", use->name);
    for (i = 0; i < 2; i++) {
        other = flk_section_find(p, others[i], &use->name);
        if (other && use->name.length)
            flk_mistake(p->mistakes,
                        other->place.line > use->place.line ? other->place : use->place,
                        "[%s %t] and [output %t] have one name: their columns would, too",
                        flk_section_table[others[i]].name, use->name, use->name);
    }
}

/* ---------------------------------------------------------------------------------------------- masses */

/* The keys of its links: of the rod, of slider or rocker. */
enum { MASS, UNIFORM, CG, CG_PLACE, GYRATION, INERTIA, KEYS };

#define KEYS_OF(X)                                                                      \
    {                                                                                   \
        KEY_OUTPUT_##X##MASS, KEY_OUTPUT_##X##UNIFORM, KEY_OUTPUT_##X##CG,              \
            KEY_OUTPUT_##X##CG_PLACE, KEY_OUTPUT_##X##GYRATION, KEY_OUTPUT_##X##INERTIA \
    }
static const key_code keys_of[2][KEYS] = {KEYS_OF(ROD_), KEYS_OF(END_)};

static void build_uniform(parser *p, const section_use *use, int number, const key_code keys[KEYS],
                          fourlink_link *link)
{
    const setting *uniform = flk_setting_of(use, keys[UNIFORM]);
    int i;

    for (i = CG; i < KEYS; i++)
        if (IS_SET(flk_setting_of(use, keys[i])))
            flk_mistake(p->mistakes, flk_setting_of(use, keys[i])->place,
                        "a uniform link has its centre of mass at mid-length and the inertia of a "
                        "bar: give either 'uniform' or the others");
    if (link->length > 0)
        fourlink_uniform_bar(link->length, link->mass, link);
    else if (!use->is_mistaken)
        flk_mistake(p->mistakes, uniform->place, "%s has no length: it is not a uniform bar",
                    p->d->groups[number].end == FOURLINK_GROUP_SLIDES ? "a slider"
                                                                      : "a rocker with a slot");
}

static void build_masses(parser *p, const section_use *use, int number, int is_rod)
{
    const key_code *keys = keys_of[!is_rod];
    const setting *mass = flk_setting_of(use, keys[MASS]),
                  *gyration = flk_setting_of(use, keys[GYRATION]),
                  *inertia = flk_setting_of(use, keys[INERTIA]),
                  *cg = flk_setting_of(use, keys[CG]),
                  *cg_place = flk_setting_of(use, keys[CG_PLACE]),
                  *uniform = flk_setting_of(use, keys[UNIFORM]);
    const setting *other = IS_SET(gyration) ? gyration : uniform->word ? uniform : NULL;
    fourlink_link *link = &p->d->groups[number].body[!is_rod];

    link->mass = mass->si[0];
    if (other && !IS_SET(mass) && !use->is_mistaken)
        flk_mistake(p->mistakes, other->place, "%s needs a mass",
                    IS_SET(gyration) ? "the radius of gyration" : "a uniform link");
    if (uniform->word) {
        build_uniform(p, use, number, keys, link);
        return;
    }
    if (cg->of_centre)
        flk_mistake(p->mistakes, cg->place, "'%t': G is the centre of mass itself", cg->value);
    else
        flk_build_point(p, cg, cg_place, FOURLINK_ROD_OF(number) + !is_rod, &link->cg);
    if (IS_SET(gyration) && IS_SET(inertia))
        flk_mistake(p->mistakes, gyration->place, "give only one of gyration and inertia");
    link->inertia =
        IS_SET(gyration) ? link->mass * gyration->si[0] * gyration->si[0] : inertia->si[0];
    if (link->inertia > FOURLINK_NUMBER_MAX)
        flk_mistake(p->mistakes, gyration->place,
                    "the resulting moment of inertia is out of range");
    if (link->mass > 0 && link->length > 0 && !IS_SET(cg) && !IS_SET(cg_place) &&
        !IS_SET(gyration) && !IS_SET(inertia))
        flk_mistake(
            NOTES(p), mass->place,
            "%s is a point mass at %s: write %suniform = yes for a uniform bar, %scg = 0 mm "
            "if this is meant",
            p->d->outputs[number].name[!is_rod], is_rod ? "P" : "its pin", is_rod ? "rod_" : "",
            is_rod ? "rod_" : "");
}

/* -------------------------------------------------------------------------------------------- geometry */

static void refuse_setting(parser *p, const section_use *use, key_code key, const char *why)
{
    const setting *s = flk_setting_of(use, key);

    if (IS_SET(s))
        flk_mistake(p->mistakes, s->place, "'%s' %s", flk_key_table[key].name, why);
}

static void require(parser *p, const section_use *use, key_code key, const char *why)
{
    if (!IS_SET(flk_setting_of(use, key)) && !use->is_mistaken)
        flk_mistake(p->mistakes, use->place, "[output] has no %s: %s", flk_key_table[key].name,
                    why);
}

/* The link of `link` or `to`, which moves and comes before the output; 0 after a mistake. */
static int read_link(parser *p, const section_use *use, int number, const setting *link)
{
    if (!flk_build_check_link(p, use, link))
        return 0;
    if (link->word < FOURLINK_ROD_OF(number))
        return link->word;
    flk_mistake(p->mistakes, link->place,
                "an output hangs on one of the four links or on an output before it, not on %t",
                link->value);
    return 0;
}

static int side_of(parser *p, const section_use *use, const fourlink_group *g)
{
    const setting *side = flk_setting_of(use, KEY_OUTPUT_SIDE);
    int is_slider = g->end == FOURLINK_GROUP_SLIDES;
    int by_rod = g->hang == FOURLINK_HANGS_BY_ROD, along = is_slider || !by_rod;

    if (side->word && is_slider && !by_rod)
        flk_mistake(p->mistakes, side->place,
                    "a slider by a slot has one assembly: leave out side");
    else if (side->word && along != (side->word <= SIDE_BEHIND))
        flk_mistake(p->mistakes, side->place, "the side of a %s is %s, not %t",
                    is_slider ? "slider"
                    : by_rod  ? "rocker"
                              : "rocker by a slot",
                    along ? "ahead or behind" : "left or right", side->value);
    return side->word == SIDE_BEHIND || side->word == SIDE_RIGHT ? -1 : 1;
}

/* By a rod, or by a slot. */
static void build_hang(parser *p, const section_use *use, fourlink_group *g)
{
    static const char none[] = "belongs to a slot: give slot = output or slot = link",
                      no_rod[] = "belongs to a rod, and this output hangs by a slot";
    const setting *rod = flk_setting_of(use, KEY_OUTPUT_ROD),
                  *slot = flk_setting_of(use, KEY_OUTPUT_SLOT);
    int i;

    g->hang = (fourlink_group_hang)slot->word;
    g->rod = g->body[0].length = IS_SET(slot) ? 0 : rod->si[0];
    if (!IS_SET(slot)) {
        refuse_setting(p, use, KEY_OUTPUT_SLOT_ANGLE, none);
        refuse_setting(p, use, KEY_OUTPUT_OFFSET, none);
        if (!IS_SET(rod) && !use->is_mistaken)
            flk_mistake(p->mistakes, use->place,
                        "[output] has no rod, its length from P to Q, and no slot: give one");
        return;
    }
    refuse_setting(p, use, KEY_OUTPUT_ROD, "and 'slot' are two ways to hang: give one");
    for (i = 0; i < KEYS; i++)
        refuse_setting(p, use, keys_of[0][i], no_rod);
}

/* The direction of a slot in a slider or in the carrying link; the offset of that of a rocker. */
static void build_slot(parser *p, const section_use *use, fourlink_group *g)
{
    const setting *angle = flk_setting_of(use, KEY_OUTPUT_SLOT_ANGLE);
    int is_own = g->hang == FOURLINK_HANGS_BY_OWN_SLOT, is_slider = g->end == FOURLINK_GROUP_SLIDES;

    if (g->hang == FOURLINK_HANGS_BY_ROD)
        return;
    if (is_own && !is_slider) {
        refuse_setting(p, use, KEY_OUTPUT_SLOT_ANGLE,
                       "is of other slots: that of a rocker is along the rocker, at its 'offset'");
        g->offset = flk_setting_of(use, KEY_OUTPUT_OFFSET)->si[0];
        return;
    }
    refuse_setting(p, use, KEY_OUTPUT_OFFSET, "is of the slot of a rocker");
    if (is_own)
        require(p, use, KEY_OUTPUT_SLOT_ANGLE, "the direction of its slot, from its line");
    flk_vector_direction(angle->si[0], &g->slot.x, &g->slot.y);
    if (is_own && IS_SET(angle) && g->slot.y * g->slot.y <= FLK_DEAD)
        flk_mistake(p->mistakes, angle->place,
                    "the slot is along the line: the output could not be moved");
}

static void build_slider(parser *p, const section_use *use, fourlink_group *g)
{
    static const char why[] = "belongs to a rocker; 'line' and 'angle' make a slider";
    const setting *line = flk_setting_of(use, KEY_OUTPUT_LINE);
    fourlink_vector u, at;

    g->end = FOURLINK_GROUP_SLIDES;
    require(p, use, KEY_OUTPUT_LINE, "a point of the line of stroke");
    require(p, use, KEY_OUTPUT_ANGLE, "the direction of the line of stroke");
    refuse_setting(p, use, KEY_OUTPUT_LENGTH, why);
    refuse_setting(p, use, KEY_OUTPUT_TO_AT, why);
    refuse_setting(p, use, KEY_OUTPUT_TO_PLACE, why);
    at.x = line->si[0];
    at.y = line->si[1];
    g->pivot = flk_build_on_ground(p, at);
    flk_vector_direction(flk_setting_of(use, KEY_OUTPUT_ANGLE)->si[0], &u.x, &u.y);
    g->direction = flk_build_direction(p, u);
}

static void build_rocker(parser *p, const section_use *use, int number, fourlink_group *g)
{
    static const char why[] = "belongs to a slider; 'pivot' and 'to' make a rocker";
    const setting *to = flk_setting_of(use, KEY_OUTPUT_TO),
                  *pivot = flk_setting_of(use, KEY_OUTPUT_PIVOT),
                  *place = flk_setting_of(use, KEY_OUTPUT_TO_PLACE);
    fourlink_vector at;

    g->end = FOURLINK_GROUP_TURNS;
    refuse_setting(p, use, KEY_OUTPUT_LINE, why);
    refuse_setting(p, use, KEY_OUTPUT_ANGLE, why);
    if (g->hang == FOURLINK_HANGS_BY_OWN_SLOT)
        refuse_setting(p, use, KEY_OUTPUT_LENGTH,
                       "is not needed: the slot of the rocker is as long as it has to be");
    else
        require(p, use, KEY_OUTPUT_LENGTH, "the length of the rocker, from its pin to Q");
    g->length = g->body[1].length = flk_setting_of(use, KEY_OUTPUT_LENGTH)->si[0];
    if (!IS_SET(to)) {
        refuse_setting(p, use, KEY_OUTPUT_TO_AT, "needs 'to', the link that the pin is on");
        refuse_setting(p, use, KEY_OUTPUT_TO_PLACE, "needs 'to', the link that the pin is on");
        at.x = pivot->si[0];
        at.y = pivot->si[1];
        g->pivot = flk_build_on_ground(p, at);
        return;
    }
    if (g->hang != FOURLINK_HANGS_BY_ROD)
        flk_mistake(p->mistakes, to->place,
                    "a rocker by a slot has a fixed pin, 'pivot': only one by a rod can have 'to'");
    refuse_setting(p, use, KEY_OUTPUT_PIVOT,
                   "is a fixed pin, and 'to' puts the pin on a link: give one");
    if (!IS_SET(place))
        require(p, use, KEY_OUTPUT_TO_AT, "the pin of the rocker, on the link 'to'");
    g->to = read_link(p, use, number, to);
    if (g->to && g->to == g->link)
        flk_mistake(p->mistakes, to->place,
                    "both pins are on the %t: the output would not move on it", to->value);
    flk_build_point(p, flk_setting_of(use, KEY_OUTPUT_TO_AT), place, g->to, &g->pivot);
}

/* ----------------------------------------------------------------------------------------------- names */

#define ENDING(code, ending, whose, q, need, form, usual, meaning) ending,
static const char *const endings[] = {OUTPUT_COLUMN_LIST(ENDING)};

#define FACT_ENDINGS(code, slider, rocker, q, q_rocker, meaning, meaning_rocker) {slider, rocker},
static const char *const fact_endings[][2] = {OUTPUT_FACT_LIST(FACT_ENDINGS)};

/* Name its columns and facts. */
static void name_results(parser *p, const section_use *use, const fourlink_group *g, deck_output *o)
{
    size_t i;

    for (i = 0; i < OUTPUT_FACTS; i++)
        o->fact_names[i] =
            flk_reader_copy(p, use->name, fact_endings[i][g->end == FOURLINK_GROUP_TURNS]);
    for (i = 0; i < OUTPUT_COLUMNS; i++)
        o->column_names[i] = flk_reader_copy(p, use->name, endings[i]);
}

/* ----------------------------------------------------------------------------------------------- build */

/* Why it cannot be assembled, by how it hangs; a slider by a slot always can. */
static const char *const apart[] = {
    " cannot be assembled: its rod does not reach",
    " cannot be assembled: P is nearer to its pin than the offset of its slot",
    " cannot be assembled: it does not reach the slot"};

static void build_output(parser *p, const section_use *use, int number)
{
    fourlink_group *g = &p->d->groups[number];
    deck_output *o = &p->d->outputs[number];
    const setting *link = flk_setting_of(use, KEY_OUTPUT_LINK),
                  *at = flk_setting_of(use, KEY_OUTPUT_AT),
                  *place = flk_setting_of(use, KEY_OUTPUT_PLACE);
    int is_slider = IS_SET(flk_setting_of(use, KEY_OUTPUT_LINE)) ||
                    IS_SET(flk_setting_of(use, KEY_OUTPUT_ANGLE));
    int is_rocker =
        IS_SET(flk_setting_of(use, KEY_OUTPUT_PIVOT)) || IS_SET(flk_setting_of(use, KEY_OUTPUT_TO));

    build_hang(p, use, g);
    o->name[0] = flk_reader_copy(p, use->name, g->hang ? ".block" : ".rod");
    o->name[1] = flk_reader_copy(p, use->name, "");
    o->apart = flk_reader_copy(p, use->name, apart[g->hang]);
    check_name(p, use);
    g->link = read_link(p, use, number, link);
    if (!IS_SET(at) && !IS_SET(place) && !use->is_mistaken)
        flk_mistake(p->mistakes, use->place,
                    "[output] has no at: the point P of the link that carries it");
    flk_build_point(p, at, place, g->link, &g->at);
    if (!is_slider && !is_rocker && !use->is_mistaken)
        flk_mistake(p->mistakes, use->place,
                    "[output] has neither a line, on which it slides, nor a pivot, about which it "
                    "turns");
    if (is_slider && !is_rocker)
        build_slider(p, use, g);
    else if (is_rocker)
        build_rocker(p, use, number, g);
    if (g->end) {
        build_slot(p, use, g);
        g->side = side_of(p, use, g);
    }
    flk_pins_draw_outputs(p);
    build_masses(p, use, number, 0);
    if (g->hang == FOURLINK_HANGS_BY_ROD)
        build_masses(p, use, number, 1);
    name_results(p, use, g, o);
    if (g->body[0].mass > 0 || g->body[1].mass > 0 || g->body[0].inertia > 0 ||
        g->body[1].inertia > 0)
        p->d->has_forces = 1;
}

void flk_build_outputs(parser *p)
{
    fourlink_design *design = &p->d->machine.mechanism.design;
    const section_use *use = NULL;
    int status;

    if (!flk_section_find(p, SECTION_OUTPUT, NULL))
        return;
    p->d->outputs = flk_reader_keep(p, FOURLINK_MOST_GROUPS * sizeof *p->d->outputs);
    p->d->groups = flk_reader_keep(p, FOURLINK_MOST_GROUPS * sizeof *p->d->groups);
    design->group = p->d->groups;
    while (!p->out_of_memory && (use = flk_section_next(p, SECTION_OUTPUT, use)) != NULL) {
        if (design->n_groups == FOURLINK_MOST_GROUPS) {
            flk_mistake(p->mistakes, use->place, "more than %ld outputs",
                        (long)FOURLINK_MOST_GROUPS);
            return;
        }
        design->n_groups++;
        build_output(p, use, design->n_groups - 1);
    }
    use = flk_section_find(p, SECTION_OUTPUT, NULL);
    status = p->mistakes->count || p->out_of_memory ? FOURLINK_OK : flk_groups_check(design);
    if (status != FOURLINK_OK)
        flk_mistake(p->mistakes, use->place, "%s", fourlink_status_text(status));
}
