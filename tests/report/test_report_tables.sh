#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
#
# test_report_tables.sh FOURLINK DATA - the tables of reports are those of the other outputs, by tables.py.
. "$(dirname "$0")/../python.sh"
decks=$tests/decks
exec python3 -B "$tests/report/tables.py" "$1" "$decks/expectations.deck" "$2/me3491-matrix.deck" "$2/alvi-5.1.deck" \
    "$decks/gas-engine.deck" "$decks/reach.deck" "$decks/rubbing-lever.deck" "$2/whitworth-150-100.deck" \
    "$2/gerstmayr-run-up.deck" "$2/../doc/motor-pump.deck"
