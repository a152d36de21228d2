#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
#
# test_reference.sh FOURLINK DATA REFERENCE - doc/reference.md has the sections and keys of the schema, as the program
# REFERENCE prints them, all columns and facts and no others; its commands are understood.
. "$(dirname "$0")/../harness.sh"
page=$(dirname "$data")/doc/reference.md

# block NAME: the text after <!-- NAME -->
block() { awk -v name="<!-- $1 -->" '$0 == name {on = 1; next} on && /^```/ {if (inside) exit; inside = 1; next} on && inside' "$page"; }

"$3" | tr -d '\r' >keys
block deck >page.keys
same page.keys keys

# names BLOCK: the names at the beginnings of its lines, up to three blanks; .y goes with what stands before it
names() {
    block "$1" | sed 's/   .*//' | tr -d , | tr ' ' '\n' | awk '
        /^\./ {print base $0; next} /./ {print; base = $0; sub(/\..*/, "", base)}'
}
for list in column fact; do
    "$fourlink" --list | awk -v list=$list '$1 == "column" || $1 == "fact" {now = $1; next} now == list && NF {print $1}' |
        grep -v '^\(C\|G[234]\|P\)\.\|(\|^COLUMN\|^F32x' | sort >wanted
    names ${list}s | sort >found
    check "${list}s: $(wc -l <found)" test "$(wc -l <found)" -gt 40
    same found wanted
done

# The commands, on a deck of each need.
cp "$data/me3491-matrix.deck" deck
cat >>deck <<END
[sweep]
crank.length = 18 mm, 20 mm
output = mu_min
END
awk -F'|' '/^\| .*`fourlink/ {print $3}' "$page" | grep -o '`fourlink[^`]*`' | tr -d '`' >commands
check "commands: $(wc -l <commands)" test "$(wc -l <commands)" -ge 15
mkdir FOLDER
: >answers.expect
while IFS= read -r command; do
    PATH=$(dirname "$fourlink"):$PATH sh -c "$command" >out 2>err </dev/null
    if grep -q "Try 'fourlink" err; then
        echo "$command: $(cat err)"
    fi
done <commands >wrong
check "commands that are not understood: $(cat wrong)" test ! -s wrong
finish
