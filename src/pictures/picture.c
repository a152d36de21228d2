/* SPDX-License-Identifier: GPL-3.0-or-later
**
** picture.c - pictures of a deck, as scripts for gnuplot: what all kinds share.
*/
#include <string.h>

#include "base/format.h"
#include "picture.h"
#include "tables/print.h"
#include "sketch.h"

#define PLOT_NAME(code, name, columns, rows, width, height, needs) name,
const char *const plot_names[] = {PLOT_LIST(PLOT_NAME) NULL};

#define PLOT_INFO(code, name, columns, rows, width, height, needs) \
    {columns, rows, width, height, needs},
static const struct {
    int columns, rows, width, height, needs;
} plot_table[] = {PLOT_LIST(PLOT_INFO)};

#define TEXT_HEIGHT 26 /* lines of a panel in a text terminal */

/* By plot_file. */
static const char *const endings[] = {".svg", ".png", ".pdf", ".txt", ".gif"};

plot_file plot_file_of(const char *name)
{
    size_t n = strlen(name);
    int i;

    if (strcmp(name, "-") == 0)
        return PLOT_TXT;
    for (i = 0; i < PLOT_FILE_COUNT; i++)
        if (n >= 4 && flk_text_equal(flk_text_of(name + n - 4), endings[i]))
            break;
    return (plot_file)i;
}

/* At most so many lines stand beside a drawing: angles, forces, torques, and the paths in its key; of
** free bodies for each link. */
static int lines_beside(const deck *d, int each_link)
{
    int lines[FOURLINK_FOLLOWER + 1] = {0}, most = 0, sum = 0, link;
    unsigned long i;

    for (i = 0; i < d->n_loads; i++)
        lines[d->loads[i].link] += d->loads[i].torque != 0 || d->variations[i].torque.n > 0 ? 2 : 1;
    for (link = 0; link <= FOURLINK_FOLLOWER; link++) {
        sum += lines[link];
        most = lines[link] > most ? lines[link] : most;
    }
    return each_link ? 7 + most : 16 + sum + (int)d->n_points;
}

static void lay_out(canvas *c, FILE *out, const deck *d, const plot_request *request)
{
    int is_text = request->file == PLOT_TXT, rows = plot_table[request->kind].rows;
    double height = is_text ? TEXT_HEIGHT * CANVAS_LINE : plot_table[request->kind].height,
           beside = 0;

    if (rows == 0)
        rows = d->open && d->crossed ? 2 : 1;
    if (request->kind == PLOT_VECTORS && !d->has_forces)
        rows = 1;
    if (plot_table[request->kind].needs & PLOT_DRAWING)
        beside = (lines_beside(d, request->kind == PLOT_VECTORS) + 5) *
                     (is_text ? CANVAS_LINE : 1.2 * CANVAS_LINE) -
                 height;
    canvas_open(c, out, is_text, plot_table[request->kind].columns, rows,
                plot_table[request->kind].width, height, beside > 0 ? beside : 0);
}

static void put_terminal(const canvas *c, const plot_request *request)
{
    FILE *out = c->out;
    int width = (int)c->width, height = (int)c->height;

    switch (request->file) {
    case PLOT_PNG:
        fprintf(out, "set terminal pngcairo size %d,%d font 'sans,11' noenhanced\n", width, height);
        break;
    case PLOT_PDF:
        fprintf(out,
                "set terminal pdfcairo size %d.%02din,%d.%02din font 'sans,8' fontscale 1 "
                "noenhanced\n",
                width / 100, width % 100, height / 100, height % 100);
        break;
    case PLOT_TXT:
        fprintf(out, "set terminal dumb nofeed size %d,%d noenhanced\n", CANVAS_TEXT_WIDTH,
                (int)(height / CANVAS_LINE));
        break;
    case PLOT_GIF:
        fprintf(out, "set terminal gif %s size %d,%d font 'sans,11' noenhanced\n",
                request->kind == PLOT_ANIMATION ? "animate delay 6 loop 0" : "", width, height);
        break;
    case PLOT_SVG:
    default:
        fprintf(out, "set terminal svg size %d,%d font 'sans,14' noenhanced background 'white'\n",
                width, height);
        break;
    }
    if (request->picture) {
        /* not a pipe, and not a home folder, whatever it begins with */
        fputs(request->picture[0] == '/' ? "set output " : "set output './' . ", out);
        canvas_quote(out, request->picture);
        putc('\n', out);
    }
}

/* Colours of M. Okabe and K. Ito ("Color universal design", 2008), which the colour-blind tell apart;
** widths and dashes tell the lines apart also in grey. */
static const char *const style_of_pen[PEN_COUNT] = {
    "",
    "lw 1.5 lc rgb '#000000'",        /* ground */
    "lw 5 lc rgb '#0072B2'",          /* crank */
    "lw 4 lc rgb '#D55E00'",          /* coupler */
    "lw 3 lc rgb '#009E73'",          /* rocker, piston */
    "lw 1.5 lc rgb '#CC79A7'",        /* paths */
    "lw 1 lc rgb '#DDDDDD'",          /* positions on the way */
    "lw 2 lc rgb '#000000'",          /* pin forces */
    "lw 2 lc rgb '#E69F00'",          /* loads */
    "lw 1 dt (4,4) lc rgb '#777777'", /* construction */
    "lw 3 lc rgb '#CC79A7'",          /* results */
    "lw 1.5 lc rgb '#777777'"         /* other positions */
};

static void put_head(const canvas *c, const deck *d, const plot_request *request, const char *held)
{
    char rest[200];
    int i;

    fprintf(c->out, "# %s of a deck, by fourlink %s: for gnuplot 5 or later\n",
            plot_names[request->kind], fourlink_version());
    fputs("set encoding utf8\n", c->out);
    put_terminal(c, request);
    for (i = 1; i < PEN_COUNT; i++)
        fprintf(c->out, "set style line %d %s\n", i, style_of_pen[i]);
    fputs("set linetype 1 lw 2 dt 1 lc rgb '#0072B2'\n"
          "set linetype 2 lw 2 dt (10,5) lc rgb '#D55E00'\n"
          "set linetype 3 lw 2 dt (3,3) lc rgb '#009E73'\n"
          "set linetype 4 lw 2 dt (12,4,2,4) lc rgb '#000000'\n"
          "set linetype 5 lw 2 dt (6,3,2,3,2,3) lc rgb '#CC79A7'\n"
          "set linetype 6 lw 2 dt (2,6) lc rgb '#E69F00'\n"
          "set key noautotitle\n"
          "set style textbox opaque margins 0.3,0.3 noborder\n",
          c->out);
    canvas_name(c, d->title[0] ? d->title : request->deck_name, request->deck_name,
                flk_text_join(rest, sizeof rest,
                              d->sweep.n_variables ? ", first design of its sweep" : "", held,
                              "  |  fourlink ", fourlink_version(), (char *)NULL));
}

/* The crank angles of --plot-at, separated by commas. */
static int read_angles(deck *d, analysis *a, plot_request *request)
{
    text rest = flk_text_of(request->at), item;
    text_place place;
    double si, digit, angle;

    place.source = "--plot-at";
    place.line = 0;
    while (flk_text_split(&rest, ',', &item)) {
        if (request->n_angles == PLOT_POSITIONS) {
            flk_mistake(&d->mistakes, place, "more than 24 positions");
            return 0;
        }
        if (request->n_angles == 1 && request->kind != PLOT_MECHANISM) {
            flk_mistake(&d->mistakes, place, "%s is drawn at one position, not at several",
                        plot_names[request->kind]);
            return 0;
        }
        if (!flk_deck_read_quantity(d, place, flk_text_trim(item), QUANTITY_ANGLE, &si, &digit))
            return 0;
        angle = flk_unit_from_si(si, d->units[QUANTITY_ANGLE].unit);
        if (!analysis_find_angle(a, angle, &request->angles[request->n_angles])) {
            flk_mistake(&d->mistakes, place, "the motion does not reach theta2 = %t",
                        flk_text_trim(item));
            return 0;
        }
        request->n_angles++;
    }
    return 1;
}

int plot_position(analysis *a, fourlink_branch branch, const plot_request *request, result *r)
{
    unsigned long i;
    int status;

    if (request->n_angles)
        fourlink_motion_at(&a->d->motion, request->angles[0], &r->row);
    else
        analysis_spread(a, 1, 6, &r->row);
    analysis_at(a, branch, &r->row.crank, r);
    status = r->status;
    for (i = 0; r->status != FOURLINK_OK && !request->n_angles && i < a->range.n_rows; i++)
        analysis_row(a, branch, i, r);
    return r->status == FOURLINK_OK ? FOURLINK_OK : status;
}

static int write_kind(canvas *on, analysis *a, const plot_request *request, const char **why)
{
    switch (request->kind) {
    case PLOT_MOTION:
        return plot_motion(on, a, why);
    case PLOT_FORCES:
        return plot_forces(on, a, why);
    case PLOT_TURNING:
        return plot_turning(on, a, why);
    case PLOT_POLAR:
        return plot_polar(on, a, why);
    case PLOT_VECTORS:
        return plot_vectors(on, a, request, why);
    case PLOT_KLEIN:
        return plot_klein(on, a, request, why);
    case PLOT_ANIMATION:
        return plot_animation(on, a, why);
    case PLOT_MECHANISM:
    default:
        return plot_mechanism(on, a, request, why);
    }
}

/* A cycle in place of a deck's one instant, of which speed and acceleration are held; words that tell so. */
static const char *hold_instant(deck *d)
{
    fourlink_motion *motion = &d->motion;
    double turn = motion->speed != 0 ? motion->speed : motion->acceleration;
    double cycle = flk_unit_from_si(d->cycle, d->units[QUANTITY_ANGLE].unit);

    motion->from = 0;
    motion->to = turn < 0 ? -cycle : cycle;
    motion->interval = cycle / 72;
    motion->hold = 1;
    d->one_instant = 0;
    return motion->acceleration != 0 ? ", speed and acceleration held" : ", speed held";
}

static const char *missing(const deck *d, plot_kind kind)
{
    int needs = plot_table[kind].needs;

    if ((needs & PLOT_FORCES_OF_DECK) && !d->has_forces)
        return "there are no forces to draw: the deck has no masses and no loads";
    if ((needs & PLOT_SLIDER_CRANK) && d->design.kind != FOURLINK_SLIDER_CRANK)
        return "Klein's construction is for a slider-crank";
    if ((needs & PLOT_DRAWING) && (d->n_loads > PLOT_LOADS || d->n_points > PLOT_POINTS))
        return "a drawing takes 40 loads and 24 points at most";
    return NULL;
}

/* 1; 0 and the reason, or null for one that has been told. */
static int write_script(FILE *out, deck *d, plot_request *request, const char **why)
{
    deck cycle = *d;
    const char *held = "";
    int written = 0;
    analysis a;
    canvas c;

    *why = missing(d, request->kind);
    if (*why)
        return 0;
    if (d->one_instant && (plot_table[request->kind].needs & PLOT_RANGE))
        held = hold_instant(&cycle);
    *why = "not enough memory";
    if (!analysis_open(&a, &cycle, (d->has_forces ? NEED_FORCES : 0) | NEED_EXTRAS))
        return 0;
    lay_out(&c, out, d, request);
    put_head(&c, d, request, held);
    if (!request->at || read_angles(d, &a, request))
        written = write_kind(&c, &a, request, why);
    else
        *why = NULL;
    analysis_close(&a);
    return written;
}

int plot_write(FILE *out, deck *d, plot_request *request)
{
    const char *why = NULL;
    text_place place;
    int written = write_script(out, d, request, &why);

    place.source = request->n_angles ? "--plot-at" : "--plot-kind";
    place.line = 0;
    if (!written && why)
        flk_mistake(&d->mistakes, place, "%s", why);
    return written;
}
