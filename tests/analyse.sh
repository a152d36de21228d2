#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
#
# analyse.sh - clang-tidy with the checks of .clang-tidy, and gcc's -fanalyzer, on the sources.
#
#   sh tests/analyse.sh [FILE...]
#
# Takes about 5 minutes of a processor; it uses all of them.  Findings in analyse.exceptions are left out.
# Needs clang-tidy 14 and gcc 12; others may find more.  Ends with the line
# "N passed, M failed", the files.
set -eu
cd "$(dirname "$0")/.."
[ $# -gt 0 ] || set -- src/*/*.c
for tool in clang-tidy gcc; do
    command -v $tool >/dev/null || { echo "analyse.sh: no $tool"; exit 2; }
done
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

printf '%s\n' "$@" | xargs -P "$(getconf _NPROCESSORS_ONLN)" -I '{}' sh -c '
    name=$(echo "$1" | tr / -)
    clang-tidy --quiet "$1" -- -std=c90 -Iinclude -Isrc >"$2/$name.clang" 2>"$2/$name.said" ||
        cat "$2/$name.said" >>"$2/$name.clang"
    gcc -std=c90 -O2 -fanalyzer -Iinclude -Isrc -c "$1" -o "$2/$name.o" 2>"$2/$name.gcc"' sh '{}' "$work"

# FILE:LINE:COLUMN: warning: TEXT [CHECK,...], each once
cat "$work"/*.clang "$work"/*.gcc | sed "s|^$PWD/||" | grep -E '^[^ ]+:[0-9]+:[0-9]+: (warning|error):' |
    sort -u | awk 'FNR == NR {if (!/^#/) known[$1 " " $2] = 1; next}
        {
            file = $0; sub(/:.*/, "", file)
            check = $NF; gsub(/[][]/, "", check); sub(/,.*/, "", check)
            if ((file " " check) in known) next
            print
        }' tests/analyse.exceptions - >"$work/findings"
cat "$work/findings"
failed=$(cut -d: -f1 "$work/findings" | sort -u | wc -l)
echo "$(($# - failed)) passed, $failed failed"
[ "$failed" -eq 0 ]
