#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
#
# test_limits.sh FOURLINK DATA - the picture of limits, by limits.py.
. "$(dirname "$0")/../python.sh"
exec python3 -B "$tests/pictures/limits.py" "$1" "$2" "$tests/decks"
