#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
#
# test_fragments.sh BUILD c|fortran|gnuplot - the parts of programs that doc/library.md shows, each as it stands within
# a program that declares what it uses, and the recipe for diagrams of doc/gallery.md.
set -u
build=$(cd "$1" && pwd) way=$2
source=$(cd "$(dirname "$0")/.." && pwd)
. "$source/tests/needs.sh"
[ "$way" = c ] || [ "$way" = gnuplot ] || needs gfortran gfortran
[ "$way" != gnuplot ] || needs gnuplot gnuplot-nox
work=$(mktemp -d) || exit 1
trap 'rm -rf "$work"' EXIT
cd "$work" || exit 1

# block LANGUAGE N FILE: the N-th block of a language in a document
block() {
    awk -v begin="\`\`\`$1" -v wanted="$2" '/^```/ {inside = $0 == begin; n += inside; next} inside && n == wanted' "$source/doc/$3"
}
deck() { printf 'mechanism = four-bar\n[ground]\nlength = 80 mm\n[crank]\nlength = 20 mm\nmass = 0.1 kg\nuniform = yes\n[coupler]\nlength = 66 mm\n[rocker]\nlength = 56 mm\n[motion]\nspeed = 60 rpm\ninterval = 40 deg\n'; }
fail() { echo "FAILED: $*" && exit 1; }
# is FILE PATTERN: the output is this
is() { grep -Eqx "$2" "$1" || { cat "$1" && fail "$way: expected '$2'"; }; }

# A program in C around the k-th block: declarations, what comes before it, what comes after.
program() {
    printf '#include <stdio.h>\n#include "fourlink.h"\nint main(void)\n{\n%s\n{\n%s\n' "$2" "$(block c "$1" library.md)"
    printf '%s\n}\n}\n' "$3"
}

run_c() {
    program 2 'static const char deck[] = "mechanism = four-bar\\n"; static fourlink_source source; fourlink_results *results = NULL; fourlink_value v;
        source.text = deck; source.length = sizeof deck - 1;' 'return 0;' >2.c
    program 3 'static fourlink_state state; static fourlink_forces forces; int status;' \
        'printf("%d %d\n", status, state.link[4].omega != 0 && forces.Ts != 0); return 0;' >3.c
    program 4 'int status;' 'printf("%d %lu %d\n", status, n, found.design.link[2].length > 0); return 0;' >4.c
    for k in 2 3 4; do
        ${CC:-cc} ${CFLAGS-} -std=c90 -pedantic-errors -Wall -Wextra -Werror -Wno-missing-field-initializers -I"$source/include" $k.c -o $k \
            "$build/libfourlink.a" -lgsl -lgslcblas -lm || fail "block $k of library.md does not compile"
        ./$k >out 2>err || fail "block $k of library.md ends with $?"
        case $k in
        2) is err 'deck:[0-9]+: error: .*' ;;
        3) is out '0 1' ;;
        4) is out '0 1 1' ;;
        esac
    done
}

run_fortran() {
    library="$build/libfourlink.a -lgsl -lgslcblas -lm"
    {
        echo 'program p'
        block fortran 1 library.md | awk '{print} /target :: text/ {
            print "character(len=100) :: line\ntype(fourlink_source) :: source\ntype(fourlink_mistake) :: mistakes(1)\ntype(fourlink_value) :: v"
            print "type(c_ptr) :: results = c_null_ptr\ninteger(c_long) :: n\ninteger :: status\ntext = \" \"\ndo"
            print "read (*, \"(a)\", end=10) line\ntext = trim(text) // trim(line) // c_new_line\nend do\n10 continue"}'
        echo 'end program p'
    } >new.f90
    {
        printf '      PROGRAM P\n      INTEGER*8 HANDLE\n      INTEGER ISTAT, N\n      DOUBLE PRECISION VALUE\n      CHARACTER TEXT*10000, LINE*100, MSG*80\n'
        printf '      TEXT = %s\n      N = 1\n   10 READ (*, %s, END=20) LINE\n      TEXT(N:N+100) = LINE // CHAR(10)\n      N = N + 101\n      GOTO 10\n   20 CONTINUE\n' "' '" "'(A)'"
        block fortran 2 library.md
        printf '      WRITE (*, *) VALUE\n      END\n'
    } >old.f
    gfortran ${CFLAGS-} "$source/include/fourlink.f90" new.f90 -o new $library || fail 'Fortran 2003 does not compile'
    gfortran ${CFLAGS-} old.f -o old $library || fail 'FORTRAN 77 does not compile'
    value=$("$build/fourlink" --at=40 --branch=open -c Ts --format=csv - <<END | tail -n 1 | cut -d, -f2
$(deck)
END
)
    deck | ./new >out || fail 'Fortran 2003 does not run'
    awk -v x="$value" '{d = $1 - x; ok = (d < 0 ? -d : d) <= 1e-12 && $2 == "N.m"} END {exit !ok}' out || fail "Fortran 2003: $(cat out), not $value"
    deck | ./old >out || fail 'FORTRAN 77 does not run'
    awk -v x="$value" '{d = $1 - x; ok = (d < 0 ? -d : d) <= 1e-12} END {exit !ok}' out || fail "FORTRAN 77: $(cat out), not $value"
}

run_gnuplot() {
    awk '/^## Your own diagrams/ {on = 1} on && /^```/ {inside = !inside; next} inside' "$source/doc/gallery.md" >recipe
    python3 -c 'import matplotlib' 2>/dev/null || sed -i '/^python3/d' recipe
    ln -s "$source/data" data
    PATH=$build:$PATH sh -e recipe >log 2>&1 </dev/null || { cat log && fail 'the recipe for diagrams'; }
    grep -q '<path' Ts.svg || fail 'there is no curve in Ts.svg'
    ! grep -q '^python3' recipe || [ -s Ts.png ] || fail 'there is no Ts.png'
}

"run_$way"
echo '1 passed, 0 failed'
