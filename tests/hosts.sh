#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
#
# hosts.sh [full|short] - the library and the command, as programs of other ages compile and call them: with gcc and
# clang, in C90 to C17, at -O0 to -O3, with a char of either sign; called from C++98 to C++20; the unit tests
# under valgrind.  Each configuration passes the unit tests, computes what the decks of data/ expect, and prints
# the same tables.  Of the 64 configurations 8 have each standard and each level with each compiler, and all are
# compiled; "full" runs them all, "short" one of them, with two tests under valgrind, and compiles C90 only.  The other
# versions of GSL are those of the suites of packages.sh.
set -u
full=${1-}
top=$(cd "$(dirname "$0")/.." && pwd)
work=$(mktemp -d) || exit 1
trap 'rm -rf "$work"' EXIT
trap 'exit 1' HUP INT TERM
cd "$work" || exit 1
passed=0
failed=0
jobs=$(nproc)

# check WHAT COMMAND...: the command succeeds.
check() {
    what=$1
    shift
    if "$@" >log 2>&1 </dev/null; then
        passed=$((passed + 1))
    else
        failed=$((failed + 1))
        echo "FAILED: $what"
        tail -n 20 log
    fi
}

# tables FOURLINK: what it prints of each deck
tables() {
    for deck in "$top"/data/*.deck; do
        "$1" "$deck" && "$1" --summary "$deck"
    done
}

# Every source file, with every warning, without code.
compiles() {
    printf '%s\n' "$top"/src/*/*.c | xargs -n 20 -P "$jobs" "$1" "-std=$2" "$3" -fsyntax-only \
        -pedantic-errors -Wall -Wextra -Wconversion -Wshadow -Wstrict-prototypes -Wmissing-prototypes -Werror -I"$top/include" -I"$top/src"
}

# runs COMPILER STANDARD LEVEL CHAR
runs() {
    name="$1 -std=$2 $3 $4"
    rm -rf build
    check "$name: configured" cmake -S "$top" -B build -DCMAKE_C_COMPILER="$1" -DCMAKE_BUILD_TYPE=None \
        -DFOURLINK_STANDARD="$2" -DCMAKE_C_FLAGS="$3 $4" -DFOURLINK_WERROR=ON
    check "$name: built" cmake --build build -j"$jobs"
    units=$(cd build/tests && for file in test_*; do [ -f "$file" ] && [ -x "$file" ] && echo "$file"; done)
    check "$name: unit tests and decks" ctest --test-dir build -j"$jobs" --output-on-failure \
        -R "^($(echo $units | tr ' ' '|')|check-.*)\$"
    tests=$(sed -n 's/.*tests passed, 0 tests failed out of \([0-9]*\)/\1/p' log)
    tables build/fourlink >tables 2>&1
    [ -f first ] || mv tables first
    [ ! -f tables ] || check "$name: the tables of the first configuration" cmp tables first
    echo "  $name: ${tests:-0} tests, $(wc -l <first) lines of tables"
    configurations=$((configurations + 1))
}

compiled=0
standards='c90 c99 c11 c17'
[ "$full" != short ] || standards=c90
for compiler in gcc clang; do
    for standard in $standards; do
        for char in -fsigned-char -funsigned-char; do
            check "$compiler -std=$standard $char" compiles $compiler $standard $char
            compiled=$((compiled + $(ls "$top"/src/*/*.c | wc -l)))
        done
    done
done
echo "compiled without warnings: $compiled files"

configurations=0
if [ "$full" = full ]; then
    for compiler in gcc clang; do
        for standard in c90 c99 c11 c17; do
            for level in -O0 -O1 -O2 -O3; do
                for char in -fsigned-char -funsigned-char; do
                    runs $compiler $standard $level $char
                done
            done
        done
    done
elif [ "$full" = short ]; then
    runs gcc c11 -O1 -fsigned-char
    units='test_kind test_units'
else
    runs gcc c90 -O2 -fsigned-char
    runs gcc c99 -O0 -funsigned-char
    runs gcc c11 -O1 -fsigned-char
    runs gcc c17 -O3 -funsigned-char
    runs clang c90 -O3 -funsigned-char
    runs clang c99 -O1 -fsigned-char
    runs clang c11 -O0 -funsigned-char
    runs clang c17 -O2 -fsigned-char
fi
echo "configurations that ran: $configurations"

# Of two programs, each from another interface, the answers that data/me3491-matrix.deck expects.
callers=0
for compiler in g++ clang++; do
    for standard in c++98 c++03 c++11 c++14 c++17 c++20; do
        for program in cxx98 results; do
            check "$compiler -std=$standard $program.cpp" $compiler -std=$standard -pedantic-errors -Wall -Wextra \
                -Werror -I"$top/include" "$top/tests/consumers/$program.cpp" build/libfourlink.a -lgsl -lgslcblas -lm \
                -o caller
            check "$compiler -std=$standard $program.cpp runs" sh -c './caller <"$1" | grep "^theta4 *= 103.820765 deg\|^theta4 *= 103.820764813 deg"' \
                sh "$top/data/me3491-matrix.deck"
            callers=$((callers + 1))
        done
    done
done
echo "callers in C++98 to C++20: $callers"

# no_memory_error TEST: valgrind computes long double as double, and what fails for that leaves its memory.
no_memory_error() {
    valgrind -q --error-exitcode=9 "build/tests/$1"
    [ $? -ne 9 ]
}

# test_format compares millions of numbers with printf and is left out: it takes no memory.
under_valgrind=0
for test in $units; do
    [ "$test" = test_format ] && [ "$full" != full ] && continue
    if grep -q -e 'machines.h' -e 'long double' "$top"/tests/*/"$test".c; then
        check "valgrind $test" no_memory_error "$test"
    elif grep -q __libc_malloc "$top"/tests/*/"$test".c; then # a malloc of its own, which counts
        check "valgrind $test" valgrind -q --error-exitcode=9 --soname-synonyms=somalloc=nouserintercepts "build/tests/$test"
    else
        check "valgrind $test" valgrind -q --error-exitcode=9 --leak-check=full "build/tests/$test"
    fi
    under_valgrind=$((under_valgrind + 1))
done
echo "unit tests under valgrind: $under_valgrind"
echo "with $(gcc --version | head -n 1), $(clang --version | head -n 1), GSL $(gsl-config --version)"
echo "$passed passed, $failed failed"
[ $failed -eq 0 ]
