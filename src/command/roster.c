/* SPDX-License-Identifier: GPL-3.0-or-later
**
** roster.c - the list of a class: names, ids, days late.
*/
#include <errno.h>
#include <stdlib.h>
#include <string.h>

#include "base/message.h"
#include "base/number.h"
#include "system/memory.h"
#include "command.h"
#include "files.h"
#include "roster.h"
#include "students.h"

enum { NAME, ID, LATE, COLUMNS };

static const char *const titles[COLUMNS] = {"name", "id", "late"};

static int refuse(const char *path, long at, const char *why)
{
    command_tell("error", path, at, why, NULL);
    return EXIT_USAGE;
}

/* Read a line; the status. */
static int read_entry(roster *r, const char *path, long at, text row, int separator,
                      const int *place)
{
    roster_entry *e = &r->list[r->n];
    text field, late = {"", 0};
    int i;

    memset(e, 0, sizeof *e);
    e->name = e->id = late;
    for (i = 0; flk_text_field(&row, separator, &field); i++)
        if (i == place[NAME])
            e->name = field;
        else if (i == place[ID])
            e->id = field;
        else if (i == place[LATE])
            late = field;
    if (!e->name.length)
        return 0;
    if (late.length &&
        (flk_number_read(&late, &e->late) != NUMBER_OK || late.length || !(e->late >= 0)))
        return refuse(path, at, "late must be a number of days, such as 2");
    r->n++;
    return 0;
}

int roster_read(roster *r, const char *path)
{
    int place[COLUMNS] = {-1, -1, -1}, separator, line_end, i, k, status = 0;
    text rest, row, field;
    size_t length = 0;
    long at = 1;

    memset(r, 0, sizeof *r);
    r->contents = files_read(path, &length);
    if (!r->contents)
        return command_complain("cannot read", path, strerror(errno));
    rest.start = r->contents;
    rest.length = length;
    rest = flk_text_without_mark(rest);
    line_end = flk_text_line_end(rest);
    r->list = memory_get(flk_text_count(rest, line_end) + 1, sizeof *r->list);
    if (!r->list)
        return command_lacks_memory("cannot read", path);
    flk_text_split(&rest, line_end, &row);
    separator = flk_text_separator(row);
    for (i = 0; flk_text_field(&row, separator, &field); i++)
        for (k = 0; k < COLUMNS; k++)
            if (flk_text_equal(field, titles[k]))
                place[k] = i;
    if (place[NAME] < 0)
        return refuse(path, 1, "expected the titles of columns: name, id, late");
    while (!status && rest.start && flk_text_split(&rest, line_end, &row))
        status = read_entry(r, path, ++at, flk_text_trim(row), separator, place);
    return status;
}

void roster_free(roster *r)
{
    free(r->contents);
    free(r->list);
}

const roster_entry *roster_find(const roster *r, text name)
{
    size_t i;

    for (i = 0; i < r->n; i++)
        if (students_same(r->list[i].name, name))
            return &r->list[i];
    return NULL;
}
