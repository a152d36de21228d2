/* SPDX-License-Identifier: GPL-3.0-or-later
**
** svg.c - a display list as an SVG.
**
** A panel is a group with the class panel; data-box and data-axes say how pixels and units of the axes
** belong together.  An item has the class of its look, and what it shows as data-name.
*/
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include <gsl/gsl_math.h>

#include "system/format.h"
#include "system/memory.h"
#include "system/xml.h"
#include "base/digits.h"
#include "base/text.h"
#include "svg.h"
#include "view/notation.h"

#define HALF_WIDE 0.32 /* of a head's length: half of its width */
#define SECONDS 4      /* of a motion */

/* Decimals of a pixel: of a curve, and of a drawing, whose lines are checked against the mechanism. */
#define OF_CURVE 2
#define OF_DRAWING 4

#define FARTHEST 1e7 /* pixels: what lies beyond is not seen */

#define NUMBER_SIZE 24

/* Write a number of pixels with at most so many decimals, halves away from 0; returns its end. */
static char *write_rounded(double x, int decimals, char *to)
{
    double size = fabs(x) < FARTHEST ? fabs(x) : FARTHEST, unit = decimals == OF_CURVE ? 1e2 : 1e4;
    double rounded = floor(unit * size + 0.5) / unit;
    char digits[DIGITS_SIZE], *end = flk_digits_fixed(x < 0 ? -rounded : rounded, decimals, digits);

    while (end[-1] == '0')
        end--;
    end -= end[-1] == '.';
    memcpy(to, digits, (size_t)(end - digits));
    return to + (end - digits);
}

static void put_number(FILE *out, double x)
{
    char digits[NUMBER_SIZE];

    fwrite(digits, 1, (size_t)(write_rounded(x, OF_DRAWING, digits) - digits), out);
}

static void put_rounded_place(FILE *out, char before, fourlink_vector at, int decimals)
{
    char words[2 * NUMBER_SIZE], *end = words;

    *end++ = before;
    end = write_rounded(at.x, decimals, end);
    *end++ = ',';
    end = write_rounded(at.y, decimals, end);
    fwrite(words, 1, (size_t)(end - words), out);
}

static void put_place(FILE *out, char before, fourlink_vector at)
{
    put_rounded_place(out, before, at, OF_DRAWING);
}

/* ---------------------------------------------------------------------------------------- style sheet */

static void put_rule(FILE *out, int stroke)
{
    look x = display_look(stroke);
    char class_name[20];

    fprintf(out, ".fourlink .%s{stroke:#%s;stroke-width:%g", display_class(stroke, class_name),
            x.colour, x.width);
    if (x.dashes[0])
        fprintf(out, ";stroke-dasharray:%s", x.dashes);
    fprintf(out, "}\n.fourlink .h-%s{fill:#%s}\n", class_name, x.colour);
}

void svg_put_style(FILE *out)
{
    int i;

    fputs("svg.fourlink{font-family:sans-serif;font-size:14px;fill:none;stroke-linejoin:round}\n"
          ".fourlink text{fill:#000;stroke:none}\n"
          ".fourlink .halo{stroke:#fff;stroke-width:4px;paint-order:stroke}\n"
          ".fourlink .open{fill:#fff;stroke:#000;stroke-width:1.5}\n"
          ".fourlink .solid{fill:#000;stroke:#000;stroke-width:1.5}\n",
          out);
    fputs(".fourlink .above{fill:#" LOOK_ABOVE ";fill-opacity:.35}\n"
          ".fourlink .below{fill:#" LOOK_BELOW ";fill-opacity:.35}\n"
          "@media (prefers-color-scheme:dark)"
          "{svg.fourlink{filter:invert(.88) hue-rotate(180deg)}}\n"
          "@media print{svg.fourlink{filter:none}}\n",
          out);
    for (i = 1; i < PEN_CURVE; i++)
        put_rule(out, i);
    for (i = 0; i < LOOK_CURVE_COUNT; i++) {
        put_rule(out, PEN_CURVE + i);
        put_rule(out, PEN_JUMP + i);
    }
    put_rule(out, PEN_GRID);
    put_rule(out, PEN_AXIS);
}

/* --------------------------------------------------------------------------------------------- items */

/* The attributes of an item: its class, and what it shows. */
static void put_class(FILE *out, const display *d, const display_item *x, const char *class_name)
{
    const char *name = display_words(d, x->name);

    fprintf(out, " class=\"%s\"", class_name);
    if (*name) {
        fputs(" data-name=\"", out);
        xml_put(out, name, strlen(name));
        putc('"', out);
    }
}

/* The corners of an arrow's head: its tip, both sides, and where the line ends.  A short arrow has a short
** head. */
static void find_head(const display *d, const display_item *x, fourlink_vector corner[4])
{
    fourlink_vector from = d->places[x->first], to = d->places[x->first + 1], axis;
    double length = place_distance(from, to), head;

    head = x->is_open ? x->size : GSL_MIN_DBL(x->size, 0.8 * length);

    axis =
        length > 0 ? place_at((from.x - to.x) / length, (from.y - to.y) / length) : place_at(0, 0);
    corner[0] = to;
    corner[1] = place_in(to, axis, head, HALF_WIDE * head);
    corner[2] = place_in(to, axis, head, -HALF_WIDE * head);
    corner[3] = place_in(to, axis, 0.8 * head, 0);
}

static void put_curve_place(FILE *out, char before, fourlink_vector at)
{
    put_rounded_place(out, before, at, OF_CURVE);
}

/* The path of a curve, with its gaps. */
static void put_curve(FILE *out, const display *d, const display_item *x)
{
    const fourlink_vector *at = d->places + x->first;
    size_t from = 0, n = 0, i;

    while (display_next_piece(d, x, &from, &n))
        for (i = 0; i < n; i = display_next_bend(at + from, i, n))
            put_curve_place(out, i ? 'L' : 'M', at[from + i]);
}

static void put_path(FILE *out, const display *d, const display_item *x)
{
    const fourlink_vector *at = d->places + x->first;
    fourlink_vector corner[4];
    size_t i;

    if (x->sort == DISPLAY_CURVE) {
        put_curve(out, d, x);
        return;
    }
    if (x->sort == DISPLAY_ARROW)
        find_head(d, x, corner);
    for (i = 0; i < x->n; i++)
        if (x->sort == DISPLAY_ABOVE || x->sort == DISPLAY_BELOW)
            put_curve_place(out, i ? 'L' : 'M', at[i]);
        else
            put_place(out, i ? 'L' : 'M', x->sort == DISPLAY_ARROW && i ? corner[3] : at[i]);
    if (x->sort == DISPLAY_ABOVE || x->sort == DISPLAY_BELOW)
        putc('z', out);
}

static void put_head(FILE *out, const display *d, const display_item *x)
{
    fourlink_vector corner[4];

    find_head(d, x, corner);
    put_place(out, 'M', corner[0]);
    put_place(out, 'L', corner[1]);
    put_place(out, 'L', corner[2]);
    putc('z', out);
}

/* The quarters of a centre of mass that are black. */
static void put_quarters(FILE *out, const display *d, const display_item *x)
{
    fourlink_vector at = d->places[x->first];
    double r = x->size;
    int i;

    for (i = -1; i <= 1; i += 2) {
        put_place(out, 'M', at);
        put_place(out, 'L', place_beside(at, -i * r, 0));
        put_place(out, 'A', place_at(r, r));
        fputs(" 0 0 1 ", out);
        put_place(out, ' ', place_beside(at, 0, -i * r));
        putc('z', out);
    }
}

#define LOWER 4  /* pixels: a subscript below the line */
#define HIGHER 6 /* a superscript above it */

/* Write a text with its subscripts and superscripts. */
static void put_words(FILE *out, const char *words)
{
    notation_part x = {NULL, 0, 0, 0};
    int at = 0;

    x.words = words;
    while (notation_next(words, &x)) {
        int to = x.level < 0 ? LOWER : x.level > 0 ? -HIGHER : 0, is_plain = to == 0 && at == 0;

        if (!is_plain)
            fprintf(out, "<tspan dy=\"%d\"%s>", to - at, to ? " font-size=\"10\"" : "");
        if (x.is_minus)
            fputs(NOTATION_MINUS, out);
        else
            xml_put(out, x.words, x.n);
        if (!is_plain)
            fputs("</tspan>", out);
        at = to;
    }
}

#define BASELINE 5 /* pixels below the middle of a line */

/* An item of a frame in another one; null if it is not there. */
static const display_item *item_in(const display *frame, const display_item *x)
{
    const display_item *y = frame->items + frame->panels[0].first;

    for (; y < frame->items + frame->n_items; y++)
        if (y->key == x->key && y->part == x->part && y->sort == x->sort && y->pen == x->pen)
            return y;
    return NULL;
}

/* Frames with a panel each, and an item of one of them. */
typedef struct moving_item {
    const display *frames, *of;
    int n, repeats; /* 1: the first frame follows the last */
    const display_item *x;
    unsigned long
        body; /* the key of the frame with which it moves as a whole, in whose group it is; 0: none */
} moving_item;

/* 1 if it is in all frames at the same places; without a key, as the axes, it is. */
static int is_still(const moving_item *m)
{
    const display_item *y;
    size_t j;
    int k;

    for (k = 0; k < m->n && m->x->key; k++) {
        y = item_in(&m->frames[k], m->x);
        if (!y || y->n != m->x->n)
            return 0;
        for (j = 0; j < y->n; j++)
            if (place_distance(m->of->places[m->x->first + j], m->frames[k].places[y->first + j]) >
                5e-4)
                return 0;
    }
    return 1;
}

static void put_animate(FILE *out, const char *attribute, const char *mode)
{
    fprintf(out, "<animate attributeName=\"%s\"%s dur=\"%ds\" repeatCount=\"indefinite\" values=\"",
            attribute, mode, SECONDS);
}

/* The values of an attribute in all frames; where the item is not there, those before. */
static void put_values(FILE *out, const moving_item *m, const char *attribute,
                       void put(FILE *out, const display *d, const display_item *x))
{
    const display *d = m->of;
    const display_item *x = m->x, *y;
    int k;

    if (m->body)
        return;
    put_animate(out, attribute, "");
    for (k = 0; k < m->n + m->repeats; k++) {
        y = item_in(&m->frames[k % m->n], m->x);
        if (y) {
            d = &m->frames[k % m->n];
            x = y;
        }
        fputs(k ? ";" : "", out);
        put(out, d, x);
    }
    fputs("\"/>", out);
}

/* Where it is not there. */
static void put_visibility(FILE *out, const moving_item *m)
{
    int k = 0;

    while (k < m->n && item_in(&m->frames[k], m->x))
        k++;
    if (k == m->n)
        return;
    put_animate(out, "visibility", " calcMode=\"discrete\"");
    for (k = 0; k < m->n; k++)
        fprintf(out, "%s%s", k ? ";" : "", item_in(&m->frames[k], m->x) ? "visible" : "hidden");
    fputs("\"/>", out);
}

static void put_x(FILE *out, const display *d, const display_item *x)
{
    put_number(out, d->places[x->first].x);
}

static void put_y(FILE *out, const display *d, const display_item *x)
{
    put_number(out, d->places[x->first].y + (x->sort == DISPLAY_TEXT ? BASELINE : 0));
}

/* End an element that has no words; of an item that moves, with its values. */
static void end_element(FILE *out, const moving_item *m, const char *name, const char *first,
                        void put_first(FILE *out, const display *d, const display_item *x),
                        const char *second)
{
    if (!m) {
        fputs("/>\n", out);
        return;
    }
    putc('>', out);
    put_values(out, m, first, put_first);
    if (second)
        put_values(out, m, second, put_y);
    put_visibility(out, m);
    fprintf(out, "</%s>\n", name);
}

/* By display_align. */
static const char *const anchors[] = {"", " text-anchor=\"middle\"", " text-anchor=\"end\""};

static void put_text(FILE *out, const display *d, const display_item *x, const moving_item *m)
{
    fourlink_vector at = d->places[x->first];
    char class_name[30], words[DISPLAY_WORDS];

    fputs("<text x=\"", out);
    put_number(out, at.x);
    fputs("\" y=\"", out);
    put_number(out, at.y + (x->is_upright ? 0 : BASELINE));
    putc('"', out);
    if (x->is_upright) {
        fputs(" transform=\"rotate(-90 ", out);
        put_place(out, ' ', at);
        fputs(")\"", out);
    }
    if (x->pen || x->name || x->is_boxed)
        put_class(out, d, x, svg_class(x, class_name));
    fputs(anchors[x->align], out);
    putc('>', out);
    put_words(out, display_text_of(d, x, words));
    if (m) {
        put_values(out, m, "x", put_x);
        put_values(out, m, "y", put_y);
        put_visibility(out, m);
    }
    fputs("</text>\n", out);
}

const char *svg_class(const display_item *x, char out[30])
{
    char own[20];

    if (x->sort == DISPLAY_TEXT)
        return flk_text_join(out, 30, x->pen ? "h-" : "", display_class(x->pen, own),
                             x->is_boxed && x->pen ? " halo"
                             : x->is_boxed         ? "halo"
                             : x->pen              ? ""
                                                   : "words",
                             (char *)NULL);
    if (x->sort != DISPLAY_DISC && x->sort != DISPLAY_MARK && x->sort != DISPLAY_CENTRE)
        return x->sort == DISPLAY_ABOVE   ? "above"
               : x->sort == DISPLAY_BELOW ? "below"
                                          : display_class(x->pen, out);
    if (x->sort == DISPLAY_MARK && x->pen)
        return flk_text_join(out, 30, "h-", display_class(x->pen, own), " mark", (char *)NULL);
    if (x->sort == DISPLAY_MARK)
        return x->is_open ? "open mark" : "solid mark";
    if (x->sort == DISPLAY_CENTRE)
        return "open centre";
    return x->is_open ? "open" : "solid";
}

static void put_circle(FILE *out, const display *d, const display_item *x, const moving_item *m)
{
    fourlink_vector at = d->places[x->first];
    char class_name[30];

    fputs("<circle cx=\"", out);
    put_number(out, at.x);
    fputs("\" cy=\"", out);
    put_number(out, at.y);
    fputs("\" r=\"", out);
    put_number(out, x->size);
    putc('"', out);
    put_class(out, d, x, svg_class(x, class_name));
    end_element(out, m, "circle", "cx", put_x, "cy");
}

/* A path, of which `put` writes the way. */
static void put_one(FILE *out, const display *d, const display_item *x, const moving_item *m,
                    const char *class_name,
                    void put(FILE *out, const display *d, const display_item *x))
{
    fputs("<path", out);
    put_class(out, d, x, class_name);
    fputs(" d=\"", out);
    put(out, d, x);
    putc('"', out);
    end_element(out, m, "path", "d", put, NULL);
}

/* Write an item; one that moves is in other frames too. */
static void put_item(FILE *out, const display *d, const display_item *x, const moving_item *m)
{
    char own[30], head[32];
    const char *class_name = svg_class(x, own);

    if (x->sort == DISPLAY_FRAME)
        return;
    if (x->sort == DISPLAY_TEXT) {
        put_text(out, d, x, m);
    } else if (x->sort < DISPLAY_DISC) {
        if (x->n)
            put_one(out, d, x, m, class_name, put_path);
        if (x->sort == DISPLAY_ARROW)
            put_one(out, d, x, m, flk_text_join(head, sizeof head, "h-", class_name, (char *)NULL),
                    put_head);
    } else {
        put_circle(out, d, x, m);
        if (x->sort == DISPLAY_CENTRE) {
            display_item quarters = *x;

            quarters.name = 0;
            put_one(out, d, &quarters, m, "solid", put_quarters);
        }
    }
}

static void put_items(FILE *out, const display *d, size_t from, size_t to)
{
    size_t i;
    int layer;

    for (layer = 0; layer < DISPLAY_LAYERS; layer++)
        for (i = from; i < to; i++)
            if (d->items[i].layer == layer)
                put_item(out, d, &d->items[i], NULL);
}

/* ------------------------------------------------------------------------------------------- picture */

static void put_element(FILE *out, const char *name, const char *words)
{
    fprintf(out, "<%s>", name);
    xml_put(out, words, strlen(words));
    fprintf(out, "</%s>\n", name);
}

/* How pixels and units of the axes of a panel belong together. */
static void put_panel_data(FILE *out, const display_panel *p)
{
    char number[FORMAT_SIZE];
    double axes[4];
    int i;

    axes[0] = p->axes.x_min;
    axes[1] = p->axes.x_max;
    axes[2] = p->axes.y_min;
    axes[3] = p->axes.y_max;
    fputs("<g class=\"panel\" data-box=\"", out);
    put_place(out, ' ', place_at(p->left, p->top));
    put_place(out, ' ', place_at(p->width, p->height));
    fputs("\" data-axes=\"", out);
    for (i = 0; i < 4; i++)
        fprintf(out, "%s%s", i ? " " : "", format_general(axes[i], 9, number));
    fputs("\">\n", out);
}

static void put_begin(FILE *out, const display *d, const char *title, const char *description,
                      int is_figure)
{
    fputs("<svg xmlns=\"http://www.w3.org/2000/svg\" class=\"fourlink\" role=\"img\" "
          "xml:space=\"preserve\" width=\"",
          out);
    put_number(out, d->width);
    fputs("\" height=\"", out);
    put_number(out, d->height);
    fputs("\" viewBox=\"0 0 ", out);
    put_number(out, d->width);
    putc(' ', out);
    put_number(out, d->height);
    fputs("\">\n", out);
    put_element(out, "title", title);
    put_element(out, "desc", description);
    if (is_figure)
        return;
    fputs("<style>\n", out);
    svg_put_style(out);
    fputs("</style>\n<rect width=\"100%\" height=\"100%\" fill=\"#fff\"/>\n", out);
}

void svg_write(FILE *out, const display *d, const char *title, const char *description,
               int is_figure)
{
    size_t i, done = 0;

    put_begin(out, d, title, description, is_figure);
    for (i = 0; i < d->n_panels; i++) {
        const display_panel *p = &d->panels[i];

        put_items(out, d, done, p->first); /* of no panel */
        put_panel_data(out, p);
        put_items(out, d, p->first, p->first + p->n);
        fputs("</g>\n", out);
        done = p->first + p->n;
    }
    put_items(out, d, done, d->n_items);
    fputs("</svg>\n", out);
}

/* -------------------------------------------------------------------------------------------- motion */

/* The frame of a display list that turns with a body; null if it is not there. */
static const display_item *body_in(const display *d, unsigned long key)
{
    const display_item *x = d->items + d->panels[0].first;

    for (; x < d->items + d->n_items; x++)
        if (x->sort == DISPLAY_FRAME && x->key == key && x->n == 2)
            return d->holds[x->first + 1] == key ? x : NULL;
    return NULL;
}

/* Where place j of an item is in the frame of a body; NaN if that does not hold it. */
static fourlink_vector place_in_body(const display *d, const display_item *x, size_t j,
                                     unsigned long key)
{
    const display_item *body = body_in(d, key);

    return body && d->holds[x->first + j] == key
               ? display_seen(body, d->places + body->first, d->places[x->first + j])
               : place_at(GSL_NAN, GSL_NAN);
}

/* The key of the body with which an item moves as a whole; 0: none.  Texts and centres of mass stay
** upright. */
static unsigned long body_of(const moving_item *m)
{
    unsigned long key = m->x->n ? m->of->holds[m->x->first] : 0;
    const display_item *y;
    size_t j;
    int k;

    if (m->x->sort == DISPLAY_TEXT || m->x->sort == DISPLAY_CENTRE)
        return 0;
    for (k = 0; k < m->n && key; k++) {
        y = item_in(&m->frames[k], m->x);
        if (y && y->n != m->x->n)
            return 0;
        for (j = 0; y && j < y->n; j++)
            if (!(place_distance(place_in_body(&m->frames[k], y, j, key),
                                 place_in_body(m->of, m->x, j, key)) < 5e-4))
                return 0;
    }
    return key;
}

/* Where a body is, or its angle in degrees, without a jump from that of the step before; the same if it
** is not there. */
static fourlink_vector pose_of(const display *d, unsigned long body, int is_turn,
                               fourlink_vector last)
{
    const display_item *x = body_in(d, body);
    const fourlink_vector *at = d->places + (x ? x->first : 0);
    double angle;

    if (!x || !is_turn)
        return x ? at[0] : last;
    angle = atan2(at[1].y - at[0].y, at[1].x - at[0].x) * 180 / M_PI;
    return place_at(angle + 360 * floor((last.x - angle) / 360 + 0.5), 0);
}

static void put_pose(FILE *out, fourlink_vector pose, int is_turn)
{
    put_number(out, pose.x);
    if (is_turn)
        return;
    putc(',', out);
    put_number(out, pose.y);
}

/* Write how a body goes, or turns; one value, if all are the same. */
static void put_transform(FILE *out, const moving_item *m, int is_turn)
{
    fourlink_vector first = pose_of(m->of, m->body, is_turn, place_at(0, 0)), last = first;
    int k, n = 1;

    for (k = 0; k < m->n; k++) {
        last = pose_of(&m->frames[k], m->body, is_turn, last);
        n = place_distance(last, first) > 5e-5 ? m->n + m->repeats : n;
    }
    fprintf(out,
            "<animateTransform attributeName=\"transform\" type=\"%s\"%s dur=\"%ds\" "
            "repeatCount=\"indefinite\" values=\"",
            is_turn ? "rotate" : "translate", is_turn ? " additive=\"sum\"" : "", SECONDS);
    for (k = 0, last = first; k < n; k++) {
        last = pose_of(&m->frames[k % m->n], m->body, is_turn, last);
        fputs(k ? ";" : "", out);
        put_pose(out, last, is_turn);
    }
    fputs("\"/>", out);
}

/* Write an item that moves with a body as it is in its frame, in the group of the one before if that is
** the same. */
static void put_in_group(FILE *out, moving_item *m, unsigned long last)
{
    display seen = *m->of;
    display_item x = *m->x;
    size_t j;

    if (last && last != m->body)
        fputs("</g>\n", out);
    if (m->body && last != m->body) {
        fputs("<g transform=\"translate(", out);
        put_pose(out, pose_of(&m->frames[0], m->body, 0, place_at(0, 0)), 0);
        fputs(") rotate(", out);
        put_pose(out, pose_of(&m->frames[0], m->body, 1, place_at(0, 0)), 1);
        fputs(")\">", out);
        put_transform(out, m, 0);
        put_transform(out, m, 1);
        putc('\n', out);
    }
    if (!m->body) {
        put_item(out, m->of, m->x, is_still(m) ? NULL : m);
        return;
    }
    seen.places = memory_get(x.n, sizeof *seen.places);
    x.first = 0;
    for (j = 0; seen.places && j < x.n; j++)
        seen.places[j] = place_in_body(m->of, m->x, j, m->body);
    if (seen.places)
        put_item(out, &seen, &x, m);
    free(seen.places);
}

/* Write those items of frame k in a layer that are in none of the frames before. */
static void put_new_items(FILE *out, moving_item *m, int k, int layer)
{
    const display *d = &m->frames[k];
    const display_item *x;
    unsigned long last;
    int before;

    for (x = d->items + d->panels[0].first; x < d->items + d->n_items; x++) {
        for (before = 0; before < k && x->key && !item_in(&m->frames[before], x); before++)
            ;
        if (before < k || x->layer != layer || x->sort == DISPLAY_FRAME)
            continue;
        m->of = d;
        m->x = x;
        last = m->body;
        m->body = x->key ? body_of(m) : 0;
        put_in_group(out, m, last);
    }
}

void svg_write_motion(FILE *out, const display *frames, int n, int repeats, const char *title,
                      const char *description)
{
    moving_item m;
    int layer, k;

    m.frames = frames;
    m.n = n;
    m.repeats = repeats;
    put_begin(out, &frames[0], title, description, 0);
    put_items(out, &frames[0], 0, frames[0].panels[0].first);
    put_panel_data(out, &frames[0].panels[0]);
    m.body = 0;
    for (layer = 0; layer < DISPLAY_LAYERS; layer++)
        for (k = 0; k < n; k++)
            put_new_items(out, &m, k, layer);
    fputs(m.body ? "</g>\n" : "", out);
    fputs("</g>\n</svg>\n", out);
}
