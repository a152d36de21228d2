#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
#
# test_manual.sh FOURLINK DATA - the examples of the manuals: each of a deck in a deck of its own, each command as it
# stands; each section and each task has one; manuals and CHANGES.md are those of this version.
. "$(dirname "$0")/../harness.sh"
top=$(dirname "$data")
manuals=$top/doc/man

version=$("$fourlink" --version | sed -n 's/^fourlink //p')
for page in "$manuals"/*; do
    check "${page##*/} is of version $version" grep -q "^\.TH .* \"fourlink $version\"" "$page"
done
check "CHANGES.md begins with version $version" \
    test "$(sed -n 's/^## //p' "$top/CHANGES.md" | head -n 1)" = "$version"

# example.N: the N-th example, as the page shows it; sections: what the page has sections for
awk '/^\.EX/ {n++; inside = 1; next} /^\.EE/ {inside = 0}
    inside {gsub(/\\-/, "-"); print > ("example." n)}
    /^\.SS "/ {print}' "$manuals"/*.5 | grep -o '\[[a-z]*' | sed 's/.//' >sections
check 'the sections of the page' test "$(wc -l <sections)" -ge 18

# the deck of an example: with the sections that it lacks
cat >complete.awk <<'END'
    /^\[/ {name = $0; sub(/^./, "", name); sub(/[] ].*/, "", name); has[name] = 1}
    /^(mechanism|positions)/ {has[$1] = 1}
    {text = text $0 "\n"}
    END {
        kind = "four-bar"; lengths = "ground 80 crank 20 coupler 66 rocker 56"
        if ("piston" in has || "gas" in has) {kind = "slider-crank"; lengths = "crank 50 rod 200"}
        if ("slider" in has || "lever" in has) {kind = "inverted-slider-crank"; lengths = "ground 300 crank 50"}
        if ("yoke" in has) {kind = "scotch-yoke"; lengths = "crank 50"}
        if ("pins" in has) lengths = ""
        if ("synthesis" in has) lengths = "positions" in has ? "" : "ground 80"
        if (!("mechanism" in has)) print "mechanism = " kind
        if ("synthesis" in has && lengths && !("ground" in has)) {print "[ground]\nlength = 80 mm"; lengths = ""}
        printf "%s", text
        n = split(lengths, link, " ")
        for (i = 1; i < n; i += 2)
            if (!(link[i] in has)) print "[" link[i] "]\nlength = " link[i + 1] " mm"
        if (!("motion" in has || "synthesis" in has)) print "[motion]\nspeed = 10 rad/s\ninterval = 40 deg"
    }
END
printf 'Angle;Pressure\n0;1\n20,5;32\n180;1,5\n' >card.csv
for example in example.*; do
    awk -f complete.awk $example >$example.deck
    if grep -q '^\[synthesis' $example; then
        mv $example.deck $example.task
        run 0 --synthesis $example.task
        quiet
        mv out $example.deck
    fi
    run 0 -f csv $example.deck
    quiet
    run 0 --list $example.deck
done
for section in $(sort -u sections); do
    case $section in misprint | rod) continue ;; esac # as expect and coupler
    check "an example of [$section]" grep -q "^\[$section[] ]" example.*
done
for task in function motion path quick-return cognate; do
    check "an example of task = $task" grep -q "^task *= $task" example.*
done

# The commands of fourlink(1), at the top of the sources; those that need files of a class or write some, in test_class.
awk '/^\.EX/ {inside = 1; next} /^\.EE/ {inside = 0} inside {gsub(/\\-/, "-"); print}' "$manuals/fourlink.1" >commands
check "commands: $(wc -l <commands)" test "$(wc -l <commands)" -ge 10
mkdir copied && cp -r "$data" "$top/doc/tolerance.deck" copied && mkdir copied/doc && mv copied/tolerance.deck copied/doc
grep -v students/ commands | while IFS= read -r command; do
    (cd copied && PATH=$(dirname "$fourlink"):$PATH sh -c "$command") >out 2>err || echo "$command"
done >wrong
check "commands that fail: $(cat wrong)" test ! -s wrong
for example in $(grep -l '^\[expect' example.*.deck); do
    run 0 --check "$example"
done

finish
