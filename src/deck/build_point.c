/* SPDX-License-Identifier: GPL-3.0-or-later
**
** build_point.c - builds [point] from values.
*/
#include <math.h>
#include <string.h>

#include <gsl/gsl_math.h>

#include "mechanics/kind.h"
#include "build.h"
#include "build_mechanism.h"
#include "build_place.h"
#include "build_point.h"
#include "parser.h"
#include "settings.h"

/* max(NAME.vx) must fit wherever names are stored. */
#define LONGEST_NAME 32

void flk_build_check_name(parser *p, const section_use *use, const char *columns)
{
    const char *what = flk_section_table[use->section].name;
    size_t i;

    if (!use->name.length)
        flk_mistake(p->mistakes, use->place, "%s %s needs a name: [%s %s]", flk_text_article(what),
                    what, what, use->section == SECTION_POINT ? "P" : "S");
    if (use->name.length > LONGEST_NAME)
        flk_mistake(p->mistakes, use->place, "the name of %s %s is too long",
                    flk_text_article(what), what);
    for (i = 0; i < use->name.length; i++)
        if (!flk_text_is_word(use->name.start[i])) {
            flk_mistake(p->mistakes, use->place,
                        "the name of %s %s must be one word: its columns are %s",
                        flk_text_article(what), what, columns);
            break;
        }
}

/* [point NAME] */
static void build_point(parser *p, const section_use *use, deck_point *new)
{
    static const char *const endings[DECK_POINT_COLUMNS] = {".x",  ".y",  ".vx", ".vy",
                                                            ".ax", ".ay", ".v",  ".a"};
    const setting *link = flk_setting_of(use, KEY_POINT_LINK),
                  *at = flk_setting_of(use, KEY_POINT_AT);
    size_t i;

    new->link = flk_build_check_link(p, use, link) ? link->word : 0;
    flk_build_check_name(p, use, "NAME.x, NAME.y ...");
    flk_build_point(p, at, flk_setting_of(use, KEY_POINT_PLACE), new->link, &new->at);
    new->name = flk_reader_copy(p, use->name, "");
    for (i = 0; i < DECK_POINT_COLUMNS; i++)
        new->column_names[i] = flk_reader_copy(p, use->name, endings[i]);
}

void flk_build_points(parser *p)
{
    const section_use *use = NULL;

    if (!flk_section_find(p, SECTION_POINT, NULL))
        return;
    p->d->points = flk_reader_keep(p, p->n_uses * sizeof *p->d->points);
    while (!p->out_of_memory && (use = flk_section_next(p, SECTION_POINT, use)) != NULL)
        build_point(p, use, &p->d->points[p->d->n_points++]);
}
