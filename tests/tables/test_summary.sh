#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
#
# test_summary.sh FOURLINK DATA - --summary: facts, extremes, turning moment, as a table and in csv.
. "$(dirname "$0")/../harness.sh"

cp "$decks/gas-engine.deck" engine.deck

# ---------------------------------------------------------------------------- --summary, table

for form in -S --summary; do
    run 0 $form "$alvi"
    quiet
done
prints '# Crank-rocker of Alvi et al., section 5.1'
run 0 -S -s table.digits=12 "$alvi"
holds 'the type in words' '$1 == "type" && /crank-rocker$/ {ok = 1} END {exit !ok}'
holds 'limits of both branches, with unit and crank angle' '
    function near(x, y) {return x - y < 1e-7 && y - x < 1e-7}
    $1 == "theta4_max" && $3 == "deg" && /, open, at/ {
        open = near($2, 145.906609189) && near($(NF - 1), 223.031532078)}
    $1 == "theta4_max" && $3 == "deg" && /, crossed, at/ {
        crossed = near($2, -103.818044198) && near($(NF - 1), 320.778684351)}
    END {exit !(open && crossed)}'
holds 'extremes of the columns' '
    function near(x, y, d) {return x - y < d && y - x < d}
    $1 == "theta4" && $7 == "open" {
        ok = near($2, 103.818044198, 1e-8) && near($3, 39.2213156, 1e-5) && near($4, 145.906609189, 1e-8)}
    $1 == "mu" {mu++}
    $1 == "mu" && $3 == 0 && $6 == "deg" && NF == 6 {both = 1}
    $1 == "theta2" || $1 == "F12x" {bad = 1}
    END {exit !ok || mu != 1 || !both || bad}'
holds 'no rows' '/^ *[-0-9.]/ {bad = 1} END {exit bad}'
run 0 -S -b crossed -c mu "$alvi"
check 'one branch' none -w open out
holds 'the columns that are chosen' '/^# column/ {on = 1; next} on {n++} $1 == "mu" {mu++} END {exit n != 1 || mu != 1}'
# coarse or fine, at the same angles
run 0 -S -i 40 "$alvi"
cp out coarse
run 0 -S -i 3 "$alvi"
sed '1,/^# result/d' out >fine.results
sed '1,/^# result/d' coarse >coarse.results
same fine.results coarse.results
run 0 -S -o summary "$alvi"
nothing
same summary coarse
"$fourlink" -S -i 40 <"$alvi" >out
same out coarse

run 0 -S engine.deck
for fact in n stroke inner_dead_centre outer_dead_centre mean_torque mean_power energy_fluctuation \
    energy_coefficient flywheel_inertia flywheel_fluctuation Ts x; do
    holds "the fact $fact, twice at most" '$1 == "'"$fact"'" {n++} END {exit n < 1 || n > 2}'
done
run 0 -S -s table.digits=12 engine.deck
holds 'power = torque x speed, dE = I Cs omega^2, dE = coefficient x torque x cycle' '
    function close_to(x, y) {return x != 0 && (x - y) / x < 1e-9 && (y - x) / x < 1e-9}
    /crossed/ {next} {value[$1] = $2}
    END {pi = atan2(0, -1); w = 4 * pi
         exit !(close_to(value["mean_power"], value["mean_torque"] * w) &&
                close_to(value["energy_fluctuation"], value["flywheel_inertia"] * 0.02 * w * w) &&
                close_to(value["energy_fluctuation"],
                         value["energy_coefficient"] * value["mean_torque"] * 4 * pi) &&
                value["mean_torque"] > 0 && value["flywheel_fluctuation"] == 0.02)}'
# quick return: crank 100 mm, rod 300 mm, offset 20 mm: (180 + 2.873) deg / (180 - 2.873) deg
check 'no time ratio without an offset' none '^time_ratio' out
run 0 -S -s 'ground.offset=20 mm' engine.deck
holds 'time ratio with an offset' '$1 == "time_ratio" && $2 == 1.03244 && $3 == 1 {n++} END {exit n != 1}'
# no forces are asked for by the columns, and the turning moment is there all the same
run 0 -S -c x,v engine.deck
prints 'mean_torque'
check 'no extremes of other columns' none '^Ts ' out
run 0 -S -s 'motion.acceleration=1 rad/s2' engine.deck
check 'no turning moment of an accelerated crank' none -E 'torque|energy|^flywheel_' out
run 0 -S "$alvi" engine.deck
check 'each deck under its name' test "$(grep -c '^# deck: ' out)" -eq 2
run 3 -S missing.deck engine.deck
prints 'mean_torque'

# ------------------------------------------------------------------------------ inputs, width

run 0 -S "$matrix"
holds 'inputs first, under their heading' '
    /^# input/ {input = NR} $1 == "ground.length" {length1 = NR == input + 1} /^# result/ {result = NR}
    $1 == "type" {type = NR}
    END {exit !(input == 3 && length1 && result > 20 && type == result + 1)}'
holds 'masses, inertias, centres, loads, gravity, speed' '
    $0 ~ /^crank.mass +0.1 kg +mass$/ {n++}
    $0 ~ /^coupler.inertia +[0-9.e-]+ kg.m2 +inertia about the centre of mass$/ {n++}
    $1 == "rocker.cg.x" && $3 == "mm" {n++}
    $1 == "gravity.y" && $2 == "-9.81" && $3 == "m/s2" {n++}
    $1 == "motion.speed" && $2 == "10.5" && $3 == "rad/s" {n++}
    $0 == "load Tl.link          rocker" {n++}
    $1 == "load" && $2 == "Tl.torque" && $4 == "N.m" {n++}
    END {exit n != 7}'
holds '6 digits' '
    /^#/ {next}
    {for (i = 2; i <= 4; i++) {x = $i; sub(/e.*/, "", x); gsub(/[^0-9]/, "", x); sub(/^0+/, "", x)
         if ($i ~ /^-?[0-9.]+(e[-+][0-9]+)?$/ && length(x) > 6) bad = 1}}
    END {exit bad}'
run 0 -S engine.deck
holds 'gas with its units' '
    $1 == "gas.area" && $3 == "mm2" {n++} /^gas.indicator +a curve$/ {n++} /^gas.back_area/ {bad = 1}
    $1 == "flywheel.fluctuation" && $2 == "0.02" && $3 == "1" {n++}
    END {exit n != 3 || bad}'
for deck in "$data"/*.deck "$decks/gas-engine.deck" "$decks/reach.deck"; do
    "$fourlink" -S -c all -s table.digits=17 "$deck" >out
    holds "$deck with 17 digits fits 100 columns" 'length > 100 {print; exit bad = 1} END {exit bad || NR < 10}'
    "$fourlink" -S "$deck" >out
    holds "$deck: a meaning for each number" '
        /^#/ {on = 1; next} on && $2 ~ /^-?[0-9.]+(e[-+][0-9]+)?$/ && NF < 4 {print; exit bad = 1} END {exit bad}'
    holds "$deck: each fact once" '
        /^# result/ {on = 1} /^# column/ || !on || /^(type|theta[24]_(from|to|swing)) / {next}
        {branch = / (open|crossed)(,|$)/ ? / open(,|$)/ + 0 : "both"}
        seen[$1, branch]++ || ($1 in both) || (branch == "both" && $1 in any) {print; exit bad = 1}
        {any[$1] = 1} branch == "both" {both[$1] = 1}
        END {exit bad}'
done
{ cat "$alvi" && printf '[load a-load-with-a-name-of-48-letters-xxxxxxxxxxxxxxx]\nlink = rocker\nforce = (-12345.6, 7) N\nat = 1 mm\n'; } >long.deck
run 0 -S long.deck
holds 'a long name' '/^load a-load-.*force.x -12345.6 N +force$/ {n++} length > 100 {bad = 1} END {exit bad || n != 1}'

run 0 -S "$alvi"
prints '# result                    value unit   meaning'
holds 'meanings stand below each other, behind value and unit' '
    /^# result/ {on = 1; next} /^# column/ {on = 0} on && $2 ~ /^-?[0-9.]+$/ {n++; if (substr($0, 41, 1) != " " || substr($0, 42, 1) == " ") bad = 1}
    END {exit bad || n < 10}'
prints '# column                 min    at deg          max    at deg unit   branch'
prints 'omega3              -3.70435   13.5618      3.22371   232.402 rad/s  open'
run 0 -S -c Ts,residual "$data/dfa-example-1.deck"
holds 'a measure of rounding has no crank angle' '
    $1 == "residual" && NF == 5 && $2 < 1e-12 && $3 < 1e-12 {ok = 1} END {exit !ok}'

# ------------------------------------------------------------------------------ --summary, csv

run 0 -S -f csv -b open -c theta4 "$alvi"
quiet
tr -d '\r' <out >plain
mv plain out
check 'the header' test "$(head -n 1 out)" = 'name,value,unit,theta2,branch'
holds 'five fields' 'BEGIN {FS = ","} NF != 5 {bad = 1} END {exit bad || NR < 10}'
check 'the type' grep -qx 'type,crank-rocker,,,' out
check 'inputs first' test "$(sed -n 2p out)" = 'ground.length,0.080000000000000002,m,,'
check 'the speed' grep -qx 'motion.speed,10.5,rad/s,,' out
holds 'a limit' '
    BEGIN {FS = ","} function near(x, y) {return x - y < 1e-11 && y - x < 1e-11}
    $1 == "theta4_min" {ok = near($2, 103.8180441982515182) && $3 == "deg" &&
                             near($4, 39.22131564862997612) && $5 == "open"}
    END {exit !ok}'
holds '17 digits' '
    BEGIN {FS = ","} NR > 1 && $3 != "" && sprintf("%.17g", $2) != $2 {bad = 1} length($2) > 16 {long++}
    END {exit bad || long < 5}'
run 0 -S -f csv engine.deck
check 'a comma in a fact is quoted' grep -q '^type,"slider-crank, the crank turns fully",,,' out
check 'the end of the lines' none "$cr" out
cp engine.deck 'a "b", c.deck'
run 0 -S -f csv "$alvi" 'a "b", c.deck'
check 'a column deck' test "$(head -n 1 out)" = "deck,name,value,unit,theta2,branch"
check 'one header' test "$(grep -c 'name,value' out)" -eq 1
check 'its name' grep -q '^"a ""b"", c.deck",mean_torque,' out
# the same numbers in both formats
run 0 -S -f csv -b open engine.deck
mv out records
run 0 --units=SI -S -s table.digits=12 -b open engine.deck
awk 'NR == FNR {split($0, field, ","); if (field[1] != "type") value[field[1]] = field[2]; next}
    /^# column/ {on = 1}
    /^#/ || $1 == "type" || $1 == "residual" || $2 == "a" {next}
    {name = on ? "min(" $1 ")" : $1; $1 = name} on {extremes++}
    {d = $2 - value[$1]; if (d < 0) d = -d; if (d > 1e-10 * (value[$1] < 0 ? -value[$1] : value[$1])) bad = 1
     n++}
    END {exit bad || n < 10 || extremes < 5}' records out
check 'the same numbers as a table and in csv' test $? -eq 0

# ---------------------------------------------------------------------------------------- extremes

# Of extremes that are equal the first is told: over two revolutions, and over a clockwise one; angles are
# followed from the first row.
run 0 --summary --format=csv --columns=x,v,theta3 --branch=open --set 'motion.cycle=720 deg' \
    --set 'motion.to=720 deg' "$decks/engine.deck"
check 'max(x) of two revolutions' grep -q '^max(x),\(300\|299.9999\|300.0000\)[0-9]*,mm,1\(80\|79.9999\|80.0000\)[0-9]*,open' out
check 'min(v) of two revolutions' grep -q '^min(v),-16566.[0-9]*,mm/s,286.8[0-9]*,open' out
run 0 --summary --format=csv --columns=x --branch=open --set 'motion.speed=-1000 rpm' \
    "$decks/engine.deck"
check 'max(x) clockwise' grep -q '^max(x),\(300\|299.9999\|300.0000\)[0-9]*,mm,-1\(80\|79.9999\|80.0000\)[0-9]*,open' out
run 0 --summary --format=csv --columns=theta4 "$data/me3491-exercise-1.deck"
check 'from the first row of a clockwise range' grep -q '^max(theta4),244.53[0-9]*,deg,-40.1[0-9]*,crossed' out

# A drag link's rocker turns with the crank: in a revolution by a whole turn, from -83.53 deg on.
printf 'mechanism = four-bar\n[ground]\nlength = 60 mm\n[crank]\nlength = 200 mm\n[coupler]\nlength = 180 mm\n' >drag.deck
printf '[rocker]\nlength = 130 mm\n[motion]\nspeed = 1 rad/s\n' >>drag.deck
run 0 --summary --format=csv --columns=theta4 --branch=open drag.deck
check 'max(theta4) of a drag link' grep -q '^max(theta4),276.467[0-9]*,deg,360,open' out
check 'min(theta4) of a drag link' grep -q '^min(theta4),-83.532[0-9]*,deg,0,open' out

# why a machine goes no further, on both branches for the same reason, is there once
cat >stalls.deck <<'DECK'
mechanism = four-bar
[ground]
length = 80 mm
[crank]
length = 20 mm
mass = 1 kg
inertia = 0.01 kg m2
[coupler]
length = 66 mm
[rocker]
length = 56 mm
[gravity]
acceleration = 0
[load L]
link = crank
torque = -5 N m
[motion]
mode = free
speed = 10 rad/s
interval = 30 deg
DECK
run 0 -S stalls.deck
check 'one end' test "$(grep -c '^end' out)" -eq 1
check 'of both branches' none '^end .*open' out
run 0 -S -f csv stalls.deck
check 'csv has both' test "$(grep -c '^end,' out)" -eq 2

# a parallelogram: its coupler does not turn, and what is computed of that is rounding
cat >parallel.deck <<'DECK'
mechanism = four-bar
[ground]
length = 100 mm
[crank]
length = 40 mm
[coupler]
length = 100 mm
[rocker]
length = 40 mm
[motion]
speed = 120 rpm
interval = 15 deg
DECK
run 0 -b open -S parallel.deck
holds 'rounding is 0, without a crank angle' '
    $1 ~ /^(omega3|alpha3|alpha4)$/ {n += $2 == "0" && $3 == "0" && $4 ~ /^rad/} END {exit n != 3}'

finish
