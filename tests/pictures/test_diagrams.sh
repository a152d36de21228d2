#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
#
# test_diagrams.sh FOURLINK DATA - the numbers of diagrams, by diagrams.py.
. "$(dirname "$0")/../python.sh"
exec python3 -B "$tests/pictures/diagrams.py" "$1" "$2" "$tests/decks"
