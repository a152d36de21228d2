#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
#
# test_install.sh BUILD_DIR - installs to a scratch prefix and uses all of it: the command with a deck, the
# header from C90 and C++98, both libraries, pkg-config, the CMake package, manual pages, completion.
set -u
build=$1
callers=$(cd "$(dirname "$0")/consumers" && pwd)
work=$(mktemp -d) || exit 1
trap 'rm -rf "$work"' EXIT
cd "$work" || exit 1
passed=0
failed=0
CC=${CC:-cc}
CXX=${CXX:-c++}
CFLAGS=${CFLAGS-}

check() {
    what=$1
    shift
    if "$@" >log 2>&1; then
        passed=$((passed + 1))
    else
        failed=$((failed + 1))
        echo "FAILED: $what"
        head -n 20 log
    fi
}

cmake --install "$build" --prefix "$work/usr" >install.log || exit 1
lib=$(dirname "$(find usr -name libfourlink.a)")
[ -d "$lib" ] || exit 1
export LD_LIBRARY_PATH="$work/$lib"

check 'command and example deck' usr/bin/fourlink --check usr/share/fourlink/data/me3491-matrix.deck
check 'manual page of the command' test -s usr/share/man/man1/fourlink.1
check 'manual page of the deck' test -s usr/share/man/man5/fourlink-deck.5
check 'completion' test -s usr/share/bash-completion/completions/fourlink
for option in format output branch interval columns set check matrix summary list help version; do
    check "--$option in the manual page" grep -qF -e "\\-\\-$option" usr/share/man/man1/fourlink.1
    check "--$option completes" grep -qF -e "--$option" usr/share/bash-completion/completions/fourlink
done

gives() { "$@" | grep -qx 'Ts = 0\.[0-9]*'; }
check 'C90, shared' $CC $CFLAGS -std=c90 -pedantic-errors -Wall -Wextra -Werror -Iusr/include "$callers/c90.c" \
    -o shared -L"$lib" -lfourlink
check 'C90, shared, runs' gives ./shared
check 'C90, static' $CC $CFLAGS -std=c90 -Iusr/include "$callers/c90.c" -o static "$lib/libfourlink.a" \
    -lgsl -lgslcblas -lm
check 'C90, static, runs' gives ./static
if command -v "$CXX" >/dev/null; then
    check 'C++98' $CXX $CFLAGS -x c++ -std=c++98 -pedantic-errors -Wall -Wextra -Werror -Iusr/include \
        "$callers/c90.c" -o cxx -L"$lib" -lfourlink
    check 'C++98 runs' gives ./cxx
fi
if command -v pkg-config >/dev/null; then
    export PKG_CONFIG_PATH="$work/$lib/pkgconfig"
    check 'pkg-config' sh -c "$CC $CFLAGS \$(pkg-config --cflags fourlink) '$callers/c90.c' -o pc \$(pkg-config --libs fourlink)"
    check 'pkg-config runs' gives ./pc
fi
mkdir project
cp "$callers/c90.c" project
cat >project/CMakeLists.txt <<'CMAKE'
cmake_minimum_required(VERSION 3.21)
project(consumer C)
find_package(fourlink 0.1 REQUIRED)
add_executable(with_shared c90.c)
target_link_libraries(with_shared fourlink::fourlink)
add_executable(with_static c90.c)
target_link_libraries(with_static fourlink::static)
CMAKE
check 'find_package' cmake -S project -B project/build -DCMAKE_PREFIX_PATH="$work/usr" \
    -DCMAKE_C_COMPILER="$CC" -DCMAKE_C_FLAGS="$CFLAGS"
check 'its targets build' cmake --build project/build
check 'fourlink::fourlink runs' gives project/build/with_shared
check 'fourlink::static runs' gives project/build/with_static

# Of the shared library nothing is visible but what the header declares.
if command -v nm >/dev/null; then
    nm -D --defined-only "$lib/libfourlink.so" | awk '$2 ~ /[A-Z]/ {print $3}' | grep -v '^__\|^_init\|^_fini' | sort >visible
    sed -n 's/.*FOURLINK_API.* \**\(fourlink_[a-z_]*\)(.*/\1/p' usr/include/fourlink.h | sort >declared
    check 'the symbols of the header, and no others' cmp visible declared
    check 'no stdio, allocation, exit in the library' sh -c \
        "! nm -D --undefined-only '$lib/libfourlink.so' | grep -wE 'printf|puts|putc|fopen|fwrite|stdout|stderr|malloc|calloc|realloc|free|exit|abort|gsl_set_error_handler|gsl_set_error_handler_off|gsl_error'"
fi

echo "$passed passed, $failed failed"
[ "$failed" -eq 0 ]
