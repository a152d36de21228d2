/* SPDX-License-Identifier: GPL-3.0-or-later
**
** scene_json.h - what the interactive drawing consists of, as JSON: links, polygons, forces by the names of their
** tracks.
*/
#ifndef FOURLINK_SCENE_JSON_H
#define FOURLINK_SCENE_JSON_H

#include "rows.h"
#include "tables/line.h"

/* What a string in an element <script> must not have as it is, in HTML or in XML. */
#define SCENE_ESCAPED "<>&"

/* Write the members of an object, with a comma after the last. */
void scene_json_write(line *l, const rows *t);

#endif
