/* SPDX-License-Identifier: GPL-3.0-or-later
**
** build_grading.c - builds [grading]: tolerances, marks and digits that hold whatever answers say.
*/
#include <math.h>
#include <string.h>

#include <gsl/gsl_math.h>

#include "base/cycle.h"
#include "base/number.h"
#include "at_angle.h"
#include "build.h"
#include "build_grading.h"
#include "deck.h"
#include "parser.h"
#include "settings.h"

int flk_rule_tolerance(const deck *d, text item, quantity q, int *is_percent, double *tolerance)
{
    char why[MESSAGE_SIZE];
    quantity_value value;

    *is_percent = item.length > 0 && item.start[item.length - 1] == '%';
    if (*is_percent) {
        item.length--;
        q = QUANTITY_NUMBER;
    } else if (!flk_quantity_unit_text(item).length) {
        return 0; /* such as the 1 of "1,5 %" */
    }
    item = flk_text_trim(item);
    if (!flk_quantity_read(item, item, q, d->bare[q].unit, &value, why) || !(value.si >= 0))
        return 0;
    *tolerance = value.si;
    return 1;
}

#define SAME_ANGLE 1e-9 /* rad */

int flk_rule_is_for(const deck *d, const deck_rule *rule, const deck_expectation *e)
{
    const deck_unit *u = &d->units[QUANTITY_ANGLE];
    text name = rule->name, angle;
    char message[MESSAGE_SIZE];
    double at = e->at;

    angle.start = NULL;
    if (flk_at_angle_cut(rule->name, &name, &angle) &&
        (!e->has_at || e->at_is_place || !flk_at_angle_read(d, angle, &at, message)))
        return 0;
    return name.length == e->name.length && memcmp(name.start, e->name.start, name.length) == 0 &&
           fabs(flk_cycle_beside(flk_unit_to_si(at - e->at, u->unit), 2 * M_PI)) <= SAME_ANGLE;
}

/* A tolerance in per cent, or of some quantity. */
static int is_tolerance(const deck *d, text item)
{
    double tolerance;
    int q, is_percent;

    for (q = 0; q < QUANTITY_COUNT; q++)
        if (flk_rule_tolerance(d, item, (quantity)q, &is_percent, &tolerance))
            return 1;
    return 0;
}

int flk_rule_marks(text item, double *marks)
{
    text words = item;
    double number;

    if (flk_number_read(&words, &number) != NUMBER_OK || !(number >= 0))
        return 0;
    words = flk_text_trim(words);
    if (!flk_text_equal(words, "marks") && !flk_text_equal(words, "mark"))
        return 0;
    *marks = number;
    return 1;
}

static void add_rule(parser *p, text name, text items, text_place place)
{
    deck_rule *rule = &p->d->rules[p->d->n_rules++];
    text rest = flk_reader_plain(p, items), item;
    double marks;

    rule->name = name;
    rule->items = rest;
    rule->place = place;
    while (rest.start) {
        flk_text_split(&rest, ',', &item);
        item = flk_text_trim(item);
        if (is_tolerance(p->d, item) || (name.length && flk_rule_marks(item, &marks)))
            continue;
        flk_mistake(p->mistakes, place,
                    name.length
                        ? "expected a tolerance or marks, such as 1 %%, 0.5 deg or 2 marks, "
                          "not '%t'"
                        : "expected tolerances, such as 1 %% or 1 %%, 0.5 deg, not '%t'",
                    item);
        return;
    }
}

/* Note a rule for a name that the deck's own [expect] does not have. */
static void note_unused(parser *p, const deck_rule *rule)
{
    const deck *d = p->d;
    size_t i;

    for (i = 0; i < d->n_expectations; i++)
        if (flk_rule_is_for(d, rule, &d->expectations[i]))
            return;
    flk_mistake(&p->d->notes, rule->place, "no value of [expect] has the name '%t'", rule->name);
}

void flk_build_grading(parser *p)
{
    const setting *tolerance = flk_setting_find(p, KEY_GRADING_TOLERANCE);
    const setting *digits = flk_setting_find(p, KEY_GRADING_DIGITS);
    const text none = {"", 0};
    size_t i;

    p->d->n_rules = 0;
    p->d->rules = flk_reader_keep(p, (p->n_named + 1) * sizeof *p->d->rules);
    if (!p->d->rules)
        return;
    for (i = 0; i < p->n_named; i++)
        if (p->uses[p->named[i].use].section == SECTION_GRADING)
            add_rule(p, p->named[i].name, p->named[i].value, p->named[i].place);
    for (i = 0; i < p->d->n_rules && p->d->n_expectations; i++)
        note_unused(p, &p->d->rules[i]);
    if (IS_SET(tolerance))
        add_rule(p, none, tolerance->value, tolerance->place);
    p->d->late = flk_setting_or(p, KEY_GRADING_LATE, 0);
    p->d->shows_answers = flk_setting_find(p, KEY_GRADING_FEEDBACK)->word;
    p->d->is_strict = flk_setting_find(p, KEY_GRADING_UNITS)->word;
    flk_text_copy(flk_setting_find(p, KEY_GRADING_TEXT)->value, p->d->task, sizeof p->d->task);
    p->d->is_half_for_hint = flk_setting_find(p, KEY_GRADING_HINT)->word;
    p->d->decimal = flk_setting_find(p, KEY_GRADING_DECIMAL)->word;
    p->d->fewest_digits = IS_SET(digits) ? digits->si[0] : 0;
}
