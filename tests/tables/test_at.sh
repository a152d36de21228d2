#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
#
# test_at.sh FOURLINK DATA - rows at crank angles that are asked for, and where a column has a value.
. "$(dirname "$0")/../harness.sh"

rocker=$data/alvi-5.1.deck
columns=theta2,theta4,omega4

run 0 --at='theta4 = 120 deg' -f csv -b open -c $columns "$rocker"
check 'two crank angles' awk -F, 'NR > 1 {n++; d = $3 - 120; if (d * d > 1e-20) bad++} END {exit bad || n != 2}' out
run 0 --at='theta4 = 120' -c $columns "$rocker"
check 'the crank angle has digits' grep -q '^ *110\.[0-9][0-9]* *120\.000 ' out
prints '# theta4 = 120: at no crank angle of this branch' # the crossed one

# items in their order, each in that of the motion; angles in any unit
run 0 --at='1 rad, omega4 = 0, theta2 = 40 deg' -f csv -b open -c $columns "$rocker"
check 'four rows' awk -F, '
    NR == 2 {bad += ($2 - 57.295779513082) ^ 2 > 1e-20}
    NR == 3 || NR == 4 {bad += $4 ^ 2 > 1e-18 || $2 < last; last = $2}
    NR == 5 {bad += $2 != 40}
    END {exit bad || NR != 5}' out

run 0 --at='theta4 = 500 deg, theta4 = 10 deg' -f csv -b open -c $columns "$rocker"
check 'whole turns do not matter; none is no row' awk -F, 'NR > 1 {d = $3 - 140; if (d * d > 1e-20) bad++} END {exit bad || NR != 3}' out
run 0 --at='theta4 = 10 deg' -f csv -c $columns "$rocker"
check 'the header alone' test "$(wc -l <out)" -eq 1
run 1 --at='omega2 = 10.5 rad/s' -b open -c $columns "$rocker"
prints '# omega2 = 10.5 rad/s: the column is constant: it is not at a value at single angles'
run 0 --at='theta4 = 120 deg' -f json -b open -c $columns "$rocker"
check 'json' test "$(grep -c '"status"' out)" -eq 2

for at in "theta5 = 3 deg|no column 'theta5'; did you mean 'theta2'?" "theta4 = 3 mm|'theta4 = 3 mm' is a length; expected an angle" \
    "theta4 =|expected an angle" "800 deg x|unknown unit 'x' in '800 deg x'"; do
    run 2 --at="${at%%|*}" "$rocker"
    check "message for ${at%%|*}: $(cat err)" grep -qF -e "${at#*|}" err
done
sed '/^interval/d' "$rocker" >time.deck
run 2 --at='theta4 = 120 deg' -s motion.mode=free -s motion.speed='5 rad/s' -s motion.rows=time -s motion.time_step='1 ms' \
    -s motion.duration='9 ms' -s crank.inertia='1 kg m^2' time.deck
check "rows by time: $(cat err)" grep -q 'needs rows by angle; these are rows by time' err
usage '--at chooses rows of a table, csv, json or --expect' --at='30 deg' --format=paper "$rocker"
usage '--at chooses rows of a table, csv, json or --expect' --at='30 deg' --plot=x.svg "$rocker"
# a motion of one instant says that it is one
run 2 --at='theta3 = 3 deg' "$data/dfa-example-1.deck"
says "'theta3 = 3 deg' is sought along a motion; this one is one instant, [motion] at = 30 deg"
run 2 --at='60 deg' "$data/dfa-example-1.deck"
says 'the motion does not reach theta2 = 60 deg: it is one instant, [motion] at = 30 deg'
run 0 --at='30 deg' "$data/dfa-example-1.deck"
# what people call a column
run 2 --at='w4 = 2' "$alvi"
says "no column 'w4'; did you mean 'omega4'?"
run 2 --at='torque = 2' "$matrix"
says "no column 'torque'; did you mean 'Ts'?"
run 2 -c 'mu_min, torque' "$matrix"
says "did you mean 'max(Ts)'?"
run 2 -s 'sweep.output=w4' -s 'sweep.crank.length=20 mm, 21 mm' "$alvi"
says "did you mean 'max(omega4)'?"
finish
