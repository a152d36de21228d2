#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
#
# test_python.sh FOURLINK LIBRARY [wheel] - the Python package with the library of this build, by pytest; with `wheel` as it
# is installed, by pip in a new environment, which needs the network of the package index, or says that there is none.
set -u
. "$(dirname "$0")/needs.sh"
package=$(cd "$(dirname "$0")/../packages/python" && pwd)
FOURLINK=$1
export FOURLINK PYTHONDONTWRITEBYTECODE=1
work=$(mktemp -d) || exit 1
trap 'rm -rf "$work"' EXIT
for python in python3 /usr/bin/python3; do
    "$python" -c 'import numpy, pytest' 2>/dev/null && break
done
if [ "${3-}" = wheel ]; then
    python3 -m venv "$work/python" || { echo 'skipped: python3-venv is not installed' && exit 77; }
    python=$work/python/bin/python
    "$python" -m pip -q install "$package" pytest pandas || { echo 'skipped: pip cannot install' && exit 77; }
else
    FOURLINK_LIBRARY=$2 PYTHONPATH=$package
    export FOURLINK_LIBRARY PYTHONPATH
    "$python" -c 'import numpy, pytest' 2>/dev/null || { echo 'skipped: python3-numpy or python3-pytest is not installed' && exit 77; }
fi
"$python" -m pytest -q -p no:cacheprovider "$package/tests" >"$work/out" 2>&1
status=$?
[ $status = 0 ] || tail -n 40 "$work/out"
echo "$(grep -o '[0-9]* passed' "$work/out"), $(grep -o '[0-9]* failed' "$work/out" || echo 0 failed)"
exit $status
