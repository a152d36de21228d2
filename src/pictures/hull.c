/* SPDX-License-Identifier: GPL-3.0-or-later
**
** hull.c - the outline of a link with tracer points: their convex hull.
*/
#include <stdlib.h>

#include "figure.h"

/* Of a link: its points, its pins, and those of outputs on it. */
#define CORNERS (TRACKS_POINTS + 2 + 2 * FOURLINK_MOST_GROUPS)

/* Twice the area of the triangle o, p, q; above 0 if it is counter-clockwise. */
static double turn(fourlink_vector o, fourlink_vector p, fourlink_vector q)
{
    return (p.x - o.x) * (q.y - o.y) - (p.y - o.y) * (q.x - o.x);
}

static int compare(const void *first, const void *second)
{
    const fourlink_vector *p = first, *q = second;

    return p->x != q->x ? (p->x < q->x ? -1 : 1) : (p->y > q->y) - (p->y < q->y);
}

/* Find the convex hull of so many points, which are sorted: the lower side from left to right, then the
** upper side back (A. M. Andrew, "Another efficient algorithm for convex hulls in two dimensions",
** Information Processing Letters 9, 1979).  Returns the number of its corners. */
static int find_hull(fourlink_vector *points, int n, fourlink_vector corners[2 * CORNERS])
{
    int m = 0, lower, i;

    qsort(points, (size_t)n, sizeof *points, compare);
    for (i = 0; i < n; corners[m++] = points[i++])
        while (m >= 2 && turn(corners[m - 2], corners[m - 1], points[i]) <= 0)
            m--;
    lower = m + 1;
    for (i = n - 2; i >= 0; corners[m++] = points[i--])
        while (m >= lower && turn(corners[m - 2], corners[m - 1], points[i]) <= 0)
            m--;
    return m - 1; /* the last is the first */
}

static void place_points(const fourlink_state *state, int link, fourlink_vector *points, int n)
{
    int i;

    for (i = 0; i < n; i++)
        points[i] = geometry_of_link(state, link, &points[i]);
}

/* Draw the outline of a link, the hull of points in its own axes: in a motion from the same corner at each
** position. */
static void put_hull(sketch *s, const fourlink_state *state, int link, fourlink_vector *points,
                     int n)
{
    fourlink_vector corners[2 * CORNERS];
    int m, i;

    if (!s->c->motion)
        place_points(state, link, points, n);
    m = find_hull(points, n, corners);
    if (s->c->motion)
        place_points(state, link, corners, m + 1);
    for (i = 0; i < m; i++)
        sketch_line(s, FIGURE_PEN(link), corners[i], corners[i + 1]);
}

/* Add the pins of outputs on a link, in its own axes; returns the number of points. */
static int add_outputs(const picture *p, int link, fourlink_vector *points, int n)
{
    const fourlink_group *g = p->v.design->group;
    int i;

    for (i = 0; i < p->v.design->n_groups; i++) {
        if (g[i].link == link)
            points[n++] = g[i].at;
        if (g[i].to == link && link != FOURLINK_GROUND)
            points[n++] = g[i].pivot;
    }
    return n;
}

/* The length of a link, of one of an output too. */
static double length_of(const picture *p, int link)
{
    const fourlink_group *g = p->v.design->group;
    int i = link - FOURLINK_FOLLOWER - 1;

    return i < 0 ? p->v.design->link[link].length : i % 2 ? g[i / 2].length : g[i / 2].rod;
}

void hull_draw(sketch *s, const picture *p, const fourlink_state *state, int link)
{
    fourlink_vector points[CORNERS];
    unsigned long i;
    int n = 0, is_off = 0, on, k;

    for (i = 0; i < p->v.problem.n_points; i++) {
        fourlink_deck_point(p->v.deck, i, NULL, &on, &points[n]);
        n += on == link;
    }
    n = add_outputs(p, link, points, n);
    for (k = 0; k < n; k++)
        is_off |= points[k].y != 0;
    if (n == 0)
        return;
    points[n++] = place_at(0, 0);
    points[n++] = place_at(length_of(p, link), 0);
    sketch_show(s, SKETCH_HULL, (unsigned long)link);
    sketch_with(s, link);
    if (is_off || link != p->v.kind.slotted) /* a lever goes that far */
        put_hull(s, state, link, points, n);
}
