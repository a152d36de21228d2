#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
#
# test_readme.sh BUILD_DIR - what README.md shows is what the program prints: every block under a
# comment <!-- $ COMMAND --> is compared with the output of that command, word by word, numbers to a few
# units of their last digit, which may differ between machines; the C program is compiled.
set -u
build=$1
cd "$(dirname "$0")/.." || exit 1
work=$(mktemp -d) || exit 1
trap 'rm -rf "$work"' EXIT
PATH=$build:$work:$PATH
passed=0
failed=0

awk '/^```c$/ {on = 1; next} on && /^```/ {exit} on' README.md >"$work/example.c"
${CC:-cc} ${CFLAGS-} -std=c90 -pedantic-errors -Wall -Wextra -Werror -Iinclude "$work/example.c" \
  -o "$work/example" "$build/libfourlink.a" -lgsl -lgslcblas -lm || exit 1

awk -v work="$work" '
  /^<!-- \$ .* -->$/ {n++; sub(/^<!-- \$ /, ""); sub(/ -->$/, ""); print > (work "/command." n); wait = 1; next}
  wait && /^```/ {wait = 0; inside = 1; printf "" > (work "/expected." n); next}
  inside && /^```/ {inside = 0; next}
  inside {print > (work "/expected." n)}' README.md

# same FILE FILE
same() {
  awk '
    function size(x) {return x < 0 ? -x : x}
    function number(x) {return x ~ /^[-+]?[0-9]*\.?[0-9]+(e[-+]?[0-9]+)?$/}
    FNR == NR {line[FNR] = $0; n = FNR; next}
    {m = FNR; words = split(line[FNR], a); same = words == NF
     for (i = 1; same && i <= NF; i++)
       if (a[i] != $i && !(number(a[i]) && number($i) && size(a[i] - $i) <= 1e-6 * size(a[i]) + 1e-12))
         same = 0
     if (!same) {print "< " line[FNR]; print "> " $0; bad = 1}}
    END {if (n != m) print n " lines for " m; exit bad || n != m}' "$1" "$2"
}

for command in "$work"/command.*; do
  n=${command##*.}
  # a failing command is shown too, with its messages
  sh -c "$(cat "$command")" >"$work/actual" 2>&1 </dev/null
  if same "$work/expected.$n" "$work/actual" >"$work/diff"; then
    passed=$((passed + 1))
  else
    failed=$((failed + 1))
    echo "README.md does not show what is printed by: $(cat "$command")"
    cat "$work/diff"
  fi
done
echo "$passed passed, $failed failed"
[ "$passed" -gt 0 ] && [ "$failed" -eq 0 ]
