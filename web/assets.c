/* SPDX-License-Identifier: GPL-3.0-or-later
**
** assets.c - what the report of a page has in place of src/report/assets.c: the page has the style and the
** script of a report, and puts them in.  There is no scratch file for the csv, which the page saves itself.
*/
#include <errno.h>
#include <stddef.h>

#include "system/system.h"
#include "report/assets.h"

const char *const assets_style[] = {"@STYLE@", NULL};
const char *const assets_script[] = {"@SCRIPT@", NULL};

FILE *system_scratch(void)
{
    errno = ENOTSUP;
    return NULL;
}
