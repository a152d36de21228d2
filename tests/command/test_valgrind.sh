#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
#
# test_valgrind.sh FOURLINK DATA - sweeps and their mistakes, with valgrind.
. "$(dirname "$0")/sweeps.sh"
needs valgrind valgrind

for output in 'motion.interval = 90 deg, 120 deg' 'output = mu_min, type, max(Ts)'; do
    sweep 'crank.length = 20 mm, 300 mm, 22 mm' 'rocker.length = 56 mm +- 0.1 mm normal' 'samples = 2' "$output"
    for format in csv table; do
        valgrind -q --error-exitcode=9 --leak-check=full "$fourlink" -f $format t.deck >out 2>err
        status=$?
        check "valgrind, $format, $output: $status, $(head -n 3 err)" test $status -eq 1
    done
done
sweep 'crank.length = 18 mm to 22 mm step 0 mm' 'rocker.length = 56 mm +- 90 mm' 'samples = 2'
valgrind -q --error-exitcode=9 --leak-check=full "$fourlink" t.deck >out 2>err
check 'valgrind, mistakes' test $? -eq 2
# through five poses, exactly and nearly
printf 'mechanism = four-bar\n[synthesis]\ntask = motion\npositions = (0, 0) mm 0 deg, (24, 10) mm -10 deg, (40, 5) mm -25 deg, (55, -5) mm -38 deg, (70, -20) mm -50 deg\n' >t.deck
valgrind -q --error-exitcode=9 --leak-check=full "$fourlink" --synthesis t.deck >out 2>err
check "valgrind, a synthesis: $(head -n 3 err)" test $? -eq 0

finish
