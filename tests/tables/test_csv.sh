#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
#
# test_csv.sh FOURLINK DATA - --format=csv: header, digits, quotes, rows without values, several decks.
. "$(dirname "$0")/../harness.sh"

cp "$decks/reach.deck" .
cp "$decks/pump.deck" engine.deck

"$fourlink" -f csv "$alvi" | tee csv >out
check 'every line ends in LF alone' none "$cr" out
check "the status is the last field of a line" test "$(awk -F, '$NF == "ok"' out | wc -l)" -eq 20
lines out 21
header='branch,theta2 (deg),theta3 (deg),omega3 (rad/s),alpha3 (rad/s2),theta4 (deg),omega4 (rad/s),alpha4 (rad/s2),mu (deg),status'
check 'the header' test "$(head -n 1 out)" = "$header"
check 'one header' test "$(grep -c theta2 out)" -eq 1
holds 'fields, branches, status' '
    BEGIN {FS = ","} NF != 10 {bad = 1} NR > 1 && $10 != "ok" {bad = 1} NR > 1 {n[$1]++}
    END {exit bad || n["open"] != 10 || n["crossed"] != 10}'
holds '17 significant digits' '
    BEGIN {FS = ","}
    NR > 1 {for (i = 2; i < NF; i++) {
        if (sprintf("%.17g", $i) != $i) bad = 1
        digits = $i; gsub(/[-.]|e.*/, "", digits); if (length(digits) >= 16) long++}}
    END {exit bad || long < 100}'
check 'the row of 40 deg' grep -q '^open,40,38\.98634752[0-9]*,-3\.15487421[0-9]*,20\.956489[0-9]*,103\.8207648[0-9]*,' out

run 1 -f csv reach.deck
check 'empty cells and the reason' grep -q "^open,200,,,,,,,,cannot be assembled: B and D are too far apart\$" out
check 'numbers beside them' grep -q '^open,40,[-0-9.e]*,[-0-9.e]*,[-0-9.e]*,[-0-9.e]*,[-0-9.e]*,[-0-9.e]*,[-0-9.e]*,ok' out

# what is not defined: the offset of no inertia force, a centre at infinity
undefined='--set=motion.interval=90deg --columns=theta2,h2,I13x,omega3 --branch=open engine.deck'
run 0 $undefined
check 'nan in a table' test "$(grep -v '^#' out | awk '{printf "%s%s ", $2, $3 == "nan" ? "-" : "+"}')" = 'nan+ nan- nan+ nan- nan+ '
run 0 -f csv $undefined
check 'empty in csv' test "$(awk -F , 'NR > 1 {printf "%s%s ", $3, $4 == "" ? "-" : "+"}' out)" = '+ - + - + '
run 0 -f json $undefined
check 'null in json' test "$(grep -c '"values":\[[0-9]*,null,null,' out)" -eq 2
run 0 --summary $undefined
check 'extremes pass over it' grep -Eq '^I13x( +[-0-9.]+){2} +1500 +[-0-9.]+ mm' out
check 'and there is none of what is nowhere defined' test "$(grep -c 'h2' out)" -eq 0

# quoting, and one header for several decks
cp "$alvi" 'a "b", c.deck'
run 0 -f csv 'a "b", c.deck' engine.deck
check 'quotes' grep -q '^"a ""b"", c.deck",open,0,' out
check 'one header for both' test "$(grep -c theta2 out)" -eq 1
check 'its first column' grep -q '^deck,branch,theta2 (deg),' out
sed 's/^"[^,]*, c.deck"/A/' out >plain
mv plain out
holds 'the union of the columns, empty where a deck has none' '
    BEGIN {FS = ","}
    NR == 1 {n = NF; for (i = 1; i <= NF; i++) at[$i] = i}
    NF != n {bad = 1}
    $1 == "A" && ($(at["x (m)"]) != "" || $(at["theta4 (deg)"]) == "") {bad = 1}
    $1 == "engine.deck" && ($(at["x (m)"]) == "" || $(at["theta4 (deg)"]) != "") {bad = 1}
    END {exit bad || !at["x (m)"] || !at["theta4 (deg)"] || at["status"] != n}'
"$fourlink" -f csv - engine.deck <"$alvi" >out
check 'standard input among several decks' grep -q '^<stdin>,open,40,38.98' out

# decks of different units share no column: none may be lost
number=0
for units in 'm:deg:rad/s:rad/s2:N:N m:W' 'mm:rad:rpm:rpm/s:kN:lbf ft:kW' \
    'cm:mrad:deg/s:deg/s2:lbf:lbf in:hp' 'in:rev:rev/s:rev/s2:kgf:kgf m:J/s'; do
    number=$((number + 1))
    echo "$units" | {
        IFS=: read -r length angle speed acceleration force torque power
        cat "$matrix"
        printf '[units]\nlength = %s\nangle = %s\nangular_speed = %s\nangular_acceleration = %s\n' \
            "$length" "$angle" "$speed" "$acceleration"
        printf 'force = %s\ntorque = %s\npower = %s\n' "$force" "$torque" "$power"
    } >units$number.deck
done
run 0 -f csv -c all units1.deck units2.deck units3.deck units4.deck
for column in 'Ts (N.m)' 'Ts (lbf.ft)' 'Ts (lbf.in)' 'Ts (kgf.m)' 'power (J/s)'; do
    check "the column $column of several decks" grep -qF ",$column," out
done

finish
