#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
#
# test_columns.sh FOURLINK DATA - any columns as curves: over the crank angle, over time, over another column.
. "$(dirname "$0")/pictures.sh"
# columns ARGUMENT...: the listing x.list
columns() { listed 0 x.list --plot-kind=columns "$@"; }
# block NAME: the places of a curve in x.list
block() { curve_of "$1" x.list; }
# has TEXT: a line of the listing
has() { check "the listing has no line: $1" grep -qxF -e "$1" x.list; }
panels() { check "$(grep -c '^drawn' x.list) panels, expected $1" test "$(grep -c '^drawn' x.list)" -eq "$1"; }

# --- panels by quantity: several columns on each branch, a column alone on both
columns -c theta2,theta3,F12,theta4,Ts,F23,omega4 "$fourbar"
quiet
panels 6
# drawn NAME WORDS NAME WORDS: a panel has these curves, no others, with these words in its key
drawn() {
    check "a panel of $1 and $3" awk -v wanted="curve1 $1 $2, curve2 $3 $4" '/^panel/ {n = 0} /^curve/ {name[$3] = $2; n++}
        sub(/^key /, "") {look = $1; sub(/^[^ ]* /, ""); words[look] = $0}
        /^drawn/ && n == 2 {found += "curve1 " name["curve1"] " " words["curve1"] ", curve2 " name["curve2"] " " words["curve2"] == wanted}
        END {exit found != 1}' x.list
}
drawn theta3_open θ₃ theta4_open θ₄
drawn F12_crossed F₁₂ F23_crossed F₂₃
drawn Ts_open open Ts_crossed crossed
has 'y angle (°)'
has 'y force (N)'
has 'y Tₛ (N·m)'
has 'y ω₄ (rad/s)'
has 'x θ₂ (°)'
# the columns of the deck, in the rows of its table; what measures rounding is left out
run 0 -b open -f csv --interval='0.5 deg' "$fourbar"
cp out rows
columns -b open "$fourbar"
check 'no panel of the residual' none residual x.list
number_of() { head -n 1 rows | tr ',' '\n' | tr -d '\r' | sed 's/ .*//' | grep -nxF "$1" | cut -d: -f1; }
for name in omega4 alpha3 Ts; do
    block "${name}_open" >curve
    check "the curve of $name is that of the table" awk -F'[, ]' -v c="$(number_of $name)" '
        NR == FNR {if (FNR > 1 && $1 == "open") {x[++n] = $2; y[n] = $c + 0; if (y[n] > size) size = y[n]}; next}
        NF {m++; d = $2 - y[m]; if (d < 0) d = -d; if (($1 - x[m]) ^ 2 > 1e-4 || d > 2e-3 * size) bad = 1}
        END {exit bad || n != m || n < 700}' rows curve
done
columns -c residual "$fourbar"
panels 1 # nothing else was asked for
# plain numbers have nothing in common
columns -b open -c mechanical_advantage,condition "$fourbar"
panels 2
# a key has room for so many names
columns -b open -c F12x,F12y,F23x,F23y,F34x,F34y,F14x,F14y "$fourbar"
panels 2

# --- over time, over another column
columns -b open -c theta4 --plot-x=time "$fourbar"
has 'x time (s)'
block theta4_open >curve
check 'time goes from 0 to a turn' awk 'NR == 1 {first = $1} {last = $1; if (NR > 1 && $1 <= before) bad = 1; before = $1} END {exit bad || first ^ 2 > 1e-9 || NR < 700 || last < 0.1}' curve
columns -b open -c P.x,P.y,F12 --plot-x=P.x "$fourbar"
panels 2 # not over itself
has 'x P.x (mm)'
check 'a path is drawn to scale' awk '$1 == "box" {w = $2; h = $3}
    $1 == "range" {r = ($3 - $2) / ($5 - $4) * h / w; exit !(r > 0.98 && r < 1.02)}' x.list
run 0 -b open -f csv -c P.x,P.y --interval='90 deg' "$fourbar"
tr -d '\r' <out | awk -F, 'NR > 1 {print $2, $3}' >points
columns -b open -c P.y --plot-x=P.x "$fourbar"
block P_y_open >curve
check 'the path passes the points of the table' awk 'NR == FNR {x[FNR] = $1; y[FNR] = $2; n = FNR; next}
    {for (i = 1; i <= n; i++) {d = ($1 - x[i]) ^ 2 + ($2 - y[i]) ^ 2; if (FNR == 1 || d < near[i]) near[i] = d}}
    END {for (i = 1; i <= n; i++) if (near[i] > 1) bad = 1; exit bad || n != 5}' points curve
# an angle is followed on the x axis as well: the lever of Whitworth's quick return turns fully
columns -b open -c slide --plot-x=theta4 "$data/whitworth-150-100.deck"
block slide_open >curve
check 'an angle is followed' awk 'NR == 1 {first = $1} NR > 1 && ($1 - last) ^ 2 > 900 {bad = 1} {last = $1} END {exit bad || (last - first) ^ 2 < 128000}' curve
# an indicator diagram: the four strokes
columns -c gas_force --plot-x=x "$decks/gas-engine.deck"
has 'x x (mm)'
block gas_force_open >curve
check 'four strokes' awk 'NR > 1 {s = $1 > last ? 1 : -1; if (s != way) turns++; way = s} {last = $1} END {exit turns != 4}' curve

# --- the p-V diagram: a closed loop, clockwise, whose area is the work of the gas
otto=$data/otto-4x4.deck
columns -c pressure --plot-x=volume "$otto"
panels 1
has 'x volume (in³)'
has 'y pressure (psi)'
block pressure_open >curve
"$fourlink" -S -f csv "$otto" | tr -d '\r' | awk -F, '/^(indicated_work|displacement),/ {print $2}' >facts
check 'the area of the diagram' awk '
    NR == FNR {fact[FNR] = $1; next}
    NF {if (n++) area += ($1 - x) * ($2 + y) / 2; else {x0 = $1; y0 = $2}; x = $1; y = $2; if ($1 > most) most = $1; if (n == 1 || $1 < least) least = $1}
    END {if (x != x0 || y != y0) exit 1
        exit !((area / fact[2] - 1) ^ 2 < 1e-6 && ((most - least) / fact[1] - 1) ^ 2 < 1e-8)}' facts curve

# --- breaks: no position, jumps of loads, unbounded values, no number
columns -b open -c F14 "$data/me3491-exercise-4.deck"
block F14_open >curve
check 'the load jumps twice' test "$(grep -c '^$' curve)" -eq 2
check 'a jump has its two ends' awk '!NF {if (getline > 0) {d = $2 - y; if (d < 0) d = -d; if (d < 10 || ($1 - x) ^ 2 > 1) bad = 1}; n++} {x = $1; y = $2} END {exit bad || n != 2}' curve
columns -b open -c theta4 "$data/me3491-exercise-4.deck"
check 'an angle does not jump' test "$(block theta4_open | grep -c '^$')" -eq 0
columns -b open -c mechanical_advantage "$data/me3491-exercise-4.deck"
check 'the frame has no pole' awk '$1 == "range" {exit !($4 > -100 && $5 < 100)}' x.list
check 'two poles' test "$(block mechanical_advantage_open | grep -c '^$')" -eq 2
check 'they are explained' grep -q 'beyond the frame where a value is unbounded' x.list
columns -b open -c I13y --plot-x=I13x "$alvi"
check 'an unbounded x has a frame' awk '$1 == "range" {exit !($3 - $2 < 10000)}' x.list
sed 's/^from .*/from = 0 deg/; s/^to .*/to = 360 deg/' "$data/me3491-exercise-1.deck" >turning.deck
listed 1 x.list --plot-kind=columns -b open -c theta4,F12 turning.deck
check 'no position, no curve' test "$(block theta4_open | grep -c '^$')" -eq 1
check 'near a dead position' grep -q 'beyond the frame near a dead position' x.list
listed 2 x.list --plot-kind=columns -c theta4 turning.deck --set='motion.from=150 deg' --set='motion.to=200 deg'
says 'the linkage cannot be assembled at any angle of the motion'
# a constant has an axis
columns -b open -c theta4 --plot-x=omega2 "$alvi"
check 'a constant x' awk '$1 == "range" {exit !($2 < 10.5 && $3 > 10.5)}' x.list

# --- one instant shows its cycle, with the instant marked
columns -c a --plot-x=time "$data/me3491-example-1.deck"
check 'the instant is marked' grep -q '^mark open 5 ' x.list
check 'on the curve' awk '/^mark open 5 / {x = $4; y = $5} /^curve a_open/ {on = 1} on && NF == 2 {px[++n] = $1; py[n] = $2}
    END {for (i = 1; i <= n; i++) if ((px[i] - x) ^ 2 < 1e-6 && (py[i] - y) ^ 2 < 1e-4 * y * y) found = 1; exit !found}' x.list

finish
