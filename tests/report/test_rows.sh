#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
#
# test_rows.sh - the rows that a report's drawing is made from.
. "$(dirname "$0")/../harness.sh"

needs jq jq

# rows DECK [OPTION...]: the rows of its report, in the file rows.
rows() {
    "$fourlink" --report=lab.html "$@" >out 2>err </dev/null
    sed -n '/id="fourlink-rows"/,/<\/script>/p' lab.html | sed '1s/.*>{/{/; $d' >rows
}
# that FILTER...: one jq, whose start takes longer than its work, finds each true.
that() {
    filters='[(.steps | length), .start]'
    for filter in "$@"; do
        filters="$filters, ([try ($filter) catch false] | last | . != null and . != false)"
    done
    jq -c "$filters" rows >truths 2>&1
    {
        read -r steps <&3
        while [ $# -gt 0 ]; do
            read -r truth <&3 || truth='no answer'
            check "$1: $truth: $steps" test "$truth" = true
            shift
        done
    } 3<truths
}

rows "$alvi"
that '.branches | map(.name) == ["open", "crossed"]' \
    '(.steps | length) == 181 and .steps[20] == 40 and .steps[.start] == 60 and .turn == 0' \
    '.units.length == "mm" and .forces == [] and .torques == []' \
    '.branches[0].reasons == {} and .branches[0].tracks.A == [0, 0] and .branches[0].tracks.D == [80, 0]' \
    '[.branches[].table | length] == [181, 181]'

# Numbers and the table are those of the program.
run 0 -f csv --units=mm -c theta2,C.x,C.y,theta4 "$alvi"
awk -F, 'NR > 1 {printf "%s %s %.5g %.5g\n", $1, $2, $3, $4}' out >wanted
jq -r '. as $all | .branches[] | . as $b | range(0; 361; 40) | . as $angle | ($all.steps | index($angle)) as $i |
    "\($b.name) \($angle) \($b.tracks.C[0][$i]) \($b.tracks.C[1][$i])"' rows | awk '{printf "%s %s %.5g %.5g\n", $1, $2, $3, $4}' >found
same found wanted
check 'too few rows' test "$(wc -l <found)" -eq 20
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
run 0 -b open -f csv -c time,C.x,omega2 time.deck
awk -F, 'NR > 1 {printf "%g %.5g\n", $2, $3}' out >wanted
jq -r '. as $all | .steps | to_entries[] | select(.key % 20 == 0 or .value == 0.75) | "\(.value) \($all.branches[0].tracks.C[0][.key])"' rows |
    awk '{printf "%g %.5g\n", $1, $2}' >found
same found wanted
check 'nine rows' test "$(wc -l <found)" -eq 9
rows -b open --set 'motion.time_step=1 ms' time.deck
that '(.steps | length) == 251 and .steps[1] == 0.003 and .steps[-1] == 0.75'

# One instant is a row of its cycle; a drawing is turned as the machine stands.
rows --set motion.at='33.3 deg' "$data/me3491-example-2.deck"
that '.steps[.start] == 33.3 and .steps[-1] == 360 and (.turn - 1.5707963 | fabs) < 1e-6' \
    '.branches[0].table[.start][0] == 33.3' \
    '(.forces | map(select(.of == "F14")) | .[0].label[0]) == "N"'

# A load of the ground's frame, of the link's frame, within its crank angles.
rows "$data/me3491-exercise-4.deck"
that '.branches[0].tracks.L0F[0] | unique == [-5000, 0]' \
    '.branches[0].tracks.L0F[1] == 0' \
    '.links[2].points == ["P0"] and .points[0].label[0] == "E"'

# Rows without a position have a reason, and the crank.
rows --set coupler.length='20 mm' "$alvi"
that '.steps as $a | .branches[0].reasons | keys | map($a[tonumber]) | (min > 0 and max < 360 and length > 10)' \
    '(.steps | index(180)) as $i | .branches[0].tracks.B[0][$i] == -20 and .branches[0].tracks.C[0][$i] == null' \
    '(.steps | index(180)) as $i | .branches[0].reasons["\($i)"] | test("too far apart")' \
    '(.steps | index(180)) as $i | .branches[0].table[$i][1] == null'

# Names cannot end the element.
rows --set title='</script><!--&]]>' "$alvi"
cat "$alvi" >named.deck
printf '[load </script><!--&]]>]\nlink = rocker\nforce = (1, 2) N\nat = (0, 0) m\n' >>named.deck
rows named.deck
check 'a name ends the element' none -e '[<>&]' rows
that '[.forces[].label[0]] | index("</script><!--&]]>")'

# Springs have ends or a pin; friction turns a link at its pins, in each row at the same place of the list.
cat "$alvi" >springs.deck
cat >>springs.deck <<'END'
[spring S]
link = rocker
at = 0.04 m
to = ground
to_at = (0.1, 0.09) m
stiffness = 800 N/m
[spring T]
link = coupler
to = rocker
damping = 0.02 N m s/rad
[friction]
B = 0.1
radius_B = 5 mm
D = 0.1
radius_D = 6 mm
END
rows --branch=open springs.deck
that '[.springs[] | [.label[0], .coil, .damper, .pin, .ends, .on]] ==
    [["S", true, false, null, ["K0P", "K0Q"], [4, 1]], ["T", false, true, "C", null, null]]' \
    '.branches[0].tracks.K0Q == [100, 90]' \
    '[.torques[] | select(.label[0] == "M") | [.at, .on]] == [["B", 3], ["B", 2], ["C", 4], ["C", 3], ["D", 4], ["A", 2]]' \
    '[.torques[], .forces[] | select(.label[0] == "M" or .label[0] == "S" or .label[0] == "T") | select(.label[1] != "s") | .inner] | all'

# Also where the last row cannot be assembled.
rows --branch=open --set='ground.length=125 mm' --set='motion.to=90 deg' springs.deck
that '(.steps | length - 1) as $i | .branches[0].reasons["\($i)"] != null' \
    '[.torques[] | select(.label[0] == "M") | .on] == [3, 2, 4, 3, 4, 2]'

# Each link is in balance with the forces and torques of its free body: x, y, and moments about B; the friction of a guide
# is in them once.
{
    sed '/^\[table\]/,$d' "$data/oscillating-cylinder.deck"
    printf '[load L]\nlink = lever\nforce = (-150, 20) N\nat = (450, 0) mm\n'
} >free-slot.deck
friction='[friction]\nA = 0.1\nradius_A = 15 mm\nB = 0.1\nradius_B = 10 mm\nguide = 0.2\nguide_length = 50 mm\n'
{ cat free-slot.deck; printf "$friction"'D = 0.1\nradius_D = 12 mm\n'; } >slot.deck
{ sed '/^\[table\]/,$d' "$decks/pump.deck"; printf "[load L]\nlink = piston\nforce = -900 N\n$friction"; } >guide.deck
for deck in free-slot.deck slot.deck guide.deck; do
    rows --branch=open --units=m --set='motion.interval=30 deg' $deck
    that '. as $all | .branches[0].tracks as $t |
        def at($i): if type == "array" then .[$i] else . end;
        def vector($i): [$t[.][0] // 0, $t[.][1] // 0 | at($i)];
        [range(3; (.steps | length); 7) as $i | (2, 3, 4) as $link | ("B" | vector($i)) as $B |
            ([$all.forces[] | select(.on == $link) | .sign as $s | (.of | vector($i) | map(. * $s)) as $F | (.at | vector($i)) as $P |
                [$F[0], $F[1], ($P[0] - $B[0]) * $F[1] - ($P[1] - $B[1]) * $F[0]]]) as $f |
            ([$all.torques[] | select(.on == $link) | .sign * (.of | vector($i))[0]] | add // 0) as $m |
            ([$f[] | map(fabs) | max] | max) as $size |
            [($f | map(.[0]) | add), ($f | map(.[1]) | add), ($f | map(.[2]) | add) + $m] | map(fabs) | max < 1e-3 * $size] |
        length > 50 and all'
done
rows --branch=open slot.deck
that '.branches[0].tracks as $t | [.forces[] | select(.label[0] == "friction") | $t[.of]] | all(. == [0, 0])'
rows --branch=open guide.deck
that '.branches[0].tracks as $t | [.forces[] | select(.label[0] == "friction" and $t[.of] != [0, 0]) | .on] == [4]'

# More than a drawing shows: no drawing.
cat "$alvi" >many.deck
awk 'BEGIN {for (i = 0; i < 43; i++) printf "[load l%d]\nlink = rocker\nforce = (1, 2) N\nat = (0, 0) m\n", i}' >>many.deck
run 0 --report=lab.html many.deck
check 'a drawing of 43 loads' none 'id="fourlink-rows"' lab.html

finish
