/* SPDX-License-Identifier: GPL-3.0-or-later
**
** foreign.h - files of other tools, which are told apart from a deck with mistakes.
*/
#ifndef FOURLINK_FOREIGN_H
#define FOURLINK_FOREIGN_H

#include "base/text.h"

/* 1 if a text is a link of PMKS+ with its joints in words, or begins with one. */
int foreign_is_link(text t);

/* Why a text is no deck, and what to do with it; null if it may be one.  `name` is that of its file. */
const char *foreign_refusal(text t, const char *name, char message[400]);

#endif
