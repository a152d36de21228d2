/* SPDX-License-Identifier: GPL-3.0-or-later
**
** vectors.c - the graphical method at one position: velocity and acceleration polygons, free
** bodies and their polygons of forces, which close:  sum F - m a_G = 0
*/
#include <math.h>

#include <gsl/gsl_math.h>

#include "arrow.h"
#include "vectors.h"

/* The height of a letter in these small drawings. */
#define LETTER 0.045

/* A side shorter than this fraction of the largest is shorter than the head of an arrow. */
#define SHORTEST 0.01

/* The longest arrow, also of a body that turns, and half of a block, as parts of a body's length. */
#define LONGEST 0.65
#define LONGEST_OF_MOTION 0.5
#define HALF_BLOCK 0.2

/* A friction circle is drawn to scale if its radius is at least this fraction of the drawing. */
#define SMALLEST_CIRCLE 0.04

#define IMAGE_NAME 9 /* letters, of the image of a point */

#define NO_FORCES "all forces are zero"

static const fourlink_vector zero = {0, 0};

/* A polygon of vectors of one quantity, in SI units. */
typedef struct polygon {
    sketch s;
    const picture *p;
    quantity q;
    const char *zero; /* if all sides are 0 */
    arrow_list sides;
    const scene_side *of[SCENE_SIDES]; /* of velocities and accelerations */
    fourlink_vector middle;
    double largest; /* side; 1: all are 0 */
} polygon;

static void open_polygon(polygon *g, picture *p, quantity q, const char *zero_words)
{
    g->p = p;
    g->q = q;
    g->zero = zero_words;
    g->sides.n = 0;
    sketch_open(&g->s, &p->on, &p->v.units[q], 1);
    g->s.letter = LETTER;
}

static fourlink_vector end_of(const arrow *x)
{
    return place_beside(x->at, x->F.x, x->F.y);
}

static void find_size(polygon *g)
{
    int i, n = g->sides.n;

    g->largest = arrow_largest(&g->sides);
    if (g->largest == 0)
        g->largest = 1;
    if (!g->p->on.motion)
        g->s.size = g->largest;
    g->middle = zero;
    for (i = 0; i < n; i++) {
        const arrow *x = &g->sides.list[i];

        g->middle.x += (x->at.x + end_of(x).x) / (2 * n);
        g->middle.y += (x->at.y + end_of(x).y) / (2 * n);
    }
}

/* Draw the sides, with their names away from the middle of the polygon; in a motion on the same side of
** each.  A side too short for a head has no name. */
static void draw_sides(polygon *g)
{
    int i;

    find_size(g);
    if (arrow_largest(&g->sides) == 0)
        sketch_text(&g->s, zero, 0, 1, g->zero);
    for (i = 0; i < g->sides.n; i++) {
        const arrow *x = &g->sides.list[i];
        fourlink_vector to = end_of(x);
        double dx = to.x - x->at.x, dy = to.y - x->at.y, length = gsl_hypot(dx, dy), nx, ny, out;

        if (format_settled(length, g->largest) == 0)
            continue; /* rounding */
        sketch_show(&g->s, SKETCH_SIDE, (unsigned long)i);
        figure_note(&g->s, g->p, x->name, length / g->s.shrink, g->q);
        if (length < SHORTEST * g->largest) {
            sketch_line(&g->s, x->kind, x->at, to);
            continue;
        }
        sketch_arrow(&g->s, x->kind, x->at, to);
        sketch_along(&g->s, x->at, 0, to, 1);
        nx = -dy / length;
        ny = dx / length;
        out = !g->p->on.motion && nx * (x->at.x - g->middle.x) + ny * (x->at.y - g->middle.y) < 0
                  ? -1
                  : 1;
        sketch_text(&g->s, place_middle(x->at, to), out * nx, out * ny, x->name);
    }
}

/* Put the letter of a corner away from the middle. */
static void put_letter(polygon *g, int corner, fourlink_vector at, const char *letter)
{
    sketch_show(&g->s, SKETCH_CORNER, (unsigned long)corner);
    sketch_away(&g->s, g->p->on.motion ? g->s.held : g->middle);
    if (arrow_largest(&g->sides) > 0)
        sketch_text(&g->s, at, at.x - g->middle.x, at.y - g->middle.y, letter);
}

/* Put the image of a point of a link, which ends its velocity or acceleration from the pole. */
static void put_image(polygon *g, fourlink_vector end, const char *letter)
{
    sketch_line(&g->s, PEN_CONSTRUCTION, zero, end);
    sketch_dot(&g->s, end, letter);
    sketch_away(&g->s, zero);
    sketch_name(&g->s, end, end.x - g->middle.x, end.y - g->middle.y, letter);
}

/* Put the images of centres of mass and of tracer points. */
static void put_images(polygon *g, const picture_row *r, const scene_polygon *d)
{
    static const char *const subscripts[] = {"", "", SUB_2, SUB_3, SUB_4};
    char letter[80], fitting[LABELS_WORDS], number[TRACKS_NAME];
    int i;

    for (i = 0; i < r->drawn.n_images && arrow_largest(&g->sides) > 0; i++) {
        const scene_image *x = &r->drawn.images[i];

        if (x->output != d->output)
            continue;
        tracks_name(NOTATION_SUB, (unsigned long)x->link, number);
        flk_text_join(letter, sizeof letter,
                      canvas_shorten(x->name, IMAGE_NAME, 0, fitting, sizeof fitting), d->mark,
                      x->link <= FOURLINK_FOLLOWER ? subscripts[x->link] : number, (char *)NULL);
        sketch_show(&g->s, SKETCH_IMAGE, (unsigned long)i);
        put_image(g,
                  place_in(zero, tracks_vector(&r->numbers, x->of + d->derivative), g->s.shrink, 0),
                  letter);
    }
}

/* The first side that ends at a corner; the number of sides if it is the pole. */
static int side_to(const polygon *g, int corner)
{
    int i;

    for (i = 0; i < g->sides.n && g->of[i]->to != corner; i++)
        ;
    return i;
}

static fourlink_vector corner_at(const polygon *g, int corner)
{
    int i = side_to(g, corner);

    return i < g->sides.n ? end_of(&g->sides.list[i]) : zero;
}

/* Find the sides, so many times smaller than they are. */
static void find_sides(polygon *g, const picture_row *r, const scene_polygon *d, double shrink)
{
    const scene_side *x;
    char name[SCENE_NAME];

    g->s.shrink = shrink;
    for (x = d->sides; x->name; x++)
        if (r->numbers.list[d->first + x->of].is_there) {
            int link = scene_link_of_side(&g->p->v, d, x);

            g->of[g->sides.n] = x;
            arrow_put(&g->sides, g->sides.n, link ? FIGURE_PEN(link) : PEN_RESULT,
                      scene_name_of_side(&g->p->v, d, x, name), corner_at(g, x->from),
                      place_in(zero, tracks_vector(&r->numbers, d->first + x->of), shrink, 0));
        }
}

/* In a motion the middle of a polygon stays where it is. */
static void hold_middle(polygon *g)
{
    place_box b = place_nothing;
    int i;

    for (i = 0; i < g->sides.n; i++) {
        place_grow(&b, g->sides.list[i].at.x, g->sides.list[i].at.y);
        place_grow(&b, end_of(&g->sides.list[i]).x, end_of(&g->sides.list[i]).y);
    }
    if (g->p->on.motion && g->sides.n)
        sketch_hold(&g->s, place_at((b.x_min + b.x_max) / 2, (b.y_min + b.y_max) / 2));
}

double vectors_size(const picture_row *r, const scene_polygon *d)
{
    double size = 0;
    const scene_side *x;

    for (x = d->sides; x->name; x++) {
        fourlink_vector v = tracks_vector(&r->numbers, d->first + x->of);

        size = GSL_MAX_DBL(size, gsl_hypot(v.x, v.y));
    }
    return size;
}

/* The part of its size at which a polygon of a motion is drawn: 1, 1/2, 1/5, 1/10 ... */
static double shrink_of(double size, double most)
{
    return most > 0 && size > most * (1 + 1e-9) ? 1 / place_round(size / most) : 1;
}

void vectors_draw_polygon(picture *p, const picture_row *r, const scene_polygon *d, double most)
{
    char letter[SCENE_NAME];
    polygon g;
    int i;

    open_polygon(&g, p, d->q, d->zero);
    g.s.size = most > 0 ? most : 1;
    find_sides(&g, r, d, shrink_of(vectors_size(r, d), most));
    hold_middle(&g);
    draw_sides(&g);
    sketch_show(&g.s, SKETCH_FRAME, 0);
    for (i = 0; i < 2 && d->lines[i][1]; i++)
        sketch_line(&g.s, PEN_CONSTRUCTION, corner_at(&g, d->lines[i][0]),
                    corner_at(&g, d->lines[i][1]));
    put_letter(&g, SCENE_SIDES, zero, d->letters[0]);
    for (i = 0; i < g.sides.n; i++)
        if (d->letters[g.of[i]->to] && side_to(&g, g.of[i]->to) == i)
            put_letter(&g, i, end_of(&g.sides.list[i]),
                       scene_letter(&p->v, d, g.of[i]->to, letter));
    put_images(&g, r, d);
    sketch_close(&g.s, "%s polygon%s%s", d->q == QUANTITY_SPEED ? "velocity" : "acceleration",
                 d->output ? " of " : "",
                 d->output ? fourlink_deck_link_text(p->v.deck, FOURLINK_END_OF(d->output - 1))
                           : "");
}

/* The friction circle of a pin of a link, to which its force is a tangent, in m; radius 0: no friction.  The
** force F and the moment M of the friction are together the force F along a line at the distance M / |F| from
** the pin: a tangent to the circle of radius mu r (R. S. Khurmi, J. K. Gupta, "Theory of Machines", chapter
** 10, friction of a pin joint). */
typedef struct friction_circle {
    double radius;
    double arm; /* of the force about the pin, positive if that turns the link counter-clockwise */
} friction_circle;

/* The moment of a joint's friction on a link: against its turning relative to the other link. */
static double moment_on(const picture *p, const picture_row *r, unsigned long joint, int link)
{
    fourlink_load_info load;
    unsigned long i;

    for (i = 0; fourlink_deck_load(p->v.deck, i, &load) == FOURLINK_OK; i++)
        if (load.sort == FOURLINK_LOAD_FRICTION && load.element == joint && load.link == link)
            return r->loads[i].torque;
    return 0;
}

/* The circle of joint 0 to 3, A to D, at which the force F, in N, acts on a link. */
static friction_circle circle_of(const picture *p, const picture_row *r, int joint, int link,
                                 fourlink_vector F)
{
    double size = gsl_hypot(F.x, F.y);
    fourlink_friction friction;
    friction_circle x = {0, 0};

    fourlink_deck_friction(p->v.deck, &friction);
    x.radius = friction.circle[joint];
    if (size > 0)
        x.arm = moment_on(p, r, (unsigned long)joint, link) / size;
    return x;
}

/* How many times larger than a drawing of this size its circles are drawn, so that the larger of two can be
** seen. */
static double scale_of_circles(double size, const friction_circle *x, const friction_circle *y)
{
    double radius = GSL_MAX_DBL(x->radius, y->radius);

    return radius > 0 ? GSL_MAX_DBL(place_round(SMALLEST_CIRCLE * size / radius), 1) : 1;
}

/* Where a force touches its circle, drawn so many times larger:  r x F = arm |F|, r at right angles to F */
static fourlink_vector touch_of(const friction_circle *x, double scale, fourlink_vector pin,
                                fourlink_vector F)
{
    double size = gsl_hypot(F.x, F.y), part = size > 0 ? scale * x->arm / size : 0;

    return place_beside(pin, part * F.y, -part * F.x);
}

/* A link with the forces on it: from its two neighbours, weight, loads, and -m a_G, which balances them. */
typedef struct free_body {
    int link;
    fourlink_vector first, second, G; /* its pins, and its centre of mass */
    double length;
    friction_circle circle[2]; /* of the pins */
    int of_pin[2];             /* their forces in the list; -1: it is 0 */
    double circle_scale;
    arrow_list forces;
} free_body;

/* The link with which a place of a free body moves: its own, but 0 where another link slides on it. */
static int body_at(const free_body *b, const picture *p, const picture_row *r, int at)
{
    int i = (at - TRACK_OUTPUT) / TRACKS_OF_OUTPUT, slides;

    if (at < TRACK_OUTPUT)
        slides = b->link == p->v.kind.slotted && (at == TRACK_B || at >= TRACK_DRIVE);
    else
        slides = tracks_body(&r->numbers, at) != b->link &&
                 p->v.design->group[i].hang == (b->link == FOURLINK_END_OF(i)
                                                    ? FOURLINK_HANGS_BY_OWN_SLOT
                                                    : FOURLINK_HANGS_IN_SLOT);
    return slides ? 0 : b->link;
}

/* Add the forces of a sort; the first two, those of the pins, have circles. */
static void add_forces(free_body *b, const picture *p, const picture_row *r, scene_sort sort)
{
    int pin = 0, i, n;

    for (i = 0; i < r->drawn.n_forces; i++) {
        const scene_force *f = &r->drawn.forces[i];

        if (f->on != b->link || f->sort != sort)
            continue;
        n = b->forces.n;
        arrow_add_force(&b->forces, r, i);
        if (b->forces.n > n)
            b->forces.list[n].body = body_at(b, p, r, f->at);
        if (sort != SCENE_PIN || pin > 1 || b->link > FOURLINK_FOLLOWER)
            continue; /* pins of outputs have no friction */
        b->circle[pin] = circle_of(p, r, b->link - FOURLINK_CRANK + pin, b->link,
                                   n < b->forces.n ? b->forces.list[n].F : zero);
        b->of_pin[pin++] = n < b->forces.n ? n : -1;
    }
}

/* Move the force of a pin to where it touches the friction circle. */
static void touch(free_body *b, int pin)
{
    int i = b->of_pin[pin];

    if (i < 0)
        return;
    b->forces.list[i].at =
        touch_of(&b->circle[pin], b->circle_scale, b->forces.list[i].at, b->forces.list[i].F);
    if (b->circle[pin].radius > 0)
        b->forces.list[i].body = 0; /* it goes along the circle */
}

/* The distance of its pins; of a block the length of the crank; of a yoke, and of a lever in a motion, whose
** pins move apart, how far its slider goes. */
static double length_of(const picture *p, const picture_row *r, const free_body *b)
{
    double length = place_distance(b->first, b->second), near, far;
    int of = b->link - FOURLINK_FOLLOWER - 1;

    if (of > 0 && of % 2 && p->v.design->group[of / 2].hang == FOURLINK_HANGS_BY_OWN_SLOT) {
        geometry_slot slot = geometry_find_slot(&p->v, &r->now.state, of / 2);

        length = slot.to - slot.from;
    }
    if (b->link == p->v.kind.slotted && (p->on.motion || p->v.kind.guided)) {
        geometry_find_way(&p->v, r->now.branch, &near, &far);
        length = GSL_MAX_DBL(fabs(near), fabs(far));
    }
    return length > 0 ? length : p->v.design->link[FOURLINK_CRANK].length;
}

/* The pins of a link; of an output P and Q of the rod, D and Q of a rocker, Q and, with a slot, P of a
** slider. */
static void find_pins(free_body *b, const picture *p, const picture_row *r)
{
    int i = (b->link - FOURLINK_FOLLOWER - 1) / 2;
    geometry_output x;

    b->of_pin[0] = b->of_pin[1] = -1;
    b->circle[0].radius = b->circle[1].radius = 0;
    if (b->link <= FOURLINK_FOLLOWER) {
        const fourlink_joint *ends = &p->v.kind.joint[b->link - FOURLINK_CRANK];

        b->first = tracks_vector(&r->numbers, TRACK_OF_JOINT(&ends[0]));
        b->second = tracks_vector(&r->numbers, TRACK_OF_JOINT(&ends[1]));
        return;
    }
    x = geometry_find_output(&p->v, &r->now.state, i);
    if (b->link % 2) {
        b->first = x.P;
        b->second = x.Q;
    } else {
        b->first = p->v.design->group[i].end == FOURLINK_GROUP_TURNS ? x.D : x.Q;
        b->second = p->v.design->group[i].hang == FOURLINK_HANGS_BY_OWN_SLOT ? x.P : x.Q;
    }
}

static void open_body(free_body *b, const picture *p, const picture_row *r, int link)
{
    b->link = link;
    find_pins(b, p, r);
    b->G = geometry_of_link(&r->now.state, link, &tracks_link(&p->v, link)->cg);
    b->length = length_of(p, r, b);
    b->forces.n = 0;
    add_forces(b, p, r, SCENE_PIN);
    b->circle_scale = scale_of_circles(b->length, &b->circle[0], &b->circle[1]);
    touch(b, 0);
    touch(b, 1);
    add_forces(b, p, r, SCENE_LOAD);
    add_forces(b, p, r, SCENE_INERTIA);
}

/* 1 for a link that is no more than a block, which is as long as the crank here. */
static int is_block(const picture *p, int link)
{
    const fourlink_group *g;

    if (link <= FOURLINK_FOLLOWER)
        return p->v.kind.shape[link] == FOURLINK_SHAPE_BLOCK;
    g = &p->v.design->group[(link - FOURLINK_FOLLOWER - 1) / 2];
    return link % 2 == 0 && g->end == FOURLINK_GROUP_SLIDES &&
           g->hang != FOURLINK_HANGS_BY_OWN_SLOT;
}

/* The link with which lines between its pins move: 0 if one of them slides on it. */
static int body_of_pins(const picture *p, int link)
{
    int of = link - FOURLINK_FOLLOWER - 1;

    return link == p->v.kind.slotted ||
                   (of > 0 && of % 2 &&
                    p->v.design->group[of / 2].hang == FOURLINK_HANGS_BY_OWN_SLOT)
               ? 0
               : link;
}

/* Draw a pin, in the middle of its friction circle if it has one. */
static void draw_pin(sketch *s, const picture *p, const free_body *b, int pin)
{
    fourlink_vector at = pin ? b->second : b->first, other = pin ? b->first : b->second;
    int joint = b->link - FOURLINK_CRANK + pin;
    const char *letter = p->v.kind.joint[joint].letter;

    sketch_show(s, SKETCH_PIN, (unsigned long)joint);
    sketch_with(s, b->link == p->v.kind.slotted && pin ? 0 : b->link);
    sketch_away(s, other);
    sketch_with(s, b->link == p->v.kind.slotted && !pin ? 0 : b->link);
    if (b->circle[pin].radius > 0 || is_block(p, b->link))
        sketch_upright(s, at);
    if (b->circle[pin].radius > 0) {
        sketch_arc(s, PEN_OTHER, at, b->circle_scale * b->circle[pin].radius, 0, 2 * M_PI);
        sketch_dot(s, at, letter);
        sketch_beyond(s, b->circle_scale * b->circle[pin].radius);
    } else {
        sketch_pin(s, at, letter);
    }
    if (p->v.kind.slides_on[b->link] || (b->link == p->v.kind.slotted && pin == 0))
        figure_beyond_block(s);
    figure_letter(s, at, other, other, letter);
}

/* The pins of a link of an output, by their letters. */
static void draw_output_pins(sketch *s, const picture *p, const free_body *b)
{
    int i = (b->link - FOURLINK_FOLLOWER - 1) / 2, is_rod = b->link % 2;
    const fourlink_group *g = &p->v.design->group[i];
    const char *second = g->hang == FOURLINK_HANGS_BY_OWN_SLOT ? "P" : "Q",
               *first = is_rod                           ? "P"
                        : g->end == FOURLINK_GROUP_TURNS ? "D"
                                                         : second;

    sketch_show(s, SKETCH_PIN, (unsigned long)(FOURLINK_FOLLOWER + 3 * i + (is_rod ? 0 : 2)));
    sketch_with(s, b->link);
    if (is_rod || g->end == FOURLINK_GROUP_TURNS) {
        sketch_pin(s, b->first, first);
        figure_letter(s, b->first, b->second, b->second, first);
    }
    sketch_show(s, SKETCH_PIN, (unsigned long)(FOURLINK_FOLLOWER + 3 * i + 1));
    sketch_with(s, body_of_pins(p, b->link));
    sketch_pin(s, b->second, second);
    figure_letter(s, b->second, b->first, b->first, second);
}

/* Draw thin lines to where outputs act on a link. */
static void draw_carried(sketch *s, const picture *p, const picture_row *r, const free_body *b)
{
    int i;

    for (i = 0; i < r->drawn.n_forces; i++) {
        const scene_force *f = &r->drawn.forces[i];

        if (f->on != b->link || f->at < TRACK_OUTPUT || f->sign > 0)
            continue;
        sketch_show(s, SKETCH_OFF, (unsigned long)(VIEW_LOADS + i));
        sketch_with(s, body_of_pins(p, b->link) ? body_at(b, p, r, f->at) : 0);
        figure_off(s, b->first, b->second, tracks_vector(&r->numbers, f->at));
    }
    (void)p;
}

/* Draw the body between its pins, out to its loads and outputs, with its centre of mass. */
static void draw_body(sketch *s, const picture *p, const picture_row *r, const free_body *b)
{
    unsigned long i;

    sketch_show(s, SKETCH_LINK, (unsigned long)b->link);
    sketch_with(s, b->link);
    if (b->link > FOURLINK_FOLLOWER)
        figure_output_link(s, p, &r->now.state, b->link);
    else if (b->link == p->v.kind.slotted)
        figure_lever(s, p, &r->now.state, PEN_FOLLOWER);
    else if (p->v.kind.slides_on[b->link])
        figure_piston(s, (pen)b->link, b->first, &r->now.state.link[b->link].axis);
    else
        sketch_line(s, (pen)b->link, b->first, b->second);
    for (i = 0; i < p->v.problem.n_loads; i++) {
        sketch_show(s, SKETCH_OFF, i);
        sketch_with(s, body_of_pins(p, b->link));
        if (r->loads[i].link == b->link)
            figure_off(s, b->first, b->second,
                       geometry_of_link(&r->now.state, b->link, &r->loads[i].at));
    }
    draw_carried(s, p, r, b);
    sketch_show(s, SKETCH_CENTRE, (unsigned long)b->link);
    sketch_with(s, body_of_pins(p, b->link));
    if (tracks_link(&p->v, b->link)->mass > 0) {
        figure_off(s, b->first, b->second, b->G);
        sketch_with(s, b->link);
        sketch_centre(s, b->G, "G");
    }
    if (b->link > FOURLINK_FOLLOWER) {
        draw_output_pins(s, p, b);
        return;
    }
    draw_pin(s, p, b, 0);
    if (p->v.kind.shape[b->link] != FOURLINK_SHAPE_BLOCK)
        draw_pin(s, p, b, 1);
}

/* Draw the torques of the pins, but for rounding, and of inertia. */
static void put_torques(sketch *s, const picture *p, const picture_row *r, const free_body *b)
{
    double size = arrow_largest(&b->forces) * p->v.design->link[FOURLINK_CRANK].length;
    char words[80];
    int i;

    for (i = 0; i < r->drawn.n_torques; i++) {
        const scene_force *f = &r->drawn.torques[i];
        double value = format_settled(f->sign * tracks_vector(&r->numbers, f->of).x, size);

        if (f->on == b->link && !f->load && (f->sort != SCENE_PIN || value != 0))
            arrow_draw_torque(
                s, p, i, body_at(b, p, r, f->at), f->sort == SCENE_PIN ? PEN_FORCE : PEN_RESULT,
                scene_words(f, words, sizeof words), tracks_vector(&r->numbers, f->at), value);
    }
}

/* In a motion a body turns about its middle, a lever about its pin. */
static void hold_body(sketch *s, const picture *p, const picture_row *r, const free_body *b)
{
    int of = b->link - FOURLINK_FOLLOWER - 1;

    if (p->on.motion && of > 0 && p->v.design->group[of / 2].hang == FOURLINK_HANGS_BY_OWN_SLOT)
        sketch_hold(s, b->first);
    else if (p->on.motion && b->link == p->v.kind.slotted)
        sketch_hold(s, tracks_vector(&r->numbers, TRACK_OF_JOINT(&p->v.kind.joint[3])));
    else if (p->on.motion)
        sketch_hold(s, place_middle(b->first, b->second));
}

/* Draw the body with forces and torques; in a motion one scale is that of all positions. */
static void put_free_body(picture *p, const picture_row *r, const free_body *b,
                          double largest_of_motion)
{
    double largest = arrow_longest(&b->forces, largest_of_motion);
    double longest = (p->on.motion ? LONGEST_OF_MOTION : LONGEST) * b->length;
    char number[FORMAT_SIZE];
    sketch s;

    sketch_open(&s, &p->on, &p->v.units[QUANTITY_LENGTH], 1.4 * b->length);
    hold_body(&s, p, r, b);
    sketch_body(&s, b->link, s.held, r->now.state.link[b->link].axis);
    s.letter = LETTER;
    if (is_block(p, b->link))
        s.block = HALF_BLOCK * b->length;
    draw_body(&s, p, r, b);
    if (largest > 0) {
        if (arrow_draw(&b->forces, &s, p, longest / largest, largest))
            arrow_note_missing(&s, p, largest);
        arrow_draw_scale(&s, p, QUANTITY_FORCE, longest / largest, largest);
    } else {
        sketch_show(&s, SKETCH_MISSING, 1);
        sketch_note(&s, NO_FORCES);
    }
    arrow_draw_load_torques(&s, p, r, b->link, 1);
    put_torques(&s, p, r, b);
    sketch_show(&s, SKETCH_CIRCLES, 0);
    if (b->circle[0].radius > 0 || b->circle[1].radius > 0)
        sketch_value(&s, "friction circles ", format_general(b->circle_scale, 6, number), ":1");
    sketch_close(&s, b->link > FOURLINK_FOLLOWER ? "free body of %s" : "free body of the %s",
                 fourlink_deck_link_text(p->v.deck, b->link));
}

/* Draw the same forces in sequence: the polygon closes. */
static void put_force_polygon(picture *p, const free_body *b)
{
    fourlink_vector at = zero;
    polygon g;
    int i;

    open_polygon(&g, p, QUANTITY_FORCE, NO_FORCES);
    for (i = 0; i < b->forces.n; i++) {
        arrow_put(&g.sides, i, b->forces.list[i].kind, b->forces.list[i].name, at,
                  b->forces.list[i].F);
        at = end_of(&g.sides.list[i]);
    }
    draw_sides(&g);
    sketch_close(&g.s, b->link > FOURLINK_FOLLOWER ? "forces on %s" : "forces on the %s",
                 fourlink_deck_link_text(p->v.deck, b->link));
}

static void put_mechanism(picture *p, const fourlink_instant *now)
{
    sketch s;

    figure_open(&s, p, now->branch);
    s.letter = LETTER;
    figure_frame(&s, p, &now->state);
    figure_draw(&s, p, &now->state, 1);
    spring_draw(&s, p, &now->state, 0);
    figure_close(&s, p, now, "");
}

void vectors_draw_body(picture *p, const picture_row *r, int link, double largest)
{
    free_body body;

    open_body(&body, p, r, link);
    put_free_body(p, r, &body, largest);
}

double vectors_largest(const picture *p, const picture_row *r, int link)
{
    free_body body;

    open_body(&body, p, r, link);
    return arrow_largest(&body.forces);
}

const char *picture_vectors(picture *p, fourlink_branch branch)
{
    picture_row r;
    free_body body;
    scene_polygon sides;
    int link, k, status = picture_row_find(p, branch, &r);

    if (status != FOURLINK_OK)
        return fourlink_status_text(status);
    if (p->request->part == PLOT_WHOLE) {
        p->on.fills_row = 1;
        put_mechanism(p, &r.now);
    }
    for (k = 0; k < scene_count_polygons(&p->v) && p->request->part != PLOT_OF_FORCES; k++) {
        scene_find_polygon(&p->v, k, &sides);
        vectors_draw_polygon(p, &r, &sides, 0);
    }
    if (p->request->part == PLOT_OF_MOTION || !p->v.problem.has_forces)
        return NULL;
    for (k = 0; (link = scene_body(&p->v, k)) != 0; k++) {
        open_body(&body, p, &r, link);
        put_free_body(p, &r, &body, 0);
        put_force_polygon(p, &body);
    }
    return NULL;
}
