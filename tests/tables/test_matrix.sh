#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
#
# test_matrix.sh FOURLINK DATA - --matrix: the nine equations at each row.
. "$(dirname "$0")/../harness.sh"

cp "$decks/reach.deck" .
cp "$decks/pump.deck" engine.deck

run 0 --matrix "$matrix"
quiet
holds 'nine rows of nine coefficients, x and b, that hold: A x = b' '
    /^#/ || /^$/ {if (n && n != 9) bad = 1; if (n) blocks++; n = 0
                  if (/^$/) next
                  if (/theta2/) titles++
                  next}
    {if (NF != 11) bad = 1
     n++; x[n] = $10; b[n] = $11; for (j = 1; j <= 9; j++) A[n, j] = $j
     if (n == 9) for (i = 1; i <= 9; i++) {
         sum = 0; size = 0
         for (j = 1; j <= 9; j++) {t = A[i, j] * x[j]; sum += t; size += t < 0 ? -t : t}
         d = sum - b[i]; if (d < 0) d = -d
         if (d > 1e-5 * size + 1e-9) bad = 1
         if (size > 0) nonzero++}}
    END {if (n == 9) blocks++; exit bad || blocks != 20 || titles != 20 || nonzero != 180}'
prints 'F12x'
prints 'Ts'
run 0 -m -b open -s motion.at=40 "$matrix"
check 'x is the solution of the table' grep -Eq ' 7\.06332168 ' out
run 0 -m engine.deck
prints 'M14'
run 1 -m -s 'crank.mass=1 kg' reach.deck
prints 'branch: open: cannot be assembled'

finish
