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

finish
