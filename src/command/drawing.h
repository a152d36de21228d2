/* SPDX-License-Identifier: GPL-3.0-or-later
**
** drawing.h - the picture of a deck, and its report.
*/
#ifndef FOURLINK_DRAWING_H
#define FOURLINK_DRAWING_H

#include <stdio.h>

#include "input.h"

typedef struct drawing {
    const input *in;
    int is_there; /* 0: there is none to write */
    plot picture;
} drawing;

/* Draw a picture, before anything is printed; a picture that is refused is a mistake of the options.  Returns
** the exit status. */
int drawing_begin(drawing *d, const input *in);

/* Write it to its file, or drop it.  Returns the exit status. */
int drawing_end(drawing *d, int keep);

/* Write the report that the options ask for. */
int drawing_report(const input *in);

#endif
