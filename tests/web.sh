#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
#
# web.sh - the page of the present sources: builds it, compares it with the page of the repository, byte for byte, and
# drives it in headless Chromium: types, drags, presses keys, reads; compares messages and numbers with those of the command for the decks of data/, and for decks of the tests.
# For Debian 12 or later, as root if packages are missing.  The variable FOLDER names a folder that keeps GSL for the
# next run; TRY names what is tried, as in drive.js.
. "$(dirname "$0")/foreign.sh"

install cmake make gcc libgsl-dev libcmocka-dev dpkg-dev man-db bsdextrautils emscripten chromium nodejs poppler-utils
sh "$source/web/build.sh" fourlink.html "$work"
status=0
[ "$(wc -c <fourlink.html)" -lt 930000 ] || status=1
count $status 'the page has 930 kB or more'
status=0
sh "$source/tests/release.sh" "$PWD/fourlink.html" || status=1
count $status 'the page of the repository is not what the sources make'

configure native
build native all
rm -rf kept
mkdir kept
for name in typing link force defaults expected column results gas deck sweep card; do
    program=$(find native/build -type f -name "test_$name")
    (cd "$source" && FOURLINK_KEEP_DECKS="$work/kept" "$program" >/dev/null 2>&1) || true
done
status=0
node "$source/tests/web/drive.js" fourlink.html native/build/fourlink "$source" kept || status=1
count $status 'drive.js'
finish
