#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
#
# release.sh - what must hold of a release, but not of each commit: web/fourlink.html is built from these sources.
set -eu
cd "$(dirname "$0")/.."
page=web/fourlink.html

# meta NAME: what the page says of itself
meta() { sed -n 's/^<meta name="'"$1"'" content="\(.*\)">$/\1/p' $page; }

version=$(sed -n 's/^project(fourlink VERSION \([0-9.]*\).*/\1/p' CMakeLists.txt)
if [ "$(meta generator)" != "fourlink $version" ] || [ "$(meta fourlink-sources)" != "sha256:$(sh web/sources.sh)" ]; then
    echo "release.sh: $page, of $(meta generator), is not built from these sources, of fourlink $version" >&2
    echo "Run sh web/build.sh $page FOLDER, then ctest --test-dir build -R test_web, and commit the page." >&2
    exit 1
fi
echo "$page is built from these sources, of fourlink $version"
