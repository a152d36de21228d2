/* SPDX-License-Identifier: GPL-3.0-or-later
**
** sample_template.h - equations of an output in the sample calculation, as templates.
**
** They have the names of the first output of a deck.  Of each output 5 stands for its rod or block and 6
** for its slider or rocker, k for the link that carries it; where there are several, P, Q and the point 0
** of a line have its number.  E is P, or PD, from the pin D on a moving link to P; armx and army are the
** arm of P from the origin of link k.  About this pin, P stands for it and k for the link with it.
*/
#ifndef FOURLINK_REPORT_SAMPLE_TEMPLATE_H
#define FOURLINK_REPORT_SAMPLE_TEMPLATE_H

#include "mathml.h"
#include "report.h"

typedef struct sample_output {
    report *r;
    math *m;
    const fourlink_group *group;
    int i;
    int is_about_pivot; /* 1: P and k are the pin of a rocker and the link with it */
} sample_output;

/* Output i of a deck. */
sample_output sample_output_of(report *r, math *m, int i);

/* The link whose number is k. */
int sample_output_link(const sample_output *o);

#define SAMPLE_EQUATION 400 /* bytes of a template that is written out */

/* Write out a template. */
const char *sample_output_words(const sample_output *o, const char *words,
                                char out[SAMPLE_EQUATION]);

/* As math_let, math_given, math_set of templates. */
void sample_output_let(const sample_output *o, const char *name, const char *equation,
                       double value);
void sample_output_given(const sample_output *o, const char *name, double value);
void sample_output_set(const sample_output *o, const char *name, double value);

/* The heading of a part, with the name of the output and, where there are several, its number. */
void sample_output_heading(const sample_output *o, const char *part);

/* 1 if the pin of a rocker is on a moving link; 1 if a link can turn. */
int sample_output_floats(const fourlink_group *group);
int sample_can_turn(const report *r, int link);

#endif
