/* SPDX-License-Identifier: GPL-3.0-or-later
**
** scene_json.c - the links and tracer points of a moving drawing as JSON, for what can be dragged.
*/
#include <math.h>
#include <stdarg.h>
#include <stdlib.h>
#include <string.h>

#include <gsl/gsl_math.h>

#include "base/text.h"
#include "interactive.h"
#include "tables/json_text.h"
#include "view/geometry.h"
#include "view/tracks.h"

/* What a string in an element <script> must not have as it is, in HTML or in XML. */
#define ESCAPED "<>&"

void interactive_put(line *l, const char *format, ...)
{
    const char *end;
    va_list arguments;

    va_start(arguments, format);
    for (; *format; format = end) {
        end = *format == '%' ? format + 2 : format + strcspn(format, "%");
        if (*format != '%')
            line_text(l, format, (size_t)(end - format));
        else if (format[1] == 'q')
            json_text_put(l, va_arg(arguments, const char *), ESCAPED);
        else if (format[1] == 's')
            line_put(l, "%s", va_arg(arguments, const char *));
        else {
            line_put(l, "%lu", va_arg(arguments, unsigned long));
            end++; /* of three letters */
        }
    }
    va_end(arguments);
}

void interactive_put_comma(line *l, int *n)
{
    line_put(l, (*n)++ ? ",\n" : "\n");
}

/* ------------------------------------------------------------------------------------------------ links */

static void put_link(line *l, const rows *t, int link)
{
    const fourlink_joint *ends = &t->v.kind.joint[link - FOURLINK_CRANK];
    static const char *const shapes[] = {"", "bar", "block", "lever", "yoke"};
    int n = 0, on;
    unsigned long i;
    char name[TRACKS_NAME];

    interactive_put(l, "{\"link\":%lu,\"name\":%q,\"shape\":%q,\"pins\":[%q", (unsigned long)link,
                    t->v.kind.link[link], shapes[t->v.kind.shape[link]], ends[0].letter);
    if (!t->v.kind.slides_on[link])
        interactive_put(l, ",%q", ends[1].letter);
    line_put(l, "],\"points\":[");
    for (i = 0; i < t->v.problem.n_points; i++) {
        fourlink_vector at;

        fourlink_deck_point(t->v.deck, i, NULL, &on, &at);
        if (on == link)
            line_put(l, "%s\"%s\"", n++ ? "," : "", tracks_name("P", i, name));
    }
    line_put(l, "]");
    if (t->v.design->link[link].mass > 0)
        line_put(l, ",\"centre\":\"%s\"", tracks_name("G", (unsigned long)link, name));
    line_put(l, "}");
}

static void put_links(line *l, const rows *t)
{
    int link, n = 0;

    line_put(l, "\"links\":[");
    for (link = FOURLINK_CRANK; link <= FOURLINK_FOLLOWER; link++) {
        interactive_put_comma(l, &n);
        put_link(l, t, link);
    }
    line_put(l, "],\n");
}

/* The tracer points: the name of each, and that of its disc. */
static void put_tracers(line *l, const rows *t)
{
    char disc[TRACKS_NAME];
    const char *name;
    fourlink_vector at;
    unsigned long i;
    int on, n = 0;

    line_put(l, "\"points\":[");
    for (i = 0; i < t->v.problem.n_points; i++) {
        fourlink_deck_point(t->v.deck, i, &name, &on, &at);
        interactive_put_comma(l, &n);
        interactive_put(l, "{\"label\":[%q,\"\",\"\"],\"of\":%q}", name, tracks_name("P", i, disc));
    }
    line_put(l, "],\n");
}

/* ------------------------------------------------------------------------------------------- synthesis */

static void put_place(line *l, const rows *t, const fourlink_vector *at)
{
    line_put(l, "[");
    json_text_number(l, view_value(&t->v, QUANTITY_LENGTH, at->x), 17);
    line_put(l, ",");
    json_text_number(l, view_value(&t->v, QUANTITY_LENGTH, at->y), 17);
    line_put(l, "]");
}

/* Of a linkage found for positions: where A is in the axes of the task, and the direction of x there. */
static void put_origin(line *l, const rows *t, const fourlink_solution *x)
{
    line_put(l, "{\"origin\":");
    put_place(l, t, &x->origin);
    line_put(l, ",\"direction\":");
    json_text_number(l, x->direction, 17);
    line_put(l, "}");
}

static void put_wanted(line *l, const rows *t)
{
    fourlink_solution *found;

    line_put(l, "\"wanted\":");
    if (view_find_solution(t->v.deck, &found) && found && found->has_point)
        put_origin(l, t, found);
    else
        line_put(l, "null");
    line_put(l, ",\n");
    free(found);
}

/* ----------------------------------------------------------------------------------------------- [pins] */

/* Where A is on the page of [pins], and the direction of x of link 1 there. */
static void put_page(line *l, const rows *t)
{
    line_put(l, "\"page\":");
    if (t->v.problem.has_drawn) {
        line_put(l, "{\"A\":");
        put_place(l, t, &t->v.problem.drawn_A);
        line_put(l, ",\"direction\":");
        json_text_number(l, t->v.problem.drawn_x, 17);
        line_put(l, "},\n");
    } else {
        line_put(l, "null,\n");
    }
}

/* --------------------------------------------------------------------------------------------- the rest */

static void put_units(line *l, const rows *t)
{
    static const quantity used[] = {QUANTITY_LENGTH, QUANTITY_SPEED,  QUANTITY_ACCELERATION,
                                    QUANTITY_FORCE,  QUANTITY_TORQUE, QUANTITY_ANGLE,
                                    QUANTITY_TIME};
    int i;

    line_put(l, "\"units\":{");
    for (i = 0; i < (int)(sizeof used / sizeof used[0]); i++)
        interactive_put(l, "%s%q:%q", i ? "," : "", flk_quantities[used[i]].name,
                        t->v.units[used[i]].name);
    line_put(l, "},\n");
}

void interactive_put_scene(line *l, const rows *t)
{
    put_units(l, t);
    line_put(l, "\"turn\":");
    json_text_number(l, geometry_turn(&t->v), 17);
    line_put(l, ",\n");
    put_links(l, t);
    put_tracers(l, t);
    put_wanted(l, t);
    put_page(l, t);
}
