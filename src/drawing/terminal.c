/* SPDX-License-Identifier: GPL-3.0-or-later
**
** terminal.c - a display list in characters.
**
** A cell is a letter, or a pattern of two by four dots: Braille has a character for each (Unicode, U+2800).
** Texts stand in front of lines.
*/
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include <gsl/gsl_math.h>

#include "base/text.h"
#include "system/memory.h"
#include "view/notation.h"
#include "terminal.h"

#define CELL 5 /* bytes: a character in UTF-8 */

typedef struct screen {
    const display *d;
    int columns, rows;
    double letter, line;   /* pixels of a cell */
    unsigned char *dots;   /* by cell: bits, as Unicode counts them */
    char (*letters)[CELL]; /* by cell; "": none */
    int is_ascii;
} screen;

/* The bit of a dot, by its column and row in the cell. */
static const unsigned char bits[2][4] = {{1, 2, 4, 64}, {8, 16, 32, 128}};

/* Set the dot at a place in dots. */
static void set_dot(screen *s, int x, int y)
{
    if (x < 0 || y < 0 || x >= 2 * s->columns || y >= 4 * s->rows)
        return;
    s->dots[y / 4 * s->columns + x / 2] |= bits[x % 2][y % 4];
}

#define FARTHEST 1e6 /* dots: what lies beyond is not seen */

static int whole_of(double dots)
{
    return !(dots > -FARTHEST) ? -(int)FARTHEST
           : dots > FARTHEST   ? (int)FARTHEST
                               : (int)floor(dots);
}

static int dot_x(const screen *s, double x)
{
    return whole_of(2 * x / s->letter);
}

static int dot_y(const screen *s, double y)
{
    return whole_of(4 * y / s->line);
}

static void draw_line(screen *s, fourlink_vector from, fourlink_vector to)
{
    int x = dot_x(s, from.x), y = dot_y(s, from.y), i;
    int dx = dot_x(s, to.x) - x, dy = dot_y(s, to.y) - y;
    int n = GSL_MAX_INT(abs(dx), abs(dy));

    if (n > 100000)
        return;
    set_dot(s, x, y);
    for (i = 1; i <= n; i++)
        set_dot(s, x + (int)floor((double)dx * i / n + 0.5),
                y + (int)floor((double)dy * i / n + 0.5));
}

static void draw_circle(screen *s, fourlink_vector at, double radius)
{
    int i;

    for (i = 0; i < 24; i++)
        draw_line(s, place_polar(at, radius, i * M_PI / 12),
                  place_polar(at, radius, (i + 1) * M_PI / 12));
}

/* What a terminal without UTF-8 has for some letters; a question mark for others. */
static const struct {
    const char *letter, *plain;
} spellings[] = {
    {"\316\270", "theta"}, {"\317\211", "omega"}, {"\316\261", "alpha"}, {"\316\274", "mu"},
    {"\316\263", "gamma"}, {"\317\206", "phi"},   {"\316\224", "d"},     {"\302\260", " deg"},
    {"\302\262", "^2"},    {"\342\202\200", "0"}, {"\342\202\201", "1"}, {"\342\202\202", "2"},
    {"\342\202\203", "3"}, {"\342\202\204", "4"}, {"\342\202\205", "5"}, {"\342\202\206", "6"},
    {"\342\202\207", "7"}, {"\342\202\210", "8"}, {"\342\202\211", "9"}, {"\342\202\233", "s"},
    {"\302\267", "."},     {"\302\265", "u"},     {"\342\200\246", "~"}};

/* Write a text without marks of subscripts, in ASCII if that is asked for. */
static void spell(const char *words, int is_ascii, char *out, size_t size)
{
    size_t n = 0, i;

    while (*words && n + 8 < size) {
        text rest = flk_text_of(words);
        size_t bytes = flk_text_printable(rest);
        const char *plain = "?";

        if (notation_mark(words)) {
            words += NOTATION_MARK;
            continue;
        }
        if (bytes == 1 || (bytes && !is_ascii)) {
            memcpy(out + n, words, bytes);
            n += bytes;
        } else {
            for (i = 0; i < sizeof spellings / sizeof *spellings; i++)
                if (strncmp(words, spellings[i].letter, strlen(spellings[i].letter)) == 0)
                    plain = spellings[i].plain;
            strcpy(out + n, plain);
            n += strlen(plain);
        }
        words += bytes ? bytes : 1;
    }
    out[n] = '\0';
}

static int length_of(const char *words)
{
    int n = 0;

    for (; *words; words++)
        n += ((unsigned char)*words & 0xC0) != 0x80;
    return n;
}

static void put_words(screen *s, const display_item *x)
{
    fourlink_vector at = s->d->places[x->first];
    char words[1300], own[DISPLAY_WORDS];
    int length, column, row = whole_of(at.y / s->line);
    const char *c = words;

    spell(display_text_of(s->d, x, own), s->is_ascii, words, sizeof words);
    length = length_of(words);
    column = whole_of(at.x / s->letter + 0.5) - (x->align == DISPLAY_RIGHT    ? length
                                                 : x->align == DISPLAY_MIDDLE ? length / 2
                                                                              : 0);
    column = GSL_MAX_INT(GSL_MIN_INT(column, s->columns - length), 0);
    if (row < 0 || row >= s->rows)
        return;
    for (; *c && column < s->columns; column++) {
        char *cell = s->letters[row * s->columns + column];

        do
            *cell++ = *c++;
        while (((unsigned char)*c & 0xC0) == 0x80);
        *cell = '\0';
    }
}

static void draw_item(screen *s, const display_item *x)
{
    const fourlink_vector *at = s->d->places + x->first;
    size_t i;

    if (x->sort == DISPLAY_TEXT)
        put_words(s, x);
    else if (x->sort == DISPLAY_DISC || x->sort == DISPLAY_CENTRE || x->sort == DISPLAY_MARK)
        draw_circle(s, *at, GSL_MAX_DBL(x->size, 3));
    else
        for (i = 0; i + 1 < x->n; i++)
            if (!gsl_isnan(at[i].x) && !gsl_isnan(at[i + 1].x) && x->pen != PEN_GRID)
                draw_line(s, at[i], at[i + 1]);
}

/* A cell without a letter: Braille, or a dot at the height of its dots. */
static void put_dots(const screen *s, unsigned char dots, FILE *out)
{
    if (!dots)
        putc(' ', out);
    else if (s->is_ascii)
        putc(!(dots & ~9) ? '\'' : !(dots & ~(9 | 18)) ? '"' : !(dots & (9 | 18)) ? '.' : ':', out);
    else
        fprintf(out, "\342%c%c", 0xA0 + (dots >> 6), 0x80 + (dots & 0x3F));
}

static void put_rows(const screen *s, FILE *out)
{
    int row, column, last;

    for (row = 0; row < s->rows; row++) {
        const char(*letters)[CELL] = (const char(*)[CELL])s->letters + row * s->columns;
        const unsigned char *dots = s->dots + row * s->columns;

        for (last = s->columns;
             last > 0 && !dots[last - 1] && (!*letters[last - 1] || *letters[last - 1] == ' ');
             last--)
            ;
        for (column = 0; column < last; column++)
            if (*letters[column])
                fputs(letters[column], out);
            else
                put_dots(s, dots[column], out);
        putc('\n', out);
    }
}

int terminal_write(FILE *out, const display *d, double letter, double line, int is_ascii)
{
    screen s;
    size_t cells, i;
    int layer, has_memory;

    s.d = d;
    s.letter = letter;
    s.line = line;
    s.is_ascii = is_ascii;
    s.columns = (int)ceil(d->width / letter - 1e-9);
    s.rows = (int)ceil(d->height / line - 1e-9);
    cells = (size_t)s.columns * (size_t)s.rows;
    s.dots = memory_get(cells, 1);
    s.letters = memory_get(cells, CELL);
    has_memory = s.dots && s.letters;
    for (layer = 0; has_memory && layer < DISPLAY_LAYERS; layer++)
        for (i = 0; i < d->n_items; i++)
            if (d->items[i].layer == layer)
                draw_item(&s, &d->items[i]);
    if (has_memory)
        put_rows(&s, out);
    free(s.dots);
    free(s.letters);
    return has_memory;
}
