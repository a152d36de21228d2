#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
#
# test_interruption.sh FOURLINK DATA - a sweep ended by a signal; progress; memory.
. "$(dirname "$0")/sweeps.sh"

whole_lines() { [ "$(tail -c 1 "$1" | tr '\n' x)" = x ]; }

sweep 'crank.length = 18 mm to 22 mm in 30000000' 'output = mu_min, swing'
mkdir files
for signal in INT TERM; do
    echo old >files/result
    # what a script starts in the background ignores SIGINT
    if [ $signal = INT ] && ! env --default-signal=INT true 2>/dev/null; then
        echo 'skipped: SIGINT cannot be given its default action here'
        continue
    fi
    set -- env
    [ $signal = INT ] && set -- env --default-signal=INT
    "$@" "$fourlink" -f csv -o files/result t.deck 2>err &
    pid=$!
    sleep 0.5
    check 'a temporary file while it runs' test "$(ls -A files | wc -l)" -eq 2
    kill -$signal $pid
    (sleep 5; kill -9 $pid) 2>/dev/null &
    guard=$!
    wait $pid 2>/dev/null
    status=$?
    kill $guard 2>/dev/null
    check "ended by SIG$signal: $status" test $status -eq "$([ $signal = INT ] && echo 130 || echo 143)"
    only_file files result
    check 'the old file is untouched' test "$(cat files/result)" = old
    check 'no progress where nobody looks' none 'designs,' err

    # to a pipe that is read slowly: whole lines
    mkfifo pipe
    (sleep 1; cat) <pipe >got &
    reader=$!
    "$@" "$fourlink" -f csv t.deck >pipe 2>err &
    pid=$!
    sleep 0.5
    kill -$signal $pid
    wait $pid 2>/dev/null
    wait $reader
    rm pipe
    check 'something arrives' test "$(wc -l <got)" -gt 100
    check "the last line is whole: $(tail -n 1 got)" whole_lines got
    check 'none is left out' awk -F, 'NR > 1 && ($1 != int(NR / 2) || NF != 6) {bad = 1} END {exit bad + 0}' got
done

# statistics, and the search of the best design
for option in --statistics "--best=max swing"; do
    echo old >files/result
    "$fourlink" "$option" -o files/result t.deck 2>err &
    pid=$!
    sleep 0.5
    kill -TERM $pid
    (sleep 5; kill -9 $pid) 2>/dev/null &
    guard=$!
    wait $pid 2>/dev/null
    status=$?
    kill $guard 2>/dev/null
    check "$option, ended by SIGTERM: $status" test $status -eq 143
    only_file files result
    check 'the old file is untouched' test "$(cat files/result)" = old
    says 'stopped t.deck: interrupted'
done

# progress
if command -v script >/dev/null; then
    script -qec "timeout 2.5 '$fourlink' -f csv -o files/result t.deck" typed </dev/null >shown 2>&1
    check 'progress on a terminal' grep -q 'of 30000000 designs, 0 %' shown
    only_file files result
else
    echo 'skipped: script is not there'
fi
sweep 'crank.length = 18 mm to 22 mm in 3000' 'output = mu_min'
run 0 -f csv -o files/result t.deck
quiet

# -------------------------------------------------------------------------------------- memory

# Memory is that of one design.  (A sanitizer needs more address space than this.)
sweep 'crank.length = 18 mm to 22 mm in 100000' 'output = swing'
if (ulimit -v 65536 && "$fourlink" --version >out) 2>err; then
    check '100,000 designs in 64 MB' sh -c 'ulimit -v 65536 && exec "$0" -f csv t.deck | wc -l | grep -q "^ *200001$"' "$fourlink"
    check 'their statistics in 64 MB' sh -c 'ulimit -v 65536 && exec "$0" -f csv --statistics t.deck | grep -q "^swing,deg,open,100000,"' "$fourlink"
fi

if command -v valgrind >/dev/null && valgrind -q "$fourlink" --version >out 2>err && [ ! -s err ]; then # not all read clang's symbols
    for output in 'motion.interval = 90 deg, 120 deg' 'output = mu_min, type, max(Ts)'; do
        sweep 'crank.length = 20 mm, 300 mm, 22 mm' 'rocker.length = 56 mm +- 0.1 mm normal' 'samples = 2' "$output"
        for format in csv table; do
            valgrind -q --error-exitcode=9 --leak-check=full "$fourlink" -f $format t.deck >out 2>err
            status=$?
            check "valgrind, $format, $output: $status, $(head -n 3 err)" test $status -eq 1
        done
    done
    sweep 'crank.length = 18 mm to 22 mm step 0 mm' 'rocker.length = 56 mm +- 90 mm' 'samples = 2'
    valgrind -q --error-exitcode=9 --leak-check=full "$fourlink" t.deck >out 2>err
    check 'valgrind, mistakes' test $? -eq 2
else
    echo 'skipped: valgrind is not there, or cannot read the program'
fi

finish
