#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
#
# test_paper.sh FOURLINK DATA - --format=paper: the printout of Alvi, Deshmukh and Wayzode.
. "$(dirname "$0")/../harness.sh"

# Alvi, section 5.1, its misprints mended: 103.821 at 40 deg; velb 3.26 for 3.20 at 120 deg; accb
# 23.99 for 23.93 at 160 and 200 deg; accb 22.42 for -22.42 at 280 deg.
tr ' ' '\t' >expected <<'EOF'
thet Vela acca phi beta velc velb Accc Accb
00 10.5 0.00 -110.74 -52.51 -3.50 -3.50 -37.58 18.56
00 10.5 0.00 110.74 52.51 -3.50 -3.50 37.58 -18.56
40 10.5 0.00 -126.30 -61.47 -4.06 -0.83 15.50 50.99
40 10.5 0.00 103.82 38.99 0.07 -3.15 56.46 20.96
80 10.5 0.00 -139.02 -58.74 -2.51 2.03 26.17 31.04
80 10.5 0.00 110.16 29.87 2.92 -1.62 27.30 22.42
120 10.5 0.00 -145.28 -48.22 -0.77 3.20 26.64 4.54
120 10.5 0.00 123.49 26.44 3.77 -0.20 -0.66 21.44
160 10.5 0.00 -144.69 -36.44 1.12 2.75 29.94 -16.40
160 10.5 0.00 136.77 28.52 2.96 1.32 -22.41 23.93
200 10.5 0.00 -136.77 -28.52 2.96 1.32 22.41 -23.93
200 10.5 0.00 144.69 36.44 1.12 2.75 -29.94 16.40
240 10.5 0.00 -123.49 -26.44 3.77 -0.20 0.66 -21.44
240 10.5 0.00 145.28 48.22 -0.77 3.20 -26.64 -4.54
280 10.5 0.00 -110.16 -29.87 2.92 -1.62 -27.30 -22.42
280 10.5 0.00 139.02 58.74 -2.51 2.03 -26.17 -31.04
320 10.5 0.00 -103.82 -38.99 0.07 -3.15 -56.46 -20.96
320 10.5 0.00 126.30 61.47 -4.06 -0.83 -15.50 -50.99
EOF
for form in '-f paper' -fpaper --format=paper '--format paper'; do
    run 0 $form "$alvi"
    quiet
    same out expected
done
run 0 -f paper -s units.angle=rad -s units.angular_speed=rpm "$alvi"
same out expected
grep -v "^[0-9]*${tab}10.5${tab}0.00${tab}-" expected >open
run 0 -f paper -b open "$alvi"
same out open
# the last row of a whole turn is the first again; of a part it is not
run 0 -f paper -b open -s 'motion.to=80 deg' "$alvi"
head -n 4 open >part
same out part
run 0 -f paper -s motion.at=40 -b open "$alvi"
lines out 2

run 0 -f paper -i 7.25 -b open "$alvi"
check 'an angle that is no whole number' test "$(sed -n '3p' out | cut -f1)" = 7.25

finish
