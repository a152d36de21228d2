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

#define NO_SIDE                      \
    {                                \
        NULL, NULL, NULL, 0, 0, 0, 0 \
    }

/* Corners of all polygons; those without a letter are between the parts of one vector. */
enum { O, B, C, B4 = C, BETWEEN, BETWEEN_C, BETWEEN_D };

/* v_C = v_B + v_CB */
static const scene_side velocities[] = {{"v", "B", "", O, B, TRACK_VB, 2},
                                        {"v", "C", "", O, C, TRACK_VC, 4},
                                        {"v", "CB", "", B, C, TRACK_VCB, 3},
                                        NO_SIDE};

/* v_B = v_B4 + slide_v u, B4 the point of the lever at B */
static const scene_side sliding[] = {{"v", "B", "", O, B, TRACK_VB, 2},
                                     {"v", "B4", "", O, B4, TRACK_VB4, 4},
                                     {"v", "BB4", "", B4, B, TRACK_VS, 3},
                                     NO_SIDE};

/* a_C = a_B + a_CB^n + a_CB^t,  a^n = -omega^2 r, a^t = alpha x r */
static const scene_side accelerations[] = {{"a", "B", "n", O, BETWEEN, TRACK_ABN, 2},
                                           {"a", "B", "t", BETWEEN, B, TRACK_ABT, 2},
                                           {"a", "CB", "n", B, BETWEEN_C, TRACK_ACBN, 3},
                                           {"a", "CB", "t", BETWEEN_C, C, TRACK_ACBT, 3},
                                           {"a", "C", "n", O, BETWEEN_D, TRACK_ACN, 4},
                                           {"a", "C", "t", BETWEEN_D, C, TRACK_ACT, 4},
                                           {"a", "C", "", O, C, TRACK_AC, 4},
                                           NO_SIDE};

/* a_B = a_B4^n + a_B4^t + 2 omega4 x slide_v u + slide_a u */
static const scene_side coriolis[] = {{"a", "B", "n", O, BETWEEN, TRACK_ABN, 2},
                                      {"a", "B", "t", BETWEEN, B, TRACK_ABT, 2},
                                      {"a", "B4", "n", O, BETWEEN_C, TRACK_AB4N, 4},
                                      {"a", "B4", "t", BETWEEN_C, B4, TRACK_AB4T, 4},
                                      {"a", "Cor", "", B4, BETWEEN_D, TRACK_AK, 0},
                                      {"a", "BB4", "", BETWEEN_D, B, TRACK_AS, 3},
                                      NO_SIDE};

/* a_B = a_B4 + slide_a u: a yoke does not turn */
static const scene_side without_turning[] = {{"a", "B", "n", O, BETWEEN, TRACK_ABN, 2},
                                             {"a", "B", "t", BETWEEN, B, TRACK_ABT, 2},
                                             {"a", "B4", "", O, B4, TRACK_AB4, 4},
                                             {"a", "BB4", "", B4, B, TRACK_AS, 3},
                                             NO_SIDE};

/* Of an output, in whose names 6 is its slider or rocker and k the link that carries it.  Of each type
** those sides have a track that it has.
**
** v_Q = v_P + v_QP, of a rocker that floats = v_D + v_QD; in slots v_P = v_P6 + v_PP6, v_Q = v_Qk + v_QQk */
enum { P = 1, Q, D, P6, QK, PART, PART_D, PART_S };

static const scene_side of_output[] = {{"v", "P", "", O, P, OUTPUT_VP, SCENE_CARRYING},
                                       {"v", "D", "", O, D, OUTPUT_D + 1, SCENE_FLOATING},
                                       {"v", "QP", "", P, Q, OUTPUT_VQP, SCENE_ROD},
                                       {"v", "QD", "", D, Q, OUTPUT_VQD, SCENE_END},
                                       {"v", "Q", "", O, Q, OUTPUT_VQ, SCENE_END},
                                       {"v", "P6", "", O, P6, OUTPUT_VP6, SCENE_END},
                                       {"v", "PP6", "", P6, P, OUTPUT_VPP6, SCENE_ROD},
                                       {"v", "Qk", "", O, QK, OUTPUT_VQK, SCENE_CARRYING},
                                       {"v", "QQk", "", QK, Q, OUTPUT_VQQK, SCENE_ROD},
                                       NO_SIDE};

/* The same, with Coriolis' acceleration in slots, which is 0 where the slot does not turn */
static const scene_side accelerated_output[] = {
    {"a", "P", "", O, P, OUTPUT_AP, SCENE_CARRYING},
    {"a", "D", "", O, D, OUTPUT_D + 2, SCENE_FLOATING},
    {"a", "QP", "n", P, PART, OUTPUT_AQPN, SCENE_ROD},
    {"a", "QP", "t", PART, Q, OUTPUT_AQPT, SCENE_ROD},
    {"a", "QD", "n", D, PART_D, OUTPUT_AQDN, SCENE_END},
    {"a", "QD", "t", PART_D, Q, OUTPUT_AQDT, SCENE_END},
    {"a", "Q", "", O, Q, OUTPUT_AQ, SCENE_END},
    {"a", "Q", "n", O, PART_D, OUTPUT_AQN, SCENE_END},
    {"a", "Q", "t", PART_D, Q, OUTPUT_AQT, SCENE_END},
    {"a", "P6", "", O, P6, OUTPUT_AP6, SCENE_END},
    {"a", "P6", "n", O, PART_D, OUTPUT_AP6N, SCENE_END},
    {"a", "P6", "t", PART_D, P6, OUTPUT_AP6T, SCENE_END},
    {"a", "Cor", "", P6, PART_S, OUTPUT_AK, 0},
    {"a", "PP6", "", PART_S, P, OUTPUT_AS, SCENE_ROD},
    {"a", "Qk", "", O, QK, OUTPUT_AQK, SCENE_CARRYING},
    {"a", "Cor", "", QK, PART_S, OUTPUT_AKK, 0},
    {"a", "QQk", "", PART_S, Q, OUTPUT_ASK, SCENE_ROD},
    NO_SIDE};

static const char *const of_velocity[] = {"o", "b", "c", NULL, NULL, NULL},
                         *const of_acceleration[] = {"o'", "b'", "c'", NULL, NULL, NULL},
                         *const of_slide[] = {"o", "b", "b4", NULL, NULL, NULL},
                         *const of_coriolis[] = {"o'", "b'", "b4'", NULL, NULL, NULL},
                         *const of_pins[] = {"o", "p", "q", "d", "p6", "qk", NULL, NULL, NULL},
                         *const of_pins_accelerated[] = {"o'",  "p'", "q'", "d'", "p6'",
                                                         "qk'", NULL, NULL, NULL};

#define VELOCITY "Velocity", QUANTITY_SPEED, "all velocities are zero"
#define ACCELERATION "Acceleration", QUANTITY_ACCELERATION, "all accelerations are zero"

int scene_count_polygons(const view *v)
{
    return 2 + 2 * v->design->n_groups;
}

void scene_find_polygon(const view *v, int k, scene_polygon *found)
{
    static const scene_polygon of_rod[] = {
        {VELOCITY, velocities, of_velocity, {{0, 0}, {0, 0}}, "", 1, 0, 0},
        {ACCELERATION, accelerations, of_acceleration, {{O, C}, {B, C}}, "'", 2, 0, 0}};
    static const scene_polygon of_slider[] = {
        {VELOCITY, sliding, of_slide, {{0, 0}, {0, 0}}, "", 1, 0, 0},
        {ACCELERATION, coriolis, of_coriolis, {{O, B}, {O, B4}}, "'", 2, 0, 0}};
    static const scene_polygon of_yoke[] = {
        {VELOCITY, sliding, of_slide, {{0, 0}, {0, 0}}, "", 1, 0, 0},
        {ACCELERATION, without_turning, of_coriolis, {{O, B}, {0, 0}}, "'", 2, 0, 0}};
    static const scene_polygon of_outputs[] = {
        {VELOCITY, of_output, of_pins, {{0, 0}, {0, 0}}, "", 1, 0, 0},
        {ACCELERATION, accelerated_output, of_pins_accelerated, {{0, 0}, {0, 0}}, "'", 2, 0, 0}};
    int shape = (int)v->kind.shape[FOURLINK_FOLLOWER];

    if (k >= 2) {
        *found = of_outputs[k % 2];
        found->output = k / 2;
        found->first = TRACK_OF_OUTPUT(k / 2 - 1);
    } else {
        *found = (shape == FOURLINK_SHAPE_LEVER  ? of_slider
                  : shape == FOURLINK_SHAPE_YOKE ? of_yoke
                                                 : of_rod)[k];
    }
}

int scene_link_of_side(const view *v, const scene_polygon *d, const scene_side *side)
{
    const fourlink_group *g = d->output ? &v->design->group[d->output - 1] : NULL;

    return side->link >= 0                ? side->link
           : side->link == SCENE_CARRYING ? g->link
           : side->link == SCENE_FLOATING ? g->to
           : side->link == SCENE_ROD      ? FOURLINK_ROD_OF(d->output - 1)
                                          : FOURLINK_END_OF(d->output - 1);
}

/* Write a name of an output, with the numbers of its links. */
static void put_numbered(const view *v, const scene_polygon *d, const char *name,
                         char out[SCENE_NAME])
{
    int link = d->output ? v->design->group[d->output - 1].link : 0;
    char letter[TRACKS_NAME];

    for (*out = '\0'; *name; name++) {
        tracks_name("", (unsigned long)(*name == '6' ? FOURLINK_END_OF(d->output - 1) : link),
                    letter);
        if (!d->output || (*name != '6' && *name != 'k')) {
            letter[0] = *name;
            letter[1] = '\0';
        }
        flk_text_join(out + strlen(out), SCENE_NAME - strlen(out), letter, (char *)NULL);
    }
}

const char *scene_name_of_side(const view *v, const scene_polygon *d, const scene_side *side,
                               char out[SCENE_NAME])
{
    char sub[SCENE_NAME];

    put_numbered(v, d, side->sub, sub);
    return flk_text_join(out, SCENE_NAME, side->name, NOTATION_SUB, sub,
                         side->super[0] ? NOTATION_SUPER : "", side->super, (char *)NULL);
}

const char *scene_letter(const view *v, const scene_polygon *d, int corner, char out[SCENE_NAME])
{
    if (!d->letters[corner])
        return NULL;
    put_numbered(v, d, d->letters[corner], out);
    return out;
}

int scene_body(const view *v, int k)
{
    int link;

    for (link = FOURLINK_CRANK; link <= FOURLINK_LAST_LINK(v->design); link++) {
        int of = link - FOURLINK_FOLLOWER - 1;

        if (of >= 0 && of % 2 == 0 && v->design->group[of / 2].hang != FOURLINK_HANGS_BY_ROD)
            continue;
        if (k-- == 0)
            return link;
    }
    return 0;
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

/* Add an entry of the sort to a list, which has room; returns it. */
static scene_force *add(scene_force *list, int *n, scene_sort sort, const char *name,
                        const char *sub, int of, int sign, int at, int on)
{
    scene_force *f = &list[(*n)++];

    memset(f, 0, sizeof *f);
    f->sort = sort;
    f->name = name;
    strcpy(f->sub, sub);
    f->of = of;
    f->sign = sign;
    f->at = at;
    f->on = on;
    return f;
}

/* 1 for the guide of a piston or yoke, on the ground. */
static int is_guide(const fourlink_joint *j)
{
    return j->slider && j->from == FOURLINK_GROUND;
}

/* Add what one link of joint i exerts on the other, and of a slider the couple: F_12, the reaction F_21. */
static void add_joint(scene *s, const fourlink_joint *j, int i, int is_reaction)
{
    int by = is_reaction ? j->on : j->from, on = is_reaction ? j->from : j->on;
    int sign = is_reaction ? -1 : 1;
    char sub[TRACKS_NAME];

    if (on == FOURLINK_GROUND)
        return;
    tracks_name("", (unsigned long)(10 * by + on), sub);
    add(s->forces, &s->n_forces, SCENE_PIN, is_guide(j) ? "N" : "F", is_guide(j) ? "" : sub,
        TRACK_FORCE + i, sign, TRACK_OF_JOINT(j), on);
    if (j->slider)
        add(s->torques, &s->n_torques, SCENE_PIN, "M", sub, TRACK_COUPLE + i, sign,
            TRACK_OF_JOINT(j), on);
}

static void add_pins(scene *s, const fourlink_kind_facts *kind)
{
    int i;

    add(s->torques, &s->n_torques, SCENE_PIN, "T", "s", TRACK_TS, 1, TRACK_A, FOURLINK_CRANK);
    for (i = 0; i < 4; i++) {
        add_joint(s, &kind->joint[i], i, 1);
        add_joint(s, &kind->joint[i], i, 0);
    }
}

/* The force F of a pin of an output on a link, and -F on the other, unless that is the ground. */
static void add_pin_of_output(scene *s, const char *sub, int of, int at, int on, int other)
{
    add(s->forces, &s->n_forces, SCENE_PIN, "F", sub, of, 1, at, on);
    if (other > FOURLINK_GROUND)
        add(s->forces, &s->n_forces, SCENE_PIN, "-F", sub, of, -1, at, other);
}

/* FP on the rod, or on slider or rocker with a slot; FQ on slider or rocker; FD on a rocker at its pin,
** or of the guide. */
static void add_output(scene *s, const view *v, int i)
{
    const fourlink_group *g = &v->design->group[i];
    int first = TRACK_OF_OUTPUT(i), rod = FOURLINK_ROD_OF(i), end = rod + 1,
        by_rod = g->hang == FOURLINK_HANGS_BY_ROD;
    char P_name[TRACKS_NAME] = "P", Q_name[TRACKS_NAME] = "Q", D_name[TRACKS_NAME],
         guide[TRACKS_NAME];

    if (v->design->n_groups > 1) {
        tracks_name("P", (unsigned long)i + 1, P_name);
        tracks_name("Q", (unsigned long)i + 1, Q_name);
    }
    tracks_name("D", (unsigned long)end, D_name);
    tracks_name("1", (unsigned long)end, guide);
    add_pin_of_output(s, P_name, first + OUTPUT_FP,
                      first + (g->hang == FOURLINK_HANGS_IN_SLOT ? OUTPUT_Q : OUTPUT_P),
                      by_rod ? rod : end, g->link);
    if (by_rod)
        add_pin_of_output(s, Q_name, first + OUTPUT_FQ, first + OUTPUT_Q, end, rod);
    if (g->end == FOURLINK_GROUP_TURNS) {
        add_pin_of_output(s, D_name, first + OUTPUT_FD, first + OUTPUT_D, end, g->to);
        return;
    }
    add(s->forces, &s->n_forces, SCENE_PIN, "N", guide, first + OUTPUT_FD, 1, first + OUTPUT_Q,
        end);
    add(s->torques, &s->n_torques, SCENE_PIN, "M", guide, first + OUTPUT_M, 1, first + OUTPUT_Q,
        end);
}

static void add_bodies(scene *s, const view *v)
{
    char name[TRACKS_NAME];
    int link;

    for (link = FOURLINK_CRANK; link <= FOURLINK_LAST_LINK(v->design); link++) {
        const fourlink_link *data = tracks_link(v, link);
        int at = TRACK_OF_CENTRE(link);

        if (data->mass <= 0)
            continue;
        tracks_name("G", (unsigned long)link, name);
        add(s->forces, &s->n_forces, SCENE_LOAD, "W", name + 1, TRACK_WEIGHT + link, 1, at, link);
        add(s->forces, &s->n_forces, SCENE_INERTIA, "-m a", name, TRACK_INERTIA_FORCE + link, 1, at,
            link);
        if (data->inertia > 0)
            add(s->torques, &s->n_torques, SCENE_INERTIA, "-I" ALPHA, name + 1,
                TRACK_INERTIA_TORQUE + link, 1, at, link);
    }
}

/* Springs are drawn as such; friction acts between links, but for that of a piston in its guide.  `joint`:
** that of friction, or null. */
static int is_inner(const fourlink_load_info *load, const fourlink_joint *joint)
{
    return joint ? !is_guide(joint) : load->sort == FOURLINK_LOAD_SPRING;
}

/* Where the torque of load i is drawn: at the first pin of its link, on one of an output where the load
** acts, that of a spring at the spring's. */
static int place_of_torque(const view *v, const fourlink_load_info *load, int i)
{
    fourlink_spring spring;

    if (load->sort == FOURLINK_LOAD_SPRING) {
        fourlink_deck_spring(v->deck, load->element, NULL, &spring);
        if (spring.is_torsional)
            return TRACK_OF_JOINT(&v->kind.joint[scene_joint_of(&spring)]);
    }
    if (load->link > FOURLINK_FOLLOWER)
        return TRACK_LOAD + i;
    return TRACK_OF_JOINT(&v->kind.joint[v->kind.begins[load->link]]);
}

/* The friction of a slider on its lever is in F34. */
static void add_loads(scene *s, const view *v)
{
    fourlink_load_info load;
    scene_force *f;
    int i;

    for (i = 0; fourlink_deck_load(v->deck, (unsigned long)i, &load) == FOURLINK_OK; i++) {
        const fourlink_joint *joint =
            load.sort == FOURLINK_LOAD_FRICTION ? &v->kind.joint[load.element] : NULL;

        if (!joint || !joint->slider || is_guide(joint)) {
            f = add(s->forces, &s->n_forces, SCENE_LOAD, load.name, "", TRACK_LOAD_FORCE + i, 1,
                    TRACK_LOAD + i, load.link);
            f->is_inner = is_inner(&load, joint);
            f->load = load.sort;
        }
        f = add(s->torques, &s->n_torques, SCENE_LOAD, load.name, "", TRACK_LOAD_TORQUE + i, 1,
                place_of_torque(v, &load, i), load.link);
        f->is_inner = joint || is_inner(&load, joint);
        f->load = load.sort;
        if (joint) {
            f->name = "M";
            f->sub[0] = (char)('A' + load.element);
            f->at = TRACK_A + (int)load.element;
        }
    }
}

/* What drives, if not the crank: between two moving links, and by an actuator, it is drawn on free
** bodies alone. */
static void add_drive(scene *s, const view *v)
{
    fourlink_load_info load, other;
    fourlink_actuator actuator;
    int i, is_actuator = 0;
    scene_force *f;

    for (i = 0; fourlink_deck_actuator(v->deck, (unsigned long)i, &actuator) == FOURLINK_OK; i++)
        is_actuator |= actuator.drives;
    for (i = 0; fourlink_deck_drive(v->deck, (unsigned long)i, &load) == FOURLINK_OK; i++) {
        if (load.has_torque)
            f = add(s->torques, &s->n_torques, SCENE_LOAD, load.name, "", TRACK_DRIVE_TORQUE + i, 1,
                    load.link > FOURLINK_FOLLOWER
                        ? TRACK_DRIVE + i
                        : TRACK_OF_JOINT(&v->kind.joint[v->kind.begins[load.link]]),
                    load.link);
        else
            f = add(s->forces, &s->n_forces, SCENE_LOAD, load.name, "", TRACK_DRIVE_FORCE + i, 1,
                    TRACK_DRIVE + i, load.link);
        f->is_inner = is_actuator || fourlink_deck_drive(v->deck, 1, &other) == FOURLINK_OK;
        f->load = load.sort;
    }
}

/* `on` is the link of the point, `link` that below its letter. */
static void add_image(scene *s, const char *name, int link, int of, int on)
{
    scene_image *x = &s->images[s->n_images++];

    x->name = name;
    x->link = link;
    x->of = of;
    x->output = on > FOURLINK_FOLLOWER ? (on - FOURLINK_FOLLOWER + 1) / 2 : 0;
}

static void add_images(scene *s, const view *v)
{
    fourlink_vector at;
    const char *name;
    unsigned long i;
    int link;

    for (link = FOURLINK_CRANK; link <= FOURLINK_LAST_LINK(v->design); link++)
        if (tracks_link(v, link)->mass > 0)
            add_image(s, "g", link, TRACK_OF_CENTRE(link), link);
    for (i = 0; i < v->problem.n_points; i++) {
        fourlink_deck_point(v->deck, i, &name, &link, &at);
        add_image(s, name, 0, TRACK_OF_POINT(i), link);
    }
}

void scene_find(scene *s, const view *v)
{
    int i;

    s->n_images = 0;
    add_images(s, v);
    s->n_forces = s->n_torques = 0;
    if (v->problem.has_forces) {
        add_pins(s, &v->kind);
        for (i = 0; i < v->design->n_groups; i++)
            add_output(s, v, i);
        add_bodies(s, v);
    }
    add_loads(s, v);
    if (v->problem.has_forces)
        add_drive(s, v);
}

char *scene_words(const scene_force *f, char *out, size_t size)
{
    static const char digits[] = "0123456789", *const subscripts[] = {
                                                   "\342\202\200", "\342\202\201", "\342\202\202",
                                                   "\342\202\203", "\342\202\204", "\342\202\205",
                                                   "\342\202\206", "\342\202\207", "\342\202\210",
                                                   "\342\202\211"};
    char letter[2] = {0, 0};
    const char *c, *script;

    flk_text_join(out, size, f->name, (char *)NULL);
    for (c = f->sub; *c; c++) {
        letter[0] = *c;
        if (*c == 's')
            script = SUB_S;
        else if (!strchr(digits, *c))
            script = letter;
        else
            script = f->sort == SCENE_INERTIA ? "" : subscripts[*c - '0'];
        flk_text_join(out + strlen(out), size - strlen(out), script == letter ? NOTATION_SUB : "",
                      script, (char *)NULL);
    }
    return out;
}
