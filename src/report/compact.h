/* SPDX-License-Identifier: GPL-3.0-or-later
**
** compact.h - gnuplot's drawings, made shorter.
*/
#ifndef FOURLINK_COMPACT_H
#define FOURLINK_COMPACT_H

#include <stdio.h>

/* Write the same drawing in about half as many bytes: empty groups are left out, and curves go on
** from point to point in tenths of a pixel.  Returns 0 if out of memory. */
int compact_svg(FILE *drawing, FILE *out);

#endif
