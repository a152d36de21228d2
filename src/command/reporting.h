/* SPDX-License-Identifier: GPL-3.0-or-later
**
** reporting.h - the report of a deck, in a file.
*/
#ifndef FOURLINK_REPORTING_H
#define FOURLINK_REPORTING_H

#include "input.h"

/* Write the report that the options ask for; returns the exit status. */
int reporting_write(const input *in);

#endif
