#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
#
# test_table.sh FOURLINK DATA - --format=table: blocks, names, units, widths and numbers.
. "$(dirname "$0")/../harness.sh"

cp "$decks/reach.deck" .
cp "$decks/pump.deck" engine.deck

"$fourlink" "$alvi" >out
prints '# Crank-rocker of Alvi et al., section 5.1'
holds 'four lines of head, then the branch' '
    NR == 1 && $0 != "# Crank-rocker of Alvi et al., section 5.1" {bad = 1}
    NR == 2 && $0 != "# four-bar linkage: crank-rocker" {bad = 1}
    NR == 3 && $0 != "# crank 20 mm, coupler 66 mm, rocker 56 mm, ground 80 mm" {bad = 1}
    NR == 4 && $0 != "# crank at 10.5 rad/s" {bad = 1}
    NR == 5 && $0 != "# branch: open" {bad = 1}
    NR == 6 && $2 != "theta2" {bad = 1}
    END {exit bad}'
holds 'extremes below the rows, under the names' '
    $2 == "theta2" {for (i = 2; i <= NF; i++) column[$i] = i}
    !/^#/ && NF {row = NR}
    $2 == "max" && $column["omega4"] == "3.77188" {max = NR > row && row}
    $2 == "at" && max && !at {at = NR == row + 2 && $column["omega4"] == "118.950"}
    $2 == "min" && $column["omega4"] == "-4.27010" {min = NR == row + 3}
    END {exit !(max && at && min)}'
holds 'two blocks of ten rows, two blank lines apart' '
    /^$/ {blank++; next}
    {if (blank && blank != 2) bad = 1; if (blank) blocks++; blank = 0}
    /^#/ {next}
    {rows[blocks + 0]++}
    END {exit bad || blocks != 1 || rows[0] != 10 || rows[1] != 10}'
holds 'besides comments, numbers' '
    /^#/ || /^$/ {next}
    {for (i = 1; i <= NF; i++) if ($i !~ /^-?[0-9]+(\.[0-9]+)?(e[-+][0-9]+)?$/) bad = 1}
    END {exit bad}'
holds 'aligned' '/^#/ || /^$/ {next} {if (n++ && length != width) bad = 1; width = length} END {exit bad}'
holds 'names and units above each column' '
    /^# *theta2/ {names = NF - 1} /^# *deg/ {units = NF - 1} /^ *40 / && NF != names {bad = 1}
    END {exit bad || names != 8 || units != 8}'
holds 'each branch under its comment' '
    /^# branch: / {branch = $3} $1 == 40 {sign[branch] = $2 > 0 ? 1 : -1}
    END {exit !(sign["open"] == 1 && sign["crossed"] == -1)}'
# reference values of the equations solved by other means
run 0 -b open -s table.digits=9 "$alvi"
holds 'the row of 40 deg' '
    function near(x, y) {return x - y < 1e-6 && y - x < 1e-6}
    $1 == 40 {ok = near($2, 38.986348) && near($3, -3.1548742) && near($4, 20.9564894) &&
              near($5, 103.820765) && near($6, 0.0732971) && near($7, 56.4557805)}
    END {exit !ok}'
run 0 -b open -c theta2,F12x,F12y,F23x,F34y,F14x,F14y,Ts -s table.digits=9 "$matrix"
holds 'the forces at 40 deg' '
    function near(x, y) {return x - y < 1e-6 && y - x < 1e-6}
    $1 == 40 {ok = near($2, 7.06332168) && near($3, 8.4656654) && near($4, 7.14777808) &&
              near($5, 4.98155676) && near($6, -8.24612757) && near($7, -2.589694) &&
              near($8, 0.03138230954551688)}
    END {exit !ok}'

# constant_fields: the rows of the table have a field for each name above them.
constant_fields() {
    holds 'as many fields in each row as names above' \
        '/^# *theta2 +theta3 / {n = NF - 1} /^#/ || /^$/ {next} {rows++} NF != n {bad = 1}
        END {exit bad || n < 3 || rows < 2}'
}
run 1 reach.deck
constant_fields
holds 'rows that cannot be computed are one comment' '
    /^# 120 to 240 deg: not reached: B and D are too far apart$/ {comments++} 120 <= $1 && $1 <= 240 {bad = 1}
    $1 == 40 {rows++}
    END {exit bad || comments != 2 || rows != 2}'
run 1 -i 90 reach.deck
holds 'one angle' '/^# 180 deg: not reached: B and D are too far apart$/ {n++} END {exit n != 2}'
holds 'other rows are there' '/^#/ || !NF {next} {rows++} END {exit rows != 8}'
# two reasons, one after the other
run 1 -b open -c theta2,x -s 'crank.length=300 mm' -s 'rod.length=150 mm' -s motion.interval=15 engine.deck
holds 'each reason' '
    /^# 30 deg: dead position: / {a = NR}
    /^# 45 to 135 deg: not reached: the rod does not reach the line of stroke$/ {b = NR == a + 1}
    /^# 150 deg: dead position: / {c = b && NR == a + 2}
    $1 == 165 {d = c && NR == a + 3}
    END {exit !d}'
prints '# crank at 12.5664 rad/s; masses of rod and piston'
prints '# slider-crank, the crank does not turn fully'
run 1 -f csv -b open -s 'crank.length=300 mm' -s 'rod.length=150 mm' -s motion.interval=15 engine.deck
check 'csv has a row for each angle' test "$(grep -c 'the rod does not reach' out)" -eq 14
run 1 -f json -b open -s 'crank.length=300 mm' -s 'rod.length=150 mm' -s motion.interval=15 engine.deck
check 'and so has json' test "$(grep -c 'the rod does not reach' out)" -eq 14
run 0 -b open -s 'ground.offset=20 mm' -s 'motion.acceleration=-0.1 rad/s2' engine.deck
prints '# crank 300 mm, rod 1200 mm, offset 20 mm'
prints '# crank at 12.5664 rad/s, acceleration -0.1 rad/s2; masses of rod and piston'
run 0 -b open "$matrix"
prints '# crank at 10.5 rad/s; masses of all links; load Tl'
run 0 -b open "$decks/gas-engine.deck"
prints '; mass of piston; gas'
loads=
for i in 1 2 3 4; do loads="$loads
[load pressing-$i]
link = rocker
torque = 1 N m"; done
{ cat "$alvi" && echo "$loads"; } >loads.deck
run 0 -b open loads.deck
prints '# crank at 10.5 rad/s; 4 loads'
run 0 engine.deck
constant_fields
# a peak between the rows from which the widths of the columns are taken
cat >peak.deck <<'EOF'
mechanism = four-bar
[ground]
length = 80 mm
[crank]
length = 20 mm
[coupler]
length = 80.0000001 mm
[rocker]
length = 20 mm
[motion]
speed = 10 rad/s
interval = 0.1 deg
EOF
run 1 peak.deck
constant_fields
run 0 -s 'motion.speed=1e9 rad/s' "$matrix"
constant_fields
# 0 has no sign, in whichever form it is written
run 1 -s 'crank.length=300 mm' -s 'rod.length=100 mm' -s motion.interval=90 engine.deck
check 'no -0 in the table' none -Ee '-0(\.0*)?(e[-+]?[0-9]+)?( |$)' out
run 0 -s motion.speed=0 engine.deck
check 'no -0 in the table of a machine at rest' none -Ee '-0(\.0*)?(e[-+]?[0-9]+)?( |$)' out
run 0 -s 'motion.speed=0' "$alvi"
constant_fields
for units in 'length=in' 'angle=rad' 'angle=rev' 'angular_speed=rpm' 'force=kip' 'torque=N m'; do
    run 0 -s "units.$units" "$matrix"
    constant_fields
    holds 'a unit above each column' '/^# branch: open/ {getline; getline; exit !/^#/}'
done
run 0 -s 'motion.at=40 deg' "$alvi"
holds 'one instant, a row for each branch' '/^ *40 / {n++} !/^#/ && NF {rows++} END {exit n != 2 || rows != 2}'
run 0 -i 7 "$alvi"
holds 'the last row is the end of the range' '!/^#/ && NF {last = $1} END {exit last != 360}'
run 0 -i 0.1 "$alvi"
holds 'no rounding in the angles' '!/^#/ && NF && $1 !~ /^[0-9]+\.[0-9]$/ {bad = 1} END {exit bad}'

# crank angles have the decimals that first angle, interval and last angle need
for case in '0 40 120:0 40 80 120' '0 7.25 15:0.00 7.25 14.50 15.00' '0 10 21.5:0.0 10.0 20.0 21.5' \
    '0.125 10 10.125:0.125 10.125'; do
    set -- ${case%%:*}
    run 0 -b open -c theta2,mu -s motion.from=$1 -i $2 -s motion.to=$3 "$alvi"
    check "crank angles: ${case#*:}" test "$(awk '!/^#/ {printf "%s%s", n++ ? " " : "", $1}' out)" = "${case#*:}"
done

# all lines of a block end in one column
run 0 -b open -c theta2,theta4,Ts "$matrix"
holds 'lines of one length' '/^# theta2/ {on = 1; n = length} on && length != n {bad = 1} END {exit !n || bad}'

finish
