/* SPDX-License-Identifier: GPL-3.0-or-later
**
** xml.h - texts in XML and HTML.
*/
#ifndef FOURLINK_XML_H
#define FOURLINK_XML_H

#include <stddef.h>
#include <stdio.h>

/* Write a text so that it is harmless in an element and in an attribute in quotes.  What XML does not allow,
** control characters and bytes that are no UTF-8, becomes the replacement character; CR LF becomes LF. */
void xml_put(FILE *out, const char *words, size_t length);

#endif
