/* SPDX-License-Identifier: GPL-3.0-or-later
**
** figures.c - the figures of a report.
*/
#include <string.h>

#include "pictures/plot.h"
#include "report.h"

/* Put a part of a picture as a figure, if the deck has such a picture.  `alt` says what it shows to
** those who do not see it. */
static void put_part(report *r, plot_kind kind, plot_part part, const char *at, const char *alt,
                     const char *caption)
{
    static const char *const parts[] = {"", " of-motion", " of-forces"};
    fourlink_mistake mistake;
    plot_request request;
    plot drawn;
    int made;

    memset(&request, 0, sizeof request);
    request.kind = kind;
    request.part = part;
    request.file = PLOT_SVG;
    request.at = at;
    request.is_figure = 1;
    request.opened = r->v.results;
    request.kept = &r->drawn;
    made = plot_make(&drawn, r->source, &request, &mistake);
    if (made > 0) {
        flk_text_join(drawn.caption.title, sizeof drawn.caption.title, alt, (char *)NULL);
        page_print(&r->page, "<figure class=\"%s%s\" id=\"figure-%d\">\n", plot_names[kind],
                   parts[part], ++r->page.n_figures);
        plot_write_figure(&drawn, r->page.out);
        page_print(&r->page, "<figcaption>Figure %d. %s</figcaption>\n</figure>\n",
                   r->page.n_figures, caption);
    }
    plot_free(&drawn);
}

static void put_figure(report *r, plot_kind kind, const char *at, const char *alt,
                       const char *caption)
{
    put_part(r, kind, PLOT_WHOLE, at, alt, caption);
}

/* "NAME at theta2 = ANGLE, WHY" */
static const char *at_angle(const report *r, const char *name, char out[320])
{
    return flk_text_join(out, 320, name, " at \316\270\342\202\202 = ", r->at, *r->why ? ", " : "",
                         r->why, ".", (char *)NULL);
}

/* The graphical method at the position of the sample calculation. */
static void put_vectors(report *r)
{
    char caption[320];

    if (!view_is_still(&r->v))
        put_part(r, PLOT_VECTORS, PLOT_OF_MOTION, r->drawn_at,
                 "Polygons of velocity and of acceleration",
                 at_angle(r, "Velocity and acceleration polygons", caption));
    if (r->v.problem.has_forces)
        put_part(r, PLOT_VECTORS, PLOT_OF_FORCES, r->drawn_at,
                 "Each link with the forces on it, and their polygon, which closes",
                 at_angle(r, "Free bodies and polygons of forces", caption));
    put_figure(r, PLOT_KLEIN, r->drawn_at,
               "Klein's construction: lengths that stand for velocity and acceleration",
               at_angle(r, "Klein's construction", caption));
}

void report_put_mechanism(report *r)
{
    const char *at = r->drawn_at;
    char caption[320], alt[200];

    if (!r->has_rows) {
        report_put_results(r);
        return;
    }
    at_angle(r, "The mechanism, with loads and pin forces,", caption);
    if (!r->v.problem.has_forces)
        at_angle(r, "The mechanism", caption);
    flk_text_join(alt, sizeof alt, "Drawing to scale of the ", r->v.kind.words,
                  ": its links, pins and points", (char *)NULL);
    put_figure(r, PLOT_MECHANISM, at, alt, caption);
    report_put_interactive(r);
    put_vectors(r);
}

void report_put_curves(report *r)
{
    const char *over = r->v.problem.over.words;
    char caption[320];

    put_figure(r, PLOT_MOTION, NULL, "Curves of angles, angular velocities and accelerations",
               flk_text_join(caption, sizeof caption, "The motion over ", over, ".", (char *)NULL));
    put_figure(r, PLOT_FORCES, NULL, "Curves of pin forces and of the driving torque",
               flk_text_join(caption, sizeof caption, "The pin forces and the driving torque over ",
                             over, ".", (char *)NULL));
    put_figure(r, PLOT_TURNING, NULL, "Turning moment, its mean, and the areas between them",
               "The turning moment.");
    put_figure(r, PLOT_POLAR, NULL, "Pin forces as vectors, drawn from one origin",
               "Polar diagrams of the pin forces.");
    put_figure(r, PLOT_SPEED, NULL, "Curves of the crank's speed, of torques, and of the energy",
               "The actual motion: speed with its mean, torques over the speed, energy.");
}
