#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
#
# test_rfc4180.sh FOURLINK DATA - csv of rows, summaries, checks, scores and designs, with names that need quotes, is
# what RFC 4180 says but for LF at the end of lines: Python reads it as strictly as it can, and writes the same bytes
# again.
. "$(dirname "$0")/../harness.sh"
needs python3 python3

# sound WHAT: the output of the last run
sound() {
    found=$(round_trip 2>&1)
    check "$1: $found" test "$found" = sound
}
round_trip() {
    python3 -c "
import csv, io
text = open('out', encoding='utf-8', newline='').read()
records = list(csv.reader(io.StringIO(text, newline=''), strict=True))
again = io.StringIO(newline='')
csv.writer(again, lineterminator='\n').writerows(records)
same = text == again.getvalue()
widths = {len(record) for record in records}
print('sound' if same and len(widths) == 1 and len(records) > 1 else '%s records of %s fields, same bytes: %s' % (
    len(records), widths, same))"
}

cp "$decks/engine.deck" 'a "b", c.deck'
sed 's/^crank/cr,nk/' "$alvi" >bad.deck
printf '[expect]\ntype = slider-crank, the crank turns fully\nstroke = 9,9 mm\n' >answers
for deck in "$alvi" "$decks/reach.deck" "$decks/gas-engine.deck" "$data/oscillating-cylinder.deck"; do
    "$fourlink" -f csv -c all "$deck" >out 2>err
    sound "rows of $deck"
    "$fourlink" -f csv -S -c all "$deck" >out 2>err
    sound "summary of $deck"
done
"$fourlink" -f csv "$alvi" 'a "b", c.deck' >out 2>err
sound 'rows of two decks'
"$fourlink" -f csv -S "$alvi" 'a "b", c.deck' >out 2>err
sound 'summaries of two decks'
# the names arrive as they are, with line ends in them too
odd=$(printf 'a\nb,"c".deck')
cp "$alvi" "$odd"
"$fourlink" -f csv -S "$odd" 'a "b", c.deck' >out 2>err
sound 'names with line ends'
check 'the names' test "$(python3 -c "
import csv
records = list(csv.reader(open('out', encoding='utf-8', newline='')))
print(sorted({record[0] for record in records[1:]}))")" = "['a\\nb,\"c\".deck', 'a \"b\", c.deck']"
"$fourlink" -f csv --check=answers 'a "b", c.deck' >out 2>err
sound 'a check'
"$fourlink" -f csv --check=answers "$alvi" 'a "b", c.deck' bad.deck >out 2>err
sound 'scores'
{ cat "$alvi"; printf '[sweep]\ncrank.length = 18 mm, -1 mm, 300 mm, 22 mm\noutput = mu_min, type\n'; } >sweep.deck
"$fourlink" -f csv sweep.deck >out 2>err
sound 'designs'
"$fourlink" -f csv --set='sweep.yield=mu_min > 50 deg' sweep.deck >out 2>err
sound 'designs with a yield'

finish
