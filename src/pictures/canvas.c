/* SPDX-License-Identifier: GPL-3.0-or-later
**
** canvas.c - a picture's panels: their places, margins and titles.
*/
#include <stdarg.h>
#include <stdlib.h>
#include <string.h>

#include "canvas.h"
#include "system/format.h"
#include "base/message.h"

#define HEAD (4 * CANVAS_LINE) /* title and source */
#define NO_HEAD (0.4 * CANVAS_LINE)
#define CANVAS_WORDS 1200           /* bytes of a title; a letter may have four */
#define LEFT (11.5 * CANVAS_LETTER) /* numbers and name of the y axis */
#define BELOW (4 * CANVAS_LINE)
#define SHORTENED "\342\200\246" /* an ellipsis, in UTF-8 */

/* Inside double quotes gnuplot interprets backslashes, commands in backquotes, and the end of the line.
** The name of a file is written as it is.  In a text what is not printable is shown as a question mark,
** so that every script and picture is valid UTF-8, and ]]> gets a blank: gnuplot would copy it, and no SVG
** may have it. */
static void put_quoted(FILE *out, const char *words, int is_file)
{
    text rest = flk_text_of(words);

    putc('"', out);
    while (rest.length) {
        size_t n = is_file ? 1 : flk_text_printable(rest);

        if (!is_file && strncmp(rest.start, "]]>", 3) == 0) {
            fputs("]] ", out);
            n = 2;
        } else if (n == 0) {
            putc('?', out);
        } else if (strchr("\"\\`", *rest.start) || (unsigned char)*rest.start < ' ') {
            fprintf(out, "\\%03o", (unsigned)*rest.start);
        } else {
            fwrite(rest.start, 1, n, out);
        }
        rest = flk_text_from(rest, n ? n : 1);
    }
    putc('"', out);
}

/* 1 at a mark of a subscript or a superscript. */
static int is_mark(const char *c)
{
    return strncmp(c, NOTATION_SUB, NOTATION_MARK) == 0 ||
           strncmp(c, NOTATION_SUPER, NOTATION_MARK) == 0;
}

/* With gnuplot's own marks, a_{CB}^{n}; on a text terminal without any. */
static void put_marked(const canvas *c, const char *words)
{
    char marked[CANVAS_WORDS];
    size_t n = 0;
    int is_in = 0;

    while (*words && n + 8 < sizeof marked) {
        if (is_in && (is_mark(words) || *words == ' ')) {
            marked[n++] = '}';
            is_in = 0;
        }
        if (!is_mark(words)) {
            marked[n++] = *words++;
            continue;
        }
        if (!c->is_text) {
            marked[n++] = strncmp(words, NOTATION_SUB, NOTATION_MARK) == 0 ? '_' : '^';
            marked[n++] = '{';
            is_in = 1;
        }
        words += NOTATION_MARK;
    }
    if (is_in)
        marked[n++] = '}';
    marked[n] = '\0';
    put_quoted(c->out, marked, 0);
}

const char *canvas_mode(const char *words)
{
    return strstr(words, NOTATION_SUB) ? "enhanced" : "noenhanced";
}

void canvas_print(const canvas *c, const char *format, ...)
{
    char number[FORMAT_SIZE], *end;
    va_list arguments;
    int digits;

    va_start(arguments, format);
    for (; *format; format++) {
        if (*format != '%' || *++format == '%') {
            putc(*format, c->out);
        } else if (*format == 's') {
            fputs(va_arg(arguments, const char *), c->out);
        } else if (*format == 'q' || *format == 'f') {
            put_quoted(c->out, va_arg(arguments, const char *), *format == 'f');
        } else if (*format == 'w') {
            put_marked(c, va_arg(arguments, const char *));
        } else if (*format == 'd') {
            fprintf(c->out, "%d", va_arg(arguments, int));
        } else { /* .8g */
            digits = (int)strtol(format + 1, &end, 10);
            format = end;
            fputs(format_general(va_arg(arguments, double), digits, number), c->out);
        }
    }
    va_end(arguments);
}

static int begins_letter(char c)
{
    return ((unsigned char)c & 0xC0) != 0x80;
}

int canvas_letters(const char *words)
{
    int n = 0;

    for (; *words; words++)
        n += begins_letter(*words) && !is_mark(words);
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

void canvas_open(canvas *c, FILE *out, int is_text, int columns, int rows, double width,
                 double height, double below, int has_title)
{
    memset(c, 0, sizeof *c);
    c->head = has_title ? HEAD : NO_HEAD;
    c->out = out;
    c->is_text = is_text;
    c->columns = is_text ? 1 : columns;
    c->rows = is_text ? rows * columns : rows;
    c->width = is_text ? CANVAS_TEXT_WIDTH * CANVAS_LETTER : width * columns;
    c->below = below;
    c->height = c->head + (height + below) * c->rows;
}

void canvas_name(const canvas *c, const char *title, const char *source, const char *rest)
{
    int letters = (int)(c->width / CANVAS_LETTER) - 2;
    char words[CANVAS_WORDS];

    canvas_print(c, "title = %q\n", canvas_shorten(title, letters, 0, words, sizeof words));
    letters -= canvas_letters(rest);
    canvas_print(c, "source = %q . %q\n", canvas_shorten(source, letters, 1, words, sizeof words),
                 rest);
}

void canvas_heading(const canvas *c)
{
    canvas_print(c,
                 "set label title at screen 0.5, screen %.6g center noenhanced\n"
                 "set label source at screen 0.5, screen %.6g center noenhanced\n",
                 1 - CANVAS_LINE / c->height, 1 - 2 * CANVAS_LINE / c->height);
}

void canvas_panel(canvas *c, int lines, double right)
{
    double width = c->width / c->columns, height = (c->height - c->head) / c->rows;
    double x = c->next % c->columns * width, y = c->head + c->next / c->columns % c->rows * height;

    c->left = LEFT;
    c->right = right < 0.5 * width ? right : 0.5 * width;
    c->box_width = width - c->left - c->right;
    c->box_height = height - lines * CANVAS_LINE - BELOW - c->below;
    c->lines = lines;
    c->curves = 0;
    canvas_print(c,
                 "set lmargin at screen %.6g; set rmargin at screen %.6g\n"
                 "set tmargin at screen %.6g; set bmargin at screen %.6g\n",
                 (x + c->left) / c->width, (x + width - c->right) / c->width,
                 1 - (y + lines * CANVAS_LINE) / c->height,
                 1 - (y + height - BELOW - c->below) / c->height);
    c->next++;
}

const char *canvas_symbol(const canvas *c, const char *name, char out[NOTATION_SIZE])
{
    return c->is_text ? name : notation_name(name, out);
}

const char *canvas_unit(const canvas *c, const char *unit, char out[NOTATION_SIZE])
{
    return c->is_text ? unit : notation_unit(unit, out);
}

static void put_axis(const canvas *c, const char *axis, const char *name, const char *unit_name)
{
    char words[200], own[NOTATION_SIZE];

    flk_message(words, sizeof words, "%s (%s)", name, canvas_unit(c, unit_name, own));
    canvas_print(c, "set %slabel %q\n", axis, words);
}

/* A text terminal cannot turn the name of the y axis, so it goes to the title. */
void canvas_titles(const canvas *c, const char *x, const char *x_unit, const char *y,
                   const char *y_unit, const char *format, ...)
{
    int letters = (int)((c->left + c->box_width + c->right) / CANVAS_LETTER) - 2;
    char words[CANVAS_WORDS], fitting[CANVAS_WORDS];
    va_list values;
    size_t n;

    va_start(values, format);
    n = strlen(flk_message_list(words, sizeof words, format, values));
    va_end(values);
    put_axis(c, "x", x, x_unit);
    if (c->is_text)
        flk_message(words + n, sizeof words - n, "%s%s (%s)", n ? ", " : "", y, y_unit);
    else
        put_axis(c, "y", y, y_unit);
    /* in the middle of the panel */
    canvas_print(c, "set title %q offset %.6g,%d\n",
                 canvas_shorten(words, letters, 0, fitting, sizeof fitting),
                 (c->right - c->left) / (2 * CANVAS_LETTER), c->lines - 2);
}

void canvas_key(const canvas *c)
{
    double line =
        (c->is_text ? 0.85 : 0.5) * (c->lines - 1) * CANVAS_LINE; /* the terminal rounds down */

    canvas_print(c, "set key at graph 0.5, graph %.6g center center horizontal\n",
                 1 + line / c->box_height);
}

void canvas_note(const canvas *c, int line, const char *format, ...)
{
    char words[MESSAGE_SIZE];
    va_list values;

    va_start(values, format);
    flk_message_list(words, sizeof words, format, values);
    va_end(values);
    canvas_print(c, "set label %w at graph 1.02, graph 1 offset 0,%d left %s\n", words, -line,
                 canvas_mode(words));
}

void canvas_grid(const canvas *c)
{
    fputs(c->is_text ? "unset grid\n" : "set grid lt 1 lw 0.5 lc rgb '#DDDDDD'\n", c->out);
}
