/* SPDX-License-Identifier: GPL-3.0-or-later
**
** system.h - the files of the page, in web/system.c.
*/
#ifndef FOURLINK_WEB_SYSTEM_H
#define FOURLINK_WEB_SYSTEM_H

#include <stddef.h>

typedef struct web_file {
    const char *name;
    char *text;
    size_t length;
} web_file;

/* Give the command its only file to read, the deck.  It is not copied. */
void web_system_put(const char *name, char *text, size_t length);

/* The file that was written as number k, from 0; null if there are fewer.  One that was removed is empty. */
const web_file *web_system_written(int k);

#endif
