/* SPDX-License-Identifier: GPL-3.0-or-later
**
** sha256.h - the digest SHA-256 of a file, by which two copies can be compared.
*/
#ifndef FOURLINK_SHA256_H
#define FOURLINK_SHA256_H

#include <stddef.h>

#define SHA256_SIZE 65

/* The digest of so many bytes, in hexadecimal digits. */
char *sha256_of(const char *bytes, size_t length, char out[SHA256_SIZE]);

#endif
