#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
#
# python.sh SCRIPT ARGUMENT... - a test that is written in Python, or without python3 a skipped one.
. "$(dirname "$0")/needs.sh"
needs python3 python3
exec python3 -B "$@"
