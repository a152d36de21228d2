/* SPDX-License-Identifier: GPL-3.0-or-later
**
** terminal.h - a display list in characters.
*/
#ifndef FOURLINK_DRAWING_TERMINAL_H
#define FOURLINK_DRAWING_TERMINAL_H

#include <stdio.h>

#include "display.h"

/* Write a picture in cells of `letter` times `line` pixels: lines as Braille characters, or with `is_ascii`
** as dots.  Returns 0 if out of memory. */
int terminal_write(FILE *out, const display *d, double letter, double line, int is_ascii);

#endif
