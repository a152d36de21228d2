#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
#
# test_synthesis.sh FOURLINK DATA - --synthesis: the deck of the linkage found, which runs and is proved by --check;
# solutions, sweeps, pictures; defects and tasks without a linkage; mistakes.
. "$(dirname "$0")/../harness.sh"

# task LINE...: t.deck
task() { printf '%s\n' "$@" >t.deck; }
four_bar='mechanism = four-bar'
ground='[ground]
length = 100 mm'
points='points = 36 deg 64 deg, 75 deg 98 deg, 114 deg 142 deg'

# proves STATUS: the deck of t.deck's linkage is in found.deck, and its [expect] sections agree
proves() {
    run "$1" --synthesis t.deck
    mv out found.deck
    cp err found.err
    run 0 --check found.deck
    quiet
    prints 'differs: 0'
    check "[expect] sections" test "$(grep -c '^\[expect\]' found.deck)" -ge "${2-3}"
    mv found.err err
}

# the rest of the deck is copied: masses, comments, loads, its own line ends; not [sweep]
task '# a comment' "$four_bar" "$ground" '[crank]' 'mass = 2 kg # two' 'uniform = yes' '[synthesis]' 'task = function' "$points" \
    '[load W]' 'link = rocker' 'torque = 5 N m'
proves 0
quiet
for line in '# a comment' 'mass = 2 kg # two' 'uniform = yes' '[load W]' 'torque = 5 N m' 'branch = crossed' 'from = 216 deg'; do
    check "$line" grep -qxF "$line" found.deck
done
check 'no [synthesis] in the deck found' none '^\[synthesis' found.deck
check '17 digits' grep -q '^length = 60.005448180335[0-9]* mm' found.deck
check 'turned by 180 deg' grep -q 'a = -60.0054482 mm: the crank is turned' found.deck
cp found.deck first.deck
sed "s/\$/$cr/" t.deck >crlf.deck
run 0 --synthesis crlf.deck
tr -d '\r' <out | sed '1s/crlf.deck/t.deck/' >one
same one first.deck
check 'all lines end in CR LF' test "$(grep -c "$cr\$" out)" -eq "$(wc -l <out)"
# any length scales the linkage
sed 's/\[ground\]/[coupler]/' t.deck >u.deck
run 0 --synthesis u.deck
prints 'length = 100 mm'
run 0 --synthesis --summary --format=csv t.deck
holds 'the facts of the linkage found' '/^defects,none,/ {n++} /^coupler_length,0.12381/ {n++} END {exit n != 2}'

run 0 --synthesis --check t.deck
prints 'score: 3 of 3'
run 0 --synthesis --report=t.html --set=rocker.mass='1 kg' t.deck
check "a note once, in the report as well: $(cat err)" test "$(grep -c 'point mass' err)" -eq 1
check 'the note in the report' grep -q 'is a point mass' t.html
run 0 --synthesis --report=t.html t.deck
check 'the checks in the report' grep -q 'condition of the linear equations' t.html
check 'the steps in the report' grep -q '<h3>Checks</h3>' t.html

# each task; positions, facts, points
task "$four_bar" "$ground" '[synthesis]' 'task = function' 'function = log10' 'x = 1 to 2' 'crank = 45 to 105 deg' 'rocker = 135 deg to 225 deg'
proves 0
check 'the error' grep -q 'structural error: largest -0.168637 deg at theta2 = 45 deg' found.deck
check 'lengths' grep -q ': ground 100, crank 185.086, coupler 286.801, rocker 192.051 (mm); open' found.deck
run 0 --synthesis --at='45 deg, 75 deg' --set=table.columns=structural_error --format=csv t.deck
holds 'the column of the error' 'BEGIN {FS = ","} NR == 2 {exit !($2 < -0.1686 && $2 > -0.1687)}'
run 0 --synthesis --plot=error.svg t.deck
check 'the largest error in the picture' grep -q '0.1686' error.svg
run 2 --plot=x.svg --plot-kind=error first.deck
says 'needs --synthesis'
# a fit that is nearly exact
task 'mechanism = slider-crank' '[synthesis]' 'task = function' 'function = x^1.5' 'x = 1.77055 to 4.74299' \
    'crank = 75.2029 deg to 131.351 deg' 'piston = 172.947 mm to 43.6346 mm' 'precision = 4'
proves 0 4
# a table: all its rows by least squares, or points between them; part of it
{ echo 'x; log10 x' && awk 'BEGIN {for (i = 0; i <= 20; i++) printf "%.2f; %.6f\n", 1 + i / 20, log(1 + i / 20) / log(10)}'; } >log.csv
table='function = file log.csv'
ranges='crank = 45 to 105 deg
rocker = 135 deg to 225 deg'
task "$four_bar" "$ground" '[synthesis]' 'task = function' "$table" "$ranges"
proves 0 21
check 'all rows' grep -q 'structural error: largest -0.1706' found.deck
task "$four_bar" "$ground" '[synthesis]' 'task = function' "$table" 'precision = 3' "$ranges"
proves 0
check 'the function of the table' grep -q ': ground 100, crank 185.09[0-9]*, coupler 286.80[0-9]*, rocker 192.05' found.deck
task "$four_bar" "$ground" '[synthesis]' 'task = function' "$table" 'x = 1.2 to 1.5' "$ranges"
proves 0 7
printf 'theta2 [deg]; theta4 [deg]\n36; 64\n75; 98\n114; 142\n' >points.csv
task "$four_bar" "$ground" '[synthesis]' 'task = function' 'points = file points.csv'
proves 0
check 'points of a file' grep -q '^length = 60.005448180335[0-9]* mm' found.deck
# lengths are in the unit of the points
task 'mechanism = slider-crank' '[synthesis]' 'task = function' 'points = 45 deg 95 mm, 90 deg 60 mm, 135 deg 30 mm'
proves 0
check 'constants in this unit' grep -q '^# S1 = 91.92388[0-9]*, S2 = 2560.66[0-9]*, S3 = -1039.33[0-9]*;' found.deck
run 0 --synthesis --report=r.html t.deck
check 'S2 of a report is an area' grep -q '<mtext>2</mtext></msub><mo form="infix">=</mo><mn>0.00256066</mn><mtext>[^m]*m²</mtext>' r.html
check 'the unit of a list' grep -q '^length = 45.96194077712[0-9]* mm' found.deck
printf '45 95\n90 60\n135 30\n' >piston.csv
task 'mechanism = slider-crank' '[synthesis]' 'task = function' 'points = file piston.csv deg mm'
proves 0
check 'the unit of a file' grep -q '^length = 45.96194077712[0-9]* mm' found.deck
task 'mechanism = slider-crank' '[synthesis]' 'task = function' 'function = linear' 'x = 0 to 1' 'crank = 45 to 135 deg' \
    'piston = 100 to 30 mm'
proves 0
task "$four_bar" '[synthesis]' 'task = motion' 'positions = (0, 0) m 0 deg, (1.2, 0.5) m 18 deg, (2.1, 1.6) m 47 deg' \
    'left = fixed (0.5, 3.5) m' 'right = fixed (0.5, -1) m'
proves 0 6
check 'where A is' grep -q 'pivot A is at (0.5, 3.5) m' found.deck
check 'the crank' grep -q '^length = 0.97986206560052[0-9]* m' found.deck
task 'mechanism = slider-crank' '[synthesis]' 'task = function' 'points = 45 deg 100 mm, 90 deg 82.5 mm, 135 deg 30 mm'
proves 0
check 'lengths in the unit of the points' grep -q '^length = 49.497474683058[0-9]* mm' found.deck
task 'mechanism = slider-crank' '[synthesis]' 'task = motion' 'positions = (0, 0) mm 0 deg, (24, 10) mm -30 deg, (40, 5) mm -50 deg' \
    'left = fixed (10, -30) mm' 'right = slider 10 deg'
proves 0 6
check 'the line of the slider' grep -q 'the direction of stroke is at -170 deg' found.deck
check 'the offset' grep -q '^offset = 39.3007466283' found.deck
task "$four_bar" '[synthesis]' 'task = motion' 'positions = (1, 2) mm 0 deg, (3, 2) mm 0 deg, (4, 4) mm 0 deg' \
    'left = fixed (5, 6) mm' 'right = fixed (7, 6) mm'
proves 0 6
check 'a change point on the way' grep -q 'and through a change point from theta2 = -119.745 to 7.12502 deg' found.deck
task "$four_bar" '[synthesis]' 'task = path' 'positions = (0, 0) mm, (12, 5) mm, (21, 16) mm' 'timing = 40 deg, 85 deg' \
    'right = fixed (50, -10) mm'
proves 0 6
run 0 --synthesis --solution=2 t.deck
prints 'solution 2 of'
prints ' more: fourlink --synthesis --format=table'
run 0 --synthesis --format=csv t.deck
holds 'a line for each solution' 'BEGIN {FS = ","} NR == 1 {ok = $1 == "solution" && /mu_range/} END {exit !ok || NR < 3}'
run 0 --synthesis --format=json t.deck
prints '{"solution":1,'
run 0 --synthesis --format=table t.deck
prints '# solution'
run 2 --synthesis --solution=999 t.deck
says 'there is no solution 999'
task "$four_bar" '[crank]' 'length = 60 mm' '[ground]' 'length = 120 mm' '[synthesis]' 'task = quick-return' \
    'time_ratio = 1.11111111111111111' 'swing = 80 deg' 'mu_min = 30 deg'
proves 0 2
quiet
check 'the coupler' grep -q '^length = 103.197034989212[0-9]* mm' found.deck
check 'no linear equations, no condition' none 'condition' found.deck
stroke='stroke = 100 mm'
task 'mechanism = slider-crank' '[rod]' 'length = 150 mm' '[synthesis]' 'task = quick-return' 'time_ratio = 1' "$stroke"
proves 0 1
task 'mechanism = slider-crank' '[ground]' 'offset = 30 mm' '[synthesis]' 'task = quick-return' 'time_ratio = 1.2' "$stroke"
proves 0 2
check 'the offset that is given' grep -qx 'offset = 30 mm' found.deck
task 'mechanism = slider-crank' '[synthesis]' 'task = quick-return' 'time_ratio = 1.2' 'slow = against' "$stroke"
proves 0 2
check 'angles of a turn' grep -q 'smallest 47.2011 deg at theta2 = 90 deg' found.deck
task 'mechanism = inverted-slider-crank' '[crank]' 'length = 30 mm' '[synthesis]' 'task = quick-return' 'time_ratio = 1.7' \
    'stroke = 120 mm'
proves 0 1
run 0 --synthesis --format=csv t.deck
check 'the lever in the table of solutions' grep -q '^solution,branch,.*,rocker_length' out
task "$four_bar" "$ground" '[crank]' 'length = 40 mm' '[coupler]' 'length = 90 mm' '[rocker]' 'length = 80 mm' '[point Q]' \
    'link = coupler' 'at = (40, 30) mm' '[synthesis]' 'task = cognate' 'which = right'
run 0 --synthesis --report=r.html t.deck
check 'rounding is 0 in equations' awk \
    '/id="synthesis"/ {on = 1} /<\/section>/ {on = 0} on && /<mn>10<\/mn>/ {bad = 1} END {exit bad}' r.html
proves 0 6
check 'the point of the deck' grep -q '^Q.x = ' found.deck

# the deck's own motion stays; positions that it does not reach are not asked for
task "$four_bar" "$ground" '[synthesis]' 'task = function' "$points" '[motion]' 'from = 200 deg' 'to = 260 deg' 'speed = 10 rad/s'
proves 0 2
check 'what is not reached' grep -qx '# position 3: the motion does not reach this crank angle' found.deck
check 'the own motion' grep -qx 'to = 260 deg' found.deck
task "$four_bar" '[synthesis]' 'task = motion' 'positions = (0, 0) m 0 deg, (1.2, 0.5) m 18 deg, (2.1, 1.6) m -47 deg' \
    'left = fixed (0.5, 3.5) m' 'right = fixed (0.5, -1) m' '[motion]' 'acceleration = 5 rad/s2'
run 1 --synthesis t.deck
prints '# Found by'

# a defect is told, the deck is printed; no linkage: the reason; both with exit status 1
task "$four_bar" "$ground" '[synthesis]' 'task = function' 'points = 10 deg 60 deg, 75 deg 20 deg, 150 deg 160 deg'
proves 1
says 't.deck:4: defect: '
check 'the defect in the deck' grep -q '^#   defect: ' found.deck
task "$four_bar" '[synthesis]' 'task = motion' 'positions = (0, 0) mm 0 deg, (24, 10) mm -30 deg, (40, 5) mm -50 deg' \
    'left = rotations -40 deg -70 deg' 'right = fixed (50, 0) mm'
proves 1
says 'open at positions 2, 3, crossed at position 1'
check 'no position has a smaller one' grep -q 'smallest 4.64795 deg at theta2 = 344.423 deg; at the positions 4.64795' found.deck
task "$four_bar" "$ground" '[crank]' 'length = 10 mm' '[synthesis]' 'task = quick-return' 'time_ratio = 2' 'swing = 60 deg'
run 1 --synthesis t.deck
nothing
says 'a given value follows from others'
task "$four_bar" "$ground" '[synthesis]' 'task = function' 'points = 10 deg 60 deg, 10 deg 60 deg, 150 deg 160 deg'
run 1 --synthesis t.deck
nothing
says 't.deck:4: error: no single linkage'
run 1 --synthesis --format=csv t.deck

# a sweep over a key of [synthesis]; one of its designs; the best one
task "$four_bar" '[ground]' 'length = 120 mm' '[synthesis]' 'task = quick-return' 'time_ratio = 1.2' 'swing = 50 deg' \
    'choose = best' '[sweep]' 'synthesis.time_ratio = 1.1 to 1.4 step 0.1'
run 0 --synthesis t.deck
run 0 --synthesis --format=csv t.deck
holds 'four designs' 'BEGIN {FS = ","} NR > 1 && $9 == "none" && $4 > 0 {n++} END {exit n != 4}'
run 0 --synthesis --design=3 t.deck
prints '# Found by'
check 'no [sweep]' none '^\[sweep' out
cp out design.deck
run 0 --check design.deck
run 0 --synthesis --best='max mu_range' t.deck
prints 'max mu_range = 49.93'

# mistakes
refuses() {
    message=$1
    shift
    task "$@"
    run 2 --synthesis t.deck
    nothing
    says "$message"
}
run 2 t.deck
says 't.deck:4: error: [synthesis] describes a linkage that is to be found: fourlink --synthesis'
run 2 --synthesis "$alvi"
says 'needs a [synthesis]'
usage '--solution needs --synthesis' --solution=2 t.deck
usage '--solution must be a number from 1 to 1000' --synthesis --solution=0 t.deck
usage '--synthesis takes one deck' --synthesis t.deck t.deck
refuses "did you mean 'function'?" "$four_bar" '[synthesis]' 'task = functon'
refuses "did you mean 'points'?" "$four_bar" '[synthesis]' 'task = function' 'pionts = 1'
refuses "'swing' does not belong to task = function" "$four_bar" "$ground" '[synthesis]' 'task = function' "$points" 'swing = 5 deg'
refuses "needs 'points' or a 'function'" "$four_bar" "$ground" '[synthesis]' 'task = function'
refuses 'needs the length of one link' "$four_bar" '[synthesis]' 'task = function' "$points"
refuses 'finds this: remove it' "$four_bar" "$ground" '[crank]' 'length = 5 mm' '[synthesis]' 'task = function' "$points"
refuses 'three or more points' "$four_bar" "$ground" '[synthesis]' 'task = function' 'points = 36 deg 64 deg'
refuses "did you mean 'power'?" "$four_bar" "$ground" '[synthesis]' 'task = function' 'function = pwer 2' 'x = 1 to 2' \
    'crank = 1 deg to 2 deg' 'rocker = 1 deg to 2 deg'
refuses 'needs a unit, such as 0 deg to 90 deg' "$four_bar" "$ground" '[synthesis]' 'task = function' 'function = sin' 'x = 0 to 90' \
    'crank = 1 deg to 2 deg' 'rocker = 1 deg to 2 deg'
refuses 'the same value at both ends' "$four_bar" "$ground" '[synthesis]' 'task = function' 'function = sin' \
    'x = 0 to 180 deg' 'crank = 0 deg to 90 deg' 'rocker = 0 deg to 90 deg'
refuses 'error: a swing is between 0 and 180 deg' "$four_bar" "$ground" '[synthesis]' 'task = quick-return' 'time_ratio = 1.1' \
    'swing = 200 deg'
refuses 't.deck:5: error: task = quick-return finds this' 'mechanism = slider-crank' '[crank]' 'length = 30 mm' '[rod]' \
    'length = 90 mm' '[synthesis]' 'task = quick-return' 'time_ratio = 0.9' 'stroke = 100 mm'
says 't.deck:8: error: a time ratio is at least 1'
refuses "needs 'stroke'" 'mechanism = slider-crank' '[crank]' 'length = 30 mm' '[synthesis]' 'task = quick-return' 'time_ratio = 1.2'
refuses 't.deck:7: error: the lever of a Whitworth mechanism turns fully' 'mechanism = inverted-slider-crank' "$ground" \
    '[synthesis]' 'task = quick-return' 'type = whitworth' 'swing = 50 deg'
refuses 'the function is not defined' "$four_bar" "$ground" '[synthesis]' 'task = function' 'function = ln' 'x = -1 to 2' \
    'crank = 1 deg to 2 deg' 'rocker = 1 deg to 2 deg'
refuses 'expected a range, such as 30 deg to 120 deg' "$four_bar" "$ground" '[synthesis]' 'task = function' 'function = ln' 'x = 1 to 2' \
    'crank = 1 deg' 'rocker = 1 deg to 2 deg'
refuses 'the table goes from x = 1 to 2' "$four_bar" "$ground" '[synthesis]' 'task = function' "$table" 'x = 1 to 3' "$ranges"
refuses '2 rows of the table' "$four_bar" "$ground" '[synthesis]' 'task = function' "$table" 'x = 1.2 to 1.25' "$ranges"
refuses "cannot read the file 'exp.csv'" "$four_bar" "$ground" '[synthesis]' 'task = function' 'function = file exp.csv' "$ranges"
printf '1 2\n2 4\n2 5\n' >bad.csv
refuses 'bad.csv:3: error: x must rise' "$four_bar" "$ground" '[synthesis]' 'task = function' 'function = file bad.csv' "$ranges"
printf '1 2\n2 4\n' >two.csv
refuses 'three or more rows' "$four_bar" "$ground" '[synthesis]' 'task = function' 'function = file two.csv' "$ranges"
refuses 'a weight for each of the points' "$four_bar" "$ground" '[synthesis]' 'task = function' "$points" 'weights = 1, 2'
refuses "crank's rotations" "$four_bar" '[synthesis]' 'task = path' 'positions = 1, 2, 3' 'timing = 4 deg' 'right = fixd (5, 4) mm'
says 'expected a point'
says "did you mean 'fixed'?"
refuses "did you mean 'ln'?" "$four_bar" "$ground" '[synthesis]' 'task = function' 'function = sn' 'crank = 3 deg' 'rocker = 1 mm to 3 mm'
says "not '3 deg'"
says 'is a length'
refuses 'expected three positions' "$four_bar" '[synthesis]' 'task = motion' 'positions = (1, 2) mm 3 deg' 'left = fixed (0, 0) mm' \
    'right = fixed (1, 0) mm'
refuses 'expected three positions' "$four_bar" '[synthesis]' 'task = motion' \
    'positions = (1, 2) mm 3 deg, (2, 2) mm 4 deg, (3, 2) mm 5 deg, (4, 3) mm 6 deg' 'left = fixed (0, 0) mm' 'right = fixed (1, 0) mm'
refuses 'expected a function' "$four_bar" "$ground" '[synthesis]' 'task = function' 'function = cubic 3' 'x = 1 to 2' \
    'crank = 1 deg to 2 deg' 'rocker = 1 deg to 2 deg'
refuses "did you mean 'fixed'?" "$four_bar" '[synthesis]' 'task = motion' \
    'positions = (1, 2) mm 3 deg, (2, 2) mm 4 deg, (3, 2) mm 5 deg' 'left = fixd (0, 0) mm' 'right = fixed (1, 0) mm'
refuses 'a time ratio is at least 1' "$four_bar" "$ground" '[crank]' 'length = 20 mm' '[synthesis]' 'task = quick-return' \
    'time_ratio = 0.8' 'swing = 40 deg'
positions='positions = (0, 0) mm 0 deg, (3, 1) mm 18 deg, (6, 2) mm 29 deg'
refuses 'the right pivot moves along a line: write mechanism = slider-crank' "$four_bar" '[synthesis]' 'task = motion' \
    "$positions" 'left = fixed (5, 7) mm' 'right = moving (0, 0) mm'
refuses 'the right pivot does not move along a line: write right = slider 30 deg' 'mechanism = slider-crank' \
    '[synthesis]' 'task = motion' "$positions" 'left = fixed (5, 7) mm' 'right = moving (1, 0) mm'
refuses 'task = motion does not exist for an inverted slider-crank' 'mechanism = inverted-slider-crank' '[synthesis]' 'task = motion'
refuses 'cognate needs a [point]' "$four_bar" "$ground" '[crank]' 'length = 40 mm' '[coupler]' 'length = 90 mm' '[rocker]' \
    'length = 80 mm' '[synthesis]' 'task = cognate' 'which = left'

finish
