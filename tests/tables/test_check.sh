#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
#
# test_check.sh FOURLINK DATA - --check: a line for each printed value, exit status; the decks of data/.
. "$(dirname "$0")/../harness.sh"

cp "$decks/expectations.deck" good.deck

for form in -C --check; do
    run 0 $form good.deck
    quiet
done
lines out 7
check 'a line for each' grep -Eq '^ok +good.deck:9: n = 3\.0, computed 3, open$' out
check 'with its unit' grep -Eq '^ok +good.deck:10: stroke = 200 mm, computed 200 mm, open$' out
check 'in words' grep -Eq '^ok +good.deck:11: type = .*, computed slider-crank, the crank turns fully, open$' out
check 'with its angle' grep -Eq '^ok +good.deck:14: phi = 19\.47 deg, computed 19\.4712206345 deg at 90 deg, open$' out
check 'a misprint' grep -Eq '^misprint confirmed +good.deck:16: n = 4, computed 3, open$' out
check 'the sum' test "$(tail -n 2 out | head -n 1)" = '# ok: 4, misprint confirmed: 1, differs: 0, not a misprint: 0, no value: 0'

sed 's/^stroke = 200/stroke = 210/; s/^n = 4/n = 3/' good.deck >wrong.deck
run 1 -C wrong.deck
quiet
check 'what differs' grep -q '^differs  *wrong.deck:10: ' out
check 'what is no misprint' grep -q '^not a misprint  *wrong.deck:16: ' out
check 'the sum' test "$(tail -n 2 out | head -n 1)" = '# ok: 3, misprint confirmed: 0, differs: 1, not a misprint: 1, no value: 0'
sed 's/^stroke = 200/stroke = 210/' good.deck >differs.deck
run 1 -C differs.deck
sed 's/^n = 4/n = 3/' good.deck >no-misprint.deck
run 1 -C no-misprint.deck
# the same physics, another deck
run 1 -C -s 'rod.length=310 mm' good.deck
check 'a changed deck' grep -q '^differs  *good.deck:9: ' out
"$fourlink" -C <wrong.deck >out 2>err
check 'standard input' test $? -eq 1
prints '<stdin>:10: stroke'

# exit status 2: nothing to compare, or not to be compared: no value, and why
run 2 -C "$alvi"
nothing
says "$alvi:1: error: nothing to check"
sed 's/^stroke/strok/' good.deck >unknown.deck
run 2 -C unknown.deck
check 'no value, and the others' grep -q '^no value  *unknown.deck:10: strok' out
says "unknown.deck:10: error: 'strok' is neither a column nor a fact of this deck"
sed 's/^phi = 19.47 deg/phi = 19.47 mm/' good.deck >unit.deck
run 2 -C unit.deck
check 'no value, and the others' grep -q '^no value  *unit.deck:14: phi' out
says "unit.deck:14: error: '19.47 mm' is a length; expected an angle"
run 2 -C -s 'crank.length=2 m' good.deck
check 'no value where the rod does not reach' grep -q '^no value  *good.deck:14: ' out
says 'good.deck:14: error: no value at theta2 = 90 deg, open: the rod does not reach'
run 3 -C missing.deck
says 'missing.deck'
run 0 -C -o report good.deck
nothing
"$fourlink" -C good.deck >out
same out report

# ------------------------------------------------------------------------- a file for each deck

for deck in "$data"/*.deck; do
    expect=${deck%deck}expect
    if [ -e "$expect" ]; then
        run 0 "--check=$expect" "$deck"
    else
        run 0 --check "$deck"
    fi
    quiet
    holds "values of $deck" '/^(ok|misprint confirmed) / {n++} /^(differs|not)/ {bad = 1} END {exit bad || !n}'
done
for expect in "$data"/*.expect; do
    check "the deck of $expect" test -e "${expect%expect}deck"
done
# two branches, nine angles, six columns
run 0 "--check=$data/alvi-5.1.expect" "$alvi"
holds 'the printout of the paper is compared whole' '/^(ok|misprint confirmed) / {n++} END {exit n != 112}'
run 1 "--check=$data/alvi-5.1.expect" -s 'coupler.length=67 mm' "$alvi"
run 1 -C -s 'coupler.mass=0.31 kg' "$data/me3491-matrix.deck"

# ------------------------------------------------------------------------- option conflicts

for pair in '-C -S' '-C -m' '-C -l' '-S -m' '-S -l' '--check=answers --summary' '-CS' '-SC'; do
    run 2 $pair good.deck
    nothing
    says 'use only one of'
done
for option in -C -S --check=answers; do
    run 2 -f paper $option "$alvi"
    nothing
    says 'can be printed as table, csv or json only'
done
run 2 --summary=yes good.deck
says '--summary takes no value'
# an empty name is a shell variable that is not set, not the deck's own values
run 2 --check= good.deck
run 2 --chek good.deck
says "did you mean '--check'?"

# ---------------------------------------------------------------------- angles of several turns

# An angle of [expect] is another position in another turn where a cycle takes two, or where one change
# point lets the links come back on the other side.
cat >four-stroke.deck <<'DECK'
mechanism = slider-crank
[crank]
length = 5 cm
[rod]
length = 20 cm
[gas]
bore = 100 mm
indicator = 0 deg 1 bar, 20 deg 30 bar, 180 deg 1 bar, 380 deg 2 bar, 540 deg 1 bar
[motion]
speed = 10 rad/s
cycle = 720 deg
to = 720 deg
[expect]
at = 20 deg
gas_force = 23561.94 N # 30 bar on pi/4 (10 cm)^2
[expect]
at = 380 deg
gas_force = 1570.796 N # 2 bar
[expect]
at = 740 deg
gas_force = 23561.94 N
DECK
run 0 --check four-stroke.deck
run 2 --check -s motion.to=360 four-stroke.deck
says 'does not reach'
cat >change-point.deck <<'DECK'
mechanism = four-bar
[ground]
length = 60 mm
[crank]
length = 50 mm
[coupler]
length = 70 mm
[rocker]
length = 40 mm
[motion]
speed = 1 rad/s
to = 720 deg
[table]
branch = open
columns = theta2, theta4
DECK
run 1 -f csv change-point.deck # the change points themselves have no row
for angle in 40 400; do
    value=$(awk -F, -v x=$angle '$2 == x {print $3}' out)
    printf '[expect]\nat = %s deg\nbranch = open\ntheta4 = %.6f deg\n' $angle "$value" >>change-point.deck
done
check 'two positions' test "$(sed -n 's/^theta4 = //p' change-point.deck | sort -u | wc -l)" -eq 2
run 0 --check change-point.deck

# an unbounded value is inf or -inf, with its unit or without
cat >parallelogram.deck <<'DECK'
mechanism = four-bar
[ground]
length = 2 m
[crank]
length = 1 m
mass = 1 kg
[coupler]
length = 2 m
mass = 1 kg
[rocker]
length = 1 m
mass = 1 kg
cg = 0.5 m
[motion]
speed = 10 rad/s
[table]
branch = open
DECK
for value in inf 'inf N'; do
    { cat parallelogram.deck && printf '[expect]\nmax(F12x) = %s\nmin(F12x) = -%s\n' "$value" "$value"; } >inf.deck
    run 0 --check inf.deck
done
for value in '-inf N' '5 N'; do
    { cat parallelogram.deck && printf '[expect]\nmax(F12x) = %s\n' "$value"; } >inf.deck
    run 1 --check inf.deck
done
for value in inf5 'inf m' infinity; do
    { cat parallelogram.deck && printf '[expect]\nmax(F12x) = %s\n' "$value"; } >inf.deck
    run 2 --check inf.deck
    check "a mistake: $value" grep -q 'inf.deck:[0-9]*: error: ' err
done

# an angle read clockwise, or in another unit; a value cut off, not rounded
whole() { "$fourlink" -f csv -b open -c "$1" --at="$2" "$alvi" | sed -n 's/^open,\([^,]*\),.*/\1/p'; }
hinted() { # VALUE COLUMN UNIT: what is told of it at 60 deg
    printf '[expect]\nat = 60 deg\n%s = %s %s\n' "$2" "$1" "$3" >answers.txt
    "$fourlink" -b open --check=answers.txt "$alvi" >out
}
hinted "$(whole theta4 '300 deg' | cut -c1-7)" theta4 deg
check "clockwise: $(head -n 1 out)" grep -q 'hint: .* is the value at theta2 = -60: angles are counter-clockwise$' out
hinted "$(printf %.4f "$(whole omega4 '197.7467707849 deg')")" omega4 rad/s
check "radians: $(head -n 1 out)" grep -q 'hint: .* is the value at theta2 = 60 rad$' out
hinted "$(whole theta4 '60 deg' | cut -c1-6)" theta4 deg # 105.626
check "cut off: $(head -n 1 out)" grep -q 'hint: the computed value is cut off there, not rounded$' out
finish
