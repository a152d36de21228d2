/* SPDX-License-Identifier: GPL-3.0-or-later
**
** import_links.h - the links and pins of a deck among those of a link of PMKS+.
**
** The four links are the ground, the one with the input, and two that close a loop with it.  Two more that
** hang on these, by a pin P, and end in a slide, a fixed pin or a pin on another link, are an output.
*/
#ifndef FOURLINK_IMPORT_LINKS_H
#define FOURLINK_IMPORT_LINKS_H

#include "pmks.h"

#define IMPORT_MOST_OUTPUTS 8
#define IMPORT_FIRST_OUTPUT \
    5 /* number of the slider or rocker of the first output; its rod is the next */

enum { PIN_A, PIN_B, PIN_C, PIN_D, PINS };

typedef struct import_output {
    text rod,
        follower; /* names of its links; the follower is empty where the rod's own joint slides */
    int carrier, to; /* numbers of the links that it hangs on; to: 0 for the ground */
    const pmks_joint *P, *Q;
    const pmks_joint *end; /* its slide, its fixed pin, or its pin on the link `to` */
} import_output;

typedef struct import_links {
    pmks_link from;
    const pmks_joint *pin[PINS]; /* D is null of a slider-crank */
    const pmks_joint *slide;     /* null of a four-bar */
    text link[5];                /* by number, from 2 on; empty: what slides has none */
    import_output output[IMPORT_MOST_OUTPUTS];
    int n_outputs;
} import_links;

/* Find the links of the deck; 0 after a mistake, which is told. */
int import_find_links(import_links *m);

/* The number of a link: 2 to 4, from IMPORT_FIRST_OUTPUT on those of outputs; 0 if the deck has none. */
int import_number_of(const import_links *m, text link);

/* The least number of the links that a joint is on; 0 if the deck has none of them. */
int import_carrier_of(const import_links *m, const pmks_joint *x);

/* The output that a link belongs to; null for the four links. */
const import_output *import_output_of(const import_links *m, int number);

/* 1 for the rod of an output; 1 for a piston or the slider of an output, which do not turn. */
int import_is_rod(int number);
int import_slides(const import_links *m, int number);

/* The pins between which the x axis of a link runs as drawn, of a slider both the same; its direction,
** deg. */
void import_axis_pins(const import_links *m, int number, const pmks_joint **from,
                      const pmks_joint **to);
double import_axis(const import_links *m, int number);

/* The direction from a place to another, deg. */
double import_direction(double x, double y, double to_x, double to_y);

/* The direction of a slide, deg: a multiple of 15 deg as that, of which the link has three decimals in
** rad. */
double import_direction_of_slide(const pmks_joint *slide);

/* 1 if a joint is one of the pins A to D, or the slide of the four links. */
int import_is_pin(const import_links *m, const pmks_joint *x);

#endif
