#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
#
# rounding.sh FOURLINK CHECK_SAMPLE DECK... - no number in an answer of --at, or in a sample calculation, is rounding error: none
# is below 1e-13 of the size of its quantity in its row, which follows from the crank's length, the speeds and the largest
# force, unless it is 0.  Of each deck, rows at three crank angles and where a column is 0, and the sample calculation at
# one.  CHECK_SAMPLE is check_sample of the build.
set -u
fourlink=$1 check_sample=$2
shift 2
work=$(mktemp -d) || exit 1
trap 'rm -rf "$work"' EXIT
trap 'exit 1' HUP INT TERM
n=0 samples=0 wrong=0
for deck; do
    length=$("$fourlink" -f csv --units=SI -c crank.length "$deck" 2>"$work/err" | tail -n 1 | tr -d '\r' | cut -d, -f3)
    # crank angles of rows; by time there is no --at for columns
    at=$("$fourlink" -f csv -c theta2,omega2 "$deck" 2>"$work/err" | tr -d '\r' |
        awk -F, 'NR > 1 && $NF == "ok" {angle[n++] = $2} END {if (n) print angle[int(n / 7)] "," angle[int(n / 2)] "," angle[int(n * 0.9)]}')
    [ "$at" ] || continue
    for list in "$at" 'alpha4 = 0' 'a = 0' 'Ts = 0' 'F34y = 0'; do
        "$fourlink" -f csv --units=SI -c all --at="$list" "$deck" 2>"$work/err" | tr -d '\r' >"$work/rows"
        awk -F, -v length_of_crank="$length" -v deck="$deck" '
            function magnitude(x) {return x < 0 ? -x : x}
            NR == 1 {
                for (i = 2; i < NF; i++) {
                    unit[i] = name[i] = $i
                    sub(/ \(.*/, "", name[i]); sub(/.*\(/, "", unit[i]); sub(/\).*/, "", unit[i])
                }
                next
            }
            $NF != "ok" {next}
            {
                speed = acceleration = force = 0
                for (i = 2; i < NF; i++) {
                    x = magnitude($i)
                    if (x == "inf") continue
                    if (name[i] ~ /^omega/ && x > speed) speed = x
                    if (name[i] ~ /^alpha[234]$/ && x > acceleration) acceleration = x
                    if (unit[i] == "N" && name[i] !~ /^klein/ && x > force) force = x
                }
                if (speed * speed > acceleration) acceleration = speed * speed
                size["m"] = length_of_crank; size["rad"] = 1
                size["rad/s"] = speed; size["rad/s2"] = acceleration
                size["m/s"] = length_of_crank * speed; size["m/s2"] = length_of_crank * acceleration
                size["N"] = force; size["N.m"] = force * length_of_crank; size["W"] = force * length_of_crank * speed
                for (i = 2; i < NF; i++)
                    if (name[i] != "theta2" && magnitude($i) > 0 && magnitude($i) < 1e-13 * size[unit[i]]) {
                        print deck ": " name[i] " = " $i " " unit[i] " is rounding error"
                        bad = 1
                    }
                rows++
            }
            END {print rows + 0 > "/dev/stderr"; exit bad}' "$work/rows" 2>"$work/count" || wrong=$((wrong + 1))
        n=$((n + $(cat "$work/count")))
    done
    "$fourlink" --report="$work/r.html" --branch=open --plot-at="${at%%,*}" "$deck" >"$work/out" 2>"$work/err"
    [ $? -le 1 ] || continue
    if "$check_sample" "$work/r.html" >"$work/out"; then
        samples=$((samples + 1))
    elif ! grep -q 'no equations' "$work/out"; then
        echo "$deck: $(head -n 3 "$work/out")"
        wrong=$((wrong + 1))
    fi
done
echo "$n rows, $samples sample calculations, wrong: $wrong"
[ $n -gt 0 ] && [ $samples -gt 0 ] && [ $wrong -eq 0 ]
