/* SPDX-License-Identifier: GPL-3.0-or-later
**
** hull.c - the outline of a link: the convex hull of its points.
*/
#include "sketch.h"

/* Twice the area of the triangle o, p, q; above 0 if it is counter-clockwise. */
static double turn(fourlink_vector o, fourlink_vector p, fourlink_vector q)
{
    return (p.x - o.x) * (q.y - o.y) - (p.y - o.y) * (q.x - o.x);
}

static int is_before(fourlink_vector p, fourlink_vector q)
{
    return p.x < q.x || (p.x == q.x && p.y < q.y);
}

static void sort(fourlink_vector *points, int n)
{
    int i, j;

    for (i = 1; i < n; i++) {
        fourlink_vector p = points[i];

        for (j = i; j > 0 && is_before(p, points[j - 1]); j--)
            points[j] = points[j - 1];
        points[j] = p;
    }
}

/* A. M. Andrew, "Another efficient algorithm for convex hulls in two dimensions", Information Processing
** Letters 9 (1979): the lower side from left to right, then the upper side back. */
void sketch_hull(sketch *s, pen p, fourlink_vector *points, int n)
{
    fourlink_vector corners[2 * SKETCH_CORNERS];
    int m = 0, lower, i;

    if (n < 2 || n > SKETCH_CORNERS)
        return;
    sort(points, n);
    for (i = 0; i < n; corners[m++] = points[i++])
        while (m >= 2 && turn(corners[m - 2], corners[m - 1], points[i]) <= 0)
            m--;
    lower = m + 1;
    for (i = n - 2; i >= 0; corners[m++] = points[i--])
        while (m >= lower && turn(corners[m - 2], corners[m - 1], points[i]) <= 0)
            m--;
    for (i = 0; i + 1 < m; i++)
        sketch_line(s, p, corners[i], corners[i + 1]);
}
