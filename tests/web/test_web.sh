#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
#
# test_web.sh FOURLINK DATA - web/fourlink.html as it stands, in headless Chromium: what tests/web.sh tries at length of
# a page just built.
. "$(dirname "$0")/../harness.sh"
top=$(dirname "$data")

needs chromium chromium
needs node nodejs

page=$top/web/fourlink.html
check "$(wc -c <"$page") bytes" test "$(wc -c <"$page")" -lt 930000
for name in generator fourlink-sources; do
    check "no $name" grep -q "^<meta name=\"$name\" content=\"[a-z0-9]*[ :][0-9a-f.]*\">$" "$page"
done
check "it asks for other files" none -E '<(link|script|img|iframe)[^>]* (src|href)=' "$page"

# the page knows the other names of links that the program reads
sed -n '/other_links\[\]/,/};/p' "$top/src/deck/schema.c" | tr -d '\n' | grep -o '"[a-z]*", "[a-z]*"' | tr -d '",' | sort >names
sed -n '/^const links = /,/;/p' "$top/web/page/text.js" | grep -o '[a-z]*: "[a-z]*"' | tr -d '":' | sort >page.names
check "$(wc -l <names) names of links" test -s names
same page.names names
TRY=tables node "$top/tests/web/drive.js" "$page" "$fourlink" "$top" >out 2>&1
check "$(cat out)" grep -q ' 0 failed$' out
finish
