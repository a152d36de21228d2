#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
#
# test_json.sh FOURLINK DATA [all] - --format=json, as a JSON parser reads it: objects, their keys, numbers as in
# csv (of every third deck, or all), several decks, designs, titles of all kinds, rows without values.
. "$(dirname "$0")/../harness.sh"
. "$decks/../questions.sh"

needs jq jq
cp "$decks/reach.deck" "$decks/pump.deck" .

# gives WHAT FILTER...: each filter is true of each object of the last run; there is at least one.
gives() { ask '[.[] | try ((' ') == true) catch false] | length > 0 and all' "$@"; }
# every WHAT FILTER...: the same of a list of all objects.
every() { ask 'try (' ') catch false' "$@"; }
# ask BEFORE AFTER WHAT FILTER...
ask() {
    before=$1
    after=$2
    shift 2
    about out
    while [ $# -gt 0 ]; do
        question "$1: $2" "$before$2$after"
        shift 2
    done
}
objects() { every "$1 objects" "length == $1"; }

# ------------------------------------------------------------------------------------------- a deck

run 0 -f json "$matrix"
quiet
check 'what ends the rows and the deck has a line of its own' test "$(tail -n 1 out)" = ']}]}'
objects 1
gives 'the keys, in order' \
    'keys_unsorted == ["deck", "title", "mechanism", "inputs", "columns", "facts", "branches"]' \
    'title and mechanism' '.deck == null and (.title | startswith("Matrix method")) and .mechanism == "four-bar linkage"' \
    'inputs' '.inputs | all(keys_unsorted == ["name", "unit", "meaning", "value"])' \
    'an input' '.inputs | any(.name == "crank.mass" and .unit == "kg" and .value == 0.1 and .meaning == "mass")' \
    'columns' '.columns | all(keys_unsorted == ["name", "unit", "meaning"])' \
    'a column' '.columns | any(.name == "Ts" and .unit == "N.m")' \
    'facts' '.facts | all(keys_unsorted == ["name", "unit", "meaning", "value", "theta2", "branch"])' \
    'a fact in words' '.facts | any(.name == "type" and .value == "crank-rocker" and .branch == null)' \
    'a fact with a crank angle' \
    '.facts | any(.name == "theta4_max" and .branch == "open" and (.theta2 - 223.031532 | fabs) < 1e-5)' \
    'branches' '.branches | map(.branch) == ["open", "crossed"]' \
    'rows' '(.columns | length) as $n | .branches | all(.rows | length == 10 and all(.status == "ok" and (.values | length) == $n))' \
    'a value' '(.columns | map(.name) | index("Ts")) as $i | (.branches[0].rows[1].values[$i] - 0.031382309545517 | fabs) < 1e-12'
run 0 --format=json --branch=crossed --columns=Ts,theta2 -i 90 "$matrix"
gives 'what is asked for' '(.branches | map(.branch)) == ["crossed"] and (.columns | map(.name)) == ["Ts", "theta2"] and (.branches[0].rows | map(.values[1])) == [0, 90, 180, 270, 360]'
"$fourlink" -f json "$matrix" >named
"$fourlink" -f json -o file "$matrix"
same file named

# Each number is the one of csv: the parser reads both.
csv_rows='def csv_rows: # of the text of a table: arrays of branch, values, status
    split("\n")[1:-1] | map([scan("(?:^|,)(\"(?:[^\"]|\"\")*\"|[^,]*)")[0] |
        if startswith("\"") then .[1:-1] | gsub("\"\""; "\"") elif . == "" then null
        elif test("^-?[0-9.]+(e[-+]?[0-9]+)?$") then tonumber else . end]);'
# compare ARGUMENT...: one jq for all of them, as its start takes longer than its work.
compare() {
    "$fourlink" -f csv "$@" >>csv 2>/dev/null
    printf '\f' >>csv
    "$fourlink" -f json "$@" >>out 2>/dev/null
    printf '%s\n' "$*" >>compared
}
rm -f csv out
turn=0
for deck in "$data"/*.deck "$decks/coupler-point.deck" "$decks/gas-engine.deck" reach.deck pump.deck; do
    turn=$((turn + 1))
    [ "${3-}" != all ] && [ $((turn % 3)) -ne 0 ] || compare "$deck"
done
for deck in "$matrix" "$data/oscillating-cylinder.deck" "$decks/gas-engine.deck" reach.deck; do
    compare --columns=all "$deck"
done
jq -cn --rawfile csv csv "$csv_rows"'($csv | split("\f")) as $tables | [inputs] | to_entries[] | .key as $i | .value |
    [(.columns | length) as $n | .branches[] | .branch as $b | .rows[] | [$b] + (.values // [range($n) | null]) + [.status]] |
    length > 0 and . == ($tables[$i] | csv_rows)' out >truths 2>&1
while read -r arguments; do
    read -r truth <&3 || truth='no answer'
    check "the numbers of csv: $arguments: $truth" test "$truth" = true
done <compared 3<truths
"$fourlink" -f json "$alvi" >out
check '17 digits, as csv' sh -c "'$fourlink' -f csv '$alvi' | tr ',' '\\n' | grep -x -e '-*[0-9.]*' | sort -u >a
    tr ',[]' '\\n' <out | sort -u >b; [ -s a ] && [ -z \"\$(comm -23 a b)\" ]"

# ------------------------------------------------------------------- --summary, --check, --list, --matrix

run 0 -f json -S "$matrix"
objects 1
gives 'the keys of a summary' 'keys_unsorted == ["deck", "title", "mechanism", "inputs", "facts"]' \
    'an extreme' '.facts | any(.name == "max(Ts)" and .branch == "open" and .unit == "N.m" and .theta2 != null)'
"$fourlink" -f csv -S "$matrix" >csv
same_facts() {
    jq -en --rawfile csv csv "$csv_rows"'[inputs | .inputs[], .facts[] | [.name, .value, .theta2, .branch]] |
        length > 20 and . == ($csv | csv_rows | map([.[0, 1, 3, 4]]))' out >/dev/null
}
check 'the inputs and facts of csv' same_facts
run 0 -f json -S "$decks/gas-engine.deck"
gives 'the turning moment' '.facts | any(.name == "mean_torque" and .unit == "N.m")'

run 0 -f json -C "$matrix"
objects 1
gives 'the keys of a check' '.checks | length > 10 and all(keys_unsorted ==
    ["result", "file", "line", "name", "theta2", "branch", "unit", "printed", "computed", "tolerance"])' \
    'all agree' '.checks | all(.result == "ok" and (.computed - (.printed | split(" ")[0] | tonumber) | fabs) <= .tolerance)'
printf '[expect]\nat = 40\ntheta4 = 104 deg\nmu = 9 deg\nno_such = 1\n[misprint]\nmu_min = 1 deg\nmu_max = 90 deg\n' >answers
run 2 -f json --check=answers "$matrix"
gives 'outcomes' '.checks | map(.result) == ["ok", "differs", "no value", "misprint confirmed", "not a misprint"]' \
    'no value has a message' '.checks | map(select(.result == "no value")) | all(.computed == null and .tolerance == null and (.message | length) > 5)'

run 0 -f json -l "$matrix"
objects 1
gives 'the keys of a list' 'keys_unsorted == ["deck", "title", "mechanism", "columns", "facts"]' \
    'columns of a list' '.columns | length > 60 and all(keys_unsorted == ["name", "unit", "meaning", "source"])' \
    'facts of a list, each once' '.facts | map(.name) | length == (unique | length) and index("max(COLUMN)") > 0'
usage '--matrix does not go with --format=json: it can be printed as table only' -f json -m "$matrix"

# ----------------------------------------------------------------------------------- several decks

run 3 -f json "$alvi" missing.deck pump.deck "$decks/bad.deck"
lines out 2
objects 2
every 'their names' 'map(.deck | split("/") | last) == ["alvi-5.1.deck", "pump.deck"]' \
    'each with its own columns' '(.[0].columns | any(.name == "theta4")) and (.[1].columns | any(.name == "x"))'
run 0 -f json -S "$alvi" pump.deck
lines out 2
objects 2
run 2 -f json -C "$matrix" "$decks/bad.deck"
lines out 2
every 'a deck with mistakes' '.[0].checks != null and .[1].status == "bad deck" and .[1].score == 0 and (.[1].message | startswith("'"$decks"'/bad.deck:")) and .[0].score == .[0].of'

# ----------------------------------------------------------------------------------------- designs

cp "$alvi" sweep.deck
printf '[sweep]\ncrank.length = 18 mm, -1 mm, 300 mm, 22 mm\noutput = mu_min, swing, type, max(omega4)\n' >>sweep.deck
"$fourlink" -f csv sweep.deck >csv
run 1 -f json sweep.deck
lines out 9
objects 9
every 'a line that describes the others' \
    '.[0] | .title != "" and (.columns | map(.name)) == ["crank.length", "mu_min", "swing", "type", "max(omega4)"]' \
    'units' '.[0].columns | map(.unit)[0:3] == ["m", "deg", "deg"]' \
    'the keys of a design' '.[1:] | all(keys_unsorted ==
    ["design", "crank.length", "branch", "mu_min", "swing", "type", "max(omega4)", "status"])' \
    'two lines for each' '.[1:] | map([.design, .branch]) ==
    [[1, "open"], [1, "crossed"], [2, "open"], [2, "crossed"], [3, "open"], [3, "crossed"], [4, "open"], [4, "crossed"]]' \
    'numbers and words' '.[1] | .type == "crank-rocker" and (.mu_min | type) == "number" and .status == "ok"' \
    'a design that cannot be built' '.[3:5] | all(.mu_min == null and .type == null and (.status | startswith("the length must be positive")))'
same_designs() { jq -es --rawfile csv csv "$csv_rows"'.[1:] | map([.[]]) == ($csv | csv_rows)' out >/dev/null; }
check 'the values of csv' same_designs
for part in 1 2 3; do
    "$fourlink" -f json --part=$part/3 sweep.deck >part.$part
done
cat part.1 part.2 part.3 >parts
same parts out

sed '/^output/d' sweep.deck >rows.deck
run 1 -f json -c theta2,theta4 rows.deck
lines out 4
objects 4
every 'an object for each design' 'map(.design) == [1, 2, 3, 4] and (map(."crank.length") == [0.018, -0.001, 0.3, 0.022])' \
    'with its rows' '.[0] | (.branches | map(.rows | length)) == [10, 10] and .title != null and (.inputs | any(.name == "crank.length" and .value == 0.018))' \
    'or the reason' '.[1] | keys == ["crank.length", "design", "status"] and (.status | startswith("the length must be positive"))'

# -------------------------------------------------------------------------------------------------- yield

tolerances="-s sweep.yield=mu_min>=57deg $data/../doc/tolerance.deck"
run 0 -f json $tolerances
every 'a yield is 1 or 0' '[.[1:][] | .yield == (if .mu_min >= 57 then 1 else 0 end)] | length == 6 and all' \
    'some meet it' '[.[1:][].yield] | add == 4'

# ---------------------------------------------------------------------------------- rows without values

run 1 -f json -c theta2,theta4 -b open reach.deck
gives 'what is not reached is null' '.branches[0].rows[3] == {status: "cannot be assembled: B and D are too far apart", values: [120, null]}'
run 0 -f json -S -b open reach.deck
gives 'the unbounded' '.facts | any(.name == "max(omega4)" and .value == "inf") and any(.name == "min(omega4)" and .value == "-inf")'
run 1 -f json -c theta2 -b open -s 'motion.acceleration=-10 rad/s2' "$alvi"
gives 'the crank comes to rest' '.branches[0].rows[-1] | .values == null and (.status | startswith("the crank comes to rest at 315.84"))'

# ------------------------------------------------------------------------------------------- strings

# title TEXT EXPECTED: of a deck with this title (in the notation of printf) the parser has that one
title() {
    { printf "title = $1\n"; sed '/^title/d' "$alvi"; } >title.deck
    "$fourlink" -f json title.deck >out 2>err
    every "the title $1" ".[0].title == \"$(printf '%s' "$2" | sed 's/[\\"]/\\&/g')\""
}
title 'a "quoted" one' 'a "quoted" one'
title 'C:\\new\\table' 'C:\new\table'
title '<script>alert(1)</script><!--' '<script>alert(1)</script><!--'
check 'no end of a script in it' none '<' out
title 'Gelenkviereck \303\274\342\202\254\360\235\204\236' 'Gelenkviereck ü€𝄞'
title 'caf\351 \200 \300\257 \355\240\200 \364\220\200\200 end' "$(printf 'caf\357\277\275 \357\277\275 ')$(
    printf '\357\277\275%.0s' 1 2) $(printf '\357\277\275%.0s' 1 2 3) $(printf '\357\277\275%.0s' 1 2 3 4) end"
# Decks have no control characters, but their names may.
name=$(printf 'a "b"\t\\ \001\010\033\037\177 \351.deck')
cp "$alvi" "$name"
run 0 -f json "$name" pump.deck
lines out 2
every 'the name of a deck' '.[0].deck == "a \"b\"\t\\ \u0001\b\u001b\u001f\u007f \ufffd.deck"'
check 'no control characters' test "$(tr -d '\n' <out | LC_ALL=C tr -cd '\001-\037\177' | wc -c)" -eq 0

# what a sweep varies has a meaning
{ cat "$alvi" && printf '[sweep]\ncrank.length = 18 mm, 20 mm\noutput = swing\n'; } >sweep.deck
run 0 -f json sweep.deck
check 'its meaning' grep -q '^{.*"columns":\[{"name":"crank.length","unit":"m","meaning":"varied by \[sweep\]"}' out

answer
finish
