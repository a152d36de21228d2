/* SPDX-License-Identifier: GPL-3.0-or-later
**
** synthesis.c - how the linkage of a report was found: the equations with their numbers, the lengths that
** follow, the wanted positions, and the checks.
*/
#include <math.h>
#include <string.h>

#include <gsl/gsl_math.h>

#include "base/cycle.h"
#include "base/text.h"
#include "mathml.h"
#include "report.h"
#include "view/notation.h"

#define MOST_EQUATIONS 10
#define DIGITS 6
#define DEGREES(angle) ((angle) * (180 / M_PI))
#define THETA "\316\270"
#define THETA2 THETA "\342\202\202"
#define THETA3 THETA "\342\202\203"
#define THETA4 THETA "\342\202\204"
#define MU "\316\274"
#define DEG ", \302\260"

static int is_slider_crank(const fourlink_solution *s)
{
    return s->design.kind == FOURLINK_SLIDER_CRANK;
}

static void put_words(report *r, const char *words)
{
    page_print(&r->page, "<p>%s</p>\n", words);
}

/* The four lengths by their letters, those of a slider-crank too. */
static void set_lengths(const fourlink_solution *s, math *m)
{
    int slides = is_slider_crank(s);

    math_set(m, "d", s->design.link[FOURLINK_GROUND].length);
    math_set(m, slides ? "r" : "a", s->a);
    math_set(m, slides ? "l" : "b", s->design.link[FOURLINK_COUPLER].length);
    math_set(m, slides ? "e" : "c", slides ? s->design.offset : s->c);
}

/* ------------------------------------------------------------------------------------ functions */

static void put_function(report *r, math *m)
{
    const fourlink_solution *s = r->request->found;
    int slides = is_slider_crank(s), i;
    const char *equation = slides
                               ? "S1 * X * cos theta2 + S2 * sin theta2 - S3 = X ^2"
                               : "K1 * cos theta4 - K2 * cos theta2 + K3 = cos ( theta2 - theta4 )";
    static const char *const names[2][3] = {{"K1", "K2", "K3"}, {"S1", "S2", "S3"}};

    put_words(r, slides ? "The coupler's length is the same in all positions:"
                        : "Freudenstein's equation, from the constant length of the coupler:");
    math_show(m, equation);
    put_words(r, s->n_positions > 3 ? "At the points:" : "At the three points:");
    for (i = 0; i < s->n_positions && i < MOST_EQUATIONS; i++) {
        const fourlink_precision *p = &s->position[i];

        math_set(m, "theta2", flk_cycle_place(p->theta2 - s->crank_turn, 0, 2 * M_PI));
        math_set(m, "theta4", flk_cycle_beside(p->output - s->rocker_turn, 2 * M_PI));
        math_set(m, "X", p->output);
        math_show_numbers(m, equation);
    }
    if (s->n_positions > MOST_EQUATIONS)
        put_words(r, "and so on.");
    put_words(r, s->n_positions > 3 ? "They are linear; the constants with the least errors:"
                                    : "They are linear, with the solution:");
    page_print(&r->page, "<ul class=\"given\">\n");
    for (i = 0; i < 3; i++)
        math_given(m, names[slides][i], s->K[i]);
    page_print(&r->page, "</ul>\n");
    if (slides) {
        math_let(m, "r", "{ S1 | 2 }", s->a);
        math_let(m, "e", "{ S2 | S1 }", s->design.offset);
        math_let(m, "l", "[ r ^2 + e ^2 - S3 ]", s->design.link[FOURLINK_COUPLER].length);
    } else {
        math_let(m, "a", "{ d | K1 }", s->a);
        math_let(m, "c", "{ d | K2 }", s->c);
        math_let(m, "b", "[ a ^2 + c ^2 + d ^2 - 2 * a * c * K3 ]",
                 s->design.link[FOURLINK_COUPLER].length);
    }
    if (s->a < 0)
        put_words(
            r,
            "The crank's length is negative: the crank of the linkage is turned by 180\302\260.");
    if (s->c < 0)
        put_words(r, "The rocker's length is negative: the rocker is turned by 180\302\260.");
}

/* ----------------------------------------------------------------------------- guided couplers */

static void set_point(math *m, const char *x, const char *y, fourlink_vector at)
{
    math_set(m, x, at.x);
    math_set(m, y, at.y);
}

/* A point at the distance `length` from another in a direction of the linkage's frame, in the axes of the
** task. */
static fourlink_vector beside(const fourlink_solution *s, fourlink_vector from, double length,
                              double theta)
{
    from.x += length * cos(theta + s->direction);
    from.y += length * sin(theta + s->direction);
    return from;
}

static void put_guided(report *r, math *m)
{
    const fourlink_solution *s = r->request->found;
    const fourlink_link *link = s->design.link;
    int slides = is_slider_crank(s), i;
    fourlink_vector A = s->origin, D = beside(s, A, link[FOURLINK_GROUND].length, 0), B = A, C = A;

    put_words(
        r, slides ? "In the axes of the task, A is the centre of a circle through the places of B:"
                  : "In the axes of the task, each fixed pivot is the centre of a circle through "
                    "the three places of its moving pivot:");
    for (i = 0; i < s->n_positions; i++) {
        const fourlink_precision *p = &s->position[i];

        B = beside(s, A, link[FOURLINK_CRANK].length, p->theta2);
        C = beside(s, B, link[FOURLINK_COUPLER].length, p->theta3);
        page_print(&r->page, "<p>Position %d:</p>\n", i + 1);
        set_point(m, "xA", "yA", A);
        set_point(m, "xB", "yB", B);
        set_point(m, "xC", "yC", C);
        set_point(m, "xD", "yD", D);
        math_let(m, slides ? "r" : "a", "[ ( xB - xA )^2 + ( yB - yA )^2 ]",
                 gsl_hypot(B.x - A.x, B.y - A.y));
        if (!slides)
            math_let(m, "c", "[ ( xC - xD )^2 + ( yC - yD )^2 ]", gsl_hypot(C.x - D.x, C.y - D.y));
    }
    math_let(m, slides ? "l" : "b", "[ ( xC - xB )^2 + ( yC - yB )^2 ]",
             gsl_hypot(C.x - B.x, C.y - B.y));
    if (!slides) {
        math_let(m, "d", "[ ( xD - xA )^2 + ( yD - yA )^2 ]", gsl_hypot(D.x - A.x, D.y - A.y));
        return;
    }
    math_set(m, "gamma", s->direction);
    put_words(r,
              "The places of C are on a line in the direction \316\263, at the distance e from A:");
    math_let(m, "e", "( yC - yA ) * cos gamma - ( xC - xA ) * sin gamma", s->design.offset);
}

/* A length, in the deck's unit. */
static double shown_length(const report *r, double length)
{
    return view_value(&r->v, QUANTITY_LENGTH, length);
}

static const char *unit_of_length(const report *r)
{
    return r->v.units[QUANTITY_LENGTH].name;
}

/* An error in degrees or the deck's length; 0 if it is rounding. */
static double shown_error(const report *r, double error, int is_angle)
{
    return is_angle ? format_settled(DEGREES(error), 100)
                    : shown_length(r, format_settled(error, 100));
}

/* -------------------------------------------------------------------------------- many positions */

static void put_many(report *r, math *m)
{
    const fourlink_solution *s = r->request->found;
    const fourlink_precision *first = &s->position[0];
    double theta3 = first->theta3 + first->residual, a = s->design.link[FOURLINK_CRANK].length;
    const char *length_unit = unit_of_length(r);
    fourlink_vector p = s->point;
    int slides = is_slider_crank(s);

    page_print(
        &r->page,
        "<p>The linkage with the least sum of squared distances of the coupler point from the "
        "%d wanted positions, of the descents from %d starts. A better one may exist.</p>\n",
        s->n_positions, (int)s->starts);
    page_print(&r->page,
               "<ul>\n<li>Root mean square distance: %.6g%U</li>\n<li>Largest distance: %.6g%U"
               "</li>\n<li>Sum: %.6g%U</li>\n",
               shown_error(r, s->rms, 0), length_unit, shown_error(r, s->largest, 0), length_unit,
               math_units_value(&m->units, s->sum, MATH_AREA), m->units.of[MATH_AREA].name);
    if (s->max_error != 0)
        page_print(&r->page, "<li>Largest error of the coupler's angle: %.6g\302\260</li>\n",
                   shown_error(r, s->max_error, 1));
    page_print(&r->page, "</ul>\n");
    put_words(r, "The coupler point in the first position, in the frame of the linkage:");
    math_set(m, "theta2", first->theta2);
    math_set(m, "theta3", theta3);
    set_point(m, "xQ", "yQ", p);
    math_let(m, "xP",
             slides ? "r * cos theta2 + xQ * cos theta3 - yQ * sin theta3"
                    : "a * cos theta2 + xQ * cos theta3 - yQ * sin theta3",
             a * cos(first->theta2) + p.x * cos(theta3) - p.y * sin(theta3));
    math_let(m, "yP",
             slides ? "r * sin theta2 + xQ * sin theta3 + yQ * cos theta3"
                    : "a * sin theta2 + xQ * sin theta3 + yQ * cos theta3",
             a * sin(first->theta2) + p.x * sin(theta3) + p.y * cos(theta3));
}

/* ------------------------------------------------------------------------------- quick returns */

static void put_quick_return(report *r, math *m)
{
    const fourlink_solution *s = r->request->found;
    const fourlink_precision *first = &s->position[0], *last = &s->position[1];
    const fourlink_link *link = s->design.link;
    double delta = last->theta2 - first->theta2 - M_PI;
    double extent = fabs(last->output - first->output);
    double a = s->a, b = link[FOURLINK_COUPLER].length, c = s->c, d = link[FOURLINK_GROUND].length;

    math_set(m, "Q", (M_PI + fabs(delta)) / (M_PI - fabs(delta)));
    put_words(
        r,
        "The crank turns by 180\302\260 + \316\264 and 180\302\260 \342\210\222 \316\264; Q is the "
        "time ratio:");
    math_let(m, "delta", delta < 0 ? "- 180deg * { Q - 1 | Q + 1 }" : "180deg * { Q - 1 | Q + 1 }",
             delta);
    if (s->type == FOURLINK_CRANK_ROCKER) {
        double psi = extent > M_PI ? 2 * M_PI - extent : extent;

        math_set(m, "psi", psi);
        put_words(r, "The crank and the coupler are in line in both limits of the rocker, with the "
                     "swing \317\210:");
        math_zero(
            m,
            "( a * cos { delta | 2 } )^2 + ( b * sin { delta | 2 } )^2 - ( c * sin { psi | 2 } )^2",
            gsl_pow_2(a * cos(delta / 2)) + gsl_pow_2(b * sin(delta / 2)) -
                gsl_pow_2(c * sin(psi / 2)),
            b * b, MATH_AREA);
        math_zero(m,
                  "( a * cos ( { psi - delta | 2 } ) )^2 + "
                  "( b * sin ( { psi - delta | 2 } ) )^2 - ( d * sin ( { psi | 2 } ) )^2",
                  gsl_pow_2(a * cos((psi - delta) / 2)) + gsl_pow_2(b * sin((psi - delta) / 2)) -
                      gsl_pow_2(d * sin(psi / 2)),
                  b * b, MATH_AREA);
    } else if (is_slider_crank(s)) {
        math_set(m, "s", extent);
        put_words(r, "The crank and the rod are in line at both ends of the stroke s:");
        math_zero(m, "( r * cos { delta | 2 } )^2 + ( l * sin { delta | 2 } )^2 - { s ^2 | 4 }",
                  gsl_pow_2(a * cos(delta / 2)) + gsl_pow_2(b * sin(delta / 2)) -
                      extent * extent / 4,
                  b * b, MATH_AREA);
        math_let(m, "e", "{ ( l ^2 - r ^2 ) * sin delta | s }", s->design.offset);
    } else if (s->type == FOURLINK_WHITWORTH) {
        put_words(r, "The tool reverses where the lever is at right angles to AD:");
        math_let(m, "d", "a * sin { delta | 2 }", d);
    } else {
        put_words(r, "The crank is at right angles to the lever in both limits:");
        math_set(m, "h", s->design.offset);
        math_let(m, "d",
                 s->design.offset == 0
                     ? "{ a | sin { delta | 2 } }"
                     : "[ ( { a | sin { delta | 2 } } )^2 + ( { h | cos { delta | 2 } } )^2 ]",
                 d);
    }
}

/* ---------------------------------------------------------------------------------------- checks */

/* The wanted positions, in the frame of the linkage, and what it has there. */
static void put_positions(report *r)
{
    const fourlink_solution *s = r->request->found;
    int is_angle = !s->has_point && !is_slider_crank(s), i;
    char length_unit[NOTATION_SIZE], columns[400];

    notation_unit(unit_of_length(r), length_unit);
    if (s->has_point)
        flk_text_join(columns, sizeof columns, "Position|" THETA2 DEG "|x, ", length_unit, "|y, ",
                      length_unit, "|" THETA3 DEG "|Error, ", length_unit, "|" MU DEG "|Branch",
                      (char *)NULL);
    else if (is_angle)
        strcpy(columns, "Position|" THETA2 DEG "|" THETA4 DEG "|Error" DEG "|" MU DEG "|Branch");
    else
        flk_text_join(columns, sizeof columns, "Position|" THETA2 DEG "|X, ", length_unit,
                      "|Error, ", length_unit, "|" MU DEG "|Branch", (char *)NULL);
    page_table(&r->page, "Wanted positions, in the frame of the linkage", columns);
    for (i = 0; i < s->n_positions; i++) {
        const fourlink_precision *p = &s->position[i];
        double theta2 = DEGREES(p->theta2), mu = DEGREES(p->mu);
        double error = shown_error(r, p->error, is_angle);
        const char *branch =
            p->branch ? fourlink_branch_text(p->branch) : fourlink_status_text(p->status);

        if (s->has_point)
            page_row(&r->page, "%d|%v|%v|%v|%v|%v|%v|%s", i + 1, theta2, DIGITS,
                     shown_length(r, p->point.x), DIGITS, shown_length(r, p->point.y), DIGITS,
                     DEGREES(p->theta3), DIGITS, error, DIGITS, mu, DIGITS, branch);
        else
            page_row(&r->page, "%d|%v|%v|%v|%v|%s", i + 1, theta2, DIGITS,
                     is_angle ? DEGREES(p->output) : shown_length(r, p->output), DIGITS, error,
                     DIGITS, mu, DIGITS, branch);
    }
    page_table_end(&r->page);
}

static void put_checks(report *r)
{
    const fourlink_solution *s = r->request->found;
    int is_length = is_slider_crank(s), bit;
    page *p = &r->page;

    page_print(p, "<h3>Checks</h3>\n<ul>\n<li>%s; longest / shortest link %.4g</li>\n",
               fourlink_type_text((int)s->type), s->ratio);
    for (bit = 1; bit <= FOURLINK_DEFECT_MISSED; bit *= 2)
        if (s->defects & bit)
            page_print(p, "<li>Defect: %s</li>\n", fourlink_defect_text(bit));
    if (!s->defects)
        page_print(p,
                   "<li>No defect: one branch, one circuit, %sno dead position on the way</li>\n",
                   s->is_in_order ? "positions in their order, " : "");
    page_print(p,
               "<li>Transmission angle: at least %.6g\302\260, at " THETA2 " = %.6g\302\260</li>\n",
               DEGREES(s->mu_min), DEGREES(s->mu_min_at));
    if (s->condition > 1)
        page_print(p, "<li>Condition of the linear equations: %.4g</li>\n", s->condition);
    if (s->K[0] != 0)
        page_print(p, "<li>Largest error: %.6g%U, at " THETA2 " = %.6g\302\260</li>\n",
                   shown_error(r, s->max_error, !is_length), is_length ? unit_of_length(r) : "deg",
                   DEGREES(s->max_error_at));
    page_print(p, "</ul>\n");
}

void report_put_synthesis(report *r)
{
    const fourlink_solution *s = r->request->found;
    math m;

    math_begin(&m, &r->page, r->v.units);
    m.size[MATH_LENGTH] = fabs(s->a) + s->design.link[FOURLINK_COUPLER].length;
    set_lengths(s, &m);
    if (s->K[0] != 0)
        put_function(r, &m);
    else if (s->starts > 0)
        put_many(r, &m);
    else if (s->has_point)
        put_guided(r, &m);
    else
        put_quick_return(r, &m);
    put_positions(r);
    put_checks(r);
}
