/* SPDX-License-Identifier: GPL-3.0-or-later
**
** sketch.c - a drawing to scale, as commands for gnuplot: lines, arrows, circles, texts, curves.
*/
#include <math.h>
#include <string.h>

#include <gsl/gsl_math.h>

#include "format.h"
#include "print.h"
#include "sketch.h"

/* Heights of a letter, and that, as a fraction of the drawing's size. */
#define LETTER 0.028
#define PIN 0.4
#define SUPPORT 1.3
#define HATCH 0.65

static void put(FILE *out, double x)
{
    char number[FORMAT_SIZE];

    fputs(format_general(x, 7, number), out);
}

static void put_place(FILE *out, fourlink_vector p)
{
    put(out, p.x);
    putc(',', out);
    put(out, p.y);
}

void sketch_include(sketch *s, fourlink_vector p)
{
    s->x_min = p.x < s->x_min ? p.x : s->x_min;
    s->x_max = p.x > s->x_max ? p.x : s->x_max;
    s->y_min = p.y < s->y_min ? p.y : s->y_min;
    s->y_max = p.y > s->y_max ? p.y : s->y_max;
}

static fourlink_vector beside(fourlink_vector p, double dx, double dy)
{
    p.x += dx;
    p.y += dy;
    return p;
}

double sketch_round(double x)
{
    double power = x > 0 ? pow(10, floor(log10(x))) : 1;

    return (x >= 5 * power ? 5 : x >= 2 * power ? 2 : 1) * power;
}

/* Within double quotes gnuplot looks for backslashes, for commands between backquotes, and for the end of
** the line. */
void sketch_quote(FILE *out, const char *words)
{
    putc('"', out);
    for (; *words; words++)
        if (strchr("\"\\`", *words) || ((unsigned char)*words < ' '))
            fprintf(out, "\\%03o", (unsigned)*words);
        else
            putc(*words, out);
    putc('"', out);
}

void sketch_open(sketch *s, FILE *out, double size)
{
    memset(s, 0, sizeof *s);
    s->out = out;
    s->size = size;
    s->letter = LETTER;
    s->x_min = s->y_min = GSL_POSINF;
    s->x_max = s->y_max = GSL_NEGINF;
    fputs("unset arrow; unset label; unset object\n", out);
}

static void put_arrow(sketch *s, pen p, fourlink_vector from, fourlink_vector to, const char *kind)
{
    sketch_include(s, from);
    sketch_include(s, to);
    fputs("set arrow from ", s->out);
    put_place(s->out, from);
    fputs(" to ", s->out);
    put_place(s->out, to);
    fprintf(s->out, " %s ls %d\n", kind, (int)p);
}

void sketch_line(sketch *s, pen p, fourlink_vector from, fourlink_vector to)
{
    put_arrow(s, p, from, to, "nohead");
}

void sketch_arrow(sketch *s, pen p, fourlink_vector from, fourlink_vector to)
{
    put_arrow(s, p, from, to, "head filled size graph 0.025,18 front");
}

/* As a polygon: the circles of gnuplot know no dashes. */
void sketch_arc(sketch *s, pen p, fourlink_vector centre, double radius, double from, double to)
{
    int n = 1 + (int)(fabs(to - from) / (M_PI / 30)), i;
    fourlink_vector last = centre, next;

    for (i = 0; i <= n; i++) {
        double angle = from + (to - from) * i / n;

        next = beside(centre, radius * cos(angle), radius * sin(angle));
        if (i > 0)
            sketch_line(s, p, last, next);
        last = next;
    }
}

void sketch_circle(sketch *s, pen p, fourlink_vector centre, double radius)
{
    sketch_arc(s, p, centre, radius, 0, 2 * M_PI);
}

void sketch_pin(sketch *s, fourlink_vector at)
{
    sketch_include(s, at);
    fputs("set object circle at ", s->out);
    put_place(s->out, at);
    fputs(" size ", s->out);
    put(s->out, PIN * s->letter * s->size);
    fputs(" front fc rgb 'white' fs solid border lc rgb 'black' lw 1.5\n", s->out);
}

void sketch_torque(sketch *s, pen p, fourlink_vector centre, double radius, double sign)
{
    double end = sign > 0 ? 5 * M_PI / 4 : -M_PI / 4, before = end + (sign > 0 ? -0.3 : 0.3);
    fourlink_vector tip, tail;

    sketch_arc(s, p, centre, radius, -M_PI / 4, 5 * M_PI / 4);
    tip = beside(centre, radius * cos(end), radius * sin(end));
    tail = beside(centre, radius * cos(before), radius * sin(before));
    sketch_arrow(s, p, tail, tip);
}

void sketch_text(sketch *s, fourlink_vector at, double dx, double dy, const char *words)
{
    at = beside(at, dx * s->letter * s->size, dy * s->letter * s->size);
    sketch_include(s, at);
    fputs("set label ", s->out);
    sketch_quote(s->out, words);
    fputs(" at ", s->out);
    put_place(s->out, at);
    fprintf(s->out, " %s front\n", dx > 0.3 ? "left" : dx < -0.3 ? "right" : "center");
}

void sketch_note(sketch *s, const char *words)
{
    fputs("set label ", s->out);
    sketch_quote(s->out, words);
    fprintf(s->out, " at graph 1.02, graph 1 offset 0,%d left\n", -s->n_notes++);
}

void sketch_centre(sketch *s, fourlink_vector at)
{
    double r = 0.7 * PIN * s->letter * s->size;
    int i;

    sketch_include(s, at);
    for (i = 0; i < 4; i++) {
        fputs("set object circle at ", s->out);
        put_place(s->out, at);
        fputs(" size ", s->out);
        put(s->out, r);
        fprintf(s->out, " arc [%d:%d] front fc rgb '%s' fs solid border lc rgb 'black'\n", 90 * i,
                90 * i + 90, i % 2 ? "white" : "black");
    }
}

void sketch_ground(sketch *s, double x1, double x2, double y, double side)
{
    double step = HATCH * s->letter * s->size, x;
    fourlink_vector from, to;

    from.x = x1;
    to.x = x2;
    from.y = to.y = y;
    sketch_line(s, PEN_GROUND, from, to);
    for (x = x1 + step; x <= x2 + 1e-9 * step; x += step) {
        from.x = x;
        to = beside(from, -step, side * step);
        put_arrow(s, PEN_CONSTRUCTION, from, to, "nohead");
    }
}

void sketch_support(sketch *s, fourlink_vector at)
{
    double r = SUPPORT * s->letter * s->size;
    fourlink_vector left = beside(at, -0.6 * r, -r), right = beside(at, 0.6 * r, -r);

    sketch_line(s, PEN_GROUND, at, left);
    sketch_line(s, PEN_GROUND, at, right);
    sketch_ground(s, at.x - r, at.x + r, at.y - r, -1);
}

void sketch_curve(sketch *s, pen p, const char *title)
{
    s->curve_pen[s->n_curves] = p;
    print_join(s->curve_title[s->n_curves], sizeof s->curve_title[0], title, (char *)NULL);
    fprintf(s->out, "$curve%d << EOD\n", s->n_curves++);
}

void sketch_point(sketch *s, fourlink_vector at)
{
    sketch_include(s, at);
    put(s->out, at.x);
    putc(' ', s->out);
    put(s->out, at.y);
    putc('\n', s->out);
}

void sketch_break(sketch *s)
{
    putc('\n', s->out);
}

void sketch_end(sketch *s)
{
    fputs("EOD\n", s->out);
}

/* Few tics, so that their numbers have room. */
static void put_axis(sketch *s, const char *axis, const char *unit_name, double low, double high)
{
    fprintf(s->out, "set %slabel '%s (' . ", axis, axis);
    sketch_quote(s->out, unit_name);
    fprintf(s->out, " . ')'\nset %stics ", axis);
    put(s->out, sketch_round((high - low) / 3));
    fprintf(s->out, "\nset %srange [", axis);
    put(s->out, low);
    putc(':', s->out);
    put(s->out, high);
    fputs("]\n", s->out);
}

void sketch_close(sketch *s, const char *title, const char *unit_name)
{
    double margin = 0.06 * s->size;
    int i;

    if (!(s->x_min <= s->x_max)) { /* nothing was drawn */
        s->x_min = s->y_min = -s->size;
        s->x_max = s->y_max = s->size;
    }

    fputs("set size ratio -1\nset title ", s->out);
    sketch_quote(s->out, title);
    putc('\n', s->out);
    put_axis(s, "x", unit_name, s->x_min - margin, s->x_max + margin);
    put_axis(s, "y", unit_name, s->y_min - margin, s->y_max + margin);
    fputs("plot ", s->out);
    for (i = 0; i < s->n_curves; i++) {
        fprintf(s->out, "%s$curve%d using 1:2 with lines ls %d ", i ? ", \\\n     " : "", i,
                (int)s->curve_pen[i]);
        if (s->curve_title[i][0]) {
            fputs("title ", s->out);
            sketch_quote(s->out, s->curve_title[i]);
        } else {
            fputs("notitle", s->out);
        }
    }
    fputs(s->n_curves ? "\n" : "NaN notitle\n", s->out);
}
