/* SPDX-License-Identifier: GPL-3.0-or-later
**
** assets.h - the style and the script of a report, by lines, with a null pointer at the end.
*/
#ifndef FOURLINK_ASSETS_H
#define FOURLINK_ASSETS_H

extern const char *const assets_style[], *const assets_script[];

#endif
