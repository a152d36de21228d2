#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
#
# fuzz.sh - runs the fuzzers, each for so many seconds, from the decks of the repository, with a fixed seed of
# the random numbers.
#
#   sh tests/fuzz/fuzz.sh SECONDS [BUILD [FUZZER...]]
#
# BUILD is a folder for the build (build-fuzz), which needs clang with its libFuzzer; the fuzzers are decks,
# units, library and runs.  AT_ONCE in the environment is how many run at once (1).  CORPUS is a folder in which
# inputs that reached something new are kept for the next run; without it each run begins with the seeds alone.
# Prints how much was tried, and a finding, which is kept in BUILD/findings; ends with the line
# "N passed, M failed", the fuzzers.
set -eu
seconds=$1 build=${2:-build-fuzz}
[ $# -lt 2 ] && shift || shift 2
[ $# -gt 0 ] || set -- decks units library runs
top=$(cd "$(dirname "$0")/../.." && pwd)

cmake -S "$top" -B "$build" -DCMAKE_C_COMPILER=clang -DCMAKE_BUILD_TYPE=None -DFOURLINK_TESTS=OFF \
    -DFOURLINK_FUZZ=ON >/dev/null
cmake --build "$build" --target fuzz_words $(printf 'fuzz_%s ' "$@") >/dev/null
build=$(cd "$build" && pwd)
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
trap 'exit 1' HUP INT TERM
rm -rf "$build/findings"
mkdir -p "$build/findings" "$work/seeds/decks" "$work/seeds/units" "$work/seeds/library" "$work/seeds/runs"
"$build/tests/fuzz/fuzz_words" >"$work/words"

# Decks as they are and, for the command, each command line with decks in turn.  Units begin with all values of
# the decks.
cp "$top"/data/*.deck "$top"/data/synthesis/osu-*.deck "$top"/tests/decks/*.deck "$top"/doc/*.deck "$top"/tests/fuzz/decks/*.deck \
    "$work/seeds/decks"
n=0
while read -r line; do
    for deck in "$work"/seeds/decks/*.deck; do
        n=$((n + 1))
        [ $((n % 5)) -eq 0 ] || continue # every command line with some of them
        { printf '%s\n' "$line" | awk '{gsub(/  /, "\t"); print}'; cat "$deck"; } >"$work/seeds/runs/$n"
    done
done <"$top/tests/fuzz/commands"
cat "$work"/seeds/decks/*.deck | sed -n 's/^[^#=]*= *\([^#]*[^# ]\).*/\1/p' | sort -u | head -n 400 |
    awk -v folder="$work/seeds/units" '{printf "%c%s", 65 + NR % 26, $0 >(folder "/" NR); close(folder "/" NR)}'
cp "$work"/seeds/decks/*.deck "$work/seeds/library" # any bytes do

# fuzz NAME LONGEST: a slow input is a finding too.
fuzz() {
    corpus=${CORPUS:-$work}/$1
    mkdir -p "$corpus" "$work/tmp"
    hide=0 slow=60
    [ "$1" = runs ] && hide=3 slow=180 # a run opens its decks several times
    TMPDIR=$work/tmp "$build/tests/fuzz/fuzz_$1" -seed=1 -max_total_time="$seconds" -timeout=$slow -rss_limit_mb=2048 \
        -max_len="$2" -dict="$work/words" -close_fd_mask=$hide -print_final_stats=1 \
        -artifact_prefix="$build/findings/$1-" "$corpus" "$work/seeds/$1" >"$work/$1.log" 2>&1 </dev/null &&
        status=ok || status=FAILED
    awk -v name="$1" -v status=$status '/number_of_executed_units/ {n = $2} /slowest_unit_time_sec/ {slow = $2}
        /cov: / {for (i = 1; i < NF; i++) if ($i == "cov:") cov = $(i + 1)}
        END {printf "%s: %d executions, %d edges, slowest %d s: %s\n", name, n, cov, slow, status}' "$work/$1.log"
    [ $status = ok ] && return
    grep -a -v '^#' "$work/$1.log" | tail -n 60
    for finding in "$build/findings/$1-"*; do
        [ ! -f "$finding" ] || { echo "$finding, in base64:"; base64 "$finding"; }
    done
    echo "$1" >>"$work/failed"
}

running=0
for name in "$@"; do
    case $name in decks) longest=4096 ;; runs) longest=4096 ;; units) longest=200 ;; *) longest=1024 ;; esac
    fuzz "$name" $longest &
    running=$((running + 1))
    [ $running -lt "${AT_ONCE:-1}" ] || { wait; running=0; }
done
wait
failed=$(sort -u "$work/failed" 2>/dev/null | wc -l)
echo "$(($# - failed)) passed, $failed failed"
[ "$failed" -eq 0 ]
