/* SPDX-License-Identifier: GPL-3.0-or-later
**
** canvas.c - a picture's panels: where each one stands, its margins, its titles.
*/
#include <string.h>

#include "canvas.h"
#include "base/format.h"
#include "base/text.h"

#define HEAD (4 * CANVAS_LINE)    /* title and source */
#define CANVAS_WORDS 1200         /* bytes of a title, letters of which may have four */
#define LEFT (12 * CANVAS_LETTER) /* numbers and name of the axis */
#define BELOW (4 * CANVAS_LINE)
#define SHORTENED "\342\200\246" /* an ellipsis, in UTF-8 */

/* Within double quotes gnuplot looks for backslashes, for commands between backquotes, and for the end of
** the line. */
void canvas_quote(FILE *out, const char *words)
{
    putc('"', out);
    for (; *words; words++)
        if (strchr("\"\\`", *words) || ((unsigned char)*words < ' '))
            fprintf(out, "\\%03o", (unsigned)*words);
        else
            putc(*words, out);
    putc('"', out);
}

static int begins_letter(char c)
{
    return ((unsigned char)c & 0xC0) != 0x80;
}

int canvas_letters(const char *words)
{
    int n = 0;

    for (; *words; words++)
        n += begins_letter(*words);
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
                 double height, double below)
{
    memset(c, 0, sizeof *c);
    c->out = out;
    c->is_text = is_text;
    c->columns = is_text ? 1 : columns;
    c->rows = is_text ? rows * columns : rows;
    c->width = is_text ? CANVAS_TEXT_WIDTH * CANVAS_LETTER : width * columns;
    c->below = below;
    c->height = HEAD + (height + below) * c->rows;
}

void canvas_name(const canvas *c, const char *title, const char *source, const char *rest)
{
    int letters = (int)(c->width / CANVAS_LETTER) - 2;
    char words[CANVAS_WORDS];

    fputs("title = ", c->out);
    canvas_quote(c->out, canvas_shorten(title, letters, 0, words, sizeof words));
    fputs("\nsource = ", c->out);
    canvas_quote(c->out,
                 canvas_shorten(source, letters - canvas_letters(rest), 1, words, sizeof words));
    fputs(" . ", c->out);
    canvas_quote(c->out, rest);
    putc('\n', c->out);
}

void canvas_begin(const canvas *c)
{
    fputs("set multiplot title title . \"\\n\" . source\n", c->out);
}

void canvas_end(const canvas *c)
{
    fputs("unset multiplot\n", c->out);
}

static void put(const canvas *c, const char *before, double x, const char *after)
{
    char number[FORMAT_SIZE];

    fprintf(c->out, "%s%s%s", before, format_general(x, 6, number), after);
}

void canvas_heading(const canvas *c)
{
    put(c, "set label title at screen 0.5, screen ", 1 - CANVAS_LINE / c->height, " center\n");
    put(c, "set label source at screen 0.5, screen ", 1 - 2 * CANVAS_LINE / c->height, " center\n");
}

void canvas_panel(canvas *c, int lines, double right)
{
    double width = c->width / c->columns, height = (c->height - HEAD) / c->rows;
    double x = c->next % c->columns * width, y = HEAD + c->next / c->columns % c->rows * height;

    c->left = LEFT;
    c->right = right < 0.5 * width ? right : 0.5 * width;
    c->box_width = width - c->left - c->right;
    c->box_height = height - lines * CANVAS_LINE - BELOW - c->below;
    c->lines = lines;
    put(c, "set lmargin at screen ", (x + c->left) / c->width, "; ");
    put(c, "set rmargin at screen ", (x + width - c->right) / c->width, "\n");
    put(c, "set tmargin at screen ", 1 - (y + lines * CANVAS_LINE) / c->height, "; ");
    put(c, "set bmargin at screen ", 1 - (y + height - BELOW - c->below) / c->height, "\n");
    c->next++;
}

static void put_axis(FILE *out, const char *axis, const char *name, const char *unit_name)
{
    char words[200];

    fprintf(out, "set %slabel ", axis);
    canvas_quote(out, flk_text_join(words, sizeof words, name, " (", unit_name, ")", (char *)NULL));
    putc('\n', out);
}

/* A text terminal cannot turn the name of the axis y, which goes to the title. */
void canvas_titles(const canvas *c, const char *title, const char *x, const char *x_unit,
                   const char *y, const char *y_unit)
{
    int letters = (int)((c->left + c->box_width + c->right) / CANVAS_LETTER) - 2;
    char words[CANVAS_WORDS], fitting[CANVAS_WORDS];

    flk_text_join(words, sizeof words, title, (char *)NULL);
    put_axis(c->out, "x", x, x_unit);
    if (c->is_text)
        flk_text_join(words, sizeof words, title, title[0] ? ", " : "", y, " (", y_unit, ")",
                      (char *)NULL);
    else
        put_axis(c->out, "y", y, y_unit);
    fputs("set title ", c->out);
    canvas_quote(c->out, canvas_shorten(words, letters, 0, fitting, sizeof fitting));
    /* in the middle of the panel */
    put(c, " offset ", (c->right - c->left) / (2 * CANVAS_LETTER), ",");
    fprintf(c->out, "%d\n", c->lines - 2);
}

void canvas_key(const canvas *c)
{
    double line = c->is_text ? 1.7 * CANVAS_LINE : CANVAS_LINE; /* the terminal rounds down */

    put(c, "set key at graph 0.5, graph ", 1 + line / c->box_height, " center center horizontal\n");
}

void canvas_grid(const canvas *c)
{
    fputs(c->is_text ? "unset grid\n" : "set grid lt 1 lw 0.5 lc rgb '#DDDDDD'\n", c->out);
}
