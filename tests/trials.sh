#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
#
# trials.sh WHEN [TRIAL...] - runs the trials of trials.txt, or those named: WHEN is `ci`, a case of each that needs nothing
# but this machine; `short`, a case of each; `night`, as many as a night has time for.  `trials.sh check` runs none: it fails
# if a file of tests/ is run by nothing.
#
# The environment: FOLDER, which is kept with the builds and logs; BUILD, a folder with all programs of the tests, built
# anew without it; EVIDENCE, a file of results that gets a line for each trial (evidence.sh).  A trial that is skipped, or
# takes longer than its limit, has failed.  Ends in a line "N passed, M failed", the trials.
[ "${1-}" != check ] || unset FOLDER # that of a run of trials is theirs
. "$(dirname "$0")/foreign.sh"
tests=$source/tests
list=$tests/trials.txt

# lines PROGRAM: awk over the list, which has the name of the trial in `name`, fields of an indented line in $1...
lines() { LC_ALL=C awk '/^#/ || /^ *$/ {next} /^[^ ]/ {name = $1; sub(/:$/, "", name)} '"$1" "$list"; }
# command_of NAME WHEN: its limit in seconds and its command; a short one is that of CI, unless it has its own
command_of() {
    lines '/^ / && name == "'"$1"'" {when = $1; $1 = ""; commands[when] = substr($0, 2)}
        END {print "'"$2"'" == "short" && !("short" in commands) ? commands["ci"] : commands["'"$2"'"]}'
}

# ------------------------------------------------------------------------------------------------ check

# names FILE...: the words of files that may name another, without comments; in CMake's lists a name may have no end, and
# folders are no names
names() {
    sed -e 's,^ *#[^i].*,,' -e 's,^\*\*.*,,' -e 's,^ *[*/][*/].*,,' -e 's, # .*,,' -e 's/add_fuzzer(\([a-z]*\)/& fuzz_\1/' \
        -e 's/^\(import\|from\) \([a-z_]*\).*/&\n\2.py/' "$@" | tr -cs 'A-Za-z0-9_.-' '\n' | sort -u
}
# A file is run if CMake's lists, the list of trials or CI names it, or a file that is run does.
check_files() {
    cd "$source"
    find tests -type f | grep -E '\.(sh|py|js|awk|c|cpp|f|f90)$' | sort >"$work/waiting"
    find tests packages -name CMakeLists.txt -exec cat '{}' + >"$work/lists"
    ci=
    [ ! -f .ci/run ] || ci=.ci/run # an archive of the sources has none
    names "$work/lists" $ci tests/trials.txt tests/nightly.sh >"$work/words"
    echo nightly.sh >>"$work/words"
    (cd tests && ls -d */ | tr -d /) >"$work/folders"
    names "$work/lists" | grep -vxFf "$work/folders" | sed 's/.*/&.c\n&.sh/' >>"$work/words"
    while [ -s "$work/words" ]; do
        : >"$work/still"
        : >"$work/more"
        while read -r file; do
            if grep -qxF -e "${file##*/}" "$work/words"; then
                names "$file" >>"$work/more"
            else
                echo "$file" >>"$work/still"
            fi
        done <"$work/waiting"
        mv "$work/still" "$work/waiting"
        mv "$work/more" "$work/words"
    done
    while read -r file; do
        count 1 "nothing runs $file: it belongs into tests/trials.txt or tests/CMakeLists.txt"
    done <"$work/waiting"
    count 0 files
}

# Each trial has a command for the night, and one for CI or what CI does not have; what the commands name is there.
check_list() {
    lines '
        function check() {if (name_before && !(night && (ci || needs))) print name_before ": no `night`, or neither `ci` nor `needs`"}
        /^[^ ]/ {check(); name_before = name; night = ci = needs = 0}
        $1 == "night" {night = 1}
        $1 == "ci" {ci = 1}
        $1 == "needs" {needs = /^ *needs (PyPI|another release|another machine|nothing: )/}
        /^ / && $1 !~ /^(ci|short|night|needs|tells)$/ {print name ": " $1 " is not known"}
        END {check()}' >"$work/mistakes"
    grep -o '\$tests/[A-Za-z0-9_./-]*' "$list" | sort -u | while read -r path; do
        [ -e "$tests${path#?tests}" ] || echo "$path is not there"
    done >>"$work/mistakes"
    while read -r mistake; do
        count 1 "tests/trials.txt: $mistake"
    done <"$work/mistakes"
    count 0 list
}

# -------------------------------------------------------------------------------------------------- run

make_build() {
    BUILD=$work/build
    cmake -S "$source" -B "$BUILD" -DCMAKE_BUILD_TYPE=Release >build.txt 2>&1 &&
        cmake --build "$BUILD" -j"$(nproc)" >>build.txt 2>&1 || { tail -n 20 build.txt; exit 1; }
}

# run NAME WHEN
run() {
    command=$(command_of "$1" "$2")
    [ -n "$command" ] || return 0
    limit=${command%% *}
    command=${command#* }
    pattern=$(lines '/^ / && name == "'"$1"'" && $1 == "tells" {sub(/^ *tells /, ""); print}')
    mkdir -p "run/$1"
    start=$(date +%s)
    status=0
    (cd "run/$1" && exec timeout -k 10 "$limit" sh -c "$command") >"$1.txt" 2>&1 </dev/null || status=$?
    seconds=$(($(date +%s) - start))
    reason="exit status $status"
    [ $status -ne 124 ] || reason="more than $limit s"
    if grep -q '^skipped' "$1.txt"; then
        status=77
        reason='a part is skipped'
    fi
    {
        grep -E '^[0-9]+ passed, [0-9]+ failed' "$1.txt" | tail -n 1
        [ -z "$pattern" ] || grep -aE "$pattern" "$1.txt"
    } | awk '!seen[$0]++' | tr -s ' ' >said
    if [ $status -eq 0 ] && [ -n "$pattern" ] && ! grep -qaE "$pattern" "$1.txt"; then
        status=1
        reason='none of its lines is what the list says that it tells'
    fi
    echo "$1 ($seconds s): $(paste -sd';' said)"
    [ $status -eq 0 ] || tail -n 40 "$1.txt" | sed 's/^/    /'
    count $status "$1: $reason; the log is $work/$1.txt"
    [ -z "${EVIDENCE-}" ] || sh "$tests/evidence.sh" record "$EVIDENCE" "$1" "$2" $status $seconds said
}

when=${1-}
case $when in
check)
    check_files
    check_list
    finish
    ;;
ci | short | night) shift ;;
*) echo 'usage: trials.sh ci|short|night|check [TRIAL...]' >&2 && exit 2 ;;
esac
all=$(lines '/^[^ ]/ {print name}')
for name; do
    echo "$all" | grep -qx "$name" || { echo "trials.sh: no trial $name in trials.txt" >&2 && exit 2; }
done
# shellcheck disable=SC2086
[ $# -gt 0 ] || set -- $all
case ${BUILD-} in '') make_build ;; /*) ;; *) echo 'trials.sh: BUILD must begin with /' >&2 && exit 2 ;; esac
build=$BUILD data=$source/data
export source tests build data work
for name; do
    run "$name" "$when"
done
finish
