#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
#
# test_tables.sh FOURLINK DATA [all] - the tables of reports have what the other outputs have (tables.awk): of chosen decks,
# and of more.
. "$(dirname "$0")/../harness.sh"

# tables DECK [UNITS]: those of its report, in the units of its pictures
tables() {
    units=--units=${2-mm,m/s,m/s2}
    "$fourlink" --report=r.html --branch=both "$1" >out 2>err
    "$programs/cells" r.html | tr -d '\r' >cells
    "$fourlink" $units --format=json --summary --branch=both "$1" >summary 2>err
    "$fourlink" $units --wide --branch=both "$1" >rows 2>err
    set -- "$1" cells json=1 summary json=0 text=1 rows text=0
    angle=$(sed -n 's/.*At θ₂ = \([^,:]*\), open branch.*/\1/p' r.html | sed 's/−/-/' | head -n 1)
    if [ "$angle" ]; then
        "$fourlink" $units --matrix --branch=open --set="motion.at=$angle" "$1" >matrix 2>err
        set -- "$@" matrix=1 matrix matrix=0
    fi
    "$fourlink" $units --format=json --check "$1" >check 2>err
    deck=$1
    shift
    LC_ALL=C awk -v where="$(basename "$deck")" -f "$decks/../report/tables.awk" "$@" check=1 check >wrong 2>&1
    status=$?
    check "$deck: $(head -n 5 wrong)" test $status -eq 0
    passed=$((passed + $(sed -n 's/ passed.*//p' wrong)))
    check "$deck: $(awk -f "$decks/../report/points.awk" r.html | head -n 3)" awk -f "$decks/../report/points.awk" r.html
}
# with mistakes, an unknown name and a misprint that is none
{
    cat "$decks/expectations.deck"
    printf '[expect]\nat = 40\nphi = 104 deg\ntheta3 = 347.6 deg\nno_such = 1\nstroke = 0.1 m\n[misprint]\nat = 90 deg\nphi = 19.47 deg\n'
} >wrong.deck
for deck in "$decks/expectations.deck" wrong.deck "$decks/reach.deck" "$decks/rubbing-lever.deck"; do
    tables "$deck"
done
tables "$data/gerstmayr-run-up.deck" m,m/s,m/s2
for deck in ${3+"$alvi" "$decks/gas-engine.deck" "$data/whitworth-150-100.deck" "$data/../doc/motor-pump.deck"}; do
    tables "$deck"
done

# --- a changed cell is found
tables "$matrix"
sed 's/^row	theta4	°/row	theta4	rad/' cells >changed
check 'the change' differ cells changed
awk -f "$decks/../report/tables.awk" changed json=1 summary json=0 text=1 rows text=0 matrix=1 matrix matrix=0 check=1 check >wrong
check 'a changed unit is found' test $? -ne 0
sed 's/--behind: 0/--behind: 1/' r.html >changed
check 'a point beside the others is found' sh -c "! awk -f $decks/../report/points.awk changed >wrong"
finish
