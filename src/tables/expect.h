/* SPDX-License-Identifier: GPL-3.0-or-later
**
** expect.h - a deck's values as [expect] sections, for --check.
*/
#ifndef FOURLINK_EXPECT_H
#define FOURLINK_EXPECT_H

#include "sheet.h"

/* Write the deck's values as [expect] sections: for each row, or for the crank angles of s->at. */
void expect_write(sheet *s);

#endif
