/* SPDX-License-Identifier: GPL-3.0-or-later
**
** build_synthesis.c - builds the task of [synthesis] from values.
*/
#include <gsl/gsl_math.h>

#include "mechanics/kind.h"
#include "build_mechanism.h"
#include "build_place.h"
#include "build_synthesis.h"
#include "curve_text.h"
#include "parser.h"
#include "pieces.h"
#include "settings.h"
#include "synthesis.h"
#include "task.h"

#define POSITIONS 3 /* of motion and path */
#define DYAD "fixed (50, 0) mm"
#define THREE_POSITIONS "(0, 0) mm 0 deg, (24, 10) mm -30 deg, (40, 5) mm -50 deg"
#define MU_MIN_USUAL 40.0 /* deg */

static const deck_task_kind kinds[] = {
    {FOURLINK_FOUR_BAR,
     QUANTITY_ANGLE,
     KEY_SYNTHESIS_ROCKER,
     "theta4",
     "60 deg to 150 deg",
     "# K1 = %g, K2 = %g, K3 = %g; a = d/K1, c = d/K2, b^2 = a^2 + c^2 + d^2 - 2 a c K3",
     FOURLINK_CRANK_ROCKER,
     1,
     "time_ratio, swing, and two lengths, or one for the best transmission angle",
     KEY_COUNT,
     {"ground_length crank_length coupler_length rocker_length mu_range defects type",
      "ground_length crank_length coupler_length rocker_length mu_range theta4_error defects "
      "type"}},
    {FOURLINK_SLIDER_CRANK,
     QUANTITY_LENGTH,
     KEY_SYNTHESIS_PISTON,
     "C.x",
     "100 mm to 30 mm",
     "# S1 = %g, S2 = %g, S3 = %g; r = S1/2, e = S2/S1, l^2 = r^2 + e^2 - S3",
     FOURLINK_ENGINE,
     0,
     "time_ratio, stroke, and crank, rod or offset, or none for the best transmission angle",
     KEY_GROUND_OFFSET,
     {"crank_length coupler_length line_offset mu_range defects type",
      "crank_length coupler_length line_offset mu_range x_error defects type"}},
    {FOURLINK_INVERTED_SLIDER_CRANK,
     QUANTITY_ANGLE,
     KEY_COUNT,
     NULL,
     NULL,
     NULL,
     FOURLINK_SLOTTED_LEVER,
     1,
     "the ground or the crank, time_ratio or, of a slotted lever, swing, and the lever or stroke",
     KEY_LEVER_ANGLE,
     {"ground_length crank_length defects type",
      "ground_length crank_length rocker_length defects type"}}};

/* -------------------------------------------------------------------------------- motion and path */

/* fixed (0.5, 3.5) mm; moving (4, 1) mm; rotations 20 deg 50 deg; slider 30 deg.  0 if it is missing. */
static int read_dyad(parser *p, key_code key, fourlink_dyad *dyad)
{
    static const char *const words[] = {"fixed", "moving", "rotations", "slider", NULL};
    setting *s = flk_task_find(p, key);
    text word = s->value, rest;
    int i;

    if (!IS_SET(s))
        return 0;
    flk_section_split(&word, &rest);
    for (i = 0; words[i] && !flk_text_equal(word, words[i]); i++)
        ;
    dyad->choice = (fourlink_choice)(FOURLINK_FIXED_PIVOT + i);
    if (!words[i])
        return flk_mistake(p->mistakes, s->place,
                           "expected fixed (x, y) mm, moving (x, y) mm, rotations 20 deg 50 deg or "
                           "slider 30 deg, not '%t'%h",
                           s->value, flk_text_nearest(word, words));
    if (dyad->choice == FOURLINK_ROTATIONS)
        return flk_task_pair(p, s, rest, QUANTITY_ANGLE, &dyad->rotation[0], &dyad->rotation[1]);
    if (dyad->choice == FOURLINK_SLIDER)
        return flk_piece_read(p, s, rest, QUANTITY_ANGLE, &dyad->rotation[0]);
    return flk_task_point(p, s, rest, &dyad->pivot, &word) &&
           (!word.length || flk_mistake(p->mistakes, s->place,
                                        "expected one point, such as (24, 10) mm, not '%t'", rest));
}

/* Check the keys of both, and read positions of the coupler; returns how many have an angle, -1 after a
** mistake. */
static int read_positions(parser *p, key_code other, const char *example,
                          fourlink_vector at[POSITIONS], double angle[POSITIONS])
{
    setting *s = flk_task_find(p, KEY_SYNTHESIS_POSITIONS);
    text rest = s->value, item, after;
    int n = 0, n_angles = 0;

    flk_task_check_lengths(p, 0, "no lengths");
    if (!(flk_task_require(p, KEY_SYNTHESIS_POSITIONS, THREE_POSITIONS) &
          flk_task_require(p, other, example) & flk_task_require(p, KEY_SYNTHESIS_RIGHT, DYAD)))
        return -1;
    while (n < POSITIONS && flk_piece_item(&rest, &item) &&
           flk_task_point(p, s, item, &at[n], &after)) {
        if (after.length && !flk_piece_read(p, s, after, QUANTITY_ANGLE, &angle[n]))
            return -1;
        n_angles += after.length > 0;
        n++;
    }
    if (n == POSITIONS && (!rest.start || !rest.length)) /* a comma at the very end */
        return n_angles;
    flk_task_refuse(p, KEY_SYNTHESIS_POSITIONS, "three positions, such as " THREE_POSITIONS);
    return -1;
}

static int build_motion(parser *p)
{
    fourlink_motion_task *t = &p->d->synthesis->motion;
    int n_angles, has_dyads;

    if (flk_task_has_points(p))
        return flk_task_points(p);
    n_angles = read_positions(p, KEY_SYNTHESIS_LEFT, DYAD, t->point, t->angle);
    has_dyads =
        read_dyad(p, KEY_SYNTHESIS_LEFT, &t->left) & read_dyad(p, KEY_SYNTHESIS_RIGHT, &t->right);
    if (n_angles >= 0 && n_angles < POSITIONS)
        flk_mistake(p->mistakes, flk_task_find(p, KEY_SYNTHESIS_POSITIONS)->place,
                    "each position needs an angle of the coupler, such as (24, 10) mm -30 deg");
    return n_angles == POSITIONS && has_dyads;
}

static int build_path(parser *p)
{
    fourlink_path_task *t = &p->d->synthesis->path;
    double angle[POSITIONS] = {0, 0, 0};
    int n_angles, has_dyad;

    if (flk_task_has_points(p))
        return flk_task_points(p);
    n_angles = read_positions(p, KEY_SYNTHESIS_TIMING, "40 deg, 85 deg", t->point, angle);
    has_dyad = read_dyad(p, KEY_SYNTHESIS_RIGHT, &t->right);
    if (n_angles > 0 && n_angles < POSITIONS)
        flk_mistake(p->mistakes, flk_task_find(p, KEY_SYNTHESIS_POSITIONS)->place,
                    "give the angle of the coupler at all positions, or at none: then they are "
                    "searched for");
    t->search = n_angles == 0;
    t->rotation[0] = angle[1] - angle[0];
    t->rotation[1] = angle[2] - angle[0];
    if (IS_SET(flk_task_find(p, KEY_SYNTHESIS_TIMING)) &&
        flk_task_list(p, KEY_SYNTHESIS_TIMING, QUANTITY_ANGLE, POSITIONS - 1, t->timing) !=
            POSITIONS - 1)
        return flk_task_refuse(p, KEY_SYNTHESIS_TIMING,
                               "the crank's rotations from the first position to the second and "
                               "third, such as 40 deg, 85 deg");
    return has_dyad && (n_angles == 0 || n_angles == POSITIONS);
}

/* ---------------------------------------------------------------------------------- quick return */

static int build_quick_return(parser *p)
{
    const deck_task_kind *kind = p->d->synthesis->kind;
    fourlink_quick_return_task *t = &p->d->synthesis->quick_return;
    const setting *swing = flk_task_find(p, KEY_SYNTHESIS_SWING),
                  *stroke = flk_task_find(p, KEY_SYNTHESIS_STROKE),
                  *type = flk_task_find(p, KEY_SYNTHESIS_TYPE),
                  *choose = flk_task_find(p, KEY_SYNTHESIS_CHOOSE),
                  *ratio = flk_task_find(p, KEY_SYNTHESIS_TIME_RATIO),
                  *offset = flk_setting_find(p, KEY_GROUND_OFFSET);
    int n = flk_task_lengths(p, t->length);

    t->type = type->word ? (fourlink_type)type->word : kind->type;
    if (!IS_SET(offset))
        offset = flk_setting_find(p, KEY_LEVER_OFFSET);
    flk_task_check_lengths(p, kind->n_best + 1, kind->quick_return);
    if (t->type == FOURLINK_ENGINE && IS_SET(offset) && offset->si[0] == 0)
        return flk_mistake(p->mistakes, offset->place,
                           "an offset of 0 has a time ratio of 1: remove it, it is found");
    if (IS_SET(swing) && !(swing->si[0] > 0 && swing->si[0] < M_PI))
        return flk_mistake(p->mistakes, swing->place, "a swing is between 0 and 180 deg");
    if (IS_SET(choose) && n + IS_SET(offset) > kind->n_best)
        return flk_mistake(p->mistakes, choose->place, "the task takes %s", kind->quick_return);
    if (t->type == FOURLINK_WHITWORTH && (IS_SET(swing) || IS_SET(stroke)))
        return flk_mistake(p->mistakes, (IS_SET(swing) ? swing : stroke)->place,
                           "the lever of a Whitworth mechanism turns fully: give the time_ratio");
    if (t->type == FOURLINK_SLOTTED_LEVER && IS_SET(swing) && IS_SET(ratio))
        return flk_mistake(p->mistakes, swing->place,
                           "the swing of a slotted lever follows from the time_ratio: give one of "
                           "them");
    if (IS_SET(ratio) && ratio->si[0] < 1)
        return flk_mistake(p->mistakes, ratio->place,
                           "a time ratio is at least 1: slow stroke / quick stroke, in time; which "
                           "is slow is said by 'slow'");
    if ((t->type == FOURLINK_CRANK_ROCKER && !flk_task_require(p, KEY_SYNTHESIS_SWING, "50 deg")) ||
        (t->type == FOURLINK_ENGINE && !flk_task_require(p, KEY_SYNTHESIS_STROKE, "100 mm")) ||
        (!(t->type == FOURLINK_SLOTTED_LEVER && IS_SET(swing)) &&
         !flk_task_require(p, KEY_SYNTHESIS_TIME_RATIO, "1.2")))
        return 0;
    flk_task_unit(p, flk_quantity_unit_text(stroke->value));
    flk_task_unit(p, flk_quantity_unit_text(offset->value));
    t->time_ratio = ratio->si[0];
    t->swing = swing->si[0];
    t->stroke = stroke->si[0];
    t->offset = offset->si[0];
    t->slow = flk_task_find(p, KEY_SYNTHESIS_SLOW)->word;
    return 1;
}

/* --------------------------------------------------------------------------------------- cognate */

static int build_cognate(parser *p)
{
    fourlink_cognate_task *t = &p->d->synthesis->cognate;
    text_place place = p->d->synthesis->place;
    const section_use *at = flk_task_coupler_point(p);
    double length[5];
    int i;

    if (!flk_task_require(p, KEY_SYNTHESIS_WHICH, "left"))
        return 0;
    if (flk_task_lengths(p, length) < 4)
        return flk_mistake(p->mistakes, place,
                           "task = cognate needs the lengths of all four links");
    if (!at)
        return flk_mistake(p->mistakes, place,
                           "task = cognate needs a [point] of the coupler, which it traces");
    t->design.kind = p->d->machine.mechanism.design.kind;
    for (i = FOURLINK_GROUND; i <= FOURLINK_FOLLOWER; i++)
        t->design.link[i].length = p->d->machine.mechanism.design.link[i].length = length[i];
    flk_build_place(p, flk_setting_of(at, KEY_POINT_AT), FOURLINK_COUPLER, &t->point);
    t->branch = flk_setting_find(p, KEY_TABLE_BRANCH)->word == BRANCH_CROSSED ? FOURLINK_CROSSED
                                                                              : FOURLINK_OPEN;
    t->side = (fourlink_side)flk_task_find(p, KEY_SYNTHESIS_WHICH)->word;
    t->from = flk_setting_or(p, KEY_MOTION_FROM, 0);
    t->to = flk_setting_or(p, KEY_MOTION_TO, t->from);
    return 1;
}

/* ------------------------------------------------------------------------------------------- all */

#define MOST_OF_TASK 10

/* The tasks by deck_task: kinds that have them, and their keys, with KEY_COUNT at the end; task and mu_min
** belong to all. */
static const struct {
    const char *name;
    int kinds;
    int (*build)(parser *p);
    key_code keys[MOST_OF_TASK];
} tasks[] = {
    {NULL, 0, NULL, {KEY_COUNT}},
    {"function",
     FOURLINK_FOUR_BAR | FOURLINK_SLIDER_CRANK,
     flk_task_function,
     {KEY_SYNTHESIS_POINTS, KEY_SYNTHESIS_WEIGHTS, KEY_SYNTHESIS_FIT, KEY_SYNTHESIS_FUNCTION,
      KEY_SYNTHESIS_ARGUMENT, KEY_SYNTHESIS_CRANK, KEY_SYNTHESIS_ROCKER, KEY_SYNTHESIS_PISTON,
      KEY_SYNTHESIS_PRECISION, KEY_COUNT}},
    {"motion",
     FOURLINK_FOUR_BAR | FOURLINK_SLIDER_CRANK,
     build_motion,
     {KEY_SYNTHESIS_POSITIONS, KEY_SYNTHESIS_TIMING, KEY_SYNTHESIS_LEFT, KEY_SYNTHESIS_RIGHT,
      KEY_SYNTHESIS_WEIGHTS, KEY_SYNTHESIS_CRANK_TURNS, KEY_SYNTHESIS_ORDER, KEY_SYNTHESIS_LENGTHS,
      KEY_SYNTHESIS_LENGTH_RATIO, KEY_COUNT}},
    {"path",
     FOURLINK_FOUR_BAR | FOURLINK_SLIDER_CRANK,
     build_path,
     {KEY_SYNTHESIS_POSITIONS, KEY_SYNTHESIS_TIMING, KEY_SYNTHESIS_LEFT, KEY_SYNTHESIS_RIGHT,
      KEY_SYNTHESIS_WEIGHTS, KEY_SYNTHESIS_CRANK_TURNS, KEY_SYNTHESIS_ORDER, KEY_SYNTHESIS_LENGTHS,
      KEY_SYNTHESIS_LENGTH_RATIO, KEY_COUNT}},
    {"quick-return",
     FLK_EVERY_KIND,
     build_quick_return,
     {KEY_SYNTHESIS_TIME_RATIO, KEY_SYNTHESIS_SWING, KEY_SYNTHESIS_STROKE, KEY_SYNTHESIS_SLOW,
      KEY_SYNTHESIS_TYPE, KEY_SYNTHESIS_CHOOSE, KEY_COUNT}},
    {"cognate", FOURLINK_FOUR_BAR, build_cognate, {KEY_SYNTHESIS_WHICH, KEY_COUNT}},
};

static int belongs(key_code key, deck_task task)
{
    const key_code *k = tasks[task].keys;

    while (*k != KEY_COUNT && *k != key)
        k++;
    return *k == key || key == KEY_SYNTHESIS_TASK || key == KEY_SYNTHESIS_MU_MIN;
}

static void refuse_others(parser *p, deck_task task)
{
    key_code key = flk_first_key(SECTION_SYNTHESIS);

    for (; key < flk_first_key(SECTION_SYNTHESIS + 1); key++)
        if (IS_SET(flk_task_find(p, key)) && !belongs(key, task))
            flk_mistake(p->mistakes, flk_task_find(p, key)->place,
                        "'%s' does not belong to task = %s", flk_key_table[key].name,
                        tasks[task].name);
}

int flk_synthesis_read(parser *p)
{
    section_use *use = flk_section_find(p, SECTION_SYNTHESIS, NULL);
    size_t before = flk_mistakes_count(p->mistakes);
    const char *words = fourlink_kind_text((int)p->d->machine.mechanism.design.kind);
    const setting *task;
    deck_synthesis *t;

    if (!p->d->solution)
        return flk_mistake(p->mistakes, use->place,
                           "[synthesis] describes a linkage that is to be found: fourlink "
                           "--synthesis finds it and prints its deck");
    if (use->is_mistaken || !flk_section_unshare(p, use))
        return 0;
    task = flk_task_find(p, KEY_SYNTHESIS_TASK);
    if (!IS_SET(task))
        return flk_mistake(p->mistakes, use->place,
                           "[synthesis] needs 'task = function', 'motion', 'path', 'quick-return' "
                           "or 'cognate'");
    t = p->d->synthesis = flk_reader_keep(p, sizeof *t);
    if (!t)
        return 0;
    t->task = (deck_task)task->word;
    t->name = tasks[t->task].name;
    if (!(tasks[t->task].kinds & (int)p->d->machine.mechanism.design.kind))
        return flk_mistake(p->mistakes, task->place, "task = %s does not exist for %s %s", t->name,
                           flk_text_article(words), words);
    for (t->kind = kinds; t->kind->kind != p->d->machine.mechanism.design.kind; t->kind++)
        ;
    t->place = use->place;
    t->mu_min = flk_setting_or(p, KEY_SYNTHESIS_MU_MIN, MU_MIN_USUAL * (M_PI / 180));
    if (IS_SET(flk_setting_find(p, KEY_UNITS_LENGTH)))
        t->length = p->d->bare[QUANTITY_LENGTH];
    refuse_others(p, t->task);
    if (!tasks[t->task].build(p) || flk_mistakes_count(p->mistakes) > before)
        return 0;
    if (!t->length.name[0])
        t->length = p->d->bare[QUANTITY_LENGTH];
    return 1;
}
