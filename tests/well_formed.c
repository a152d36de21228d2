/* SPDX-License-Identifier: GPL-3.0-or-later
**
** well_formed.c FILE... - fails if one of these files is not well-formed XML, and says why.
*/
#include "xml.h"

int main(int argc, char **argv)
{
    int i, status = 0;

    for (i = 1; i < argc; i++) {
        xml_document d;

        if (!xml_read(&d, argv[i])) {
            printf("%s: %s\n", argv[i], d.wrong);
            status = 1;
        }
        xml_free(&d);
    }
    return status;
}
