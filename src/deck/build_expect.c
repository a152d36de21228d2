/* SPDX-License-Identifier: GPL-3.0-or-later
**
** build_expect.c - builds [expect] and [misprint], the values that a source printed.
*/
#include <math.h>
#include <string.h>

#include <gsl/gsl_math.h>

#include "mechanics/kind.h"
#include "at_angle.h"
#include "build.h"
#include "parser.h"
#include "settings.h"
#include "values.h"

/* For a deck that requests one branch, keep only the answers for that branch.  If there are none, those for
** the other branch are used. */
static void keep_one_branch(deck *d)
{
    fourlink_branch asked = d->open ? FOURLINK_OPEN : FOURLINK_CROSSED;
    int is_given = 0;
    size_t i, kept = 0;

    if (d->open && d->crossed)
        return;
    for (i = 0; i < d->n_expectations; i++)
        is_given |= d->expectations[i].has_branch && d->expectations[i].branch == asked;
    for (i = 0; i < d->n_expectations; i++) {
        if (is_given && d->expectations[i].branch != asked)
            continue;
        d->expectations[kept] = d->expectations[i];
        d->expectations[kept++].branch = asked;
    }
    d->n_expectations = kept;
}

/* The row that an angle of answers means: 1.0472 rad is the row at 60 deg.  The last row can be closer
** than the others. */
static double nearest_row(const deck *d, text words, double angle)
{
    double interval = fabs(d->motion.interval), row, digit;
    quantity_value read;
    fourlink_range range;
    fourlink_abscissa over;
    char why[MESSAGE_SIZE];

    if (!(interval > 0) || flk_deck_rows(d, &range, &over) != FOURLINK_OK || !over.is_crank_angle ||
        !flk_quantity_read(words, words, QUANTITY_ANGLE, d->bare[QUANTITY_ANGLE].unit, &read, why))
        return angle;
    row = d->motion.from + interval * floor((angle - d->motion.from) / interval + 0.5);
    if (fabs(over.last - angle) < fabs(row - angle))
        row = over.last;
    digit = flk_unit_from_si(read.digit, d->units[QUANTITY_ANGLE].unit);
    return fabs(row - angle) <= 0.5 * digit * (1 + 1e-9) ? row : angle;
}

/* Where the values of a section are: at a crank angle, or at a place of what the rows go over.  Where an
** angle is prescribed, an angle is that. */
static void read_at(parser *p, const section_use *use, key_code key, deck_expectation *e)
{
    const deck *d = p->d;
    const setting *at = flk_setting_of(use, key);
    quantity q = flk_values_quantity_at(at), of_rows = flk_deck_over(d);

    if (!IS_SET(at)) {
        e->at_is_place = DECK_GOES_OVER_INPUT(d) && !d->prescribed->is_at_crank;
        e->at = e->at_is_place ? d->prescribed->motion.from : d->motion.from;
        return;
    }
    e->at_is_place = q != QUANTITY_ANGLE || (q == of_rows && !at->word && !d->over->is_crank_angle);
    e->at = e->at_is_place ? at->si[0] : flk_setting_in_unit(p, at, QUANTITY_ANGLE);
    if (p->is_answers && q == QUANTITY_ANGLE && !e->at_is_place)
        e->at = nearest_row(d, at->value, e->at);
    if (q == QUANTITY_TIME && q != of_rows)
        flk_mistake(p->mistakes, at->place,
                    "a time is for rows by time: expected a crank angle, such as 40 deg");
    else if (q == QUANTITY_LENGTH && q != of_rows)
        flk_mistake(p->mistakes, at->place, "'%t' is a length; expected an angle, such as 40 deg",
                    at->value);
}

/* NAME at ANGLE is NAME where the section has this angle. */
static void take_angle(parser *p, deck_expectation *e)
{
    char message[MESSAGE_SIZE];
    text column, angle;
    double at;

    if (!flk_at_angle_cut(e->name, &column, &angle))
        return;
    if (!flk_at_angle_read(p->d, angle, &at, message)) {
        if (!p->is_answers)
            flk_mistake(p->mistakes, e->place, "%s", message);
        return;
    }
    e->name = column;
    e->has_at = 1;
    e->at_is_place = 0;
    e->at = p->is_answers ? nearest_row(p->d, angle, at) : at;
}

/* The side of the input on which the values of a section are, if they are at a place of it. */
static int read_side(parser *p, const setting *side, const deck_expectation *e)
{
    const deck *d = p->d;
    int own = d->prescribed ? d->prescribed->side : 0;

    if (IS_SET(side) && !own && !flk_setting_find(p, KEY_MOTION_INPUT)->word)
        flk_mistake(p->mistakes, side->place, "'side' needs an input, such as input = x");
    else if (IS_SET(side) && own && !DECK_HAS_BOTH_SIDES(d) && side->word != own)
        flk_mistake(p->mistakes, side->place, "the rows are where %s is %s, not %t",
                    d->prescribed->q->words, fourlink_input_side_text(own), side->value);
    if (!DECK_HAS_BOTH_SIDES(d) || !e->at_is_place)
        return 0;
    return IS_SET(side) ? side->word : own;
}

/* Add the printed values of the deck, in line order. */
void flk_build_expectations(parser *p)
{
    deck *d = p->d;
    deck_expectation *list;
    size_t i;

    d->n_expectations = 0; /* those of the deck, if these are its answers */
    if (!p->n_named)
        return;
    d->expectations = list = flk_reader_keep(p, p->n_named * sizeof *list);
    if (!list)
        return;
    for (i = 0; i < p->n_named; i++) {
        const named_value *named = &p->named[i];
        const section_use *use = &p->uses[named->use];
        const setting *at, *branch, *side, *tolerance;
        deck_expectation *e;
        int is_misprint;

        if (use->section == SECTION_SWEEP || use->section == SECTION_GRADING)
            continue;
        is_misprint = use->section == SECTION_MISPRINT;
        at = flk_setting_of(use, is_misprint ? KEY_MISPRINT_AT : KEY_EXPECT_AT);
        branch = flk_setting_of(use, is_misprint ? KEY_MISPRINT_BRANCH : KEY_EXPECT_BRANCH);
        side = flk_setting_of(use, is_misprint ? KEY_MISPRINT_SIDE : KEY_EXPECT_SIDE);
        tolerance =
            flk_setting_of(use, is_misprint ? KEY_MISPRINT_TOLERANCE : KEY_EXPECT_TOLERANCE);
        e = &list[d->n_expectations++];
        e->place = named->place;
        e->name = named->name;
        e->value = named->value;
        e->tolerance = tolerance->value;
        e->tolerance_place = tolerance->place;
        e->misprint = is_misprint;
        e->is_answer = p->is_answers;
        e->has_at = IS_SET(at) || d->one_instant;
        read_at(p, use, is_misprint ? KEY_MISPRINT_AT : KEY_EXPECT_AT, e);
        take_angle(p, e);
        flk_build_check_branch(p, branch);
        e->has_branch = IS_SET(branch);
        e->branch = branch->word ? (branch->word == BRANCH_OPEN ? FOURLINK_OPEN : FOURLINK_CROSSED)
                    : d->open    ? FOURLINK_OPEN
                                 : FOURLINK_CROSSED;
        e->side = read_side(p, side, e);
    }
    if (p->is_answers)
        keep_one_branch(d);
}
