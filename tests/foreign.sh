# SPDX-License-Identifier: GPL-3.0-or-later
#
# foreign.sh - what the trials of other machines share: sourced by qemu.sh and windows.sh.  They work in a
# folder of their own; one that is named in the variable FOLDER is kept, with its libraries, for the next run.
set -eu
source=$(cd "$(dirname "$0")/.." && pwd)
if [ -n "${FOLDER-}" ]; then
    mkdir -p "$FOLDER"
    work=$(cd "$FOLDER" && pwd)
else
    work=$(mktemp -d)
    trap 'rm -rf "$work"' EXIT
fi
trap 'exit 1' HUP INT TERM
cd "$work"
passed=0
failed=0

# count STATUS WHAT: one thing was tried; what is said if it failed.
count() {
    if [ "$1" -eq 0 ]; then
        passed=$((passed + 1))
    else
        failed=$((failed + 1))
        printf 'FAILED: %s\n' "$2"
    fi
}

finish() {
    echo "$passed passed, $failed failed"
    [ "$failed" -eq 0 ]
    exit
}

# install PACKAGE...: those that are missing; this needs root.
install() {
    missing=$(for package; do dpkg -s "$package" >/dev/null 2>&1 || echo "$package"; done)
    [ -n "$missing" ] || return 0
    apt-get update
    # shellcheck disable=SC2086
    apt-get -o DPkg::Lock::Timeout=600 install -y --no-install-recommends $missing
}

# private_apt NAME: apt with lists of its own, so that the machine's stay as they are.  It reads the variables
# architecture and sources (empty: the machine's).
private_apt() {
    apt=$work/apt-$1
    mkdir -p "$apt/lists/partial" "$apt/cache/archives/partial"
    shift
    apt-get -q -q -o APT::Sandbox::User=root -o APT::Architecture="$architecture" \
        -o APT::Architectures::="$architecture" -o Dir::State::lists="$apt/lists" -o Dir::Cache="$apt/cache" \
        -o Dir::State::status=/dev/null -o Debug::NoLocking=1 ${sources:+-o Dir::Etc::sourceparts="$sources"} "$@"
}

# sources_of PACKAGE...: Debian's source packages, unpacked into PACKAGE-VERSION.
sources_of() {
    architecture=$(dpkg --print-architecture)
    sources=$work/sources
    mkdir -p "$sources"
    for package; do
        ls -d "$package"-[0-9]* >/dev/null 2>&1 && continue
        for list in /etc/apt/sources.list.d/*.sources; do
            sed 's/^Types: .*/Types: deb-src/' "$list" >"$sources/${list##*/}"
        done
        private_apt sources update || true # an index of another suite may be missing
        private_apt sources source "$package"
    done
    sources=
}

# build_gsl NAME HOST CC: GSL, static, in the folder NAME/usr.
build_gsl() {
    [ -e "$1/usr/lib/libgsl.a" ] && return
    sources_of gsl
    mkdir -p "$1/gsl"
    (
        cd "$1/gsl"
        "$work"/gsl-[0-9]*/configure --host="$2" CC="$3" CFLAGS=-O2 --disable-shared --with-pic --prefix="$work/$1/usr"
        sed -i 's/ doc$//; s/ doc / /' Makefile # its documentation is not in Debian's source
        make -j2
        make install
    ) >"$1/gsl.log" 2>&1 || { tail -n 20 "$1/gsl.log"; exit 1; }
}

# build_cmocka NAME ARGUMENT...: cmocka, static, in the folder NAME/usr, with arguments for cmake.
build_cmocka() {
    [ -e "$1/usr/lib/libcmocka.a" ] && return
    sources_of cmocka
    prefix=$work/$1/usr
    cmocka=$1/cmocka
    shift
    {
        cmake -S cmocka-[0-9]* -B "$cmocka" -DCMAKE_INSTALL_PREFIX="$prefix" -DCMAKE_INSTALL_LIBDIR=lib \
            -DWITH_STATIC_LIB=ON -DWITH_EXAMPLES=OFF "$@" && cmake --build "$cmocka" && cmake --install "$cmocka"
        cp "$cmocka"/src/libcmocka-static.a "$prefix/lib/libcmocka.a"
    } >"$cmocka.log" 2>&1 || { tail -n 20 "$cmocka.log"; exit 1; }
}

# configure NAME ARGUMENT...: prepare the folder NAME/build, with arguments for cmake.
configure() {
    name=$1
    shift
    mkdir -p "$name"
    cmake -S "$source" -B "$name/build" -DCMAKE_BUILD_TYPE=Release -DFOURLINK_WERROR=ON "$@" >"$name/build.log" 2>&1 ||
        { tail -n 20 "$name/build.log"; exit 1; }
}

# build NAME TARGET: compile fourlink, or all.
build() {
    cmake --build "$1/build" -j2 --target "$2" >>"$1/build.log" 2>&1 || { tail -n 20 "$1/build.log"; exit 1; }
}

# emulate NAME COMMAND...: put a script that runs it with COMMAND in the place of each program that was built.
emulate() {
    name=$1
    shift
    find "$name/build" -maxdepth 2 -type f -perm -u+x ! -path '*/real/*' ! -name '*.so*' ! -name '*.dll' >"$name/programs"
    while read -r program; do
        if [ "$(head -c 2 "$program")" != '#!' ]; then
            mkdir -p "${program%/*}/real"
            mv "$program" "${program%/*}/real"
            printf '#!/bin/sh\nexec %s "%s" "$@"\n' "$*" "$work/${program%/*}/real/${program##*/}" >"$program"
            chmod +x "$program"
        fi
        case $program in *.exe) ln -sf "${program##*/}" "${program%.exe}" ;; esac
    done <"$name/programs"
}

# random_decks N: so many machines in the folder random, the same on every run.
random_decks() {
    build native random_decks
    mkdir -p random
    native/build/random_decks machines "$1" random
}

# A table or a summary without the residual, which is rounding itself.
without_residual() {
    awk '
        /residual\)/ {next}
        /^# theta2 / {to = match($0, /  +(energy_)?residual/) ? RSTART : 0; from = to + RLENGTH}
        {print (to && length($0) >= to ? substr($0, 1, to - 1) substr($0, from) : $0)}'
}

# results COMMAND FOLDER: tables, summaries and csv files of all decks; NAME.integrated.csv of a motion that is computed.
results() {
    rm -rf "$2"
    mkdir -p "$2"
    for deck in "$source"/data/*.deck "$source"/tests/decks/*.deck random/*.deck; do
        to=$2/$(basename "$deck" .deck)
        { "$1" "$deck" 2>&1 </dev/null || echo "exit status $?"; } | without_residual >"$to.table"
        { "$1" --summary "$deck" 2>&1 </dev/null || echo "exit status $?"; } | without_residual >"$to.summary"
        ! grep -q '^mode ' "$deck" || to=$to.integrated
        "$1" --format=csv -i '5 deg' "$deck" >"$to.csv" 2>/dev/null </dev/null || true
    done
}

# same_text NAME FILE OTHER: of x87 the rows of a table, as its angles of extremes, and zeros, have other last digits.
same_text() {
    if [ "$1 ${2##*.}" = 'x87 table' ]; then
        grep -v '^#' "$2" >rows
        grep -v '^#' "$3" | cmp -s rows -
    else
        cmp -s "$2" "$3"
    fi
}

# compare NAME: the results of another machine with those of this one.  Summaries of x87 may differ (same_text).  The steps of
# an integration depend on rounding: its numbers may differ by 1e-9, which is its precision.
compare() {
    results "$1/build/fourlink" "$1/results"
    for file in native/results/*; do
        other=$1/results/${file##*/}
        case $file in
        *.integrated.csv) echo "${file##*/} $(python3 "$source/tests/compare.py" --csv "$file" "$other" 1e-9)" ;;
        *.csv) echo "${file##*/} $(python3 "$source/tests/compare.py" --csv "$file" "$other")" ;;
        *) echo "${file##*/} $(same_text "$1" "$file" "$other" && echo same || echo differs)" ;;
        esac
    done >"$1/compared"
    awk -v name="$1" '
        $1 !~ /csv$/ {texts++; same += $2 == "same"}
        $1 ~ /csv$/ {
            motion = $1 ~ /integrated/ ? "integrated" : "given"
            csv[motion]++
            values[motion] += $3
            if ($4 >= worst[motion]) {
                worst[motion] = $4
                where[motion] = $5 " " $6 " of " $1
            }
        }
        END {
            print name ": " same + 0 " of " texts + 0 " tables and summaries are the same"
            for (motion in csv)
                print name ": " csv[motion] " csv files of " motion " motions, " values[motion] " values, largest " \
                    "difference " worst[motion] + 0 " of the largest value of its column, " where[motion]
        }' "$1/compared"
    while read -r file answer more; do
        status=0
        [ "$answer" != differs ] || [ "$1 ${file##*.}" = 'x87 summary' ] || status=1
        count $status "$1: $file differs $more"
    done <"$1/compared"
}

# run_tests NAME PATTERN: the tests of a build, but for those of a pattern; the variable TESTS selects others.  A test that
# is skipped, because something is not installed, is none.
run_tests() {
    ctest --test-dir "$1/build" -j2 --timeout 3000 -LE '^long$' -E "$2" -R "${TESTS-.}" --output-on-failure >"$1/tests.log" 2>&1 || true
    while read -r _ _ _ name outcome; do
        status=0
        case $outcome in
        *Skipped*) echo "$1: $name is skipped" && continue ;;
        *Passed*) ;;
        *) status=1 ;;
        esac
        count $status "$1: $name"
    done <<TESTS
$(sed -n 's/^ *\([0-9]*\/[0-9]* Test  *#\)/\1/p' "$1/tests.log" | tr -s '.# ' ' ')
TESTS
    grep 'tests passed' "$1/tests.log" | sed "s/^/$1: /" || true
    grep -a -A 40 '[*][*][*]' "$1/tests.log" | grep -a -v -e '^ *Start ' -e ' Passed ' | cut -c1-300 | head -n 100 || true
}
