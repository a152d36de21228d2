#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
#
# test_python.sh FOURLINK LIBRARY [WAY] - the Python package with the library of this build, by pytest.  WAY is
#   address  with a library for gcc's sanitizers of addresses and undefined behaviour
#   thread   the tests with threads and forks, with a library for its sanitizer of threads
#   wheel    as it is installed by pip in a new environment, with GSL from the wheel alone; needs the network of the package
#            index, or says that there is none
set -u
. "$(dirname "$0")/needs.sh"
source=$(cd "$(dirname "$0")/.." && pwd)
package=$source/packages/python
way=${3-}
FOURLINK=$1
export FOURLINK PYTHONDONTWRITEBYTECODE=1
work=$(mktemp -d) || exit 1
trap 'rm -rf "$work"' EXIT
for python in python3 /usr/bin/python3; do
    "$python" -c 'import numpy, pytest' 2>/dev/null && break
done
if [ "$way" = wheel ]; then
    python3 -m venv "$work/python" || { echo 'skipped: python3-venv is not installed' && exit 77; }
    python=$work/python/bin/python
    "$python" -m pip -q wheel --no-deps -w "$work" "$package" && "$python" -m pip -q install "$work"/fourlink-*.whl pytest pandas mypy ||
        { echo 'skipped: pip cannot install' && exit 77; }
    if [ "$(uname)" = Linux ]; then
        "$python" -c "import fourlink; print(open('/proc/self/maps').read())" | grep -o '/.*libgsl.*' | sort -u >"$work/gsl"
        [ "$(wc -l <"$work/gsl")" = 2 ] && ! grep -v "^$work/python/.*/fourlink/" "$work/gsl" || { echo 'FAILED: GSL is not from the wheel' && exit 1; }
    fi
    "$python" -m mypy --strict --cache-dir "$work/mypy" -p fourlink || exit 1
else
    "$python" -c 'import numpy, pytest' 2>/dev/null || { echo 'skipped: python3-numpy or python3-pytest is not installed' && exit 77; }
    FOURLINK_LIBRARY=$2 PYTHONPATH=$package
    export FOURLINK_LIBRARY PYTHONPATH
fi
tests=
if [ "$way" = address ] || [ "$way" = thread ]; then
    needs gcc gcc
    sanitizer=address,undefined runtimes="$(gcc -print-file-name=libasan.so) $(gcc -print-file-name=libstdc++.so)"
    [ "$way" = address ] || sanitizer=thread runtimes=$(gcc -print-file-name=libtsan.so) tests='thread or fork'
    FOURLINK_LIBRARY=$work/libfourlink.so
    (cd "$source/src" && gcc -shared -fPIC -O1 -g -fsanitize=$sanitizer -fno-sanitize-recover=undefined -DFOURLINK_BUILDING -I../include -I. \
        base/*.c mechanics/*.c deck/*.c motion/*.c results/*.c synthesis/*.c -lgsl -lgslcblas -lm -o "$FOURLINK_LIBRARY") || exit 1
    set -- env LD_PRELOAD="$runtimes" ASAN_OPTIONS=detect_leaks=0 # python3 itself leaks
else
    set -- env
fi
"$@" "$python" -m pytest -q -p no:cacheprovider -k "$tests" "$package/tests" >"$work/out" 2>&1
status=$?
[ $status = 0 ] || tail -n 40 "$work/out"
echo "$(grep -o '[0-9]* passed' "$work/out"), $(grep -o '[0-9]* failed' "$work/out" || echo 0 failed)"
exit $status
