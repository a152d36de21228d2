/* SPDX-License-Identifier: GPL-3.0-or-later
**
** formats.h - the formats of a sheet by their names.
*/
#ifndef FOURLINK_FORMATS_H
#define FOURLINK_FORMATS_H

#include "sheet.h"

/* All formats, with null at the end; the format of this name, or null. */
extern const sheet_format *const formats_all[];
const sheet_format *formats_find(const char *name);

/* The names of the formats that can show this, as flk_text_list joins them. */
#define FORMATS_NAMES 100
char *formats_of(sheet_content content, const char *between, const char *last,
                 char names[FORMATS_NAMES]);

#endif
