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
for file in report.css elements.js labels.js player.js cursor.js typed.js controls.js; do
    check "$file ends a CDATA section" none -F ']]>' "$report/$file"
    check "$file ends an element" none -i -E '</(script|style)' "$report/$file"
    check "$file names an address" sh -c "! sed 's|http://www.w3.org/[a-z0-9/]*||g; s|url(#[a-z-]*)||g' '$report/$file' | grep -E 'https?:|//[a-z]+\\.|import |url\\(|fetch\\('"
done

# The colours of drawings stand in look.h alone.
sed -n 's/^    X([^"]*"[a-z]*", "\([0-9A-F]\{6\}\)".*/\1/p; s/^    X("\([0-9A-F]\{6\}\)".*/\1/p' "$report/../view/look.h" | grep -v '^\(000000\|666666\)$' >colours
check "colours in look.h: $(wc -l <colours)" test "$(wc -l <colours)" -ge 14
check 'a colour of a drawing in report.css' none -i -F -f colours "$report/report.css"

# A quote, a backslash and a trigraph come through; a line that is too long is refused.
mkdir copy
cp "$report/embed.sh" copy
printf 'a "b" \\d ??/ c\n' >copy/report.css
: >copy/elements.js
: >copy/labels.js
: >copy/player.js
: >copy/cursor.js
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
