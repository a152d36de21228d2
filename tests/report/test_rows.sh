#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
#
# test_rows.sh - the rows that a report's drawing is made from.
. "$(dirname "$0")/../harness.sh"
. "$decks/../questions.sh"

needs jq jq

# rows DECK [OPTION...]: the rows of its report, in the file rows.
rows() {
    "$fourlink" --report=lab.html "$@" >out 2>err </dev/null
    sed -n '/id="fourlink-rows"/,/<\/script>/p' lab.html | sed '1s/.*>{/{/; $d' >rows
}
# that FILTER...: each is true of them.
that() {
    about rows
    for filter in "$@"; do
        question "rows $asked: $filter" "try (.[] | $filter) catch false | . != null and . != false"
    done
}

rows "$alvi"
that '.branches | map(.name) == ["open", "crossed"]' \
    '(.steps | length) == 181 and .steps[20] == 40 and .steps[.start] == 60 and .turn == 0' \
    '.units.length == "mm" and .branches[0].reasons == {} and [.branches[].table | length] == [181, 181]' \
    '[.branches[0].panels[].title] == ["Mechanism", "Velocity polygon", "Acceleration polygon"]' \
    '.branches[0].panels | all(.box[2] / .box[3] | . > 1.2 and . < 2.3)'

# The table is the program's.
run 0 "$alvi"
check 'the row of the table at 120 deg' test "$(awk '$1 == 120 {print $5; exit}' out)" = \
    "$(jq -r '(.columns | map(.name) | index("theta4")) as $j | .branches[0].table[60][$j]' rows)"

# Steps: they divide the deck's interval; there are at most 361 of them, and the angle of the sample calculation; a cycle of 720 deg has 2 deg.
for case in '15 deg:121' '10 deg:181' '1 deg:361' '0.1 deg:361' '7 deg:262'; do
    rows --set motion.interval="${case%:*}" "$alvi"
    that "(.steps | length) == ${case#*:}"
done
rows "$decks/gas-engine.deck"
that '.steps[-1] == 720 and (.steps | length) == 361'

# Rows by time: each row of the deck, and steps between them; every so many of more than 361.
pump=$data/../doc/motor-pump.deck
sed '/^turns/d; /^interval/d; s/^mode .*/mode = run-up\nrows = time\ntime_step = 0.1 s\nduration = 0.75 s/' "$pump" >time.deck
rows -b open --units=m time.deck
that '.over == "time" and .units.time == "s" and (.steps | length) == 151 and .steps[20] == 0.1 and .steps[-1] == 0.75' \
    '.steps[.start] == 0.1'
rows -b open --set 'motion.time_step=1 ms' time.deck
that '(.steps | length) == 251 and .steps[1] == 0.003 and .steps[-1] == 0.75'

# One instant is a row of its cycle; a drawing is turned as the machine stands.
rows --set motion.at='33.3 deg' "$data/me3491-example-2.deck"
that '.steps[.start] == 33.3 and .steps[-1] == 360 and (.turn - 1.5707963 | fabs) < 1e-6' \
    '.branches[0].table[.start][0] == 33.3' \
    '[.branches[0].panels[0].items[] | select(.as == "label") | .words[0]] | index("N") != null'

# What can be dragged; the panels of a deck with forces, and the crank enlarged where it is small.
rows "$data/me3491-exercise-4.deck"
that '.links[2].points == ["P0"] and .points[0].label[0] == "E"' \
    '[.branches[0].panels[].title] == ["Mechanism", "Velocity polygon", "Acceleration polygon", "Free body of the crank",
    "Free body of the coupler", "Free body of the rocker"]'
rows --set crank.length='3 mm' "$alvi"
that '.branches[0].panels[-1].title == "The crank enlarged"'

# Rows without a position have a reason, and the crank alone.
rows --set coupler.length='20 mm' "$alvi"
that '.steps as $a | .branches[0].reasons | keys | map($a[tonumber]) | (min > 0 and max < 360 and length > 10)' \
    '(.steps | index(180)) as $i | .branches[0].panels[0].items | (map(select(.name == "C"))[0].gone | [.[0] <= $i, .[1] > $i] | all) and
    (map(select(.name == "B")) | map(.gone // [999]) | map(.[0] > $i or .[1] <= $i) | any)' \
    '(.steps | index(180)) as $i | .branches[0].reasons["\($i)"] | test("too far apart")' \
    '(.steps | index(180)) as $i | .branches[0].table[$i][1] == null'

# Names cannot end the element.
rows --set title='</script><!--&]]>' "$alvi"
cat "$alvi" >named.deck
printf '[load </script><!--&]]>]\nlink = rocker\nforce = (1, 2) N\nat = (0, 0) m\n' >>named.deck
rows named.deck
check 'a name ends the element' none -e '[<>&]' rows
that '[.branches[0].panels[0].items[] | select(.as == "label") | .words[0]] | index("</script><!--&]]>") != null'

# More than a drawing shows: no drawing.
cat "$alvi" >many.deck
awk 'BEGIN {for (i = 0; i < 43; i++) printf "[load l%d]\nlink = rocker\nforce = (1, 2) N\nat = (0, 0) m\n", i}' >>many.deck
run 0 --report=lab.html many.deck
check 'a drawing of 43 loads' none 'id="fourlink-rows"' lab.html

answer
finish
