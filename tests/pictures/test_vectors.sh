#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
#
# test_vectors.sh FOURLINK DATA - polygons of velocity and acceleration, and forces, against the columns.
. "$(dirname "$0")/pictures.sh"

# sum of the arrows of a panel: the size of their sum, that of the largest, their number, number of notes
closing() {
    awk -F '\t' -v panel="$1" '$1 == panel && $2 == "note" {notes++}
        $1 == panel && $2 != "note" {split($3, p, " "); x = p[3] - p[1]; y = p[4] - p[2]; X += x; Y += y; n++
            s = sqrt(x * x + y * y); if (s > big) big = s}
        END {s = sqrt(X * X + Y * Y); limit = (n == notes ? 1e-4 : 0.02) * big
            print s, big, n + 0, notes + 0; exit !(n >= 2 && notes >= n && notes - n < 4 && s <= limit)}' arrows
}
closes() { closing "$1" >/dev/null; }
# arrow PANEL NUMBER: "DX DY X2 Y2" of its arrow number so many
arrow() {
    awk -F '\t' -v panel="$1" -v k="$2" '$1 == panel && $2 != "note" && ++n == k {split($3, p, " ")
        printf "%.9g %.9g %.9g %.9g\n", p[3] - p[1], p[4] - p[2], p[3], p[4]}' arrows
}
note() { awk -F '\t' -v panel="$1" -v name="$2" '$1 == panel && $2 == "note" && index($3, name " = ") == 1 {
    split(substr($3, length(name) + 4), w, " "); print w[1]}' arrows; }

for deck in "$fourbar" "$engine"; do
    case $deck in
    "$fourbar") links='crank coupler rocker' r=0.020 f=0.056 angles='20 190 333' ;;
    *) links='crank rod piston' r=0.150 f=0 angles='40 120 333' ;;
    esac
    for angle in $angles; do
        for branch in open crossed; do
            run 0 --plot-script=v.gp --plot-kind=vectors --plot-at="$angle deg" --branch=$branch "$deck"
            quiet
            arrows v.gp >arrows
            "$fourlink" --format=csv --branch=$branch --set="motion.at=$angle deg" --columns=all "$deck" >csv
            where="$(basename "$deck"), $branch, $angle deg"
            for link in $links; do
                check "forces on the $link: $where: $(closing "forces on the $link")" closes "forces on the $link"
            done
            # each polygon is a chain
            check "the forces follow each other: $where" awk -F '\t' 'function far(a, b) {return a - b > 0.02 * big || b - a > 0.02 * big}
                $1 ~ /^forces on/ && $2 != "note" {split($3, p, " ")
                    big = 1 + sqrt((p[3] - p[1]) ^ 2 + (p[4] - p[2]) ^ 2) + sqrt(x * x + y * y)
                    if (last == $1 && (far(p[1], x) || far(p[2], y))) bad = 1; x = p[3]; y = p[4]; last = $1; n++}
                END {exit !(n > 5 && !bad)}' arrows
            # the first of the crank is F12
            set -- $(arrow 'forces on the crank' 1)
            near "F12x: $where" "$1" "$(number F12x)" 1e-5
            near "F12y: $where" "$2" "$(number F12y)" 1e-5
            near "F12: $where" "$(note 'forces on the crank' F₁₂)" "$(number F12)" 1e-4
            set -- $(arrow 'forces on the crank' 2)
            near "F32 = -F23: $where" "$1" "$(number F23x | awk '{print -$1}')" 1e-5
            for link in $links; do
                [ $link = crank ] || near "F34 on the $link: $where" \
                    "$(note "forces on the $link" $([ $link = coupler ] || [ $link = rod ] && echo F₄₃ || echo F₃₄))" \
                    "$(number F34)" 1e-4
            done
            near "Ts: $where" "$(note 'free body of the crank' Ts)" "$(number Ts)" 1e-4

            # velocities: vB + vCB = vC
            check "three velocities: $where" test "$(grep -c '^velocity polygon	[2-4]	' arrows)" -eq 3
            set -- $(arrow 'velocity polygon' 1) $(arrow 'velocity polygon' 3) $(arrow 'velocity polygon' 2)
            near "vB + vCB = vC, x: $where" "$(awk -v x="$1" -v y="$5" 'BEGIN {printf "%.9g", x + y}')" "$9" 1e-5
            near "vB + vCB = vC, y: $where" "$(awk -v x="$2" -v y="$6" 'BEGIN {printf "%.9g", x + y}')" "${10}" 2e-5
            near "vB: $where" "$(size "$1" "$2")" "$(number omega2 | awk -v r=$r '{printf "%.9g", $1 * r}')" 1e-6
            near "vB is at right angles to the crank: $where" "$(number theta2 | awk -v x="$1" -v y="$2" '{
                t = $1 / 57.29577951308232; print 1 + (x * cos(t) + y * sin(t)) / sqrt(x * x + y * y)}')" 1 1e-6
            side=$([ $branch = open ] && echo 1 || echo -1)
            if [ $f != 0 ]; then
                near "vC: $where" "$(size "$9" "${10}")" "$(number omega4 | awk -v f=$f '{s = $1 * f; printf "%.9g", s < 0 ? -s : s}')" 1e-5
                near "note of vC: $where" "$(note 'velocity polygon' vC)" "$(size "$9" "${10}")" 1e-4
            else
                near "vC: $where" "$(awk -v x="$9" -v s=$side 'BEGIN {print -s * x}')" "$(number v)" 1e-5
            fi

            # accelerations: both ways meet in c', small parts left out
            check "accelerations meet: $where" awk -F '\t' -v four=$f '$1 == "acceleration polygon" && $2 != "note" {
                    split($3, p, " "); s = sqrt((p[3] - p[1]) ^ 2 + (p[4] - p[2]) ^ 2); if (s > big) big = s
                    if ($2 < 4) {x = p[3]; y = p[4]; n++} else {X = p[3]; Y = p[4]; m++}}
                $1 == "acceleration polygon" && $2 == "note" {notes++}
                END {d = sqrt((x - X) ^ 2 + (y - Y) ^ 2); exit !(n && m && notes >= n + m && d <= (notes == n + m ? 1e-5 : 0.02) * big)}' arrows
            near "aB: $where" "$(note 'acceleration polygon' aBn)" "$(number omega2 | awk -v r=$r '{print $1 * $1 * r}')" 1e-4
            if [ $f != 0 ]; then
                near "aCn: $where" "$(note 'acceleration polygon' aCn)" "$(number omega4 | awk -v f=$f '{print $1 * $1 * f}')" 1e-4
                near "aCt: $where" "$(note 'acceleration polygon' aCt)" "$(number alpha4 | awk -v f=$f '{s = $1 * f; print s < 0 ? -s : s}')" 1e-4
            else
                near "aC: $where" "$(note 'acceleration polygon' aC)" "$(number a | awk '{print $1 < 0 ? -$1 : $1}')" 1e-4
            fi
        done
    done
done
check 'the arrows of a load bear its name' grep -q '^forces on the piston	note	gas ' arrows
run 0 --plot-script=v.gp --plot-kind=vectors "$fourbar"
check 'a load by its name' grep -q '^set label .push. at' v.gp
check 'the weights' grep -q '^set label .W₃ = 2.943 N. at' v.gp

# --- images of centres of mass and of tracer points: thin lines from the pole that end in their motion
"$fourlink" --format=csv --branch=open --set='motion.at=20 deg' --columns=P.vx,P.vy,P.ax,P.ay,G3.vx,G3.vy,G3.ax,G3.ay "$fourbar" >csv
run 0 --plot-script=v.gp --plot-kind=vectors --plot-at='20 deg' --branch=open "$fourbar"
arrows v.gp nohead >lines
image() { # image PANEL X Y: one of its thin lines from 0 ends there
    awk -F '\t' -v panel="$1" -v x="$2" -v y="$3" 'function near(a, b) {b -= a; return b < 1e-4 * size && -b < 1e-4 * size}
        BEGIN {size = sqrt(x * x + y * y)}
        $1 == panel && $2 == 9 {split($3, p, " "); if (p[1] == 0 && p[2] == 0 && near(p[3], x) && near(p[4], y)) found = 1}
        END {exit !(size > 0 && found)}' lines
}
for point in P G3; do
    check "the velocity of $point" image 'velocity polygon' "$(number $point.vx)" "$(number $point.vy)"
    check "the acceleration of $point" image 'acceleration polygon' "$(number $point.ax)" "$(number $point.ay)"
done
check 'the velocity is not the acceleration' not image 'velocity polygon' "$(number P.ax)" "$(number P.ay)"
for letter in g₂ g₃ g₄ P "g'₂" "g'₃" "g'₄" "P'"; do
    check "the letter $letter" grep -qF "set label \"$letter\" at" v.gp
done

# --- each panel has two tics on each axis, and free bodies have a scale of forces
tics() { # tics SCRIPT: of each panel that is a drawing
    awk 'function few(low, high, step,  n) {n = int(high / step + 1e6) - int(low / step + 1e6); return n < 2}
        /^set format .*xtics/ {gsub(";", ""); x = $6; y = $9}
        /^set [xy]range \[/ {r = $3; gsub(/[][]/, "", r); split(r, p, ":"); panels++
            if (few(p[1], p[2], $2 == "xrange" ? x : y)) bad = 1}
        END {exit !(panels == 18 && !bad)}' "$1"
}
for angle in 0 60 130 200 299; do
    for deck in "$fourbar" "$engine"; do
        run 0 --plot-script=v.gp --plot-kind=vectors --plot-at="$angle deg" --branch=open "$deck"
        check "two tics at $angle deg of $(basename "$deck")" tics v.gp
    done
done
sed 's/xtics [^;]*/xtics 1e9/' v.gp >wrong.gp
check 'too few tics are seen' not tics wrong.gp
arrows v.gp | awk -F '\t' '/^free body/ && $2 == 9' >scales
check "scales of forces: $(wc -l <scales)" test "$(wc -l <scales)" -eq 3

# --- nothing moves and nothing acts
run 0 --plot-script=v.gp --plot-kind=vectors --set=motion.speed=0 --set=gravity.acceleration=0 --set='load push.force=(0, 0) N' "$fourbar"
check 'all forces are zero' test "$(grep -c '^set label "all forces are zero"' v.gp)" -eq 6
check 'all velocities are zero' grep -q '^set label "all velocities are zero"' v.gp
check 'all accelerations are zero' grep -q '^set label "all accelerations are zero"' v.gp
run 0 --plot-script=v.gp --plot-kind=vectors "$fourbar"
check 'not all is zero' none 'are zero' v.gp

# --- the piston's box, and the body out to a centre of mass that is off the line
run 0 --plot-script=v.gp --plot-kind=vectors "$engine"
arrows v.gp nohead >arrows
check 'the box of the piston' test "$(grep -c '^free body of the piston	4	' arrows)" -eq 4
check 'a straight rod' none '^free body of the rod	9	' arrows
run 0 --plot-script=v.gp --plot-kind=vectors --set='rod.cg=(100, 40) mm' "$engine"
arrows v.gp nohead >arrows
check 'a rod with its centre of mass off its line' test "$(grep -c '^free body of the rod	9	' arrows)" -eq 2

# --- friction: the polygons close, and the force of a pin is a tangent to its circle, drawn larger
cat >friction.deck <<'END'
mechanism = four-bar
[motion]
speed = 10 rad/s
[ground]
length = 80 mm
[crank]
length = 20 mm
mass = 0.1 kg
cg = 8 mm
[coupler]
length = 66 mm
mass = 0.3 kg
cg = (30, 4) mm
[rocker]
length = 56 mm
[load push]
link = rocker
torque = -0.5 N m
[spring S]
link = rocker
at = (30, 5) mm
to = coupler
to_at = 20 mm
stiffness = 300 N/m
[spring T]
link = rocker
to = ground
stiffness = 0.4 N m/rad
[friction]
A = 0.1
radius_A = 6 mm
B = 0.2
radius_B = 5 mm
C = 0.1
radius_C = 4 mm
[table]
branch = open
END
cat >guide.deck <<'END'
mechanism = slider-crank
[motion]
speed = 10 rad/s
[crank]
length = 50 mm
[rod]
length = 200 mm
mass = 1 kg
cg = 70 mm
[piston]
mass = 2 kg
[load water]
link = piston
force = -400 N
[spring damper]
link = ground
at = 350 mm
to = piston
damping = 200 N s/m
[friction]
A = 0.1
radius_A = 15 mm
C = 0.1
radius_C = 8 mm
guide = 0.2
[table]
branch = open
END
# circle PANEL NUMBER X Y: the distance of its arrow number so many from a place, in the drawing's unit
circle() {
    awk -F '\t' -v panel="$1" -v k="$2" -v x="$3" -v y="$4" '$1 == panel && $2 != "note" && ++n == k {split($3, p, " ")
        u = p[3] - p[1]; v = p[4] - p[2]; d = ((p[1] - x) * v - (p[2] - y) * u) / sqrt(u * u + v * v)
        printf "%.9g", d < 0 ? -d : d}' arrows
}
enlarged() { sed -n "s/^set label .friction circles \([0-9]*\):1. at.*/\1/p" v.gp | sed -n "$1p"; }
for angle in 20 140 300; do
    run 0 --plot-script=v.gp --plot-kind=vectors --plot-at="$angle deg" friction.deck
    quiet
    arrows v.gp >arrows
    for link in crank coupler rocker; do
        check "forces with friction on the $link: $angle deg: $(closing "forces on the $link")" closes "forces on the $link"
    done
    "$fourlink" --format=csv --set="motion.at=$angle deg" --columns=B.x,B.y,C.x,C.y,F12,S.force,T.torque friction.deck >csv
    near "F12 at its circle, $angle deg" "$(circle 'free body of the crank' 1 0 0)" "$(enlarged 1 | awk '{print 0.0006 * $1}')" 1e-5
    near "F32 at its circle, $angle deg" "$(circle 'free body of the crank' 2 "$(number B.x)" "$(number B.y)")" \
        "$(enlarged 1 | awk '{print 0.001 * $1}')" 1e-5
    near "F43 at its circle, $angle deg" "$(circle 'free body of the coupler' 2 "$(number C.x)" "$(number C.y)")" \
        "$(enlarged 2 | awk '{print 0.0004 * $1}')" 1e-5
    near "F14 without friction, $angle deg" "$(circle 'free body of the rocker' 2 0.08 0)" 0 1e-9
    check "friction turns against the crank, $angle deg" awk -F '\t' '$1 == "free body of the crank" && $2 != "note" {
        split($3, p, " "); exit !(p[1] * (p[4] - p[2]) - p[2] * (p[3] - p[1]) < 0)}' arrows
    near "S, $angle deg" "$(note 'free body of the rocker' S)" "$(number S.force)" 1e-4
    near "T, $angle deg" "$(note 'free body of the rocker' T | awk '{print -$1}')" "$(number T.torque)" 1e-4
    run 0 --plot-script=v.gp --plot-kind=vectors --plot-at="$angle deg" guide.deck
    arrows v.gp >arrows
    for link in crank rod piston; do
        check "forces with friction on the $link: $angle deg: $(closing "forces on the $link")" closes "forces on the $link"
    done
    "$fourlink" --format=csv --set="motion.at=$angle deg" --columns=N,friction_guide guide.deck >csv
    near "N, $angle deg" "$(note 'forces on the piston' N)" "$(number N | awk '{print $1 < 0 ? -$1 : $1}')" 1e-4
    near "friction of the guide, $angle deg" "$(note 'forces on the piston' friction)" "$(number friction_guide)" 1e-4
done
# --- springs in the mechanism: a zigzag and a spiral in black, their names and forces; a damper has no zigzag
run 0 --plot-script=v.gp --plot-at='20 deg' friction.deck
check 'the name of a spring' grep -q '^set label "S" at' v.gp
check 'the name of a torsional spring' grep -q '^set label "T" at' v.gp
check 'the force of a spring' grep -q '^set label "S = [-0-9.]* N" at' v.gp
check 'friction of pins is no arrow' none 'label "friction' v.gp
check "the lines of springs: $(grep -c 'nohead ls 1$' v.gp)" test "$(grep -c 'nohead ls 1$' v.gp)" -gt 75
run 0 --plot-script=w.gp --plot-at='20 deg' guide.deck
check 'the name of a damper' grep -q '^set label "damper" at' w.gp
check "the lines of a damper: $(grep -c 'nohead ls 1$' w.gp)" test "$(grep -c 'nohead ls 1$' w.gp)" -lt 25
run 0 --plot-script=v.gp --plot-kind=animation friction.deck
check 'springs move' test "$(grep -c '^set label "S" at' v.gp)" -eq 60

finish
