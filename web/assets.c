/* SPDX-License-Identifier: GPL-3.0-or-later
**
** assets.c - what the report of a page has in place of src/report/assets.c: the page has the style and the
** script of a report, and puts them in.
*/
#include <stddef.h>

#include "report/assets.h"

const char *const assets_style[] = {"@STYLE@", NULL};
const char *const assets_script[] = {"@SCRIPT@", NULL};
