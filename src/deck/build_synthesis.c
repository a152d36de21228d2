/* SPDX-License-Identifier: GPL-3.0-or-later
**
** build_synthesis.c - builds the task of [synthesis] from values.
*/
#include <string.h>

#include <gsl/gsl_math.h>

#include "mechanics/kind.h"
#include "task.h"

#define POSITIONS 3 /* of motion and path */

/* The tasks that have a key, in the order of the schema: 1 << TASK_FUNCTION ... */
enum {
    F = 1 << TASK_FUNCTION,
    M = 1 << TASK_MOTION,
    P = 1 << TASK_PATH,
    Q = 1 << TASK_QUICK_RETURN,
    C = 1 << TASK_COGNATE,
    EVERY = F | M | P | Q | C
};
static const int tasks_with[] = {EVERY, F, F,     F, F, F, F, F, F, F, M | P,
                                 P,     M, M | P, Q, Q, Q, Q, Q, Q, C, EVERY};

static void refuse_others(parser *p)
{
    key_code first = flk_first_key(SECTION_SYNTHESIS), k;

    for (k = first; k < flk_first_key(SECTION_SYNTHESIS + 1); k++)
        if (IS_SET(flk_task_find(p, k)) && !(tasks_with[k - first] & 1 << flk_task_of(p)->task))
            flk_mistake(p->mistakes, flk_task_find(p, k)->place,
                        "'%s' does not belong to task = %s", flk_key_table[k].name,
                        flk_task_names[flk_task_of(p)->task]);
}

/* Positions of the coupler; `n_angles` is how many have an angle. */
static int read_positions(parser *p, fourlink_vector at[POSITIONS], double angle[POSITIONS],
                          int *n_angles)
{
    setting *s = flk_task_find(p, KEY_SYNTHESIS_POSITIONS);
    text rest = s->value, item, after;
    int n = 0;

    *n_angles = 0;
    while (flk_curve_text_item(&rest, &item)) {
        if (n == POSITIONS || !flk_task_point(p, s, item, &at[n], &after))
            break;
        if (after.length && !flk_values_piece(p, s, after, QUANTITY_ANGLE, &angle[n]))
            return 0;
        *n_angles += after.length > 0;
        n++;
    }
    return (n == POSITIONS && !rest.start) ||
           flk_task_refuse(
               p, KEY_SYNTHESIS_POSITIONS,
               "three positions, such as (0, 0) mm 0 deg, (24, 10) mm -30 deg, (40, 5) mm -50 "
               "deg");
}

/* fixed (0.5, 3.5) mm; moving (4, 1) mm; rotations 20 deg 50 deg */
static int read_dyad(parser *p, key_code key, fourlink_dyad *dyad)
{
    static const char *const words[] = {"fixed", "moving", "rotations", NULL};
    setting *s = flk_task_find(p, key);
    text word = s->value, rest;
    point pair;
    int i;

    flk_section_split(&word, &rest);
    for (i = 0; words[i] && !flk_text_equal(word, words[i]); i++)
        ;
    dyad->choice = (fourlink_choice)(FOURLINK_FIXED_PIVOT + i);
    if (!words[i])
        return flk_mistake(p->mistakes, s->place,
                           "expected fixed (x, y) mm, moving (x, y) mm or rotations 20 deg 50 deg, "
                           "not '%t'%h",
                           s->value, flk_text_nearest(word, words));
    if (dyad->choice != FOURLINK_ROTATIONS)
        return flk_task_point(p, s, rest, &dyad->pivot, &word) &&
               (!word.length ||
                flk_mistake(p->mistakes, s->place,
                            "expected one point, such as (24, 10) mm, not '%t'", rest));
    memset(&pair, 0, sizeof pair);
    p->argument = QUANTITY_ANGLE;
    if (!flk_curve_point_read(p, s, rest, QUANTITY_ANGLE, 0, &pair))
        return 0;
    dyad->rotation[0] = pair.x;
    dyad->rotation[1] = pair.y[0];
    return 1;
}

/* -------------------------------------------------------------------------------- motion and path */

static const char dyad_example[] = "fixed (50, 0) mm";
static const char positions_example[] = "(0, 0) mm 0 deg, (24, 10) mm -30 deg, (40, 5) mm -50 deg";

static int build_motion(parser *p)
{
    fourlink_motion_task *m = &flk_task_of(p)->motion;
    int n_angles;

    flk_task_refuse_lengths(p, 0, "no lengths");
    if (!flk_task_require(p, KEY_SYNTHESIS_POSITIONS, positions_example) ||
        !flk_task_require(p, KEY_SYNTHESIS_LEFT, dyad_example) ||
        !flk_task_require(p, KEY_SYNTHESIS_RIGHT, dyad_example) ||
        !read_positions(p, m->point, m->angle, &n_angles))
        return 0;
    if (n_angles < POSITIONS)
        return flk_mistake(p->mistakes, flk_task_find(p, KEY_SYNTHESIS_POSITIONS)->place,
                           "each position needs an angle of the coupler, such as (24, 10) mm -30 "
                           "deg");
    return read_dyad(p, KEY_SYNTHESIS_LEFT, &m->left) &
           read_dyad(p, KEY_SYNTHESIS_RIGHT, &m->right);
}

static int build_path(parser *p)
{
    fourlink_path_task *t = &flk_task_of(p)->path;
    double angle[POSITIONS] = {0, 0, 0};
    int n_angles;

    flk_task_refuse_lengths(p, 0, "no lengths");
    if (!flk_task_require(p, KEY_SYNTHESIS_POSITIONS, positions_example) ||
        !flk_task_require(p, KEY_SYNTHESIS_TIMING, "40 deg, 85 deg") ||
        !flk_task_require(p, KEY_SYNTHESIS_RIGHT, dyad_example) ||
        !read_positions(p, t->point, angle, &n_angles))
        return 0;
    if (n_angles != 0 && n_angles != POSITIONS)
        return flk_mistake(p->mistakes, flk_task_find(p, KEY_SYNTHESIS_POSITIONS)->place,
                           "give the angle of the coupler at all positions, or at none: then they "
                           "are searched for");
    t->search = n_angles == 0;
    t->rotation[0] = angle[1] - angle[0];
    t->rotation[1] = angle[2] - angle[0];
    if (flk_task_list(p, KEY_SYNTHESIS_TIMING, QUANTITY_ANGLE, POSITIONS - 1, t->timing) !=
        POSITIONS - 1)
        return flk_task_refuse(
            p, KEY_SYNTHESIS_TIMING,
            "the crank's rotations from the first position to the second and third, such "
            "as 40 deg, 85 deg");
    return read_dyad(p, KEY_SYNTHESIS_RIGHT, &t->right);
}

/* ---------------------------------------------------------------------------------- quick return */

static int build_quick_return(parser *p)
{
    fourlink_quick_return_task *t = &flk_task_of(p)->quick_return;
    const setting *swing = flk_task_find(p, KEY_SYNTHESIS_SWING),
                  *stroke = flk_task_find(p, KEY_SYNTHESIS_STROKE),
                  *type = flk_task_find(p, KEY_SYNTHESIS_TYPE),
                  *choose = flk_task_find(p, KEY_SYNTHESIS_CHOOSE),
                  *ratio = flk_task_find(p, KEY_SYNTHESIS_TIME_RATIO),
                  *offset = flk_setting_find(p, KEY_GROUND_OFFSET);
    fourlink_kind kind = p->d->design.kind;
    int n = flk_task_lengths(p, t->length), is_lever = kind == FOURLINK_INVERTED_SLIDER_CRANK;
    int most = kind == FOURLINK_SLIDER_CRANK ? 1 : 2;

    t->type = kind == FOURLINK_FOUR_BAR       ? FOURLINK_CRANK_ROCKER
              : kind == FOURLINK_SLIDER_CRANK ? FOURLINK_ENGINE
              : type->word                    ? (fourlink_type)type->word
                                              : FOURLINK_SLOTTED_LEVER;
    if (is_lever && !IS_SET(offset))
        offset = flk_setting_find(p, KEY_LEVER_OFFSET);
    if (IS_SET(offset) && offset->si[0] == 0 && !is_lever)
        return flk_mistake(p->mistakes, offset->place,
                           "an offset of 0 has a time ratio of 1: remove it, it is found");
    n += IS_SET(offset) && !is_lever;
    flk_task_refuse_lengths(p, most,
                            kind == FOURLINK_FOUR_BAR ? "two lengths, or one and choose = best"
                            : kind == FOURLINK_SLIDER_CRANK
                                ? "the crank, the rod or the offset, or none"
                                : "the ground or the crank, and the lever");
    if (IS_SET(choose) && n > most - 1)
        flk_mistake(p->mistakes, choose->place, "with choose = best, %s: give fewer lengths",
                    kind == FOURLINK_FOUR_BAR ? "one length is given" : "no length is given");
    if (kind == FOURLINK_FOUR_BAR && !n)
        flk_mistake(p->mistakes, flk_task_of(p)->place,
                    "the crank-rocker needs two lengths, or one for the best transmission angle");
    if (t->type == FOURLINK_CRANK_ROCKER && !flk_task_require(p, KEY_SYNTHESIS_SWING, "50 deg"))
        return 0;
    if (t->type == FOURLINK_ENGINE && !flk_task_require(p, KEY_SYNTHESIS_STROKE, "100 mm"))
        return 0;
    if (t->type == FOURLINK_WHITWORTH && (IS_SET(swing) || IS_SET(stroke)))
        return flk_mistake(p->mistakes, (IS_SET(swing) ? swing : stroke)->place,
                           "the lever of a Whitworth mechanism turns fully: give the time_ratio");
    if ((t->type != FOURLINK_SLOTTED_LEVER || !IS_SET(swing)) &&
        !flk_task_require(p, KEY_SYNTHESIS_TIME_RATIO, "1.2"))
        return 0;
    if (t->type == FOURLINK_SLOTTED_LEVER && IS_SET(swing) && IS_SET(ratio))
        return flk_mistake(p->mistakes, swing->place,
                           "the swing of a slotted lever follows from the time_ratio: give one of "
                           "them");
    if (IS_SET(ratio) && ratio->si[0] < 1)
        return flk_mistake(p->mistakes, ratio->place,
                           "a time ratio is at least 1: slow stroke / quick stroke, in time; which "
                           "is slow is said by 'slow'");
    if (IS_SET(stroke))
        flk_task_unit(p, flk_quantity_unit_text(stroke->value));
    if (IS_SET(offset))
        flk_task_unit(p, flk_quantity_unit_text(offset->value));
    t->time_ratio = ratio->si[0];
    t->swing = swing->si[0];
    t->stroke = stroke->si[0];
    t->offset = offset->si[0];
    t->slow = flk_task_find(p, KEY_SYNTHESIS_SLOW)->word;
    return 1;
}

/* --------------------------------------------------------------------------------------- cognate */

/* The first point of the coupler. */
static const section_use *coupler_point(const parser *p)
{
    size_t i;

    for (i = 0; i < p->n_uses; i++)
        if (p->uses[i].section == SECTION_POINT &&
            flk_setting_of(&p->uses[i], KEY_POINT_LINK)->word == FOURLINK_COUPLER)
            return &p->uses[i];
    return NULL;
}

static int build_cognate(parser *p)
{
    fourlink_cognate_task *t = &flk_task_of(p)->cognate;
    const section_use *at = coupler_point(p);
    double length[5];
    int i;

    if (!flk_task_require(p, KEY_SYNTHESIS_WHICH, "left"))
        return 0;
    if (flk_task_lengths(p, length) < 4)
        return flk_mistake(p->mistakes, flk_task_of(p)->place,
                           "task = cognate needs the lengths of all four links");
    if (!at)
        return flk_mistake(p->mistakes, flk_task_of(p)->place,
                           "task = cognate needs a [point] of the coupler, which it traces");
    t->design.kind = p->d->design.kind;
    for (i = FOURLINK_GROUND; i <= FOURLINK_FOLLOWER; i++)
        t->design.link[i].length = p->d->design.link[i].length = length[i];
    flk_build_place(p, flk_setting_of(at, KEY_POINT_AT), FOURLINK_COUPLER, &t->point);
    t->branch = flk_setting_find(p, KEY_TABLE_BRANCH)->word == BRANCH_CROSSED ? FOURLINK_CROSSED
                                                                              : FOURLINK_OPEN;
    t->side = (fourlink_side)flk_task_find(p, KEY_SYNTHESIS_WHICH)->word;
    t->from = flk_setting_or(p, KEY_MOTION_FROM, 0);
    t->to = flk_setting_or(p, KEY_MOTION_TO, t->from);
    return 1;
}

/* ------------------------------------------------------------------------------------------- all */

static int build_task(parser *p)
{
    switch (flk_task_of(p)->task) {
    case TASK_FUNCTION:
        return flk_task_function(p);
    case TASK_MOTION:
        return build_motion(p);
    case TASK_PATH:
        return build_path(p);
    case TASK_QUICK_RETURN:
        return build_quick_return(p);
    case TASK_COGNATE:
    default:
        return build_cognate(p);
    }
}

/* 1 if this kind of mechanism has the task; 0 and a mistake. */
static int has_task(parser *p, const setting *task)
{
    static const int kinds[] = {0,
                                FOURLINK_FOUR_BAR | FOURLINK_SLIDER_CRANK,
                                FOURLINK_FOUR_BAR,
                                FOURLINK_FOUR_BAR,
                                FLK_EVERY_KIND,
                                FOURLINK_FOUR_BAR};
    const char *words = fourlink_kind_text((int)p->d->design.kind);

    return (kinds[task->word] & (int)p->d->design.kind) != 0 ||
           flk_mistake(p->mistakes, task->place, "task = %s does not exist for %s %s",
                       flk_task_names[task->word], flk_text_article(words), words);
}

int flk_synthesis_read(parser *p)
{
    section_use *use = flk_section_find(p, SECTION_SYNTHESIS, NULL);
    size_t before = flk_mistakes_count(p->mistakes);
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
    if (!t || !has_task(p, task))
        return 0;
    t->task = (deck_task)task->word;
    t->place = use->place;
    t->mu_min = flk_setting_or(p, KEY_SYNTHESIS_MU_MIN, MU_MIN_USUAL * (M_PI / 180));
    if (IS_SET(flk_setting_find(p, KEY_UNITS_LENGTH)))
        t->length = p->d->bare[QUANTITY_LENGTH];
    refuse_others(p);
    if (!build_task(p) || flk_mistakes_count(p->mistakes) > before)
        return 0;
    if (!t->length.name[0])
        t->length = p->d->bare[QUANTITY_LENGTH];
    return 1;
}
