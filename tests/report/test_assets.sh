#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
#
# test_assets.sh - src/report/assets.c is what embed.sh makes of the style and the scripts.
. "$(dirname "$0")/../harness.sh"
report=$(cd "$data/../src/report" && pwd)

sh "$report/embed.sh" >assets.c
check 'src/report/assets.c is old: run sh src/report/embed.sh >src/report/assets.c' cmp "$report/assets.c" assets.c
check 'strings of 509 characters at most' awk 'length > 509 {exit 1}' assets.c

# They stand in a page that is XML too, and reach for nothing outside it.
for file in report.css panel.js drawing.js typed.js controls.js; do
    check "$file ends a CDATA section" none -F ']]>' "$report/$file"
    check "$file ends an element" none -i -E '</(script|style)' "$report/$file"
    check "$file names an address" sh -c "! sed 's|http://www.w3.org/[a-z0-9/]*||g; s|url(#[a-z-]*)||g' '$report/$file' | grep -E 'https?:|//[a-z]+\\.|import |url\\(|fetch\\('"
done

# The colours of the light page are those of the pictures, and its widths: look.h has them.
colour() {
    check "$2 is not the colour of $1 in look.h" grep -qi "^    --$1: #$2;" "$report/report.css"
}
table=$report/../view/look.h
for name in crank coupler follower load result path; do
    colour $name "$(sed -n "s/^    X([A-Z]*, \"$name\", \"\([0-9A-F]*\)\".*/\1/p" "$table")"
done
sed -n '/define LOOK_CURVES/,/^$/s/^    X("\([0-9A-F]*\)".*/\1/p' "$table" >curves
check 'six curves' test "$(wc -l <curves)" -eq 6
k=0
while read -r hex; do
    colour curve$k "$hex"
    k=$((k + 1))
done <curves
width() {
    wide=$(sed -n "s/^    X($2, [^,]*, [^,]*, \([0-9.]*\),.*/\1/p" "$table")
    check "$1 is not $wide wide, as in look.h" grep -qE "^\.$1 \{ .*stroke-width: $wide;" "$report/report.css"
}
width link2 CRANK
width link3 COUPLER
width link4 FOLLOWER
width load LOAD
width inertia RESULT

# A quote, a backslash and a trigraph come through; a line that is too long is refused.
mkdir copy
cp "$report/embed.sh" copy
printf 'a "b" \\d ??/ c\n' >copy/report.css
: >copy/panel.js
: >copy/drawing.js
: >copy/typed.js
awk 'BEGIN {for (i = 0; i < 401; i++) printf "x"; print ""}' >copy/controls.js
check 'a line of 401 bytes is refused' sh -c '! sh copy/embed.sh >/dev/null 2>err'
says 'controls.js:1: longer than 400 bytes'
: >copy/controls.js
sh copy/embed.sh >copy/assets.c
cat >copy/main.c <<'END'
#include <stdio.h>
#include "assets.h"
int main(void)
{
    puts(assets_style[0]);
    return assets_style[1] != 0 || assets_script[0] != 0;
}
END
check 'the copy compiles as C90' "${CC:-cc}" -std=c90 -pedantic-errors -I"$report" copy/assets.c copy/main.c -o copy/main
copy/main >out
check 'the copy does not end where it should' test $? -eq 0
prints 'a "b" \d ??/ c'

finish
