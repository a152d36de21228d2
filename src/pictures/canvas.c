/* SPDX-License-Identifier: GPL-3.0-or-later
**
** canvas.c - a picture's panels: their places, margins and titles.
*/
#include <math.h>
#include <stdarg.h>
#include <string.h>

#include <gsl/gsl_math.h>

#include "base/message.h"
#include "canvas.h"
#include "system/format.h"

#define HEAD (4 * CANVAS_LINE) /* title and source */
#define NO_HEAD (0.4 * CANVAS_LINE)
#define CANVAS_WORDS 1200           /* bytes of a title; a letter may have four */
#define LEFT (11.5 * CANVAS_LETTER) /* numbers and name of the y axis */
#define NO_NUMBERS (2 * CANVAS_LETTER)
#define BELOW (3.2 * CANVAS_LINE)
#define SCALES (1.6 * CANVAS_LINE) /* below a bare drawing */
#define SHORTENED "\342\200\246"   /* an ellipsis, in UTF-8 */
#define TIC 5.0                    /* pixels */
#define SAMPLE 26.0                /* pixels of a line in a key */
#define NARROWEST 330.0 /* pixels: a script may make a sheet so narrow, but not its texts */
#define LEAST_HEAD 14.0 /* pixels of an arrow's head on a small sheet */

static int begins_letter(char c)
{
    return ((unsigned char)c & 0xC0) != 0x80;
}

int canvas_letters(const char *words)
{
    int n = 0;

    for (; *words; words++)
        n += begins_letter(*words) && !notation_mark(words);
    return n;
}

double canvas_width_of(const char *words)
{
    return CANVAS_LETTER * canvas_letters(words);
}

char *canvas_shorten(const char *words, int letters, int keep_end, char *out, size_t size)
{
    int surplus = canvas_letters(words) - letters;
    size_t n = 0;

    if (surplus <= 0)
        return flk_text_join(out, size, words, (char *)NULL);
    if (keep_end) {
        for (surplus++; *words && (surplus > 0 || !begins_letter(*words)); words++)
            surplus -= begins_letter(*words);
        return flk_text_join(out, size, SHORTENED, words, (char *)NULL);
    }
    for (; n + 5 < size && words[n] && ((letters > 1 && n + 9 < size) || !begins_letter(words[n]));
         n++) {
        letters -= begins_letter(words[n]);
        out[n] = words[n];
    }
    strcpy(out + n, SHORTENED);
    return out;
}

void canvas_open(canvas *c, display *d, int is_text, int columns, int rows, double width,
                 double height, double below, int has_title)
{
    memset(c, 0, sizeof *c);
    c->head = has_title ? HEAD : NO_HEAD;
    c->d = d;
    c->is_text = is_text;
    c->columns = is_text ? 1 : columns;
    c->rows = is_text ? rows * columns : rows;
    c->width = d->width = is_text ? CANVAS_TEXT_WIDTH * CANVAS_LETTER : width * columns;
    c->below = below;
    c->height = d->height = c->head + (height + below) * c->rows;
}

/* Put a line of the head, of no panel. */
static void put_head(const canvas *c, const char *words, int line)
{
    display_text(c->d, 0, place_at(c->width / 2, line * CANVAS_LINE), DISPLAY_MIDDLE, words);
}

void canvas_name(const canvas *c, const char *title, const char *source, const char *rest)
{
    int letters = (int)(c->width / CANVAS_LETTER) - 2;
    char words[CANVAS_WORDS], all[CANVAS_WORDS + 200];

    if (c->head == NO_HEAD)
        return;
    put_head(c, canvas_shorten(title, letters, 0, words, sizeof words), 1);
    letters -= canvas_letters(rest);
    canvas_shorten(source, letters, 1, words, sizeof words);
    put_head(c, flk_text_join(all, sizeof all, words, rest, (char *)NULL), 2);
}

void canvas_begin_panel(canvas *c)
{
    display_begin_panel(c->d);
    c->d->key = 0;
    c->n_entries = 0;
    c->has_key_below_title = 0;
}

int canvas_has_scales(const canvas *c)
{
    return c->is_bare || c->has_scale_bars;
}

double canvas_head(const canvas *c)
{
    return c->is_bare ? GSL_MAX_DBL(DISPLAY_HEAD, LEAST_HEAD / c->width) : 0;
}

/* 1 if a drawing has axes with numbers. */
static int has_axes(const canvas *c)
{
    return !canvas_has_scales(c) && !c->has_no_scale;
}

void canvas_place_panel(canvas *c, int lines, double right)
{
    int columns = c->fills_row ? c->columns : 1; /* of this panel */
    double width = c->width / c->columns * columns, height = (c->height - c->head) / c->rows;
    double x = c->next % c->columns * width, y = c->head + c->next / c->columns % c->rows * height;

    if (c->is_bare)
        lines = 0;
    c->left = c->is_bare ? 0 : c->has_scale_bars ? NO_NUMBERS : LEFT;
    c->right = c->is_bare ? 0 : right < 0.5 * width ? right : 0.5 * width;
    c->lines = lines;
    c->box.x_min = x + c->left;
    c->box.x_max = x + width - c->right;
    c->box.y_min = y + lines * CANVAS_LINE;
    c->box.y_max = y + height - (canvas_has_scales(c) ? SCALES : BELOW) - c->below;
    c->box_width = c->box.x_max - c->box.x_min;
    c->box_height = c->box.y_max - c->box.y_min;
    c->next += columns;
    c->fills_row = 0;
}

void canvas_set_axes(canvas *c, place_box axes, double x_step, double y_step)
{
    c->axes = axes;
    c->x_step = x_step;
    c->y_step = y_step;
}

const char *canvas_symbol(const canvas *c, const char *name, char out[NOTATION_SIZE])
{
    return c->is_text ? name : notation_name(name, out);
}

const char *canvas_unit(const canvas *c, const char *unit, char out[NOTATION_SIZE])
{
    return c->is_text ? unit : notation_unit(unit, out);
}

/* Put a text of this name at a part of the box, so many pixels to the right and down from there. */
static display_item *put_in_box(const canvas *c, const char *name, double x, double y, double dx,
                                double dy, display_align align, const char *words)
{
    size_t kept = display_keep(c->d, name);
    display_item *words_at = display_text(c->d, 0, place_at(x, y), align, words);

    words_at->name = kept;
    words_at->in_box = 1;
    words_at->dx = dx;
    words_at->dy = dy;
    return words_at;
}

static const char *name_axis(const canvas *c, const char *name, const char *unit_name,
                             char out[200])
{
    char own[NOTATION_SIZE];

    return flk_message(out, 200, "%s (%s)", name, canvas_unit(c, unit_name, own));
}

/* A text terminal cannot turn the name of the y axis, so it goes to the title. */
void canvas_titles(const canvas *c, const char *x, const char *x_unit, const char *y,
                   const char *y_unit, const char *format, ...)
{
    int letters = (int)((c->left + c->box_width + c->right) / CANVAS_LETTER) - 2;
    char words[CANVAS_WORDS], fitting[CANVAS_WORDS], axis[200];
    va_list values;
    size_t n;

    if (c->is_bare)
        return;
    va_start(values, format);
    n = strlen(flk_message_list(words, sizeof words, format, values));
    va_end(values);
    if (has_axes(c))
        put_in_box(c, "x", 0.5, 0, 0, 2.3 * CANVAS_LINE, DISPLAY_MIDDLE,
                   name_axis(c, x, x_unit, axis));
    name_axis(c, y, y_unit, axis);
    if (c->is_text && has_axes(c))
        flk_message(words + n, sizeof words - n, "%s%s", n ? ", " : "", axis);
    else if (has_axes(c))
        put_in_box(c, "y", 0, 0.5, 2.2 * CANVAS_LETTER - LEFT, 0, DISPLAY_MIDDLE, axis)
            ->is_upright = 1;
    /* in the middle of the panel */
    put_in_box(c, "title", 0.5, 1, (c->right - c->left) / 2, (0.5 - c->lines) * CANVAS_LINE,
               DISPLAY_MIDDLE, canvas_shorten(words, letters, 0, fitting, sizeof fitting));
}

double canvas_scale(const canvas *c, double from, double length, int stroke, const char *value,
                    const char *unit)
{
    double y = -0.8 * CANVAS_LINE / c->box_height, to = from + length, end = 4 / c->box_height;
    size_t kept = display_keep(c->d, "scale");
    display_item *words;
    double room;
    int k;

    c->d->key = 4 * (unsigned long)stroke + 1;
    for (k = stroke ? 0 : -1; k <= (stroke ? 0 : 1);
         k++) { /* the line, or both ends and the line */
        double x1 = k < 0 ? from : k > 0 ? to : from, x2 = k < 0 ? from : to;
        display_item *line = display_line(c->d, stroke ? stroke : PEN_AXIS, DISPLAY_FRONT,
                                          place_at(x1 / c->box_width, y + (k ? end : 0)),
                                          place_at(x2 / c->box_width, y - (k ? end : 0)));

        line->sort = stroke ? DISPLAY_ARROW : DISPLAY_LINE;
        line->size = stroke ? canvas_head(c) : 0;
        line->in_box = 1;
        line->name = kept;
        line->part = DISPLAY_SCALE;
        c->d->key++;
    }
    words = put_in_box(c, "scale", to / c->box_width, y, 0.7 * CANVAS_LETTER, 0, DISPLAY_LEFT, "");
    words->part = DISPLAY_SCALE;
    display_set_value(c->d, words, value, unit);
    room = 4 * CANVAS_LETTER + canvas_width_of(value) + canvas_width_of(unit);
    return to + (c->is_bare ? room * GSL_MAX_DBL(1, c->width / NARROWEST) : room);
}

display_item *canvas_note(const canvas *c, int line, const char *format, ...)
{
    char words[MESSAGE_SIZE];
    display_item *note;
    va_list values;

    va_start(values, format);
    flk_message_list(words, sizeof words, format, values);
    va_end(values);
    note =
        put_in_box(c, "note", 1, 1, 0.02 * c->box_width, line * CANVAS_LINE, DISPLAY_LEFT, words);
    note->part = DISPLAY_NOTE;
    return note;
}

/* ----------------------------------------------------------------------------------------------- key */

void canvas_add_key(canvas *c, display_sort sort, int stroke, const char *words)
{
    canvas_entry *new = &c->entries[c->n_entries];

    if (c->n_entries == CANVAS_ENTRIES || !*words)
        return;
    new->sort = sort;
    new->pen = stroke;
    new->key = c->d->key;
    flk_text_join(new->words, sizeof new->words, words, (char *)NULL);
    c->n_entries++;
}

/* Put an entry, from a place in pixels right of and above the upper left corner of the box. */
static void put_entry(const canvas *c, const canvas_entry *x, double dx, double dy)
{
    size_t kept = display_keep(c->d, "key");
    display_item *sample;
    int i;

    c->d->key = x->key;
    if (x->sort == DISPLAY_ABOVE || x->sort == DISPLAY_BELOW) {
        sample = display_add(c->d, x->sort, x->pen, DISPLAY_FRONT);
        sample->is_open = 1; /* a polygon already */
        for (i = 0; i < 4; i++)
            display_add_place(c->d, place_at(i == 1 || i == 2 ? SAMPLE / c->box_width : 0,
                                             1 + (i < 2 ? 1 : -1) * 5 / c->box_height));
    } else if (x->sort == DISPLAY_MARK) {
        sample = display_add(c->d, DISPLAY_MARK, x->pen, DISPLAY_FRONT);
        sample->size = 3;
        display_add_place(c->d, place_at(SAMPLE / 2 / c->box_width, 1));
    } else {
        sample = display_line(c->d, x->pen, DISPLAY_FRONT, place_at(0, 1),
                              place_at(SAMPLE / c->box_width, 1));
    }
    sample->dx = dx;
    sample->dy = dy;
    sample->in_box = 1;
    sample->name = kept;
    sample->part = DISPLAY_KEY;
    put_in_box(c, "key", 0, 1, dx + SAMPLE + 0.7 * CANVAS_LETTER, dy, DISPLAY_LEFT, x->words)
        ->part = DISPLAY_KEY;
}

static double width_of_entry(const canvas_entry *x)
{
    return SAMPLE + 2.5 * CANVAS_LETTER + 0.85 * canvas_width_of(x->words);
}

/* The entries in lines in the middle of the box, above it. */
static void put_key_above(const canvas *c)
{
    double most = c->box_width + c->left + c->right - 4 * CANVAS_LETTER, width[CANVAS_ENTRIES];
    int row[CANVAS_ENTRIES], rows = 0, i;

    for (i = 0; i < c->n_entries; i++) {
        double own = width_of_entry(&c->entries[i]);

        if (i == 0 || width[rows - 1] + own > most)
            width[rows++] = 0;
        width[rows - 1] += own;
        row[i] = rows - 1;
    }
    for (i = 0; i < c->n_entries; i++) {
        double x = 0, y = -0.5 * (c->lines - 1) * CANVAS_LINE;
        int k;

        for (k = 0; k < i; k++)
            x += row[k] == row[i] ? width_of_entry(&c->entries[k]) : 0;
        put_entry(c, &c->entries[i], (c->box_width - width[row[i]]) / 2 + x,
                  y + (row[i] - 0.5 * (rows - 1)) * CANVAS_LINE);
    }
}

/* ---------------------------------------------------------------------------------------------- axes */

/* A line in parts of the box, with so many pixels added at its end. */
static void put_part(const canvas *c, int stroke, int layer, double x1, double y1, double x2,
                     double y2)
{
    display_line(c->d, stroke, layer, place_at(x1, y1), place_at(x2, y2))->in_box = 1;
}

#define Y_SPACING 42.0 /* pixels between two numbers of the y axis, at least */

/* Put the numbers of an axis, its tics, and the lines of the grid. */
static void put_scale(const canvas *c, double low, double high, double step, int is_y)
{
    double length = is_y ? c->box_height : c->box_width,
           tic = TIC / (is_y ? c->box_width : c->box_height);
    char number[FORMAT_SIZE];
    double k;

    if (!(step > 0))
        step = place_round(Y_SPACING * fabs(high - low) / length);
    for (k = ceil(GSL_MIN_DBL(low, high) / step - 1e-9);
         k * step <= GSL_MAX_DBL(low, high) + 1e-9 * step; k++) {
        double at = (k * step - low) / (high - low);

        if (!c->is_text && at > 1e-6 && at < 1 - 1e-6)
            put_part(c, PEN_GRID, DISPLAY_BACK, is_y ? 0 : at, is_y ? at : 0, is_y ? 1 : at,
                     is_y ? at : 1);
        put_part(c, PEN_AXIS, DISPLAY_BACK, is_y ? 0 : at, is_y ? at : 0, is_y ? tic : at,
                 is_y ? at : tic);
        put_in_box(c, is_y ? "y-number" : "x-number", is_y ? 0 : at, is_y ? at : 0,
                   is_y ? -0.7 * CANVAS_LETTER : 0, is_y ? 0 : 0.8 * CANVAS_LINE,
                   is_y ? DISPLAY_RIGHT : DISPLAY_MIDDLE,
                   format_general(k == 0 ? 0 : k * step, 6, number));
    }
}

/* Put the lines through 0. */
static void put_zero_axes(const canvas *c)
{
    double x = -c->axes.x_min / (c->axes.x_max - c->axes.x_min);
    double y = -c->axes.y_min / (c->axes.y_max - c->axes.y_min);

    if (x > 0 && x < 1)
        put_part(c, PEN_AXIS, DISPLAY_BACK, x, 0, x, 1);
    if (y > 0 && y < 1)
        put_part(c, PEN_AXIS, DISPLAY_BACK, 0, y, 1, y);
}

void canvas_end_panel(canvas *c)
{
    int i;

    if (has_axes(c)) {
        put_scale(c, c->axes.x_min, c->axes.x_max, c->x_step, 0);
        put_scale(c, c->axes.y_min, c->axes.y_max, c->y_step, 1);
        for (i = 0; i < 4; i++)
            put_part(c, PEN_AXIS, DISPLAY_BACK, i == 2, i == 3, i != 0, i != 1);
    }
    if (c->has_zero_axes)
        put_zero_axes(c);
    if (c->has_key_below_title)
        put_key_above(c);
    else
        for (i = 0; i < c->n_entries; i++)
            put_entry(c, &c->entries[i], 1.02 * c->box_width, i * CANVAS_LINE);
    display_end_panel(c->d, c->box, c->axes);
}

void canvas_drop_panel(canvas *c)
{
    display_drop_panel(c->d);
}
