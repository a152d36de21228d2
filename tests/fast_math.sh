#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
#
# fast_math.sh COMPILER SOURCE - the library is not compiled without NaN and infinity; programs that only
# include its header are.  No product is fused with a sum, without -ffp-contract=off too, where the processor could.
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

fma=$(mktemp) || exit 1
trap 'rm -f "$fma"' EXIT
echo 'double f(double a, double b, double c) { return a * b + c; }' |
    "$compiler" -O2 -mfma -ffp-contract=fast -xc -S - -o "$fma" 2>/dev/null
if grep -Eq 'vfn?m(add|sub)' "$fma"; then
    files=0
    for file in base/*.c mechanics/*.c motion/*.c results/*.c synthesis/*.c deck/*.c; do
        "$compiler" -O2 -mfma -w -I"$source/include" -I. -S "$file" -o "$fma" || fail "$file is not compiled"
        grep -Eq 'vfn?m(add|sub)' "$fma" && fail "$file has a fused product"
        files=$((files + 1))
    done
    echo "$files files without a fused product"
fi
exit $failed
