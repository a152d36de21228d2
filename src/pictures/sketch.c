/* SPDX-License-Identifier: GPL-3.0-or-later
**
** sketch.c - a drawing to scale: lines, arrows, circles, texts, curves.
*/
#include <math.h>
#include <stdarg.h>

#include <gsl/gsl_math.h>

#include "base/message.h"
#include "sketch.h"
#include "system/format.h"
#include "system/memory.h"

/* As fractions of the drawing's size: the height of a letter, and */
#define LETTER 0.028
#define PIN 0.4
#define DOT 0.15
#define RING 0.28
#define SUPPORT 1.3
#define HATCH 0.65

/* The width of a letter is that of digits; names are narrower. */
#define NARROW 0.9

#define TICS 7 /* smallest distance between two, in letters */

/* Texts avoid every so many points of a curve. */
#define OBSTACLE 4

static fourlink_vector turned(const sketch *s, fourlink_vector p)
{
    double x = p.x - s->held.x, y = p.y - s->held.y;

    return place_at(s->cosine * x - s->sine * y + s->shift.x,
                    s->sine * x + s->cosine * y + s->shift.y);
}

/* A place in the drawing's unit. */
static fourlink_vector in_unit(const sketch *s, fourlink_vector at)
{
    return place_at(at.x * s->unit->down / s->unit->up, at.y * s->unit->down / s->unit->up);
}

/* Keys: what, its number, 1,024 parts, and 256 pieces of a part that the window cuts. */
#define NUMBERS 256UL
#define PARTS 1024UL
#define PIECES 256UL

void sketch_show(sketch *s, sketch_subject what, unsigned long number)
{
    s->subject = s->part = ((unsigned long)what * NUMBERS + number) * PARTS * PIECES;
    s->c->d->hold = 0;
}

void sketch_skip(sketch *s, unsigned long parts)
{
    s->part += parts * PIECES;
}

/* The key of the next part, which the items have that are added now. */
static unsigned long next_part(sketch *s)
{
    s->c->d->key = s->part;
    sketch_skip(s, 1);
    return s->c->d->key;
}

/* The key of a link's frame; the ground stands still, as the sheet does. */
static unsigned long key_of(int link)
{
    return link <= FOURLINK_GROUND
               ? 0
               : ((unsigned long)SKETCH_BODY * NUMBERS + (unsigned long)link) * PARTS * PIECES;
}

void sketch_with(sketch *s, int link)
{
    s->c->d->hold = s->c->motion ? key_of(link) : 0;
}

/* Begin a frame at a place that moves with what is said now; then it holds what follows. */
static display_item *add_frame(sketch *s, unsigned long key, fourlink_vector origin)
{
    display_item *x;

    s->c->d->key = key;
    x = display_add(s->c->d, DISPLAY_FRAME, PEN_OF_LINK, DISPLAY_BACK);
    display_add_place(s->c->d, in_unit(s, turned(s, origin)));
    s->c->d->hold = key;
    return x;
}

void sketch_body(sketch *s, int link, fourlink_vector origin, fourlink_vector axis)
{
    if (!s->c->motion)
        return;
    add_frame(s, key_of(link), origin);
    display_add_place(s->c->d, in_unit(s, turned(s, place_in(origin, axis, s->size, 0))));
}

void sketch_upright(sketch *s, fourlink_vector at)
{
    if (s->c->motion)
        add_frame(s, next_part(s), at);
}

void sketch_along(sketch *s, fourlink_vector from, int link, fourlink_vector to, int is_stretched)
{
    unsigned long key;

    if (!s->c->motion)
        return;
    key = next_part(s);
    add_frame(s, key, from)->size = is_stretched;
    sketch_with(s, link);
    display_add_place(s->c->d, in_unit(s, turned(s, to)));
    s->c->d->hold = key;
}

void sketch_hold(sketch *s, fourlink_vector at)
{
    s->held = at;
}

static void include(sketch *s, fourlink_vector p)
{
    if (!s->is_fixed)
        place_grow(&s->drawn, p.x, p.y);
}

void sketch_include(sketch *s, fourlink_vector p)
{
    include(s, turned(s, p));
}

void sketch_window(sketch *s, fourlink_vector middle, double half)
{
    middle = turned(s, middle);
    s->is_window = s->is_fixed = 1;
    s->drawn = place_nothing;
    place_grow(&s->drawn, middle.x - half, middle.y - half);
    place_grow(&s->drawn, middle.x + half, middle.y + half);
}

void sketch_turn(sketch *s, int is_turned)
{
    s->cosine = is_turned ? cos(s->c->turn) : 1;
    s->sine = is_turned ? sin(s->c->turn) : 0;
    s->shift = is_turned ? s->place : place_at(0, 0);
}

void sketch_place(sketch *s, fourlink_vector place)
{
    s->place = place;
    sketch_turn(s, 1);
}

void sketch_open(sketch *s, canvas *c, const fourlink_unit *unit, double size)
{
    /* field by field: the room for texts is 100 kB, and a motion opens a thousand sketches */
    s->c = c;
    s->unit = unit;
    s->drawn = place_nothing;
    s->is_fixed = s->is_window = 0;
    s->size = size;
    s->letter = LETTER;
    s->block = 0;
    s->held = s->place = place_at(0, 0);
    s->n_notes = s->n_entries = s->texts.n = s->texts.n_obstacles = 0;
    s->scale.length = s->beyond = s->is_away = 0;
    s->shrink = 1;
    if (c->motion && c->motion->phase != LABELS_MEASURE) {
        s->is_fixed = 1;
        s->drawn = c->motion->drawn;
    }
    sketch_show(s, SKETCH_OTHER, 0);
    sketch_turn(s, 1);
    canvas_begin_panel(c);
}

static void add_obstacle(sketch *s, fourlink_vector from, fourlink_vector to, double weight)
{
    obstacle *new = &s->texts.obstacles[s->texts.n_obstacles];

    if (s->texts.n_obstacles == LABELS_OBSTACLES)
        return;
    new->from = from;
    new->to = to;
    new->weight = weight;
    s->texts.n_obstacles++;
}

/* 1 if a place is beyond the window. */
static int is_beyond(const sketch *s, fourlink_vector at)
{
    const place_box *b = &s->drawn;

    return s->is_window &&
           (at.x < b->x_min || at.x > b->x_max || at.y < b->y_min || at.y > b->y_max);
}

int sketch_shows(const sketch *s, fourlink_vector at)
{
    return !is_beyond(s, turned(s, at));
}

/* Keep room for a line, which texts should not cover. */
static void take_line(sketch *s, pen p, fourlink_vector from, fourlink_vector to)
{
    include(s, from);
    include(s, to);
    if (p != PEN_GHOST)
        add_obstacle(s, from, to, p == PEN_CONSTRUCTION || p == PEN_OTHER ? 1 : 3);
}

/* Put a line; one that a window cuts moves with nothing. */
static void put_line(sketch *s, pen p, fourlink_vector from, fourlink_vector to, int has_head)
{
    unsigned long hold = s->c->d->hold;
    fourlink_vector first = from = turned(s, from), last = to = turned(s, to);
    display_item *line;

    has_head = has_head && !is_beyond(s, to);
    if (s->is_window && !place_clip(&s->drawn, &from, &to))
        return;
    take_line(s, p, from, to);
    if (place_distance(from, first) + place_distance(to, last) > 0)
        s->c->d->hold = 0;
    line = display_line(s->c->d, (int)p, DISPLAY_LINES, in_unit(s, from), in_unit(s, to));
    line->sort = has_head ? DISPLAY_ARROW : DISPLAY_LINE;
    line->size = has_head ? canvas_head(s->c) : 0;
    s->c->d->hold = hold;
}

void sketch_line(sketch *s, pen p, fourlink_vector from, fourlink_vector to)
{
    next_part(s);
    put_line(s, p, from, to, 0);
}

void sketch_arrow(sketch *s, pen p, fourlink_vector from, fourlink_vector to)
{
    next_part(s);
    put_line(s, p, from, to, 1);
}

void sketch_vector(sketch *s, pen p, fourlink_vector at, fourlink_vector v, double scale,
                   const char *name)
{
    display *d = s->c->d;
    unsigned long hold = d->hold;
    size_t n = d->n_items;
    fourlink_vector to = place_in(at, v, scale, 0);

    sketch_away(s, at);
    sketch_upright(s, at);
    sketch_arrow(s, p, at, to);
    if (!memory_has_failed() && d->n_items > n + 1 && d->holds[d->n_places - 2])
        d->holds[d->n_places - 2] = hold; /* it begins at a place that moves with what was said */
    if (name[0])
        sketch_text(s, to, v.x, v.y, name);
    s->is_away = 0;
    d->hold = hold;
}

/* A place of an arc or a spiral, after a part of it. */
static fourlink_vector on_arc(fourlink_vector centre, double inner, double outer, double from,
                              double to, double part)
{
    return place_polar(centre, inner + part * (outer - inner), from + part * (to - from));
}

/* An arc is one line unless the window cuts it. */
void sketch_spiral(sketch *s, pen p, fourlink_vector centre, double inner, double outer,
                   double from, double to)
{
    int n = 8 + (int)(fabs(to - from) / DISPLAY_ARC_STEP), is_cut = 0, i;
    double turn = atan2(s->sine, s->cosine);
    fourlink_vector last = on_arc(centre, inner, outer, from, to, 0), next;

    next_part(s);
    for (i = 0; i <= n; i++)
        is_cut |= is_beyond(s, turned(s, on_arc(centre, inner, outer, from, to, (double)i / n)));
    if (!is_cut) {
        display_item *arc =
            display_arc(s->c->d, (int)p, in_unit(s, turned(s, centre)), from + turn, to - from);

        arc->radius[0] = in_unit(s, place_at(inner, 0)).x;
        arc->radius[1] = in_unit(s, place_at(outer, 0)).x;
    }
    for (i = 1; i <= n; i++) {
        next = on_arc(centre, inner, outer, from, to, (double)i / n);
        s->c->d->key++; /* a piece of this part */
        if (is_cut)
            put_line(s, p, last, next, 0);
        else
            take_line(s, p, turned(s, last), turned(s, next));
        last = next;
    }
}

void sketch_arc(sketch *s, pen p, fourlink_vector centre, double radius, double from, double to)
{
    sketch_spiral(s, p, centre, radius, radius, from, to);
}

/* Add a disc as an obstacle, by its diameters. */
static void add_disc(sketch *s, fourlink_vector at, double radius)
{
    int i;

    for (i = 0; i < 4; i++) {
        double x = 1.2 * radius * cos(i * M_PI / 4), y = 1.2 * radius * sin(i * M_PI / 4);

        add_obstacle(s, place_beside(at, -x, -y), place_beside(at, x, y), 5);
    }
}

/* Draw a disc, which texts should not cover. */
static void put_disc(sketch *s, display_sort sort, fourlink_vector at, double part, int is_open,
                     const char *name)
{
    double radius = part * s->letter * s->size;
    size_t kept = display_keep(s->c->d, name);
    display_item *disc;

    next_part(s);
    at = turned(s, at);
    if (is_beyond(s, at))
        return;
    include(s, at);
    add_disc(s, at, radius);
    disc = display_add(s->c->d, sort, PEN_GROUND, DISPLAY_FRONT);
    disc->is_open = is_open;
    disc->name = kept;
    disc->size = in_unit(s, place_at(radius, 0)).x;
    display_add_place(s->c->d, in_unit(s, at));
}

void sketch_dot(sketch *s, fourlink_vector at, const char *name)
{
    put_disc(s, DISPLAY_DISC, at, DOT, 0, name);
}

void sketch_pin(sketch *s, fourlink_vector at, const char *name)
{
    put_disc(s, DISPLAY_DISC, at, PIN, 1, name);
}

void sketch_centre(sketch *s, fourlink_vector at, const char *name)
{
    put_disc(s, DISPLAY_CENTRE, at, 0.7 * PIN, 0, name);
}

#define HEAD 0.3 /* rad, of an arc with a head */

void sketch_turn_arrow(sketch *s, pen p, fourlink_vector centre, double radius, double from,
                       double to)
{
    double before = to + (to > from ? -HEAD : HEAD);

    sketch_arc(s, p, centre, radius, from, before);
    sketch_arrow(s, p, place_polar(centre, radius, before), place_polar(centre, radius, to));
}

void sketch_torque(sketch *s, pen p, fourlink_vector centre, double radius, double sign)
{
    double end = sign > 0 ? 5 * M_PI / 4 : -M_PI / 4, before = end + (sign > 0 ? -HEAD : HEAD);

    sketch_arc(s, p, centre, radius, -M_PI / 4, 5 * M_PI / 4);
    sketch_arrow(s, p, place_polar(centre, radius, before), place_polar(centre, radius, end));
}

/* Add a text; null if there is no room for one. */
static label *add_text(sketch *s, fourlink_vector at, double dx, double dy, const char *words)
{
    label *new = &s->texts.list[s->texts.n];
    unsigned long key = next_part(s);
    fourlink_vector side = turned(s, place_beside(s->held, dx, dy));
    double way = s->letter * s->size, length;
    int is_away = s->is_away && place_distance(s->away, turned(s, at)) > 0;

    new->beyond = s->beyond;
    s->beyond = s->is_away = 0;
    at = turned(s, at);
    if (s->texts.n == LABELS_MOST || is_beyond(s, at))
        return NULL;
    include(s, at);
    new->key = key;
    new->at = at;
    new->dx = side.x - s->shift.x;
    new->dy = side.y - s->shift.y;
    length = gsl_hypot(new->dx, new->dy);
    new->hold = s->c->d->hold;
    new->behind_hold = is_away ? s->away_hold : new->hold;
    new->behind = is_away      ? s->away
                  : length > 0 ? place_beside(at, -way * new->dx / length, -way * new->dy / length)
                               : place_beside(at, 0, -way);
    flk_text_join(new->words, sizeof new->words, words, (char *)NULL);
    new->half = canvas_width_of(words) * (s->c->is_text ? 1 : NARROW) / 2;
    new->is_close = new->has_leader = new->is_hidden = 0;
    s->texts.n++;
    return new;
}

void sketch_text(sketch *s, fourlink_vector at, double dx, double dy, const char *words)
{
    add_text(s, at, dx, dy, words);
}

void sketch_beyond(sketch *s, double radius)
{
    s->beyond = radius;
}

void sketch_away(sketch *s, fourlink_vector from)
{
    s->is_away = 1;
    s->away = turned(s, from);
    s->away_hold = s->c->d->hold;
}

void sketch_letter(sketch *s, fourlink_vector at, double dx, double dy, const char *words)
{
    s->beyond = GSL_MAX_DBL(s->beyond, PIN * s->letter * s->size);
    add_text(s, at, dx, dy, words);
}

void sketch_name(sketch *s, fourlink_vector at, double dx, double dy, const char *words)
{
    label *new = add_text(s, at, dx, dy, words);

    if (new)
        new->has_leader = 1;
}

void sketch_number(sketch *s, fourlink_vector at, double dx, double dy, const char *words)
{
    label *new = add_text(s, at, dx, dy, words);

    if (new)
        new->is_close = 1;
}

void sketch_text_around(sketch *s, fourlink_vector centre, double radius, double angle,
                        const char *words)
{
    sketch_away(s, centre);
    sketch_text(s, place_polar(centre, radius, angle), cos(angle), sin(angle), words);
}

void sketch_ring(sketch *s, fourlink_vector at, const char *name)
{
    put_disc(s, DISPLAY_DISC, at, RING, 1, name);
}

void sketch_mark(sketch *s, fourlink_vector at, const char *name)
{
    size_t kept = display_keep(s->c->d, name);

    if (!s->c->is_bare)
        return;
    next_part(s);
    display_add(s->c->d, DISPLAY_DISC, PEN_GROUND, DISPLAY_FRONT)->name = kept;
    display_add_place(s->c->d, in_unit(s, turned(s, at)));
}

void sketch_ground(sketch *s, double x1, double x2, double y, double side)
{
    double step = HATCH * s->letter * s->size, x;

    sketch_line(s, PEN_GROUND, place_at(x1, y), place_at(x2, y));
    for (x = x1 + step; step > 0 && x <= x2 + 1e-9 * step; x += step)
        sketch_line(s, PEN_CONSTRUCTION, place_at(x, y), place_at(x - step, y + side * step));
}

void sketch_support(sketch *s, fourlink_vector at)
{
    double r = SUPPORT * s->letter * s->size;
    fourlink_vector left = place_beside(at, -0.6 * r, -r), right = place_beside(at, 0.6 * r, -r);

    sketch_line(s, PEN_GROUND, at, left);
    sketch_line(s, PEN_GROUND, at, right);
    sketch_ground(s, at.x - r, at.x + r, at.y - r, -1);
}

void sketch_curve(sketch *s, pen p, const char *title, const fourlink_vector *points, int n)
{
    size_t kept = display_keep(s->c->d, title);
    fourlink_vector at, last = {0, 0};
    int in_piece = 0, is_empty = 1, i;

    next_part(s);
    display_add(s->c->d, DISPLAY_CURVE, (int)p, DISPLAY_CURVES)->name = kept;
    for (i = 0; i < n; i++) {
        if (gsl_isnan(points[i].x)) {
            display_add_place(s->c->d, points[i]);
            in_piece = 0;
            continue;
        }
        at = turned(s, points[i]);
        include(s, at);
        if (in_piece % OBSTACLE == 0) {
            if (in_piece)
                add_obstacle(s, last, at, 1);
            last = at;
        }
        in_piece++;
        is_empty = 0;
        display_add_place(s->c->d, in_unit(s, at));
    }
    if (!is_empty)
        sketch_key(s, p, s->n_entries < SKETCH_TITLES ? title : "");
}

/* The end of a text that is nearest to a place, in pixels from its own place. */
static fourlink_vector edge_of(const label *x, double px, double py)
{
    double h = 0.35 * CANVAS_LINE;

    return place_at(GSL_MAX_DBL(x->middle.x - x->half, GSL_MIN_DBL(x->middle.x + x->half, px)),
                    GSL_MAX_DBL(x->middle.y - h, GSL_MIN_DBL(x->middle.y + h, py)));
}

/* The distance of a place from a text, in pixels. */
static double distance_of(const sketch *s, const label *x, fourlink_vector at)
{
    double px = (at.x - x->at.x) / s->texts.scale, py = (at.y - x->at.y) / s->texts.scale;
    fourlink_vector edge = edge_of(x, px, py);

    return gsl_hypot(edge.x - px, edge.y - py);
}

#define FAR 14.0 /* pixels: a text so far from its place has a line to it, */
#define SURE 2.0 /* and one that is not so many times nearer to it than to another */

/* Draw a line from a name to its point, if the text could be that of another. */
static void put_leader(const sketch *s, const label *x)
{
    double own = distance_of(s, x, x->at), other = GSL_POSINF;
    fourlink_vector from, to = in_unit(s, x->at);
    int i;

    for (i = 0; i < s->texts.n; i++)
        if (&s->texts.list[i] != x && s->texts.list[i].has_leader)
            other = GSL_MIN_DBL(other, distance_of(s, x, s->texts.list[i].at));
    if (own < FAR && SURE * own < other)
        return;
    from = edge_of(x, 0, 0);
    from = in_unit(s, place_in(x->at, from, s->texts.scale, 0));
    display_line(s->c->d, PEN_LEADER, DISPLAY_FRONT, from, to);
}

/* Leave a text to the script: beside its place, away from one behind it. */
static void put_free_label(const sketch *s, const label *x)
{
    display_item *put;

    s->c->d->hold = x->hold;
    put = display_text(s->c->d, 0, in_unit(s, x->at), DISPLAY_MIDDLE, x->words);
    put->is_boxed = 1;
    put->size = in_unit(s, place_at(x->beyond, 0)).x;
    s->c->d->hold = x->behind_hold;
    display_add_place(s->c->d, in_unit(s, x->behind));
    s->c->d->hold = 0;
}

/* Put a text at its side: beyond half its width it begins or ends there, in a motion its middle stays. */
static void put_label(const sketch *s, const label *x)
{
    int side = s->c->motion ? 0 : x->middle.x > x->half ? 1 : x->middle.x < -x->half ? -1 : 0;
    display_align align = side > 0 ? DISPLAY_LEFT : side < 0 ? DISPLAY_RIGHT : DISPLAY_MIDDLE;
    display_item *put = display_text(s->c->d, 0, in_unit(s, x->at), align, x->words);

    put->is_boxed = 1;
    put->dx = x->middle.x - side * x->half;
    put->dy = -x->middle.y;
}

static void put_labels(const sketch *s)
{
    int i;

    s->c->d->hold = 0;
    for (i = 0; i < s->texts.n; i++) {
        const label *one = &s->texts.list[i];

        if (one->is_hidden)
            continue;
        s->c->d->key = one->key;
        if (one->has_leader && !s->c->is_text && !s->c->motion)
            put_leader(s, one);
        (s->c->is_bare ? put_free_label : put_label)(s, one);
    }
}

/* A step of tics, far enough apart for their numbers, and smaller if there would be fewer than two. */
static double step_of(double step, double middle, double size)
{
    int i;

    for (i = 0; i < 6; i++) {
        double low = middle - size / 2, high = middle + size / 2;

        if (floor(high / step) - ceil(low / step) >= 1)
            break;
        step = place_round(0.4 * step);
    }
    return step;
}

static void put_axes(const sketch *s)
{
    double scale = in_unit(s, place_at(s->texts.scale, 0)).x;
    double width = scale * s->c->box_width, height = scale * s->c->box_height;
    double step = place_round(TICS * CANVAS_LETTER * scale);
    place_box axes;
    fourlink_vector middle = in_unit(
        s, place_at((s->drawn.x_min + s->drawn.x_max) / 2, (s->drawn.y_min + s->drawn.y_max) / 2));

    axes.x_min = middle.x - width / 2;
    axes.x_max = middle.x + width / 2;
    axes.y_min = middle.y - height / 2;
    axes.y_max = middle.y + height / 2;
    canvas_set_axes(s->c, axes, step_of(step, middle.x, width), step_of(step, middle.y, height));
}

void sketch_scale(sketch *s, pen p, double length, const char *value, const char *unit)
{
    double below = s->is_window ? -0.06 : 0.16; /* in a window it is inside */
    fourlink_vector from = place_at(s->drawn.x_min, s->drawn.y_min - below * s->size);
    fourlink_vector to = place_beside(from, length, 0);
    char words[LABELS_WORDS];

    if (canvas_has_scales(s->c)) {
        s->scale.p = p;
        s->scale.length = length;
        flk_text_join(s->scale.value, sizeof s->scale.value, value, (char *)NULL);
        flk_text_join(s->scale.unit, sizeof s->scale.unit, unit, (char *)NULL);
        return;
    }
    flk_text_join(words, sizeof words, value, unit, (char *)NULL);
    sketch_turn(s, 0);
    sketch_arrow(s, p, from, to);
    sketch_text(s, to, 0.7, 0, words);
    sketch_turn(s, 1);
}

#define BAR 0.055   /* of the width, at least: the scale of lengths */
#define INDENT 12.0 /* of the first */

static void put_scales(const sketch *s)
{
    double unit = in_unit(s, place_at(s->texts.scale, 0)).x / s->shrink;
    double bar = place_round(BAR * s->c->box_width * unit), next;
    char value[FORMAT_SIZE], words[NOTATION_SIZE + 1], own[NOTATION_SIZE];

    flk_text_join(words, sizeof words, " ", canvas_unit(s->c, s->unit->name, own), (char *)NULL);
    next = canvas_scale(s->c, INDENT, bar / unit, 0, format_general(bar, 6, value), words);
    if (s->scale.length > 0)
        canvas_scale(s->c, next, s->scale.length / s->texts.scale, (int)s->scale.p, s->scale.value,
                     s->scale.unit);
}

/* A position of a motion whose range is being found, or whose texts are kept, is not drawn; returns 1. */
static int is_before_drawing(sketch *s)
{
    labels_motion *m = s->c->motion;

    if (!m || m->phase == LABELS_DRAW)
        return 0;
    if (m->phase == LABELS_KEEP) {
        canvas_place_panel(s->c, 2, sketch_margin_width(s));
        labels_keep(m, &s->texts, s->size, s->c->box_width, s->c->box_height);
    } else if (!place_is_empty(&s->drawn)) {
        place_grow(&m->drawn, s->drawn.x_min, s->drawn.y_min);
        place_grow(&m->drawn, s->drawn.x_max, s->drawn.y_max);
    }
    canvas_drop_panel(s->c);
    return 1;
}

void sketch_close(sketch *s, const char *format, ...)
{
    char title[MESSAGE_SIZE];
    va_list values;

    if (is_before_drawing(s))
        return;
    va_start(values, format);
    flk_message_list(title, sizeof title, format, values);
    va_end(values);
    if (place_is_empty(&s->drawn)) { /* nothing was drawn */
        place_grow(&s->drawn, -s->size, -s->size);
        place_grow(&s->drawn, s->size, s->size);
    }
    canvas_place_panel(s->c, 2, sketch_margin_width(s));
    if (s->c->motion)
        labels_take_sides(&s->texts, s->c->motion, s->size, s->c->box_width, s->c->box_height);
    else
        labels_place(&s->texts, s->drawn, s->is_fixed, s->size, s->c->box_width, s->c->box_height);
    s->drawn = s->texts.drawn;
    put_labels(s);
    sketch_put_margin(s);
    if (canvas_has_scales(s->c))
        put_scales(s);
    s->c->d->key = 0; /* the axes stand still */
    canvas_titles(s->c, s->c->turn != 0 ? "horizontal" : "x", s->unit->name,
                  s->c->turn != 0 ? "vertical" : "y", s->unit->name, "%s", title);
    put_axes(s);
    canvas_end_panel(s->c);
}
