/* SPDX-License-Identifier: GPL-3.0-or-later
**
** scene_json.h - what the interactive drawing consists of, as JSON: links, polygons, forces by the names of their
** tracks.
*/
#ifndef FOURLINK_SCENE_JSON_H
#define FOURLINK_SCENE_JSON_H

#include "rows.h"
#include "tables/line.h"

/* Write JSON into an element <script>: %s a text as it is, %q a string, %lu a whole number. */
void scene_json_put(line *l, const char *format, ...);

/* Write the members of an object, with a comma after the last. */
void scene_json_write(line *l, const rows *t);

#endif
