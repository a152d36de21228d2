/* SPDX-License-Identifier: GPL-3.0-or-later
**
** utf16.h - texts in UTF-16, as Notepad and PowerShell save them, in UTF-8.
*/
#ifndef FOURLINK_UTF16_H
#define FOURLINK_UTF16_H

#include "text.h"

/* 1 if a text begins with the byte order mark of UTF-16, of either byte order. */
int flk_utf16_is(text t);

/* The size of the buffer that flk_utf16_convert needs. */
#define UTF16_SIZE(length) (3 * ((length) / 2 + 1))

/* Write a text in UTF-8, its mark too.  A surrogate without the other and a last byte without the other
** become the replacement character.
**
** Returned (function value):
**    the text, in `out`, of UTF16_SIZE(t.length) bytes */
text flk_utf16_convert(text t, char *out);

#endif
