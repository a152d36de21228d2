#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
#
# release.sh [PAGE] - web/fourlink.html is built from these sources: what must hold of what is released or merged, but not of
# each commit.  It has their sum; with PAGE, which web/build.sh has just made, it has the same bytes too.  This needs the
# compiler that made it, emscripten of Debian 12, and its GSL, man and gzip.
set -eu
built=
[ $# -eq 0 ] || built=$(cd "$(dirname "$1")" && pwd)/$(basename "$1")
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
passed=1
if [ -n "$built" ] && grep -qs '^VERSION_CODENAME=bookworm' "${OS_RELEASE-/etc/os-release}"; then
    if ! cmp "$built" $page >&2; then
        echo "release.sh: $page has the sum of these sources, but is not what they make here: $built" >&2
        echo "Was it edited, or built elsewhere than on Debian 12? Run sh web/build.sh $page FOLDER, and commit the page." >&2
        exit 1
    fi
    echo "$page has the bytes of the page just built"
    passed=2
elif [ -n "$built" ]; then
    echo "$page is not compared with the page just built, which is of another compiler than that of Debian 12"
fi
echo "$passed passed, 0 failed"
