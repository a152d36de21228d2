/* SPDX-License-Identifier: GPL-3.0-or-later
**
** plot.c - pictures of a deck, as scripts for gnuplot: what all kinds share.
*/
#include <string.h>

#include "format.h"
#include "plot.h"
#include "sketch.h"

#define PLOT_NAME(code, name, width, height, per_branch, needs) name,
const char *const plot_names[] = {PLOT_LIST(PLOT_NAME) NULL};

#define PLOT_INFO(code, name, width, height, per_branch, needs) {width, height, per_branch, needs},
static const struct {
    int width, height, per_branch, needs;
} plot_table[] = {PLOT_LIST(PLOT_INFO)};

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

static void put_terminal(FILE *out, const deck *d, const plot_request *request)
{
    int width = plot_table[request->kind].width, height = plot_table[request->kind].height;

    if (plot_table[request->kind].per_branch && d->open && d->crossed)
        height *= 2;
    if (request->kind == PLOT_VECTORS && !d->has_forces)
        height = height / 3 + 40;
    switch (request->file) {
    case PLOT_PNG:
        fprintf(out, "set terminal pngcairo size %d,%d font 'sans,11' noenhanced\n", width, height);
        break;
    case PLOT_PDF:
        fprintf(out, "set terminal pdfcairo size %d.%02din,%d.%02din font 'sans,9' noenhanced\n",
                width / 100, width % 100, height / 100, height % 100);
        break;
    case PLOT_TXT:
        fprintf(out, "set terminal dumb nofeed size %d,%d noenhanced\n", width / 8, height / 16);
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
        sketch_quote(out, request->picture);
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
    "lw 1 lc rgb '#DDDDDD'",          /* other positions */
    "lw 2 lc rgb '#000000'",          /* pin forces */
    "lw 2 lc rgb '#E69F00'",          /* loads */
    "lw 1 dt (4,4) lc rgb '#777777'", /* construction */
    "lw 3 lc rgb '#CC79A7'"           /* results */
};

static void put_head(FILE *out, const deck *d, const plot_request *request)
{
    int i;

    fprintf(out, "# %s of a deck, by fourlink %s: for gnuplot 5 or later\n",
            plot_names[request->kind], fourlink_version());
    fputs("set encoding utf8\n", out);
    put_terminal(out, d, request);
    for (i = 1; i < PEN_COUNT; i++)
        fprintf(out, "set style line %d %s\n", i, style_of_pen[i]);
    fputs("set linetype 1 lw 2 dt 1 lc rgb '#0072B2'\n"
          "set linetype 2 lw 2 dt (10,5) lc rgb '#D55E00'\n"
          "set linetype 3 lw 2 dt (3,3) lc rgb '#009E73'\n"
          "set linetype 4 lw 2 dt (12,4,2,4) lc rgb '#000000'\n"
          "set linetype 5 lw 2 dt (6,3,2,3,2,3) lc rgb '#CC79A7'\n"
          "set linetype 6 lw 2 dt (2,6) lc rgb '#E69F00'\n"
          "set key noautotitle\n"
          "set style textbox opaque noborder\n"
          "source = ",
          out);
    sketch_quote(out, request->deck_name);
    fprintf(out, " . '%s  |  fourlink %s'\ntitle = ",
            d->sweep.n_variables ? ", first design of its sweep" : "", fourlink_version());
    sketch_quote(out, d->title[0] ? d->title : request->deck_name);
    putc('\n', out);
}

void plot_panels(FILE *out, int rows, int columns)
{
    fprintf(out, "set multiplot layout %d,%d title title . \"\\n\" . source . \"\\n\"\n", rows,
            columns);
}

void plot_source(FILE *out)
{
    fputs("set label title at screen 0.01,0.015 left font ',9' front\n"
          "set label source at screen 0.99,0.015 right font ',9' front\n",
          out);
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
            flk_mistake_note(&d->mistakes, place, "more than 24 positions", (char *)NULL);
            return 0;
        }
        if (request->n_angles == 1 && request->kind != PLOT_MECHANISM) {
            flk_mistake_note(&d->mistakes, place, plot_names[request->kind],
                             " is drawn at one position, not at several", (char *)NULL);
            return 0;
        }
        if (!flk_deck_read_quantity(d, place, flk_text_trim(item), QUANTITY_ANGLE, &si, &digit))
            return 0;
        angle = flk_unit_from_si(si, d->units[QUANTITY_ANGLE].unit);
        if (!analysis_find_angle(a, angle, &request->angles[request->n_angles])) {
            char word[60];

            flk_mistake_note(&d->mistakes, place, "the motion does not reach theta2 = ",
                             flk_text_copy(flk_text_trim(item), word, sizeof word), (char *)NULL);
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

static int write_kind(FILE *out, analysis *a, const plot_request *request, const char **why)
{
    switch (request->kind) {
    case PLOT_MOTION:
        return plot_motion(out, a, why);
    case PLOT_FORCES:
        return plot_forces(out, a, why);
    case PLOT_TURNING:
        return plot_turning(out, a, why);
    case PLOT_POLAR:
        return plot_polar(out, a, why);
    case PLOT_VECTORS:
        return plot_vectors(out, a, request, why);
    case PLOT_KLEIN:
        return plot_klein(out, a, request, why);
    case PLOT_ANIMATION:
        return plot_animation(out, a, why);
    case PLOT_MECHANISM:
    default:
        return plot_mechanism(out, a, request, why);
    }
}

int plot_write(FILE *out, deck *d, plot_request *request)
{
    int needs = plot_table[request->kind].needs, written = 0;
    const char *why = "not enough memory";
    text_place place;
    analysis a;

    place.source = "--plot-kind";
    place.line = 0;
    if ((needs & PLOT_FORCES_OF_DECK) && !d->has_forces)
        why = "there are no forces to draw: the deck has no masses and no loads";
    else if ((needs & PLOT_SLIDER_CRANK) && d->design.kind != FOURLINK_SLIDER_CRANK)
        why = "Klein's construction is for a slider-crank";
    else if ((needs & PLOT_DRAWING) && (d->n_loads > PLOT_LOADS || d->n_points > PLOT_POINTS))
        why = "a drawing takes 40 loads and 24 points at most";
    else if (analysis_open(&a, d, (d->has_forces ? NEED_FORCES : 0) | NEED_EXTRAS)) {
        put_head(out, d, request);
        if (request->at && !read_angles(d, &a, request)) {
            analysis_close(&a);
            return 0;
        }
        written = write_kind(out, &a, request, &why);
        analysis_close(&a);
    }
    if (request->n_angles)
        place.source = "--plot-at";
    if (!written)
        flk_mistake_note(&d->mistakes, place, why, (char *)NULL);
    return written;
}
