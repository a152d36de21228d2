#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
#
# web.sh - the page: builds web/fourlink.html and drives it in headless Chromium: types, drags, presses keys, reads;
# compares messages and numbers with those of the command for the decks of data/, and for decks of the tests.
# For Debian 12 or later, as root if packages are missing.  The variable FOLDER names a folder that keeps GSL for the
# next run; TRY names what is tried, as in drive.js.
. "$(dirname "$0")/foreign.sh"

install cmake make gcc libgsl-dev libcmocka-dev dpkg-dev man-db bsdextrautils emscripten chromium nodejs
sh "$source/web/build.sh" "$source/web/fourlink.html" "$work"
status=0
[ "$(wc -c <"$source/web/fourlink.html")" -lt 700000 ] || status=1
count $status 'the page has 700 kB or more'

configure native
build native all
rm -rf kept
mkdir kept
for name in typing link force defaults expected column results gas deck sweep card; do
    program=$(find native/build -type f -name "test_$name")
    (cd "$source" && FOURLINK_KEEP_DECKS="$work/kept" "$program" >/dev/null 2>&1) || true
done
status=0
node "$source/tests/web/drive.js" "$source/web/fourlink.html" native/build/fourlink "$source" kept || status=1
count $status 'drive.js'
finish
