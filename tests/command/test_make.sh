#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
#
# test_make.sh FOURLINK DATA - the parts of a sweep, made by make: after an interruption only what is missing.
. "$(dirname "$0")/sweeps.sh"
needs make make

cat >Makefile <<MAKE
parts = part1.csv part2.csv part3.csv part4.csv
all.csv: \$(parts)
${tab}cat \$(parts) >all.csv
\$(parts): part%.csv: t.deck
${tab}$fourlink --part=\$*/4 -f csv -o \$@ t.deck || test \$\$? -eq 1
MAKE
sweep 'crank.length = 18 mm to 26 mm in 5' 'rocker.length = 56 mm, 20 mm' # some rows are out of reach
run 1 -f csv -o whole t.deck
check 'make -j4' make -s -j4 </dev/null
same all.csv whole
cp part1.csv kept
rm part3.csv all.csv # as if it had been interrupted
make -j4 </dev/null >made
check 'only the part that is not there is made again' test "$(grep -c -e --part= made)" -eq 1
same all.csv whole

# the recipes: of parts; of many decks, of which one has mistakes
PATH=$(dirname "$fourlink"):$PATH
export PATH
recipe make Makefile
cp t.deck sweep.deck
check 'the recipe of parts' make -s -j8 sweep.csv </dev/null
same sweep.csv whole
rm -f ./*.deck
recipe 'Many decks, by make' Makefile
for name in a b c; do
    base >$name.deck
done
check 'the recipe of many decks' make -s -k -j8 facts.jsonl </dev/null
run 0 -f json --summary a.deck b.deck c.deck
same facts.jsonl out
sleep 1
echo krank >>b.deck
touch c.deck
make -k -j8 facts.jsonl </dev/null >made 2>err
check 'a deck with mistakes fails' test $? -eq 2
says "b.deck:"
check 'the deck that is as it was is not computed again' none ' a.deck' made
check 'the one that has changed is' grep -q ' c.deck' made
base >b.deck
check 'it is mended' make -s -k facts.jsonl </dev/null
same facts.jsonl out

finish
