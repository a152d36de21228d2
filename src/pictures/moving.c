/* SPDX-License-Identifier: GPL-3.0-or-later
**
** moving.c - drawings over a motion.
*/
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include <gsl/gsl_math.h>
#include <gsl/gsl_sort.h>

#include "system/memory.h"
#include "arrow.h"
#include "mechanism.h"
#include "moving.h"
#include "vectors.h"
#include "view/geometry.h"

#define MEASURED 90 /* positions, at least, whose range is found */

/* ---------------------------------------------------------------------------------------- positions */

/* Call `draw` for about so many of n positions, the last among them. */
static void draw_some(picture *p, int n, int wanted, void draw(picture *p, const void *what, int k),
                      const void *what)
{
    int stride = 1 + (n - 1) / wanted, k;

    for (k = 0; k < n; k += stride)
        draw(p, what, k);
    if ((n - 1) % stride)
        draw(p, what, n - 1);
}

void moving_run(picture *p, place_box *range, int n, void draw(picture *p, const void *what, int k),
                const void *what)
{
    labels_motion *m = memory_get(1, sizeof *m);
    int k;

    if (m)
        m->kept = memory_get(LABELS_KEPT, sizeof *m->kept);
    if (m && m->kept) {
        p->on.motion = m;
        m->drawn = *range;
        m->phase = LABELS_MEASURE;
        if (place_is_empty(range))
            draw_some(p, n, MEASURED, draw, what);
        *range = m->drawn;
        if (!p->on.is_bare) {
            m->phase = LABELS_KEEP;
            draw_some(p, n, LABELS_KEPT - 1, draw, what);
            labels_choose_sides(m);
        }
        m->phase = LABELS_DRAW;
        p->on.next = 0;
        for (k = 0; k < n; k++)
            draw(p, what, k);
        p->on.motion = NULL;
        free(m->kept);
    }
    free(m);
}

/* ----------------------------------------------------------------------------------------- drawings */

/* What one of the drawings shows. */
typedef enum subject { MECHANISM, INSET, POLYGON, BODY, NOTHING } subject;

typedef struct drawn {
    moving *of;
    subject subject;
    int which; /* link, or number of a polygon */
    double
        most; /* of a polygon: a larger one is drawn smaller; of a free body, its largest force */
    display *step;
    moving_panel *panel;
} drawn;

/* Find what drawing k shows. */
static subject subject_of(const moving *x, int k, int *which)
{
    int polygons = view_is_still(&x->p.v) ? 0 : scene_count_polygons(&x->p.v);
    int bodies = 0;

    while (x->p.v.problem.has_forces && scene_body(&x->p.v, bodies))
        bodies++;
    *which = 0;
    if (k == 0)
        return MECHANISM;
    *which = k -= 1;
    if (k < polygons)
        return POLYGON;
    k -= polygons;
    *which = k < bodies ? scene_body(&x->p.v, k) : 0;
    if (k < bodies)
        return BODY;
    k -= bodies;
    *which = k < x->p.n_insets ? x->p.insets[k] : 0;
    return k < x->p.n_insets ? INSET : NOTHING;
}

int moving_count(const moving *x)
{
    int n = 0, which;

    while (subject_of(x, n, &which) != NOTHING)
        n++;
    return n;
}

/* A step as it was solved, once for all drawings. */
struct moving_step {
    fourlink_instant now;
    fourlink_load loads[TRACKS_LOADS];
};

/* Solve all steps; 0 without memory. */
static int solve_steps(moving *x)
{
    const view *v = &x->p.v;
    unsigned long i;

    x->solved = memory_get(x->steps.n, sizeof *x->solved);
    for (i = 0; x->solved && i < x->steps.n; i++) {
        moving_step *to = &x->solved[i];

        view_find_along(v, x->branch, view_side_of_row(v, i), x->steps.at[i], NULL, &to->now,
                        to->loads);
    }
    return x->solved != NULL;
}

/* A step, with all that is drawn there. */
static const picture_row *row_of(moving *x, unsigned long step)
{
    picture_row *r = &x->row;

    r->now = x->solved[step].now;
    memcpy(r->loads, x->solved[step].loads, sizeof r->loads);
    tracks_find(&r->numbers, &x->p.v, &r->now, r->loads);
    return r;
}

/* Draw a step; at last, add it to the list. */
static void draw_step(picture *p, const void *what, int step)
{
    const drawn *x = what;
    const picture_row *r = row_of(x->of, (unsigned long)step);
    scene_polygon polygon;

    scene_find_polygon(&p->v, x->subject == POLYGON ? x->which : 0, &polygon);
    display_clear(x->step);
    p->on.next = 0;
    p->on.motion->is_first = step == 0;
    if (x->subject == MECHANISM)
        mechanism_draw(p, r, x->of->largest);
    else if (r->now.status != FOURLINK_OK)
        return;
    else if (x->subject == INSET)
        mechanism_draw_inset(p, r, x->which, x->of->largest);
    else if (x->subject == POLYGON)
        vectors_draw_polygon(p, r, &polygon, x->most);
    else
        vectors_draw_body(p, r, x->which, x->most);
    if (p->on.motion->phase != LABELS_DRAW)
        return;
    motion_add(&x->panel->list, (size_t)step, x->step);
    if (x->step->n_panels) {
        const display_panel *panel = &x->step->panels[0];

        x->panel->axes = panel->axes;
        x->panel->box = place_nothing;
        place_grow(&x->panel->box, panel->left, panel->top);
        place_grow(&x->panel->box, panel->left + panel->width, panel->top + panel->height);
    }
}

/* ------------------------------------------------------------------------------------------- panels */

/* The largest size of a polygon that is not out of proportion to the others, as those near dead positions
** are. */
static double usual_size(moving *x, int which)
{
    double *sizes = memory_get(x->steps.n, sizeof *sizes), usual = 0;
    scene_polygon polygon;
    size_t n = 0;
    unsigned long i;

    if (!sizes)
        return 1;
    scene_find_polygon(&x->p.v, which, &polygon);
    for (i = 0; i < x->steps.n; i++) {
        sizes[n] = vectors_size(row_of(x, i), &polygon);
        n += sizes[n] > 0;
    }
    gsl_sort(sizes, 1, n);
    if (n)
        usual = GSL_MIN_DBL(sizes[n - 1], 3 * sizes[n / 2]);
    free(sizes);
    return usual;
}

/* The largest force on a link, but for those near dead positions. */
static double largest_on(moving *x, int link)
{
    double largest = 0;
    unsigned long i;

    for (i = 0; i < x->steps.n; i++) {
        const picture_row *r = row_of(x, i);

        if (r->now.status == FOURLINK_OK && r->now.state.mu >= VIEW_NEAR)
            largest = GSL_MAX_DBL(largest, vectors_largest(&x->p, r, link));
    }
    return largest;
}

/* In pixels, by moving_size; the mechanism is as high as it needs, between these ratios. */
static const double widths[] = {760, 500, 340}, heights[] = {0, 320, 250};
#define LOWEST 2.2
#define HIGHEST 1.25

static double height_of_mechanism(const picture *p, double width)
{
    return floor(width / GSL_MIN_DBL(LOWEST, GSL_MAX_DBL(HIGHEST, size_aspect(p))));
}

/* The size of a panel; that of the mechanism is kept with its range. */
static void set_size(moving *x, moving_panel *panel)
{
    moving_sheet *sheet = &x->sheet;

    panel->width = widths[panel->size];
    panel->height = heights[panel->size];
    if (panel->size != MOVING_WHOLE)
        return;
    if (!(sheet->width > 0))
        sheet->width = panel->width;
    if (!(sheet->height > 0))
        sheet->height = height_of_mechanism(&x->p, sheet->width);
    panel->width = sheet->width;
    panel->height = sheet->height;
}

static void name(const picture *p, const drawn *x, char out[80])
{
    scene_polygon polygon;
    const char *link = fourlink_deck_link_text(
        p->v.deck, x->subject == POLYGON ? FOURLINK_FOLLOWER + 2 * (x->which / 2) : x->which);

    if (x->subject == MECHANISM) {
        strcpy(out, "Mechanism");
    } else if (x->subject == INSET) {
        flk_text_join(out, 80, "The ", link, " enlarged", (char *)NULL);
    } else if (x->subject == POLYGON) {
        scene_find_polygon(&p->v, x->which, &polygon);
        flk_text_join(out, 80, polygon.title, " polygon", polygon.output ? " of " : "",
                      polygon.output ? link : "", (char *)NULL);
    } else {
        flk_text_join(out, 80, x->which > FOURLINK_FOLLOWER ? "Free body of " : "Free body of the ",
                      link, (char *)NULL);
    }
}

int moving_open(moving *x, const fourlink_source *source, fourlink_results *results,
                fourlink_branch branch, const moving_steps *steps)
{
    memset(x, 0, sizeof *x);
    x->request.kind = PLOT_MECHANISM;
    x->request.is_figure = 1;
    x->request.opened = results;
    x->branch = branch;
    x->sheet.range = place_nothing;
    x->steps = *steps;
    if (!picture_open(&x->p, source, &x->request) || !solve_steps(x))
        return 0;
    scene_find(&x->row.drawn, &x->p.v);
    size_find_insets(&x->p);
    x->largest = x->p.v.problem.has_forces ? arrow_largest_of_motion(&x->p, branch) : 0;
    return 1;
}

void moving_close(moving *x)
{
    picture_close(&x->p);
    free(x->solved);
}

/* Where A is on the page of [pins], in the axes of the sheet. */
static fourlink_vector place_of_A(const view *v)
{
    double angle = geometry_turn(v) - v->problem.drawn_x;

    return place_in(place_at(0, 0), place_at(cos(angle), sin(angle)), v->problem.drawn_A.x,
                    v->problem.drawn_A.y);
}

/* A box whose origin is moved to a place. */
static place_box moved(const place_box *b, fourlink_vector to)
{
    place_box made;

    made.x_min = b->x_min + to.x;
    made.x_max = b->x_max + to.x;
    made.y_min = b->y_min + to.y;
    made.y_max = b->y_max + to.y;
    return made;
}

int moving_draw(moving *x, int k, moving_panel *panel)
{
    fourlink_vector A = place_of_A(&x->p.v);
    place_box range = place_nothing;
    display step;
    drawn what;

    what.of = x;
    what.subject = subject_of(x, k, &what.which);
    what.step = &step;
    what.panel = panel;
    what.most = what.subject == POLYGON ? usual_size(x, what.which)
                : what.subject == BODY  ? largest_on(x, what.which)
                                        : 0;
    panel->size = what.subject == MECHANISM ? MOVING_WHOLE
                  : what.subject == BODY    ? MOVING_THIRD
                                            : MOVING_HALF;
    set_size(x, panel);
    name(&x->p, &what, panel->title);
    motion_open(&panel->list, x->steps.n);
    display_open(&step);
    canvas_open(&x->p.on, &step, 0, 1, 1, panel->width, panel->height, 0, 0);
    x->p.on.is_bare = 1;
    x->p.on.head = 0;
    x->p.on.turn = geometry_turn(&x->p.v);
    if (what.subject == MECHANISM)
        range = moved(&x->sheet.range, place_at(-A.x, -A.y));
    moving_run(&x->p, &range, (int)x->steps.n, draw_step, &what);
    if (what.subject == MECHANISM)
        x->sheet.range = moved(&range, A);
    display_close(&step);
    return !memory_has_failed() && panel->list.n_items > 0;
}
