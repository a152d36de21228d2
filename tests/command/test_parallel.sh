#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
#
# test_parallel.sh FOURLINK DATA - the parts of a sweep, run by GNU parallel, are the whole.
. "$(dirname "$0")/sweeps.sh"
needs parallel parallel

sweep 'crank.length = 18 mm to 22 mm step 1 mm' 'rocker.length = 56 mm +- 0.1 mm' 'samples = 2' 'output = mu_min, type, max(Ts)'
run 0 -f csv -o whole t.deck
HOME=$work
export HOME
rm -f part*
check 'parallel' parallel --will-cite "$fourlink" '--part={}/4' -f csv -o 'part{}.csv' t.deck ::: 1 2 3 4 </dev/null 2>err
cat part1.csv part2.csv part3.csv part4.csv >together
same together whole
check 'parallel --keep-order' parallel --will-cite -k "$fourlink" '--part={}/4' -f csv t.deck ::: 1 2 3 4 </dev/null >together 2>err
same together whole

finish
