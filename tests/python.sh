# SPDX-License-Identifier: GPL-3.0-or-later
#
# python.sh - what the tests in Python share, sourced by their scripts.
tests=$(cd "$(dirname "$0")/.." && pwd)
. "$tests/needs.sh"
needs python3 python3
