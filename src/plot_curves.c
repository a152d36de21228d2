/* SPDX-License-Identifier: GPL-3.0-or-later
**
** plot_curves.c - curves over the crank angle: motion, forces, turning moment; and pin forces in their
** links' axes.
*/
#include <math.h>
#include <string.h>

#include <gsl/gsl_math.h>

#include "extreme.h"
#include "format.h"
#include "plot.h"
#include "print.h"
#include "sketch.h"
#include "turning.h"

#define STEPS 720

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

/* The least and the greatest value of curves. */
typedef struct extent {
    double low, high;
} extent;

static const extent nothing = {GSL_POSINF, GSL_NEGINF};

/* Two columns over the motion as $NAME_BRANCH; breaks where the links do not reach.  Angles go on past
** half a turn.  How many points. */
static int put_data(FILE *out, analysis *a, fourlink_branch branch, const char *name,
                    const column *x, const column *y, extent *e)
{
    double turn = 2 * M_PI * y->scale, last = GSL_NAN, value;
    int k, n = 0;
    result r;

    fprintf(out, "$%s_%s << EOD\n", name, branch_name(branch));
    for (k = 0; k <= STEPS; k++) {
        sample(a, branch, k, &r);
        if (r.status != FOURLINK_OK || r.state.mu < 1e-3) {
            putc('\n', out);
            last = GSL_NAN; /* behind a gap an angle starts anew */
            continue;
        }
        value = column_value(y, &r);
        if (column_quantity(y) == QUANTITY_ANGLE && !gsl_isnan(last))
            value += turn * floor((last - value) / turn + 0.5);
        last = value;
        e->low = value < e->low ? value : e->low;
        e->high = value > e->high ? value : e->high;
        put_pair(out, column_value(x, &r), value);
        n++;
    }
    fputs("EOD\n", out);
    return n;
}

/* The extremes of a column on a branch, as $NAME_BRANCH_extremes; what is rounding beside the other is 0. */
static int put_extremes(FILE *out, analysis *a, fourlink_branch branch, const column *c)
{
    extreme found[2];
    int n = 0, i;

    n += extreme_find(a, c, branch, 1, &found[n]) == EXTREME_FOUND;
    n += extreme_find(a, c, branch, -1, &found[n]) == EXTREME_FOUND;
    fprintf(out, "$%s_%s_extremes << EOD\n", c->name, branch_name(branch));
    for (i = 0; i < n; i++) {
        double other = fabs(found[n - 1 - i].value);

        put_pair(out, found[i].angle, fabs(found[i].value) < 1e-12 * other ? 0 : found[i].value);
    }
    fputs("EOD\n", out);
    return n;
}

static int find_column(const analysis *a, const char *name, column *c)
{
    return column_find(a->d, flk_text_of(name), c);
}

static void put_axis(FILE *out, const char *axis, const char *name, const char *unit_name)
{
    char words[200];

    fprintf(out, "set %slabel ", axis);
    sketch_quote(out, print_join(words, sizeof words, name, " (", unit_name, ")", (char *)NULL));
    putc('\n', out);
}

static void put_angle_axis(FILE *out, const analysis *a)
{
    const deck_unit *u = &a->d->units[QUANTITY_ANGLE];
    double from = a->d->motion.from, to = analysis_end(a);
    char low[FORMAT_SIZE], high[FORMAT_SIZE];

    put_axis(out, "x", "theta2", u->name);
    fprintf(out, "set xrange [%s:%s]\n", format_general(from, 8, low), format_general(to, 8, high));
    if (strcmp(u->name, "deg") == 0 && fabs(to - from) >= 180 && fabs(to - from) <= 720)
        fputs(fabs(to - from) > 360 ? "set xtics 90\n" : "set xtics 30\n", out);
}

/* gnuplot has its own opinion of a range without extent. */
static void put_range(FILE *out, const extent *e)
{
    double size = fabs(e->low) > fabs(e->high) ? fabs(e->low) : fabs(e->high);
    char low[FORMAT_SIZE], high[FORMAT_SIZE];

    if (e->high - e->low > 1e-9 * size || e->high < e->low)
        fputs("set yrange [*:*]\n", out);
    else
        fprintf(out, "set yrange [%s:%s]\n", format_general(e->low - (size > 0 ? size : 1), 8, low),
                format_general(e->high + (size > 0 ? size : 1), 8, high));
}

static void begin_panel(FILE *out, const analysis *a)
{
    fputs("unset label; unset arrow; unset title\n"
          "set grid lt 1 lw 0.5 lc rgb '#DDDDDD'\n"
          "set offsets graph 0, graph 0, graph 0.08, graph 0.08\n",
          out);
    put_angle_axis(out, a);
}

/* A column over the crank angle, of all branches, with its extremes. */
static int put_panel(FILE *out, analysis *a, const char *name)
{
    fourlink_branch branches[2];
    int n = print_branches_of(a->d, branches), i, drawn = 0, extremes[2] = {0, 0}, points[2];
    extent e = nothing;
    column x, y;

    if (!find_column(a, "theta2", &x) || !find_column(a, name, &y))
        return 0;
    begin_panel(out, a);
    for (i = 0; i < n; i++) {
        points[i] = put_data(out, a, branches[i], name, &x, &y, &e);
        if (points[i])
            extremes[i] = put_extremes(out, a, branches[i], &y);
    }
    put_axis(out, "y", name, y.unit);
    put_range(out, &e);
    for (i = 0; i < n; i++)
        if (points[i]) {
            const char *branch = branch_name(branches[i]);

            fprintf(out, "%s $%s_%s using 1:2 with lines lt %d title '%s'", drawn ? "," : "plot",
                    name, branch, i + 1, branch);
            if (extremes[i])
                fprintf(out,
                        ", $%s_%s_extremes using 1:2 with points pt 7 ps 0.6 lc rgb 'black', "
                        "'' using 1:2:(sprintf('%%.4g', $2)) with labels font ',9' offset 0,0.6",
                        name, branch);
            drawn = 1;
        }
    fputs(drawn ? "\n" : "set multiplot next\n", out);
    return drawn;
}

static int has_range(const analysis *a, const char **why)
{
    *why = "curves need a range of crank angles; the deck has one instant";
    return a->range.n_rows > 1;
}

int plot_motion(FILE *out, analysis *a, const char **why)
{
    static const char *const four_bar[] = {"theta3", "theta4", "omega3",
                                           "omega4", "alpha3", "alpha4"};
    static const char *const slider_crank[] = {"theta3", "x", "omega3", "v", "alpha3", "a"};
    const char *const *names = a->d->design.kind == FOURLINK_FOUR_BAR ? four_bar : slider_crank;
    int i, drawn = 0;

    if (!has_range(a, why))
        return 0;
    plot_panels(out, 3, 2);
    fputs("set key above\n", out);
    for (i = 0; i < 6; i++)
        drawn += put_panel(out, a, names[i]);
    fputs("unset multiplot\n", out);
    *why = "the links reach at no angle of the motion";
    return drawn > 0;
}

/* Columns of one unit in one panel. */
static void put_columns(FILE *out, analysis *a, fourlink_branch branch, const char *const *names)
{
    int i, drawn = 0;
    extent e = nothing;
    column x, y;

    find_column(a, "theta2", &x);
    begin_panel(out, a);
    fputs("set title ", out);
    sketch_quote(out, branch_name(branch));
    putc('\n', out);
    for (i = 0; names[i]; i++)
        if (find_column(a, names[i], &y)) {
            put_data(out, a, branch, names[i], &x, &y, &e);
            put_axis(out, "y", names[1] ? "force" : names[i], y.unit);
        }
    put_range(out, &e);
    for (i = 0; names[i]; i++)
        if (find_column(a, names[i], &y)) {
            fprintf(out, "%s $%s_%s using 1:2 with lines lt %d title ", drawn ? "," : "plot",
                    names[i], branch_name(branch), i + 1);
            sketch_quote(out, names[i]);
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

int plot_forces(FILE *out, analysis *a, const char **why)
{
    static const char *const pins[] = {"F12", "F23", "F34", "F14", "N", NULL};
    static const char *const torque[] = {"Ts", NULL};
    fourlink_branch branches[2];
    int n = print_branches_of(a->d, branches), i, drawn = 0;

    if (!has_range(a, why))
        return 0;
    plot_panels(out, n, 2);
    fputs("set key above\n", out);
    for (i = 0; i < n; i++)
        if (reaches(a, branches[i])) {
            put_columns(out, a, branches[i], pins);
            put_columns(out, a, branches[i], torque);
            drawn++;
        }
    fputs("unset multiplot\n", out);
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

/* The turning moment -Ts over one cycle, its mean, and the areas between them with their energies. */
static void put_turning(FILE *out, analysis *a, fourlink_branch branch, const turning *t)
{
    const deck *d = a->d;
    const deck_unit *angle = &d->units[QUANTITY_ANGLE], *energy = &d->units[QUANTITY_ENERGY];
    double mean = flk_unit_from_si(t->mean_torque, d->units[QUANTITY_TORQUE].unit), cycle;
    char number[FORMAT_SIZE], other[FORMAT_SIZE], words[200];
    int k;

    cycle = flk_unit_from_si(d->cycle, angle->unit);
    fputs("unset label; set grid lt 1 lw 0.5 lc rgb '#DDDDDD'\n", out);
    fputs("set title ", out);
    sketch_quote(
        out,
        print_join(words, sizeof words, branch_name(branch), ": mean ",
                   format_general(mean, 5, number), " ", d->units[QUANTITY_TORQUE].name,
                   ", fluctuation of energy ",
                   format_general(flk_unit_from_si(t->energy_fluctuation, energy->unit), 5, other),
                   " ", energy->name, (char *)NULL));
    putc('\n', out);
    put_axis(out, "x", "theta2", angle->name);
    put_axis(out, "y", "turning moment -Ts", d->units[QUANTITY_TORQUE].name);
    fprintf(out, "set xrange [0:%s]\nset offsets graph 0, graph 0, graph 0.1, graph 0.1\n",
            format_general(d->motion.speed < 0 ? -cycle : cycle, 8, number));
    if (strcmp(angle->name, "deg") == 0)
        fputs(cycle > 360 ? "set xtics 60\n" : "set xtics 30\n", out);
    fprintf(out, "mean = %s\n", format_general(mean, 17, number));
    for (k = 0; k < t->n_areas; k++) {
        const turning_area *area = &t->area[k];

        if (fabs(area->energy) < 0.02 * t->energy_fluctuation)
            continue;
        fputs("set label ", out);
        sketch_quote(
            out, print_join(words, sizeof words,
                            format_general(flk_unit_from_si(area->energy, energy->unit), 4, number),
                            " ", energy->name, (char *)NULL));
        fprintf(out, " at %s, mean center front offset 0,%s\n",
                format_general(cycle_angle(d, (area->from + area->to) / 2), 8, number),
                (area->energy > 0) == (d->motion.speed > 0) ? "1" : "-1");
    }
    fprintf(out, "$turning_%s << EOD\n", branch_name(branch));
    for (k = 0; k <= STEPS; k++) {
        fourlink_crank crank;
        result r;

        crank.theta2 = d->cycle * k / STEPS;
        crank.omega2 = d->motion.speed;
        crank.alpha2 = 0;
        analysis_at(a, branch, &crank, &r);
        if (r.status == FOURLINK_OK)
            put_pair(out, cycle_angle(d, crank.theta2),
                     flk_unit_from_si(-r.forces.Ts, d->units[QUANTITY_TORQUE].unit));
    }
    fprintf(out,
            "EOD\nplot $turning_%s using 1:2 with filledcurves above y=mean fs solid 0.35 lc rgb "
            "'#56B4E9' title 'above the mean', \\\n"
            "     '' using 1:2 with filledcurves below y=mean fs pattern 4 lc rgb '#E69F00' title "
            "'below', \\\n"
            "     '' using 1:2 with lines lt 4 dt 1 title '-Ts', \\\n"
            "     mean with lines lt 2 title 'mean'\n",
            branch_name(branch));
}

int plot_turning(FILE *out, analysis *a, const char **why)
{
    fourlink_branch branches[2];
    int n = print_branches_of(a->d, branches), i, drawn = 0;
    turning t;

    plot_panels(out, n, 1);
    fputs("set key above\n", out);
    for (i = 0; i < n; i++)
        if (turning_find(a, branches[i], &t)) {
            put_turning(out, a, branches[i], &t);
            drawn++;
        }
    fputs("unset multiplot\n", out);
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

/* The crank angles along the curve, as $NAME_BRANCH_marks: each `step` of MARKS. */
static void put_marks(FILE *out, analysis *a, fourlink_branch branch, const char *name, int step,
                      const column *x, const column *y)
{
    char number[FORMAT_SIZE];
    result r;
    int k;

    fprintf(out, "$%s_%s_marks%d << EOD\n", name, branch_name(branch), step);
    for (k = 0; k < MARKS; k += step) {
        sample(a, branch, k * (STEPS / MARKS), &r);
        if (r.status != FOURLINK_OK)
            continue;
        fputs(format_general(column_value(x, &r), 8, number), out);
        putc(' ', out);
        fputs(format_general(column_value(y, &r), 8, number), out);
        putc(' ', out);
        fputs(format_general(r.row.angle, 4, number), out);
        putc('\n', out);
    }
    fputs("EOD\n", out);
}

/* Axes of equal range around 0, where there is no force; positions near dead ones do not count. */
static void put_square(FILE *out, analysis *a, const fourlink_branch *branches, int n,
                       const column *x, const column *y)
{
    double largest = 0;
    char number[FORMAT_SIZE];
    result r;
    int i, k;

    for (i = 0; i < n; i++)
        for (k = 0; k <= STEPS; k++) {
            sample(a, branches[i], k, &r);
            if (r.status == FOURLINK_OK && r.state.mu > 0.1) {
                double size = gsl_hypot(column_value(x, &r), column_value(y, &r));

                largest = size > largest ? size : largest;
            }
        }
    largest = largest > 0 ? 1.15 * largest : 1;
    format_general(largest, 6, number);
    fprintf(out, "set xrange [-%s:%s]; set yrange [-%s:%s]\n", number, number, number, number);
    format_general(sketch_round(largest / 1.5), 6, number);
    fprintf(out, "set xtics %s; set ytics %s\n", number, number);
}

static int put_polar(FILE *out, analysis *a, const bearing *b)
{
    fourlink_branch branches[2];
    int n = print_branches_of(a->d, branches), i, drawn = 0, points[2];
    extent e = nothing;
    column x, y;

    if (!find_column(a, b->along, &x) || !find_column(a, b->across, &y))
        return 0;
    fputs("unset label; unset arrow\nset grid lt 1 lw 0.5 lc rgb '#DDDDDD'\nset size ratio -1\n"
          "set zeroaxis lt 1 lw 1 lc rgb 'black'\n",
          out);
    fputs("set title ", out);
    sketch_quote(out, b->words);
    putc('\n', out);
    put_axis(out, "x", b->along, x.unit);
    put_axis(out, "y", b->across, y.unit);
    put_square(out, a, branches, n, &x, &y);
    for (i = 0; i < n; i++)
        if ((points[i] = put_data(out, a, branches[i], b->name, &x, &y, &e)) > 0) {
            put_marks(out, a, branches[i], b->name, 1, &x, &y);
            put_marks(out, a, branches[i], b->name, LETTERED, &x, &y);
        }
    for (i = 0; i < n; i++)
        if (points[i]) {
            const char *branch = branch_name(branches[i]);

            fprintf(out,
                    "%s $%s_%s using 1:2 with lines lt %d title '%s', $%s_%s_marks1 using 1:2 with "
                    "points pt 7 ps 0.5 lc rgb 'black'",
                    drawn ? "," : "plot", b->name, branch, i + 1, branch, b->name, branch);
            if (!drawn)
                fprintf(out, ", $%s_%s_marks%d using 1:2:3 with labels font ',9' offset 0,0.6",
                        b->name, branch, LETTERED);
            drawn = 1;
        }
    fputs(drawn ? "\n" : "set multiplot next\n", out);
    return drawn;
}

int plot_polar(FILE *out, analysis *a, const char **why)
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

    if (!has_range(a, why))
        return 0;
    fputs("set key above\n", out);
    plot_panels(out, 2, 3);
    for (i = 0; i < (is_four_bar ? 6 : 5); i++)
        drawn += put_polar(out, a, is_four_bar ? &four_bar[i] : &slider_crank[i]);
    fputs("unset multiplot\n", out);
    *why = "the links reach at no angle of the motion";
    return drawn > 0;
}
