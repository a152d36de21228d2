/* SPDX-License-Identifier: GPL-3.0-or-later
**
** build_prescribed.c - builds `input` of [motion]: what is prescribed in place of the crank angle.
**
** Rows go over the coordinate, from `from` to `to`, both within one stretch on which it only rises or only
** falls.
*/
#include <math.h>
#include <string.h>

#include <gsl/gsl_math.h>

#include "base/cycle.h"
#include "build.h"
#include "build_motor.h"
#include "build_prescribed.h"
#include "parser.h"
#include "settings.h"
#include "values.h"

#define STEPS 36   /* intervals of a range, without an interval */
#define CLOSE 1e-9 /* of a stretch: an end that is written with fewer digits */

/* The stretches of a branch that can be meant. */
typedef struct reach {
    flk_stretch list[FLK_STRETCHES];
    int n;
} reach;

int flk_build_is_prescribed(parser *p)
{
    static const key_code own[] = {KEY_MOTION_SIDE, KEY_MOTION_NEAR},
                          others[] = {KEY_MOTION_MEAN_SPEED, KEY_MOTION_TURNS,
                                      KEY_MOTION_RUN_UP,     KEY_MOTION_DURATION,
                                      KEY_MOTION_ROWS,       KEY_MOTION_TIME_STEP};
    size_t n_others = IS_SET(flk_setting_find(p, KEY_MOTION_PROGRAM))
                          ? 1 /* the others are those of a program, which refuses its own */
                          : sizeof others / sizeof others[0];
    const setting *input = flk_setting_find(p, KEY_MOTION_INPUT),
                  *mode = flk_setting_find(p, KEY_MOTION_MODE);
    const char *kind = fourlink_kind_text((int)p->d->machine.mechanism.design.kind);
    size_t i;

    for (i = 0; !input->word && i < sizeof own / sizeof own[0]; i++)
        if (IS_SET(flk_setting_find(p, own[i])))
            flk_mistake(p->mistakes, flk_setting_find(p, own[i])->place,
                        "'%s' needs an input, such as input = x", flk_key_table[own[i]].name);
    if (!input->word)
        return 0;
    if (input->word != FLK_NAMED_INPUT &&
        !(flk_coordinates[input->word - 1].kinds & (int)p->d->machine.mechanism.design.kind))
        flk_mistake(p->mistakes, input->place, "%s %s has no %t", flk_text_article(kind), kind,
                    input->value);
    for (i = 0; i < n_others; i++) {
        const setting *s = flk_setting_find(p, others[i]);

        if (IS_SET(s))
            flk_mistake(p->mistakes, s->place, "'%s' cannot be used with input = %t",
                        flk_key_table[others[i]].name, input->value);
    }
    if (mode->word != MODE_GIVEN)
        flk_mistake(p->mistakes, mode->place,
                    "'input' gives the motion, and mode = %t computes it: leave out one",
                    mode->value);
    if (input->word != FLK_NAMED_INPUT)
        p->d->over = &flk_abscissas[input->word + DECK_OVER_INPUT];
    return 1;
}

/* ------------------------------------------------------------------------------------------ by its name */

/* The length of an actuator. */
static int find_actuator(parser *p, const setting *input, text name, flk_coordinate *q)
{
    const flk_actuator *x;
    int i = flk_deck_actuator(p->d, name);

    if (i < 0)
        return flk_mistake(p->mistakes, input->place, "there is no [actuator %t]", name);
    x = &p->d->actuators[i];
    q->what = FLK_OF_ACTUATOR;
    q->actuator = x;
    q->n_groups = flk_search_groups(GSL_MAX(x->link, x->to));
    q->is_searched = flk_search_has_to(x, p->d->machine.mechanism.design.kind);
    return 1;
}

/* The place of the slider of an output, or the angle of its rocker. */
static int find_output(parser *p, const setting *input, text name, flk_coordinate *q)
{
    const fourlink_group *g;
    int i = flk_deck_output(p->d, name), turns;

    if (i < 0)
        return flk_mistake(p->mistakes, input->place, "there is no [output %t]", name);
    g = &p->d->groups[i];
    turns = g->end == FOURLINK_GROUP_TURNS;
    if (q->is_angle != turns)
        return flk_mistake(p->mistakes, input->place,
                           turns ? "[output %t] turns: input = %t.theta"
                                 : "[output %t] slides: input = %t.x",
                           name, name);
    q->what = FLK_OF_GROUP;
    q->group = g;
    q->link = FOURLINK_END_OF(i);
    q->n_groups = i + 1;
    q->is_searched = 1;
    return 1;
}

/* The coordinate that is prescribed; null after a mistake. */
static const flk_coordinate *find_coordinate(parser *p, const setting *input)
{
    flk_coordinate *q;
    fourlink_abscissa *over;
    text name, of;

    if (input->word != FLK_NAMED_INPUT)
        return &flk_coordinates[input->word - 1];
    q = flk_reader_keep(p, sizeof *q);
    over = flk_reader_keep(p, sizeof *over);
    if (!q || !over)
        return NULL;
    flk_text_cut_last(input->value, ".", &name, &of);
    q->name = q->symbol = q->words = flk_reader_copy(p, input->value, "");
    q->kinds = ANY_KIND;
    q->is_angle = flk_text_equal(of, "theta");
    *over =
        flk_abscissas[(q->is_angle ? FLK_OF_FOLLOWER : FLK_OF_DISPLACEMENT) + 1 + DECK_OVER_INPUT];
    over->name = over->symbol = over->rows = over->words = q->name;
    if (!p->d->program)
        p->d->over = over;
    return (flk_text_equal(of, "length") ? find_actuator : find_output)(p, input, name, q) ? q
                                                                                           : NULL;
}

/* ------------------------------------------------------------------------------------------------ reach */

/* Whether a crank angle is in a stretch, less whole periods. */
static int has_angle(const flk_stretch *x, double theta2, double period)
{
    double close = CLOSE * (x->theta2_to - x->theta2_from);

    return flk_cycle_place(theta2, x->theta2_from - close, period) <= x->theta2_to + close;
}

/* Keep the stretches of a side and, if given, near a crank angle. */
static void find_reach(parser *p, const deck_prescribed *x, fourlink_branch branch, int side,
                       reach *r)
{
    const setting *near = flk_setting_find(p, KEY_MOTION_NEAR);
    flk_stretch all[FLK_STRETCHES];
    int n = flk_coordinate_stretches(x->q, &p->d->machine.mechanism, branch, all), i, turns;
    double theta2 = IS_SET(near) ? flk_setting_crank_angle(p, near) - p->d->axes.angle : 0;

    for (turns = 2, r->n = 0; turns > 0 && !r->n; turns--)
        for (i = 0; i < n; i++)
            if (all[i].side == side &&
                (!IS_SET(near) || has_angle(&all[i], theta2, turns * 2 * M_PI)))
                r->list[r->n++] = all[i];
}

/* A value of the coordinate moved by whole turns, if it is an angle outside a stretch, to where the
** stretch has it; 0 if it is not there. */
static int move_into(const deck_prescribed *x, const flk_stretch *s, double *value)
{
    double low = GSL_MIN(s->from, s->to), high = GSL_MAX(s->from, s->to);
    double close = CLOSE * (high - low), at = *value - x->motion.x_at;

    if (x->q->is_angle && !(low - close <= at && at <= high + close))
        at = flk_cycle_place(at, low - close, 2 * M_PI);
    *value = GSL_MIN(GSL_MAX(at, low), high) + x->motion.x_at;
    return low - close <= at && at <= high + close;
}

static const deck_unit *unit_of(const parser *p, const deck_prescribed *x)
{
    return &p->d->units[x->q->is_angle ? QUANTITY_ANGLE : QUANTITY_LENGTH];
}

/* List the ranges that can be reached, in the deck's unit. */
static const char *list_reach(parser *p, const deck_prescribed *x, const reach *r, char *out)
{
    const deck_unit *u = unit_of(p, x);
    size_t length;
    int i;

    strcpy(out, r->n ? "" : "no value");
    for (i = 0; i < r->n && i < 4; i++) {
        const flk_stretch *s = &r->list[i];

        length = strlen(out);
        flk_message(out + length, MESSAGE_SIZE - length, "%sfrom %.5g to %.5g %s", i ? ", " : "",
                    flk_unit_from_si(GSL_MIN(s->from, s->to) + x->motion.x_at, u->unit),
                    flk_unit_from_si(GSL_MAX(s->from, s->to) + x->motion.x_at, u->unit), u->name);
    }
    return out;
}

/* Let a stretch of a whole turn begin at the lower end of a range. */
static void turn_stretch(parser *p, const deck_prescribed *x, fourlink_branch branch,
                         const double *from, const double *to, flk_stretch *s)
{
    double turn = fabs(s->to - s->from), way = s->theta2_to - s->theta2_from;
    double low = from && to ? GSL_MIN(*from, *to) : from ? *from : *to - turn;
    flk_prescribed at = {0, 0, 0};
    fourlink_crank crank;

    at.value = low - x->motion.x_at;
    if (flk_coordinate_crank(x->q, &p->d->machine.mechanism, branch, s, &at, &crank) != FOURLINK_OK)
        return;
    s->theta2_from = crank.theta2 - (x->q->is_searched && s->side < 0 ? way : 0);
    s->theta2_to = s->theta2_from + way;
    s->from = at.value + (s->side > 0 ? 0 : turn);
    s->to = at.value + (s->side > 0 ? turn : 0);
}

/* Keep the stretches in which both ends of a range are. */
static void keep_stretches(parser *p, const deck_prescribed *x, fourlink_branch branch, reach *r,
                           const double *from, const double *to, reach *kept)
{
    double at[2];
    int i;

    for (i = 0, kept->n = 0; i < r->n; i++) {
        flk_stretch *s = &r->list[i];
        double width = fabs(s->to - s->from);
        int is_turn = x->q->is_searched ? flk_coordinate_turns(x->q, s)
                                        : x->q->is_angle && fabs(width - 2 * M_PI) <= CLOSE * width;

        if ((from || to) && is_turn && !x->program)
            turn_stretch(p, x, branch, from, to, s);
        at[0] = from ? *from : s->from + x->motion.x_at;
        at[1] = to ? *to : s->to + x->motion.x_at;
        if ((x->program &&
             flk_coordinate_turns(x->q, s)) || /* with the crank, any number of times */
            (move_into(x, s, &at[0]) && move_into(x, s, &at[1]) &&
             (!from || !to || fabs((at[1] - at[0]) - (*to - *from)) <= 2 * CLOSE * width)))
            kept->list[kept->n++] = *s;
    }
}

/* ------------------------------------------------------------------------------------------------ range */

/* The value of a place of the motion, null if it is not given. */
static const double *place_of(parser *p, key_code key)
{
    const setting *s = flk_setting_find(p, key);

    return IS_SET(s) ? s->si : NULL;
}

static text_place place_or(parser *p, const setting *s)
{
    return IS_SET(s) ? s->place : flk_setting_find(p, KEY_MOTION_INPUT)->place;
}

/* Add the crank angles of the stretches on a side to a message. */
static void list_crank_angles(parser *p, const flk_stretch *list, int n, int side,
                              char why[MESSAGE_SIZE])
{
    const deck_unit *u = &p->d->units[QUANTITY_ANGLE];
    int listed = 0, i;
    size_t length;

    for (i = 0; i < n && listed < 4; i++) {
        length = strlen(why);
        if (list[i].side == side)
            flk_message(why + length, MESSAGE_SIZE - length, "%s from %.5g to %.5g %s",
                        listed++ ? "," : "",
                        flk_unit_from_si(list[i].theta2_from + p->d->axes.angle, u->unit),
                        flk_unit_from_si(list[i].theta2_to + p->d->axes.angle, u->unit), u->name);
    }
    if (!listed)
        strcat(why, " nowhere");
}

/* Say at which crank angles there are stretches of the side, as none is at `near`. */
static void tell_near(parser *p, const deck_prescribed *x, fourlink_branch branch,
                      char why[MESSAGE_SIZE])
{
    flk_stretch all[FLK_STRETCHES];
    int n = flk_coordinate_stretches(x->q, &p->d->machine.mechanism, branch, all);

    flk_message(why, MESSAGE_SIZE,
                "'near' is no crank angle at which %s is %s on the %s branch: it is", x->q->words,
                fourlink_input_side_text(x->side), fourlink_branch_text((int)branch));
    list_crank_angles(p, all, n, x->side, why);
}

/* Say when a program leaves the stretch in which it begins; 0 if it begins in none. */
static int tell_end(parser *p, const deck_prescribed *x, fourlink_branch branch, reach *r,
                    char why[MESSAGE_SIZE])
{
    char range[MESSAGE_SIZE];
    double at[3], value, time, begin[2];
    reach one;
    int i, k;

    if (!x->program)
        return 0;
    flk_program_at(x->program, x->program->segment[0].begin, at);
    for (i = 0; i < r->n; i++) {
        value = at[0] + x->motion.x_at;
        if (!move_into(x, &r->list[i], &value))
            continue;
        begin[0] = begin[1] = flk_program_end(x->program);
        for (k = 0; k < 2; k++)
            if (flk_program_pass(
                    x->program,
                    (k ? r->list[i].to : r->list[i].from) + at[0] + x->motion.x_at - value, &time))
                begin[k] = time;
        one.n = 1;
        one.list[0] = r->list[i];
        flk_message(why, MESSAGE_SIZE,
                    "at %.5g s the program leaves what %s reaches on the %s branch: %s, where it "
                    "is %s",
                    GSL_MIN(begin[0], begin[1]), x->q->words, fourlink_branch_text((int)branch),
                    list_reach(p, x, &one, range), fourlink_input_side_text(x->side));
        return 1;
    }
    return 0;
}

/* Choose the stretch of a branch, and tell why there is none, or more than one. */
static int choose_on_side(parser *p, deck_prescribed *x, fourlink_branch branch, int side,
                          char why[MESSAGE_SIZE])
{
    const double *from = place_of(p, KEY_MOTION_FROM), *to = place_of(p, KEY_MOTION_TO);
    char ranges[MESSAGE_SIZE];
    reach r, found;

    if (x->program) {
        from = &x->motion.from;
        to = &x->motion.to;
    }
    find_reach(p, x, branch, side, &r);
    if (!r.n && IS_SET(flk_setting_find(p, KEY_MOTION_NEAR))) {
        tell_near(p, x, branch, why);
        return 0;
    }
    if (IS_SET(flk_setting_find(p, KEY_MOTION_AT)))
        from = to = place_of(p, KEY_MOTION_AT);
    if (!from && !to && r.n > 1) {
        flk_message(
            why, MESSAGE_SIZE,
            "on the %s branch, %s has several ranges, %s: give 'from' and 'to', or 'near', a "
            "crank angle in one of them",
            fourlink_branch_text((int)branch), x->q->words, list_reach(p, x, &r, ranges));
        return 0;
    }
    keep_stretches(p, x, branch, &r, from, to, &found);
    if (found.n > 1) {
        flk_message(why, MESSAGE_SIZE,
                    "on the %s branch, %s is there at several crank angles where it is %s: give "
                    "'near', one between these limits:",
                    fourlink_branch_text((int)branch), x->q->words, fourlink_input_side_text(side));
        list_crank_angles(p, found.list, found.n, side, why);
    } else if (found.n) {
        *DECK_STRETCH(x, branch, side) = found.list[0];
    } else if (!tell_end(p, x, branch, &r, why)) {
        flk_message(why, MESSAGE_SIZE, "on the %s branch, %s reaches %s where it is %s",
                    fourlink_branch_text((int)branch), x->q->words, list_reach(p, x, &r, ranges),
                    fourlink_input_side_text(side));
    }
    return found.n == 1;
}

static int choose(parser *p, deck_prescribed *x, fourlink_branch branch, char why[MESSAGE_SIZE])
{
    return choose_on_side(p, x, branch, x->side, why) &&
           (!x->has_both || choose_on_side(p, x, branch, FOURLINK_FALLING, why));
}

/* The branches of the table that reach the range; those that do not are left out, unless the deck names
** them.  A branch that is not in the table has its stretch too, which a host may ask. */
static fourlink_branch choose_branches(parser *p, deck_prescribed *x)
{
    const setting *at = flk_setting_find(p, KEY_MOTION_AT),
                  *to = flk_setting_find(p, KEY_MOTION_TO),
                  *from = flk_setting_find(p, KEY_MOTION_FROM),
                  *near = flk_setting_find(p, KEY_MOTION_NEAR),
                  *program = flk_setting_find(p, KEY_MOTION_PROGRAM);
    text_place place = place_or(p, IS_SET(program) ? program
                                   : IS_SET(at)    ? at
                                   : IS_SET(from)  ? from
                                   : IS_SET(to)    ? to
                                                   : near);
    int is_named = IS_SET(flk_setting_find(p, KEY_TABLE_BRANCH));
    char why[2][MESSAGE_SIZE];
    int open = choose(p, x, FOURLINK_OPEN, why[0]) && p->d->open;
    int crossed = choose(p, x, FOURLINK_CROSSED, why[1]) && p->d->crossed;

    if (p->d->open && !open && (is_named || !crossed))
        flk_mistake(p->mistakes, place, "%s", why[0]);
    if (p->d->crossed && !crossed && (is_named || (!open && !p->d->open)))
        flk_mistake(p->mistakes, place, "%s", why[1]);
    p->d->open = open;
    p->d->crossed = crossed;
    return open ? FOURLINK_OPEN : FOURLINK_CROSSED;
}

/* Refuse both sides where one is meant. */
static void check_both_sides(parser *p, const deck_prescribed *x, const setting *side)
{
    if (p->d->program)
        flk_mistake(p->mistakes, side->place,
                    "a program moves %s on one side at a time: side = rising or falling",
                    x->q->words);
    else if (IS_SET(flk_setting_find(p, KEY_MOTION_NEAR)))
        flk_mistake(p->mistakes, flk_setting_find(p, KEY_MOTION_NEAR)->place,
                    "'near' is on one side: it cannot be used with side = both");
}

/* Refuse a place by the crank as it is drawn: it is one of the coordinate. */
static void refuse_drawn(parser *p, const deck_prescribed *x, const setting *s)
{
    if (IS_DRAWN(s))
        flk_mistake(p->mistakes, s->place, "'drawn' is a crank angle: give a value of %s",
                    x->q->words);
}

/* rad, by how many whole turns a stretch of an angle is before a value amid a range; 0 of a length. */
static double turns_before(const deck_prescribed *x, const flk_stretch *s, double middle)
{
    return x->q->is_angle ? 2 * M_PI * flk_cycle_nearest(middle - 0.5 * (s->from + s->to), 2 * M_PI)
                          : 0;
}

/* 1 if the values of two stretches are the same, less whole turns. */
static int is_same_range(const deck_prescribed *x, const flk_stretch *s, const flk_stretch *other)
{
    double low = GSL_MIN(s->from, s->to), high = GSL_MAX(s->from, s->to);
    double turns = turns_before(x, other, 0.5 * (low + high));

    return fabs(GSL_MIN(other->from, other->to) + turns - low) <= CLOSE * (high - low) &&
           fabs(GSL_MAX(other->from, other->to) + turns - high) <= CLOSE * (high - low);
}

/* Let the stretches of an angle that swings, of all branches and sides, be in the turn of the rows. */
static void align_stretches(deck_prescribed *x)
{
    double middle = 0.5 * (x->motion.from + x->motion.to) - x->motion.x_at, turns;
    int i, k;

    for (i = 0; i < 4; i++) {
        flk_stretch *s = &x->stretch[i / 2][i % 2];

        if (!x->q->is_searched || s->is_whole || s->from == s->to)
            continue;
        turns = middle < GSL_MIN(s->from, s->to) || middle > GSL_MAX(s->from, s->to)
                    ? turns_before(x, s, middle)
                    : 0;
        s->from += turns;
        s->to += turns;
        for (k = 0; k <= FLK_STRETCH_PARTS; k++)
            s->node[k].value += turns;
    }
}

/* The rows: without `from` and `to`, from end to end of the stretch, in the sense of the speed. */
static void build_range(parser *p, deck_prescribed *x, fourlink_branch branch)
{
    const setting *from = flk_setting_find(p, KEY_MOTION_FROM),
                  *to = flk_setting_find(p, KEY_MOTION_TO),
                  *interval = flk_setting_find(p, KEY_MOTION_INTERVAL);
    const flk_stretch *s = DECK_STRETCH(x, branch, x->side),
                      *other = DECK_STRETCH(x, -(int)branch, x->side),
                      *falling = DECK_STRETCH(x, branch, FOURLINK_FALLING);
    fourlink_motion *motion = &x->motion;
    double turning = motion->speed != 0 ? motion->speed : motion->acceleration;
    double low = GSL_MIN(s->from, s->to), high = GSL_MAX(s->from, s->to);
    fourlink_range range;
    int status;

    if (x->has_both && !(IS_SET(from) && IS_SET(to)) && !is_same_range(x, s, falling))
        flk_mistake(p->mistakes, flk_setting_find(p, KEY_MOTION_SIDE)->place,
                    "%s reaches different ranges where it is rising and where it is falling: give "
                    "'from' and 'to', or one side",
                    x->q->words);
    if (p->d->open && p->d->crossed && !(IS_SET(from) && IS_SET(to)) &&
        !is_same_range(x, s, other)) {
        if (IS_SET(flk_setting_find(p, KEY_TABLE_BRANCH)))
            flk_mistake(p->mistakes, flk_setting_find(p, KEY_TABLE_BRANCH)->place,
                        "the branches reach different ranges of %s: give 'from' and 'to', or one "
                        "branch",
                        x->q->words);
        p->d->crossed = 0;
    }
    motion->from = IS_SET(from) ? from->si[0] : (turning < 0 ? high : low) + motion->x_at;
    motion->to = IS_SET(to) ? to->si[0] : (turning < 0 ? low : high) + motion->x_at;
    move_into(x, s, &motion->from);
    move_into(x, s, &motion->to);
    motion->interval = IS_SET(interval) ? interval->si[0] : fabs(motion->to - motion->from) / STEPS;
    if (!(motion->interval > 0))
        motion->interval = 1;
    status = fourlink_motion_range(motion, &range);
    if (status == FOURLINK_BAD_RANGE)
        flk_mistake(p->mistakes, place_or(p, to),
                    "the range runs against the motion of an accelerated input: swap 'from' and "
                    "'to', or set 'hold = yes'");
    else if (status != FOURLINK_OK || range.n_rows > MOST_ROWS)
        flk_mistake(p->mistakes, place_or(p, interval), "%s",
                    fourlink_status_text(status != FOURLINK_OK ? status : FOURLINK_TOO_MANY_ROWS));
}

/* The stretch of a branch in which a crank angle is. */
static void choose_by_crank(const parser *p, deck_prescribed *x, fourlink_branch branch)
{
    flk_stretch all[FLK_STRETCHES];
    int n = flk_coordinate_stretches(x->q, &p->d->machine.mechanism, branch, all), i;

    for (i = 0; i < n; i++)
        if (i == 0 || has_angle(&all[i], x->theta2, 2 * M_PI))
            *DECK_STRETCH(x, branch, FOURLINK_RISING) = *DECK_STRETCH(x, branch, FOURLINK_FALLING) =
                all[i];
}

/* One instant: at a value of the coordinate or at a crank angle. */
static void build_instant(parser *p, deck_prescribed *x, const setting *at)
{
    const section_use *use = flk_section_find(p, SECTION_MOTION, NULL);

    p->d->one_instant = 1;
    x->motion.interval = 1; /* any value */
    x->is_at_crank =
        at->word || (!x->q->is_angle && flk_quantity_of_key(use, KEY_MOTION_AT) == QUANTITY_ANGLE);
    x->motion.from = x->motion.to = x->is_at_crank ? 0 : at->si[0];
    x->theta2 = flk_setting_crank_angle(p, at) - p->d->axes.angle;
    if (x->is_at_crank) {
        x->has_both = 0;
        choose_by_crank(p, x, FOURLINK_OPEN);
        choose_by_crank(p, x, FOURLINK_CROSSED);
    }
}

/* The value of an angle that swings through more than a turn, in the turn that it is in near a crank
** angle. */
static double value_near(parser *p, const deck_prescribed *x, fourlink_branch branch, double value)
{
    const setting *near = flk_setting_find(p, KEY_MOTION_NEAR);
    const flk_stretch *s = DECK_STRETCH(x, branch, x->side);
    double theta2, at, moved;

    if (!IS_SET(near) || !x->q->is_searched || !x->q->is_angle)
        return value;
    theta2 = flk_cycle_place(flk_setting_crank_angle(p, near) - p->d->axes.angle, s->theta2_from,
                             2 * M_PI);
    at = flk_coordinate_in_turn(
        x->q, s, theta2, flk_coordinate_value(x->q, &p->d->machine.mechanism, branch, theta2));
    moved = value + 2 * M_PI * flk_cycle_nearest(at + x->motion.x_at - value, 2 * M_PI);
    return moved - x->motion.x_at < GSL_MIN(s->from, s->to) ||
                   moved - x->motion.x_at > GSL_MAX(s->from, s->to)
               ? value
               : moved;
}

/* Between which values a program goes. */
static void build_limits(deck_prescribed *x)
{
    flk_program_reach of;

    flk_program_limits(x->program, &of);
    x->motion.interval = 1; /* any value: rows go over time */
    x->motion.from = of.low + x->motion.x_at;
    x->motion.to = of.high + x->motion.x_at;
}

void flk_build_prescribed(parser *p)
{
    const setting *input = flk_setting_find(p, KEY_MOTION_INPUT),
                  *side = flk_setting_find(p, KEY_MOTION_SIDE),
                  *at = flk_setting_find(p, KEY_MOTION_AT);
    fourlink_motion *crank = &p->d->motion;
    fourlink_branch branch;
    deck_prescribed *x;

    if (!input->word || p->out_of_memory || flk_mistakes_count(p->mistakes))
        return;
    x = flk_reader_keep(p, sizeof *x);
    if (!x)
        return;
    x->q = find_coordinate(p, input);
    if (!x->q || p->out_of_memory) /* also where there was no room for a program */
        return;
    x->has_both = side->word == SIDE_BOTH;
    x->side = IS_SET(side) && !x->has_both ? side->word : FOURLINK_RISING;
    x->motion.angle_unit = 1;
    x->motion.x_at = x->q->is_angle ? p->d->axes.angle : 0;
    x->motion.speed = flk_setting_or(p, KEY_MOTION_SPEED, 0);
    x->motion.acceleration = flk_setting_or(p, KEY_MOTION_ACCELERATION, 0);
    x->motion.hold = flk_setting_find(p, KEY_MOTION_HOLD)->word;
    p->d->prescribed = x;
    if (x->has_both)
        check_both_sides(p, x, side);
    refuse_drawn(p, x, flk_setting_find(p, KEY_MOTION_FROM));
    refuse_drawn(p, x, flk_setting_find(p, KEY_MOTION_TO));
    if (flk_mistakes_count(p->mistakes))
        return;
    x->program = p->d->program;
    if (x->program)
        build_limits(x);
    if (IS_SET(at))
        build_instant(p, x, at);
    if (!x->is_at_crank) {
        branch = choose_branches(p, x);
        if (flk_mistakes_count(p->mistakes))
            return;
        if (!x->program && !IS_SET(at))
            build_range(p, x, branch);
        else
            move_into(x, DECK_STRETCH(x, branch, x->side), &x->motion.from);
        if (IS_SET(at))
            x->motion.from = value_near(p, x, branch, x->motion.from);
        x->motion.to = IS_SET(at) || x->program ? x->motion.from : x->motion.to;
        align_stretches(x);
        x->theta2 = DECK_STRETCH(x, branch, x->side)->theta2_from;
    }
    crank->from = (x->theta2 + crank->x_at) / crank->angle_unit;
    crank->to = crank->from + flk_build_sense(p) * p->d->machine.cycle / crank->angle_unit;
}
