#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
#
# test_release.sh - tests/release.sh tells a page that is built from the sources from another; web/build.sh begins only
# where it can come to its end.
. "$(dirname "$0")/../harness.sh"
top=$(dirname "$data")

mkdir -p copy/doc copy/tests
cp -r "$top/include" "$top/src" "$top/web" "$top/data" "$top/CMakeLists.txt" copy
cp -r "$top/doc/man" copy/doc
cp "$top/tests/release.sh" "$top/tests/foreign.sh" copy/tests
version=$(sed -n 's/^project(fourlink VERSION \([0-9.]*\).*/\1/p' copy/CMakeLists.txt)

# As if it were built from them.
hash=$(sh copy/web/sources.sh)
check "a hash: $hash" grep -qE '^[0-9a-f]{64}$' <<END
$hash
END
sed -e "s/@VERSION@/$version/" -e "s/@SOURCES@/$hash/" copy/web/page.html >copy/web/fourlink.html
check 'a page of these sources' sh copy/tests/release.sh >out

# A change of any of these is seen.
for file in include/fourlink.h src/base/number.c src/results/mean.c src/report/report.css src/view/view.c src/command/best.c web/worker.js \
    web/build.sh data/alvi-5.1.deck doc/man/fourlink.1 CMakeLists.txt; do
    cp "copy/$file" before
    sed 's/^project(fourlink VERSION /&9./' before >"copy/$file"
    [ "$file" = CMakeLists.txt ] || echo >>"copy/$file"
    check "$file has changed" sh -c '! sh copy/tests/release.sh 2>err'
    says 'Run sh web/build.sh web/fourlink.html FOLDER'
    mv before "copy/$file"
done
check 'a page of these sources, again' sh copy/tests/release.sh >out

# A page that was just built: the same bytes, where the compiler is that of Debian 12.
echo 'VERSION_CODENAME=bookworm' >os-release
export OS_RELEASE="$work/os-release"
cp copy/web/fourlink.html built.html
check 'the same bytes' sh copy/tests/release.sh built.html >out
check 'they are compared' grep -q 'has the bytes of the page just built' out
sed 's/<title>/&x/' built.html >other.html
check 'a page has other bytes' sh -c '! cmp -s built.html other.html'
check 'other bytes' sh -c '! sh copy/tests/release.sh other.html 2>err >out'
says 'Run sh web/build.sh web/fourlink.html FOLDER'
echo 'VERSION_CODENAME=trixie' >os-release
check 'another compiler' sh copy/tests/release.sh other.html >out
check 'it says so' grep -q 'is not compared' out
: >copy/src/base/new.c
check 'a new file' sh -c '! sh copy/tests/release.sh 2>err'
rm copy/src/base/new.c

# Without a compiler: which packages, and nothing is left behind.
mkdir bin
for command in sh dirname; do
    ln -s "$(command -v $command)" bin
done
PATH=$work/bin sh copy/web/build.sh page.html folder >out 2>err
status=$?
check "exit status $status" test $status -eq 2
says 'not installed: emcc dpkg-source man col'
says 'emscripten dpkg-dev man-db bsdextrautils'
check 'something is left' test ! -e folder -a ! -e page.html

# A build of GSL that fails is not taken for done.
for command in emcc emmake dpkg-source man col dpkg; do
    printf '#!/bin/sh\nexit 0\n' >bin/$command
done
printf '#!/bin/sh\necho "no such host"\nexit 1\n' >bin/emconfigure
chmod +x bin/*
mkdir -p folder/gsl-0
for again in 1 2; do
    PATH=$work/bin:$PATH sh copy/web/build.sh page.html folder >out 2>err
    status=$?
    check "exit status $status" test $status -eq 1
    says 'no such host'
    check 'it is taken for done' test ! -e folder/web/gsl/done
done
finish
