#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
#
# test_narrow.sh FOURLINK DATA - the drawing of a report in narrow panels, by narrow.js, for the decks of look/: long levers, unequal links, dead positions, springs, friction, many points.
. "$(dirname "$0")/../harness.sh"
tests=$(dirname "$decks")/report

needs node nodejs
mkdir empty
for deck in "$tests"/look/*.deck; do
    name=$(basename "$deck" .deck)
    PATH_BEFORE=$PATH
    PATH=$work/empty "$fourlink" --report="$name.html" "$deck" 2>err
    PATH=$PATH_BEFORE
    check "$name: $(head -n 2 err)" test -s "$name.html"
done
node "$tests/narrow.js" "$data/../src/report" ./*.html >out 2>&1
check "$(head -n 5 out)" none '^FAILED\|Error' out
check "too few: $(tail -n 1 out)" test "$(sed -n 's/ drawings$//p' out)" -gt 1000
finish
