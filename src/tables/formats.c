/* SPDX-License-Identifier: GPL-3.0-or-later
**
** formats.c - the formats of a sheet by their names.
*/
#include <string.h>

#include "base/text.h"
#include "formats.h"

#define FORMATS_ENTRY(name) &name##_format,
const sheet_format *const formats_all[] = {SHEET_FORMATS(FORMATS_ENTRY) NULL};

const sheet_format *formats_find(const char *name)
{
    const sheet_format *const *f = formats_all;

    while (*f && strcmp((*f)->name, name) != 0)
        f++;
    return *f;
}

char *formats_of(sheet_content content, const char *between, const char *last,
                 char names[FORMATS_NAMES])
{
    const char *list[sizeof formats_all / sizeof formats_all[0]];
    const sheet_format *const *f;
    int n = 0;

    for (f = formats_all; *f; f++)
        if ((*f)->frame[content])
            list[n++] = (*f)->name;
    list[n] = NULL;
    return flk_text_list(list, between, last, names, FORMATS_NAMES);
}
