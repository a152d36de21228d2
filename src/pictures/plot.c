/* SPDX-License-Identifier: GPL-3.0-or-later
**
** plot.c - pictures of a deck: the kinds of pictures and of files.
*/
#include <math.h>
#include <string.h>

#include <gsl/gsl_math.h>

#include "base/quantity.h"
#include "system/memory.h"
#include "drawing/svg.h"
#include "drawing/terminal.h"
#include "plot.h"
#include "sketch.h"
#include "view/geometry.h"

#define PLOT_NAME(code, name, columns, rows, width, height, needs, draw, values, shows) name,
const char *const plot_names[] = {PLOT_LIST(PLOT_NAME) NULL};

#define PLOT_SHOWS(code, name, columns, rows, width, height, needs, draw, values, shows) shows,
const char *const plot_shows[] = {PLOT_LIST(PLOT_SHOWS) NULL};

#define PLOT_INFO(code, name, columns, rows, width, height, needs, draw, values, shows) \
    {columns, rows, width, height, needs, draw},
static const struct plot_info {
    int columns, rows, width, height, needs;
    const char *(*draw)(picture *p, fourlink_branch branch);
} plot_table[] = {PLOT_LIST(PLOT_INFO)};

#define SMALL_CRANK 0.7 /* of the rod: Klein's construction is small beside it */
#define LONE_WIDTH 760  /* of a single panel */
#define TEXT_HEIGHT 26  /* lines of a panel in a text terminal */

/* Free bodies with friction circles or springs, and polygons with more points, are so many times larger. */
#define CROWDED 1.3
#define MANY_POINTS 4

const char *const plot_endings[] = {".svg", ".png", ".pdf", ".txt", NULL};

int plot_is_of_position(plot_kind kind)
{
    return (plot_table[kind].needs & PLOT_AT) != 0;
}

plot_file plot_file_of(const char *name)
{
    size_t n = strlen(name);
    int i;

    if (strcmp(name, "-") == 0)
        return PLOT_TXT;
    for (i = 0; i < PLOT_FILE_COUNT; i++)
        if (n >= 4 && flk_text_equal(flk_text_of(name + n - 4), plot_endings[i]))
            break;
    return (plot_file)i;
}

/* A figure of a page, in pixels: as wide as paper at 7 pt allows, no higher than half of it; the height
** of its panels over the crank angle, as a part of the usual one, and of those with scales in place of
** axes. */
#define FIGURE_WIDTH 1000.0
#define FIGURE_HIGHEST 570.0
#define FIGURE_LOW 0.82
#define FIGURE_VECTORS 220.0
#define FIGURE_KLEIN 420.0

/* The panels of columns of the table, or of outputs of the sweep; 0: it has none of these. */
static int count_columns(picture *p)
{
    const fourlink_value *outputs;
    unsigned long n = 0;

    if (picture_has_outputs(p))
        fourlink_results_list(p->v.results, FOURLINK_OUTPUTS, &outputs, &n);
    else if (p->request->kind == PLOT_COLUMNS)
        n = (unsigned long)picture_column_panels(p);
    return (int)n;
}

/* The rows of polar diagrams: of each pin force in the axes of its links, and where there is a balance
** one more for each branch. */
static int count_polar_rows(const picture *p)
{
    int of_forces = p->v.kind.slotted ? 4 : p->v.kind.guided ? 5 : 6;

    if (!picture_has_balance(p))
        return plot_table[PLOT_POLAR].rows;
    return (of_forces + (p->v.problem.asks_for_both ? p->v.n_branches : 1) + 2) / 3;
}

/* The rows of PLOT_VECTORS: the mechanism, its polygons in pairs, each free body with its polygon. */
static int count_vector_rows(const picture *p)
{
    int polygons = scene_count_polygons(&p->v) / 2, bodies = 0;

    while (p->v.problem.has_forces && scene_body(&p->v, bodies))
        bodies++;
    return p->request->part == PLOT_OF_MOTION   ? polygons
           : p->request->part == PLOT_OF_FORCES ? bodies
                                                : 1 + polygons + bodies;
}

/* Find the panels of a picture, in columns and rows. */
static void count_panels(picture *p, int *columns, int *rows)
{
    const struct plot_info *info = &plot_table[p->request->kind];
    int n = count_columns(p);

    *columns = info->columns;
    *rows = info->rows ? info->rows : p->v.n_branches;
    if (n) {
        *columns = n > 1 ? info->columns : 1;
        *rows = (n + *columns - 1) / *columns;
    } else if (p->request->kind == PLOT_VECTORS) {
        *rows = count_vector_rows(p);
    } else if (p->request->kind == PLOT_LIMITS) {
        *columns += p->v.design->n_groups;
    } else if (p->request->kind == PLOT_MOTION) {
        *columns += p->v.design->n_groups;
        *rows = view_is_still(&p->v) ? 1 : *rows;
    } else if (p->request->kind == PLOT_KLEIN) {
        p->has_inset =
            p->v.kind.guided && p->v.design->link[FOURLINK_CRANK].length <
                                    SMALL_CRANK * p->v.design->link[FOURLINK_COUPLER].length;
        *(p->request->is_figure ? columns : rows) = 1 + p->has_inset;
    } else if (p->request->kind == PLOT_POLAR) {
        *rows = count_polar_rows(p);
    } else if (p->request->kind == PLOT_MECHANISM && p->request->file != PLOT_TXT) {
        if (!p->request->is_figure || p->v.n_branches == 1) /* a page has no room for four */
            size_find_insets(p);
        *rows *= 1 + p->n_insets;
    }
}

/* Find the size of a panel, in pixels. */
static void find_size(picture *p, int columns, int rows, double *width, double *height)
{
    const struct plot_info *info = &plot_table[p->request->kind];
    int is_text = p->request->file == PLOT_TXT;

    *width = info->width;
    *height = is_text ? TEXT_HEIGHT * CANVAS_LINE : info->height;
    if (p->request->is_figure) {
        *width = GSL_MIN_DBL(*width, FIGURE_WIDTH / columns);
        *height *= info->needs & PLOT_ANGLE_AXIS ? FIGURE_LOW : 1.05 * *width / info->width;
        if (p->request->part)
            *height = FIGURE_VECTORS;
        else if (p->request->kind == PLOT_KLEIN)
            *height = FIGURE_KLEIN;
        else if (!(info->needs & PLOT_DRAWING))
            *height = GSL_MIN_DBL(*height, FIGURE_HIGHEST / rows);
    }
    if (p->request->kind == PLOT_VECTORS && !is_text &&
        (p->v.problem.has_friction || p->v.problem.n_springs ||
         p->v.problem.n_points > MANY_POINTS)) {
        *width *= p->request->part ? 1 : CROWDED;
        *height *= CROWDED;
    }
    if (count_columns(p) == 1) /* its titles need it */
        *width = p->request->lone_width > 0 ? p->request->lone_width : LONE_WIDTH;
}

static void lay_out(picture *p)
{
    const struct plot_info *info = &plot_table[p->request->kind];
    int is_text = p->request->file == PLOT_TXT, is_vectors = p->request->kind == PLOT_VECTORS;
    double width, height, beside = 0, lines;
    int rows, columns;

    count_panels(p, &columns, &rows);
    find_size(p, columns, rows, &width, &height);
    lines = info->needs & PLOT_DRAWING ? size_lines_beside(p, is_vectors) : 0;
    if (p->request->part == PLOT_OF_FORCES)
        height = GSL_MAX_DBL(height, (lines + 1) * CANVAS_LINE);
    else if (info->needs & PLOT_FILLED && !is_text)
        height = floor(GSL_MAX_DBL(size_height(p, info->width),
                                   p->request->is_figure ? (lines + 3) * CANVAS_LINE
                                                         : (lines + 4) * 1.2 * CANVAS_LINE));
    else if (info->needs & PLOT_DRAWING && !p->request->part)
        beside = (lines + 5) * (is_text ? CANVAS_LINE : 1.2 * CANVAS_LINE) - height;
    canvas_open(&p->on, p->frames, is_text, columns, rows, width, height, beside > 0 ? beside : 0,
                !p->request->is_figure);
    p->on.turn = geometry_turn(&p->v);
    p->on.has_scale_bars = p->request->part != PLOT_WHOLE;
}

static void put_head(const picture *p, const char *deck_name, const char *held)
{
    char rest[200];

    canvas_name(&p->on, p->v.problem.title[0] ? p->v.problem.title : deck_name, deck_name,
                flk_text_join(rest, sizeof rest,
                              picture_has_outputs(p)   ? ", all designs of its sweep"
                              : p->v.problem.n_designs ? ", first design of its sweep"
                                                       : "",
                              held, "  |  fourlink ", fourlink_version(), (char *)NULL));
}

/* Add a range of crank angles to a message. */
static void add_range(const picture *p, char message[MESSAGE_SIZE], const char *before, double from,
                      double to)
{
    size_t n = strlen(message);

    flk_message(message + n, MESSAGE_SIZE - n, "%s from %.6g to %.6g %s", before, from, to,
                p->v.units[QUANTITY_ANGLE].name);
}

/* 1 if the motion goes to a spot and the links reach it on some branch; else 0 and the range. */
static int is_in_range(const picture *p, const view_spot *spot, char message[MESSAGE_SIZE])
{
    fourlink_reach reach;
    double turn;
    int i, status = FOURLINK_OK, is_over_angle = p->v.problem.over.is_crank_angle;

    for (i = 0; i < p->v.n_branches; i++) {
        status = view_find_spot(&p->v, p->v.branches[i], spot, NULL, NULL, NULL);
        if (status == FOURLINK_OK)
            return 1;
    }
    fourlink_reach_of(p->v.mechanism, &reach);
    flk_message(message, MESSAGE_SIZE, "%s = %.6g %s: %s",
                spot->is_place ? p->v.problem.over.name : "theta2", spot->at,
                spot->is_place ? p->v.problem.over.unit : p->v.units[QUANTITY_ANGLE].name,
                status != FOURLINK_NO_SUCH_ANGLE
                    ? reach.n_ranges ? "the links reach" : fourlink_status_text(status)
                : spot->is_place ? "the motion does not go there"
                : is_over_angle  ? "the motion goes"
                                 : "the crank does not pass it");
    for (i = 0; i < reach.n_ranges && status != FOURLINK_NO_SUCH_ANGLE; i++) {
        turn = view_turn_of_range(&p->v, reach.from[i], reach.to[i]);
        add_range(p, message, i ? ", and" : "",
                  view_value(&p->v, QUANTITY_ANGLE, reach.from[i] + turn),
                  view_value(&p->v, QUANTITY_ANGLE, reach.to[i] + turn));
    }
    if (status != FOURLINK_NO_SUCH_ANGLE)
        return 0;
    if (is_over_angle)
        add_range(p, message, "", p->v.problem.over.first, p->v.end);
    return 0;
}

/* The spots of --plot-at, separated by commas. */
static int read_spots(picture *p, fourlink_mistake *mistake)
{
    text rest = flk_text_of(p->request->at), item;
    char words[MESSAGE_SIZE];
    view_spot *spot;

    while (flk_text_split(&rest, ',', &item)) {
        item = flk_text_trim(item);
        if (p->n_spots == PICTURE_POSITIONS)
            return view_refuse(mistake, "--plot-at", "more than 24 positions", "");
        if (p->n_spots == 1 && p->request->kind != PLOT_MECHANISM)
            return view_refuse(mistake, "--plot-at", plot_names[p->request->kind],
                               " draws one position, not several");
        spot = &p->spots[p->n_spots++];
        if (!view_read_spot(&p->v, item, spot, words) || !is_in_range(p, spot, words))
            return view_refuse(mistake, "--plot-at", words, "");
    }
    return 1;
}

static int has_too_many_loads(const picture *p)
{
    fourlink_load_info load;
    unsigned long i, n = 0;

    for (i = 0; fourlink_deck_load(p->v.deck, i, &load) == FOURLINK_OK; i++)
        n += load.sort != FOURLINK_LOAD_GAS;
    return n > PICTURE_LOADS;
}

static const char *missing(const picture *p)
{
    int needs = plot_table[p->request->kind].needs;
    fourlink_value error;

    if ((needs & PLOT_BY_ANGLE) && !p->v.problem.over.is_crank_angle)
        return "this picture needs [motion] rows = angle; the deck has rows by time";
    if ((needs & PLOT_FORCES_OF_DECK) && !p->v.problem.has_forces)
        return "no forces to draw: the deck has no masses and no loads";
    if ((needs & PLOT_WANTED) &&
        fourlink_results_find(p->v.results, "structural_error", &error) != FOURLINK_OK)
        return "this picture needs --synthesis and a [synthesis] with a function";
    if ((needs & PLOT_ACTUAL) && p->v.problem.mode == FOURLINK_MODE_GIVEN)
        return "this picture needs [motion] mode = free, run-up or steady; the motion is given";
    if ((needs & PLOT_STROKE) && p->v.kind.shape[FOURLINK_FOLLOWER] != FOURLINK_SHAPE_BLOCK)
        return "Klein's construction needs a slider-crank";
    if (p->request->kind == PLOT_COLUMNS && !picture_has_outputs(p) &&
        p->v.n_columns > PICTURE_CURVES)
        return "a picture shows at most 24 columns; name those to draw with --columns";
    if ((needs & (PLOT_DRAWING | PLOT_AT)) &&
        (has_too_many_loads(p) || p->v.problem.n_points > TRACKS_POINTS))
        return "a drawing shows at most 40 loads and 24 points";
    return NULL;
}

/* Draw the panels; returns null, or the reason why there are none. */
static const char *draw(picture *p)
{
    const struct plot_info *info = &plot_table[p->request->kind];
    const char *why = NULL, *here;
    int i, drawn = 0;

    for (i = 0; i < (info->rows ? 1 : p->v.n_branches); i++)
        if ((here = info->draw(p, p->v.branches[i])) != NULL)
            why = here;
        else
            drawn++;
    return drawn ? NULL : why;
}

/* 1 if all branches of the deck are drawn. */
static int shows_all_branches(const picture *p)
{
    plot_kind kind = p->request->kind;

    return kind == PLOT_POLAR ? p->v.problem.asks_for_both
                              : kind != PLOT_VECTORS && kind != PLOT_KLEIN;
}

/* "theta4, omega4 over theta2" */
static void name_columns(const picture *p, char *out, size_t size)
{
    unsigned long i;

    out[0] = '\0';
    for (i = 1; i < p->v.n_columns; i++)
        flk_text_join(out + strlen(out), size - strlen(out), i > 1 ? ", " : "",
                      p->v.columns[i].name, (char *)NULL);
    flk_text_join(out + strlen(out), size - strlen(out), " over ", p->v.columns[0].name,
                  (char *)NULL);
}

static void write_caption(const picture *p, const char *deck_name, plot_caption *caption)
{
    const struct plot_info *info = &plot_table[p->request->kind];
    const char *shows = plot_shows[p->request->kind], *over = "";
    int all = p->v.n_branches > 1 && shows_all_branches(p);
    char names[PICTURE_NAMES], number[PICTURE_MARK], at[PICTURE_MARK + VIEW_WHY + 20] = "";

    if (p->request->kind == PLOT_COLUMNS) {
        name_columns(p, names, sizeof names);
        shows = picture_has_outputs(p) ? "outputs of the sweep" : names;
    } else if (info->needs & PLOT_OVER) {
        over = p->v.problem.over.words;
    }
    if ((info->needs & PLOT_AT) && !p->n_spots)
        flk_text_join(at, sizeof at, ", at \316\270" SUB_2 " = ",
                      picture_mark(p, p->shown, 7, number), p->why[0] ? ", " : "", p->why,
                      (char *)NULL);
    caption->n_lines = p->n_lines;
    caption->n_missing = p->n_missing;
    flk_text_join(caption->title, sizeof caption->title,
                  p->v.problem.title[0] ? p->v.problem.title : deck_name, (char *)NULL);
    flk_text_join(caption->words, sizeof caption->words, deck_name, ", ",
                  all ? "open and crossed branches" : fourlink_branch_text((int)p->v.branches[0]),
                  all ? ": " : " branch: ", shows, over[0] ? " over " : "", over, at, (char *)NULL);
}

/* Draw an open deck. */
static int make(picture *p, fourlink_mistake *mistake)
{
    const struct plot_info *info = &plot_table[p->request->kind];
    const char *why = missing(p), *held = "", *chosen = NULL, *steps = NULL;
    char names[PICTURE_NAMES], step[VIEW_STEP];

    if (why)
        return view_refuse(mistake, "--plot-kind", why, "");
    if (picture_has_outputs(p) && p->request->x)
        return view_refuse(mistake, "--plot-x",
                           "the outputs of a [sweep] are drawn over what it varies", "");
    if (p->request->kind == PLOT_COLUMNS && !picture_has_outputs(p)) {
        if (!picture_choose_columns(p, names, mistake))
            return 0;
        chosen = names;
    } else if (plot_values[p->request->kind]) {
        picture_choose(p, names);
        chosen = names;
    }
    p->instant = p->v.problem.motion.from;
    p->has_instant =
        p->v.problem.one_instant && (info->needs & PLOT_RANGE) && !picture_has_outputs(p);
    if (p->has_instant)
        held = p->v.problem.motion.acceleration != 0 ? ", speed and acceleration held"
                                                     : ", speed held";
    if (!p->v.problem.over.is_crank_angle && !picture_has_outputs(p) &&
        p->v.end != p->v.problem.over.first)
        steps =
            view_set_step(&p->v, fabs(p->v.end - p->v.problem.over.first) / PICTURE_STEPS, step);
    if ((chosen || held[0] || steps) && !picture_reopen(p, chosen, steps, mistake))
        return 0;
    if (p->request->kind == PLOT_POLAR && picture_take_last_turn(p, p->v.branches[0]))
        held = ", the last turn";
    lay_out(p);
    put_head(p, view_file_of(p->source->name), held);
    if (p->request->at && !read_spots(p, mistake))
        return 0;
    why = draw(p);
    return why ? view_refuse(mistake, p->n_spots ? "--plot-at" : "--plot-kind", why, "") : 1;
}

/* 1 if the last frame comes before the first one again. */
static int repeats(const picture *p)
{
    return p->v.problem.one_revolution &&
           (p->v.problem.mode == FOURLINK_MODE_GIVEN || p->v.problem.mode == FOURLINK_MODE_STEADY);
}

int plot_make(plot *x, const fourlink_source *source, const plot_request *request,
              fourlink_mistake *mistake)
{
    int made;
    picture p;

    memset(x, 0, sizeof *x);
    display_open(&x->frames[0]);
    x->n_frames = 1;
    made = picture_open(&p, source, request);
    p.frames = x->frames;
    p.n_frames = &x->n_frames;
    made = made && make(&p, mistake);
    if (made)
        write_caption(&p, view_file_of(source->name), &x->caption);
    x->repeats = made && repeats(&p);
    picture_close(&p);
    return memory_has_failed() ? -1 : made;
}

void plot_free(plot *x)
{
    int i;

    for (i = 0; i < x->n_frames; i++)
        display_close(&x->frames[i]);
}

/* ----------------------------------------------------------------------------------------------- files */

void plot_write_figure(const plot *x, FILE *out)
{
    svg_write(out, &x->frames[0], x->caption.title, x->caption.words, 1);
}

int plot_write(const plot *x, int is_text, int is_ascii, FILE *out)
{
    if (is_text)
        return terminal_write(out, &x->frames[0], CANVAS_LETTER, CANVAS_LINE, is_ascii);
    if (x->n_frames > 1)
        svg_write_motion(out, x->frames, x->n_frames, x->repeats, x->caption.title,
                         x->caption.words);
    else
        svg_write(out, &x->frames[0], x->caption.title, x->caption.words, 0);
    return 1;
}

int plot_write_exercise(const fourlink_source *source, fourlink_results *opened, FILE *out,
                        fourlink_mistake *mistake)
{
    plot_request request;
    plot drawn;
    int status;

    memset(&drawn, 0, sizeof drawn);
    memset(&request, 0, sizeof request);
    request.kind = PLOT_EXERCISE;
    request.file = PLOT_SVG;
    request.is_figure = 1;
    request.opened = opened;
    status = plot_make(&drawn, source, &request, mistake);
    if (status > 0 && !plot_write(&drawn, 0, 0, out))
        status = -1;
    plot_free(&drawn);
    return status;
}
