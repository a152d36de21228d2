#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
#
# mutate.sh FILE... - do the tests notice small faults?  Puts faults into each FILE of src/, one at a time: another
# operator, another constant, a statement less.  Builds, runs the tests of the file's folder, and prints the faults that
# no test noticed.  A fault that does not compile, or that leaves the machine code as it is, is none and not counted.
#
# The variables FAULTS (5 for each file), SEED (1) of their choice, and FOLDER, which keeps the build for the next run.
# It needs what the build needs, Ninja, Python's venv and pip, which installs universalmutator, and node for JavaScript.
set -eu
[ $# -gt 0 ] || { echo 'usage: mutate.sh FILE...' >&2 && exit 2; }
source=$(cd "$(dirname "$0")/.." && pwd)
faults=${FAULTS:-5} seed=${SEED:-1}
if [ "${FOLDER-}" ]; then
    mkdir -p "$FOLDER"
    work=$(cd "$FOLDER" && pwd)
else
    work=$(mktemp -d)
    trap 'rm -rf "$work"' EXIT
fi
trap 'exit 1' HUP INT TERM

cd "$source"
for file; do
    case $file in src/*.c | src/*.js) [ -f "$file" ] && continue ;; esac
    echo "mutate.sh: $file: a file src/*/*.c or src/*/*.js is expected" >&2 && exit 2
done
rm -rf "$work/tree" "$work/faults"
mkdir -p "$work/tree" "$work/faults"
git ls-files -z | xargs -0 cp --parents -t "$work/tree"
[ -x "$work/python/bin/mutate" ] || {
    python3 -m venv "$work/python" && "$work/python/bin/pip" -q install universalmutator
}

# No debug information: a line that moves would change it.
cmake -S "$work/tree" -B "$work/build" -G Ninja -DCMAKE_BUILD_TYPE=None -DCMAKE_C_FLAGS=-O1 >"$work/log"
# build: the program, from the tree with its fault; a script of the report is embedded first
build() {
    sh "$work/tree/src/report/embed.sh" >"$work/assets.c" 2>"$work/log" &&
        { cmp -s "$work/assets.c" "$work/tree/src/report/assets.c" || cp "$work/assets.c" "$work/tree/src/report/assets.c"; } &&
        cmake --build "$work/build" -j"$(nproc)" >"$work/log" 2>&1
}
build || { tail "$work/log" && exit 1; }

# labels FILE: of the tests that belong to it
labels() {
    case $1 in
    src/drawing/* | src/pictures/*) echo '^(pictures|report)$' ;;
    src/report/*) echo '^report$' ;;
    src/view/*) echo '^(tables|pictures|report)$' ;;
    src/tables/*) echo '^(tables|report|command)$' ;;
    src/command/*) echo '^(command|tables|pictures)$' ;;
    *) echo '^(base|mechanics|synthesis|deck|results|tables)$' ;;
    esac
}
# one at a time: in parallel ctest would begin with the slowest
tests_pass() {
    run_tests -L "$(labels "$1")" || return 1
    case $1 in
    *.js) run_tests -C long -R '^test_browser$' ;;
    src/drawing/* | src/pictures/* | src/view/*) run_tests -C long -R '^drawn$' ;;
    esac
}
run_tests() { ctest --test-dir "$work/build" --stop-on-failure --timeout 200 "$@" >"$work/tests.txt" 2>&1; }
well_formed() { case $1 in *.js) node --check "$1" 2>"$work/log" ;; esac }

all_tried=0 all_killed=0 passed=
STOP_AT_FAILURE=1
export STOP_AT_FAILURE
for file; do
    cp "$file" "$work/unchanged"
    case " $passed " in
    *" $(labels "$file") "*) ;;
    *)
        tests_pass "$file" || { cat "$work/tests.txt" && echo "mutate.sh: the tests of $file fail without a fault" && exit 1; }
        passed="$passed $(labels "$file")"
        ;;
    esac
    build
    cp "$work/build/fourlink" "$work/program"
    mkdir -p "$work/faults/$file"
    "$work/python/bin/mutate" "$file" --noCheck --mutantDir "$work/faults/$file" >"$work/log"
    tried=0 killed=0
    for fault in $(python3 -c 'import pathlib, random, sys
faults = sorted(map(str, pathlib.Path(sys.argv[1]).iterdir()))
random.Random(int(sys.argv[2])).shuffle(faults)
print(*faults, sep="\n")' "$work/faults/$file" "$seed"); do
        [ $tried -lt "$faults" ] || break
        cp "$fault" "$work/tree/$file"
        well_formed "$work/tree/$file" && build || continue
        ! cmp -s "$work/build/fourlink" "$work/program" || continue
        tried=$((tried + 1))
        if tests_pass "$file"; then
            echo "survived: $file"
            diff "$work/unchanged" "$fault" || true
        else
            killed=$((killed + 1))
            echo "killed: $file:$(diff "$work/unchanged" "$fault" | head -n 1) by $(sed -n 's/.*[0-9] - \(.*\) (.*/\1/p' "$work/tests.txt" | tr '\n' ' ')"
        fi
    done
    cp "$work/unchanged" "$work/tree/$file"
    build
    echo "$file: $tried tried, $killed killed"
    all_tried=$((all_tried + tried)) all_killed=$((all_killed + killed))
done
echo "all: $all_tried tried, $all_killed killed, $((all_tried - all_killed)) survived"
