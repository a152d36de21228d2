/* SPDX-License-Identifier: GPL-3.0-or-later
**
** turning.c - the turning moment over a cycle, its mean, and the areas between them.
*/
#include <math.h>

#include <gsl/gsl_math.h>

#include "graph.h"

#define AREA_STEPS 100 /* of an area */

/* N m, -Ts at an angle of the cycle; NaN if the linkage cannot be assembled there. */
static double moment_at(const picture *p, fourlink_branch branch, double theta2)
{
    fourlink_forces forces;
    fourlink_state state;
    fourlink_crank crank;

    crank.theta2 = theta2;
    crank.omega2 = p->problem.motion.speed;
    crank.alpha2 = 0;
    if (fourlink_deck_loads(p->deck, branch, theta2, p->loads, NULL) != FOURLINK_OK ||
        fourlink_analyse(p->mechanism, branch, &crank, p->loads, p->problem.n_loads, &state,
                         &forces) != FOURLINK_OK)
        return GSL_NAN;
    return -forces.Ts;
}

/* An angle of the cycle as drawn: a clockwise crank goes from 0 to -cycle. */
static double cycle_angle(const picture *p, double theta2)
{
    if (p->problem.motion.speed < 0)
        theta2 -= p->problem.cycle;
    return picture_value(p, QUANTITY_ANGLE, theta2);
}

/* Where the turning moment is farthest from its mean in an area, as drawn. */
static fourlink_vector find_peak(const picture *p, fourlink_branch branch,
                                 const fourlink_area *area, double mean)
{
    fourlink_vector peak = {0, 0};
    double farthest = -1;
    int k;

    for (k = 0; k <= AREA_STEPS; k++) {
        double theta2 = area->from + (area->to - area->from) * k / AREA_STEPS;
        double T = moment_at(p, branch, theta2);

        if (fabs(T - mean) > farthest) {
            farthest = fabs(T - mean);
            peak.x = cycle_angle(p, theta2);
            peak.y = picture_value(p, QUANTITY_TORQUE, T);
        }
    }
    return peak;
}

/* Put the energies of the areas, each above or below its curve, unless it would overlap the one before it. */
static void put_areas(const picture *p, fourlink_branch branch, const fourlink_turning *t)
{
    double pixel = picture_value(p, QUANTITY_ANGLE, p->problem.cycle) / p->on.box_width;
    double free_from[2] = {GSL_NEGINF, GSL_NEGINF}, first = cycle_angle(p, 0), half;
    char words[PICTURE_WORDS];
    fourlink_vector peak;
    int k, is_above;

    for (k = 0; k < t->n_areas; k++) {
        const fourlink_area *area = &t->area[k];

        if (fabs(area->energy) < 0.02 * t->energy_fluctuation)
            continue;
        peak = find_peak(p, branch, area, t->mean_torque);
        is_above = (area->energy > 0) == (p->problem.motion.speed > 0);
        half =
            pixel * canvas_width_of(picture_words(p, "", area->energy, QUANTITY_ENERGY, words)) / 2;
        peak.x = GSL_MAX_DBL(peak.x, first + half);
        peak.x = GSL_MIN_DBL(peak.x, first + pixel * p->on.box_width - half);
        if (peak.x - half < free_from[is_above])
            continue;
        free_from[is_above] = peak.x + half;
        canvas_print(&p->on, "set label %q at %.8g,%.8g center front offset 0,%d\n", words, peak.x,
                     peak.y, is_above ? 1 : -1);
    }
}

static void put_moment(const picture *p, fourlink_branch branch)
{
    int k;

    fprintf(p->on.out, "$turning_%s << EOD\n", fourlink_branch_text(branch));
    for (k = 0; k <= GRAPH_STEPS; k++) {
        double theta2 = p->problem.cycle * k / GRAPH_STEPS, T = moment_at(p, branch, theta2);

        if (!gsl_isnan(T))
            canvas_print(&p->on, "%.8g %.8g\n", cycle_angle(p, theta2),
                         picture_value(p, QUANTITY_TORQUE, T));
    }
    fputs("EOD\n", p->on.out);
}

/* Fill the areas, except on a text terminal.  A clockwise crank gives energy to the flywheel while the moment
** is below its mean. */
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
                is_clockwise ? ": energy given up" : "", is_clockwise ? ": energy taken up" : "");
    fprintf(on->out,
            "with lines lt %s title '-Ts', \\\n"
            "     mean with lines lt 2 title 'mean'\n",
            on->is_text ? "1" : "4 dt 1");
}

const char *picture_turning(picture *p, fourlink_branch branch)
{
    const char *name = fourlink_branch_text(branch), *torque = p->units[QUANTITY_TORQUE].name;
    double mean, cycle = picture_value(p, QUANTITY_ANGLE, p->problem.cycle);
    int is_clockwise = p->problem.motion.speed < 0;
    char words[PICTURE_WORDS], other[PICTURE_WORDS], title[200];
    fourlink_turning t;

    if (fourlink_results_turning(p->results, branch, &t) != FOURLINK_OK)
        return "the turning moment needs a crank that turns fully, at constant speed";
    mean = picture_value(p, QUANTITY_TORQUE, t.mean_torque);
    fputs("unset label\n", p->on.out);
    canvas_panel(&p->on, 3, 2 * CANVAS_LETTER);
    canvas_key(&p->on);
    canvas_grid(&p->on);
    picture_words(p, "mean", t.mean_torque, QUANTITY_TORQUE, words);
    picture_words(p, "fluctuation of energy", t.energy_fluctuation, QUANTITY_ENERGY, other);
    flk_text_join(title, sizeof title, name, ": ", words, ", ", other, (char *)NULL);
    canvas_titles(&p->on, title, "theta2", p->units[QUANTITY_ANGLE].name, "turning moment -Ts",
                  torque);
    canvas_print(&p->on,
                 "set xrange [0:%.8g]\nset offsets graph 0, graph 0, graph 0.15, graph 0.15\n"
                 "set xtics %.6g\nmean = %.17g\n",
                 is_clockwise ? -cycle : cycle, graph_angle_step(p, cycle), mean);
    put_areas(p, branch, &t);
    put_moment(p, branch);
    plot_moment(&p->on, name, is_clockwise);
    return NULL;
}
