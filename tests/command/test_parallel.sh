#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
#
# test_parallel.sh FOURLINK DATA - the parts of a sweep, run by GNU parallel, are the whole.
. "$(dirname "$0")/sweeps.sh"
needs parallel parallel

sweep 'crank.length = 18 mm to 22 mm step 1 mm' 'rocker.length = 56 mm +- 0.1 mm' 'samples = 2' 'output = mu_min, type, max(Ts)'
run 0 -f csv -o whole t.deck
HOME=$work PATH=$(dirname "$fourlink"):$PATH
export HOME PATH
rm -f part*
check 'parallel' parallel --will-cite "$fourlink" '--part={}/4' -f csv -o 'part{}.csv' t.deck ::: 1 2 3 4 </dev/null 2>err
cat part1.csv part2.csv part3.csv part4.csv >together
same together whole
check 'parallel --keep-order' parallel --will-cite -k "$fourlink" '--part={}/4' -f csv t.deck ::: 1 2 3 4 </dev/null >together 2>err
same together whole

# the recipe, with designs of which something is missing: parallel's status is the number of their parts
recipe 'The cores of one machine' parallel.sh
{ base && printf '[sweep]\nrocker.length = 56 mm, 20 mm, 57 mm\ncrank.length = 18 mm to 22 mm in 5\n'; } >sweep.deck
run 1 -f csv -o whole sweep.deck
check 'the recipe' sh parallel.sh </dev/null 2>err
same sweep.csv whole
sed -i '2,$d' parallel.sh
sh parallel.sh </dev/null 2>err
check 'its status is the number of parts with such designs' test $? -eq "$(for k in 1 2 3 4 5 6 7 8; do
    "$fourlink" -f csv --part=$k/8 sweep.deck >part 2>err || echo $k
done | wc -l)"

# many decks, in order; the status is the number of those with mistakes
rm -f ./*.deck
for name in a b c; do
    base >$name.deck
done
recipe 'Many decks, by GNU parallel' many.sh
check 'many decks' sh many.sh </dev/null 2>err
run 0 -f json --summary a.deck b.deck c.deck
same facts.jsonl out
echo krank >>b.deck
sh many.sh </dev/null 2>err
check 'one of them has mistakes' test $? -eq 1
says "b.deck:"
run 2 -f json --summary a.deck b.deck c.deck
same facts.jsonl out

finish
