/* SPDX-License-Identifier: GPL-3.0-or-later
**
** deck.c - the input deck: text in, a problem to solve out, or its mistakes.
**
** In three passes: the lines give settings, each a text and its place (deck_lines.c); the texts
*give
** values, by the forms of schema.h and in the deck's units (deck_values.c); the values give the
*problem,
** here.  A mistake does not end the reading, so that one run tells all of them.
*/
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include <gsl/gsl_math.h>

#include "number.h"
#include "reader.h"

/* A value in SI units, or what it is when the deck does not set it. */
static double value_or(parser *p, key_code key, double otherwise)
{
    const setting *s = find(p, key);

    return s ? s->si[0] : otherwise;
}

/* An angle in the deck's unit of angle, without rounding if it is written in that. */
static double angle_or(parser *p, key_code key, double otherwise)
{
    const setting *s = find(p, key);
    const unit *u = &p->d->units[QUANTITY_ANGLE].unit;

    if (!s)
        return otherwise;
    if (s->unit.up == u->up && s->unit.down == u->down)
        return s->number;
    return s->si[0] * u->down / u->up;
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
    const key_info *k = &key_table[key];
    const section_use *use = find_use(p, k->section);

    if (find(p, key))
        return;
    if (use)
        mistake_note(&p->d->mistakes, use->place, "[", section_table[k->section].name, "] has no ",
                     k->name, (char *)NULL);
    else
        mistake_note(&p->d->mistakes, end_of_deck(p), "there is no [",
                     section_table[k->section].name, "] with a ", k->name, " in it", (char *)NULL);
}

static void build_link(parser *p, key_code length, int number)
{
    fourlink_link *link = &p->d->design.link[number];
    key_code mass = length + 1, gyration = length + 2, inertia = length + 3, cg = length + 4;
    const setting *s;

    require(p, length);
    link->length = value_or(p, length, 0);
    link->mass = value_or(p, mass, 0);
    link->inertia = value_or(p, inertia, 0);
    if ((s = find(p, gyration)) != NULL) {
        if (find(p, inertia))
            mistake_note(&p->d->mistakes, s->place,
                         "give either the gyration or the inertia, not both", (char *)NULL);
        if (!find(p, mass))
            mistake_note(&p->d->mistakes, s->place, "a radius of gyration needs a mass",
                         (char *)NULL);
        link->inertia = link->mass * s->si[0] * s->si[0]; /* I = m k^2 */
    }
    if ((s = find(p, cg)) != NULL) {
        link->cg.x = s->si[0];
        link->cg.y = s->si[1];
    }
}

/* The mechanism's kind, and that each section and key is one that it has. */
static int build_kind(parser *p)
{
    const setting *s = find(p, KEY_TOP_MECHANISM);
    size_t i;
    fourlink_kind kind;
    int k;

    if (!s) {
        text_place place = end_of_deck(p);

        place.line = 1;
        mistake_note(&p->d->mistakes, place, "expected 'mechanism = four-bar' or 'mechanism = ",
                     "slider-crank' before the first section", (char *)NULL);
        return 0;
    }
    if (!s->word)
        return 0;
    kind = (fourlink_kind)s->word;
    p->d->design.kind = kind;
    for (i = 0; i < p->n_uses; i++) {
        const section_use *use = &p->uses[i];
        int first = first_key(use->section), n = key_count(use->section);

        if (!(section_table[use->section].kinds & (int)kind)) {
            mistake_note(&p->d->mistakes, use->place, "a ", kind_words(kind), " has no [",
                         section_table[use->section].name, "]",
                         use->section == SECTION_COUPLER ? "; its link 3 is the [rod]"
                         : use->section == SECTION_ROD   ? "; its link 3 is the [coupler]"
                                                         : "",
                         (char *)NULL);
            continue;
        }
        for (k = first; k < first + n; k++) {
            s = setting_of(p, use, (key_code)k);
            if (s->place.source && !(key_table[k].kinds & (int)kind))
                mistake_note(&p->d->mistakes, s->place, "the ", section_table[use->section].name,
                             " of a ", kind_words(kind), " has no ", key_table[k].name,
                             (char *)NULL);
        }
    }
    return 1;
}

/* The links reach at some angle if no link is longer than the other three together; of a
** slider-crank, if crank and rod together reach the line of stroke. */
static void check_reach(parser *p)
{
    static const key_code keys[4] = {KEY_GROUND_LENGTH, KEY_CRANK_LENGTH, KEY_COUPLER_LENGTH,
                                     KEY_ROCKER_LENGTH};
    const fourlink_design *design = &p->d->design;
    const unit *u = &p->d->units[QUANTITY_LENGTH].unit;
    char rest[NUMBER_SIZE], word[WORD_SIZE];
    int i, longest = 0;
    double sum = 0;

    if (design->kind == FOURLINK_SLIDER_CRANK) {
        const setting *s = find(p, KEY_GROUND_OFFSET);

        sum = design->link[2].length + design->link[3].length;
        if (s && fabs(design->offset) > sum)
            mistake_note(&p->d->mistakes, s->place, "the offset, ", word_of(s->value, word),
                         ", is more than crank and rod together, ",
                         number_general(sum * u->down / u->up, 6, rest), " ",
                         p->d->units[QUANTITY_LENGTH].name, ": the rod never reaches",
                         (char *)NULL);
        return;
    }
    for (i = 0; i < 4; i++) {
        sum += design->link[i + 1].length;
        if (design->link[i + 1].length > design->link[longest + 1].length)
            longest = i;
    }
    sum -= design->link[longest + 1].length;
    if (design->link[longest + 1].length > sum * (1 + 1e-14)) {
        const setting *s = find(p, keys[longest]);

        mistake_note(&p->d->mistakes, s->place, "the ",
                     section_table[key_table[keys[longest]].section].name, ", ",
                     word_of(s->value, word), ", is longer than the other three together, ",
                     number_general(sum * u->down / u->up, 6, rest), " ",
                     p->d->units[QUANTITY_LENGTH].name, ": they cannot be assembled", (char *)NULL);
    }
}

static void build_mechanism(parser *p)
{
    fourlink_design *design = &p->d->design;
    double direction, g;
    const setting *s;
    int i;

    if (design->kind == FOURLINK_FOUR_BAR) {
        require(p, KEY_GROUND_LENGTH);
        design->link[FOURLINK_GROUND].length = value_or(p, KEY_GROUND_LENGTH, 0);
        build_link(p, KEY_CRANK_LENGTH, FOURLINK_CRANK);
        build_link(p, KEY_COUPLER_LENGTH, FOURLINK_COUPLER);
        build_link(p, KEY_ROCKER_LENGTH, FOURLINK_FOLLOWER);
    } else {
        design->offset = value_or(p, KEY_GROUND_OFFSET, 0);
        build_link(p, KEY_CRANK_LENGTH, FOURLINK_CRANK);
        build_link(p, KEY_ROD_LENGTH, FOURLINK_COUPLER);
        design->link[FOURLINK_FOLLOWER].mass = value_or(p, KEY_PISTON_MASS, 0);
    }
    g = value_or(p, KEY_GRAVITY_ACCELERATION, 9.81);
    direction = value_or(p, KEY_GRAVITY_DIRECTION, -M_PI_2) - value_or(p, KEY_GROUND_ANGLE, 0);
    direction_of(direction, &design->gravity.x, &design->gravity.y);
    design->gravity.x *= g;
    design->gravity.y *= g;
    for (i = FOURLINK_CRANK; i <= FOURLINK_FOLLOWER; i++)
        if (design->link[i].mass > 0 || design->link[i].inertia > 0)
            p->d->has_forces = 1;
    if (p->d->mistakes.count)
        return;
    check_reach(p);
    i = fourlink_prepare(design, &p->d->mechanism);
    s = find(p, KEY_CRANK_LENGTH);
    if (i != FOURLINK_OK)
        mistake_note(&p->d->mistakes, s->place, fourlink_status_text(i), (char *)NULL);
}

static void build_load(parser *p, const section_use *use, fourlink_load *load)
{
    const setting *link = setting_of(p, use, KEY_LOAD_LINK);
    const setting *force = setting_of(p, use, KEY_LOAD_FORCE),
                  *at = setting_of(p, use, KEY_LOAD_AT);
    const setting *torque = setting_of(p, use, KEY_LOAD_TORQUE);
    char word[WORD_SIZE];
    int four_bar = p->d->design.kind == FOURLINK_FOUR_BAR;

    if (!link->place.source) {
        mistake_note(&p->d->mistakes, use->place, "[load] has no link: ",
                     four_bar ? "crank, coupler or rocker" : "crank, rod or piston", (char *)NULL);
    } else if (four_bar ? text_equal(link->value, "rod") || text_equal(link->value, "piston")
                        : text_equal(link->value, "coupler") || text_equal(link->value, "rocker")) {
        mistake_note(&p->d->mistakes, link->place, "a ", kind_words(p->d->design.kind), " has no ",
                     word_of(link->value, word), ": its links are ",
                     four_bar ? "crank, coupler and rocker" : "crank, rod and piston",
                     (char *)NULL);
    }
    if (!force->place.source && !torque->place.source)
        mistake_note(&p->d->mistakes, use->place, "[load] has neither a force nor a torque",
                     (char *)NULL);
    if (at->place.source && !force->place.source)
        mistake_note(&p->d->mistakes, at->place, "'at' is for a force", (char *)NULL);
    load->link = link->word;
    load->frame = FOURLINK_FRAME_GROUND;
    load->force.x = force->si[0];
    load->force.y = force->si[1];
    load->at.x = at->si[0];
    load->at.y = at->si[1];
    load->torque = torque->si[0];
}

static void build_loads(parser *p)
{
    size_t i, n = 0;

    for (i = 0; i < p->n_uses; i++)
        n += p->uses[i].section == SECTION_LOAD;
    if (!n)
        return;
    p->d->loads = calloc(n, sizeof *p->d->loads);
    if (!p->d->loads) {
        p->out_of_memory = 1;
        return;
    }
    for (i = 0; i < p->n_uses; i++)
        if (p->uses[i].section == SECTION_LOAD)
            build_load(p, &p->uses[i], &p->d->loads[p->d->n_loads++]);
    p->d->has_forces = 1;
}

static void build_motion(parser *p)
{
    fourlink_motion *motion = &p->d->motion;
    const unit *u = &p->d->units[QUANTITY_ANGLE].unit;
    const setting *run_up = find(p, KEY_MOTION_RUN_UP), *s;
    double cycle, turning;
    fourlink_range range;
    int status;

    motion->angle_unit = u->up / u->down;
    motion->speed = value_or(p, KEY_MOTION_SPEED, 0);
    motion->acceleration = value_or(p, KEY_MOTION_ACCELERATION, 0);
    s = find(p, KEY_MOTION_HOLD);
    motion->hold = s ? s->word : 0;
    motion->interval = angle_or(p, KEY_MOTION_INTERVAL, 10 * (M_PI / 180) / motion->angle_unit);
    if (u->up == M_PI && u->down == 180)
        motion->interval = angle_or(p, KEY_MOTION_INTERVAL, 10);
    if ((s = find(p, KEY_MOTION_AT)) != NULL) {
        motion->from = angle_or(p, KEY_MOTION_AT, 0);
        motion->to = motion->from;
        p->d->one_instant = 1;
        return;
    }
    cycle = angle_or(p, KEY_MOTION_CYCLE, floor(2 * M_PI * u->down / u->up * 1e9 + 0.5) / 1e9);
    turning = motion->speed != 0 ? motion->speed : motion->acceleration;
    motion->from = angle_or(p, KEY_MOTION_FROM, 0);
    motion->to = angle_or(p, KEY_MOTION_TO, motion->from + (turning < 0 ? -cycle : cycle));
    p->d->one_revolution =
        fabs(fabs(motion->to - motion->from) * motion->angle_unit - 2 * M_PI) < 1e-9;
    if (run_up) {
        motion->run_up = angle_or(p, KEY_MOTION_RUN_UP, 0);
        p->d->one_revolution = 1;
        if ((s = find(p, KEY_MOTION_SPEED)) != NULL && s->si[0] != 0)
            mistake_note(&p->d->mistakes, s->place,
                         "a run-up starts from rest: it takes an acceleration and no speed",
                         (char *)NULL);
        if ((s = find(p, KEY_MOTION_TO)) != NULL)
            mistake_note(&p->d->mistakes, s->place,
                         "a run-up ends one revolution after its angle: it takes no 'to'",
                         (char *)NULL);
        if (motion->hold)
            mistake_note(&p->d->mistakes, run_up->place, "a run-up cannot hold its speed",
                         (char *)NULL);
    }
    if (p->d->mistakes.count)
        return;
    status = fourlink_motion_range(motion, &range);
    if (status == FOURLINK_BAD_RANGE) {
        s = find(p, KEY_MOTION_TO);
        mistake_note(&p->d->mistakes, s ? s->place : end_of_deck(p),
                     "the range runs against the rotation of the accelerated crank; turn it round, "
                     "or give 'hold = yes'",
                     (char *)NULL);
    } else if (status == FOURLINK_NO_RUN_UP) {
        mistake_note(&p->d->mistakes, run_up->place, "a run-up from rest needs an acceleration",
                     (char *)NULL);
    } else if (status != FOURLINK_OK) {
        s = find(p, KEY_MOTION_INTERVAL);
        mistake_note(&p->d->mistakes, s ? s->place : end_of_deck(p), fourlink_status_text(status),
                     (char *)NULL);
    }
}

static void build_table(parser *p)
{
    const setting *s = find(p, KEY_TABLE_BRANCH);
    int branches = s ? s->word : BRANCH_BOTH;
    char word[WORD_SIZE];

    p->d->open = (branches & BRANCH_OPEN) != 0;
    p->d->crossed = (branches & BRANCH_CROSSED) != 0;
    if ((s = find(p, KEY_TABLE_COLUMNS)) != NULL) {
        p->d->columns.names = s->value;
        p->d->columns.place = s->place;
    }
    p->d->digits = 6;
    if ((s = find(p, KEY_TABLE_DIGITS)) != NULL) {
        if (s->si[0] > 17)
            mistake_note(&p->d->mistakes, s->place, "digits must be 1 to 17, not ",
                         word_of(s->value, word), (char *)NULL);
        else
            p->d->digits = (int)s->si[0];
    }
}

static void build(parser *p)
{
    const setting *title = find(p, KEY_TOP_TITLE);

    if (title)
        text_copy(title->value, p->d->title, sizeof p->d->title);
    if (!build_kind(p))
        return;
    build_mechanism(p);
    build_loads(p);
    build_motion(p);
    build_table(p);
}

static void set_default_units(deck *d)
{
    text bad;
    int q;

    for (q = 0; q < QUANTITY_COUNT; q++) {
        strcpy(d->units[q].name, quantities[q].unit);
        unit_read(text_of(quantities[q].unit), &d->units[q].unit, &bad);
    }
}

/* One copy of the deck and of the changes: values are pieces of it. */
static int store(deck *d, text contents, const deck_change *changes, size_t n_changes)
{
    size_t size = contents.length + 1, i;
    char *end;

    for (i = 0; i < n_changes; i++)
        size += strlen(changes[i].assignment) + 1;
    d->storage = malloc(size);
    if (!d->storage)
        return 0;
    if (contents.length)
        memcpy(d->storage, contents.start, contents.length);
    end = d->storage + contents.length;
    *end++ = '\0';
    for (i = 0; i < n_changes; i++) {
        strcpy(end, changes[i].assignment);
        end += strlen(end) + 1;
    }
    return 1;
}

int deck_read(const char *name, text contents, const deck_change *changes, size_t n_changes,
              deck *d)
{
    parser p;
    char *change;
    size_t i;

    memset(d, 0, sizeof *d);
    memset(&p, 0, sizeof p);
    p.d = d;
    p.name = name;
    set_default_units(d);
    if (!store(d, contents, changes, n_changes))
        return -1;
    contents.start = d->storage;
    read_lines(&p, contents);
    change = d->storage + contents.length + 1;
    for (i = 0; i < n_changes && !p.out_of_memory; i++) {
        apply_change(&p, changes[i].option, text_of(change));
        change += strlen(change) + 1;
    }
    if (!p.out_of_memory)
        read_values(&p);
    if (!p.out_of_memory)
        build(&p);
    mistakes_sort(&d->mistakes);
    free(p.uses);
    free(p.settings);
    if (p.out_of_memory)
        return -1;
    return d->mistakes.count == 0;
}

void deck_free(deck *d)
{
    mistakes_free(&d->mistakes);
    free(d->loads);
    free(d->storage);
    memset(d, 0, sizeof *d);
}
