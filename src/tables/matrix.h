/* SPDX-License-Identifier: GPL-3.0-or-later
**
** matrix.h - the nine equations of each row, as text.
*/
#ifndef FOURLINK_MATRIX_H
#define FOURLINK_MATRIX_H

#include "sheet.h"

/* Write the nine equations for each row. */
void matrix_write(sheet *s);

#endif
