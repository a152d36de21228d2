/* SPDX-License-Identifier: GPL-3.0-or-later
**
** turning.c - the turning moment over a cycle in the sense of rotation, its mean, and the areas between them.
*/
#include <math.h>

#include <gsl/gsl_math.h>

#include "graph.h"
#include "room.h"

#define AREA_STEPS 100 /* of an area */
#define ROOM 0.16      /* above and below the curve, for the labels of E max and E min */
#define MARGIN 27      /* letters at the right of the axes */

#define DELTA_E "\316\224E" /* with the Greek letter, in UTF-8 */

/* The turning moment of a branch, in the deck's units and as drawn: angles grow with the motion from 0, and
** a moment is positive in the sense of rotation. */
typedef struct diagram {
    const picture *p;
    fourlink_branch branch;
    fourlink_turning t;
    int sense;    /* -1: clockwise */
    double speed; /* rad/s */
    double cycle, mean, low, high;
    double moment[PICTURE_STEPS + 1]; /* NaN if the linkage cannot be assembled there */
    room r;
} diagram;

/* theta2 in rad at an angle of the diagram. */
static double theta2_at(const diagram *d, double angle)
{
    double si = view_si(&d->p->v, QUANTITY_ANGLE, angle);

    return (d->sense > 0 ? si : d->p->v.problem.cycle - si) - d->p->v.problem.motion.x_at;
}

static double moment_at(const diagram *d, double angle)
{
    const picture *p = d->p;
    fourlink_losses losses;
    fourlink_forces forces;
    fourlink_state state;
    fourlink_crank crank;
    double gas_force;

    crank.theta2 = theta2_at(d, angle);
    crank.omega2 = d->speed;
    crank.alpha2 = 0;
    if (fourlink_deck_analyse(p->v.deck, d->branch, &crank, 0, p->loads, &state, &forces, &losses,
                              &gas_force) != FOURLINK_OK)
        return GSL_NAN;
    return view_value(&p->v, QUANTITY_TORQUE, -d->sense * forces.Ts);
}

/* Area k in the order of the motion, with its ends as drawn; its energy in J. */
static double find_area(const diagram *d, int k, double *from, double *to)
{
    const fourlink_area *area = &d->t.area[d->sense > 0 ? k : d->t.n_areas - 1 - k];
    double first = view_value(&d->p->v, QUANTITY_ANGLE, area->from);
    double last = view_value(&d->p->v, QUANTITY_ANGLE, area->to);

    *from = d->sense > 0 ? first : d->cycle - last;
    *to = d->sense > 0 ? last : d->cycle - first;
    return area->energy;
}

static void sample(diagram *d)
{
    int k;

    d->low = d->high = d->mean;
    for (k = 0; k <= PICTURE_STEPS; k++) {
        double T = d->moment[k] = moment_at(d, d->cycle * k / PICTURE_STEPS);

        if (T < d->low)
            d->low = T;
        if (T > d->high)
            d->high = T;
    }
    if (!(d->high > d->low))
        d->high = d->low + 1;
}

/* Set the axes, and what no text should cover: the curve, and the mean. */
static void put_axes(diagram *d)
{
    double border = (d->high - d->low) * ROOM / (1 - 2 * ROOM), angles[PICTURE_STEPS + 1];
    place_box frame;
    int k;

    frame.x_min = 0;
    frame.x_max = d->cycle;
    frame.y_min = d->low - border;
    frame.y_max = d->high + border;
    room_set_axes(&d->r, frame, graph_angle_step(d->p, d->cycle), 0);
    for (k = 0; k <= PICTURE_STEPS; k++)
        angles[k] = d->cycle * k / PICTURE_STEPS;
    room_add_curve(&d->r, angles, d->moment, PICTURE_STEPS + 1);
    room_add_line(&d->r, place_at(0, d->mean), place_at(d->cycle, d->mean));
}

/* The centroid of an area. */
static fourlink_vector centroid(const diagram *d, double from, double to)
{
    double sum = 0, x = 0, y = 0, angle, excess;
    int k;

    for (k = 0; k < AREA_STEPS; k++) {
        angle = from + (to - from) * (k + 0.5) / AREA_STEPS;
        excess = moment_at(d, angle) - d->mean;
        if (gsl_isnan(excess))
            continue;
        sum += excess;
        x += angle * excess;
        y += excess * excess / 2;
    }
    return sum != 0 ? place_at(x / sum, d->mean + y / sum) : place_at((from + to) / 2, d->mean);
}

static double clamp(double x, double low, double high)
{
    return GSL_MIN_DBL(GSL_MAX_DBL(x, low), high);
}

/* Draw a line from the edge of a text to its place, unless it stands on it. */
static void put_leader(const diagram *d, fourlink_vector middle, double half, fourlink_vector to)
{
    double w = half / d->r.x_scale, h = CANVAS_LINE / 2 / d->r.y_scale;
    double x = clamp(to.x, middle.x - w, middle.x + w), y = clamp(to.y, middle.y - h, middle.y + h);

    if (x != to.x || y != to.y)
        display_line(d->p->on.d, PEN_GROUND, DISPLAY_FRONT, place_at(x, y), to);
}

/* Put the energies of the areas on their centroids, or beside them with a line to them. */
static void put_areas(diagram *d)
{
    double from, to, energy;
    char words[PICTURE_WORDS];
    fourlink_vector at, middle;
    int k;

    for (k = 0; k < d->t.n_areas; k++) {
        energy = find_area(d, k, &from, &to);
        if (fabs(energy) < 0.02 * d->t.energy_fluctuation)
            continue;
        at = centroid(d, from, to);
        picture_words(d->p, "", energy, QUANTITY_ENERGY, words);
        if (room_put(&d->r, at, 0, 0, 0, words, 0, &middle))
            put_leader(d, middle, canvas_width_of(words) / 2, at);
    }
}

/* Mark where the flywheel has its largest or its smallest energy. */
static void put_mark(diagram *d, double angle, const char *name, int line)
{
    char mark[PICTURE_MARK];
    double half = canvas_width_of(name) / 2 / d->r.x_scale;
    double y = d->r.frame.y_max - CANVAS_LINE / d->r.y_scale;
    double x = clamp(angle, half, d->cycle - half);

    display_line(d->p->on.d, PEN_CONSTRUCTION, DISPLAY_LINES, place_at(angle, d->r.frame.y_min),
                 place_at(angle, d->r.frame.y_max));
    graph_mark(d->p, place_at(angle, d->mean), 4, 0);
    display_text(d->p->on.d, 0, place_at(x, y), DISPLAY_MIDDLE, name)->is_boxed = 1;
    room_take(&d->r, place_at(x, y), name);
    canvas_note(&d->p->on, line, "%s at %s", name, picture_mark(d->p, angle, 4, mark));
}

/* The energy grows from 0 at the beginning of the cycle by each area; the extremes lie between areas. */
static void put_extremes(diagram *d)
{
    double E = 0, least = 0, greatest = 0, from, to, at_least = 0, at_greatest = 0;
    int k;

    if (d->t.n_areas < 2 || d->t.n_areas == FOURLINK_AREAS)
        return;
    for (k = 0; k < d->t.n_areas; k++) {
        E += find_area(d, k, &from, &to);
        if (E > greatest + 1e-9 * d->t.energy_fluctuation) {
            greatest = E;
            at_greatest = to;
        }
        if (E < least - 1e-9 * d->t.energy_fluctuation) {
            least = E;
            at_least = to;
        }
    }
    put_mark(d, at_greatest, "E max", 6);
    put_mark(d, at_least, "E min", 7);
}

/* Put the coefficients to the right of the axes. */
static void put_coefficients(const diagram *d)
{
    const canvas *on = &d->p->on;

    canvas_note(on, 0, "coefficient of fluctuation");
    if (d->t.has_coefficient)
        canvas_note(on, 1, "of energy %.4g", d->t.energy_coefficient);
    else
        canvas_note(on, 1, "of energy: none, its mean is 0");
    if (d->t.fluctuation > 0)
        canvas_note(on, 2, "of speed %.4g", d->t.fluctuation);
    else
        canvas_note(on, 2, "of speed: no flywheel");
    canvas_note(on, 4, "above the mean the");
    canvas_note(on, 5, "flywheel takes up energy");
}

static void put_titles(const diagram *d)
{
    char mean[PICTURE_WORDS], change[PICTURE_WORDS], x[NOTATION_SIZE + 40], y[NOTATION_SIZE + 40];
    char theta[NOTATION_SIZE], torque[NOTATION_SIZE];
    const picture *p = d->p;
    int is_clockwise = d->sense < 0;

    picture_words(p, "mean", d->sense * d->t.mean_torque, QUANTITY_TORQUE, mean);
    picture_words(p, DELTA_E, d->t.energy_fluctuation, QUANTITY_ENERGY, change);
    flk_message(x, sizeof x, is_clockwise ? "-%s, turned clockwise" : "%s",
                canvas_symbol(&p->on, "theta2", theta));
    flk_message(y, sizeof y, is_clockwise ? "turning moment %s, clockwise" : "turning moment -%s",
                canvas_symbol(&p->on, "Ts", torque));
    canvas_titles(&p->on, x, p->v.units[QUANTITY_ANGLE].name, y, p->v.units[QUANTITY_TORQUE].name,
                  "%s: %s, %s", fourlink_branch_text(d->branch), mean, change);
}

/* Draw the moment, or the area between it and the mean. */
static void put_moment(diagram *d, display_sort sort, int stroke, const char *words)
{
    display *list = d->p->on.d;
    display_item *x;
    int k;

    x = graph_begin(d->p, stroke, "turning", fourlink_branch_text((int)d->branch));
    x->sort = sort;
    x->layer = sort == DISPLAY_CURVE ? DISPLAY_CURVES : DISPLAY_BACK;
    x->level = d->mean;
    for (k = 0; k <= PICTURE_STEPS; k++)
        if (!gsl_isnan(d->moment[k]))
            display_add_place(list, place_at(d->cycle * k / PICTURE_STEPS, d->moment[k]));
    canvas_add_key(d->r.on, sort, stroke, words);
}

/* Fill the areas, except on a text terminal. */
static void plot_moment(diagram *d)
{
    char symbol[NOTATION_SIZE], name[NOTATION_SIZE + 2];
    display *list = d->p->on.d;

    if (!d->r.on->is_text) {
        put_moment(d, DISPLAY_ABOVE, 0, "above");
        put_moment(d, DISPLAY_BELOW, 0, "below");
    }
    put_moment(d, DISPLAY_CURVE, PEN_CURVE + 3,
               flk_text_join(name, sizeof name, d->sense > 0 ? "-" : "",
                             canvas_symbol(d->r.on, "Ts", symbol), (char *)NULL));
    graph_begin(d->p, PEN_CURVE + 1, "mean", "line");
    display_add_place(list, place_at(0, d->mean));
    display_add_place(list, place_at(d->cycle, d->mean));
    canvas_add_key(d->r.on, DISPLAY_LINE, PEN_CURVE + 1, "mean");
}

const char *picture_turning(picture *p, fourlink_branch branch)
{
    diagram d;

    if (fourlink_results_turning(p->v.results, branch, &d.t) != FOURLINK_OK)
        return "the turning moment needs a crank that drives and turns fully, at constant speed or "
               "in a steady motion";
    d.p = p;
    d.branch = branch;
    d.speed = picture_speed_of(p, branch);
    d.sense = d.speed < 0 ? -1 : 1;
    d.cycle = view_value(&p->v, QUANTITY_ANGLE, p->v.problem.cycle);
    d.mean = view_value(&p->v, QUANTITY_TORQUE, d.sense * d.t.mean_torque);
    room_open(&d.r, &p->on, 3, MARGIN * CANVAS_LETTER);
    sample(&d);
    put_titles(&d);
    put_axes(&d);
    put_coefficients(&d);
    put_extremes(&d);
    put_areas(&d);
    plot_moment(&d);
    canvas_end_panel(&p->on);
    return NULL;
}
