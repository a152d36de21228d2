#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
#
# build.sh PAGE [FOLDER] - builds fourlink.html: the program in a page, one file that needs no network.
#
# FOLDER keeps GSL and the objects for the next run; without it they are built anew and removed.  On Debian it
# needs the packages named below, and apt for GSL's source package, or that source unpacked in FOLDER/gsl-VERSION.
# With the same versions of these, the same sources give the same bytes.
set -eu
[ $# -ge 1 ] || { echo 'usage: build.sh PAGE [FOLDER]' >&2 && exit 2; }
missing=
for command in emcc dpkg-source man col; do
    command -v $command >/dev/null || missing="$missing $command"
done
if [ -n "$missing" ]; then
    echo "build.sh: not installed:$missing" >&2
    echo 'On Debian: apt-get install --no-install-recommends emscripten dpkg-dev man-db bsdextrautils' >&2
    exit 2
fi
case $1 in /*) page=$1 ;; *) page=$PWD/$1 ;; esac
if [ $# -gt 1 ]; then
    FOLDER=$2
fi
. "$(dirname "$0")/../tests/foreign.sh"
export NODE_PATH=/usr/share/nodejs LC_ALL=C.UTF-8

# The parts of GSL that the program uses, and those that these need.
parts='err sys utils complex min roots interpolation poly linalg blas cblas matrix vector block permutation rng randist
    sort statistics integration multimin'

# configure does not know the machine; WebAssembly has no extended registers.  GSL's messages of errors name its
# files: by relative paths, which are the same everywhere.
build_parts() {
    [ "$(cat web/gsl/done 2>/dev/null)" = "$parts" ] && return
    sources_of gsl
    rm -rf web/gsl
    mkdir -p web/gsl
    (
        cd web/gsl &&
            emconfigure ../../gsl-[0-9]*/configure --host=none-unknown-linux --disable-shared CFLAGS=-O2 &&
            sed -i 's,^#define HAVE_EXTENDED_PRECISION_REGISTERS.*,/* none */,' config.h &&
            for part in gsl $parts; do
                emmake make -j2 -C "$part" || exit 1
            done &&
            echo "$parts" >done
    ) >web/gsl.log 2>&1 || { tail -n 20 web/gsl.log >&2; exit 1; }
}

# The whole program; of the operating system it has what web/system.c has.  All is compiled anew after a change.
build_program() {
    hash=$(sh "$source/web/sources.sh" '\.(c|h|sh)$')
    [ "$(cat web/objects/done 2>/dev/null)" = "$hash" ] && return
    rm -rf web/objects
    mkdir -p web/objects
    (cd "$source" && find src web -name '*.c' ! -name 'system_*.c' ! -path src/report/assets.c) | xargs -P 2 -n 8 sh -c '
        cd "$1" && work=$2 && shift 2
        for file; do
            case $file in
            src/report/* | src/pictures/* | src/view/* | src/drawing/* | src/command/* | src/tables/* | src/deck/*) level=-Oz ;; # what is small loads sooner
            src/results/* | src/motion/*) level=-Os ;;
            *) level=-O2 ;;
            esac
            emcc -std=c90 -pedantic-errors -Wall -Wextra -Werror $level -ffp-contract=off -Dmain=web_main -Iinclude -Isrc -I"$work/web/gsl" \
                -c "$file" -o "$work/web/objects/$(echo "${file%.c}" | tr / -).o" || exit 255
        done' sh "$source" "$work"
    libraries=$(for part in $parts; do ls web/gsl/"$part"/.libs/*.a; done)
    # shellcheck disable=SC2086
    emcc -O2 --no-entry -s STANDALONE_WASM -s ALLOW_MEMORY_GROWTH=1 -s MAXIMUM_MEMORY=1GB -s TOTAL_STACK=1MB \
        -o web/fourlink.wasm web/objects/*.o $libraries
    if grep -qF -e "$work" -e "$source" web/fourlink.wasm; then
        echo "build.sh: the page has a path of this machine: remove $work/web and begin again" >&2
        exit 1
    fi
    echo "$hash" >web/objects/done
}

# put_json FOLDER: the decks of a folder, {"NAME": "TEXT", ...}, without a "<" that could end the script.
put_json() {
    printf '{'
    comma=
    for file in "$1"/*.deck; do
        printf '%s\n"%s":"' "$comma" "${file##*/}"
        sed -e 's/[\\"]/\\&/g' -e 's/	/\\t/g' -e 's/</\\u003c/g' "$file" | awk '{printf "%s\\n", $0}'
        printf '"'
        comma=,
    done
    printf '}\n'
}

# put_manual FILE: a manual page as plain text, for an element of HTML
put_manual() {
    MANWIDTH=78 man -E UTF-8 -l "$1" >web/manual || exit 1
    col -bx <web/manual | sed -e 's/&/\&amp;/g' -e 's/</\&lt;/g'
}

# Each line of page.html that holds only @NAME@ is replaced; so are @VERSION@ and @SOURCES@.
build_page() {
    version=$(sed -n 's/^project(fourlink VERSION \([0-9.]*\).*/\1/p' "$source/CMakeLists.txt")
    hash=$(sh "$source/web/sources.sh")
    web=$source/web
    report=$source/src/report
    gzip -9n <web/fourlink.wasm | base64 -w 0 >web/fourlink.base64
    put_json "$source/data" >web/examples.json
    put_json "$source/web/templates" >web/templates.json
    put_json "$source/data/synthesis" >web/designs.json
    for manual in fourlink-deck.5 fourlink-synthesis.5 fourlink.1; do
        put_manual "$source/doc/man/$manual"
    done >web/manual.txt
    sed -e "s/@VERSION@/$version/g" -e "s/@SOURCES@/$hash/g" "$web/page.html" >web/frame.html
    while IFS= read -r line; do
        case $line in
        @REPORT_STYLE@) sh "$report/embed.sh" report.css ;;
        @STYLE@) sh "$report/embed.sh" "$web/page.css" ;;
        @REPORT_SCRIPT@) sh "$report/embed.sh" elements.js labels.js player.js cursor.js typed.js controls.js ;;
        @EXAMPLES@) cat web/examples.json ;;
        @TEMPLATES@) cat web/templates.json ;;
        @DESIGNS@) cat web/designs.json ;;
        @MANUAL@) cat web/manual.txt ;;
        @WORKER@) sh "$report/embed.sh" "$web/worker.js" ;;
        @PROGRAM@) cat web/fourlink.base64 ;;
        @SCRIPT@) for part in text editor program zoom handles tables link drawn draw questions manual files menus views main; do
            sh "$report/embed.sh" "$web/page/$part.js"
        done ;;
        *) printf '%s\n' "$line" ;;
        esac
    done <web/frame.html >web/page.html
    mv web/page.html "$page"
    wc -c "$page" web/fourlink.wasm
}

mkdir -p web
build_parts
build_program
build_page
