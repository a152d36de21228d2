#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
#
# test_replayed.sh FOURLINK DATA SCENES [FOLDER] - the script of a report draws at each step what the program drew, by replay.js,
# of chosen decks, with ALL_CASES in the environment of more of them, or of those of a folder.
. "$(dirname "$0")/../harness.sh"
tests=$(dirname "$decks")
scenes=$3
needs node nodejs

# shown DECK: cells and captions beside the drawings, and where a pointer is, by shown.js
shown() {
    branch=$(sed -n 's/^"branches":\[{*"name":"\([a-z]*\)".*/\1/p; s/^{"name":"\(open\|crossed\)".*/\1/p' "$name.json" | head -n 1)
    "$fourlink" --wide -b "${branch:-open}" "$1" >table 2>err
    grep -q '^# theta2 ' table && grep -q '^ *-\{0,1\}[0-9]' table || return 0 # no rows
    node "$tests/report/shown.js" "$data/../src/report" "$name.json" table >out 2>&1
    check "$name: $(head -n 3 out)" grep -q ' compared, 0 wrong' out
}

# replay DECK EVERY: so many of its steps
replay() {
    name=$(basename "$1" .deck)
    "$scenes" "$1" "$name.frames" "$2" >"$name.json" 2>err || return 0 # no drawing
    node "$tests/report/replay.js" "$data/../src/report" "$name.json" "$name.frames" $(grep -q '^slot *=' "$1" && echo slots) >out 2>&1
    check "$name: $(head -n 3 out)" grep -q ' drawings, 0 wrong, ' out
    tail -n 1 out >>all
    [ "$1" = none.deck ] || shown "$1"
    rm -f "$name.json" "$name.frames"
}

: >all
# a motion without a position, of which the page draws the crank alone
printf 'mechanism = slider-crank\n[ground]\noffset = 60 mm\n[crank]\nlength = 40 mm\nmass = 1 kg\n[rod]\nlength = 50 mm\n' >none.deck
printf '[gravity]\ndirection = -60 deg\n[motion]\nspeed = 10 rad/s\nfrom = 200 deg\nto = 230 deg\n' >>none.deck
replay none.deck 5
if [ "${4-}" ]; then
    for deck in "$4"/*.deck; do
        replay "$deck" 17
    done
else
    set -- "$tests"/report/look/friction.deck "$data"/synthesis/log10.deck
    [ "${ALL_CASES-}" ] && set -- "$@" "$data"/alvi-5.1.deck "$tests"/report/look/change.deck "$data"/me3491-exercise-4.deck "$data"/me3491-example-2.deck \
        "$data"/oscillating-cylinder.deck "$data"/synthesis/three-positions.deck
    for deck; do
        replay "$deck" 41
    done
fi
awk '{drawings += $1; labels += $5; out += $11; if ($7 > most) most = $7}
    END {printf "%d decks, %d drawings compared, %d labels, %d left out, %s pixels at most\n", NR, drawings, labels, out, most}' all
# Without a position the x axis goes out of the sheet, so its label is not there.  Random decks are crowded.
share=20
[ -z "${4-}" ] || share=10
check "labels that are left out: $(cat all)" test "$(awk -v share=$share 'NR > 1 {n += $5 - share * $11} END {print n + 0}' all)" -gt 0
least=100
[ "${4-}${ALL_CASES-}" ] || least=30
check "drawings: $(wc -l <all)" test "$(awk '{n += $1} END {print n + 0}' all)" -gt $least
finish
