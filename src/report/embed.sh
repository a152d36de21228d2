#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
#
# embed.sh - writes src/report/assets.c from the style and the scripts of a report: some lines in each string,
# since C90 has strings of 509 characters at most.  Run it after a change of one of them:
#
#   sh src/report/embed.sh >src/report/assets.c
#
# embed.sh FILE... - prints these files as they are embedded, for web/build.sh.
set -eu
cd "$(dirname "$0")"

# Indentation, blank lines and comments that have lines of their own stay here, all but the licence: each report is
# smaller by a quarter of its script.
put_bare() {
    awk '
        {sub(/^ +/, "")}
        /^\/\* SPDX/ {print $0 " */"}
        /^\/\*/ {is_comment = 1}
        length && !is_comment
        /\*\/$/ {is_comment = 0}' "$@"
}
[ $# -eq 0 ] || { put_bare "$@" && exit; }

# put_lines NAME FILE...: an array of lines with a null pointer at the end.
put_lines() {
    name=$1
    shift
    printf '\nconst char *const assets_%s[] = {\n' "$name"
    # A question mark is escaped because C90 has trigraphs.
    awk 'length > 400 {print FILENAME ":" FNR ": longer than 400 bytes" >"/dev/stderr"; exit 1}' "$@"
    put_bare "$@" | sed -e 's/\\/&&/g' -e 's/["?]/\\&/g' | awk '
        NR > 1 && length(lines) + length < 240 {lines = lines "\\n" $0; next}
        NR > 1 {print "    \"" lines "\","}
        {lines = $0}
        END {if (NR) print "    \"" lines "\","}'
    printf '    NULL};\n'
}

cat <<'END'
/* SPDX-License-Identifier: GPL-3.0-or-later
**
** assets.c - the style and the script of a report, written by embed.sh: do not change it by hand.
*/
#include <stddef.h>

#include "assets.h"

/* clang-format off */
END
put_lines style report.css
put_lines script elements.js labels.js player.js cursor.js typed.js controls.js
