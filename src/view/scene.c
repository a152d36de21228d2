/* SPDX-License-Identifier: GPL-3.0-or-later
**
** scene.c - what a drawing of a mechanism consists of.
*/
#include <string.h>

#include "base/text.h"
#include "notation.h"
#include "scene.h"

/* In UTF-8. */
#define ALPHA "\316\261"
#define SUB_S "\342\202\233"

/* ------------------------------------------------------------------------------------------ polygons */

/* v_C = v_B + v_CB */
static const scene_side velocities[] = {{"v", "B", "", "o", "b", "vB", 2},
                                        {"v", "C", "", "o", "c", "vC", 4},
                                        {"v", "CB", "", "b", "c", "vCB", 3},
                                        {NULL, NULL, NULL, NULL, NULL, NULL, 0}};

/* v_B = v_B4 + slide_v u, B4 the point of the lever at B */
static const scene_side sliding[] = {{"v", "B", "", "o", "b", "vB", 2},
                                     {"v", "B4", "", "o", "b4", "vB4", 4},
                                     {"v", "BB4", "", "b4", "b", "vS", 3},
                                     {NULL, NULL, NULL, NULL, NULL, NULL, 0}};

/* a_C = a_B + a_CB^n + a_CB^t,  a^n = -omega^2 r, a^t = alpha x r */
static const scene_side accelerations[] = {
    {"a", "B", "n", "o'", "_b", "aBn", 2},   {"a", "B", "t", "_b", "b'", "aBt", 2},
    {"a", "CB", "n", "b'", "_c", "aCBn", 3}, {"a", "CB", "t", "_c", "c'", "aCBt", 3},
    {"a", "C", "n", "o'", "_d", "aCn", 4},   {"a", "C", "t", "_d", "c'", "aCt", 4},
    {"a", "C", "", "o'", "c'", "aC", 4},     {NULL, NULL, NULL, NULL, NULL, NULL, 0}};

/* a_B = a_B4^n + a_B4^t + 2 omega4 x slide_v u + slide_a u */
static const scene_side coriolis[] = {
    {"a", "B", "n", "o'", "_b", "aBn", 2},   {"a", "B", "t", "_b", "b'", "aBt", 2},
    {"a", "B4", "n", "o'", "_n", "aB4n", 4}, {"a", "B4", "t", "_n", "b4'", "aB4t", 4},
    {"a", "Cor", "", "b4'", "_k", "aK", 5},  {"a", "BB4", "", "_k", "b'", "aS", 3},
    {NULL, NULL, NULL, NULL, NULL, NULL, 0}};

/* a_B = a_B4 + slide_a u: a yoke does not turn */
static const scene_side without_turning[] = {{"a", "B", "n", "o'", "_b", "aBn", 2},
                                             {"a", "B", "t", "_b", "b'", "aBt", 2},
                                             {"a", "B4", "", "o'", "b4'", "aB4", 4},
                                             {"a", "BB4", "", "b4'", "b'", "aS", 3},
                                             {NULL, NULL, NULL, NULL, NULL, NULL, 0}};

#define VELOCITY "Velocity", QUANTITY_SPEED, "all velocities are zero"
#define ACCELERATION "Acceleration", QUANTITY_ACCELERATION, "all accelerations are zero"

const scene_polygon *scene_polygons(const view *v)
{
    static const scene_polygon of_rod[] = {
        {VELOCITY, velocities, {{NULL, NULL}, {NULL, NULL}}, "", "v"},
        {ACCELERATION, accelerations, {{"o'", "c'"}, {"b'", "c'"}}, "'", "a"}};
    static const scene_polygon of_slider[] = {
        {VELOCITY, sliding, {{NULL, NULL}, {NULL, NULL}}, "", "v"},
        {ACCELERATION, coriolis, {{"o'", "b'"}, {"o'", "b4'"}}, "'", "a"}};

    static const scene_polygon of_yoke[] = {
        {VELOCITY, sliding, {{NULL, NULL}, {NULL, NULL}}, "", "v"},
        {ACCELERATION, without_turning, {{"o'", "b'"}, {NULL, NULL}}, "'", "a"}};

    switch (v->kind.shape[FOURLINK_FOLLOWER]) {
    case FOURLINK_SHAPE_LEVER:
        return of_slider;
    case FOURLINK_SHAPE_YOKE:
        return of_yoke;
    default:
        return of_rod;
    }
}

/* ------------------------------------------------------------------------------------------- springs */

int scene_has_damper(const fourlink_spring *spring)
{
    return spring->damping > 0;
}

int scene_has_coil(const fourlink_spring *spring)
{
    return spring->stiffness != 0 || !scene_has_damper(spring);
}

int scene_joint_of(const fourlink_spring *spring)
{
    static const int joints[5][5] = {
        {0, 0, 0, 0, 0}, {0, 0, 0, 1, 3}, {0, 0, 0, 1, 3}, {0, 1, 1, 0, 2}, {0, 3, 3, 2, 0}};

    return joints[spring->link][spring->to];
}

/* ----------------------------------------------------------------------------------- forces, torques */

/* Add an entry of the sort to a list; returns it. */
static scene_force *add(scene_force *list, int *n, scene_sort sort, const char *name,
                        const char *sub, const char *of, int sign, const char *at, int on)
{
    scene_force *f = &list[*n < SCENE_FORCES ? (*n)++ : SCENE_FORCES - 1];

    memset(f, 0, sizeof *f);
    f->sort = sort;
    f->name = name;
    strcpy(f->sub, sub);
    strcpy(f->of, of);
    f->sign = sign;
    strcpy(f->at, at);
    f->on = on;
    return f;
}

static void add_pin(scene *s, const char *name, const char *sub, const char *of, int sign,
                    const char *at, int on)
{
    add(s->forces, &s->n_forces, SCENE_PIN, name, sub, of, sign, at, on);
}

static void add_couple(scene *s, const char *name, const char *sub, const char *of, int sign,
                       const char *at, int on)
{
    add(s->torques, &s->n_torques, SCENE_PIN, name, sub, of, sign, at, on);
}

/* 1 for the guide of a piston or yoke, on the ground. */
static int is_guide(const fourlink_joint *j)
{
    return j->slider && j->from == FOURLINK_GROUND;
}

/* Add what one link of a joint exerts on the other, and of a slider the couple: F_12, the reaction F_21. */
static void add_joint(scene *s, const fourlink_joint *j, int is_reaction)
{
    int by = is_reaction ? j->on : j->from, on = is_reaction ? j->from : j->on;
    int sign = is_reaction ? -1 : 1;
    unsigned long number = (unsigned long)(10 * j->from + j->on);
    char sub[TRACKS_NAME], of[TRACKS_NAME];

    if (on == FOURLINK_GROUND)
        return;
    tracks_name("", (unsigned long)(10 * by + on), "", sub);
    add_pin(s, is_guide(j) ? "N" : "F", is_guide(j) ? "" : sub, tracks_name("F", number, "", of),
            sign, j->letter, on);
    if (j->slider)
        add_couple(s, "M", sub, tracks_name("M", number, "", of), sign, j->letter, on);
}

static void add_pins(scene *s, const fourlink_kind_facts *kind)
{
    int i;

    add_couple(s, "T", "s", "Ts", 1, "A", FOURLINK_CRANK);
    for (i = 0; i < 4; i++) {
        add_joint(s, &kind->joint[i], 1);
        add_joint(s, &kind->joint[i], 0);
    }
}

static void add_bodies(scene *s, const fourlink_design *design)
{
    char at[TRACKS_NAME], of[TRACKS_NAME];
    int link;

    for (link = FOURLINK_CRANK; link <= FOURLINK_FOLLOWER; link++) {
        if (design->link[link].mass <= 0)
            continue;
        tracks_name("G", (unsigned long)link, "", at);
        tracks_name("W", (unsigned long)link, "", of);
        add(s->forces, &s->n_forces, SCENE_LOAD, "W", at + 1, of, 1, at, link);
        tracks_name("I", (unsigned long)link, "F", of);
        add(s->forces, &s->n_forces, SCENE_INERTIA, "-m a", at, of, 1, at, link);
        tracks_name("I", (unsigned long)link, "T", of);
        if (design->link[link].inertia > 0)
            add(s->torques, &s->n_torques, SCENE_INERTIA, "-I" ALPHA, at + 1, of, 1, at, link);
    }
}

/* Springs are drawn as such; friction acts between links, but for that of a piston in its guide.  `joint`: that
** of friction, or null. */
static int is_inner(const fourlink_load_info *load, const fourlink_joint *joint)
{
    return joint ? !is_guide(joint) : load->sort == FOURLINK_LOAD_SPRING;
}

/* Where the torque of a load is drawn: at the first pin of its link, that of a spring at the spring's. */
static const char *place_of_torque(const view *v, const fourlink_load_info *load)
{
    fourlink_spring spring;

    if (load->sort == FOURLINK_LOAD_SPRING) {
        fourlink_deck_spring(v->deck, load->element, NULL, &spring);
        if (spring.is_torsional)
            return v->kind.joint[scene_joint_of(&spring)].letter;
    }
    return v->kind.joint[v->kind.begins[load->link]].letter;
}

/* The friction of a slider on its lever is in F34. */
static void add_loads(scene *s, const view *v)
{
    char at[TRACKS_NAME], of[TRACKS_NAME];
    fourlink_load_info load;
    scene_force *f;
    unsigned long i;

    for (i = 0; fourlink_deck_load(v->deck, i, &load) == FOURLINK_OK; i++) {
        const fourlink_joint *joint =
            load.sort == FOURLINK_LOAD_FRICTION ? &v->kind.joint[load.element] : NULL;

        tracks_name("L", i, "", at);
        tracks_name("L", i, "F", of);
        if (!joint || !joint->slider || is_guide(joint)) {
            f = add(s->forces, &s->n_forces, SCENE_LOAD, load.name, "", of, 1, at, load.link);
            f->is_inner = is_inner(&load, joint);
            f->load = load.sort;
        }
        tracks_name("L", i, "T", of);
        f = add(s->torques, &s->n_torques, SCENE_LOAD, load.name, "", of, 1,
                place_of_torque(v, &load), load.link);
        f->is_inner = joint || is_inner(&load, joint);
        f->load = load.sort;
        if (joint) {
            static const char *const joints[] = {"A", "B", "C", "D"};

            f->name = "M";
            strcpy(f->sub, joints[load.element]);
            strcpy(f->at, joints[load.element]);
        }
    }
}

static void add_image(scene *s, const char *name, const char *sub, const char *of)
{
    scene_image *x = &s->images[s->n_images < SCENE_IMAGES ? s->n_images++ : SCENE_IMAGES - 1];

    x->name = name;
    strcpy(x->sub, sub);
    strcpy(x->of, of);
}

static void add_images(scene *s, const view *v)
{
    char of[TRACKS_NAME];
    fourlink_vector at;
    const char *name;
    unsigned long i;
    int link;

    for (link = FOURLINK_CRANK; link <= FOURLINK_FOLLOWER; link++)
        if (v->design->link[link].mass > 0) {
            tracks_name("G", (unsigned long)link, "", of);
            add_image(s, "g", of + 1, of);
        }
    for (i = 0; i < v->problem.n_points; i++) {
        fourlink_deck_point(v->deck, i, &name, &link, &at);
        add_image(s, name, "", tracks_name("P", i, "", of));
    }
}

void scene_find(scene *s, const view *v)
{
    s->n_images = 0;
    add_images(s, v);
    s->n_forces = s->n_torques = 0;
    if (v->problem.has_forces) {
        add_pins(s, &v->kind);
        add_bodies(s, v->design);
    }
    add_loads(s, v);
}

char *scene_words(const scene_force *f, char *out, size_t size)
{
    static const char *const subscripts[] = {"", "\342\202\201", "\342\202\202", "\342\202\203",
                                             "\342\202\204"};
    char letter[2] = {0, 0};
    const char *c, *script;

    flk_text_join(out, size, f->name, (char *)NULL);
    for (c = f->sub; *c; c++) {
        letter[0] = *c;
        if (*c == 's')
            script = SUB_S;
        else if (*c > '4')
            script = letter;
        else
            script = f->sort == SCENE_INERTIA ? "" : subscripts[*c - '0'];
        flk_text_join(out + strlen(out), size - strlen(out), script == letter ? NOTATION_SUB : "",
                      script, (char *)NULL);
    }
    return out;
}
