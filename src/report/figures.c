/* SPDX-License-Identifier: GPL-3.0-or-later
**
** figures.c - the figures of a report, drawn by gnuplot.
*/
#include <errno.h>
#include <string.h>

#include "system/system.h"
#include "pictures/plot.h"
#include "compact.h"
#include "report.h"

/* Keep the reason why there are no pictures.  Without memory there is no report either. */
static void miss(report *r, const char *why)
{
    r->gnuplot = why;
    r->out_of_memory |= errno == ENOMEM;
}

/* Draw a picture into a stream; 0 if there is none. */
static int draw(report *r, FILE *drawing, plot_kind kind, const char *at)
{
    FILE *script = system_scratch();
    fourlink_mistake mistake;
    plot_request request;
    plot_caption caption;
    int is_drawn = 0, is_written;
    const char *why;

    memset(&request, 0, sizeof request);
    request.kind = kind;
    request.file = PLOT_SVG;
    request.at = at;
    request.is_figure = 1;
    request.opened = r->v.results;
    request.kept = &r->drawn;
    if (!script) {
        miss(r, strerror(errno));
    } else if ((is_written = plot_write(script, r->source, &request, &caption, &mistake)) > 0) {
        errno = 0;
        why = gnuplot_run(script, drawing, &caption, r->reason);
        is_drawn = !why;
        if (why)
            miss(r, why);
    } else {
        r->out_of_memory |= is_written < 0;
    }
    if (script)
        fclose(script);
    return is_drawn;
}

static void put_drawing(report *r, FILE *drawing, plot_kind kind, const char *alt,
                        const char *caption)
{
    page_print(&r->page,
               "<figure class=\"%s\" id=\"figure-%d\">\n<img alt=\"%s\" "
               "src=\"data:image/svg+xml;base64,",
               plot_names[kind], r->page.n_figures + 1, alt);
    rewind(drawing);
    page_base64(&r->page, drawing);
    page_print(&r->page, "\"/>\n<figcaption>Figure %d. %s</figcaption>\n</figure>\n",
               ++r->page.n_figures, caption);
}

/* Put a figure, if the deck has such a picture.  `alt` says what it shows to those who do not see it. */
static void put_figure(report *r, plot_kind kind, const char *at, const char *alt,
                       const char *caption)
{
    FILE *drawing, *shorter;

    if (r->gnuplot)
        return;
    drawing = system_scratch();
    shorter = system_scratch();
    if (!drawing || !shorter)
        miss(r, strerror(errno));
    else if (draw(r, drawing, kind, at)) {
        if (compact_svg(drawing, shorter))
            put_drawing(r, shorter, kind, alt, caption);
        else
            r->out_of_memory = 1;
    }
    if (drawing)
        fclose(drawing);
    if (shorter)
        fclose(shorter);
}

/* "NAME at theta2 = ANGLE, WHY" */
static const char *at_angle(const report *r, const char *name, char out[320])
{
    return flk_text_join(out, 320, name, " at \316\270\342\202\202 = ", r->at, *r->why ? ", " : "",
                         r->why, ".", (char *)NULL);
}

void report_put_mechanism(report *r, int is_drawn)
{
    const char *at = r->drawn_at;
    char caption[320], alt[200];

    if (!is_drawn) {
        report_put_results(r);
        return;
    }
    page_section(&r->page, "mechanism", "Mechanism");
    at_angle(r, "The mechanism, with loads and pin forces,", caption);
    if (!r->v.problem.has_forces)
        at_angle(r, "The mechanism", caption);
    flk_text_join(alt, sizeof alt, "Drawing to scale of the ", r->v.kind.words,
                  ": its links, pins and points", (char *)NULL);
    put_figure(r, PLOT_MECHANISM, at, alt, caption);
    if (r->gnuplot)
        page_print(&r->page, "<p class=\"missing\">The pictures are missing: %s.</p>\n",
                   r->gnuplot);
    report_put_interactive(r);
}

void report_put_curves(report *r)
{
    const char *at = r->drawn_at;
    const char *over = r->v.problem.by_time ? "over time." : "over the crank angle.";
    char caption[320];

    page_section(&r->page, "curves", "Curves and diagrams");
    put_figure(r, PLOT_MOTION, NULL, "Curves of angles, angular velocities and accelerations",
               flk_text_join(caption, sizeof caption, "The motion ", over, (char *)NULL));
    put_figure(r, PLOT_FORCES, NULL, "Curves of pin forces and of the driving torque",
               flk_text_join(caption, sizeof caption, "The pin forces and the driving torque ",
                             over, (char *)NULL));
    put_figure(r, PLOT_POLAR, NULL, "Pin forces as vectors, drawn from one origin",
               "Polar diagrams of the pin forces.");
    put_figure(r, PLOT_SPEED, NULL, "Curves of the crank's speed, of torques, and of the energy",
               "The actual motion: speed with its mean, torques over the speed, energy.");
    put_figure(r, PLOT_TURNING, NULL, "Turning moment, its mean, and the areas between them",
               "The turning moment.");
    put_figure(r, PLOT_KLEIN, at,
               "Klein's construction: lengths that stand for velocity and acceleration",
               at_angle(r, "Klein's construction", caption));
    if (r->gnuplot)
        page_print(&r->page, "<p class=\"missing\">The pictures are missing: %s.</p>\n",
                   r->gnuplot);
    page_print(&r->page, "</section>\n");
}
