/* SPDX-License-Identifier: GPL-3.0-or-later
**
** write_pins.c - the [pins] of a deck by lengths, for write.c.
**
** A is the origin of the page, on which x of link 1 has the direction of [ground].  All other numbers of
** the deck keep their meaning in the axes of link 1, so that these stay its axes.
*/
#include <math.h>
#include <string.h>

#include <gsl/gsl_math.h>

#include "mechanics/kind.h"
#include "mechanics/machine.h"
#include "build_mechanism.h"
#include "numbers.h"
#include "settings.h"
#include "values.h"
#include "vector.h"
#include "write_pins.h"

/* The keys that follow from the pins, and the kinds of mechanism: a slider-crank keeps the direction of
** its line of stroke, an inverted one the line of its slide on the lever. */
static const struct {
    key_code key;
    int kinds;
} dropped[] = {{KEY_CRANK_LENGTH, ANY_KIND},
               {KEY_CRANK_STROKE, ANY_KIND},
               {KEY_GROUND_LENGTH, WITH_PIN_D},
               {KEY_GROUND_TO, WITH_PIN_D},
               {KEY_GROUND_ANGLE, WITH_PIN_D | SCOTCH_YOKE},
               {KEY_GROUND_OFFSET, WITH_STROKE},
               {KEY_COUPLER_LENGTH, ANY_KIND},
               {KEY_ROCKER_LENGTH, ANY_KIND},
               {KEY_ROD_LENGTH, ANY_KIND}};

int flk_write_drops(const deck *d, key_code key)
{
    size_t i;

    for (i = 0; i < sizeof dropped / sizeof *dropped; i++)
        if (dropped[i].key == key)
            return (dropped[i].kinds & (int)d->machine.mechanism.design.kind) != 0;
    return 0;
}

/* Without [pins] the axes are those of link 1, and both branches are meant, but with gas. */
const char *flk_write_word(parser *p, const deck *d, key_code key)
{
    if (IS_SET(flk_setting_find(p, key)))
        return NULL;
    if (key == KEY_TOP_AXES)
        return "ground";
    return key == KEY_TABLE_BRANCH &&
                   !flk_kind_of(d->machine.mechanism.design.kind)->has_one_branch &&
                   !flk_machine_count(&d->machine, &flk_gas_type)
               ? "both"
               : NULL;
}

/* What writes the places of a drawing. */
typedef struct page {
    fourlink_vector x; /* direction of x of link 1 */
    double size;       /* m, of the largest coordinate */
    unit u;
    char unit_name[DECK_NAME_SIZE];
    char *lines;
} page;

static void put_words(page *g, const char *words)
{
    strncat(g->lines, words, PINS_SIZE - 1 - strlen(g->lines));
}

static void put_coordinate(page *g, double si)
{
    char number[DIGITS_SIZE];

    if (fabs(si) <= GSL_DBL_EPSILON * g->size)
        si = 0;
    flk_number_in_unit(si, &g->u, number);
    put_words(g, number);
}

/* (x, y), of a place in the axes of link 1 */
static void put_place(page *g, fourlink_vector at)
{
    put_words(g, "(");
    put_coordinate(g, g->x.x * at.x - g->x.y * at.y);
    put_words(g, ", ");
    put_coordinate(g, g->x.y * at.x + g->x.x * at.y);
    put_words(g, ")");
}

static void put_pin(page *g, const char *name, fourlink_vector at)
{
    put_words(g, name);
    put_words(g, " = ");
    put_place(g, at);
    put_words(g, " ");
    put_words(g, g->unit_name);
    put_words(g, "\n");
}

/* guide = (x, y), (x, y) mm: from the foot of A on the line of the guide, along x */
static void put_guide(page *g, const fourlink_design *design)
{
    fourlink_vector on = {0, 0};

    on.y = design->offset;
    put_words(g, "guide = ");
    put_place(g, on);
    put_words(g, ", ");
    on.x = g->size;
    put_place(g, on);
    put_words(g, " ");
    put_words(g, g->unit_name);
    put_words(g, "\n");
}

int flk_write_pins(parser *p, const deck *d, double theta2, char lines[PINS_SIZE])
{
    const fourlink_design *design = &d->machine.mechanism.design;
    const deck_unit *bare = &d->bare[QUANTITY_LENGTH];
    int kind = (int)design->kind, status, i;
    fourlink_vector A = {0, 0};
    fourlink_state state;
    const char *word;
    text name;
    page g;

    status = fourlink_position(&d->machine.mechanism, FOURLINK_OPEN, theta2, &state);
    if (status != FOURLINK_OK)
        return status;
    flk_vector_direction(flk_build_inclination(p), &g.x.x, &g.x.y);
    g.size = fabs(design->offset);
    for (i = FOURLINK_GROUND; i <= FOURLINK_FOLLOWER; i++)
        g.size = GSL_MAX(g.size, design->link[i].length);
    if (flk_values_written_length(p, &name, &g.u)) {
        flk_text_copy(name, g.unit_name, sizeof g.unit_name);
    } else {
        strcpy(g.unit_name, bare->name);
        g.u = bare->unit;
    }
    g.lines = lines;
    lines[0] = '\0';
    put_words(&g, "\n[pins]\n");
    put_pin(&g, "A", A);
    put_pin(&g, "B", state.link[FOURLINK_COUPLER].origin);
    if (kind == FOURLINK_FOUR_BAR) {
        fourlink_vector C = state.link[FOURLINK_FOLLOWER].origin;

        C.x += design->link[FOURLINK_FOLLOWER].length * state.link[FOURLINK_FOLLOWER].axis.x;
        C.y += design->link[FOURLINK_FOLLOWER].length * state.link[FOURLINK_FOLLOWER].axis.y;
        put_pin(&g, "C", C);
    }
    if (kind == FOURLINK_SLIDER_CRANK)
        put_pin(&g, "C", state.link[FOURLINK_FOLLOWER].origin);
    if (WITH_PIN_D & kind)
        put_pin(&g, "D", state.link[FOURLINK_FOLLOWER].origin);
    if (kind == FOURLINK_SCOTCH_YOKE)
        put_guide(&g, design);
    word = flk_write_word(p, d, KEY_TABLE_BRANCH);
    if (word && !flk_section_find(p, SECTION_TABLE, NULL)) {
        put_words(&g, "\n[table]\nbranch = ");
        put_words(&g, word);
        put_words(&g, "\n");
    }
    return FOURLINK_OK;
}
