/* SPDX-License-Identifier: GPL-3.0-or-later
**
** curves.c - curves over the crank angle: motion, forces, turning moment; and pin forces in their
** links' axes.
*/
#include <math.h>
#include <string.h>

#include <gsl/gsl_math.h>

#include "results/extreme.h"
#include "base/format.h"
#include "picture.h"
#include "tables/print.h"
#include "sketch.h"
#include "results/turning.h"

#define STEPS 720
#define AREA_STEPS 100 /* of an area of the turning moment */

static void put_pair(FILE *out, double x, double y)
{
    char number[FORMAT_SIZE];

    fputs(format_general(x, 8, number), out);
    putc(' ', out);
    fputs(format_general(y, 8, number), out);
    putc('\n', out);
}

static void sample(analysis *a, fourlink_branch branch, int k, result *r)
{
    analysis_spread(a, k, STEPS, &r->row);
    analysis_at(a, branch, &r->row.crank, r);
}

/* The least and the greatest value of curves: of all, and of those away from dead positions. */
typedef struct extent {
    double low, high;
    double sound_low, sound_high;
    double mu; /* rad, the least transmission angle */
} extent;

static const extent nothing = {GSL_POSINF, GSL_NEGINF, GSL_POSINF, GSL_NEGINF, GSL_POSINF};

/* rad, transmission angles: below the first a dead position is near, where values say little but that
** they grow; above the second it is far.  Curves that are so many times higher near it go on beyond the
** picture. */
#define NEAR 0.2
#define SOUND 0.6
#define HIGHER 3

static void extend(extent *e, double value, double mu)
{
    e->low = GSL_MIN_DBL(e->low, value);
    e->high = GSL_MAX_DBL(e->high, value);
    e->mu = GSL_MIN_DBL(e->mu, mu);
    if (mu > SOUND) {
        e->sound_low = GSL_MIN_DBL(e->sound_low, value);
        e->sound_high = GSL_MAX_DBL(e->sound_high, value);
    }
}

/* 1 if the picture ends before the curves do. */
static int is_cut(const extent *e)
{
    return e->mu < NEAR && e->sound_high > e->sound_low &&
           e->high - e->low > HIGHER * (e->sound_high - e->sound_low);
}

/* Where a curve can be drawn. */
static int is_sound(const result *r)
{
    return r->status == FOURLINK_OK && !(r->state.mu < 1e-3);
}

/* The value of an angle goes on from the one before it, past half a turn. */
static double go_on(double value, double last, double turn)
{
    return turn > 0 && !gsl_isnan(last) ? value + turn * floor((last - value) / turn + 0.5) : value;
}

/* The sample behind the last gap of a revolution, and the value from which an angle goes on there, so that
** it is the same at both ends; -1 if there is none. */
static int behind_gap(analysis *a, fourlink_branch branch, const column *y, double turn,
                      double *last)
{
    result r;
    int k;

    sample(a, branch, 0, &r);
    if (!(turn > 0) || !analysis_is_periodic(a) || !is_sound(&r))
        return -1;
    *last = column_value(y, &r);
    for (k = STEPS; k >= 0; k--) {
        sample(a, branch, k, &r);
        if (!is_sound(&r))
            return k + 1;
        *last = go_on(column_value(y, &r), *last, turn);
    }
    return -1;
}

/* Two columns over the motion as $NAME_BRANCH; breaks where the links do not reach.  How many points. */
static int put_data(FILE *out, analysis *a, fourlink_branch branch, const char *name,
                    const column *x, const column *y, extent *e)
{
    double turn = column_quantity(y) == QUANTITY_ANGLE ? 2 * M_PI * y->scale : 0;
    double last = GSL_NAN, behind = GSL_NAN;
    int k, n = 0, from = behind_gap(a, branch, y, turn, &behind);
    result r;

    fprintf(out, "$%s_%s << EOD\n", name, branch_name(branch));
    for (k = 0; k <= STEPS; k++) {
        sample(a, branch, k, &r);
        if (!is_sound(&r)) {
            putc('\n', out);
            last = GSL_NAN; /* behind a gap an angle starts anew */
            continue;
        }
        last = go_on(column_value(y, &r), k == from ? behind : last, turn);
        extend(e, last, r.state.mu);
        put_pair(out, column_value(x, &r), last);
        n++;
    }
    fputs("EOD\n", out);
    return n;
}

static int find_column(const analysis *a, const char *name, column *c)
{
    return column_find(a->d, flk_text_of(name), c);
}

/* A step of the numbers on the axis of crank angles, for `width` pixels: in degrees, parts of a turn. */
static double step_of_angles(const deck_unit *u, double span, double width)
{
    static const double parts[] = {5, 10, 15, 30, 45, 60, 90, 180, 360, 720};
    double least = 6 * CANVAS_LETTER * span / width;
    size_t i;

    if (strcmp(u->name, "deg") == 0)
        for (i = 0; i < sizeof parts / sizeof parts[0]; i++)
            if (parts[i] >= least)
                return least < 2 ? sketch_round(least) : parts[i];
    return sketch_round(least);
}

static void put_angle_axis(const canvas *on, const analysis *a)
{
    double from = a->d->motion.from, to = analysis_end(a);
    double step = step_of_angles(&a->d->units[QUANTITY_ANGLE], fabs(to - from), on->box_width);
    char low[FORMAT_SIZE], high[FORMAT_SIZE], number[FORMAT_SIZE];

    fprintf(on->out, "set xrange [%s:%s]\nset xtics %s\n", format_general(from, 8, low),
            format_general(to, 8, high), format_general(step, 6, number));
}

/* With room for the numbers of the extremes.  gnuplot has its own opinion of a range without extent. */
static void put_range(const canvas *on, const extent *e)
{
    double low = is_cut(e) ? e->sound_low : e->low, high = is_cut(e) ? e->sound_high : e->high;
    double size = GSL_MAX_DBL(fabs(low), fabs(high)), room;
    double part = 1.8 * CANVAS_LINE / on->box_height;
    char number[FORMAT_SIZE], other[FORMAT_SIZE];

    if (low > high)
        return;
    room = (high - low) * part / (1 - 2 * part);
    if (high - low <= 1e-9 * size || size == 0)
        room = size > 0 ? size : 1;
    fprintf(on->out, "set yrange [%s:%s]\n", format_general(low - room, 8, number),
            format_general(high + room, 8, other));
    if (is_cut(e))
        fputs("set label 'beyond the frame near a dead position' at graph 0.5, graph 1 center "
              "front boxed offset 0,-0.8\n",
              on->out);
}

static void begin_panel(canvas *on, const analysis *a)
{
    fputs("unset label; unset arrow\n", on->out);
    canvas_panel(on, 3, 2 * CANVAS_LETTER);
    canvas_key(on);
    canvas_grid(on);
    put_angle_axis(on, a);
}

/* The marked extremes of a panel. */
typedef struct marks {
    double x[4], y[4]; /* fractions of the panel */
    int n;
} marks;

/* An extreme's value, above a maximum, below a minimum; not over one that stands there. */
static void put_extreme(FILE *out, const analysis *a, const extreme *found, int sign, double height,
                        marks *m)
{
    double from = a->d->motion.from;
    double x = (found->angle - from) / (analysis_end(a) - from), y = found->value / height;
    char angle[FORMAT_SIZE], value[FORMAT_SIZE], words[FORMAT_SIZE];
    int i;

    for (i = 0; i < m->n; i++)
        if (fabs(x - m->x[i]) < 0.15 && fabs(y - m->y[i]) < 0.1)
            return;
    m->x[m->n] = x;
    m->y[m->n++] = y;
    fputs("set label ", out);
    canvas_quote(out, format_general(found->value, 4, words));
    fprintf(out, " at %s,%s %s front boxed point pt 7 ps 0.6 lc rgb 'black' offset %d,%s\n",
            format_general(found->angle, 8, angle), format_general(found->value, 8, value),
            x < 0.1   ? "left"
            : x > 0.9 ? "right"
                      : "center",
            x < 0.1   ? 1
            : x > 0.9 ? -1
                      : 0,
            sign > 0 ? "1" : "-1");
}

/* The extremes of a column on a branch within the picture; what is rounding beside the other is 0. */
static void put_extremes(FILE *out, analysis *a, fourlink_branch branch, const column *c,
                         const extent *e, marks *m)
{
    extreme found[2];
    int there[2], i;

    for (i = 0; i < 2; i++)
        there[i] = extreme_find(a, c, branch, i ? -1 : 1, &found[i]) == EXTREME_FOUND;
    for (i = 0; i < 2; i++) {
        if (!there[i] ||
            (is_cut(e) && (found[i].value < e->sound_low || found[i].value > e->sound_high)))
            continue;
        if (there[1 - i] && fabs(found[i].value) < 1e-12 * fabs(found[1 - i].value))
            found[i].value = 0;
        put_extreme(out, a, &found[i], i ? -1 : 1,
                    is_cut(e) ? e->sound_high - e->sound_low : e->high - e->low, m);
    }
}

/* A column over the crank angle, of all branches, with its extremes. */
static int put_panel(canvas *on, analysis *a, const char *name)
{
    fourlink_branch branches[2];
    int n = print_branches_of(a->d, branches), i, drawn = 0, points[2];
    extent e = nothing;
    marks m;
    column x, y;

    begin_panel(on, a);
    if (!find_column(a, "theta2", &x) || !find_column(a, name, &y))
        return 0;
    m.n = 0;
    for (i = 0; i < n; i++)
        points[i] = put_data(on->out, a, branches[i], name, &x, &y, &e);
    for (i = 0; i < n; i++)
        if (points[i])
            put_extremes(on->out, a, branches[i], &y, &e, &m);
    canvas_titles(on, "", "theta2", x.unit, name, y.unit);
    put_range(on, &e);
    for (i = 0; i < n; i++)
        if (points[i]) {
            const char *branch = branch_name(branches[i]);

            fprintf(on->out, "%s $%s_%s using 1:2 with lines lt %d title '%s'",
                    drawn ? "," : "plot", name, branch, i + 1, branch);
            drawn = 1;
        }
    putc('\n', on->out);
    return drawn;
}

int plot_motion(canvas *on, analysis *a, const char **why)
{
    static const char *const four_bar[] = {"theta3", "theta4", "omega3",
                                           "omega4", "alpha3", "alpha4"};
    static const char *const slider_crank[] = {"theta3", "x", "omega3", "v", "alpha3", "a"};
    const char *const *names = a->d->design.kind == FOURLINK_FOUR_BAR ? four_bar : slider_crank;
    int i, drawn = 0;

    canvas_begin(on);
    fputs("set format '%g'\n", on->out);
    for (i = 0; i < 6; i++)
        drawn += put_panel(on, a, names[i]);
    canvas_end(on);
    *why = "the links reach at no angle of the motion";
    return drawn > 0;
}

/* Columns of one unit in one panel. */
static void put_columns(canvas *on, analysis *a, fourlink_branch branch, const char *const *names)
{
    FILE *out = on->out;
    int i, drawn = 0;
    extent e = nothing;
    column x, y;

    begin_panel(on, a);
    find_column(a, "theta2", &x);
    for (i = 0; names[i]; i++)
        if (find_column(a, names[i], &y)) {
            put_data(out, a, branch, names[i], &x, &y, &e);
            canvas_titles(on, branch_name(branch), "theta2", x.unit, names[1] ? "force" : names[i],
                          y.unit);
        }
    put_range(on, &e);
    for (i = 0; names[i]; i++)
        if (find_column(a, names[i], &y)) {
            fprintf(out, "%s $%s_%s using 1:2 with lines lt %d title ", drawn ? "," : "plot",
                    names[i], branch_name(branch), i + 1);
            canvas_quote(out, names[i]);
            drawn = 1;
        }
    putc('\n', out);
}

/* 1 if the links reach somewhere on the motion. */
static int reaches(analysis *a, fourlink_branch branch)
{
    result r;
    int k;

    for (k = 0; k <= STEPS; k++) {
        sample(a, branch, k, &r);
        if (r.status == FOURLINK_OK)
            return 1;
    }
    return 0;
}

int plot_forces(canvas *on, analysis *a, const char **why)
{
    static const char *const pins[] = {"F12", "F23", "F34", "F14", "N", NULL};
    static const char *const torque[] = {"Ts", NULL};
    fourlink_branch branches[2];
    int n = print_branches_of(a->d, branches), i, drawn = 0;

    canvas_begin(on);
    fputs("set format '%g'\n", on->out);
    for (i = 0; i < n; i++)
        if (reaches(a, branches[i])) {
            put_columns(on, a, branches[i], pins);
            put_columns(on, a, branches[i], torque);
            drawn++;
        }
    canvas_end(on);
    *why = "the links reach at no angle of the motion";
    return drawn > 0;
}

/* An angle of the turning moment's cycle as it is drawn: a clockwise crank goes from 0 to -cycle. */
static double cycle_angle(const deck *d, double theta2)
{
    if (d->motion.speed < 0)
        theta2 -= d->cycle;
    return flk_unit_from_si(theta2, d->units[QUANTITY_ANGLE].unit);
}

/* Where the turning moment is farthest from its mean in an area: angle and moment, as they are drawn. */
static void find_peak(analysis *a, fourlink_branch branch, const turning_area *area, double mean,
                      double *angle, double *moment)
{
    double farthest = -1;
    fourlink_crank crank;
    result r;
    int k;

    crank.omega2 = a->d->motion.speed;
    crank.alpha2 = 0;
    for (k = 0; k <= AREA_STEPS; k++) {
        crank.theta2 = area->from + (area->to - area->from) * k / AREA_STEPS;
        analysis_at(a, branch, &crank, &r);
        if (r.status == FOURLINK_OK && fabs(-r.forces.Ts - mean) > farthest) {
            farthest = fabs(-r.forces.Ts - mean);
            *angle = cycle_angle(a->d, crank.theta2);
            *moment = flk_unit_from_si(-r.forces.Ts, a->d->units[QUANTITY_TORQUE].unit);
        }
    }
}

/* The energies of the areas, each above or below its curve, if it does not run into the one before it. */
static void put_areas(const canvas *on, analysis *a, fourlink_branch branch, const turning *t)
{
    const deck *d = a->d;
    double pixel = flk_unit_from_si(d->cycle, d->units[QUANTITY_ANGLE].unit) / on->box_width;
    double free_from[2] = {GSL_NEGINF, GSL_NEGINF}, angle = 0, moment = 0, half, first;
    char number[FORMAT_SIZE], other[FORMAT_SIZE], words[200];
    int k, is_above;

    first = cycle_angle(d, 0);
    for (k = 0; k < t->n_areas; k++) {
        const turning_area *area = &t->area[k];

        if (fabs(area->energy) < 0.02 * t->energy_fluctuation)
            continue;
        find_peak(a, branch, area, t->mean_torque, &angle, &moment);
        is_above = (area->energy > 0) == (d->motion.speed > 0);
        format_general(flk_unit_from_si(area->energy, d->units[QUANTITY_ENERGY].unit), 5, number);
        flk_text_join(words, sizeof words, number, " ", d->units[QUANTITY_ENERGY].name,
                      (char *)NULL);
        half = pixel * canvas_width_of(words) / 2;
        angle = GSL_MAX_DBL(angle, first + half);
        angle = GSL_MIN_DBL(angle, first + pixel * on->box_width - half);
        if (angle - half < free_from[is_above])
            continue;
        free_from[is_above] = angle + half;
        fputs("set label ", on->out);
        canvas_quote(on->out, words);
        fprintf(on->out, " at %s,%s center front offset 0,%s\n", format_general(angle, 8, number),
                format_general(moment, 8, other), is_above ? "1" : "-1");
    }
}

static void put_moment(FILE *out, analysis *a, fourlink_branch branch)
{
    fourlink_crank crank;
    result r;
    int k;

    crank.omega2 = a->d->motion.speed;
    crank.alpha2 = 0;
    fprintf(out, "$turning_%s << EOD\n", branch_name(branch));
    for (k = 0; k <= STEPS; k++) {
        crank.theta2 = a->d->cycle * k / STEPS;
        analysis_at(a, branch, &crank, &r);
        if (r.status == FOURLINK_OK)
            put_pair(out, cycle_angle(a->d, crank.theta2),
                     flk_unit_from_si(-r.forces.Ts, a->d->units[QUANTITY_TORQUE].unit));
    }
    fputs("EOD\n", out);
}

/* Areas are filled, but for a text terminal.  A clockwise crank gives energy to the flywheel where the
** moment is below its mean. */
static void plot_moment(const canvas *on, const char *branch, int is_clockwise)
{
    fprintf(on->out, "plot $turning_%s using 1:2 ", branch);
    if (!on->is_text)
        fprintf(on->out,
                "with filledcurves above y=mean fs solid 0.35 lc rgb '#56B4E9' title 'above"
                "%s', \\\n"
                "     '' using 1:2 with filledcurves below y=mean fs pattern 4 lc rgb '#E69F00' "
                "title 'below%s', \\\n"
                "     '' using 1:2 ",
                is_clockwise ? ": given up" : "", is_clockwise ? ": taken up" : "");
    fprintf(on->out,
            "with lines lt %s title '-Ts', \\\n"
            "     mean with lines lt 2 title 'mean'\n",
            on->is_text ? "1" : "4 dt 1");
}

/* The turning moment -Ts over one cycle, its mean, and the areas between them with their energies. */
static void put_turning(canvas *on, analysis *a, fourlink_branch branch, const turning *t)
{
    const deck *d = a->d;
    const deck_unit *angle = &d->units[QUANTITY_ANGLE], *energy = &d->units[QUANTITY_ENERGY];
    const deck_unit *torque = &d->units[QUANTITY_TORQUE];
    double mean = flk_unit_from_si(t->mean_torque, torque->unit);
    double cycle = flk_unit_from_si(d->cycle, angle->unit);
    char number[FORMAT_SIZE], other[FORMAT_SIZE], words[200];

    fputs("unset label\n", on->out);
    canvas_panel(on, 3, 2 * CANVAS_LETTER);
    canvas_key(on);
    canvas_grid(on);
    flk_text_join(words, sizeof words, branch_name(branch), ": mean ",
                  format_general(mean, 5, number), " ", torque->name, ", fluctuation of energy ",
                  format_general(flk_unit_from_si(t->energy_fluctuation, energy->unit), 5, other),
                  " ", energy->name, (char *)NULL);
    canvas_titles(on, words, "theta2", angle->name, "turning moment -Ts", torque->name);
    fprintf(on->out, "set xrange [0:%s]\nset offsets graph 0, graph 0, graph 0.15, graph 0.15\n",
            format_general(d->motion.speed < 0 ? -cycle : cycle, 8, number));
    fprintf(on->out, "set xtics %s\nmean = %s\n",
            format_general(step_of_angles(angle, cycle, on->box_width), 6, number),
            format_general(mean, 17, other));
    put_areas(on, a, branch, t);
    put_moment(on->out, a, branch);
    plot_moment(on, branch_name(branch), d->motion.speed < 0);
}

int plot_turning(canvas *on, analysis *a, const char **why)
{
    fourlink_branch branches[2];
    int n = print_branches_of(a->d, branches), i, drawn = 0;
    turning t;

    canvas_begin(on);
    fputs("set format '%g'\n", on->out);
    for (i = 0; i < n; i++)
        if (turning_find(a, branches[i], &t)) {
            put_turning(on, a, branches[i], &t);
            drawn++;
        }
    canvas_end(on);
    *why = "the turning moment needs a crank that turns fully, at constant speed";
    return drawn > 0;
}

/* A pin force as a curve in the axes of one of its links, as bearing-load diagrams have it: what wears
** where.  Marks tell the crank angle. */
typedef struct bearing {
    const char *name, *along, *across; /* the columns of its components */
    const char *words;
} bearing;

#define MARKS 12
#define LETTERED 3 /* every third of them has its angle beside it */
#define MOST_LETTERED (2 * MARKS / LETTERED)

/* A drawing of equal scale on both axes, and what is lettered in it. */
typedef struct frame {
    double x_min, x_max, y_min, y_max;
    double scale; /* of a pixel */
    double x[MOST_LETTERED], y[MOST_LETTERED];
    int n;
} frame;

/* Room for the curves, and for 0, where there is no force. */
static void find_frame(analysis *a, const fourlink_branch *branches, int n, const column *x,
                       const column *y, frame *f)
{
    extent ex = nothing, ey = nothing;
    int i, k, cut;
    result r;

    for (i = 0; i < n; i++)
        for (k = 0; k <= STEPS; k++) {
            sample(a, branches[i], k, &r);
            if (r.status == FOURLINK_OK) {
                extend(&ex, column_value(x, &r), r.state.mu);
                extend(&ey, column_value(y, &r), r.state.mu);
            }
        }
    cut = is_cut(&ex) || is_cut(&ey);
    memset(f, 0, sizeof *f);
    f->x_min = GSL_MIN_DBL(0, cut ? ex.sound_low : ex.low);
    f->x_max = GSL_MAX_DBL(0, cut ? ex.sound_high : ex.high);
    f->y_min = GSL_MIN_DBL(0, cut ? ey.sound_low : ey.low);
    f->y_max = GSL_MAX_DBL(0, cut ? ey.sound_high : ey.high);
}

static void put_frame_axis(FILE *out, const char *axis, double low, double high, double length)
{
    char number[FORMAT_SIZE], other[FORMAT_SIZE];

    fprintf(out, "set %srange [%s:%s]\n", axis,
            format_general((low + high - length) / 2, 6, number),
            format_general((low + high + length) / 2, 6, other));
}

static void put_frame(const canvas *on, frame *f)
{
    double border = 6 * CANVAS_LETTER; /* for the angles */
    char number[FORMAT_SIZE];

    f->scale = GSL_MAX_DBL((f->x_max - f->x_min) / (on->box_width - 2 * border),
                           (f->y_max - f->y_min) / (on->box_height - 2 * border));
    if (f->scale == 0)
        f->scale = 1 / on->box_width;
    put_frame_axis(on->out, "x", f->x_min, f->x_max, f->scale * on->box_width);
    put_frame_axis(on->out, "y", f->y_min, f->y_max, f->scale * on->box_height);
    format_general(sketch_round(8 * CANVAS_LETTER * f->scale), 6, number);
    fprintf(on->out, "set tics %s\n", number);
}

/* A crank angle beside the curve, in its colour, unless another stands there. */
static void put_angle(const canvas *on, const deck *d, frame *f, double x, double y, double angle,
                      int line)
{
    int is_right = x > (f->x_min + f->x_max) / 2, i;
    char number[FORMAT_SIZE], other[FORMAT_SIZE], mark[PRINT_MARK];

    if (x < f->x_min || x > f->x_max || y < f->y_min || y > f->y_max)
        return;
    for (i = 0; i < f->n; i++)
        if (fabs(x - f->x[i]) < 5 * CANVAS_LETTER * f->scale &&
            fabs(y - f->y[i]) < CANVAS_LINE * f->scale)
            return;
    f->x[f->n] = x;
    f->y[f->n++] = y;
    fputs("set label ", on->out);
    canvas_quote(on->out, print_mark(d, angle, mark));
    fprintf(on->out, " at %s,%s %s front tc lt %d offset %d,%s\n", format_general(x, 8, number),
            format_general(y, 8, other), is_right ? "left" : "right", line, is_right ? 1 : -1,
            y > (f->y_min + f->y_max) / 2 ? "0.4" : "-0.4");
}

/* The crank angles along the curve, as $NAME_BRANCH_marks. */
static void put_marks(const canvas *on, analysis *a, fourlink_branch branch, const bearing *b,
                      const column *x, const column *y, frame *f)
{
    result r;
    int k;

    fprintf(on->out, "$%s_%s_marks << EOD\n", b->name, branch_name(branch));
    for (k = 0; k < MARKS; k++) {
        sample(a, branch, k * (STEPS / MARKS), &r);
        if (r.status == FOURLINK_OK)
            put_pair(on->out, column_value(x, &r), column_value(y, &r));
    }
    fputs("EOD\n", on->out);
    for (k = 0; k < MARKS; k += LETTERED) {
        sample(a, branch, k * (STEPS / MARKS), &r);
        if (r.status == FOURLINK_OK)
            put_angle(on, a->d, f, column_value(x, &r), column_value(y, &r), r.row.angle,
                      branch == FOURLINK_CROSSED && a->d->open ? 2 : 1);
    }
}

static int put_polar(canvas *on, analysis *a, const bearing *b)
{
    fourlink_branch branches[2];
    int n = print_branches_of(a->d, branches), i, drawn = 0, points[2];
    extent e = nothing;
    column x, y;
    frame f;

    fputs("unset label; unset arrow\n", on->out);
    canvas_panel(on, 3, 4 * CANVAS_LETTER);
    canvas_key(on);
    if (!find_column(a, b->along, &x) || !find_column(a, b->across, &y))
        return 0;
    canvas_titles(on, b->words, b->along, x.unit, b->across, y.unit);
    find_frame(a, branches, n, &x, &y, &f);
    put_frame(on, &f);
    for (i = 0; i < n; i++)
        if ((points[i] = put_data(on->out, a, branches[i], b->name, &x, &y, &e)) > 0)
            put_marks(on, a, branches[i], b, &x, &y, &f);
    for (i = 0; i < n; i++)
        if (points[i]) {
            const char *branch = branch_name(branches[i]);

            fprintf(on->out,
                    "%s $%s_%s using 1:2 with lines lt %d title '%s', $%s_%s_marks using 1:2 with "
                    "points pt 7 ps 0.5 lc rgb 'black'",
                    drawn ? "," : "plot", b->name, branch, i + 1, branch, b->name, branch);
            drawn = 1;
        }
    putc('\n', on->out);
    return drawn;
}

int plot_polar(canvas *on, analysis *a, const char **why)
{
#define LINK_AXES(name) name, name "_along", name "_across"
    static const bearing four_bar[] = {
        {LINK_AXES("F12"), "F12, ground on crank, in the crank's axes"},
        {LINK_AXES("F32"), "F32, coupler on crank, in the crank's axes"},
        {LINK_AXES("F23"), "F23, crank on coupler, in the coupler's axes"},
        {LINK_AXES("F43"), "F43, rocker on coupler, in the coupler's axes"},
        {LINK_AXES("F34"), "F34, coupler on rocker, in the rocker's axes"},
        {LINK_AXES("F14"), "F14, ground on rocker, in the rocker's axes"}};
    static const bearing slider_crank[] = {
        {LINK_AXES("F12"), "F12, ground on crank, in the crank's axes"},
        {LINK_AXES("F32"), "F32, rod on crank, in the crank's axes"},
        {LINK_AXES("F23"), "F23, crank on rod, in the rod's axes"},
        {LINK_AXES("F43"), "F43, piston on rod, in the rod's axes"},
        {"F34", "F34x", "F34y", "F34, rod on piston, in the piston's axes"}};
    int is_four_bar = a->d->design.kind == FOURLINK_FOUR_BAR, i, drawn = 0;

    canvas_begin(on);
    canvas_grid(on);
    fprintf(on->out,
            "set format '%%g'; set size ratio -1\n"
            "set zeroaxis lt %d lw 1 lc rgb 'black'\n",
            on->is_text ? -1 : 1);
    for (i = 0; i < (is_four_bar ? 6 : 5); i++)
        drawn += put_polar(on, a, is_four_bar ? &four_bar[i] : &slider_crank[i]);
    canvas_end(on);
    *why = "the links reach at no angle of the motion";
    return drawn > 0;
}
