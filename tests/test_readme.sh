#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
#
# test_readme.sh BUILD_DIR [pictures] - what README.md, doc/*.md and data/*.md show is what the program prints: every
# block that begins with "$ COMMAND" is compared with the output of that command, word by word, numbers to a few
# units of their last digit, which may differ between machines; so is a block under a comment <!-- $ COMMAND -->,
# for a file that is shown.  A block under <!-- > NAME --> is a file for these commands; the lines of one under
# <!-- run --> are run.  The first whole program in C of a
# document is compiled, and is the command "example" of that document.  The tests that doc/accuracy.md names are there.
# Lines that make pictures are run with the argument "pictures" only, and the other lines of their block before them.
set -u
build=$1
pictures=${2-}
. "$(dirname "$0")/needs.sh"
cd "$(dirname "$0")/.." || exit 1
work=$(mktemp -d) || exit 1
trap 'rm -rf "$work"' EXIT
passed=0
failed=0

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

# result STATUS MESSAGE
result() {
  if [ "$1" -eq 0 ]; then
    passed=$((passed + 1))
  else
    failed=$((failed + 1))
    echo "$2"
  fi
}

# compile DOCUMENT FOLDER
compile() {
  awk '
    /^```c$/ {inside = 1; whole = 0; code = ""; next}
    inside && /^```/ {inside = 0; if (whole) {printf "%s", code; exit}}
    inside {code = code $0 "\n"; if (/^int main/) whole = 1}' "$1" >"$2/example.c"
  [ -s "$2/example.c" ] || return 0
  ${CC:-cc} ${CFLAGS-} -std=c90 -pedantic-errors -Wall -Wextra -Werror -Iinclude "$2/example.c" \
    -o "$2/example" "$build/libfourlink.a" -lgsl -lgslcblas -lm
  result $? "$1: the program in C does not compile"
}

# blocks DOCUMENT FOLDER: its commands, what they are to print, its files, the lines to run
blocks() {
  awk -v folder="$2" '
    /^<!-- > [a-z.]* -->$/ {name = folder "/" $3; inside = wait = 0; next}
    /^<!-- run -->$/ {name = folder "/run"; inside = wait = 0; next}
    name && /^```/ {if (opened) {close(name); name = ""} opened = !opened; next}
    name && opened {print >> name; next}
    /^<!-- \$ .* -->$/ {n++; sub(/^<!-- \$ /, ""); sub(/ -->$/, ""); print > (folder "/command." n); wait = 1; next}
    /^```console$/ {first = 1; next}
    first {first = 0; n++; print substr($0, 3) > (folder "/command." n); inside = 1; printf "" > (folder "/expected." n); next}
    wait && /^```/ {wait = 0; inside = 1; printf "" > (folder "/expected." n); next}
    inside && /^```/ {inside = 0; next}
    inside {print > (folder "/expected." n)}' "$1"
}

# compare DOCUMENT FOLDER
compare() {
  for command in "$2"/command.*; do
    [ -f "$command" ] || continue
    # a failing command is shown too, with its messages
    (cd "$2" && PATH=$build:$2:$PATH sh -c "$(cat "$command")") >"$2/actual" 2>&1 </dev/null
    same "$2/expected.${command##*.}" "$2/actual" >"$2/difference"
    result $? "$1 does not show what is printed by: $(cat "$command")
$(cat "$2/difference")"
  done
}

# run DOCUMENT FOLDER: what a reader types
run() {
  [ -f "$2/run" ] || return 0
  while read -r line; do
    case $line in *--plot*) [ "$pictures" ] || continue ;; esac
    (cd "$2" && PATH=$build:$2:$PATH sh -c "$line") >"$2/actual" 2>&1 </dev/null
    result $? "$1: this fails: $line
$(tail -n 3 "$2/actual")"
  done <"$2/run"
}

for document in README.md doc/*.md data/*.md; do
  folder=$work/$(basename "$document")
  mkdir "$folder" && ln -s "$PWD/data" "$PWD/web" "$PWD/tests" "$PWD/doc" "$folder" || exit 1
  compile "$document" "$folder"
  blocks "$document" "$folder"
  [ "$pictures" ] || compare "$document" "$folder"
  run "$document" "$folder"
done
[ -x "$work/library.md/example" ]
result $? 'doc/library.md has no whole program in C'
for name in $(grep -o '`\(expect/[a-z0-9-]*\|[a-z/]*\(test_[a-zA-Z0-9_]*\|brute_extremes\)\)[.a-z]*`' doc/accuracy.md | tr -d '`'); do
  case $name in
  */*.*) [ -f "tests/${name#tests/}" ] ;;
  *.*) find tests -name "$name" | grep -q . ;;
  *) grep -rqE --include='*.c' "^TEST\($name\)" tests ;;
  esac
  result $? "doc/accuracy.md names a test that is not there: $name"
done
echo "$passed passed, $failed failed"
[ "$passed" -gt 0 ] && [ "$failed" -eq 0 ]
