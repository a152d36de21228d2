#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
#
# random_synthesis.sh FOURLINK [N [SEED]] - random tasks of [synthesis], by random_synthesis.py.
. "$(dirname "$0")/../python.sh"
exec python3 -B "$tests/synthesis/random_synthesis.py" "$@"
