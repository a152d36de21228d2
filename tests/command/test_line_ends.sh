#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
#
# test_line_ends.sh FOURLINK DATA - decks, answers and cards whose lines end in LF, CR LF or CR.
. "$(dirname "$0")/../harness.sh"

# with_ends END FILE: a copy of the file with other ends of lines.
with_ends() { awk -v ORS="$1" '{print}' "$2" >"$2.new" && mv "$2.new" "$2"; }

printf 'Angle;Pressure\ndeg;bar\n0;1\n90;20,5\n180;4\n' >card.lf
{
    printf '# a deck\nmechanism = slider-crank\n[crank]\nlength = 5 cm # a comment\n[rod]\nlength = 20 cm\n'
    printf '[gas]\nbore = 10 cm\nindicator = file card.txt\n[load]\nlink = rod\ntorque = 0 deg 1 N m, # goes on\n 90 deg 2 N m\n'
    printf '[motion]\nspeed = 10 rad/s\ninterval = 90 deg\n[expect]\nstroke = 100 mm\n'
} >deck.lf
printf '[expect]\nstroke = 100 mm\n' >answers.lf
for end in '\n' '\r\n' '\r'; do
    for file in card.txt:card.lf x.deck:deck.lf answers:answers.lf; do
        cp "${file#*:}" "${file%:*}"
        with_ends "$end" "${file%:*}"
    done
    run 0 -f csv x.deck
    quiet
    [ "$end" = '\n' ] && cp out rows
    same out rows
    run 0 --check x.deck
    prints 'x.deck:18'
    run 0 --check=answers x.deck
    prints 'answers:2'
    run 0 --plot-kind=turning-moment --plot=x.svg x.deck
    [ "$end" = '\n' ] && cp x.svg picture
    same x.svg picture
done
printf 'mechanism = four-bar\r[crank]\rlenght = 1 m\r' >x.deck
run 2 x.deck
says "x.deck:3: error: unknown key 'lenght' in [crank]; did you mean 'length'?"

# the best design of a sweep is a deck again
{
    sed 's/^interval.*/interval = 10 deg/; /^\[load\]/,/^ 90/d' deck.lf
    printf '[sweep]\ncrank.length = 4 cm to 5 cm step 1 cm\n'
} >x.deck
cp card.lf card.txt
run 0 --best='max stroke' x.deck
cp out best
with_ends '\r' x.deck
run 0 --best='max stroke' x.deck
same out best

finish
