#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
#
# fast_math.sh COMPILER SOURCE - the library is not compiled without NaN and infinity; programs that only
# include its header are.
compiler=$1
source=$2
failed=0
try() { "$compiler" -std=c90 -fsyntax-only -I"$source/include" -I"$source/src" "$@" >/dev/null 2>&1; }
fail() {
    echo "FAILED: $*"
    failed=1
}

cd "$source/src" || exit 1
for file in mechanics/four_bar.c results/extreme.c mechanics/curve.c base/number.c; do
    try $file || fail "$file is not compiled at all"
    for flag in -ffast-math -Ofast -ffinite-math-only; do
        try $flag $file && fail "$file is compiled with $flag"
    done
done
try -ffast-math ../tests/consumers/c90.c || fail 'a program is not compiled with -ffast-math'
[ $failed = 0 ] && echo '3 flags refused'
exit $failed
