#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
#
# test_tasks.sh FOURLINK DATA - tasks of [synthesis] of all sorts: the deck that is found meets the task, as its own analysis
# proves, and the equations of its report hold for the numbers that are printed in them.
. "$(dirname "$0")/../harness.sh"

# task EXPECTED: t.deck; the linkage has so many [expect] sections at least, and they agree, unless it has a defect.
n=0 good=0
task() {
    n=$((n + 1))
    case $((n % 3)) in 0) units=in ;; 1) units=mm ;; *) units=m ;; esac
    "$fourlink" --synthesis --units=$units --report=r-$n.html t.deck >found.deck 2>err
    "$fourlink" --synthesis t.deck >found.deck 2>err
    status=$?
    check "task $n: status $status: $(grep -v note err)" test $status -le 1
    ! grep -q '^positions' t.deck || placed
    told
    if [ $status -eq 1 ]; then
        check "task $n: $(cat err)" grep -q defect err
        return
    fi
    good=$((good + 1))
    "$fourlink" --check found.deck >checked 2>&1
    check "task $n: $(tail -n 3 checked)" grep -q 'differs: 0' checked
    check "task $n: $(grep -c '^\[expect\]' found.deck) sections" test "$(grep -c '^\[expect\]' found.deck)" -ge "$1"
}

# placed: with the pivot A and the direction that the comments tell, the points that are expected are the positions of the task;
# the coupler turns, and the crank, as the task says.
placed() {
    awk '
        function near(a, b) { return a - b < 1e-5 * (1 + size) && b - a < 1e-5 * (1 + size) }
        function turn(a, b) { a = (a - b) % 360; return a * a < 1e-8 || (a - 360) ^ 2 < 1e-8 || (a + 360) ^ 2 < 1e-8 }
        FNR == 1 {file++}
        file == 1 && /^positions/ {
            sub(/^positions = */, "")
            n = split($0, part, "[()]")
            for (i = 2; i <= n; i += 2) {
                split(part[i], xy, ", *")
                wanted[++wants, 1] = xy[1]
                wanted[wants, 2] = xy[2]
                size += xy[1] ^ 2 + xy[2] ^ 2
                if (split(part[i + 1], word, " ") >= 3) turned[wants] = word[2] + 360
            }
            size = sqrt(size)
        }
        file == 1 && /^timing/ {sub(/^timing = */, ""); split($0, word, ", *"); timing[2] = word[1] + 0; timing[3] = word[2] + 0}
        file == 2 && $1 == "at" {at = $3}
        file == 2 && $1 == "theta3" && (found in turned) {
            body[found] = $3
            if (!turn(body[found] - body[1], turned[found] - turned[1])) { print "angle", found, body[found], body[1]; bad = 1 }
        }
        file == 2 && /^# The pivot A is at/ {sub(/.*\(/, ""); split($0, pivot, ", *"); pivot[2] += 0}
        file == 2 && /^# where the .* is at/ {angle = $(NF - 1) * atan2(0, -1) / 180}
        file == 2 && $1 ~ /^[A-Z]\.x$/ {x = $3}
        file == 2 && $1 ~ /^[A-Z]\.y$/ {
            found++
            crank[found] = at
            if ((found in timing) && !turn(crank[found] - crank[1], timing[found])) { print "timing", found, at, crank[1]; bad = 1 }
            if (!near(pivot[1] + x * cos(angle) - $3 * sin(angle), wanted[found, 1]) ||
                !near(pivot[2] + x * sin(angle) + $3 * cos(angle), wanted[found, 2])) {
                print "position", found, pivot[1] + x * cos(angle) - $3 * sin(angle), pivot[2] + x * sin(angle) + $3 * cos(angle)
                bad = 1
            }
        }
        END {exit bad || found != 3 || wants != 3}' t.deck found.deck >misplaced
    is_placed=$?
    check "task $n is misplaced: $(cat misplaced)" test $is_placed -eq 0
}

# told: the crank angles of the report are those of the deck.
told() {
    awk '/^\[expect/ {on = 1} on && /^at = [-0-9]/ {print $3}' found.deck | uniq >angles
    [ -s angles ] || return 0 # of a quick return facts alone
    sed -n '/Wanted positions/,/<\/table>/s|.*<th scope="row">[0-9]*</th><td>\([^<]*\)</td>.*|\1|p' r-$n.html | sed 's/−/-/' >shown
    paste -d ' ' angles shown | awk '{off = ($1 - $2) % 360; n++} off ^ 2 > 1e-6 && (off - 360) ^ 2 > 1e-6 && (off + 360) ^ 2 > 1e-6 {print; bad = 1} END {exit bad || !n}' >other
    is_told=$?
    check "task $n: angles in its report and its deck: $(head -n 1 other)" test $is_told -eq 0
}

# quick returns: either way, each length given, or the best; both sorts of slotted levers, with an offset
lengths() { # KIND SECTION LENGTH ...
    printf 'mechanism = %s\n' "$1"
    shift
    while [ $# -gt 1 ]; do
        printf '[%s]\n%s\n' "$1" "$2"
        shift 2
    done
    printf '[synthesis]\ntask = quick-return\n'
}
for slow in with against; do
    { lengths four-bar crank 'length = 40 mm' ground 'length = 110 mm' && printf 'time_ratio = 1.15\nswing = 48 deg\nslow = %s\n' $slow; } >t.deck && task 1
    { lengths four-bar coupler 'length = 5 in' rocker 'length = 3 in' && printf 'time_ratio = 1.05\nswing = 0.9 rad\nslow = %s\n' $slow; } >t.deck && task 1
    { lengths four-bar ground 'length = 110 mm' && printf 'time_ratio = 1.2\nswing = 70 deg\nslow = %s\n' $slow; } >t.deck && task 1
    { lengths slider-crank crank 'length = 45 mm' && printf 'time_ratio = 1.3\nstroke = 100 mm\nslow = %s\n' $slow; } >t.deck && task 1
    { lengths slider-crank rod 'length = 160 mm' && printf 'time_ratio = 1.25\nstroke = 100 mm\nslow = %s\n' $slow; } >t.deck && task 1
    { lengths slider-crank ground 'offset = 25 mm' && printf 'time_ratio = 1.2\nstroke = 4 in\nslow = %s\n' $slow; } >t.deck && task 1
    { lengths slider-crank && printf 'time_ratio = 1.4\nstroke = 100 mm\nslow = %s\n' $slow; } >t.deck && task 1
done
for ratio in 1.5 2.2; do
    { lengths inverted-slider-crank crank 'length = 100 mm' && printf 'time_ratio = %s\n' $ratio; } >t.deck && task 1
    { lengths inverted-slider-crank ground 'length = 240 mm' lever 'offset = 15 mm' && printf 'time_ratio = %s\n' $ratio; } >t.deck && task 1
    { lengths inverted-slider-crank ground 'length = 10 in' && printf 'time_ratio = %s\nstroke = 18 in\n' $ratio; } >t.deck && task 1
    { lengths inverted-slider-crank crank 'length = 100 mm' && printf 'type = whitworth\ntime_ratio = %s\n' $ratio; } >t.deck && task 1
done
{ lengths inverted-slider-crank crank 'length = 80 mm' && printf 'swing = 50 deg\n'; } >t.deck && task 1

# three positions, away from the origin of their axes, turned either way; rotations, pivots on the ground and the coupler
guided() { printf 'mechanism = %s\n[synthesis]\ntask = motion\npositions = %s\nleft = %s\nright = %s\n' "$@"; }
guided four-bar '(30, 120) mm 40 deg, (75, 140) mm 22 deg, (105, 130) mm -7 deg' 'fixed (25, 20) mm' 'fixed (125, 35) mm' >t.deck && task 3
guided four-bar '(-30, -120) mm 200 deg, (-60, -145) mm 218 deg, (-105, -150) mm 247 deg' 'fixed (-25, 75) mm' 'fixed (-25, -250) mm' >t.deck && task 3
guided four-bar '(0, 0) mm 0 deg, (60, 25) mm 18 deg, (105, 80) mm 47 deg' 'moving (10, -20) mm' 'fixed (25, -50) mm' >t.deck && task 3
guided four-bar '(1, 1) in 10 deg, (3, 2) in 28 deg, (5, 4) in 57 deg' 'rotations 20 deg 50 deg' 'rotations -15 deg -40 deg' >t.deck && task 3
guided slider-crank '(0, 0) mm 0 deg, (60, 25) mm 18 deg, (105, 80) mm 47 deg' 'fixed (25, 175) mm' 'slider 30 deg' >t.deck && task 3
guided slider-crank '(10, 20) mm 5 deg, (40, 25) mm -18 deg, (95, 50) mm -37 deg' 'fixed (-45, -75) mm' 'slider -140 deg' >t.deck && task 3

# paths, with angles of the coupler and without; functions either way, exact, with least errors
printf 'mechanism = four-bar\n[synthesis]\ntask = path\npositions = (10, 0) mm, (60, 25) mm, (105, 80) mm\ntiming = 40 deg, 85 deg\nright = fixed (25, -50) mm\n' >t.deck && task 3
printf 'mechanism = four-bar\n[synthesis]\ntask = path\npositions = (0, 0) mm 0 deg, (60, 25) mm 18 deg, (105, 80) mm 47 deg\ntiming = 40 deg, 85 deg\nright = fixed (25, -50) mm\n' >t.deck && task 3
printf 'mechanism = four-bar\n[synthesis]\ntask = path\npositions = (5, 10) mm 30 deg, (-40, 25) mm 11 deg, (-95, 30) mm -20 deg\ntiming = -35 deg, -95 deg\nright = moving (25, -50) mm\n' >t.deck && task 3
functions() { printf 'mechanism = %s\n%s[synthesis]\ntask = function\n%s\n' "$@"; }
ground='[ground]
length = 100 mm
'
functions four-bar "$ground" 'points = 36 deg 64 deg, 75 deg 98 deg, 114 deg 142 deg' >t.deck && task 3
functions four-bar "$ground" 'points = 114 deg 64 deg, 75 deg 98 deg, 36 deg 142 deg' >t.deck && task 3
functions four-bar "$ground" 'points = 250 deg 224 deg, 300 deg 260 deg, 345 deg 280 deg' >t.deck && task 3
# points of the linkage 100, 40, 95, 70, on either branch
functions four-bar "$ground" 'points = 60 deg 83.12897 deg, 90 deg 97.91716 deg, 130 deg 120.44957 deg' >t.deck && task 3
functions four-bar "$ground" 'points = 60 deg -129.95542 deg, 90 deg -141.51998 deg, 130 deg -147.84666 deg' >t.deck && task 3
functions four-bar "$ground" 'points = -70 deg 134.60195 deg, -20 deg 102.09123 deg, 250 deg 145.8248 deg' >t.deck && task 3
functions four-bar "$ground" 'function = x^1.5
x = 1 to 4
crank = 40 deg to 130 deg
rocker = 60 deg to 120 deg
precision = 9' >t.deck && task 3
functions slider-crank '' 'points = 45 deg 95 mm, 90 deg 60 mm, 135 deg 30 mm' >t.deck && task 3
functions slider-crank '' 'points = 135 deg 95 mm, 90 deg 80 mm, 45 deg 50 mm' >t.deck && task 3

check "only $good without a defect" test $good -ge 20
"$programs/check_sample" r-*.html >checked 2>&1
check "$(head -n 5 checked)" test "$(sed 's/,.*//' checked)" = "$n samples"
finish
