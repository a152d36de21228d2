/* SPDX-License-Identifier: GPL-3.0-or-later
**
** scene.c - what the interactive drawing consists of, as JSON.
*/
#include <math.h>

#include "scene.h"
#include "tables/json_text.h"
#include "view/geometry.h"

/* In UTF-8. */
#define PRIME "\342\200\262"
#define MINUS "\342\210\222"
#define ALPHA "\316\261"
#define SUB_4 "\342\202\204"

/* Of the links, and of the joints. */
static const char *const numbers[] = {"", "1", "2", "3", "4"};
static const char *const joints[] = {"A", "B", "C", "D"};

enum { JOINT_C = 2, JOINT_D };

/* Put what stands before an entry of a list; `n` counts them. */
static void put_comma(line *l, int *n)
{
    line_put(l, (*n)++ ? ",\n" : "\n");
}

static void put_string(line *l, const char *s)
{
    json_text_put(l, s, SCENE_ESCAPED);
}

static void put_text(line *l, const char *name, const char *s)
{
    line_put(l, ",\"%s\":", name);
    put_string(l, s);
}

/* Begin an object with a label: a name, its subscript and its superscript. */
static void put_label(line *l, const char *name, const char *sub, const char *super)
{
    line_put(l, "{\"label\":[");
    put_string(l, name);
    line_put(l, ",");
    put_string(l, sub);
    line_put(l, ",");
    put_string(l, super);
    line_put(l, "]");
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

    line_put(l, "{\"link\":%lu", (unsigned long)link);
    put_text(l, "name", t->v.kind.link[link]);
    put_text(l, "shape", shape);
    line_put(l, ",\"pins\":[\"%s\"", ends[0].letter);
    if (!slides)
        line_put(l, ",\"%s\"", ends[1].letter);
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

/* The tracer points: the track of each and its name. */
static void put_tracers(line *l, const rows *t)
{
    const char *words;
    char name[TRACKS_NAME];
    unsigned long i;
    fourlink_vector at;
    int link, n = 0;

    line_put(l, "\"points\":[");
    for (i = 0; i < t->v.problem.n_points; i++) {
        fourlink_deck_point(t->v.deck, i, &words, &link, &at);
        put_comma(l, &n);
        put_label(l, words, "", "");
        line_put(l, ",\"of\":\"%s\"}", tracks_name("P", i, "", name));
    }
    line_put(l, "],\n");
}

/* The pin at which a torsional spring is: that of its links, or the first link's origin. */
static const char *pin_of(const rows *t, const fourlink_spring *spring)
{
    static const int pins[5][5] = {
        {0, 0, 0, 0, 0}, {0, 0, 0, 1, 3}, {0, 0, 0, 1, 0}, {0, 1, 1, 0, 2}, {0, 3, 3, 2, 0}};

    return t->v.kind.joint[pins[spring->link][spring->to]].letter;
}

/* A spring: its name and what it is, its pin, or its ends on two links. */
static void put_springs(line *l, const rows *t)
{
    fourlink_spring spring;
    char name[TRACKS_NAME];
    const char *words;
    unsigned long i;
    int n = 0;

    line_put(l, "\"springs\":[");
    for (i = 0; i < t->v.problem.n_springs; i++) {
        fourlink_deck_spring(t->v.deck, i, &words, &spring);
        put_comma(l, &n);
        put_label(l, words, "", "");
        line_put(l, ",\"coil\":%s,\"damper\":%s",
                 spring.stiffness != 0 || !(spring.damping > 0) ? "true" : "false",
                 spring.damping > 0 ? "true" : "false");
        if (spring.is_torsional) {
            line_put(l, ",\"pin\":\"%s\"}", pin_of(t, &spring));
            continue;
        }
        line_put(l, ",\"ends\":[\"%s\",", tracks_name("K", i, "P", name));
        line_put(l, "\"%s\"],\"on\":[%lu,%lu]}", tracks_name("K", i, "Q", name),
                 (unsigned long)spring.link, (unsigned long)spring.to);
    }
    line_put(l, "],\n");
}

/* ---------------------------------------------------------------------------------------------- polygons */

/* A side from one corner to another; corners whose names begin with _ have no letter. */
typedef struct side {
    const char *name, *sub, *super, *from, *to, *of;
    int pen; /* the number of a link; 5: neither */
} side;

static const side velocities[] = {{"v", "B", "", "o", "b", "vB", 2},
                                  {"v", "C", "", "o", "c", "vC", 4},
                                  {"v", "CB", "", "b", "c", "vCB", 3},
                                  {NULL, NULL, NULL, NULL, NULL, NULL, 0}};

static const side sliding[] = {{"v", "B", "", "o", "b", "vB", 2},
                               {"v", "B4", "", "o", "b" SUB_4, "vB4", 4},
                               {"v", "BB4", "", "b" SUB_4, "b", "vS", 3},
                               {NULL, NULL, NULL, NULL, NULL, NULL, 0}};

static const side accelerations[] = {
    {"a", "B", "n", "o" PRIME, "_b", "aBn", 2},    {"a", "B", "t", "_b", "b" PRIME, "aBt", 2},
    {"a", "CB", "n", "b" PRIME, "_c", "aCBn", 3},  {"a", "CB", "t", "_c", "c" PRIME, "aCBt", 3},
    {"a", "C", "n", "o" PRIME, "_d", "aCn", 4},    {"a", "C", "t", "_d", "c" PRIME, "aCt", 4},
    {"a", "C", "", "o" PRIME, "c" PRIME, "aC", 4}, {NULL, NULL, NULL, NULL, NULL, NULL, 0}};

static const side coriolis[] = {{"a", "B", "n", "o" PRIME, "_b", "aBn", 2},
                                {"a", "B", "t", "_b", "b" PRIME, "aBt", 2},
                                {"a", "B4", "n", "o" PRIME, "_n", "aB4n", 4},
                                {"a", "B4", "t", "_n", "b" SUB_4 PRIME, "aB4t", 4},
                                {"a", "Cor", "", "b" SUB_4 PRIME, "_k", "aK", 5},
                                {"a", "BB4", "", "_k", "b" PRIME, "aS", 3},
                                {NULL, NULL, NULL, NULL, NULL, NULL, 0}};

/* Those sides that this mechanism has: an entry needs its track. */
static void put_sides(line *l, const rows *t, const side *x)
{
    int n = 0;

    line_put(l, ",\"sides\":[");
    for (; x->name; x++) {
        if (!rows_find(t, x->of))
            continue;
        put_comma(l, &n);
        put_label(l, x->name, x->sub, x->super);
        line_put(l, ",\"from\":\"%s\",\"to\":\"%s\",\"of\":\"%s\",\"pen\":%lu}", x->from, x->to,
                 x->of, (unsigned long)x->pen);
    }
    line_put(l, "]");
}

/* The images of the centres of mass and of the tracer points. */
static void put_images(line *l, const rows *t, const char *before, const char *prime)
{
    char name[TRACKS_NAME];
    const char *words;
    fourlink_vector at;
    unsigned long i;
    int link, n = 0;

    line_put(l, ",\"images\":[");
    for (link = FOURLINK_CRANK; link <= FOURLINK_FOLLOWER; link++)
        if (t->v.design->link[link].mass > 0) {
            put_comma(l, &n);
            put_label(l, "g", numbers[link], prime);
            line_put(l, ",\"of\":\"%sG%s\"}", before, numbers[link]);
        }
    for (i = 0; i < t->v.problem.n_points; i++) {
        fourlink_deck_point(t->v.deck, i, &words, &link, &at);
        put_comma(l, &n);
        put_label(l, words, "", prime);
        line_put(l, ",\"of\":\"%s%s\"}", before, tracks_name("P", i, "", name));
    }
    line_put(l, "]");
}

static void put_polygons(line *l, const rows *t)
{
    line_put(l, "\"polygons\":[\n{\"title\":\"Velocity polygon\",\"quantity\":\"speed\","
                "\"zero\":\"all velocities are zero\",\"pole\":\"o\",\"lines\":[]");
    put_sides(l, t, t->v.kind.has_slot ? sliding : velocities);
    put_images(l, t, "v", "");
    line_put(l, "},\n{\"title\":\"Acceleration polygon\",\"quantity\":\"acceleration\","
                "\"zero\":\"all accelerations are zero\",\"pole\":\"o" PRIME "\",\"lines\":[");
    if (t->v.kind.has_slot)
        line_put(l, "[\"o" PRIME "\",\"b" PRIME "\"],[\"o" PRIME "\",\"b" SUB_4 PRIME "\"]]");
    else
        line_put(l, "[\"o" PRIME "\",\"c" PRIME "\"],[\"b" PRIME "\",\"c" PRIME "\"]]");
    put_sides(l, t, t->v.kind.has_slot ? coriolis : accelerations);
    put_images(l, t, "a", PRIME);
    line_put(l, "}],\n");
}

/* ------------------------------------------------------------------------------------------------ forces */

/* The force of a track on a link at a point; `pen` is pin, load or inertia.  A reaction has the sign -1; with INNER,
** a load has "inner".  These are not in the drawing of the mechanism. */
enum { INNER = 2 };

static void put_force(line *l, int *n, const char *name, const char *sub, const char *of, int sign,
                      const char *at, int on, const char *pen)
{
    put_comma(l, n);
    put_label(l, name, sub, "");
    line_put(l, ",\"of\":\"%s\",\"sign\":%s1,\"at\":\"%s\",\"on\":%lu,\"pen\":\"%s\"%s}", of,
             sign < 0 ? "-" : "", at, (unsigned long)on, pen,
             sign == INNER ? ",\"inner\":true" : "");
}

/* 1 for the friction of a slider on its lever, which F34 has. */
static int is_in_F34(const rows *t, const fourlink_load_info *load)
{
    return t->v.kind.has_slot && load->sort == FOURLINK_LOAD_FRICTION && load->element == JOINT_C;
}

/* Springs are drawn as such; friction acts between links, but for that of a piston in its guide. */
static int sense_of_load(const rows *t, const fourlink_load_info *load)
{
    if (load->sort == FOURLINK_LOAD_FRICTION)
        return t->v.kind.has_stroke && load->element == JOINT_D ? 1 : INNER;
    return load->sort == FOURLINK_LOAD_SPRING ? INNER : 1;
}

static void put_pin_forces(line *l, const rows *t, int *n)
{
    const char *C = t->v.kind.joint[JOINT_C].letter, *D = t->v.kind.joint[JOINT_D].letter;

    put_force(l, n, "F", "12", "F12", 1, "A", 2, "pin");
    put_force(l, n, "F", "32", "F23", -1, "B", 2, "pin");
    put_force(l, n, "F", "23", "F23", 1, "B", 3, "pin");
    put_force(l, n, "F", "43", "F34", -1, C, 3, "pin");
    put_force(l, n, "F", "34", "F34", 1, C, 4, "pin");
    put_force(l, n, t->v.kind.has_stroke ? "N" : "F", t->v.kind.has_stroke ? "" : "14", "F14", 1, D,
              4, "pin");
}

static void put_body_forces(line *l, const rows *t, int *n)
{
    char at[TRACKS_NAME], of[TRACKS_NAME];
    unsigned long link;

    for (link = FOURLINK_CRANK; link <= FOURLINK_FOLLOWER; link++) {
        if (t->v.design->link[link].mass <= 0)
            continue;
        tracks_name("G", link, "", at);
        put_force(l, n, "W", numbers[link], tracks_name("W", link, "", of), 1, at, (int)link, "load");
        put_force(l, n, MINUS "m a", at, tracks_name("I", link, "F", of), 1, at, (int)link,
                  "inertia");
    }
}

static void put_forces(line *l, const rows *t)
{
    char at[TRACKS_NAME], of[TRACKS_NAME];
    fourlink_load_info load;
    unsigned long i;
    int n = 0;

    line_put(l, "\"forces\":[");
    if (t->v.problem.has_forces) {
        put_pin_forces(l, t, &n);
        put_body_forces(l, t, &n);
    }
    for (i = 0; fourlink_deck_load(t->v.deck, i, &load) == FOURLINK_OK; i++)
        if (!is_in_F34(t, &load))
            put_force(l, &n, load.name, "", tracks_name("L", i, "F", of), sense_of_load(t, &load),
                      tracks_name("L", i, "", at), load.link, "load");
    line_put(l, "],\n");
}

static void put_torques(line *l, const rows *t)
{
    static const int origins[] = {0, 0, 0, 1, JOINT_D}; /* of the links */
    char at[TRACKS_NAME], of[TRACKS_NAME];
    fourlink_load_info load;
    unsigned long i;
    int n = 0;

    line_put(l, "\"torques\":[");
    if (t->v.problem.has_forces)
        put_force(l, &n, "T", "s", "Ts", 1, "A", 2, "pin");
    if (t->v.problem.has_forces && t->v.kind.has_slot) {
        put_force(l, &n, "M", "43", "M34", -1, "B", 3, "pin");
        put_force(l, &n, "M", "34", "M34", 1, "B", 4, "pin");
    }
    if (t->v.problem.has_forces && t->v.kind.has_stroke)
        put_force(l, &n, "M", "14", "M14", 1, "C", 4, "pin");
    for (i = FOURLINK_CRANK; i <= FOURLINK_FOLLOWER && t->v.problem.has_forces; i++)
        if (t->v.design->link[i].mass > 0 && t->v.design->link[i].inertia > 0)
            put_force(l, &n, MINUS "I" ALPHA, numbers[i], tracks_name("I", i, "T", of), 1,
                      tracks_name("G", i, "", at), (int)i, "inertia");
    for (i = 0; fourlink_deck_load(t->v.deck, i, &load) == FOURLINK_OK; i++)
        if (load.sort == FOURLINK_LOAD_FRICTION)
            put_force(l, &n, "M", joints[load.element], tracks_name("L", i, "T", of), INNER,
                      joints[load.element], load.link, "load");
        else
            put_force(l, &n, load.name, "", tracks_name("L", i, "T", of), sense_of_load(t, &load),
                      t->v.kind.joint[origins[load.link]].letter, load.link, "load");
    line_put(l, "],\n");
}

/* ----------------------------------------------------------------------------------------------- the rest */

static void put_units(line *l, const rows *t)
{
    static const quantity used[] = {QUANTITY_LENGTH, QUANTITY_SPEED,  QUANTITY_ACCELERATION,
                                    QUANTITY_FORCE,  QUANTITY_TORQUE, QUANTITY_ANGLE,
                                    QUANTITY_TIME};
    int i;

    line_put(l, "\"units\":{");
    for (i = 0; i < (int)(sizeof used / sizeof used[0]); i++) {
        line_put(l, "%s\"%s\":", i ? "," : "", flk_quantities[used[i]].name);
        put_string(l, t->v.units[used[i]].name);
    }
    line_put(l, "},\n");
}

/* The x axis rises by the angle `turn`, in rad; a drawing is turned by it. */
static void put_frame(line *l, const rows *t)
{
    line_put(l, "\"turn\":");
    json_text_number(l, geometry_turn(&t->v), 17);
    line_put(l, ",\"gravity\":%s,\"forced\":%s,\"supports\":[\"A\"%s],\n",
             geometry_has_weight(&t->v) ? "true" : "false",
             t->v.problem.has_forces ? "true" : "false", t->v.kind.has_stroke ? "" : ",\"D\"");
}

void scene_write(line *l, const rows *t)
{
    put_units(l, t);
    put_frame(l, t);
    put_links(l, t);
    put_tracers(l, t);
    put_springs(l, t);
    put_polygons(l, t);
    put_forces(l, t);
    put_torques(l, t);
}
