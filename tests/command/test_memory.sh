#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
#
# test_memory.sh FOURLINK DATA - a sweep takes the memory of one design, and says nothing where nobody looks.
. "$(dirname "$0")/sweeps.sh"

sweep 'crank.length = 18 mm to 22 mm in 3000' 'output = mu_min'
run 0 -f csv t.deck
quiet

# Memory is that of one design.  (A sanitizer needs more address space than this.)
sweep 'crank.length = 18 mm to 22 mm in 100000' 'output = swing'
if (ulimit -v 65536 && "$fourlink" --version >out) 2>err; then
    check '100,000 designs in 64 MB' sh -c 'ulimit -v 65536 && exec "$0" -f csv t.deck | wc -l | grep -q "^ *200001$"' "$fourlink"
    check 'their statistics in 64 MB' sh -c 'ulimit -v 65536 && exec "$0" -f csv --statistics t.deck | grep -q "^swing,deg,open,100000,"' "$fourlink"
fi

finish
