# SPDX-License-Identifier: GPL-3.0-or-later
#
# needs.sh - a test that needs a program which is not installed: ctest lists it as skipped.

# needs PROGRAM PACKAGE: without this program the whole test is skipped (exit status 77), and says why.
needs() {
    command -v "$1" >/dev/null || {
        echo "skipped: $1 is not installed (Debian: $2)"
        exit 77
    }
}
