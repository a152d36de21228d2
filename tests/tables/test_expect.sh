#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
#
# test_expect.sh FOURLINK DATA - --expect: answers from a deck, which --check confirms.
. "$(dirname "$0")/../harness.sh"

# every deck agrees with its own answers, and has one for each column but the crank angle
for deck in "$data"/*.deck; do
    run 0 --expect "$deck"
    quiet
    mv out answers
    run 0 --check=answers "$deck"
    quiet
    holds "answers of $deck" '/^ok / {n++} /^[a-z]/ && !/^ok / {bad = 1} END {exit bad || !n}'
done

run 0 --expect -b open -c theta2,theta4,Ts,time,residual --at='30 deg, 1 rad' "$matrix"
quiet
grep -v '^#' out >sections
cat >expected <<'ANSWERS'

[expect]
at = 30 deg
branch = open
theta4 = 104 deg
Ts = 0.081 N.m

[expect]
at = 57.2957795130823 deg
branch = open
theta4 = 105 deg
Ts = -0.049 N.m
ANSWERS
same sections expected
cp out answers
run 0 --check=answers "$matrix"
run 1 --check=answers -s 'coupler.length=68 mm' "$matrix"
run 0 --check=answers -s 'coupler.length=66.002 mm' "$matrix"

# the last digit is 0.05 to 0.5 per cent of the column's largest value, whatever its unit
for unit in 'N' 'kN' 'MN'; do
    run 0 --expect -c F12 -s "units.force=$unit" -s 'load Tl.torque=-500 N m' "$matrix"
    mv out answers
    run 0 -f csv -c F12 -s "units.force=$unit" -s 'load Tl.torque=-500 N m' "$matrix"
    check "digits of F12 in $unit" awk -F'[ ,]' '
        NR == FNR {if ($1 == "F12") {digit = $3; sub(/e.*/, "", digit); e = $3; if (!sub(/.*e/, "", e)) e = 0
                       digit = index(digit, ".") ? length(digit) - index(digit, ".") : 0
                       half[10 ^ (e - digit) / 2]}; next}
        $1 == "open" || $1 == "crossed" {if ($2 > most) most = $2}
        END {for (h in half) {n++; if (h + 0 > 0.005 * most || h + 0 < 0.0005 * most * 0.999) bad = 1} exit bad || n != 1}' answers out
done

# a row that is not reached is a comment; the end of a revolution is its beginning
run 1 --expect "$decks/reach.deck"
check 'the reason' grep -q '^# at .*: cannot be assembled: ' out
run 0 --expect -i '90 deg' -b open "$matrix"
check 'four rows' test "$(grep -c '^at = ' out)" -eq 4
run 0 --expect -i '90 deg' -b open -s motion.acceleration=1 "$matrix"
check 'five rows of an accelerated crank' test "$(grep -c '^at = ' out)" -eq 5

# what is refused
run 2 --expect --at='30 deg, 5 mm' "$matrix"
nothing
says "--at: error: '5 mm' is a length; expected an angle"
run 2 --expect --at='30 deg,,40 deg' "$matrix"
nothing
says '--at: error: '
run 2 --expect --at='30,5 deg' -s motion.to=20 "$matrix"
says '--at: error: the motion does not reach theta2 = 30'
usage '--at chooses rows of a table, csv, json or --expect' --at='30 deg' --summary "$matrix"
usage '--expect takes one deck' --expect "$matrix" "$alvi"
usage 'use only one of' --expect --check "$matrix"
usage '--expect can be printed as table only' --expect -f csv "$matrix"
usage '--expect takes no value' --expect=5 "$matrix"
run 2 --expect -c theta5 "$matrix"
nothing
says "theta5"

# Rows by time: a machine that swings back passes a crank angle more than once, so the values are at times; and torques
# that are rounding error are 0.
cat >swing.deck <<'END'
mechanism = four-bar
[ground]
length = 80 mm
[crank]
length = 20 mm
mass = 1 kg
uniform = yes
[coupler]
length = 66 mm
[rocker]
length = 56 mm
[motion]
mode = free
speed = 10 rad/s
rows = time
time_step = 50 ms
duration = 1 s
END
for speed in 1 4 10 -7 25; do
    for step in 50 31.25; do
        run 0 --expect --set="motion.speed = $speed rad/s" --set="motion.time_step = $step ms" swing.deck
        mv out swing.expect
        check 'no exponents of rounding error' none 'e-1[0-9]' swing.expect
        run 0 --check=swing.expect --set="motion.speed = $speed rad/s" --set="motion.time_step = $step ms" swing.deck
        check 'nothing differs' none '^differs' out
    done
done
# at a time it is the row of that time, whatever was passed before
run 0 -f csv -b open -c time,theta4 swing.deck
row=$(sed -n 12p out)
printf '[expect]\nat = %s s\nbranch = open\ntheta4 = %s deg\n' "$(echo "$row" | cut -d, -f2)" "$(echo "$row" | cut -d, -f3)" >one.expect
run 0 --check=one.expect swing.deck
prints 'ok: 1,'
printf '[expect]\nat = 2 s\ntheta4 = 1 deg\n' >late.expect
run 2 --check=late.expect swing.deck
says 'no value at 2 s, open: the motion ends before'
printf '[expect]\nat = 0.1 s\ntheta4 = 1 deg\n' >time.expect
run 2 --check=time.expect "$alvi"
says 'a time is for rows by time: expected a crank angle, such as 40 deg'

finish
