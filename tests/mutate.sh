#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
#
# mutate.sh [N [SEED [FOLDER...]]] - do the tests notice small faults?  Puts N faults (40) into the sources of src/, evenly over the
# folders, or over those that are named: another operator, constant, sign or variable, x for y, min for max, arguments swapped, a statement less.  SEED
# is the commit's, unless given.  Then it runs, for each fault, the tests that reach it, first those of ctest, and with
# LONG=1 the long trials too.  faults.py says how.
#
# With SURVIVORS=FILE, out.json of an earlier run's folder, it puts in again those that survived in it.
#
# Prints the faults, those without effect left out, and a table by folder.  Survivors are expected to stand in faults.txt,
# with a reason each.  Fails if one has none.  FOLDER keeps the work.  For Debian, with what the build needs, Ninja and
# python3-clang.
set -eu
source=$(cd "$(dirname "$0")/.." && pwd)
n=${1:-40}
seed=${2:-$(git -C "$source" rev-parse HEAD)}
[ $# -lt 2 ] || shift
[ $# -lt 1 ] || shift
if [ "${FOLDER-}" ]; then
    mkdir -p "$FOLDER"
    work=$(cd "$FOLDER" && pwd)
else
    work=$(mktemp -d)
    trap 'rm -rf "$work"' EXIT
fi
trap 'exit 1' HUP INT TERM
faults() { /usr/bin/python3 "$source/tests/faults.py" "$@"; } # Debian's, which has python3-clang

cd "$source"
rm -rf "$work/tree"
mkdir -p "$work/tree"
git ls-files -z | xargs -0 cp --parents -t "$work/tree"
if [ "${SURVIVORS-}" ]; then
    faults again "$work/tree" "$SURVIVORS" "$work/list.json" "$@"
else
    echo "seed $seed"
    faults put "$work/tree" "$n" "$seed" "$work/list.json" "$@"
fi
{
    cmake -S "$work/tree" -B "$work/build" -G Ninja -DCMAKE_BUILD_TYPE=None -DCMAKE_C_FLAGS='-O1 -w' \
        -DFOURLINK_STANDARD=gnu11 && cmake --build "$work/build"
} >"$work/log" 2>&1 || { tail "$work/log" && exit 1; }
faults run "$work/build" "$work/list.json" "$work/out.json"
[ -z "${LONG-}" ] || faults run "$work/build" "$work/list.json" "$work/out.json" long
status=0
faults table "$source" "$work/out.json" "$source/tests/faults.txt" || status=1
# with SCRIPTS=N, N faults in scripts too; for Debian with nodejs and node-acorn
if [ "${SCRIPTS-}" ]; then
    faults scripts "$work/tree" "$work/build" "$SCRIPTS" "$seed" "$work/scripts.json"
    faults table "$source" "$work/scripts.json" "$source/tests/faults.txt" || status=1
fi
exit $status
