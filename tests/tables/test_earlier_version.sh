#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
#
# test_earlier_version.sh FOURLINK DATA - decks of version 0.1 as they stood, of each kind and with each section: the
# tables of today are those that 0.1 printed, column by column, and so is the exit status.  tests/decks-0.1 has the
# decks and the tables.
. "$(dirname "$0")/../harness.sh"

needs python3 python3
difference="python3 -B $(cd "$decks/.." && pwd)/csv_difference.py"
cp "$decks-0.1"/* .
without=

# as_before STATUS TABLE DECK OPTION...: the csv is TABLE.csv, values within 1e-12 of the largest of their column.
# New columns are left out.  Integrated motions have errors of their own, 1e-11 in a step: there 1e-10.  What superposition leaves is rounding.
as_before() {
    status=$1
    table=$2.csv
    deck=$3.deck
    shift 3
    run "$status" --format=csv "$@" "$deck"
    most=1e-12
    grep -q '^mode *=' "$deck" && most=1e-10
    found=$($difference "$table" out $most superposition +gamma $without)
    check "$deck, $*: $found" test "${found%% *}" != differs
    without=
}
# except COLUMNS REASON: of the next deck they are not compared
except() { without=$1; }

as_before 0 alvi-5.1 alvi-5.1
as_before 0 me3491-matrix me3491-matrix --interval='60 deg'
as_before 0 me3491-matrix.dyad me3491-matrix --interval='120 deg' --set=solver=dyad
as_before 0 me3491-matrix.check me3491-matrix --check
as_before 0 coupler-point coupler-point --interval='90 deg' --columns=all
as_before 1 dead dead
except Ms '0 but for rounding, without weights'
as_before 0 eccentric-60 eccentric-60 --columns=all
as_before 0 me3491-example-1 me3491-example-1 --columns=all
as_before 0 me3491-example-1.check me3491-example-1 --check
as_before 0 gas-engine gas-engine --interval='120 deg'
as_before 0 card card --interval='120 deg'
as_before 0 khurmi-22.1 khurmi-22.1
as_before 0 whitworth-150-100 whitworth-150-100
as_before 0 oscillating-cylinder oscillating-cylinder --interval='60 deg'
as_before 0 lever lever
as_before 1 lever.check lever --check
except Fsx '0 but for rounding, balanced'
as_before 0 springs springs --interval='90 deg' --columns=all
except 'F34x F34y F34 F34_dir F34_along F34_across F43_along F43_across' 'of an inverted slider-crank with friction in the guide: changed in 0.2'
as_before 0 friction friction --interval='90 deg' --columns=all

as_before 0 gerstmayr-run-up gerstmayr-run-up --interval='60 deg'
as_before 0 n-four-bar n-four-bar --interval='60 deg'
as_before 0 motor-pump motor-pump
as_before 0 motor motor --interval='60 deg'
except Ts '0 but for rounding, a free machine'
as_before 0 free free --set='motion.time_step=50 ms'
as_before 0 steady steady --interval='60 deg'

as_before 0 tolerance tolerance
as_before 0 sweep sweep
run 2 mistakes.deck
nothing

# The comparison can fail: another digit, another column, a row less.
cp alvi-5.1.csv right
sed '2s/52\.512678575/52.512678576/' right >alvi-5.1.csv
check 'another digit' test "$($difference alvi-5.1.csv right 1e-12 | cut -d' ' -f1)" = differs
sed '1s/omega3/omega4/' right >alvi-5.1.csv
check 'another column' test "$($difference alvi-5.1.csv right | cut -d' ' -f1)" = differs
sed '$d' right >alvi-5.1.csv
check 'a row less' test "$($difference alvi-5.1.csv right | cut -d' ' -f1)" = differs

finish
