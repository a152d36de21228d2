#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
#
# test_decks.sh FOURLINK DATA - decks from standard input, and several decks in one run.
. "$(dirname "$0")/../harness.sh"

cp "$decks/reach.deck" "$decks/bad.deck" .
cp "$decks/pump.deck" engine.deck
: >empty.deck
"$fourlink" "$alvi" >table
"$fourlink" -f csv "$alvi" >csv

# standard input
"$fourlink" <"$alvi" >out 2>err
check 'a deck on standard input' test $? -eq 0
same out table
"$fourlink" - <"$alvi" >out 2>err
same out table
"$fourlink" <bad.deck >out 2>err
check 'a bad deck on standard input' test $? -eq 2
nothing
says '<stdin>:5: error:'
cat "$alvi" | "$fourlink" -f csv - >out
same out csv
"$fourlink" <empty.deck >out 2>err
check 'nothing on standard input' test $? -eq 2
nothing
"$fourlink" <&- >out 2>err
check 'standard input closed' test $? -eq 3
nothing

# several decks, one of them bad: the others still run, and the status is the worst
run 0 -f csv "$alvi" engine.deck
check 'two decks' grep -q '^engine.deck,crossed,' out
for worst in '2 bad.deck' '3 missing.deck' '1 reach.deck'; do
    run ${worst%% *} -f csv "$alvi" ${worst#* } engine.deck
    check "alvi runs with $worst" grep -q "^$alvi,open,40,38.98" out
    check "engine runs with $worst" grep -q '^engine.deck,open,' out
done
run 3 missing.deck bad.deck reach.deck
says 'missing.deck'
says 'bad.deck:5'
prints 'A crank that cannot turn fully'
run 2 reach.deck bad.deck
run 3 -f csv bad.deck missing.deck
nothing
run 0 "$alvi" engine.deck
prints "# deck: $alvi"
prints '# deck: engine.deck'
holds 'four blocks, two blank lines apart' '
    /^$/ {blank++; next} {if (blank) {blocks++; if (blank != 2) bad = 1} blank = 0}
    END {exit bad || blocks != 3}'

# a place by steps: the sum of its steps
steps() { # PLACE X Y: in mm
    { cat "$alvi" && printf '[point P]\nlink = coupler\nat = %s\n' "$1"; } >steps.deck
    run 0 --summary -s table.digits=15 steps.deck
    check "$1: $(grep 'P.at' out)" awk -v x="$2" -v y="$3" 'function near(a, b) {return a - b < 1e-12 && b - a < 1e-12}
        /^point P.at.x / {ok += near($3, x)} /^point P.at.y / {ok += near($3, y)} END {exit ok != 2}' out
}
steps '9 mm at 0 deg + 3 mm at 90 deg' 9 3
steps '30 mm at 45 deg + 10 mm at 100 deg + (1, 2) mm' 20.476721658927122 33.0612809657185
steps '(1, 2) mm + (3, 4) mm' 4 6
steps '50 % + 25 % at 90 deg' 33 16.5
# from the centre of mass: with what the link has in this design
sed 's/^length *= 66 mm/&\nmass = 1 kg\ncg = 30 mm at 10 deg/' steps.deck >centre.deck
sed -i 's/^at = .*/at = G + 4 mm at 90 deg/' centre.deck
run 0 --summary -s table.digits=15 centre.deck
check "G: $(grep 'P.at' out)" awk 'function near(a, b) {return a - b < 1e-12 && b - a < 1e-12}
    BEGIN {d = 3.14159265358979323846 / 18} /^point P.at.x / {ok += near($3, 30 * cos(d))}
    /^point P.at.y / {ok += near($3, 30 * sin(d) + 4)} END {exit ok != 2}' out
run 0 -f csv -b open -c G3.x,G3.y,P.x,P.y,theta3 --units=mm -s 'point P.at=G' centre.deck
check 'G itself' awk -F, 'NR > 1 {if (($2 - $4) ^ 2 + ($3 - $5) ^ 2 > 1e-20) bad++} END {exit bad || NR < 9}' out
run 0 -f csv -b open -s 'sweep.coupler.cg.x=10 mm, 20 mm' -s 'sweep.output=max(P.y)' centre.deck
check 'it follows a design' test "$(awk -F, 'NR > 1 {print $4}' out | sort -u | wc -l)" -eq 2
run 2 -s 'coupler.cg=G' centre.deck
says "'G': G is the centre of mass itself"
run 2 -s 'point P.at=G + 3 mm' steps.deck
says "'G + 3 mm' is from the centre of mass, and the coupler has no mass"
run 2 -s 'point P.at.x=3 mm' centre.deck
says "'G + 4 mm at 90 deg' is from the centre of mass"
for place in '50 % + 3 mm' '3 mm +' '3 mm + mm' '3 mm + 4 kg' '(1, 2) + 3 mm, 4'; do
    sed "s/^at = .*/at = $place/" steps.deck >bad.deck
    run 2 bad.deck
    check "refused: $place" grep -q '^bad.deck:[0-9]*: error: ' err
done
finish
