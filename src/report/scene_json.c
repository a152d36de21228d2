/* SPDX-License-Identifier: GPL-3.0-or-later
**
** scene_json.c - what the interactive drawing consists of, as JSON.
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
#include "view/scene.h"

#define PLACE_DIGITS 5

/* In UTF-8. */
#define PRIME "\342\200\262"
#define MINUS "\342\210\222"

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

/* Put what stands before an entry of a list; `n` counts them. */
static void put_comma(line *l, int *n)
{
    line_put(l, (*n)++ ? ",\n" : "\n");
}

/* ------------------------------------------------------------------------------------------------- links */

static void put_link(line *l, const rows *t, int link)
{
    const fourlink_joint *ends = &t->v.kind.joint[link - FOURLINK_CRANK];
    int slides = t->v.kind.slides_on[link], n = 0, on;
    const char *shape = slides                                            ? "block"
                        : t->v.kind.has_slot && link == FOURLINK_FOLLOWER ? "slot"
                                                                          : "bar";
    unsigned long i;
    char name[TRACKS_NAME];

    interactive_put(l, "{\"link\":%lu,\"name\":%q,\"shape\":%q,\"pins\":[%q", (unsigned long)link,
                    t->v.kind.link[link], shape, ends[0].letter);
    if (!slides)
        interactive_put(l, ",%q", ends[1].letter);
    line_put(l, "],\"points\":[");
    for (i = 0; i < t->v.problem.n_points; i++) {
        fourlink_vector at;

        fourlink_deck_point(t->v.deck, i, NULL, &on, &at);
        if (on == link)
            line_put(l, "%s\"%s\"", n++ ? "," : "", tracks_name("P", i, "", name));
    }
    line_put(l, "]");
    if (t->v.design->link[link].mass > 0)
        line_put(l, ",\"centre\":\"%s\"", tracks_name("G", (unsigned long)link, "", name));
    line_put(l, "}");
}

static void put_links(line *l, const rows *t)
{
    int link, n = 0;

    line_put(l, "\"links\":[");
    for (link = FOURLINK_CRANK; link <= FOURLINK_FOLLOWER; link++) {
        put_comma(l, &n);
        put_link(l, t, link);
    }
    line_put(l, "],\n");
}

/* The tracer points, which are the images without a subscript: the track of each and its name. */
static void put_tracers(line *l, const scene *s)
{
    int i, n = 0;

    line_put(l, "\"points\":[");
    for (i = 0; i < s->n_images; i++) {
        if (s->images[i].sub[0])
            continue;
        put_comma(l, &n);
        interactive_put(l, "{\"label\":[%q,\"\",\"\"],\"of\":%q}", s->images[i].name,
                        s->images[i].of);
    }
    line_put(l, "],\n");
}

static const char *truth(int is)
{
    return is ? "true" : "false";
}

/* A spring: its name and what it is, its pin, or its ends on two links. */
static void put_springs(line *l, const rows *t)
{
    fourlink_spring spring;
    char from[TRACKS_NAME], to[TRACKS_NAME];
    const char *words;
    unsigned long i;
    int n = 0;

    line_put(l, "\"springs\":[");
    for (i = 0; i < t->v.problem.n_springs; i++) {
        fourlink_deck_spring(t->v.deck, i, &words, &spring);
        put_comma(l, &n);
        interactive_put(l, "{\"label\":[%q,\"\",\"\"],\"coil\":%s,\"damper\":%s", words,
                        truth(scene_has_coil(&spring)), truth(scene_has_damper(&spring)));
        if (spring.is_torsional)
            interactive_put(l, ",\"pin\":%q}", scene_pin_of(&t->v, &spring));
        else
            interactive_put(l, ",\"ends\":[%q,%q],\"on\":[%lu,%lu]}",
                            tracks_name("K", i, "P", from), tracks_name("K", i, "Q", to),
                            (unsigned long)spring.link, (unsigned long)spring.to);
    }
    line_put(l, "],\n");
}

/* ---------------------------------------------------------------------------------------------- polygons */

/* Those sides that this mechanism has. */
static void put_sides(line *l, const rows *t, const scene_side *x)
{
    int n = 0;

    line_put(l, ",\"sides\":[");
    for (; x->name; x++) {
        if (!rows_find(t, x->of))
            continue;
        put_comma(l, &n);
        interactive_put(l, "{\"label\":[%q,%q,%q],\"from\":%q,\"to\":%q,\"of\":%q,\"pen\":%lu}",
                        x->name, x->sub, x->super, x->from, x->to, x->of, (unsigned long)x->link);
    }
    line_put(l, "]");
}

/* The images of the centres of mass and of the tracer points. */
static void put_images(line *l, const scene *s, const scene_polygon *g)
{
    int n = 0, i;

    line_put(l, ",\"images\":[");
    for (i = 0; i < s->n_images; i++) {
        put_comma(l, &n);
        interactive_put(l, "{\"label\":[%q,%q,%q],\"of\":\"%s%s\"}", s->images[i].name,
                        s->images[i].sub, *g->mark ? PRIME : "", g->of, s->images[i].of);
    }
    line_put(l, "]");
}

static void put_polygon(line *l, const rows *t, const scene *s, const scene_polygon *g)
{
    int i;

    interactive_put(l,
                    "{\"title\":\"%s polygon\",\"quantity\":%q,\"zero\":%q,\"pole\":%q,\"lines\":[",
                    g->title, flk_quantities[g->q].name, g->zero, g->sides[0].from);
    for (i = 0; i < 2 && g->lines[i][0]; i++)
        interactive_put(l, "%s[%q,%q]", i ? "," : "", g->lines[i][0], g->lines[i][1]);
    line_put(l, "]");
    put_sides(l, t, g->sides);
    put_images(l, s, g);
    line_put(l, "}");
}

/* ------------------------------------------------------------------------------------------------ forces */

static void put_forces(line *l, const char *name, const scene_force *list, int n_list)
{
    static const char *const pens[] = {"pin", "load", "inertia"};
    int n = 0, i;

    line_put(l, "\"%s\":[", name);
    for (i = 0; i < n_list; i++) {
        const scene_force *f = &list[i];
        int is_minus = f->sort == SCENE_INERTIA;
        char words[80];

        flk_text_join(words, sizeof words, MINUS, f->name + is_minus, (char *)NULL);
        put_comma(l, &n);
        interactive_put(
            l, "{\"label\":[%q,%q,\"\"],\"of\":%q,\"sign\":%s1,\"at\":%q,\"on\":%lu,\"pen\":%q%s}",
            is_minus ? words : f->name, f->sub, f->of, f->sign < 0 ? "-" : "", f->at,
            (unsigned long)f->on, pens[f->sort],
            !f->is_inner                      ? ""
            : f->load == FOURLINK_LOAD_SPRING ? ",\"inner\":true,\"spring\":true"
                                              : ",\"inner\":true");
    }
    line_put(l, "],\n");
}

/* ------------------------------------------------------------------------------ positions of a synthesis */

static fourlink_vector polar(fourlink_vector from, double length, double angle)
{
    from.x += length * cos(angle);
    from.y += length * sin(angle);
    return from;
}

static void put_place(line *l, const rows *t, const char *before, fourlink_vector at)
{
    line_put(l, "%s[", before);
    json_text_number(l, view_value(&t->v, QUANTITY_LENGTH, at.x), PLACE_DIGITS);
    line_put(l, ",");
    json_text_number(l, view_value(&t->v, QUANTITY_LENGTH, at.y), PLACE_DIGITS);
    line_put(l, "]");
}

/* The wanted coupler as a triangle with its point, or the wanted crank and output; a mark at what is
** wanted. */
static void put_position(line *l, const rows *t, const fourlink_solution *s,
                         const fourlink_precision *wanted)
{
    const fourlink_link *link = s->design.link;
    double arm = link[FOURLINK_FOLLOWER].length;
    fourlink_vector A = {0, 0}, from, to, mark;

    if (s->has_point) {
        mark = wanted->point;
        from = polar(mark, -s->point.x, wanted->theta3);
        from = polar(from, -s->point.y, wanted->theta3 + M_PI / 2);
        to = polar(from, link[FOURLINK_COUPLER].length, wanted->theta3);
        put_place(l, t, "{\"lines\":[[", mark);
        put_place(l, t, ",", from);
        put_place(l, t, ",", to);
        put_place(l, t, ",", mark);
    } else {
        put_place(l, t, "{\"lines\":[[", A);
        put_place(l, t, ",", polar(A, link[FOURLINK_CRANK].length, wanted->theta2));
        from = polar(A, link[FOURLINK_GROUND].length, 0);
        mark = polar(from, arm > 0 ? arm : t->v.lever_high, wanted->output);
        if (t->v.kind.has_stroke) {
            mark.x = wanted->output;
            mark.y = s->design.offset;
        } else {
            put_place(l, t, "],[", from);
            put_place(l, t, ",", mark);
        }
    }
    put_place(l, t, "]],\"mark\":", mark);
    line_put(l, "}");
}

/* The precision positions of a linkage found for [synthesis]; nothing for another deck. */
static void put_wanted(line *l, const rows *t)
{
    unsigned long chosen, count;
    fourlink_solution *s;
    int i, n = 0;

    if (fourlink_deck_solutions(t->v.deck, 0, NULL, &chosen, &count) != FOURLINK_OK)
        return;
    s = malloc((chosen + 1) * sizeof *s);
    if (!s)
        return;
    fourlink_deck_solutions(t->v.deck, chosen + 1, s, &chosen, &count);
    line_put(l, "\"wanted\":[");
    for (i = 0; i < s[chosen].n_positions; i++) {
        put_comma(l, &n);
        put_position(l, t, &s[chosen], &s[chosen].position[i]);
    }
    line_put(l, "],\n");
    free(s);
}

/* ----------------------------------------------------------------------------------------------- the rest */

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

/* The x axis rises by the angle `turn`, in rad; a drawing is turned by it. */
static void put_frame(line *l, const rows *t)
{
    line_put(l, "\"turn\":");
    json_text_number(l, geometry_turn(&t->v), 17);
    line_put(l, ",\"gravity\":%s,\"forced\":%s,\"supports\":[\"A\"%s],\n",
             truth(geometry_has_weight(&t->v)), truth(t->v.problem.has_forces),
             t->v.kind.has_stroke ? "" : ",\"D\"");
}

void interactive_put_scene(line *l, const rows *t)
{
    const scene_polygon *polygons = scene_polygons(&t->v);
    scene s;

    scene_find(&s, &t->v);
    put_units(l, t);
    put_frame(l, t);
    put_links(l, t);
    put_tracers(l, &s);
    put_springs(l, t);
    line_put(l, "\"polygons\":[\n");
    put_polygon(l, t, &s, &polygons[0]);
    line_put(l, ",\n");
    put_polygon(l, t, &s, &polygons[1]);
    line_put(l, "],\n");
    put_forces(l, "forces", s.forces, s.n_forces);
    put_forces(l, "torques", s.torques, s.n_torques);
    put_wanted(l, t);
}
