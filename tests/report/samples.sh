#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
#
# samples.sh FOURLINK CHECK_SAMPLE DECK... - the sample calculations of decks with outputs at three crank angles on both
# branches: each equation is evaluated from its printed numbers by CHECK_SAMPLE, and the results are those of the columns.
set -u
fourlink=$1 check_sample=$2
shift 2
work=$(mktemp -d) || exit 1
trap 'rm -rf "$work"' EXIT
trap 'exit 1' HUP INT TERM
n=0 equations=0 compared=0 wrong=0

# names DECK: of each output its columns, and the names of these in the equations
names() {
    awk '
        function put() {if (name != "") list[n++] = name " " slides " " rod}
        /^\[/ {put(); name = ""}
        /^\[output / {name = $2; sub(/\]/, "", name); slides = rod = 0}
        name != "" && $1 == "line" {slides = 1}
        name != "" && $1 == "rod" {rod = 1}
        END {
            put()
            for (i = 0; i < n; i++) {
                split(list[i], x, " ")
                print x[1] ".FP FP" (n > 1 ? i + 1 : "")
                print x[1] (x[2] ? ".N N1" : ".alpha alpha") 6 + 2 * i
                if (x[3]) print x[1] ".rod_omega omega" 5 + 2 * i
            }
        }' "$1"
}

for deck; do
    names "$deck" >"$work/names"
    [ -s "$work/names" ] || continue
    columns=$(cut -d' ' -f1 "$work/names" | paste -sd,)
    for branch in open crossed; do
        for angle in 20 131 247; do
            "$fourlink" --report="$work/r.html" -b $branch --plot-at="$angle deg" "$deck" >"$work/out" 2>"$work/err"
            if [ $? -gt 1 ] || ! grep -q 'id="equation-' "$work/r.html"; then
                continue # it has no position there
            fi
            values=
            if grep -q 'nine equations' "$work/r.html"; then
                "$fourlink" -f csv -b $branch -s "motion.at=$angle deg" -c "theta2,$columns" "$deck" 2>"$work/err" |
                    tr -d '\r' | sed 1d | cut -d, -f3- | tr , '\n' >"$work/values"
                # beside a dead position forces are 0 that are rounding error beside the others
                [ "$(tail -n 1 "$work/values")" != ok ] || values=$(cut -d' ' -f2 "$work/names" | paste -d= - "$work/values" | grep -v '^=')
            fi
            # shellcheck disable=SC2086
            if "$check_sample" "$work/r.html" $values >"$work/checked" 2>&1; then
                n=$((n + 1))
                equations=$((equations + $(grep -c 'id="equation-' "$work/r.html")))
                compared=$((compared + $(echo $values | wc -w)))
            else
                echo "$deck, $branch, $angle: $(head -n 3 "$work/checked")"
                wrong=$((wrong + 1))
            fi
            rm "$work/r.html"
        done
    done
done
echo "$n samples of outputs, $equations equations, $compared values of columns, wrong: $wrong"
[ $n -gt 0 ] && [ $compared -gt 0 ] && [ $wrong -eq 0 ]
