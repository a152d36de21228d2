#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
#
# sources.sh [PATTERN] - prints the SHA-256 of all that the page is built from; with PATTERN, which grep -E reads,
# only of the files whose names it matches.  The page has it from build.sh; tests/release.sh compares.
set -eu
cd "$(dirname "$0")/.."
export LC_ALL=C

{
    find include src web data doc/man -type f \
        \( -name '*.[ch]' -o -name '*.js' -o -name '*.css' -o -name '*.html' -o -name '*.sh' -o -name '*.deck' \
        -o -name '*.[15]' \) ! -path web/fourlink.html
} | grep -E -e "${1-.}" | sort | xargs sha256sum | {
    cat
    sed -n '/^project(fourlink /p' CMakeLists.txt # the version
} | sha256sum | cut -d ' ' -f 1
