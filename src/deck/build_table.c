/* SPDX-License-Identifier: GPL-3.0-or-later
**
** build_table.c - builds [table] from values.
*/
#include <math.h>
#include <string.h>

#include <gsl/gsl_math.h>

#include "mechanics/kind.h"
#include "build.h"
#include "parser.h"
#include "settings.h"

void flk_build_check_branch(parser *p, const setting *branch)
{
    const flk_kind *kind = flk_kind_of(p->d->machine.mechanism.design.kind);

    if (kind->has_one_branch && IS_SET(branch) && branch->word && branch->word != BRANCH_OPEN)
        flk_mistake(p->mistakes, branch->place, "%s %s has one assembly mode: open",
                    flk_text_article(kind->words), kind->words);
}

void flk_build_table(parser *p)
{
    const setting *columns = flk_setting_find(p, KEY_TABLE_COLUMNS),
                  *digits = flk_setting_find(p, KEY_TABLE_DIGITS);
    int branches = flk_setting_find(p, KEY_TABLE_BRANCH)->word;

    flk_build_check_branch(p, flk_setting_find(p, KEY_TABLE_BRANCH));
    p->d->asks_for_both = branches == BRANCH_BOTH;
    if (flk_kind_of(p->d->machine.mechanism.design.kind)->has_one_branch)
        branches = BRANCH_OPEN;
    if (!branches && p->d->pins.branch)
        branches = p->d->pins.branch == FOURLINK_OPEN ? BRANCH_OPEN : BRANCH_CROSSED;
    if (!branches && flk_machine_count(&p->d->machine, &flk_gas_type))
        branches = BRANCH_OPEN; /* the usual branch of engines */
    p->d->open = branches != BRANCH_CROSSED;
    p->d->crossed = branches != BRANCH_OPEN;
    p->d->columns.names = columns->value;
    p->d->columns.place = columns->place;
    p->d->solver = flk_setting_find(p, KEY_TOP_SOLVER)->word;
    if (digits->si[0] > 17)
        flk_mistake(p->mistakes, digits->place, "digits must be 1 to 17, not %t", digits->value);
    else
        p->d->digits = IS_SET(digits) ? (int)digits->si[0] : 6;
}
