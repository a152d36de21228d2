/* SPDX-License-Identifier: GPL-3.0-or-later
**
** sketch.c - a drawing to scale, as gnuplot commands: lines, arrows, circles, texts, curves.
*/
#include <math.h>
#include <stdarg.h>
#include <string.h>

#include <gsl/gsl_math.h>

#include "base/message.h"
#include "sketch.h"

/* As fractions of the drawing's size: the height of a letter, and */
#define LETTER 0.028
#define PIN 0.4
#define DOT 0.15
#define SUPPORT 1.3
#define HATCH 0.65

/* The width of a letter is that of digits; names are narrower. */
#define NARROW 0.9

#define MOST_TITLES 18 /* in the key, which is as high as the axes */
#define TICS 7         /* smallest distance between two, in letters */

/* Texts avoid every so many points of a curve. */
#define OBSTACLE 4

static fourlink_vector turned(const sketch *s, fourlink_vector p)
{
    return place_at(s->cosine * p.x - s->sine * p.y, s->sine * p.x + s->cosine * p.y);
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
}

void sketch_open(sketch *s, canvas *c, const fourlink_unit *unit, double size)
{
    memset(s, 0, sizeof *s);
    s->c = c;
    s->unit = unit;
    s->size = size;
    s->letter = LETTER;
    s->drawn = place_nothing;
    sketch_turn(s, 1);
    fputs("unset arrow; unset label; unset object\n", s->c->out);
}

/* A place in the drawing's unit. */
static fourlink_vector in_unit(const sketch *s, fourlink_vector at)
{
    return place_at(at.x * s->unit->down / s->unit->up, at.y * s->unit->down / s->unit->up);
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

static void put_arrow(sketch *s, pen p, fourlink_vector from, fourlink_vector to, const char *kind)
{
    from = turned(s, from);
    to = turned(s, to);
    if (is_beyond(s, to))
        kind = "nohead";
    if (s->is_window && !place_clip(&s->drawn, &from, &to))
        return;
    include(s, from);
    include(s, to);
    if (p != PEN_GHOST)
        add_obstacle(s, from, to, p == PEN_CONSTRUCTION || p == PEN_OTHER ? 1 : 3);
    from = in_unit(s, from);
    to = in_unit(s, to);
    canvas_print(s->c, "set arrow from %.7g,%.7g to %.7g,%.7g %s ls %d\n", from.x, from.y, to.x,
                 to.y, kind, (int)p);
}

static void add_part(sketch *s, pen p, fourlink_vector from, fourlink_vector to)
{
    sketch_part *new = &s->parts[s->n_parts++];

    new->p = p;
    new->from = turned(s, from);
    new->to = turned(s, to);
    include(s, new->from);
    include(s, new->to);
    add_obstacle(s, new->from, new->to, 3);
}

void sketch_line(sketch *s, pen p, fourlink_vector from, fourlink_vector to)
{
    if (s->c->is_text && p >= PEN_CRANK && p <= PEN_FOLLOWER && s->n_parts < SKETCH_PARTS)
        add_part(s, p, from, to);
    else
        put_arrow(s, p, from, to, "nohead");
}

void sketch_arrow(sketch *s, pen p, fourlink_vector from, fourlink_vector to)
{
    /* in a text picture, arrows in front would hide the letters */
    put_arrow(s, p, from, to,
              s->c->is_text ? "head filled size graph 0.025,18"
                            : "head filled size graph 0.025,18 front");
}

/* Drawn as a polygon: gnuplot's circles cannot be dashed. */
void sketch_arc(sketch *s, pen p, fourlink_vector centre, double radius, double from, double to)
{
    int n = 8 + (int)(fabs(to - from) / (M_PI / 30)), i;
    fourlink_vector last = place_polar(centre, radius, from), next;

    for (i = 1; i <= n; i++) {
        next = place_polar(centre, radius, from + (to - from) * i / n);
        sketch_line(s, p, last, next);
        last = next;
    }
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

/* Draw a disc of this colour, as a text's obstacle. */
static void put_disc(sketch *s, fourlink_vector at, double radius, const char *colour)
{
    at = turned(s, at);
    if (is_beyond(s, at))
        return;
    include(s, at);
    add_disc(s, at, radius);
    at = in_unit(s, at);
    canvas_print(s->c,
                 "set object circle at %.7g,%.7g size %.7g front fc rgb '%s' fs solid border "
                 "lc rgb 'black' lw 1.5\n",
                 at.x, at.y, in_unit(s, place_at(radius, 0)).x, colour);
}

void sketch_dot(sketch *s, fourlink_vector at)
{
    put_disc(s, at, DOT * s->letter * s->size, "black");
}

void sketch_pin(sketch *s, fourlink_vector at)
{
    put_disc(s, at, PIN * s->letter * s->size, "white");
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
    fourlink_vector side = turned(s, place_at(dx, dy));

    at = turned(s, at);
    if (s->texts.n == LABELS_MOST || is_beyond(s, at))
        return NULL;
    include(s, at);
    new->at = at;
    new->dx = side.x;
    new->dy = side.y;
    flk_text_join(new->words, sizeof new->words, words, (char *)NULL);
    new->half = canvas_width_of(words) * (s->c->is_text ? 1 : NARROW) / 2;
    new->is_close = new->has_leader = 0;
    s->texts.n++;
    return new;
}

void sketch_text(sketch *s, fourlink_vector at, double dx, double dy, const char *words)
{
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
    sketch_text(s, place_polar(centre, radius, angle), cos(angle), sin(angle), words);
}

void sketch_note(sketch *s, const char *format, ...)
{
    va_list values;

    va_start(values, format);
    if (s->n_notes < SKETCH_NOTES)
        flk_message_list(s->notes[s->n_notes++], LABELS_WORDS, format, values);
    va_end(values);
}

void sketch_centre(sketch *s, fourlink_vector at)
{
    double r = 0.7 * PIN * s->letter * s->size;
    int i;

    at = turned(s, at);
    if (is_beyond(s, at))
        return;
    include(s, at);
    add_disc(s, at, r);
    at = in_unit(s, at);
    r = in_unit(s, place_at(r, 0)).x;
    for (i = 0; i < 4; i++)
        canvas_print(
            s->c,
            "set object circle at %.7g,%.7g size %.7g arc [%d:%d] front fc rgb '%s' fs solid "
            "border lc rgb 'black'\n",
            at.x, at.y, r, 90 * i, 90 * i + 90, i % 2 ? "white" : "black");
}

void sketch_ground(sketch *s, double x1, double x2, double y, double side)
{
    double step = HATCH * s->letter * s->size, x;

    sketch_line(s, PEN_GROUND, place_at(x1, y), place_at(x2, y));
    for (x = x1 + step; x <= x2 + 1e-9 * step; x += step)
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

static void add_entry(sketch *s, pen p, int is_curve, const char *title)
{
    sketch_entry *new = &s->entries[s->n_entries++];

    new->p = p;
    new->is_curve = is_curve;
    flk_text_join(new->title, sizeof new->title, title, (char *)NULL);
}

/* gnuplot needs a word for an empty curve: it has no entry. */
void sketch_curve(sketch *s, pen p, const char *title, const fourlink_vector *points, int n)
{
    fourlink_vector at, last = {0, 0};
    int in_piece = 0, is_empty = 1, i;

    fprintf(s->c->out, "$curve%d << EOD\n", s->n_entries);
    for (i = 0; i < n; i++) {
        if (gsl_isnan(points[i].x)) {
            fputs(in_piece ? "\n" : "", s->c->out);
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
        at = in_unit(s, at);
        canvas_print(s->c, "%.7g %.7g\n", at.x, at.y);
    }
    fputs("EOD\n", s->c->out);
    if (!is_empty)
        add_entry(s, p, 1, s->n_entries < MOST_TITLES ? title : "");
}

void sketch_key(sketch *s, pen p, const char *meaning)
{
    add_entry(s, p, 0, meaning);
}

/* Values and key are to the right of the axes. */
static double width_of_margin(const sketch *s)
{
    double width = CANVAS_LETTER, narrow = s->c->is_text ? 1 : 0.95;
    int i;

    if (s->n_parts)
        width = 13 * CANVAS_LETTER;
    for (i = 0; i < s->n_notes; i++)
        width = GSL_MAX_DBL(width, narrow * canvas_width_of(s->notes[i]) + 3 * CANVAS_LETTER);
    for (i = 0; i < s->n_entries; i++)
        if (s->entries[i].title[0])
            width = GSL_MAX_DBL(width,
                                narrow * canvas_width_of(s->entries[i].title) + 7 * CANVAS_LETTER);
    return width;
}

static int has_part(const sketch *s, pen p)
{
    int i;

    for (i = 0; i < s->n_parts && s->parts[i].p != p; i++)
        ;
    return i < s->n_parts;
}

/* Put the key, and the notes below it. */
static void put_margin(const sketch *s)
{
    int in_key = 0, i;

    for (i = 0; i < s->n_entries; i++)
        in_key += s->entries[i].title[0] != '\0';
    for (i = PEN_CRANK; i <= PEN_FOLLOWER; i++)
        in_key += has_part(s, (pen)i);
    for (i = 0; i < s->n_notes; i++)
        canvas_note(s->c, i + (in_key ? in_key + 1 : 0), "%s", s->notes[i]);
    fputs("set key at graph 1.02, graph 1 left top Left reverse samplen 2\n", s->c->out);
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
    canvas_print(s->c, "set arrow from %.7g,%.7g to %.7g,%.7g nohead ls %d front\n", from.x, from.y,
                 to.x, to.y, PEN_LEADER);
}

static void put_labels(const sketch *s)
{
    int i;

    for (i = 0; i < s->texts.n; i++) {
        const label *one = &s->texts.list[i];
        double half = one->half;
        int side = one->middle.x > half ? 1 : one->middle.x < -half ? -1 : 0;
        fourlink_vector at =
            in_unit(s, place_beside(one->at, s->texts.scale * (one->middle.x - side * half),
                                    s->texts.scale * one->middle.y));

        if (one->is_hidden)
            continue;
        if (one->has_leader && !s->c->is_text)
            put_leader(s, one);
        canvas_print(s->c, "set label %w at %.7g,%.7g %s front %s\n", one->words, at.x, at.y,
                     side > 0   ? "left"
                     : side < 0 ? "right"
                                : "center",
                     canvas_mode(one->words));
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
    fourlink_vector middle = in_unit(
        s, place_at((s->drawn.x_min + s->drawn.x_max) / 2, (s->drawn.y_min + s->drawn.y_max) / 2));

    canvas_print(s->c,
                 "set format '%%g'; set xtics %.7g; set ytics %.7g\n"
                 "set xrange [%.7g:%.7g]\nset yrange [%.7g:%.7g]\n",
                 step_of(step, middle.x, width), step_of(step, middle.y, height),
                 middle.x - width / 2, middle.x + width / 2, middle.y - height / 2,
                 middle.y + height / 2);
}

/* Write the lines of a link as $linkN, for a text terminal; 0 if there are none. */
static int put_parts(const sketch *s, pen p)
{
    fourlink_vector from, to;
    int i, n = 0;

    for (i = 0; i < s->n_parts; i++)
        if (s->parts[i].p == p) {
            if (n++ == 0)
                fprintf(s->c->out, "$link%d << EOD\n", (int)p);
            from = in_unit(s, s->parts[i].from);
            to = in_unit(s, s->parts[i].to);
            canvas_print(s->c, "%.7g %.7g\n%.7g %.7g\n\n", from.x, from.y, to.x, to.y);
        }
    if (n)
        fputs("EOD\n", s->c->out);
    return n > 0;
}

static void put_curves(const sketch *s)
{
    int has_parts[PEN_FOLLOWER + 1], i;

    for (i = PEN_CRANK; i <= PEN_FOLLOWER; i++)
        has_parts[i] = put_parts(s, (pen)i);
    fputs("plot ", s->c->out);
    for (i = PEN_CRANK; i <= PEN_FOLLOWER; i++)
        if (has_parts[i])
            fprintf(s->c->out, "$link%d using 1:2 with lines ls %d title 'link %d', \\\n     ", i,
                    i, i);
    for (i = 0; i < s->n_entries; i++) {
        const sketch_entry *x = &s->entries[i];

        fputs(i ? ", \\\n     " : "", s->c->out);
        if (x->is_curve)
            fprintf(s->c->out, "$curve%d using 1:2", i);
        else
            fputs("NaN", s->c->out);
        canvas_print(s->c, x->title[0] ? " with lines ls %d title %q" : " with lines ls %d notitle",
                     (int)x->p, x->title);
    }
    fputs(s->n_entries ? "\n" : "NaN notitle\n", s->c->out);
}

void sketch_close(sketch *s, const char *format, ...)
{
    char title[MESSAGE_SIZE];
    va_list values;

    va_start(values, format);
    flk_message_list(title, sizeof title, format, values);
    va_end(values);
    if (!(s->drawn.x_min <= s->drawn.x_max)) { /* nothing was drawn */
        place_grow(&s->drawn, -s->size, -s->size);
        place_grow(&s->drawn, s->size, s->size);
    }
    canvas_panel(s->c, 2, width_of_margin(s));
    labels_place(&s->texts, s->drawn, s->is_fixed, s->size, s->c->box_width, s->c->box_height);
    s->drawn = s->texts.drawn;
    put_labels(s);
    put_margin(s);
    fputs("set size ratio -1\n", s->c->out);
    canvas_titles(s->c, s->c->turn != 0 ? "horizontal" : "x", s->unit->name,
                  s->c->turn != 0 ? "vertical" : "y", s->unit->name, "%s", title);
    put_axes(s);
    put_curves(s);
}
