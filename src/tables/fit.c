/* SPDX-License-Identifier: GPL-3.0-or-later
**
** fit.c - a table that fits a terminal: which columns stand side by side.
*/
#include <string.h>

#include "fit.h"

/* Subjects of columns, in the order of their pages. */
enum { KINEMATICS, FORCES, TORQUES, SUBJECTS };

static int subject_of(const fourlink_value *c)
{
    static const char *const of_torques[] = {"torque", "power", "energy"};
    int i;

    for (i = 0; i < 3; i++)
        if (strcmp(c->quantity, of_torques[i]) == 0)
            return TORQUES;
    if (c->flags & FOURLINK_OF_ROUNDING)
        return TORQUES; /* the power balance */
    return c->flags & FOURLINK_OF_FORCES || strcmp(c->quantity, "force") == 0 ? FORCES : KINEMATICS;
}

/* 1 if two columns are the x and y of one vector. */
static int is_pair(const fourlink_value *x, const fourlink_value *y)
{
    size_t n = strlen(x->name);

    return n > 0 && strlen(y->name) == n && memcmp(x->name, y->name, n - 1) == 0 &&
           x->name[n - 1] == 'x' && y->name[n - 1] == 'y';
}

static int is_angle(const sheet *s, unsigned long j)
{
    return (s->v.columns[j].flags & FOURLINK_CRANK_ANGLE) != 0;
}

/* The pages so far, and what is used of the last one's width. */
typedef struct filling {
    const sheet *s;
    style *styles;
    size_t first; /* what each page begins with */
    size_t used;
    int page;
} filling;

/* Go on to the next page, unless this one is empty or has so much room. */
static void make_room(filling *f, size_t width)
{
    if (f->used > f->first && f->used + width > f->s->width) {
        f->page++;
        f->used = f->first;
    }
}

static size_t width_of(const filling *f, int subject)
{
    size_t width = 0;
    unsigned long j;

    for (j = 0; j < f->s->v.n_columns; j++)
        if (subject_of(&f->s->v.columns[j]) == subject && !is_angle(f->s, j))
            width += f->styles[j].width;
    return width;
}

/* Place the columns of a subject; x and y of a vector stay together. */
static void place(filling *f, int subject)
{
    const fourlink_value *columns = f->s->v.columns;
    unsigned long n = f->s->v.n_columns, j;

    make_room(f, width_of(f, subject));
    for (j = 0; j < n; j++) {
        size_t width = f->styles[j].width;

        if (subject_of(&columns[j]) != subject || is_angle(f->s, j))
            continue;
        if (j + 1 < n && is_pair(&columns[j], &columns[j + 1]))
            make_room(f, width + f->styles[j + 1].width);
        make_room(f, width);
        f->styles[j].page = f->page;
        f->used += width;
    }
}

int fit_begins_with_angle(const sheet *s)
{
    const style *styles = s->layout;

    return is_angle(s, styles[0].column);
}

/* On several pages the crank angle is the first column. */
static void put_angle_first(const sheet *s, style *styles, unsigned long angle)
{
    unsigned long k;

    if (angle == s->v.n_columns)
        return;
    for (k = angle; k > 0; k--)
        styles[k].column = styles[k - 1].column;
    styles[0].column = angle;
}

int fit_columns(const sheet *s, style *styles)
{
    unsigned long angle = s->v.n_columns, j;
    size_t label = sizeof "  at theta2" - 1, total = 0;
    filling f;
    int subject;

    for (j = 0; j < s->v.n_columns; j++) {
        styles[j].page = is_angle(s, j) ? EACH_PAGE : 0;
        styles[j].column = j;
        total += styles[j].width;
        if (is_angle(s, j) && angle == s->v.n_columns)
            angle = j;
    }
    if (!s->width || total + (angle == 0 ? 0 : label) <= s->width)
        return 1;
    f.s = s;
    f.styles = styles;
    /* on each page there is the crank angle, or the label of the extremes */
    f.used = f.first = angle < s->v.n_columns ? styles[angle].width : label;
    f.page = 0;
    for (subject = KINEMATICS; subject < SUBJECTS; subject++)
        place(&f, subject);
    if (f.page > 0)
        put_angle_first(s, styles, angle);
    return f.page + 1;
}
