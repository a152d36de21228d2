#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
#
# fuzz.sh - runs the fuzzers, each for so many seconds, from the decks of the repository and the inputs kept in
# tests/fuzz/corpus, with a fixed seed of the random numbers.
#
#   sh tests/fuzz/fuzz.sh SECONDS [BUILD [FUZZER...]]
#
# BUILD is a folder for the build (build-fuzz), which needs clang with its libFuzzer; the fuzzers are decks,
# units, library, runs and page.  With 0 seconds they only run these inputs.  In the environment: AT_ONCE, how many run
# at once (1); CORPUS, a folder in which inputs that reached something new are kept for the next run; COVERAGE=1, which
# prints how much of each folder of the sources they reach (it needs llvm-cov, and a BUILD of its own); KEEP, so many bytes
# of the inputs in CORPUS that reach most become tests/fuzz/corpus.
# Prints how much was tried, and a finding, which is kept in BUILD/findings; ends with the line
# "N passed, M failed", the fuzzers.
set -eu
seconds=$1 build=${2:-build-fuzz}
[ $# -lt 2 ] && shift || shift 2
[ $# -gt 0 ] || set -- decks units library runs page
top=$(cd "$(dirname "$0")/../.." && pwd)
fuzz=$top/tests/fuzz

cmake -S "$top" -B "$build" -DCMAKE_C_COMPILER=clang -DCMAKE_BUILD_TYPE=None -DFOURLINK_TESTS=OFF \
    -DFOURLINK_FUZZ=ON -DFOURLINK_FUZZ_COVERAGE="${COVERAGE:-OFF}" >/dev/null
cmake --build "$build" -j"${AT_ONCE:-1}" --target fuzz_words $(printf 'fuzz_%s ' "$@") >/dev/null
build=$(cd "$build" && pwd)
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
trap 'exit 1' HUP INT TERM
rm -rf "$build/findings"
mkdir -p "$build/findings" "$work/seeds/decks" "$work/seeds/units" "$work/seeds/library" "$work/seeds/runs" "$work/seeds/page"
LLVM_PROFILE_FILE=$work/words.raw "$build/tests/fuzz/fuzz_words" | sort -u >"$work/words"

# Decks as they are and, for the command and the page, lines of arguments or calls, each with the decks before it; for *,
# with all.  Units begin with all values of the decks.
cp "$top"/data/*.deck "$top"/data/synthesis/osu-*.deck "$top"/tests/decks/*.deck "$top"/doc/*.deck "$fuzz"/decks/*.deck \
    "$work/seeds/decks"
rm "$work/seeds/decks/khurmi-16.11.deck" # its motion takes two seconds here
# with_decks NAME LINES
with_decks() {
    n=0
    while IFS= read -r line; do
        given=${line%% | *} line=${line#* | }
        [ "$given" != '*' ] || given=$(cd "$work/seeds/decks" && ls | sed 's/\.deck$//')
        for deck in $given; do
            n=$((n + 1)) deck=$work/seeds/decks/$deck.deck
            {
                printf '%s\n' "$line" | awk '{gsub(/  /, "\t"); print}'
                cat "$deck"
                case $line in
                *answers*scores* | *answers*feedback*) printf '\f%s\f' 'name,id,late
a,1,2
b,2,' && sed -n '/^\[expect/,$p' "$deck" && printf '\fmu_min = 40 deg\n\fmu_min = 40\nTs == 1.5 N m\n' ;;
                *answers*) printf '\f%s\f' 'name,id,late
a,1,2
b,2,' && sed -n '/^\[expect/,$p' "$deck" && printf '\fmu_min = 40 deg\n' ;;
                *--names*) printf '\fanna\nben\nclara\n' ;;
                *--import*) printf '\fj=A,1,2,AB,R,t,0,0.1,t,%%0AB,-3,5,AB|BC,R,f,0,0.1,f,%%0AC,-11,17,BC|CD,R,f,0,0.1,f,%%0AD,1,22,CD,R,t,0,0.1,f,&l=AB,2,1,1,1,A|B&f=F,BC,1,2,3,4,t,true,5&s=10,false,false,cm' ;;
                *=y* | *=.*) printf '\f' && sed -n '/^\[expect/,$p' "$deck" ;;
                esac
            } >"$work/seeds/$1/$n"
        done
    done <"$2"
}
with_decks runs "$fuzz/commands"
with_decks page "$fuzz/calls"

# The command accepts each of these lines with each of its decks; but for the line for all, of which some have mistakes.
check_commands() {
    mkdir -p "$work/tmp"
    ACCEPTED=$work/accepted LLVM_PROFILE_FILE=$work/check.raw TMPDIR=$work/tmp "$build/tests/fuzz/fuzz_runs" -runs=0 \
        -close_fd_mask=3 "$work/seeds/runs" </dev/null >"$work/check.log" 2>&1 || { tail -n 60 "$work/check.log"; return 1; }
    for seed in "$work"/seeds/runs/*; do head -n 1 "$seed"; done | grep -vx x.deck | sort >"$work/asked"
    sort "$work/accepted" | comm -23 "$work/asked" - >"$work/refused"
    sed 's/^/refused, or out of the limits of small.c, with one of its decks: /' "$work/refused"
    [ ! -s "$work/refused" ]
}
case " $* " in *' runs '*) check_commands || echo runs >>"$work/failed" ;; esac
cat "$work"/seeds/decks/*.deck | sed -n 's/^[^#=]*= *\([^#]*[^# ]\).*/\1/p' | sort -u | head -n 400 |
    awk -v folder="$work/seeds/units" '{printf "%c%s", 65 + NR % 26, $0 >(folder "/" NR); close(folder "/" NR)}'
cp "$work"/seeds/decks/*.deck "$work/seeds/library" # any bytes do
# What is kept: an input a line, in base64.
for name; do
    [ -f "$fuzz/corpus/$name" ] || continue
    n=0
    while read -r line; do
        n=$((n + 1))
        printf %s "$line" | base64 -d >"$work/seeds/$name/kept-$n"
    done <"$fuzz/corpus/$name"
done

# libfuzzer NAME LONGEST ARGUMENT...: a slow input is a finding too.  Here all takes some thirty times as long.
libfuzzer() {
    name=$1 longest=$2
    shift 2
    mkdir -p "$work/tmp"
    hide=0 slow=200
    case $name in runs | page) hide=3 slow=400 ;; esac # a run opens its decks several times
    TMPDIR=$work/tmp LLVM_PROFILE_FILE=$work/$name.profraw "$build/tests/fuzz/fuzz_$name" -seed=1 -timeout=$slow -rss_limit_mb=2048 \
        -max_len="$longest" -dict="$work/words" -close_fd_mask=$hide -print_final_stats=1 "$@" </dev/null
}

fuzz() {
    corpus=${CORPUS:-$work}/$1
    mkdir -p "$corpus"
    [ "$seconds" -gt 0 ] && how=-max_total_time=$seconds || how=-runs=0
    libfuzzer "$1" "$2" $how -artifact_prefix="$build/findings/$1-" "$corpus" "$work/seeds/$1" >"$work/$1.log" 2>&1 && status=ok ||
        status=FAILED
    awk -v name="$1" -v status=$status '/number_of_executed_units/ {n = $2} /slowest_unit_time_sec/ {slow = $2}
        /cov: / {for (i = 1; i < NF; i++) if ($i == "cov:") cov = $(i + 1)}
        END {
            printf "%d inputs for %s, %d edges, slowest %d s%s\n", n, name, cov, slow, status == "ok" ? "" : ": " status
        }' "$work/$1.log"
    [ $status = ok ] && return
    grep -a -v '^#' "$work/$1.log" | tail -n 60
    for finding in "$build/findings/$1-"*; do
        [ ! -f "$finding" ] || { echo "$finding, in base64:"; base64 "$finding"; }
    done
    echo "$1" >>"$work/failed"
}

# keep NAME LONGEST: of the inputs in CORPUS those that reach most beyond the seeds, for their length, up to KEEP bytes
keep() {
    libfuzzer "$1" "$2" -merge=1 -merge_control_file="$work/$1.control" "$work/seeds/$1" "$CORPUS/$1" >"$work/$1.log" 2>&1
    mkdir -p "$fuzz/corpus"
    awk -v seeds="$work/seeds/$1/" -v most="$KEEP" '
        NR > 2 && !/^(STARTED|FT|COV) / {name[files++] = $0; next}
        $1 == "STARTED" {size[$2] = $3}
        $1 == "COV" {id = $2; $1 = $2 = ""; reached[id] = $0}
        END {
            for (id = 0; id < files; id++)
                if (index(name[id], seeds) == 1 && name[id] !~ /\/kept-[0-9]*$/) {n = split(reached[id], part); for (i = 1; i <= n; i++) old[part[i]]}
            for (;;) {
                best = 0
                for (id in reached) {
                    n = split(reached[id], part); new = 0
                    for (i = 1; i <= n; i++) new += !(part[i] in old)
                    if (!new) delete reached[id]
                    else if (new / (size[id] + 100) > best) {best = new / (size[id] + 100); chosen = id}
                }
                if (!best || (total += size[chosen]) > most) exit
                print name[chosen]
                n = split(reached[chosen], part); for (i = 1; i <= n; i++) old[part[i]]
            }
        }' "$work/$1.control" | while IFS= read -r file; do base64 -w 0 "$file" && echo; done >"$work/kept"
    mv "$work/kept" "$fuzz/corpus/$1"
    echo "$1: $(wc -l <"$fuzz/corpus/$1") inputs kept"
}

longest_of() { case $1 in decks | runs | page) echo 4096 ;; units) echo 200 ;; *) echo 1024 ;; esac }

running=0
for name in "$@"; do
    fuzz "$name" "$(longest_of "$name")" &
    running=$((running + 1))
    [ $running -lt "${AT_ONCE:-1}" ] || { wait; running=0; }
done
wait
if [ -n "${COVERAGE-}" ]; then
    llvm-profdata merge -o "$work/profile" "$work"/*.profraw
    # shellcheck disable=SC2046
    llvm-cov export -summary-only -instr-profile "$work/profile" $(printf -- "-object $build/tests/fuzz/fuzz_%s " "$@") |
        grep -o '"filename":"[^"]*","summary":{[^}]*}[^}]*}[^}]*}[^}]*}' | sed -nE 's#"filename":"[^"]*/((src|web)/)#"filename":"\1#p' | awk -F'"' '
            {folder = $4; sub("/[^/]*$", "", folder); match($0, /"lines":[{][^}]*/); n = split(substr($0, RSTART, RLENGTH), part, /[:,]/)
                all[folder] += part[3]; reached[folder] += part[5]}
            END {for (folder in all) printf "reached of %s: %d of %d lines, %.0f %%\n", folder, reached[folder], all[folder], 100 * reached[folder] / all[folder]}' | sort
fi
if [ -n "${KEEP-}" ]; then
    for name; do keep "$name" "$(longest_of "$name")"; done
fi
failed=$(sort -u "$work/failed" 2>/dev/null | wc -l)
echo "$(($# - failed)) passed, $failed failed"
[ "$failed" -eq 0 ]
