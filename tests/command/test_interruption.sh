#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
#
# test_interruption.sh FOURLINK DATA INT|TERM - a sweep ended by this signal.
. "$(dirname "$0")/sweeps.sh"
signal=$3
# what a script starts in the background ignores SIGINT
if ! env --default-signal=$signal true 2>/dev/null; then
    echo 'skipped: env has no --default-signal (Debian: coreutils)'
    exit 77
fi

[ $signal = INT ] && expected=130 || expected=143
whole_lines() { [ "$(tail -c 1 "$1" | tr '\n' x)" = x ]; }

# interrupted ARGUMENT...: the sweep, ended while it computes, leaves the old output as it was
interrupted() {
    echo old >files/result
    env --default-signal=$signal "$fourlink" "$@" -o files/result t.deck 2>err &
    pid=$!
    tries=0
    while [ "$(ls -A files | wc -l)" -lt 2 ] && [ $tries -lt 100 ]; do
        sleep 0.05
        tries=$((tries + 1))
    done
    sleep 0.1
    check "$*: a temporary file while it runs" test "$(ls -A files | wc -l)" -eq 2
    kill -$signal $pid
    (sleep 5; kill -9 $pid) >/dev/null 2>&1 &
    guard=$!
    wait $pid 2>/dev/null
    status=$?
    kill $guard 2>/dev/null
    check "$*, ended by SIG$signal: $status" test $status -eq "$expected"
    only_file files result
    check 'the old file is untouched' test "$(cat files/result)" = old
}

sweep 'crank.length = 18 mm to 22 mm in 30000000' 'output = mu_min, swing'
mkdir files
interrupted -f csv
check 'it is no part' none 'this part' err
interrupted -f csv --part=1/2
says 'stopped t.deck: interrupted; run this part again'
check 'no progress where nobody looks' none 'designs,' err

# to a pipe that is read slowly: whole lines
mkfifo pipe
(sleep 1; cat) <pipe >got &
reader=$!
env --default-signal=$signal "$fourlink" -f csv t.deck >pipe 2>err &
pid=$!
sleep 0.5
kill -$signal $pid
wait $pid 2>/dev/null
wait $reader
rm pipe
check 'something arrives' test "$(wc -l <got)" -gt 100
check "the last line is whole: $(tail -n 1 got)" whole_lines got
check 'none is left out' awk -F, 'NR > 1 && ($1 != int(NR / 2) || NF != 6) {bad = 1} END {exit bad + 0}' got

# the search of the best design
interrupted "--best=max swing"
says 'stopped t.deck: interrupted'
check 'there is no part to run again' none 'this part' err

finish
