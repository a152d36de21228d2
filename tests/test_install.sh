#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
#
# test_install.sh BUILD_DIR PART - installs to a scratch prefix and uses it.  PART is
#   c           the command with a deck, the header from C90, both libraries, the CMake package, manual pages
#   c++         the header from C++98
#   fortran     the module from Fortran 2003, the library from FORTRAN 77
#   pkg-config  its file
#   symbols     what the libraries define and need, by nm
#   completion  of bash
#   projects    the library built within another project, in C and in C++
set -u
build=$1
part=$2
. "$(dirname "$0")/needs.sh"
callers=$(cd "$(dirname "$0")/consumers" && pwd)
work=$(mktemp -d) || exit 1
trap 'rm -rf "$work"' EXIT
cd "$work" || exit 1
passed=0
failed=0
CC=${CC:-cc}
CXX=${CXX:-c++}
FC=${FC:-gfortran}
CFLAGS=${CFLAGS-}

check() {
    what=$1
    shift
    if "$@" >log 2>&1; then
        passed=$((passed + 1))
    else
        failed=$((failed + 1))
        echo "FAILED: $what"
        head -n 20 log
    fi
}

case $part in
c++ | projects) needs "$CXX" g++ ;;
fortran) needs "$FC" gfortran ;;
pkg-config) needs pkg-config pkg-config ;;
symbols) needs nm binutils ;;
completion) needs bash bash ;;
esac

cmake --install "$build" --prefix "$work/usr" >install.log || exit 1
lib=$(dirname "$(find usr -name libfourlink.a)")
[ -d "$lib" ] || exit 1
export LD_LIBRARY_PATH="$work/$lib"

cat >answer <<'ANSWER'
theta4 = 103.820765 deg
Ts = 0.031382309546 N m
ANSWER
answer=answer
cat >named <<'ANSWER'
theta4 = 103.820764813 deg
Ts = 0.031382310 N.m
min(Ts) = -0.234672250 N.m
mu_min = 58.229701379 deg
ANSWER
# Both are what data/me3491-matrix.deck expects, from two other computations; programs that open a deck read it.
gives() { "$@" <usr/share/fourlink/data/me3491-matrix.deck | tr -s ' ' | cmp - "$answer"; }
varied=$work/varied
for crank in 18 20 22; do
    usr/bin/fourlink -f csv -S -c Ts -b open -s "crank.length=$crank mm" usr/share/fourlink/data/me3491-matrix.deck |
        awk -F, -v crank="$crank" '$1 == "max(Ts)" {printf "%d mm: max(Ts) = %.9f N.m\n", crank, $2}'
done >"$varied"
echo 'the length must be positive, not -1 mm' >>"$varied"
static_libraries="$lib/libfourlink.a -lgsl -lgslcblas -lm"

# caller NAME COMMAND...: a caller of the library, linked to the shared and to the static one.
caller() {
    what=$1
    shift
    check "$what, shared" "$@" -o shared -L"$lib" -lfourlink -lm
    check "$what, shared, runs" gives ./shared
    check "$what, static" "$@" -o static $static_libraries
    check "$what, static, runs" gives ./static
}

strict='-pedantic-errors -Wall -Wextra -Werror -Iusr/include'
with_c() {
    check 'command and example deck' usr/bin/fourlink --check usr/share/fourlink/data/me3491-matrix.deck
    check 'manual page of the command' test -s usr/share/man/man1/fourlink.1
    # the program in the manual page of the library, and what the page says that it prints
    sed '/^\.EX/,/^\.EE/!d; /^\.E/d; s/\\e/\\/g; s/\\-/-/g' usr/share/man/man3/fourlink.3 >example.c
    check 'the program of fourlink(3)' $CC $CFLAGS -std=c90 $strict example.c -o example $static_libraries
    ./example >printed
    check 'it prints what is said' grep -qFx "prints $(cat printed)." usr/share/man/man3/fourlink.3
    check 'the page' grep -q '</html>' usr/share/fourlink/fourlink.html
    check 'licence' test -s usr/share/doc/fourlink/LICENSE
    for file in README.md CHANGES.md doc/library.md doc/gallery/mechanism.svg doc/gallery/motion.svg; do
        check "$file" test -s "usr/share/doc/fourlink/$file"
    done
    check 'manual page of the deck' test -s usr/share/man/man5/fourlink-deck.5
    # every link of an installed document leads to a file
    find usr/share/doc -name '*.md' | while read -r file; do
        grep -o '](\([^)# ]*\)' "$file" | sed 's/](//' | grep -v '^$\|^http\|^mailto' | while read -r link; do
            [ -e "$(dirname "$file")/$link" ] || echo "$file: $link"
        done
    done >dead
    check "links of documents lead nowhere: $(head -n 3 dead)" test ! -s dead
    # cffi's parser knows no attributes
    check 'no attribute in the header' sh -c "echo '#include <fourlink.h>' | $CC -Iusr/include -E - >plain.h && ! grep -q attribute plain.h"
    check 'completion' test -s usr/share/bash-completion/completions/fourlink
    for option in format output branch interval columns set check matrix summary plot plot-kind plot-at plot-x ascii part list help \
        version; do
        escaped=$(echo "$option" | sed 's/-/\\-/g')
        check "--$option in the manual page" grep -qF -e "\\-\\-$escaped" usr/share/man/man1/fourlink.1
    done

    caller 'C90' $CC $CFLAGS -std=c90 $strict "$callers/c90.c"
    answer=named
    caller 'results by name, C90' $CC $CFLAGS -std=c90 $strict "$callers/results.c"
    answer=answer
    printf 'mechanism = four-bar\n[ground]\nlength = 80 parsec\n[krank]\n' >x.deck
    ./shared <x.deck >mistakes
    check 'the mistakes of a deck, as the command tells them' grep -qx \
        "deck:3: error: unknown unit 'parsec' in '80 parsec'" mistakes
    sed 's/^deck:/x.deck:/' mistakes >told
    usr/bin/fourlink x.deck 2>printed
    check 'all of them' cmp printed told

    answer=$varied
    caller 'numbers that are set, C90' $CC $CFLAGS -std=c90 $strict "$callers/varied.c"
    # The best transmission angle: b = c = sqrt((a^2 + d^2) / 2), cos(mu_min) = 2 a d / (a^2 + d^2).
    answer=optimum
    echo 'coupler 58.310 mm, rocker 58.310 mm: mu_min = 61.928 deg' >$answer
    usr/bin/fourlink -b open -s 'sweep.coupler.length=50 mm to 65 mm step 5 mm' \
        -s 'sweep.rocker.length=50 mm to 65 mm step 5 mm' --best='max mu_min' usr/share/fourlink/data/me3491-matrix.deck >best
    awk 'NR == 1 {mu = $(NF - 3)} /^\[/ {section = $1} /^length/ {length_of[section] = $3}
        END {printf "coupler %.3f mm, rocker %.3f mm: mu_min = %.3f deg\n", length_of["[coupler]"], length_of["[rocker]"], mu}' best >of_best
    check 'the best transmission angle, --best' cmp of_best $answer
    caller 'an optimiser, as --best, C90' $CC $CFLAGS -std=c90 $strict "$callers/optimise.c" -lgsl -lgslcblas
    answer=answer
    in_a_project C INSTALLED
}

# in_a_project LANGUAGE WAY...: the library within another project: the same targets, no others that get in its way, nothing of fourlink's installed.
# A project may fetch it, from an address or from a folder, which needs no network.
in_a_project() {
    language=$1
    shift
    source=$callers/../..
    mkdir -p within
    cp "$callers/c90.c" within
    cat >within/CMakeLists.txt <<'CMAKE'
cmake_minimum_required(VERSION 3.21)
project(host C ${LANGUAGE})
if(INSTALLED)
  find_package(fourlink 0.3 REQUIRED)
elseif(FETCHED)
  include(FetchContent)
  FetchContent_Declare(fourlink SOURCE_DIR "${FOURLINK_FOLDER}")
  FetchContent_MakeAvailable(fourlink)
else()
  add_subdirectory("${FOURLINK_FOLDER}" fourlink)
endif()
foreach(other gallery bench fourlink package)
  if(TARGET ${other})
    message(FATAL_ERROR "there is a target ${other}")
  endif()
endforeach()
if(CMAKE_BUILD_TYPE)
  message(FATAL_ERROR "the build type is ${CMAKE_BUILD_TYPE}")
endif()
add_custom_target(gallery)
add_executable(with_shared c90.c)
target_link_libraries(with_shared fourlink::fourlink m)
add_executable(with_static c90.c)
target_link_libraries(with_static fourlink::static)
if(LANGUAGE STREQUAL CXX)
  add_executable(in_cxx ${RESULTS})
  target_compile_features(in_cxx PRIVATE cxx_std_17)
  target_link_libraries(in_cxx fourlink::static)
endif()
install(TARGETS with_static)
CMAKE
    for way; do
        rm -rf within/build installed
        check "$language: a project, fourlink $way" cmake -S within -B within/build -D$way=ON -DFOURLINK_FOLDER="$source" -DLANGUAGE="$language" \
            -DRESULTS="$callers/results.cpp" -DCMAKE_PREFIX_PATH="$work/usr" -DCMAKE_C_COMPILER="$CC" -DCMAKE_C_FLAGS="$CFLAGS" \
            -DCMAKE_CXX_FLAGS="$CFLAGS"
        check "$language, $way: it builds" cmake --build within/build -j2
        check "$language, $way: fourlink::fourlink runs" gives within/build/with_shared
        check "$language, $way: fourlink::static runs" gives within/build/with_static
        answer=named
        [ "$language" = C ] || check "$way: its program in C++17 runs" gives within/build/in_cxx
        answer=answer
        check "$language, $way: no tests of fourlink" sh -c 'ctest --test-dir within/build -N | grep -q "Total Tests: 0"'
        check "$language, $way: it is installed" cmake --install within/build --prefix "$work/installed"
        check "$language, $way: nothing of fourlink is" test "$(cd installed && find . -type f)" = ./bin/with_static
    done
}

with_cxx() {
    caller 'C++98' $CXX $CFLAGS -std=c++98 $strict "$callers/cxx98.cpp"
    answer=named
    caller 'results by name, C++98' $CXX $CFLAGS -std=c++98 $strict "$callers/results.cpp"
    answer=answer
    in_a_project CXX INSTALLED
}

projects() {
    in_a_project C ADDED
    in_a_project CXX FETCHED
}

with_fortran() {
    strict='-Wall -Wextra -Werror -fcheck=all'
    check 'Fortran 2003, the module' $FC $CFLAGS -std=f2003 -pedantic $strict -c usr/include/fourlink.f90
    caller 'Fortran 2003' $FC $CFLAGS -std=f2003 -pedantic $strict "$callers/fortran2003.f90" fourlink.o
    answer=named
    caller 'results by name, Fortran 2003' $FC $CFLAGS -std=f2003 -pedantic $strict "$callers/results.f90" fourlink.o
    caller 'results by name, FORTRAN 77' $FC $CFLAGS -std=legacy $strict "$callers/results.f"
    answer=$varied
    caller 'numbers that are set, Fortran 2003' $FC $CFLAGS -std=f2003 -pedantic $strict "$callers/varied.f90" fourlink.o
    caller 'numbers that are set, FORTRAN 77' $FC $CFLAGS -std=legacy $strict -Wno-unused-parameter -Iusr/include "$callers/varied.f"
    answer=longer
    { cat answer; printf 'a4 = -1373.420151 m/s2\nslide = 0.146352 m\na length is not positive\n'; } >$answer
    caller 'FORTRAN 77' $FC $CFLAGS -std=legacy $strict "$callers/fortran77.f"
    answer=answer
    # What the module has is that of the header, and all status codes are there.
    cat usr/include/fourlink.h usr/include/fourlink/*.h >headers
    { sed -n 's/^ *X(\(FOURLINK_[A-Z_]*\), *\([0-9]*\),.*/\1=\2/p' headers
        grep -o 'FOURLINK_[A-Z_]* = -*[0-9]*' headers | grep -v '_END_' | tr -d ' '; } | tr A-Z a-z >values
    for name in $(sed -n 's/^    [a-z].*\(function\|subroutine\) \(fourlink_[a-z_]*\)(.*/\2/p' usr/include/fourlink.f90 | grep -v '_c$'); do
        check "$name of the module" grep -q "^FOURLINK_API .*\b$name(" headers
    done
    for name in $({ grep -o 'fourlink_[a-z_]* = -*[0-9][0-9]*' usr/include/fourlink.f90 | sed 's/crank_link = /crank = /'
        sed -n 's/.*PARAMETER (\(.*\))/\1/p' usr/include/fourlink.inc; } | tr A-Z a-z | tr -d ' '); do
        check "$name of the module or fourlink.inc" grep -qx -e "$name" values
    done
    for name in $(sed -n '/^#define FOURLINK_STATUS_LIST/,/^$/s/^ *X(\(FOURLINK_[A-Z_]*\), *\([0-9]*\),.*/\1=\2/p' headers | tr A-Z a-z); do
        check "$name in the module" grep -Eq "\b${name%=*} = ${name#*=}\b" usr/include/fourlink.f90
        check "$name in fourlink.inc" grep -Eiq "\(${name%=*} = ${name#*=}\)" usr/include/fourlink.inc
    done
    $CC $CFLAGS -Iusr/include "$callers/sizes.c" -o sizes_c && ./sizes_c >sizes_of_c
    $FC $CFLAGS "$callers/sizes.f90" fourlink.o $static_libraries -o sizes_f && ./sizes_f >sizes_of_fortran
    check 'the structures of the header' test -s sizes_of_c
    check 'the same in the module' cmp sizes_of_c sizes_of_fortran
}

with_pkg_config() {
    export PKG_CONFIG_PATH="$work/$lib/pkgconfig"
    check 'pkg-config' sh -c "$CC $CFLAGS \$(pkg-config --cflags fourlink) '$callers/c90.c' -o pc \$(pkg-config --libs fourlink) -lm"
    check 'pkg-config runs' gives ./pc
    # the version of the header is that of the build, and the library's name has it, without its last number
    version=$(sed -n 's/^#define FOURLINK_VERSION "\(.*\)"$/\1/p' usr/include/fourlink.h)
    check "version $version" test "$(pkg-config --modversion fourlink)" = "$version"
    [ "$(uname)" != Linux ] || check 'the name of the shared library' test -e "$lib/libfourlink.so.${version%.*}"
}

symbols() {
    # Of the shared library nothing is visible but what the header declares; of the static one all names
    # have its prefix.
    nm -D --defined-only "$lib/libfourlink.so" | awk '$2 ~ /[A-Z]/ {print $3}' | grep -v '^__\|^_init\|^_fini' | sort >visible
    sed -n 's/^FOURLINK_API .* \**\(f[a-z0-9_]*\)(.*/\1/p' usr/include/fourlink.h usr/include/fourlink/*.h | sort >declared
    check 'the symbols of the header, and no others' cmp visible declared
    check 'names with a prefix' sh -c \
        "! nm --defined-only '$lib/libfourlink.a' | awk 'NF == 3 && \$2 ~ /[A-Z]/ {print \$3}' | grep -v '^flk_\|^__' | sort | comm -13 declared - | grep ."
    check 'no stdio, exit, locale, error handler in the library' sh -c \
        "! nm -D --undefined-only '$lib/libfourlink.so' | grep -wE '[a-z_]*printf[a-z_]*|puts|putc|fputs|fopen|fwrite|fread|stdout|stderr|exit|abort|localeconv|setlocale|gsl_set_error_handler|gsl_set_error_handler_off|gsl_error'"
    # Memory is taken where a deck is opened, by the first search along a motion, and by one through many points; crank positions, rows and facts need none.
    nm -A --undefined-only "$lib/libfourlink.a" | grep -wE 'malloc|calloc|realloc|free|[a-z_]*alloc' |
        sed 's/.*:\([a-z0-9_]*\)\.c\.o:.*/\1/' | sort -u >allocating
    check 'memory is for decks' sh -c "printf '%s\n' actual analysis corners deck extremes mean message opened path points reader results samples | cmp - allocating"
    # No state: nothing that can be written to.  (A sanitizer has some of its own.)
    case $CFLAGS in
    *sanitize*) ;;
    *) check 'no writable data in the library' sh -c \
        "size -A '$lib/libfourlink.a' | awk '\$1 ~ /^[.](data|bss|data[.]rel|data[.]rel[.]local)$/ {n += \$2} END {exit n > 0}'" ;;
    esac
}

completion() {
    # The completion of bash, as it is typed: fourlink --form<TAB>, fourlink --format=p<TAB>
    completes() {
        bash -c '. usr/share/bash-completion/completions/fourlink
            compopt() { :; }
            COMP_WORDS=(usr/bin/fourlink "${@:2}") COMP_CWORD=$(($# - 1))
            _fourlink
            [ "${COMPREPLY[*]}" = "$1" ]' completes "$@"
    }
    check 'an option completes' completes --format= --forma
    check 'its value completes' completes paper --format = p
    check 'others' completes 'json jsonl' --format = j
    check 'a kind of picture completes' completes polar --plot-kind = pol
    : >x.deck
    check 'a deck completes' completes x.deck x
}

case $part in
c) with_c ;;
c++) with_cxx ;;
fortran) with_fortran ;;
pkg-config) with_pkg_config ;;
*) $part ;;
esac
echo "$passed passed, $failed failed"
[ "$failed" -eq 0 ]
