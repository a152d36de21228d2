/* SPDX-License-Identifier: GPL-3.0-or-later
**
** test_drawing.c - random display lists: where their items are in pixels, curves cut to the box, areas, arcs; what a
** terminal shows of them; and many steps as one motion, whose places stay in their frames.
*/
#include <float.h>

#include "check.h"
#include "drawing/motion.h"
#include "drawing/terminal.h"

static uint64_t seed;

static double any(double low, double high)
{
    return uniform(&seed, low, high);
}

static int one_of(int n)
{
    return (int)any(0, n);
}

/* ------------------------------------------------------------------------------------------- pixels */

static const place_box box = {60, 460, 40, 340}, axes = {-3, 5, 10, 16};

static fourlink_vector any_place(void)
{
    return place_at(any(-3, 5), any(10, 16));
}

/* x to the right, y upwards; both of the axes' units have 50 pixels. */
static fourlink_vector pixels(fourlink_vector at)
{
    return place_at(60 + (at.x + 3) * 50, 340 - (at.y - 10) * 50);
}

static void near_place(fourlink_vector at, fourlink_vector expected, double tolerance)
{
    if (!(place_distance(at, expected) <= tolerance))
        fail_msg("(%.9g, %.9g), expected (%.9g, %.9g)", at.x, at.y, expected.x, expected.y);
}

TEST(places_in_pixels)
{
    int number, k;

    for (number = 0; number < 200; number++) {
        fourlink_vector p = any_place(), q = any_place(), part = place_at(any(0, 1), any(0, 1));
        double radius = any(0.1, 2), from = any(-4, 4), span = any(-7, 7);
        display_item *x;
        display d;

        display_open(&d);
        display_begin_panel(&d);
        display_line(&d, PEN_CRANK, DISPLAY_LINES, p, q);
        x = display_line(&d, PEN_CRANK, DISPLAY_LINES, part, place_at(1, 0));
        x->in_box = 1;
        x = display_text(&d, PEN_CRANK, p, DISPLAY_LEFT, "word");
        x->dx = 7;
        x->dy = -3;
        x = display_add(&d, DISPLAY_DISC, PEN_GROUND, DISPLAY_FRONT);
        x->size = radius;
        display_add_place(&d, q);
        x = display_arc(&d, PEN_CRANK, p, from, span);
        x->radius[0] = radius;
        x->radius[1] = 2 * radius;
        display_end_panel(&d, box, axes);
        near_place(d.places[d.items[0].first], pixels(p), 1e-9);
        near_place(d.places[d.items[0].first + 1], pixels(q), 1e-9);
        near_place(d.places[d.items[1].first], place_at(60 + 400 * part.x, 340 - 300 * part.y),
                   1e-9);
        near_place(d.places[d.items[1].first + 1], place_at(460, 340), 1e-9);
        near_place(d.places[d.items[2].first], place_beside(pixels(p), 7, -3), 1e-9);
        assert_string_equal(display_words(&d, d.items[2].words), "word");
        assert_close(d.items[3].size, 50 * radius, 1e-12);
        /* a spiral, counter-clockwise on paper */
        x = &d.items[4];
        assert_true(x->n >= 9);
        for (k = 0; k < (int)x->n; k++) {
            double along = (double)k / (double)(x->n - 1);

            near_place(d.places[x->first + (size_t)k],
                       pixels(place_polar(p, radius * (1 + along), from + along * span)),
                       1e-9 * 300);
        }
        display_close(&d);
    }
}

/* The distance of a place from a line. */
static double off(fourlink_vector at, fourlink_vector p, fourlink_vector q)
{
    double length = place_distance(p, q), along;

    if (length < 1e-12)
        return place_distance(at, p);
    along = ((at.x - p.x) * (q.x - p.x) + (at.y - p.y) * (q.y - p.y)) / length;
    along = fmax(0, fmin(length, along));
    return place_distance(
        at, place_at(p.x + (q.x - p.x) * along / length, p.y + (q.y - p.y) * along / length));
}

static int is_in_box(fourlink_vector at, double margin)
{
    return at.x > box.x_min + margin && at.x < box.x_max - margin && at.y > box.y_min + margin &&
           at.y < box.y_max - margin;
}

enum { CURVE = 60 };

/* A curve that leaves the box and has gaps: what is drawn of it is in the box and on the curve, all of it, also with the bends
** alone. */
TEST(curves_cut_to_the_box)
{
    int number, k, j;

    for (number = 0; number < some_of(300); number++) {
        fourlink_vector at[CURVE];
        int is_smooth = number % 2;
        double phase = any(0, 6), size = any(1, 6);
        display_item *x;
        display d;

        display_open(&d);
        display_begin_panel(&d);
        display_add(&d, DISPLAY_CURVE, PEN_CURVE, DISPLAY_CURVES);
        for (k = 0; k < CURVE; k++) {
            at[k] = is_smooth ? place_at(-4 + 10.0 * k / CURVE, 13 + size * sin(phase + 0.1 * k))
                              : place_at(any(-5, 7), any(8, 18));
            if (one_of(8) == 0)
                at[k] = place_at(NAN, NAN);
            display_add_place(&d, at[k]);
        }
        display_end_panel(&d, box, axes);
        x = &d.items[0];
        for (k = 0; k + 1 < CURVE; k++)
            for (j = 0; j <= 20; j++) {
                fourlink_vector p = pixels(at[k]), q = pixels(at[k + 1]), here;
                size_t from = 0, n = 0, i, next;
                double nearest = HUGE_VAL, nearest_bend = HUGE_VAL;

                here = place_at(p.x + (q.x - p.x) * j / 20, p.y + (q.y - p.y) * j / 20);
                if (isnan(here.x) || !is_in_box(here, 1e-3))
                    continue;
                while (display_next_piece(&d, x, &from, &n)) {
                    const fourlink_vector *piece = d.places + x->first + from;

                    for (i = 0; i + 1 < n; i++)
                        nearest = fmin(nearest, off(here, piece[i], piece[i + 1]));
                    for (i = 0; i + 1 < n; i = next) {
                        next = display_next_bend(piece, i, n);
                        assert_true(next > i && next < n);
                        nearest_bend = fmin(nearest_bend, off(here, piece[i], piece[next]));
                    }
                }
                assert_true(nearest < 1e-6);
                assert_true(nearest_bend < 0.0201);
            }
        for (k = 0; k < (int)x->n; k++) {
            fourlink_vector drawn = d.places[x->first + (size_t)k];
            double nearest = HUGE_VAL;

            if (isnan(drawn.x))
                continue;
            assert_true(is_in_box(drawn, -1e-6));
            for (j = 0; j + 1 < CURVE; j++)
                if (!isnan(at[j].x) && !isnan(at[j + 1].x))
                    nearest = fmin(nearest, off(drawn, pixels(at[j]), pixels(at[j + 1])));
            assert_true(nearest < 1e-6);
        }
        display_close(&d);
    }
}

/* The signed area of a polygon. */
static double area_of(const fourlink_vector *at, size_t n)
{
    double sum = 0;
    size_t i;

    for (i = 0; i < n; i++)
        sum += (at[i].x * at[(i + 1) % n].y - at[(i + 1) % n].x * at[i].y) / 2;
    return sum;
}

/* The areas above and below a level are those between the curve and the level, by the trapezoidal rule on a fine grid. */
TEST(areas_beside_a_level)
{
    int number, k, j;

    for (number = 0; number < 200; number++) {
        double y[CURVE], level = any(11, 15), above = 0, below = 0;
        display_item *x;
        display d;

        display_open(&d);
        display_begin_panel(&d);
        for (k = 0; k < CURVE; k++)
            y[k] = 13 + 2.5 * sin(any(0, 0.3) + 0.2 * k) + any(-0.3, 0.3);
        for (j = 0; j < 2; j++) {
            x = display_add(&d, j ? DISPLAY_BELOW : DISPLAY_ABOVE, PEN_CURVE, DISPLAY_BACK);
            x->level = level;
            for (k = 0; k < CURVE; k++)
                display_add_place(&d, place_at(-3 + 8.0 * k / (CURVE - 1), y[k]));
        }
        display_end_panel(&d, box, axes);
        for (k = 0; k + 1 < CURVE; k++)
            for (j = 0; j < 100; j++) {
                double excess = y[k] + (y[k + 1] - y[k]) * (j + 0.5) / 100 - level,
                       width = 8.0 / (CURVE - 1) / 100;

                *(excess > 0 ? &above : &below) += fabs(excess) * width * 2500;
            }
        assert_near(fabs(area_of(d.places + d.items[0].first, d.items[0].n)), above,
                    1e-3 * (above + below));
        assert_near(fabs(area_of(d.places + d.items[1].first, d.items[1].n)), below,
                    1e-3 * (above + below));
        display_close(&d);
    }
}

/* --------------------------------------------------------------------------------------- a terminal */

enum { COLUMNS = 52, ROWS = 19, DOTS_X = 2 * COLUMNS, DOTS_Y = 4 * ROWS };
#define LETTER 10.0
#define LINE 20.0

static unsigned char dots[DOTS_Y][DOTS_X];
static char letters[ROWS][COLUMNS];

/* The text that a terminal gets of a display list. */
static void write_terminal(const display *d, int is_ascii, char *out, size_t size)
{
    FILE *file = tmpfile();
    size_t n;

    assert_non_null(file);
    assert_int_equal(terminal_write(file, d, LETTER, LINE, is_ascii), 1);
    rewind(file);
    n = fread(out, 1, size - 1, file);
    out[n] = '\0';
    fclose(file);
}

/* Read Braille: U+2800 + a bit for each of two by four dots, 1, 2, 4, 64 downwards and 8, 16, 32, 128. */
static void read_braille(const char *text)
{
    static const int rows[8] = {0, 1, 2, 0, 1, 2, 3, 3}, columns[8] = {0, 0, 0, 1, 1, 1, 0, 1};
    const unsigned char *c = (const unsigned char *)text;
    int row = 0, column = 0, bit;

    memset(dots, 0, sizeof dots);
    memset(letters, 0, sizeof letters);
    for (; *c; c++) {
        if (*c == '\n') {
            row++;
            column = 0;
            continue;
        }
        assert_true(row < ROWS && column < COLUMNS);
        if (*c == 0xE2) {
            int code = ((c[1] & 0x3F) << 6 | (c[2] & 0x3F)) & 0xFF;

            for (bit = 0; bit < 8; bit++)
                dots[4 * row + rows[bit]][2 * column + columns[bit]] =
                    (unsigned char)(code >> bit & 1);
            c += 2;
        } else if (*c != ' ')
            letters[row][column] = (char)*c;
        column++;
    }
    assert_int_equal(row, ROWS);
}

/* The cell has a letter, which covers dots. */
static int is_covered(int x, int y)
{
    return letters[y / 4][x / 2] != 0;
}

static fourlink_vector in_dots(fourlink_vector at)
{
    return place_at(2 * at.x / LETTER, 4 * at.y / LINE);
}

/* How far a dot is from what of an item is drawn: its lines, or its circle. */
static double off_item(const display *d, const display_item *x, fourlink_vector dot)
{
    const fourlink_vector *at = d->places + x->first;
    double nearest = HUGE_VAL, radius = fmax(x->size, 3);
    size_t i;

    if (x->sort == DISPLAY_DISC || x->sort == DISPLAY_CENTRE || x->sort == DISPLAY_MARK)
        return fabs(place_distance(dot, *at) - radius);
    for (i = 0; i + 1 < x->n && x->sort != DISPLAY_TEXT && x->pen != PEN_GRID; i++)
        if (!isnan(at[i].x) && !isnan(at[i + 1].x))
            nearest = fmin(nearest, off(dot, at[i], at[i + 1]));
    return nearest;
}

/* There is a dot within a dot of a place in pixels, or a letter. */
static int has_dot(fourlink_vector at)
{
    fourlink_vector p = in_dots(at);
    int x, y;

    for (y = (int)floor(p.y) - 1; y <= (int)floor(p.y) + 1; y++)
        for (x = (int)floor(p.x) - 1; x <= (int)floor(p.x) + 1; x++)
            if (x < 0 || y < 0 || x >= DOTS_X || y >= DOTS_Y || dots[y][x] || is_covered(x, y))
                return 1;
    return 0;
}

static void add_any_items(display *d)
{
    static const display_sort round_ones[] = {DISPLAY_DISC, DISPLAY_CENTRE, DISPLAY_MARK};
    display_item *x;
    int k;

    display_line(d, PEN_CRANK, DISPLAY_LINES, any_place(), any_place());
    display_line(d, PEN_GRID, DISPLAY_BACK, any_place(), any_place());
    x = display_line(d, PEN_FORCE, DISPLAY_FRONT, any_place(), any_place());
    x->sort = DISPLAY_ARROW;
    for (k = 0; k < 3; k++) {
        x = display_add(d, round_ones[k], PEN_GROUND, DISPLAY_FRONT);
        x->size = k == 2 ? any(0, 20) : any(0, 0.5);
        display_add_place(d, any_place());
    }
    x = display_arc(d, PEN_COUPLER, any_place(), any(-3, 3), any(-6, 6));
    x->radius[0] = x->radius[1] = any(0.2, 2);
    display_add(d, DISPLAY_CURVE, PEN_CURVE, DISPLAY_CURVES);
    for (k = 0; k < 9; k++)
        display_add_place(d, k == 4 ? place_at(NAN, NAN) : any_place());
}

TEST(a_terminal_shows_what_is_drawn)
{
    static char text[20 * COLUMNS * ROWS], plain[20 * COLUMNS * ROWS];
    int number, x, y, k;
    size_t i;

    for (number = 0; number < 20; number++) {
        display d;

        display_open(&d);
        d.width = COLUMNS * LETTER;
        d.height = ROWS * LINE;
        display_begin_panel(&d);
        add_any_items(&d);
        display_end_panel(&d, box, axes);
        write_terminal(&d, 0, text, sizeof text);
        read_braille(text);
        for (y = 0; y < DOTS_Y; y++)
            for (x = 0; x < DOTS_X; x++) {
                double nearest = HUGE_VAL;

                for (i = 0; i < d.n_items; i++)
                    nearest = fmin(
                        nearest, off_item(&d, &d.items[i],
                                          place_at((x + 0.5) * LETTER / 2, (y + 0.5) * LINE / 4)));
                if (dots[y][x] && nearest > 6)
                    fail_msg("a dot at %d, %d that is %.3g pixels from all\n%s", x, y, nearest,
                             text);
            }
        for (i = 0; i < d.n_items; i++) {
            const display_item *item = &d.items[i];
            const fourlink_vector *at = d.places + item->first;

            if (off_item(&d, item, *at) == HUGE_VAL)
                continue; /* the grid */
            for (k = 0; k <= 200; k++) {
                size_t side = (size_t)(k % ((int)item->n > 1 ? (int)item->n - 1 : 1));
                double part = any(0, 1);
                fourlink_vector here =
                    item->n == 1 ? place_polar(*at, fmax(item->size, 3), 2 * PI * part)
                                 : place_at(at[side].x + part * (at[side + 1].x - at[side].x),
                                            at[side].y + part * (at[side + 1].y - at[side].y));

                if (!isnan(here.x) && !has_dot(here))
                    fail_msg("no dot at %.4g, %.4g of item %u\n%s", here.x, here.y, (unsigned)i,
                             text);
            }
        }
        /* in ASCII the same cells have a sign at the height of their dots */
        write_terminal(&d, 1, plain, sizeof plain);
        for (x = y = 0, k = 0; plain[k]; k++) {
            unsigned char *upper[4];
            int has[4], j, expected;

            if (plain[k] == '\n') {
                y++;
                x = 0;
                continue;
            }
            for (j = 0; j < 4; j++) {
                upper[j] = &dots[4 * y + j][2 * x];
                has[j] = upper[j][0] | upper[j][1];
            }
            expected = !(has[0] | has[1] | has[2] | has[3]) ? ' '
                       : !(has[1] | has[2] | has[3])        ? '\''
                       : !(has[2] | has[3])                 ? '"'
                       : !(has[0] | has[1])                 ? '.'
                                                            : ':';
            assert_int_equal(plain[k], expected);
            x++;
        }
        display_close(&d);
    }
}

/* The line of a terminal that has a text, with what stands left of it as blanks. */
static void check_words(display_align align, const char *words, double x, const char *expected)
{
    char text[4000], *line;
    display d;

    display_open(&d);
    d.width = COLUMNS * LETTER;
    d.height = ROWS * LINE;
    display_begin_panel(&d);
    display_text(&d, PEN_GROUND, place_at(x, 7.5 * LINE), align, words);
    d.items[0].layer = DISPLAY_BACK;
    display_line(&d, PEN_CRANK, DISPLAY_FRONT, place_at(0, 9.5 * LINE),
                 place_at(COLUMNS * LETTER, 9.5 * LINE));
    display_end_panel(&d, (place_box){0, COLUMNS * LETTER, 0, ROWS * LINE},
                      (place_box){0, COLUMNS * LETTER, ROWS * LINE, 0});
    write_terminal(&d, 0, text, sizeof text);
    line = text;
    for (x = 0; x < 7; x++)
        line = strchr(line, '\n') + 1;
    line = strtok(line, "\n");
    assert_string_equal(line, expected);
    display_close(&d);
}

TEST(texts_in_a_terminal)
{
    check_words(DISPLAY_LEFT, "word", 100, "          word");
    check_words(DISPLAY_RIGHT, "word", 100, "      word");
    check_words(DISPLAY_MIDDLE, "word", 100, "        word");
    check_words(DISPLAY_LEFT, "two words  ", 100, "          two words");
    check_words(DISPLAY_RIGHT, "word", 20, "word");
    check_words(DISPLAY_LEFT, "word", 515, "                                                word");
    check_words(DISPLAY_MIDDLE, "\316\270\342\202\202 = 3", 50, "  \316\270\342\202\202 = 3");
}

/* ---------------------------------------------------------------------------------------- a motion */

enum { STEPS = 24, MOST_ITEMS = 40, MOST_PLACES = 8 };

/* What each step has. */
static struct {
    int n;
    struct {
        fourlink_vector at[MOST_PLACES];
        int n;
        display_sort sort;
        unsigned long key;
        char words[DISPLAY_WORDS];
    } item[MOST_ITEMS];
} steps[STEPS];

static unsigned long last_key;
static long n_held;                        /* places in frames that have been checked */
static fourlink_vector place_of_held[200]; /* of each track: where it was in its frame at first */

enum { ROD = 200, BLOCK, SPRING }; /* keys of frames */

/* Add a frame at a place; then it holds what follows. */
static display_item *frame_at(display *d, unsigned long key, fourlink_vector origin)
{
    display_item *x = display_add(d, DISPLAY_FRAME, PEN_OF_LINK, DISPLAY_BACK);

    x->key = key;
    d->hold = 0;
    display_add_place(d, origin);
    d->hold = key;
    return x;
}

/* Give an item the next key. */
static display_item *keyed(display_item *x)
{
    x->key = ++last_key;
    return x;
}

/* A crank with a block, a rod with a point, a spring between them, notes, two arrows that look the same, of which one or
** the other is not there now and then. */
static void draw_step(display *d, int i, double length, double offset)
{
    double theta = 0.2 + 2 * PI * i / STEPS;
    fourlink_vector A = place_at(0, 13), B = place_polar(A, 1, theta),
                    C = place_at(B.x + sqrt(length * length - (B.y - 13) * (B.y - 13)), 13);
    fourlink_vector u = place_at((C.x - B.x) / length, (C.y - B.y) / length),
                    P = place_in(B, u, 0.4 * length, offset);
    fourlink_vector corner = place_beside(C, 0.3, 0.2), other = place_beside(C, -0.3, 0.2);
    char words[40];
    display_item *x;

    last_key = 0;
    display_clear(d);
    display_begin_panel(d);
    x = keyed(display_add(d, DISPLAY_DISC, PEN_GROUND, DISPLAY_FRONT));
    x->size = 0.1;
    display_add_place(d, B);
    x = keyed(display_add(d, DISPLAY_DISC, PEN_GROUND, DISPLAY_FRONT));
    x->size = 0.1;
    display_add_place(d, C);
    if (i % 5 != 3) {
        x = display_line(d, PEN_FORCE, DISPLAY_FRONT, B,
                         place_beside(B, cos(3 * theta), sin(2 * theta)));
        x->sort = DISPLAY_ARROW;
        x->key = 100;
    }
    if (i % 4 != 1) {
        x = display_line(d, PEN_FORCE, DISPLAY_FRONT, C, place_beside(C, cos(theta), 1));
        x->sort = DISPLAY_ARROW;
        x->key = 101;
    }
    keyed(display_line(d, PEN_CRANK, DISPLAY_LINES, A, B));
    frame_at(d, ROD, B);
    display_add_place(d, place_in(B, u, 0.5, 0));
    keyed(display_line(d, PEN_COUPLER, DISPLAY_LINES, B, C));
    keyed(display_line(d, PEN_COUPLER, DISPLAY_LINES, B, P));
    keyed(display_line(d, PEN_COUPLER, DISPLAY_LINES, P, C));
    frame_at(d, BLOCK, C);
    keyed(display_line(d, PEN_FOLLOWER, DISPLAY_LINES, corner, other));
    d->hold = 0;
    keyed(display_line(d, PEN_GROUND, DISPLAY_LINES, place_at(-1, 12), place_at(2, 12)));
    /* parts of the way from A to C, which changes its length */
    x = frame_at(d, SPRING, A);
    x->size = 1;
    d->hold = 0;
    display_add_place(d, C);
    d->hold = SPRING;
    keyed(display_line(d, PEN_GROUND, DISPLAY_LINES, A, C));
    keyed(display_line(d, PEN_GROUND, DISPLAY_LINES, place_at(0.3 * C.x, 13.2),
                       place_at(0.7 * C.x, 12.8)));
    d->hold = 0;
    x = keyed(display_arc(d, PEN_CONSTRUCTION, A, 0, theta));
    x->radius[0] = x->radius[1] = 0.4;
    keyed(display_text(d, PEN_GROUND, B, DISPLAY_MIDDLE, "B"));
    sprintf(words, "%d", 15 * i);
    x = keyed(display_text(d, PEN_GROUND, place_at(-2, 11), DISPLAY_LEFT, "theta = "));
    x->part = DISPLAY_NOTE;
    display_set_value(d, x, words, i < STEPS / 2 ? " deg" : " degrees");
    x = keyed(display_text(d, PEN_GROUND, place_at(-2, 11), DISPLAY_LEFT, "a = "));
    x->part = DISPLAY_NOTE;
    display_set_value(d, x, "3", " mm");
    if (i % 7 == 2)
        keyed(display_text(d, PEN_GROUND, place_at(-2, 15), DISPLAY_LEFT, "dead"));
    display_end_panel(d, box, axes);
}

static void keep_step(const display *d, int i)
{
    char words[DISPLAY_WORDS];
    size_t k, j;

    steps[i].n = (int)d->n_items;
    for (k = 0; k < d->n_items; k++) {
        const display_item *x = &d->items[k];

        steps[i].item[k].sort = x->sort;
        steps[i].item[k].key = x->key;
        strcpy(steps[i].item[k].words, display_text_of(d, x, words));
        steps[i].item[k].n = x->sort == DISPLAY_ARC ? 1 : (int)x->n;
        for (j = 0; j < (size_t)steps[i].item[k].n; j++)
            steps[i].item[k].at[j] = x->sort == DISPLAY_ARC ? x->centre : d->places[x->first + j];
    }
}

/* A place that a frame holds stays where it is in that: its coordinates, from the frame's places by the rotation
**
**    x = c dx + s dy,  y = c dy - s dx
**
** of a stretched one with x divided by the length, are those of the first step. */
static void check_frame(const motion *m, size_t track, size_t i)
{
    size_t frame = motion_frame_of(m, track);
    const motion_item *x = &m->items[frame];
    fourlink_vector o, e, p = m->tracks[track * m->n_steps + i], q;
    double length = 1, c = 1, s = 0;

    if (frame == m->n_items) {
        near_place(motion_seen(m, frame, track, i), p, 0);
        return;
    }
    n_held++;
    o = m->tracks[x->first * m->n_steps + i];
    if (x->n > 1) {
        e = m->tracks[(x->first + 1) * m->n_steps + i];
        length = hypot(e.x - o.x, e.y - o.y);
        c = (e.x - o.x) / length;
        s = (e.y - o.y) / length;
    }
    assert_true(fabs(cos(motion_angle(m, frame, i)) - c) < 1e-12);
    assert_true(fabs(sin(motion_angle(m, frame, i)) - s) < 1e-12);
    q = place_at(c * (p.x - o.x) + s * (p.y - o.y), c * (p.y - o.y) - s * (p.x - o.x));
    if (x->like.size > 0)
        q.x /= length;
    near_place(motion_seen(m, frame, track, i), q, 1e-9);
    if (i == 0)
        place_of_held[track] = q;
    near_place(q, place_of_held[track], 1e-9);
}

/* A step of the motion is the display list that it had: its items in their order. */
static void check_step(const motion *m, int i)
{
    int k = 0, j;
    size_t at;

    for (at = 0; at < m->n_items; at++) {
        const motion_item *x = &m->items[at];
        const motion_value *value = motion_value_at(m, at, (size_t)i);
        char words[DISPLAY_WORDS];

        if (!motion_has(m, at, (size_t)i))
            continue;
        assert_true(k < steps[i].n);
        assert_int_equal(x->like.sort, steps[i].item[k].sort);
        assert_int_equal(x->like.key, steps[i].item[k].key);
        sprintf(words, "%s%s%s", display_words(&m->kept, x->like.words),
                display_words(&m->kept, value->value), display_words(&m->kept, value->unit));
        assert_string_equal(words, steps[i].item[k].words);
        for (j = 0; j < steps[i].item[k].n; j++) {
            size_t track = x->first + (size_t)j;

            near_place(m->tracks[track * m->n_steps + (size_t)i], steps[i].item[k].at[j], 1e-9);
            check_frame(m, track, (size_t)i);
        }
        k++;
    }
    assert_int_equal(k, steps[i].n);
}

TEST(motions_of_many_steps)
{
    int number, i;

    for (number = 0; number < 40; number++) {
        double length = any(1.5, 3), offset = any(-1, 1);
        size_t k;
        display d;
        motion m;

        display_open(&d);
        motion_open(&m, STEPS);
        for (i = 0; i < STEPS; i++) {
            draw_step(&d, i, length, offset);
            keep_step(&d, i);
            motion_add(&m, (size_t)i, &d);
        }
        assert_int_equal(m.n_items, 20);
        for (k = 0; k < m.n_items; k++) {
            int is_theta = strcmp(display_words(&m.kept, m.items[k].like.words), "theta = ") == 0;

            assert_int_equal(m.items[k].varies, is_theta);
            assert_int_equal(m.items[k].unit_varies, is_theta);
        }
        for (i = 0; i < STEPS; i++)
            check_step(&m, i);
        assert_int_equal(n_held, (number + 1) * STEPS * (1 + 6 + 2 + 4));
        motion_close(&m);
        display_close(&d);
    }
}

int main(void)
{
    seed = 71;
    return run_all_tests(NULL);
}
