/* SPDX-License-Identifier: GPL-3.0-or-later
**
** handed.h - what the names of files that were handed in say: whose they are, and when.
*/
#ifndef FOURLINK_HANDED_H
#define FOURLINK_HANDED_H

#include "base/text.h"

/* A name of a file, or of a student, without its endings. */
text handed_stem(const char *path);

/* The part of a name without endings that says who has handed it in.  Where a learning platform has written
** it, this is the name of the student:
**
**    Li Ada_123456_assignsubmission_file_hw4       Li Ada
**    liada_LATE_1234_5678_hw4 (final) (2)          liada
**    123456-78901 - Ada Li - Nov 26, 2026 1030 AM  Ada Li
**
** otherwise all of it. */
text handed_who(text stem);

/* The date in a name, such as 2026-11-26, 2026-11-26-10-30-00 or Nov 26, 2026 1030 AM, as a number that
** grows with it; 0 if there is none. */
double handed_date(text stem);

#endif
